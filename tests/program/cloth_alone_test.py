# SPDX-License-Identifier: BSD-3-Clause
"""Cloth without fluid: its kinetic energy and its angular momentum are those of its mass, by mechanics."""

import unittest

import numpy as np
from support import ProgramTest, read_columns

PLANE = ["-grid_cells", "16,16", "-grid_lower", "-1,0", "-grid_upper", "3,4", "-fluid", "none", "-cloths", "towel", "-towel_size", 0.5,
         "-towel_markers", 10, "-towel_excess_mass", 0.3, "-towel_ke", 200, "-towel_kb", 1e-3, "-contact", "none", "-time_step", 1e-3,
         "-output_interval", 10]
SPACE = ["-grid_cells", "16,16,16", "-grid_lower", "-1,0,-2", "-grid_upper", "3,4,2", "-fluid", "none", "-cloths", "towel", "-towel_size",
         "0.5,0.4", "-towel_markers", "10,8", "-towel_excess_mass", 0.3, "-towel_ke", 200, "-towel_kb", 1e-3, "-contact", "none",
         "-time_step", 1e-3, "-output_interval", 10]
MIDDLE = np.array([1, 2])  # of both boxes, from above


class ClothAlone(ProgramTest):
    def history(self, *options, ranks=1):
        self.run_well(ranks, *options, "-output_dir", "out")
        return read_columns(self.folder / "out" / "history.csv")

    def test_free_flight(self):
        """All of a cloth has one velocity, which gravity changes evenly."""
        cases = {"plane": (PLANE, 0.5 * 0.3, "1.1,0.7", "1,-2", "0.5,3"),
                 "space": (SPACE, 0.5 * 0.4 * 0.3, "1.1,0.7,0.3", "1,-2,0.5", "0.5,3,-0.4")}
        for name, (case, mass, center, gravity, velocity) in cases.items():
            for scheme in ("explicit", "implicit"):
                with self.subTest(case=name, scheme=scheme):
                    history = self.history(*case, "-coupling_scheme", scheme, "-towel_center", center, "-gravity", gravity,
                                           "-towel_velocity", velocity, "-time_end", 0.3, ranks=2)
                    gravity_, start = (np.fromstring(text, sep=",") for text in (gravity, velocity))
                    v = start + np.outer(history["time"], gravity_)
                    arm = np.array([history["towel_center_x"], history["towel_center_y"]]).T - MIDDLE
                    np.testing.assert_allclose(history["kinetic_energy"], 0.5 * mass * (v ** 2).sum(axis=1), rtol=2e-4)
                    np.testing.assert_allclose(history["angular_momentum"], mass * (arm[:, 0] * v[:, 1] - arm[:, 1] * v[:, 0]), rtol=2e-4)

    def test_rotation_about_the_middle_of_the_box(self):
        """A cloth that flies past is held by its end, in the middle of the box, where the hold has neither leverage nor power."""
        velocity, mass = 2, 0.5 * 0.3
        history = self.history(*PLANE, "-towel_ke", 2000, "-towel_center", "1.225,2", "-towel_velocity", f"0,{velocity}", "-towel_hold", "first",
                               "-time_step", 1e-4, "-time_end", 0.3)
        arms = np.linspace(0, 0.45, 10)  # of the markers
        np.testing.assert_allclose(history["angular_momentum"], mass * velocity * arms.mean(), rtol=1e-3)
        energy = history["kinetic_energy"] + history["towel_elastic_energy"]
        np.testing.assert_allclose(energy, 0.5 * mass * velocity ** 2, rtol=0.1)  # the held end takes a part at once
        self.assertLess(np.ptp(energy[100:]), 0.01 * energy[0])

    def test_a_swing_keeps_its_energy(self):
        history = self.history(*PLANE, "-towel_ke", 1000, "-towel_center", "1.225,2", "-gravity", "0,-9.81", "-towel_hold", "first",
                               "-time_step", 1e-4, "-time_end", 0.25)
        height = history["towel_center_y"] - 2
        energy = history["kinetic_energy"] + history["towel_elastic_energy"] + 0.15 * 9.81 * height
        self.assertGreater(history["kinetic_energy"].max(), 0.2)
        self.assertLess(np.abs(energy).max(), 0.01 * history["kinetic_energy"].max())


if __name__ == "__main__":
    unittest.main()
