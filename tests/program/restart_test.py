# SPDX-License-Identifier: BSD-3-Clause
"""A run that is interrupted and restarted from its checkpoint ends where the uninterrupted one does."""

import shutil
import subprocess
import unittest

import h5py
import numpy as np

from support import CHANNEL, EXPLICIT_WASH, SHEET, TIGHT, ProgramTest, read_columns, relative_difference

CASE = [*EXPLICIT_WASH, *TIGHT]


def datasets(path):
    """Returns all datasets of an HDF5 file by name."""
    found = {}

    def remember(name, member):
        if isinstance(member, h5py.Dataset):
            found[name] = member[()]

    with h5py.File(path) as file:
        file.visititems(remember)
    return found


def last_frame(path):
    """Returns the name of the last frame of a series."""
    with h5py.File(path) as file:
        return max(file["frames"].values(), key=lambda frame: frame.attrs["time"]).name


class Restart(ProgramTest):
    def setUp(self):
        super().setUp()
        self.straight, self.split = self.folder / "straight", self.folder / "split"
        self.run_well(2, *CASE, "-time_end", 0.1, "-output_dir", self.straight)
        self.run_well(2, *CASE, "-time_end", 0.05, "-output_dir", self.split)

    def restart(self, ranks):
        """Continues the run of half the time, in a copy of its folder; returns this folder."""
        folder = self.folder / f"split_{ranks}"
        shutil.copytree(self.split, folder)
        self.run_well(ranks, *CASE, "-time_end", 0.1, "-restart", folder / "checkpoint.h5", "-output_dir", folder)
        return folder

    def assert_same_bits(self, file, other, *members):
        """Compares two HDF5 files, or one member of each, with all attributes."""
        outcome = subprocess.run(["h5diff", file, other, *members],
                                 capture_output=True, text=True, check=False)
        self.assertEqual((outcome.returncode, outcome.stdout, outcome.stderr), (0, "", ""), f"{other} {members}")

    def assert_same_results(self, folder):
        """Compares the final state, the last frames and the history with those of the straight run."""
        self.assertEqual(datasets(self.straight / "checkpoint.h5").keys(), datasets(folder / "checkpoint.h5").keys())
        self.assert_same_bits(self.straight / "checkpoint.h5", folder / "checkpoint.h5")
        for name in ("flow.h5", "cloth.h5", "bodies.h5"):
            expected, frame = last_frame(self.straight / name), last_frame(folder / name)
            self.assert_same_bits(self.straight / name, folder / name, expected, frame)
        self.assertEqual((self.straight / "history.csv").read_text(), (folder / "history.csv").read_text())

    def assert_close_results(self, folder):
        """Compares the final state with that of the straight run, to 1e-6 of each dataset's largest number."""
        expected, state = datasets(self.straight / "checkpoint.h5"), datasets(folder / "checkpoint.h5")
        self.assertEqual(state.keys(), expected.keys())
        for name, values in expected.items():
            if name == "totals/largest_max_divergence":  # what the solver left
                continue
            with self.subTest(folder=folder.name, dataset=name):
                self.assertLess(relative_difference(state[name], values), 1e-6)
        steps = read_columns(folder / "history.csv")["step"]
        np.testing.assert_array_equal(steps, np.arange(1, 1001))

    def test_restarts_agree_with_the_straight_run(self):
        with self.subTest(ranks=2):
            self.assert_same_results(self.restart(2))
        for ranks in (1, 3):
            with self.subTest(ranks=ranks):
                self.assert_close_results(self.restart(ranks))


class RestartOfCouplings(ProgramTest):
    """Whatever couples cloth and water, the checkpoint holds all that it needs."""

    def test_restarts_agree_with_the_straight_run(self):
        steps_of_bound = ["-time_step", 0, "-time_cfl", 0.5]
        for coupling, steps in [("midpoint", ["-time_step", 2e-4]), ("semi_implicit", ["-time_step", 1e-3]),
                                ("implicit", ["-time_step", 1e-3]), ("explicit", steps_of_bound)]:
            case = [*CASE, "-coupling_scheme", coupling, *steps]
            straight, half = self.folder / f"{coupling}_straight", self.folder / f"{coupling}_half"
            self.run_well(2, *case, "-time_end", 0.04, "-output_dir", straight)
            self.run_well(2, *case, "-time_end", 0.02, "-output_dir", half)
            self.run_well(2, *case, "-time_end", 0.04, "-restart", half / "checkpoint.h5", "-output_dir", half)
            for name in ("history.csv", "tracks.csv"):
                with self.subTest(coupling=coupling, name=name):
                    self.assertEqual((straight / name).read_text(), (half / name).read_text())


