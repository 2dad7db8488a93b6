# SPDX-License-Identifier: BSD-3-Clause
"""The lid-driven cavity at Re = 100 agrees with Ghia, Ghia & Shin (1982) on its centre lines."""

import csv
import json
import unittest

import numpy as np

from support import CAVITY, SOURCE, ProgramTest, read_columns

REFERENCE = SOURCE / "tests" / "verification" / "reference" / "cavity"
LINES = ["-profiles", "vertical,horizontal",
         "-vertical_from", "0.5,0", "-vertical_to", "0.5,1", "-vertical_points", 513,
         "-horizontal_from", "0,0.5", "-horizontal_to", "1,0.5", "-horizontal_points", 513]
IN_SPACE = ["-grid_cells", "32,32,32", "-grid_lower", "0,0,0", "-grid_upper", "1,1,1",
            "-bc_y_upper_velocity", "1,0,0"]


def read_reference(name, place, value):
    """Returns two columns of a table of Ghia et al."""
    with open(REFERENCE / name, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return np.array([[float(row[place]), float(row[value])] for row in rows]).T


class Cavity(ProgramTest):
    def assert_agrees(self, profile, table, place, component):
        """Compares a sampled line, interpolated linearly, with Re = 100 of a table."""
        places, expected = read_reference(table, place, f"{component}_Re100")
        self.assertEqual(len(places), 17)
        sampled = read_columns(self.folder / "out" / "profiles" / f"{profile}.csv")
        values = np.interp(places, sampled[place], sampled[component])
        worst = np.abs(values - expected).argmax()
        self.assertLess(abs(values[worst] - expected[worst]), 0.01, f"{component} at {place} = {places[worst]}")

    def test_centre_lines_agree_with_ghia(self):
        self.run_well(2, "-options_file", CAVITY, "-output_dir", "out", *LINES)
        self.assert_agrees("vertical", "ghia1982_u_x0.5.csv", "y", "u")
        self.assert_agrees("horizontal", "ghia1982_v_y0.5.csv", "x", "v")

    def test_runs_in_three_dimensions(self):
        self.run_well(2, "-options_file", CAVITY, "-output_dir", "out", *IN_SPACE, "-max_steps", 3)
        history = read_columns(self.folder / "out" / "history.csv")
        self.assertEqual(list(history["step"]), [1, 2, 3])
        self.assertGreater(history["kinetic_energy"][-1], 0)

    def peak_memory(self, cells):
        """Returns the most memory that a few steps on cells^3 take [byte]."""
        self.run_well(2, "-grid_cells", f"{cells},{cells},{cells}", "-bc_y_upper_velocity", "1,0,0", "-fluid_density", 1,
                      "-fluid_viscosity", 1e-3, "-time_step", 2.5e-3, "-max_steps", 6, "-time_end", 1, "-output_dir", "out")
        return json.loads((self.folder / "out" / "summary.json").read_text())["peak_memory_bytes"]

    def test_takes_little_memory_a_cell(self):
        most = 850  # [byte]: a hundred numbers; 750 when it was written, 1000 with fields of bodies that there are not
        self.assertLess(self.peak_memory(48) - self.peak_memory(32), most * (48**3 - 32**3))


if __name__ == "__main__":
    unittest.main()
