# SPDX-License-Identifier: BSD-3-Clause
"""Bodies held by markers: what must not matter to their loads does not, and the energy of a stirred box closes."""

import unittest

import numpy as np

from support import SOURCE, ProgramTest, read_columns

DIRECT = ["-body_method", "direct_forcing", "-fluid_density", 1, "-output_interval", 100]
FLOW = [*DIRECT, "-grid_cells", "60,40", "-grid_upper", "3,2", "-bc_x_lower", "inflow", "-bc_x_lower_velocity", "1,0",
        "-bc_x_upper", "outflow", "-bc_y_lower", "slip", "-bc_y_upper", "slip", "-fluid_initial", "uniform",
        "-fluid_initial_velocity", "1,0", "-fluid_viscosity", 0.025, "-time_step", 0.02, "-time_max_cfl", 2, "-bodies", "ball"]
CELL = 0.05
STIRRED = [*DIRECT, "-grid_cells", "40,40", "-fluid_viscosity", 2e-3, "-bodies", "vane", "-vane_shape", "vaned",
           "-vane_hub_radius", 0.08, "-vane_tip_radius", 0.3, "-vane_vane_thickness", 0.06, "-vane_center", "0.5,0.5",
           "-vane_angular_speed", 4, "-vane_frequency", 0.5, "-time_step", 5e-3, "-time_end", 1]

STANDING = [*DIRECT, "-grid_cells", "30,30,24", "-grid_upper", "1,1,0.8", "-bc_z_upper", "slip", "-fluid_viscosity", 1e-2,
            "-bodies", "vane", "-vane_shape", "box", "-vane_size", "0.5,0.15,0.8", "-vane_center", "0.5,0.5,0",
            "-vane_angular_speed", 4, "-vane_frequency", 0.5, "-time_step", 1e-2, "-time_end", 0.6]


ARRAY = [*DIRECT, "-grid_lower", "-2,-2", "-grid_upper", "2,2", "-bc_x_lower", "periodic", "-bc_x_upper", "periodic",
         "-bc_y_lower", "periodic", "-bc_y_upper", "periodic", "-fluid_viscosity", 10, "-fluid_bulk_velocity", "1,0",
         "-bodies", "ball", "-ball_shape", "sphere", "-ball_radius", 0.5, "-time_step", 0.02, "-time_end", 3,
         "-body_slip_tolerance", 1e-4]


TURNING_SPEED = 0.06
TURNING = [*DIRECT, "-grid_cells", "48,48", "-grid_upper", "3,3", "-fluid_viscosity", 0.032, "-bodies", "ball,drum", "-ball_shape", "sphere",
           "-ball_radius", 0.5, "-ball_center", "1.51,1.49", "-ball_angular_speed", TURNING_SPEED, "-ball_frequency", 0.5, "-drum_shape",
           "sphere", "-drum_radius", 1.2, "-drum_center", "1.51,1.49", "-drum_inverted", "true", "-time_step", 5e-3, "-time_end", 6,
           "-history_interval", 0.02]
STOKES = complex(-0.25408, -0.17403)  # torque over angular velocity: -2 pi R^3 mu k K_2(kR)/K_1(kR), k^2 = i w/nu

# 0.78 of a cell lies between drum and box
SQUEEZED = ["-options_file", SOURCE / "inputs" / "thesis" / "wash33.opts", "-grid_cells", "12,12,12", "-towel_count", 4, "-towel_markers", 4,
            "-agitator_frequency", 10, "-agitator_angular_speed", 15, "-time_end", 0.15, "-output_interval", 1]

MACHINE = ["-options_file", SOURCE / "inputs" / "thesis" / "wash33.opts", "-cloths", "", "-time_tolerance", 0, "-time_cfl", 0, "-time_step", 2e-3, "-time_end", 0.2,
           "-output_interval", 100]