class RestartOfSheets(ProgramTest):
    """In space too, with steps for a CFL number."""

    def assert_restart_agrees(self, *options):
        """Returns the history."""
        case = ["-options_file", SHEET, *TIGHT, *options]
        self.run_well(2, *case, "-time_end", 0.4, "-output_dir", "straight")
        self.run_well(2, *case, "-time_end", 0.2, "-output_dir", "half")
        self.run_well(2, *case, "-time_end", 0.4, "-restart", "half/checkpoint.h5", "-output_dir", "half")
        straight = read_columns(self.folder / "straight" / "history.csv")
        restarted = read_columns(self.folder / "half" / "history.csv")
        for name, values in straight.items():
            with self.subTest(column=name):
                np.testing.assert_array_equal(restarted[name], values)
        return straight

    def test_restart_agrees_with_the_straight_run(self):
        self.assert_restart_agrees()

    def test_restart_agrees_with_models_of_turbulence(self):
        history = self.assert_restart_agrees("-turbulence", "vreman", "-wall_model", "equilibrium", "-fluid_viscosity", 5e-3)
        self.assertGreater(history["wall_y_plus_max"][-1], 5)
        self.assertTrue(np.all(history["eddy_viscosity_mean"][1:] > 0))
        with h5py.File(self.folder / "half" / "flow.h5") as file:
            frame = max(file["frames"].values(), key=lambda one: one.attrs["time"])
            self.assertAlmostEqual(float(np.max(frame["eddy_viscosity"])) / history["eddy_viscosity_max"][-1], 1, places=5)

    def test_restart_agrees_with_the_law_of_bodies(self):
        body = ["-bodies", "ball", "-ball_shape", "sphere", "-ball_radius", 0.03, "-ball_center", "0.1,0,0.1",
                "-ball_angular_speed", 10, "-body_method", "direct_forcing"]
        history = self.assert_restart_agrees("-wall_model", "equilibrium", "-fluid_viscosity", 5e-3, *body)
        self.assertGreater(history["ball_y_plus_max"][-1], 3)

    def test_models_and_bodies_may_come_and_go_at_a_restart(self):
        case = ["-options_file", SHEET, *TIGHT, "-fluid_viscosity", 5e-3]
        ball = ["-bodies", "ball", "-ball_shape", "sphere", "-ball_radius", 0.03, "-ball_center", "0.1,0,0.1",
                "-ball_angular_speed", 10, "-body_method", "direct_forcing"]
        models = ["-turbulence", "vreman", "-wall_model", "equilibrium"]
        before, columns = None, {}
        for name, end, options in (("laminar", 0.05, []), ("turbulent", 0.1, models), ("with_ball", 0.15, [*models, *ball]),
                                   ("again", 0.2, [])):
            restart = ["-restart", f"{before}/checkpoint.h5"] if before else []
            self.run_well(2, *case, *options, "-time_end", end, "-output_dir", name, *restart)
            columns[name] = read_columns(self.folder / name / "history.csv")
            before = name
        self.assertGreater(columns["turbulent"]["eddy_viscosity_max"][-1], 0)
        self.assertGreater(columns["with_ball"]["ball_y_plus_max"][-1], 0)
        self.assertNotIn("eddy_viscosity_max", columns["again"])

    def test_restart_agrees_where_steps_have_a_longest_length_too(self):
        longest, courant = 0.008, 0.145
        history = self.assert_restart_agrees("-time_step", longest, "-time_cfl", courant)
        self.assertEqual(history["dt"].max(), longest)
        self.assertLess(history["dt"][-1], 0.97 * longest)
        np.testing.assert_array_less(history["cfl"], 1.1 * courant)

    def test_restart_agrees_where_steps_are_as_short_as_accuracy_wants(self):
        tolerance, lid_speed = 2e-3, 0.2
        history = self.assert_restart_agrees("-time_tolerance", tolerance)
        late = history["time"] > 0.2
        np.testing.assert_array_less(history["step_error"][late], 1.1 * tolerance * lid_speed)
        self.assertLess(history["cfl"][late].max(), 0.3)  # without it 0.4, which the case asks for


class RestartOfWallForces(ProgramTest):
    """A step of walls that turn begins with the forces of the step before, after a restart too."""

    def test_restart_agrees_with_the_straight_run(self):
        case = ["-grid_cells", "40,40", "-fluid_density", 1, "-fluid_viscosity", 2e-3, "-body_method", "direct_forcing", "-bodies", "vane",
                "-vane_shape", "vaned", "-vane_hub_radius", 0.08, "-vane_tip_radius", 0.3, "-vane_vane_thickness", 0.06,
                "-vane_center", "0.5,0.5", "-vane_angular_speed", 4, "-vane_frequency", 2, "-time_step", 5e-3, "-body_slip_tolerance", 1e-3]
        self.run_well(2, *case, "-time_end", 0.2, "-output_dir", "straight")
        self.run_well(2, *case, "-time_end", 0.1, "-output_dir", "half")
        self.assertIn("walls/force", datasets(self.folder / "half" / "checkpoint.h5"))
        self.run_well(2, *case, "-time_end", 0.2, "-restart", "half/checkpoint.h5", "-output_dir", "half")
        self.assertEqual((self.folder / "straight" / "history.csv").read_text(), (self.folder / "half" / "history.csv").read_text())


