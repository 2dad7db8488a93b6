# SPDX-License-Identifier: BSD-3-Clause
"""The physics of cloth in water does not depend on the number of ranks."""

import unittest

import numpy as np

from support import EXPLICIT_WASH, SHEET, TIGHT, ProgramTest, read_columns, relative_difference

NOT_PHYSICAL = {"step", "dt", "max_divergence"}


class Ranks(ProgramTest):
    def history(self, ranks, *options):
        """Runs 0.1 s of wash2d and returns the columns of its history."""
        self.run_well(ranks, *EXPLICIT_WASH, "-time_end", 0.1, *TIGHT, *options, "-output_dir", f"on_{ranks}")
        return read_columns(self.folder / f"on_{ranks}" / "history.csv")

    def assert_same(self, history, expected, **which):
        """Compares all that is physical, to 1e-6 of each column's largest number."""
        self.assertEqual(history.keys(), expected.keys())
        for name in expected.keys() - NOT_PHYSICAL:
            with self.subTest(column=name, **which):
                self.assertLess(relative_difference(history[name], expected[name]), 1e-6)

    def test_history_agrees_on_one_to_four_ranks(self):
        expected = self.history(1)
        self.assertEqual(len(expected["step"]), 1000)
        for ranks in (2, 3, 4):
            self.assert_same(self.history(ranks), expected, ranks=ranks)

    def sheets(self, cells):
        """Returns history and final markers of a sheet in a shear flow, by the number of ranks."""
        case = ["-options_file", SHEET, *TIGHT, "-coupling_tolerance", 1e-12, "-time_end", 0.4, "-grid_cells", cells]
        tables = {}
        for ranks in (1, 2, 3):
            self.run_well(ranks, *case, "-output_dir", f"sheet_{ranks}")
            tables[ranks] = read_columns(self.folder / f"sheet_{ranks}" / "history.csv")
            with open(self.folder / f"sheet_{ranks}" / "cloth_final.csv", encoding="utf-8") as file:
                rows = [line.split(",")[4:] for line in file.readlines()[2:]]
            tables[ranks]["markers"] = np.array(rows, dtype=float)
        self.assertGreater(len(tables[1]["step"]), 10)
        return tables

    def test_sheet_in_a_shear_flow_is_the_same_on_one_two_and_three_ranks(self):
        tables = self.sheets("32,16,32")
        for table in tables.values():  # while nothing moves yet, what is solved to the flow's speed is solved coarsely
            table["cloth_slip"] = table["cloth_slip"][2:]
        for ranks in (2, 3):
            self.assert_same(tables[ranks], tables[1], ranks=ranks)

    def test_water_is_measured_beside_a_sheet_that_leans_in_flat_cells(self):
        tables = self.sheets("16,16,32")  # four times as wide as high
        for ranks in (2, 3):
            for name in ("towel_relative_speed_mean", "towel_water_shear_mean"):
                self.assertLess(relative_difference(tables[ranks][name], tables[1][name]), 1e-6, (ranks, name))

    def test_steps_as_accuracy_wants_them_are_the_same_on_one_and_three_ranks(self):
        options = ("-coupling_scheme", "semi_implicit", "-time_step", 5e-3, "-time_cfl", 0.5, "-time_tolerance", 2e-3,
                   "-coupling_tolerance", 1e-10)
        tables = {ranks: self.history(ranks, *options) for ranks in (1, 3)}
        self.assertLess(tables[1]["cfl"].max(), 0.45)  # shorter than the flow's
        self.assertLess(relative_difference(tables[3]["dt"], tables[1]["dt"]), 1e-6)
        self.assert_same(tables[3], tables[1])

    def test_history_of_couplings_that_solve_agrees_on_one_and_three_ranks(self):
        for coupling in ("semi_implicit", "implicit"):
            options = ("-coupling_scheme", coupling, "-time_step", 1e-3, "-coupling_tolerance", 1e-10)
            tables = {ranks: self.history(ranks, *options) for ranks in (1, 3)}
            if coupling == "implicit":  # its steps are by the rule to which they are compared, but for -coupling_tolerance
                for table in tables.values():
                    self.assertLess(table.pop("step_error").max(), 1e-6)
            self.assert_same(tables[3], tables[1], coupling=coupling)


if __name__ == "__main__":
    unittest.main()