class DirectForcing(ProgramTest):
    def history(self, name, *options, ranks=1):
        self.run_well(ranks, *options, "-output_dir", self.folder / name)
        return read_columns(self.folder / name / "history.csv")

    def mean_drag(self, shape, shift):
        center = f"{1 + shift[0] * CELL},{1 + shift[1] * CELL}"
        history = self.history(f"shift_{shift[0]}_{shift[1]}", *FLOW, *shape, "-ball_center", center, "-time_end", 1.6)
        return history["ball_force_x"][-20:].mean()

    def check_half_cell(self, shape, limit):
        drags = [self.mean_drag(shape, shift) for shift in ((0, 0), (0.25, 0.25), (0.5, 0.5), (0.5, 0))]
        self.assertLess(np.ptp(drags), limit * np.mean(drags), drags)

    def test_half_a_cell_hardly_matters_to_a_circle(self):
        self.check_half_cell(["-ball_shape", "sphere", "-ball_radius", 0.25], 0.02)

    def test_half_a_cell_hardly_matters_to_a_plate(self):
        self.check_half_cell(["-ball_shape", "box", "-ball_size", "0.03,0.5"], 0.02)

    def plate_with_thin_layers(self, name, shift, swapped=False):
        """Runs a plate of eight cells across a stream of Re = 100 along x, or along y; returns its drag coefficients and the
        history."""
        along, across = "yx" if swapped else "xy"

        def point(first, second):
            return f"{second},{first}" if swapped else f"{first},{second}"

        history = self.history(name, *DIRECT, "-grid_cells", point(64, 48), "-grid_lower", point(-2, -3), "-grid_upper", point(6, 3),
                               f"-bc_{along}_lower", "inflow", f"-bc_{along}_lower_velocity", point(1, 0), f"-bc_{along}_upper",
                               "outflow", f"-bc_{across}_lower", "slip", f"-bc_{across}_upper", "slip", "-fluid_initial", "uniform",
                               "-fluid_initial_velocity", point(1, 0), "-fluid_viscosity", 0.01, "-bodies", "ball", "-ball_shape", "box",
                               "-ball_size", point(0.1, 1), "-ball_center", point(0, shift / 8), "-time_cfl", 0.2, "-time_end", 2)
        return 2 * history[f"ball_force_{along}"], history

    def test_half_a_cell_hardly_matters_to_a_plate_with_thin_layers(self):
        # on 32 cells, at any place, Cd is 2.85 from t = 1 to 2
        means = []
        for shift in (0, 0.25, 0.5):
            drags, history = self.plate_with_thin_layers(f"thin_{shift}", shift)
            late = history["time"] > 1
            means.append(np.average(drags[late], weights=history["dt"][late]))
            self.assertGreater(history["numerical_dissipation"].max(), 0)
        self.assertLess(np.ptp(means), 0.04 * np.mean(means), means)
        self.assertLess(abs(np.mean(means) / 2.85 - 1), 0.12, means)

    def test_a_vane_thinner_than_a_cell_may_start_at_once(self):
        # no cell's middle lies in it, and its first step was as long as allowed: a CFL number of 2.7
        history = self.history("vane", *DIRECT, "-grid_cells", "64,64", "-fluid_viscosity", 1e-5, "-bodies", "ball", "-ball_shape", "box",
                               "-ball_size", "0.6,0.01", "-ball_center", "0.5,0.5", "-ball_angular_speed", 1, "-time_step", 0.05,
                               "-time_cfl", 0.5, "-time_end", 0.1)
        self.assertLess(history["cfl"].max(), 0.6)
        self.assertLess(history["dt"][0], 0.01)

    def test_swapped_axes_do_not_matter_to_a_plate(self):
        here, _ = self.plate_with_thin_layers("x", 0.25)
        swapped, _ = self.plate_with_thin_layers("y", 0.25, swapped=True)
        np.testing.assert_allclose(swapped, here, rtol=1e-9)

    def test_cylinders_in_creeping_flow_act_with_their_radius(self):
        # Sangani and Acrivos, Int. J. Multiphase Flow 8 (1982) 193: a square array, volume fraction pi/64
        part = np.pi / 64
        exact = 4 * np.pi * 10 / (-0.5 * np.log(part) - 0.738 + part - 0.887 * part ** 2 + 2.038 * part ** 3)
        for cells, shift, limit in ((5, 0, 0.02), (5, 0.3, 0.02), (10, 0, 4e-3)):
            history = self.history(f"array_{cells}_{shift}", *ARRAY, "-grid_cells", f"{4 * cells},{4 * cells}",
                                   "-ball_center", f"{shift / cells},{shift / cells}")
            self.assertLess(abs(history["ball_force_x"][-1] / exact - 1), limit, (cells, shift))

    def test_a_circle_that_turns_to_and_fro_has_stokes_torque(self):
        """Water inside, which lags behind the wall, is no load: taken to turn with it, it would make 16 % off of 10. The layer is 2.3 cells thick."""
        history = self.history("turns", *TURNING)
        seen = history["time"] > 2
        middle, torque = (history["time"] - 0.5 * history["dt"])[seen], history["ball_torque"][seen]
        basis = np.array([np.sin(np.pi * middle), np.cos(np.pi * middle), np.ones_like(middle)]).T
        with_velocity, with_acceleration = np.linalg.lstsq(basis, torque, rcond=None)[0][:2] / TURNING_SPEED
        self.assertLess(abs(complex(with_velocity, with_acceleration) / STOKES - 1), 0.13)

    def test_walls_hold_the_water_after_the_step(self):
        """And the slip that is reported is the water's: what the solver leaves more of, it shows."""
        slips = {}
        for tolerance in (5e-3, 0.1):
            history = self.history(f"tolerance_{tolerance}", *FLOW, "-ball_shape", "sphere", "-ball_radius", 0.25, "-ball_center", "1,1",
                                   "-time_end", 1, "-body_slip_tolerance", tolerance)
            slips[tolerance] = history["ball_slip"]
        self.assertLess(slips[5e-3][-20:].mean(), 0.02)  # of the stream, whose speed is 1
        self.assertGreater(slips[0.1][:20].mean(), 2 * slips[5e-3][:20].mean())
        self.assertLess(self.history("stirred", *STIRRED)["vane_slip"].max(), 0.02 * 0.3 * 4)  # of the tip's largest speed

    def test_water_thinner_than_a_cell_stays_calm(self):
        """Whichever way the cloths stand, and however long the steps: a solver that goes far for what water hardly answers lets it run away."""
        work = []
        for changed in (("-towel_tilt", 0.02), ("-towel_tilt", 0.021), ("-time_step", 3e-3)):
            history = self.history("squeezed", *SQUEEZED, *changed)
            self.assertLess(np.abs(history["drum_torque_z"]).max(), 0.2 * np.abs(history["agitator_torque_z"]).max(), changed)
            work.append((history["agitator_power"] * history["dt"]).sum())
        self.assertLess(np.ptp(work), 0.03 * np.mean(work), work)

    def test_which_way_a_machine_stands_hardly_matters(self):
        """Turned by a right angle it lies the same on the grid, by another angle otherwise."""
        stands = {turn: self.history(f"turned_{turn}", *MACHINE, "-agitator_turn", turn, "-drum_turn", turn) for turn in (0, 90, 37)}
        torques = {turn: history["agitator_torque_z"] for turn, history in stands.items()}
        work = {turn: (history["agitator_power"] * history["dt"]).sum() for turn, history in stands.items()}
        for turn, limit_of_torque, limit_of_work in ((90, 0.03, 3e-3), (37, 0.08, 0.03)):
            off = np.linalg.norm(torques[turn] - torques[0]) / np.linalg.norm(torques[0])
            self.assertLess(off, limit_of_torque, turn)
            self.assertLess(abs(work[turn] / work[0] - 1), limit_of_work, turn)

    def check_energy(self, history, limit):
        dt = history["dt"]
        work = (history["vane_power"] * dt).sum()
        lost = sum(history[name] for name in ("dissipation", "mask_dissipation", "numerical_dissipation"))
        kept_or_lost = history["kinetic_energy"][-1] + (lost * dt).sum()
        self.assertLess(abs(work - kept_or_lost), limit * work, (work, kept_or_lost))

    def test_ranks_agree(self):
        one = self.history("one", *STIRRED, "-max_steps", 40)
        three = self.history("three", *STIRRED, "-max_steps", 40, ranks=3)
        largest = np.abs(one["vane_torque"]).max()
        np.testing.assert_allclose(three["vane_torque"], one["vane_torque"], atol=1e-5 * largest)

    def test_round_off_does_not_grow_where_the_slip_is_small(self):
        """Two ranks sum in another order than one. The Krylov solver is called in many steps."""
        one, two = (self.history(f"small_slip_{ranks}", *STIRRED, "-body_slip_tolerance", 1e-5, ranks=ranks) for ranks in (1, 2))
        for name in ("vane_torque", "vane_force_x", "wall_x_lower_force_x"):
            with self.subTest(name):
                np.testing.assert_allclose(two[name], one[name], rtol=0, atol=1e-9 * np.abs(one[name]).max())

    def test_restart_gives_the_same_bytes(self):
        self.history("whole", *STIRRED, "-max_steps", 30)
        self.history("parts", *STIRRED, "-max_steps", 15)
        self.history("parts", *STIRRED, "-max_steps", 15, "-restart", self.folder / "parts" / "checkpoint.h5")
        whole, parts = (self.folder / name / "history.csv" for name in ("whole", "parts"))
        self.assertEqual(whole.read_bytes(), parts.read_bytes())

    def test_energy_of_a_stirred_box_closes_and_the_torque_is_smooth(self):
        history = self.history("stirred", *STIRRED)
        torque = history["vane_torque"]
        self.check_energy(history, 0.05)
        smooth = np.convolve(torque, np.full(9, 1 / 9), mode="valid")
        noise = (torque[4:-4] - smooth)[20:]
        self.assertLess(noise.std(), 0.03 * np.abs(smooth).max())

    def test_momentum_and_energy_of_a_body_on_a_floor_close(self):
        history = self.history("floor", *STANDING)
        dt = history["dt"]
        impulses = [(history[name] * dt).sum() for name in history if name.endswith("_torque_z")]
        left = history["angular_momentum"][-1] + sum(impulses)
        self.assertLess(abs(left), 5e-3 * max(map(abs, impulses)), impulses)
        self.check_energy(history, 0.015)  # falls with the square of the spacing


if __name__ == "__main__":
    unittest.main()
