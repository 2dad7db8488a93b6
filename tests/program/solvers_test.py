# SPDX-License-Identifier: BSD-3-Clause
"""The equations of cloth, pressure and momentum have one solution each, whatever solver the user chooses for them."""

import re
import unittest

from support import EXPLICIT_WASH, SOURCE, TIGHT, ProgramTest, read_columns, relative_difference

IMPLICIT = [*EXPLICIT_WASH, "-coupling_scheme", "implicit", "-time_step", 4e-4, "-time_end", 0.02]
SOLVERS = [("qn", "-cloth_snes_qn_type", "badbroyden"), ("qn", "-cloth_snes_qn_type", "lbfgs"), ("newtonls",), ("anderson",)]

MACHINE = ["-options_file", SOURCE / "inputs" / "wash.opts", "-towel_count", 4, "-time_tolerance", 0, "-time_cfl", 0,
           "-time_step", 2e-3]
# the pressure's and the momentum's, and on how many ranks
WATER_SOLVERS = [("transform", "bcgs", 1), ("hypre", "gmres", 1), ("hypre", "bcgs", 2), ("mg", "gmres", 1), ("mg", "bcgs", 2)]


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


    def test_a_heavy_cloth_in_a_light_fluid_is_solved_for(self):
        """GMRES breaks down there where it does not orthogonalise again."""
        self.run_well(1, "-options_file", SOURCE / "inputs" / "plate.opts", "-coupling_scheme", "semi_implicit", "-coupling_order", 1, "-grid_cells",
                      "17,17,17", "-fluid_density", 0.02, "-time_step", 0.4, "-max_steps", 1, "-output_dir", "out")

class SolversOfWater(ProgramTest):
    """The machine on odd numbers of cells, in which no multigrid halves them all."""

    def machine(self, ranks, *options):
        """Runs the machine; returns the columns of its history and of its cloths' tracks, and the iterations of each pressure solution."""
        text = self.run_well(ranks, *MACHINE, *options, "-output_dir", "out", "-pressure_ksp_converged_reason")
        columns = {name: values for table in ("history", "tracks")
                   for name, values in read_columns(self.folder / "out" / f"{table}.csv").items()}
        return columns, [int(count) for count in re.findall(r"pressure_ solve converged .* iterations (\d+)", text)]

    def test_all_give_the_same_wash(self):
        case = ["-grid_cells", "21,21,15", *TIGHT, "-coupling_tolerance", 1e-9, "-max_steps", 5]
        expected, _ = self.machine(1, *case, "-pressure_pc_type", "transform", "-momentum_ksp_type", "gmres")
        for pressure, momentum, ranks in WATER_SOLVERS:
            columns, _ = self.machine(ranks, *case, "-pressure_pc_type", pressure, "-momentum_ksp_type", momentum)
            for name in expected.keys() - {"max_divergence"}:
                with self.subTest(pressure=pressure, momentum=momentum, ranks=ranks, column=name):
                    self.assertLess(relative_difference(columns[name], expected[name]), 1e-6)

    def test_multigrid_takes_few_iterations_on_33_cells(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                _, iterations = self.machine(ranks, "-pressure_pc_type", "mg", "-max_steps", 3)
                self.assertGreater(len(iterations), 3)
                self.assertLessEqual(max(iterations), 12)


if __name__ == "__main__":
    unittest.main()
