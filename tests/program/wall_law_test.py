# SPDX-License-Identifier: BSD-3-Clause
"""A plug of thin water slides between slabs that have a law for their friction: it must not matter where they lie in their cells, nor how they lie to
the grid."""

import json
import unittest

import h5py
import numpy as np
from support import ProgramTest, read_columns

CELL, SPEED = 1 / 16, 20
PERIODIC = [word for axis in "xy" for end in ("lower", "upper") for word in (f"-bc_{axis}_{end}", "periodic")]
LAW = 1.0  # Pa: of 20 m/s three cells from a wall, viscosity 5e-4 Pa s, density 1 kg/m3


def vector(values, axes=(0, 1)):
    return ",".join(str(values[axis]) for axis in axes)


def plug(run, rise, shift=0.0, axes=(0, 1)):
    """Options of a slab that goes so many cells along and up while it goes through a periodic box once, and the way along it. What
    lies aslant to the box and has no end does not repeat itself: above and below it lie others."""
    lengths = np.array([run, rise or 44]) * CELL
    along = np.array([run, rise]) / np.hypot(run, rise)
    across = np.array([-along[1], along[0]])
    thickness = lengths[1] * along[0] - 2
    options = []
    slabs = [("slab", 0), ("above", lengths[1]), ("below", -lengths[1])] if rise else [("slab", 0)]
    for name, height in slabs:
        options += [f"-{name}_shape", "intersection", f"-{name}_parts", "roof,floor", f"-{name}_center",
                    vector((0, height + shift * CELL), axes)]
        for part, side in (("roof", 1), ("floor", -1)):
            options += [f"-{name}_{part}_shape", "halfspace", f"-{name}_{part}_normal", vector(side * across, axes),
                        f"-{name}_{part}_offset", vector(side * thickness / 2 * across, axes)]
    return ["-grid_cells", vector(np.round(lengths / CELL).astype(int), axes), "-grid_lower", "0,0", "-grid_upper", vector(lengths, axes),
            *PERIODIC, "-fluid_density", 1, "-fluid_viscosity", 5e-4, "-wall_model", "equilibrium", "-fluid_initial", "uniform",
            "-fluid_initial_velocity", vector(SPEED * along, axes), "-bodies", ",".join(name for name, _ in slabs), "-body_method", "direct_forcing",
            *options, "-time_step", 0.004, "-time_cfl", 0.6, "-history_interval", 0.02], along


def plate(shift, axes=(0, 1)):
    """Options of a plate 0.8 cells thick and 16 long in a stream along it, so many cells aside."""
    return ["-grid_cells", vector((64, 32), axes), "-grid_upper", vector((4, 2), axes), *PERIODIC, "-fluid_density", 1,
            "-fluid_viscosity", 5e-4, "-wall_model", "equilibrium", "-fluid_initial", "uniform",
            "-fluid_initial_velocity", vector((SPEED, 0), axes), "-bodies", "plate", "-body_method", "direct_forcing",
            "-plate_shape", "box", "-plate_size", vector((1, 0.05), axes), "-plate_center", vector((2, 1 + shift * CELL), axes),
            "-time_step", 0.002, "-time_cfl", 0.5, "-history_interval", 0.004]


POST = ["-grid_cells", "48,48", "-grid_upper", "3,3", "-fluid_density", 1, "-bodies", "post,tub", "-body_method", "direct_forcing",
        "-post_shape", "sphere", "-post_radius", 0.5, "-post_center", "1.5,1.5", "-post_angular_speed", 6, "-post_frequency", 0.5,
        "-tub_shape", "sphere", "-tub_radius", 1.2, "-tub_center", "1.5,1.5", "-tub_inverted", "true", "-time_step", 0.005, "-time_end", 3,
        "-history_interval", 0.02]