class RestartOfOpenSides(ProgramTest):
    """What the open sides hold belongs to the state."""

    def test_restarts_agree_with_the_straight_run(self):
        case = ["-options_file", CHANNEL, *TIGHT, "-fluid_viscosity", 1e-3]
        self.run_well(2, *case, "-time_end", 0.4, "-output_dir", "straight")
        self.run_well(2, *case, "-time_end", 0.2, "-output_dir", "half")
        expected = datasets(self.folder / "straight" / "checkpoint.h5")
        self.assertIn("outflow/x_upper", expected)
        for ranks in (1, 2, 3):
            self.run_well(ranks, *case, "-time_end", 0.4, "-restart", "half/checkpoint.h5", "-output_dir", f"on_{ranks}")
            state = datasets(self.folder / f"on_{ranks}" / "checkpoint.h5")
            for name, values in expected.items():
                with self.subTest(ranks=ranks, dataset=name):
                    self.assertLessEqual(relative_difference(state[name], values), 0 if ranks == 2 else 1e-7)


class RestartOfMovingBodies(ProgramTest):
    """Bodies are where the time says, whatever moves them."""

    def test_restarts_agree_with_the_straight_run(self):
        (self.folder / "motion.csv").write_text("time,x,y,angle\n0,0,0,0\n0.07,0.01,-0.02,0.2\n0.3,0,0.1,-1\n")
        (self.folder / "case.opts").write_text("""
            -grid_cells 32,32
            -bodies paddle,bar
            -body_method mapping
            -paddle_shape difference
            -paddle_parts plate,hole
            -paddle_plate_shape box
            -paddle_plate_size 0.4,0.1
            -paddle_hole_radius 0.03
            -paddle_center 0.4,0.5
            -paddle_motion_file motion.csv
            -bar_shape capsule
            -bar_from 0,-0.1
            -bar_to 0,0.1
            -bar_radius 0.05
            -bar_center 0.8,0.5
            -bar_velocity 0.5,0.2
            -bar_frequency 2
            -time_step 5e-3
            """)
        case = ["-options_file", "case.opts", *TIGHT, "-fluid_viscosity", 1]
        self.run_well(2, *case, "-time_end", 0.2, "-output_dir", "straight")
        self.run_well(2, *case, "-time_end", 0.1, "-output_dir", "half")
        expected = datasets(self.folder / "straight" / "checkpoint.h5")
        for ranks in (1, 2):
            self.run_well(ranks, *case, "-time_end", 0.2, "-restart", "half/checkpoint.h5", "-output_dir", f"on_{ranks}")
            state = datasets(self.folder / f"on_{ranks}" / "checkpoint.h5")
            for name, values in expected.items():
                if name == "totals/largest_max_divergence" and ranks != 2:  # what the solver left
                    continue
                with self.subTest(ranks=ranks, dataset=name):
                    self.assertLessEqual(relative_difference(state[name], values), 0 if ranks == 2 else 1e-7)


class RestartOfSurfaces(ProgramTest):
    """The bodies' surfaces are joined alike on any number of ranks, so that the frames of several starts are one series."""

    case = ["-grid_cells", "16,16,12", "-fluid_viscosity", 1, "-time_step", 5e-3, "-output_interval", 0.01, "-bodies", "ball,egg",
            "-body_method", "mapping", "-ball_radius", 0.21, "-ball_center", "0.31,0.47,0.52", "-ball_velocity", "1,0,0",
            "-egg_radius", 0.13, "-egg_center", "0.7,0.53,0.5"]

    def areas(self, folder):
        """Returns the area of the surfaces in each frame."""
        with h5py.File(self.folder / folder / "surfaces.h5") as file:
            corners = [frame["position"][()][file["topology"][()]] for frame in file["frames"].values()]
        return [0.5 * np.linalg.norm(np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0]), axis=1).sum() for c in corners]

    def test_frames_before_and_after_are_of_the_same_surfaces(self):
        self.run_well(1, *self.case, "-time_end", 0.01, "-output_dir", "out")
        self.run_well(3, *self.case, "-time_end", 0.02, "-restart", "out/checkpoint.h5", "-output_dir", "out")
        np.testing.assert_allclose(self.areas("out"), 3 * [4 * np.pi * (0.21 ** 2 + 0.13 ** 2)], rtol=0.02)

    def test_the_series_begins_anew_with_other_bodies(self):
        self.run_well(1, *self.case, "-time_end", 0.01, "-output_dir", "out")
        self.run_well(1, *self.case, "-time_end", 0.02, "-restart", "out/checkpoint.h5", "-output_dir", "out", "-egg_radius", 0.2)
        np.testing.assert_allclose(self.areas("out"), [4 * np.pi * (0.21 ** 2 + 0.2 ** 2)], rtol=0.02)


if __name__ == "__main__":
    unittest.main()
