# SPDX-License-Identifier: BSD-3-Clause
"""A foil that is its own mirror image: it has no lift in a stream along it, and the opposite one at the opposite angle."""

import unittest

import numpy as np
from support import TIGHT, ProgramTest, read_columns

HALF = 0.5 * (1 - np.cos(np.linspace(0, np.pi, 41)))
THICK = 0.6 * (0.2969 * np.sqrt(HALF) - 0.126 * HALF - 0.3516 * HALF ** 2 + 0.2843 * HALF ** 3 - 0.1036 * HALF ** 4)
THICK[-1] = 0
UPPER = [(float(x) - 0.5, float(y)) for x, y in zip(HALF, THICK)]
FOIL = ",".join(f"{x!r},{y!r}" for x, y in UPPER + [(x, -y) for x, y in UPPER[-2:0:-1]])  # NACA 0012
CELLS = 24
PLANE = ["-grid_upper", "2.5,1.5", "-bc_x_lower", "inflow", "-bc_x_lower_velocity", "1,0", "-bc_x_upper", "outflow", "-bc_y_lower", "slip",
         "-bc_y_upper", "slip", "-fluid_density", 1, "-fluid_viscosity", 0.002, "-fluid_initial", "uniform", "-fluid_initial_velocity", "1,0",
         "-bodies", "foil", "-foil_shape", "polygon", "-foil_vertices", FOIL, "-time_cfl", 0.5, "-time_end", 1, "-output_interval", 100, *TIGHT]
SPACE = ["-grid_cells", f"{5 * CELLS // 2},{3 * CELLS // 2},8", "-grid_upper", f"2.5,1.5,{8 / CELLS}", "-bc_x_lower_velocity", "1,0,0",
         "-bc_z_lower", "periodic", "-bc_z_upper", "periodic", "-fluid_initial_velocity", "1,0,0", "-foil_height", 1, "-foil_center", "1,0.75,0",
         "-max_steps", 8]


class Foil(ProgramTest):
    def loads(self, *options):
        self.run_well(1, *PLANE, *options, "-output_dir", "out")
        history = read_columns(self.folder / "out" / "history.csv")
        return history["foil_force_x"], history["foil_force_y"]

    def test_a_stream_along_it_does_not_lift_it(self):
        for method in ("mapping", "ghost", "cut_stencil", "direct_forcing"):
            for rows in (36, 37):  # its chord between faces, and on them
                with self.subTest(method=method, rows=rows):
                    drag, lift = self.loads("-body_method", method, "-grid_cells", f"60,{rows}", "-grid_upper", f"2.5,{rows / CELLS!r}",
                                            "-foil_center", f"1,{rows / CELLS / 2!r}")
                    self.assertLess(np.abs(lift).max(), 1e-8 * np.abs(drag).max())
                    self.assertGreater(drag[-1], 0.05)

    def test_nor_in_space(self):
        for method in ("cut_stencil", "direct_forcing"):
            with self.subTest(method=method):
                drag, lift = self.loads(*SPACE, "-body_method", method)
                self.assertLess(np.abs(lift).max(), 1e-8 * np.abs(drag).max())

    def test_opposite_angles_have_opposite_lifts(self):
        for method in ("cut_stencil", "direct_forcing"):
            with self.subTest(method=method):
                (drag, lift), (other_drag, other_lift) = (
                    self.loads("-body_method", method, "-grid_cells", "60,36", "-foil_center", "1,0.75", "-foil_turn", turn,
                               "-body_slip_tolerance", 5e-4) for turn in (-10, 10))
                self.assertLess(np.abs(lift + other_lift).max(), 1e-6 * np.abs(drag).max())
                np.testing.assert_allclose(other_drag, drag, rtol=1e-5)
                self.assertGreater(lift[-1], 0.1)


if __name__ == "__main__":
    unittest.main()