class WallLaw(ProgramTest):
    def energy_open(self, folder="equilibrium"):
        summary = json.loads((self.folder / folder / "summary.json").read_text(encoding="utf-8"))
        return next(finding["value"] for finding in summary["trust"]["end"] if finding["name"] == "energy open")

    def friction(self, run, rise, shift=0.0, axes=(0, 1), ranks=1):
        """Mean load per area of the slabs along the flow."""
        options, along = plug(run, rise, shift, axes)
        self.run_well(ranks, *options, "-time_end", 0.15, "-output_dir", "out")
        history = read_columns(self.folder / "out" / "history.csv")
        late = history["time"] > 0.05
        bodies = [name for name in ("slab", "above", "below") if name + "_force_x" in history]
        force = sum(history[f"{name}_force_{'xy'[axes.index(axis)]}"][late].mean() * along[axis] for axis in (0, 1) for name in bodies)
        self.open = self.energy_open("out")
        return force / (2 * np.hypot(*(np.array([run, rise]) * CELL)))

    def assert_as_by_the_law(self, friction):
        """The water inside, which slides along, slows down too: by up to 0.8 Pa in this time. At rest with the slabs it makes 13 Pa of it."""
        self.assertGreater(friction, 0.8 * LAW)
        self.assertLess(friction, 2 * LAW)
        self.assertLess(self.open, 1)

    def test_walls_along_the_grid_rub_by_the_law(self):
        for shift in (0.0, 0.3, 0.5):
            self.assert_as_by_the_law(self.friction(48, 0, shift))

    def test_oblique_walls_rub_no_more(self):
        frictions = [self.friction(118, 43, shift) for shift in (0.0, 0.3, 0.5)]
        for friction in frictions:
            self.assert_as_by_the_law(friction)
            self.assertAlmostEqual(friction / frictions[0], 1, delta=0.02)

    def test_axes_and_ranks_do_not_matter(self):
        one = self.friction(118, 43)
        self.assertAlmostEqual(self.friction(118, 43, axes=(1, 0)) / one, 1, delta=1e-3)
        self.assertAlmostEqual(self.friction(118, 43, ranks=2) / one, 1, delta=1e-3)

    def friction_of_plate(self, shift, axes=(0, 1), ranks=1):
        """Mean load per area of the plate, which water passes along it."""
        self.run_well(ranks, *plate(shift, axes), "-time_end", 0.3, "-output_dir", "out")
        history = read_columns(self.folder / "out" / "history.csv")
        return history["plate_force_" + "xy"[axes[0]]][history["time"] > 0.1].mean() / 2

    def test_a_thin_plate_rubs_on_both_faces(self):
        """Held by its markers it would have 7 to 13 times the load."""
        for shift in (0.0, 0.5, 0.25):
            one = self.friction_of_plate(shift)
            self.assertAlmostEqual(one / LAW, 1, delta=0.1)
            self.assertLess(self.energy_open("out"), 1)
        self.assertAlmostEqual(self.friction_of_plate(0.25, axes=(1, 0)) / one, 1, delta=1e-3)
        self.assertAlmostEqual(self.friction_of_plate(0.25, ranks=2) / one, 1, delta=1e-3)

    def torque_of_vane(self, model, thickness):
        """Root of the mean square torque of a vane 45 cells long that turns to and fro, so many cells thick."""
        self.run_well(1, "-grid_cells", "96,96", "-grid_upper", "3,3", "-fluid_density", 1, "-fluid_viscosity", 1e-4, "-wall_model", model,
                      "-bodies", "vane", "-body_method", "direct_forcing", "-vane_shape", "box", "-vane_size", f"1.4,{thickness / 32}",
                      "-vane_center", "1.5,1.5", "-vane_angular_speed", 6, "-vane_frequency", 0.5, "-time_step", 0.005, "-time_cfl", 0.5,
                      "-time_end", 2, "-history_interval", 0.02, "-output_dir", model)
        return np.sqrt(np.mean(read_columns(self.folder / model / "history.csv")["vane_torque"] ** 2))

    def test_layers_part_from_the_tips_of_a_vane_of_any_thickness(self):
        """If they slid round its tips it would have little more than half of the torque."""
        for thickness in (1.5, 2):
            ratio = self.torque_of_vane("equilibrium", thickness) / self.torque_of_vane("none", thickness)
            self.assertGreater(ratio, 0.8)
            self.assertLess(ratio, 1.35)

    def turn_post(self, model, viscosity, ranks=1):
        """The history of a post that turns to and fro in a tub of thin water."""
        self.run_well(ranks, *POST, "-fluid_viscosity", viscosity, "-wall_model", model, "-output_dir", model)
        return read_columns(self.folder / model / "history.csv")

    def power_of_post(self, model, viscosity):
        history = self.turn_post(model, viscosity)
        return history["post_power"][history["time"] > 1].mean()

    def test_nearly_laminar_layers_keep_their_friction(self):
        for viscosity in (4e-3, 8e-3):
            ratio = self.power_of_post("equilibrium", viscosity) / self.power_of_post("none", viscosity)
            self.assertGreater(ratio, 0.7)
            self.assertLess(ratio, 1.2)

    def test_walls_that_slide_at_times_keep_the_energy(self):
        """The post's layer is laminar whenever it turns round, so that its markers let go of the water and catch it twice a stroke."""
        for viscosity in (1e-3, 2e-3):
            history = self.turn_post("equilibrium", viscosity)
            self.assertGreater(history["mask_dissipation"].min(), -0.5)  # walls take energy alone; up to -40 W once
            self.assertLess(self.energy_open(), 10)

    def test_water_inside_that_slides_is_no_load(self):
        """Almost without friction, at y+ of 500, the post has no more to turn than that: water inside would need 7 W."""
        power = self.turn_post("equilibrium", 1e-5)["post_power"]
        self.assertLess(abs(power).mean(), 1)

    def test_ranks_do_not_matter_where_walls_slide_at_times(self):
        one, two = (self.turn_post("equilibrium", 4e-3, ranks)["post_torque"] for ranks in (1, 2))
        self.assertLess(abs(two - one).mean(), 0.02 * abs(one).mean())

    def test_a_restart_goes_on(self):
        def results_of(folder, *options, ranks):
            self.run_well(ranks, *options, "-output_dir", folder)
            with h5py.File(self.folder / folder / "checkpoint.h5") as file:
                return {name: file[name][()] for name in ("fluid/velocity", "walls/filtered")}

        for case in (plug(118, 43)[0], plate(0.25)):
            self.assert_restart_goes_on(results_of, [*case, "-checkpoint_interval", 0.05], 0.05, 0.1)


if __name__ == "__main__":
    unittest.main()
