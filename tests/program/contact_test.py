# SPDX-License-Identifier: BSD-3-Clause
"""Contact between cloths by the barrier: nothing passes, however cloths are pressed and on however many ranks."""

import unittest

import h5py
import numpy as np

from support import TIGHT, ProgramTest, read_columns, relative_difference, run

# Two towels in water, some millimetres apart, pressed together.
PRESSED = """
-grid_cells 16,16,16
-grid_upper 0.32,0.32,0.32
-fluid_viscosity 0.5
-cloths lower,upper
-cloths_size 0.15
-cloths_markers 6
-cloths_ke 8e3
-lower_center 0.16,0.16,0.16
-lower_load 0,0,500
-upper_center 0.17,0.155,0.164
-upper_direction 0.9,0.3,0.01
-upper_load 0,0,-500
-contact_distance 0.006
-coupling_order 1
-time_step 1e-3
-time_end 0.02
-output_interval 1
""".split()
# A towel that stands on the floor and buckles under a load in its plane.
BUCKLED = """
-grid_cells 16,16,16
-grid_upper 0.32,0.32,0.32
-fluid_viscosity 0.5
-cloths towel
-towel_size 0.2
-towel_markers 12
-towel_ke 8e5
-towel_center 0.161,0.163,0.12
-towel_direction 1,0.01,0
-towel_across 0,0.05,1
-towel_load 0,0,-5000
-contact barrier
-contact_distance 0.006
-coupling_order 1
-time_step 2.5e-3
-time_end 0.04
-output_interval 1
""".split()
# A towel that falls onto one held by its corners, in a vacuum.
DROPPED = """
-grid_cells 12,12,12
-grid_lower -0.5,-0.5,-0.5
-grid_upper 0.5,0.5,0.5
-fluid none
-gravity 0,0,-9.81
-cloths held,loose
-cloths_ke 800
-cloths_excess_mass 0.3
-held_size 0.4
-held_markers 11
-held_hold corners
-loose_size 0.2
-loose_markers 6
-loose_center 0.02,0.01,0.03
-loose_direction 0.9,0.3,0.1
-time_step 1e-3
-time_end 0.2
-output_interval 1
""".split()
# The same in the plane, in little water.
FIBRES = """
-grid_cells 16,16
-grid_upper 0.32,0.32
-fluid_density 10
-fluid_viscosity 0.01
-cloths held,loose
-cloths_ke 80
-cloths_excess_mass 0.3
-held_size 0.24
-held_markers 8
-held_hold corners
-held_center 0.16,0.16
-loose_size 0.1
-loose_markers 8
-loose_center 0.165,0.22
-loose_direction 0.3,1
-loose_load 0,-200
-coupling_order 1
-time_end 0.1
-output_interval 1
""".split()
# A towel that falls onto a prism, in a vacuum but for some drag.
PRISM = """
-grid_cells 12,12,12
-grid_lower -0.3,-0.3,0
-grid_upper 0.3,0.3,0.6
-fluid none
-gravity 0,0,-9.81
-bodies prism
-prism_shape box
-prism_size 0.25,0.25,0.2
-prism_center 0,0,0.1
-cloths towel
-towel_size 0.4
-towel_markers 16
-towel_ke 800
-towel_kb 1e-4
-towel_excess_mass 0.3
-towel_center 0.01,0.02,0.23
-towel_direction 0.9,0.3,0.02
-cloth_drag 3
-contact barrier
-contact_stiffness 1e3
-time_step 2e-3
-time_end 0.3
-output_interval 1
""".split()
# A small towel that is pulled over one that is too heavy to move, and pressed onto it.
SLED = """
-grid_cells 12,12,12
-grid_lower -0.5,-0.5,-0.5
-grid_upper 0.5,0.5,0.5
-fluid none
-cloths base,sled
-cloths_ke 800
-base_size 0.4
-base_markers 14
-base_excess_mass 1e5
-sled_size 0.08
-sled_markers 4
-sled_excess_mass 1
-sled_center -0.1,0.013,0.0037
-sled_direction 0.9,0.3,0
-contact barrier
-contact_distance 0.004
-time_step 5e-4
-time_end 0.1
-output_interval 1
""".split()
# The small towel on a block.
BLOCK = """
-grid_cells 12,12,12
-grid_lower -0.5,-0.5,-0.5
-grid_upper 0.5,0.5,0.5
-fluid none
-bodies block
-block_shape box
-block_size 0.6,0.6,0.2
-block_center 0,0,-0.1
-cloths sled
-cloths_ke 800
-sled_size 0.08
-sled_markers 4
-sled_excess_mass 1
-sled_center -0.1,0.013,0.009
-sled_direction 0.9,0.3,0
-contact barrier
-contact_distance 0.004
-time_step 5e-4
-time_end 0.1
-output_interval 1
""".split()
IN_AIR = """
-fluid water
-grid_cells 20,20,20
-grid_lower -0.2,-0.2,-0.2
-grid_upper 0.2,0.2,0.2
-fluid_density 1
-fluid_viscosity 1e-3
-body_method mapping
""".split()
# A sheet, too heavy to move, across a channel in the plane.
CHANNEL = """
-grid_cells 32,16
-grid_upper 0.64,0.32
-bc_x_lower inflow
-bc_x_upper outflow
-bc_y_lower slip
-bc_y_upper slip
-fluid_viscosity 0.01
-cloths sheet
-sheet_size 0.32
-sheet_markers 33
-sheet_center 0.32,0.16
-sheet_direction 0,1
-sheet_hold middle
-sheet_ke 1e4
-sheet_excess_mass 1e7
-contact none
-coupling_order 1
-time_step 2e-3
-output_interval 1
""".split()
# The pressed towels, face to face and 4 mm apart, a fifth of a cell.
FILM = [*PRESSED, "-contact", "barrier", "-upper_direction", "1,0,0", "-upper_center", "0.16,0.16,0.164",
        "-contact_distance", 5e-4]
