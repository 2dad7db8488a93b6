# SPDX-License-Identifier: BSD-3-Clause
"""Bodies behind periodic sides: it must not matter where in a periodic box a body lies, nor whether it passes its sides."""

import unittest

import h5py
import numpy as np
from support import TIGHT, ProgramTest, read_columns, run

METHODS = ("mapping", "mapping_variable", "ghost", "cut_stencil", "direct_forcing")
PERIODIC = {axis: [f"-bc_{axis}_lower", "periodic", f"-bc_{axis}_upper", "periodic"] for axis in "xyz"}
CHANNEL = ["-grid_cells", "48,16", "-grid_upper", "3,1", *PERIODIC["x"], "-fluid_density", 1, "-fluid_viscosity", 0.02, "-bodies", "post",
           *TIGHT, "-output_interval", 100]
STREAM = [*CHANNEL, "-fluid_bulk_velocity", "0.5,0", "-fluid_initial", "uniform", "-fluid_initial_velocity", "0.5,0", "-post_radius", 0.17,
          "-time_step", 0.02, "-time_end", 0.2]
PADDLE = [*CHANNEL, "-post_shape", "box", "-post_size", "0.5,0.2", "-post_velocity", "0.6,0", "-post_angular_speed", 2, "-time_step", 0.01,
          "-time_end", 0.3, "-body_balance", "true"]
BALL = ["-grid_cells", "12,12,12", "-grid_upper", "1,1,1", *PERIODIC["x"], *PERIODIC["y"], *PERIODIC["z"], "-fluid_density", 1,
        "-fluid_viscosity", 0.1, "-bodies", "post,slat", "-post_radius", 0.2, "-post_velocity", "-0.3,0.5,1", "-slat_shape", "box", "-slat_size",
        "0.4,0.4,0.2", "-slat_angular_speed", 2, "-time_step", 0.01, "-time_end", 0.05, "-output_interval", 100, *TIGHT]
FALL = ["-grid_cells", "32,32", "-grid_upper", "1,1", *PERIODIC["x"], "-fluid", "none", "-gravity", "0,-1", "-cloth_drag", 1, "-bodies",
        "post", "-post_radius", 0.2, "-cloths", "towel", "-towel_size", 0.5, "-towel_markers", 20, "-towel_ke", 100, "-towel_kb", 1e-3,
        "-towel_excess_mass", 1, "-contact", "penalty", "-contact_friction", 0.3, "-contact_distance", 0.03, "-contact_pressure", 20, "-time_step", 2e-3,
        "-time_end", 0.8]


def loads(history):
    """All columns of loads on bodies."""
    parts = ("_force_", "_torque", "_power")
    return {name: values for name, values in history.items() if any(part in name for part in parts) and not name.startswith("wall")}


class PeriodicBodies(ProgramTest):
    def history(self, *options, ranks=1):
        self.run_well(ranks, *options, "-output_dir", "out")
        return read_columns(self.folder / "out" / "history.csv")

    def assert_alike(self, one, other, tolerance):
        one, other = loads(one), loads(other)
        largest = max(np.abs(values).max() for values in one.values())
        self.assertGreater(largest, 0)
        for name, values in one.items():
            np.testing.assert_allclose(other[name], values, rtol=0, atol=tolerance * largest, err_msg=name)

    def test_a_post_on_the_side_has_the_loads_of_one_in_the_middle(self):
        for method in METHODS:
            with self.subTest(method=method):
                case = [*STREAM, "-body_method", method]
                middle, side = (self.history(*case, "-post_center", center) for center in ("1.5,0.5", "0,0.5"))
                self.assert_alike(middle, side, 1e-9)
                self.assert_alike(middle, self.history(*case, "-post_center", "3,0.5", ranks=2), 1e-9)
                self.assertLess(abs(side["post_force_y"][-1]), 1e-3 * abs(side["post_force_x"][-1]))

    def test_a_paddle_passes_the_side_as_it_passes_the_middle(self):
        """It turns, so that its torque and its material's velocity must be those about the centre of its image."""
        for method in METHODS:
            with self.subTest(method=method):
                case = [*PADDLE, "-body_method", method]
                middle = self.history(*case, "-post_center", "1.4,0.47")
                self.assert_alike(middle, self.history(*case, "-post_center", "2.9,0.47"), 1e-8)
                self.assert_alike(middle, self.history(*case, "-post_center", "14.9,0.47", ranks=2), 1e-8)

    def test_bodies_in_a_corner_in_space(self):
        for method in ("mapping", "cut_stencil", "direct_forcing"):
            with self.subTest(method=method):
                case = [*BALL, "-body_method", method]
                middle = self.history(*case, "-post_center", "0.5,0.5,0.5", "-slat_center", "0.5,0.5,0")
                corner = self.history(*case, "-post_center", "0,1,2", "-slat_center", "1,0,0.5", ranks=2)
                self.assert_alike(middle, corner, 1e-8)

    def test_cloth_falls_on_a_post_behind_the_side(self):
        ends = []
        for post, towel in (("0.5,0.3", "0.55,0.6"), ("0,0.3", "0.05,0.6"), ("1,0.3", "0.05,0.6")):
            self.run_well(1, *FALL, "-post_center", post, "-towel_center", towel, "-output_dir", "out")
            history = read_columns(self.folder / "out" / "history.csv")
            with open(self.folder / "out" / "cloth_final.csv", encoding="utf-8") as file:
                names = next(file).strip().split(",")
                end = np.loadtxt(file, delimiter=",", skiprows=1, usecols=(names.index("x"), names.index("y")))
            ends.append((end - [float(towel.split(",")[0]), 0], history["post_force_y"], history["post_torque"]))
        self.assertLess(ends[0][1].min(), -0.1)
        for other in ends[1:]:
            for mine, theirs in zip(ends[0], other):
                np.testing.assert_allclose(theirs, mine, rtol=0, atol=1e-6)

    def test_what_is_written_of_a_body_lies_in_the_box(self):
        self.history(*PADDLE, "-body_method", "mapping", "-post_center", "14.9,0.47", "-output_interval", 0.15)
        for frame in sorted((self.folder / "out" / "surfaces").glob("[0-9]*.h5")):
            with h5py.File(frame) as file:
                places = file["position"][()]
            self.assertLess(np.ptp(places[:, 0]), 0.6)
            self.assertLess(abs(places[:, 0].mean() - 1.5), 1.5)
            self.assertAlmostEqual(places[:, 1].mean(), 0.47, delta=0.02)

    def test_what_cannot_be_repeated_is_refused_in_one_line(self):
        for options, words in ((["-post_radius", 0.6, "-grid_cells", "16,16", "-grid_upper", "1,1"],
                                ["post", "overlaps its own images along x", "1 m"]),
                               (["-post_shape", "halfspace", "-post_normal", "-0.1,1"], ["post", "without end along x"])):
            outcome = run(1, *CHANNEL, "-body_method", "mapping", "-post_center", "1.5,0.5", *options, "-time_step", 0.02, "-time_end", 0.04,
                          folder=self.folder)
            self.assertEqual(outcome.returncode, 2)
            lines = [line for line in (outcome.stdout + outcome.stderr).splitlines() if "-bodies" in line]
            self.assertEqual(len(lines), 1)
            for word in words:
                self.assertIn(word, lines[0])


if __name__ == "__main__":
    unittest.main()
