# SPDX-License-Identifier: BSD-3-Clause
"""The cloth's equations have one solution, whatever solver the user chooses for them."""

import unittest

from support import EXPLICIT_WASH, ProgramTest, read_columns, relative_difference

IMPLICIT = [*EXPLICIT_WASH, "-coupling_scheme", "implicit", "-time_step", 4e-4, "-time_end", 0.02]
SOLVERS = [("qn", "-cloth_snes_qn_type", "badbroyden"), ("qn", "-cloth_snes_qn_type", "lbfgs"), ("newtonls",), ("anderson",)]


class Solvers(ProgramTest):
    def tracks(self, *options):
        """Runs a little of wash2d and returns the cloths' tracks."""
        self.run_well(1, *IMPLICIT, *options, "-output_dir", "out")
        return read_columns(self.folder / "out" / "tracks.csv")

    def test_all_agree_with_the_default(self):
        expected = self.tracks()
        for solver in SOLVERS:
            tracks = self.tracks("-cloth_snes_type", *solver)
            for name in expected.keys() - {"step", "time"}:
                with self.subTest(solver=solver, cloth=name):
                    self.assertLess(relative_difference(tracks[name], expected[name]), 1e-5)

    def test_semi_implicit_takes_other_linear_solvers(self):
        case = ("-coupling_scheme", "semi_implicit")
        names = self.tracks(*case).keys() - {"step", "time"}
        for mobility, solver in (("matrix", ("-cloth_pc_type", "bjacobi")), ("row_sums", ("-cloth_ksp_type", "cg"))):
            base = self.tracks(*case, "-coupling_mobility", mobility)
            tracks = self.tracks(*case, "-coupling_mobility", mobility, *solver)
            for name in names:
                with self.subTest(mobility=mobility, cloth=name):
                    self.assertLess(relative_difference(tracks[name], base[name]), 1e-5)


if __name__ == "__main__":
    unittest.main()