RUBS = ["-contact_friction", 0.4]
PULL, PRESS, AREA = 45, 100, 0.08**2  # [N/m2], [N/m2], [m2]
COUNT = ["-contact_verify_interval", 1e-9]
NOT_PHYSICAL = {"step", "dt", "max_divergence"}


def squeezed(time, gap, viscosity, cell=0.02, area=0.15**2, pressure=500, density=1000):
    """Returns the thickness of a film at each time [m] by the mean law of squeezed films, faded out towards a cell."""
    gaps = []
    for dt in np.diff(time, append=time[-1]):
        gaps.append(gap)
        for _ in range(10):
            slope = 12 * viscosity * area / (8 * np.pi) / gap**3
            square = 1.8 * density * area / (8 * np.pi) / gap**2
            speed = (-slope + np.sqrt(slope**2 + 4 * square * pressure)) / (2 * square)
            gap -= dt / 10 * (1 - gap / cell) * speed
    return np.array(gaps)


class Contact(ProgramTest):
    def history(self, ranks, *options, name="out"):
        """Runs a case; returns the columns of its history."""
        self.run_well(ranks, *options, "-output_dir", name)
        return read_columns(self.folder / name / "history.csv")

    def test_a_falling_towel_goes_through_another_without_the_barrier_only(self):
        without = self.history(1, *DROPPED, "-contact", "none", *COUNT, "-time_step", 2e-4)
        self.assertGreater(without["intersections"].max(), 10)
        within = self.history(1, *DROPPED, "-contact", "barrier")
        self.assertEqual(within["intersections"].max(), 0)
        self.assertGreater(within["loose_center_z"][-1] - within["held_center_z"][-1], -0.02)
        self.assertGreater(within["friction_power"].max(), 0)
        self.assertLess(without["loose_center_z"][-1], -0.1)

    def test_a_towel_that_falls_onto_a_prism_drapes_over_it(self):
        history = self.history(1, *PRISM)
        self.assertEqual(history["intersections"].max(), 0)
        self.assertEqual(history["towel_depth"].max(), 0)
        self.assertGreater(history["towel_body_contact_force"].max(), 0)
        self.assertLess(history["towel_center_z"][-1], 0.2)  # its rim hangs below the top

    def test_cloth_that_buckles_within_a_step_is_solved_for(self):
        out = self.run_well(1, *BUCKLED, "-cloth_ksp_converged_reason")
        iterations = [int(line.split()[-1]) for line in out.splitlines() if "Linear cloth_ solve" in line]
        self.assertLess(max(iterations), 200)

    def test_fibres_do_not_pass_in_any_coupling(self):
        without = self.history(1, *FIBRES, "-contact", "none", "-time_step", 1e-3, *COUNT)
        self.assertGreater(without["intersections"].max(), 0)
        for coupling, step in (("semi_implicit", 1e-3), ("implicit", 1e-3), ("explicit", 1e-4), ("midpoint", 1e-4)):
            history = self.history(1, *FIBRES, "-contact", "barrier", "-coupling_scheme", coupling, "-time_step", step)
            with self.subTest(coupling=coupling):
                self.assertEqual(history["intersections"].max(), 0)
        again = self.history(2, *FIBRES, "-contact", "barrier", "-coupling_scheme", "midpoint", "-time_step", 1e-4)
        self.assertGreater(history["friction_power"].max(), 0)
        for name in ("time", "loose_center_x", "loose_center_y", "friction_power"):
            self.assertLess(relative_difference(again[name], history[name]), 1e-6, name)
        rows = self.history(1, *FIBRES, "-contact", "barrier", "-coupling_mobility", "row_sums", "-time_step", 1e-3)
        self.assertEqual(rows["intersections"].max(), 0)

    def test_an_explicit_step_beyond_its_bound_does_not_let_anything_pass(self):
        history = self.history(1, *DROPPED, "-contact", "barrier", "-coupling_scheme", "explicit", "-time_step", 5e-4,
                               "-time_end", 0.1)
        self.assertEqual(history["intersections"].max(), 0)

    def test_pressed_towels_are_the_same_on_one_two_and_three_ranks(self):
        leaky = [*PRESSED, "-cloths_permeance", 1e-4]  # or the water between them would carry all of the load
        options = [*leaky, "-contact", "barrier", *TIGHT, "-coupling_tolerance", 1e-11]
        expected = self.history(1, *options)
        free = self.history(1, *leaky, "-contact", "none")
        self.assertGreater(relative_difference(expected["lower_center_z"], free["lower_center_z"]), 1e-5)
        self.assertEqual(expected["intersections"].max(), 0)
        for ranks in (2, 3):
            history = self.history(ranks, *options)
            for name in expected.keys() - NOT_PHYSICAL:
                with self.subTest(ranks=ranks, column=name):
                    self.assertLess(relative_difference(history[name], expected[name]), 1e-6)

    def test_restart_in_the_middle_equals_the_uninterrupted_run(self):
        for case in (PRESSED, DROPPED):
            options = [*case, "-contact", "barrier", "-time_end"]
            end = float(case[case.index("-time_end") + 1])
            straight = self.history(2, *options, end, name="straight")
            self.history(2, *options, 0.5 * end, name="half")
            restarted = self.history(2, *options, end, "-restart", "half/checkpoint.h5", name="half")
            for name, values in straight.items():
                with self.subTest(column=name):
                    np.testing.assert_array_equal(restarted[name], values)

    def test_cloths_that_intersect_at_the_start_are_refused(self):
        outcome = run(1, *DROPPED, "-contact", "barrier", "-loose_center", "0.02,0.01,0", "-loose_direction", "0.3,0.2,1",
                      folder=self.folder)
        self.assertEqual(outcome.returncode, 2, outcome.stderr)
        lines = outcome.stderr.strip().splitlines()
        self.assertEqual(len(lines), 1, lines)
        for words in ("-contact barrier", "held 1 goes through loose 1", "place the cloths apart"):
            self.assertIn(words, lines[0])

    def test_friction_is_that_of_coulomb(self):
        late = slice(100, None)
        history = self.history(1, *SLED, *RUBS, "-sled_load", f"{PULL},0,-{PRESS}")
        time, place = history["time"], history["sled_center_x"]
        acceleration = 2 * np.polyfit(time[late], place[late], 2)[0]
        friction = (PULL - acceleration) / PRESS
        print(f"coefficient {friction:.4f}")
        self.assertLess(abs(friction - 0.4), 0.03 * 0.4)
        speed = (place[-1] - place[-2]) / (time[-1] - time[-2])
        work = np.sum(history["friction_power"][late] * history["dt"][late])
        kinetic = 0.5 * AREA * (speed**2 - ((place[99] - place[98]) / (time[99] - time[98]))**2)
        driven = PULL * AREA * (place[-1] - place[99])
        print(f"driven {driven:.5g} J, friction {work:.5g} J, kinetic {kinetic:.5g} J")
        self.assertLess(abs(driven - work - kinetic), 0.01 * driven)
        self.assertGreaterEqual(history["friction_power"].min(), 0)
        stuck = self.history(1, *SLED, *RUBS, "-sled_load", f"36,0,-{PRESS}")
        creep = np.diff(stuck["sled_center_x"])[late] / np.diff(stuck["time"])[late]
        print(f"creep {creep.max():.3g} m/s, sliding {speed:.3g} m/s")
        self.assertLess(creep.max(), 0.01 * speed)

    def settled(self, case, height):
        """Options of a run that goes on from where the small towel has come to rest under its load."""
        options = [*case, "-sled_center", f"-0.1,0.013,{height}"]
        self.history(1, *options, "-coupling_scheme", "implicit", "-sled_load", f"0,0,-{PRESS}", "-time_end", 0.05, name="rest")
        return [*options, "-restart", "rest/checkpoint.h5", "-time_end", 0.15]

    def test_friction_in_explicit_steps_is_that_of_coulomb(self):
        for case, height, given in (([*BLOCK, "-contact_body_friction", 0.3], 0.0081, 0.3), ([*SLED, *RUBS], 0.0041, 0.4)):
            options = [*self.settled(case, height), "-coupling_scheme", "explicit"]
            history = self.history(1, *options, "-time_step", 5e-5, "-sled_load", f"{PULL},0,-{PRESS}")
            late = history["time"] > 0.1
            time, place = history["time"][late], history["sled_center_x"][late]
            friction = (PULL - 2 * np.polyfit(time, place, 2)[0]) / PRESS
            speed = np.gradient(place, time)
            driven, work = PULL * AREA * (place[-1] - place[0]), np.sum((history["friction_power"] * history["dt"])[late])
            left = driven - work - 0.5 * AREA * (speed[-1]**2 - speed[0]**2)
            print(f"coefficient {friction:.4f}, {left / driven:.2%} of the work open")
            self.assertLess(abs(friction - given), 0.01 * given)
            self.assertLess(abs(left), 0.02 * driven)
            self.assertGreaterEqual(history["friction_power"].min(), 0)
        creeps = []
        for step in (1e-4, 5e-5):
            options = self.settled([*BLOCK, "-contact_body_friction", 0.3], 0.0081)
            stuck = self.history(1, *options, "-coupling_scheme", "explicit", "-time_step", step, "-sled_load", f"27,0,-{PRESS}")
            creeps.append((np.diff(stuck["sled_center_x"]) / np.diff(stuck["time"]))[-1])
        self.assertLess(creeps[0], 5e-3)
        self.assertLess(creeps[1], 0.6 * creeps[0])

    def test_friction_on_a_body_is_that_of_coulomb(self):
        late = slice(100, None)
        options = [*BLOCK, "-contact_body_friction", 0.3]
        history = self.history(1, *options, "-sled_load", f"{PULL},0,-{PRESS}")
        time, place = history["time"], history["sled_center_x"]
        friction = (PULL - 2 * np.polyfit(time[late], place[late], 2)[0]) / PRESS
        print(f"coefficient {friction:.4f}")
        self.assertLess(abs(friction - 0.3), 0.03 * 0.3)
        pressed = history["sled_body_contact_force"][late].mean()
        self.assertLess(abs(pressed - PRESS * AREA), 0.02 * PRESS * AREA)
        self.assertLess(relative_difference(history["block_force_x"][late], np.full(len(time[late]), 0.3 * PRESS * AREA)),
                        0.03)
        with h5py.File(self.folder / "out" / "cloth.h5") as file:
            last = file["frames"][max(file["frames"])]
            self.assertAlmostEqual(last["body_contact_force"][:].sum(), history["sled_body_contact_force"][-1], delta=1e-9)
            self.assertAlmostEqual(last["body_contact_area"][:].sum(), AREA, delta=1e-12)
            self.assertEqual(last["contact_force"][:].sum(), 0)
        speed = np.gradient(place, time)
        power = 0.3 * PRESS * AREA * speed
        self.assertLess(relative_difference(history["sled_friction_power"][late], power[late]), 0.03)
        stuck = self.history(1, *options, "-sled_load", f"27,0,-{PRESS}")
        creep = np.diff(stuck["sled_center_x"])[late] / np.diff(stuck["time"])[late]
        self.assertLess(creep.max(), 0.01 * speed[-1])
        carried = self.history(1, *options, "-sled_load", f"0,0,-{PRESS}", "-block_velocity", "0.1,0,0",
                               "-block_frequency", 2)
        way = 0.1 * (1 - np.cos(4 * np.pi * carried["time"])) / (4 * np.pi)
        apart = carried["sled_center_x"] - carried["sled_center_x"][0] - way
        print(f"carried along but for {np.abs(apart).max():.3g} m of {way[-1]:.3g} m")
        self.assertLess(np.abs(apart).max(), 0.02 * way[-1])

    def test_friction_of_second_order_is_whole(self):
        """What slides has rubbed in a step, not at its start: friction must not be weighed as forces there and at the end are."""
        late = slice(100, None)
        accelerations = []
        for order in (1, 2):
            history = self.history(1, *BLOCK, *IN_AIR, "-contact_body_friction", 0.3, "-sled_load", f"{PULL},0,-{PRESS}",
                                   "-coupling_order", order)
            time, place = history["time"][late], history["sled_center_x"][late]
            accelerations.append(2 * np.polyfit(time, place, 2)[0])
            rubbed = 0.3 * history["sled_body_contact_force"][late]
            power = history["sled_friction_power"][late] / (rubbed * np.gradient(place, time))
            load = history["block_force_x"][late] / rubbed
            print(f"order {order}: accelerates by {accelerations[-1]:.3f} m/s2, power {power.mean():.3f} and load {load.mean():.3f} "
                  "of Coulomb's")
            self.assertLess(abs(power.mean() - 1), 0.03)
            self.assertLess(abs(load.mean() - 1), 0.1)  # the air drags too
        self.assertLess(abs(accelerations[1] / accelerations[0] - 1), 0.03)

    def test_water_goes_through_a_permeable_sheet_by_darcys_law(self):
        lighter = ("-contact", "barrier", "-sheet_excess_mass", 1e4)
        for permeance, inflow, scheme, end in ((1e-6, 1e-3, "semi_implicit", 0.1), (1e-5, 1e-2, "semi_implicit", 0.1),
                                               (1e-4, 1e-2, "semi_implicit", 0.1), (1e-3, 1e-2, "semi_implicit", 0.1),
                                               (1e-4, 1e-2, "implicit", 0.02)):
            history = self.history(1, *CHANNEL, "-sheet_permeance", permeance, "-bc_x_lower_velocity", f"{inflow},0",
                                   "-time_end", end, "-coupling_scheme", scheme, *(lighter if scheme == "implicit" else ()))
            speed = np.diff(history["sheet_center_x"])[-1] / np.diff(history["time"])[-1]
            through = permeance * history["sheet_water_force_x"][-1] / 0.32
            print(f"{scheme}, permeance {permeance:g}: {through / (inflow - speed):.5f} of Darcy's flow")
            with self.subTest(permeance=permeance, scheme=scheme):
                self.assertLess(speed, 0.2 * inflow)
                self.assertLess(abs(through - (inflow - speed)), 0.03 * inflow)
                power = (inflow - speed)**2 / permeance * 0.32
                self.assertLess(abs(history["seepage_power"][-1] - power), 0.03 * power)
                self.assertGreaterEqual(history["seepage_power"].min(), 0)

    def test_permeable_towels_carry_the_load_that_presses_them_and_part(self):
        options = [*PRESSED, "-contact", "barrier", "-cloths_permeance", 1e-4, "-upper_direction", "1,0,0",
                   "-upper_center", "0.16,0.16,0.168"]
        pressed = self.history(1, *options, "-time_end", 0.08)
        late = pressed["time"] > 0.04
        force = pressed["lower_contact_force"][late].mean()
        print(f"contact force {force:.4f} N of {500 * 0.15**2} N")
        self.assertLess(abs(force - 500 * 0.15**2), 0.02 * 500 * 0.15**2)
        self.assertEqual(pressed["intersections"].max(), 0)
        parted = self.history(1, *options, "-lower_load", "0,0,-500", "-upper_load", "0,0,500", "-restart",
                              "out/checkpoint.h5", "-time_end", 0.28)
        gap = (parted["upper_center_z"] - parted["lower_center_z"])[parted["time"] >= 0.08]
        print(f"gap {gap[0]:.4g} m when the loads are reversed, {gap[-1]:.4g} m 0.2 s later")
        self.assertEqual(parted["lower_contact_force"][-1], 0)
        self.assertGreater(gap[-1], 0.02)
        tight = self.history(1, *options, "-cloths_permeance", 0, "-time_end", 0.08)
        film = tight["upper_center_z"] - tight["lower_center_z"]
        print(f"tight: gap {film[-1]:.4g} m")
        self.assertGreater(film[-1], 0.006)

    def test_permeable_towels_are_the_same_on_two_ranks(self):
        options = [*PRESSED, "-contact", "barrier", "-cloths_permeance", 1e-5, *TIGHT, "-coupling_tolerance", 1e-11]
        expected, history = self.history(1, *options), self.history(2, *options)
        for name in expected.keys() - NOT_PHYSICAL:
            with self.subTest(column=name):
                self.assertLess(relative_difference(history[name], expected[name]), 1e-6)

    def test_permeable_towels_go_on_to_the_bit_after_a_restart(self):
        options = [*PRESSED, "-contact", "barrier", "-cloths_permeance", 1e-5, "-time_end"]
        for ranks in (1, 2):
            straight = self.history(ranks, *options, 0.01, name="straight")
            self.history(ranks, *options, 0.005, name="half")
            restarted = self.history(ranks, *options, 0.01, "-restart", "half/checkpoint.h5", name="half")
            self.assertGreater(straight["seepage_power"].max(), 0)
            for name, values in straight.items():
                with self.subTest(ranks=ranks, column=name):
                    np.testing.assert_array_equal(restarted[name], values)

    def test_films_between_tight_towels_close_by_the_law_of_squeezed_films(self):
        for viscosity in (0.5, 0.05):
            options = [*FILM, "-fluid_viscosity", viscosity, "-time_end", 0.1]
            history = self.history(1, *options, "-contact_drainage")
            gap = history["upper_center_z"] - history["lower_center_z"]
            expected = squeezed(history["time"], gap[0], viscosity)
            power = 500 * 0.15**2 * -np.diff(gap) / np.diff(history["time"])
            closed = (gap[0] - gap[-1]) / (gap[0] - expected[-1])
            print(f"viscosity {viscosity}: {1e3 * gap[-1]:.3f} mm, {closed:.4f} of the way by the law")
            with self.subTest(viscosity=viscosity):
                self.assertLess(abs(closed - 1), 0.03)
                self.assertLess(relative_difference(history["seepage_power"][1:], power), 0.1)
                still = self.history(1, *options)
                self.assertGreater((still["upper_center_z"] - still["lower_center_z"])[-1], 0.99 * gap[0])

    def test_films_are_the_same_on_two_ranks_in_both_couplings_and_after_a_restart(self):
        for coupling in ("semi_implicit", "implicit"):
            options = [*FILM, "-contact_drainage", "-upper_center", "0.17,0.155,0.164", "-coupling_scheme", coupling,
                       *TIGHT, "-coupling_tolerance", 1e-11]
            expected = self.history(1, *options, "-time_end", 0.01)
            two = self.history(2, *options, "-time_end", 0.01)
            for name in expected.keys() - NOT_PHYSICAL:
                with self.subTest(column=name, coupling=coupling):
                    self.assertLess(relative_difference(two[name], expected[name]), 1e-6)
            self.history(1, *options, "-time_end", 0.005, name="half")
            restarted = self.history(1, *options, "-time_end", 0.01, "-restart", "half/checkpoint.h5", name="half")
            for name, values in expected.items():
                with self.subTest(restarted=name, coupling=coupling):
                    np.testing.assert_array_equal(restarted[name], values)

    def test_permeable_cloth_is_refused_where_it_is_not_solved_for(self):
        for extra in (("-coupling_scheme", "explicit"), ("-coupling_mobility", "row_sums")):
            outcome = run(1, *CHANNEL, "-sheet_permeance", 1e-4, "-time_end", 1, *extra, folder=self.folder)
            self.assertEqual(outcome.returncode, 2, outcome.stderr)
            self.assertIn("-sheet_permeance", outcome.stderr)
            outcome = run(1, *FILM, "-contact_drainage", *extra, folder=self.folder)
            self.assertEqual(outcome.returncode, 2, outcome.stderr)
            self.assertIn("-contact_drainage", outcome.stderr)

    def test_energy_of_cloths_alone_never_grows(self):
        history = self.history(1, *DROPPED, "-contact", "barrier", "-contact_friction", 0)
        height = {"held": 0.3 * 0.4**2, "loose": 0.3 * 0.2**2}  # times mass
        energy = sum(history[f"{name}_elastic_energy"] + 9.81 * mass * history[f"{name}_center_z"]
                     for name, mass in height.items())
        self.assertLess(energy[-1], energy[0])


if __name__ == "__main__":
    unittest.main()
