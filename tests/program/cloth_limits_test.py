# SPDX-License-Identifier: BSD-3-Clause
"""A sheet across a stream of a thin liquid. Tight: central differences may let it off, upwind beside the cloth does not. Permeable: what
must not matter to its load."""

import unittest

import numpy as np
from support import ProgramTest, read_columns

STREAM = """
-grid_cells 48,36
-grid_lower -3,-3
-grid_upper 5,3
-bc_x_lower inflow
-bc_x_lower_velocity 1,0
-bc_x_upper outflow
-bc_y_lower slip
-bc_y_upper slip
-fluid_density 1
-fluid_viscosity 1e-3
-fluid_initial uniform
-fluid_initial_velocity 1,0
-cloths sheet
-sheet_size 1
-sheet_markers 12
-sheet_center 0,0
-sheet_direction 0,1
-sheet_ke 1e3
-sheet_excess_mass 1e5
-sheet_hold middle
-contact none
-time_step 0.01
-time_end 4
""".split()


CELL = 1 / 6
WALL_MODEL = ("-cloth_wall_model", "equilibrium", "-sheet_direction", "0.5,1")  # its edges are held, and slide
SWAPPED = ("-grid_cells", "36,48", "-grid_upper", "3,5", "-bc_x_lower", "slip", "-bc_x_lower_velocity", "0,0", "-bc_x_upper", "slip",
           "-bc_y_lower", "inflow", "-bc_y_lower_velocity", "0,1", "-bc_y_upper", "outflow", "-fluid_initial_velocity", "0,1",
           "-sheet_direction", "1,0")


class ClothLimits(ProgramTest):
    def history(self, folder, *options, ranks=1):
        self.run_well(ranks, *STREAM, *options, "-output_dir", folder)
        return read_columns(self.folder / folder / "history.csv")

    def test_load(self):
        drag = {}
        for name, options in {"central": (), "upwind": ("-advection", "upwind"), "beside cloth": ("-cloth_limits_advection",)}.items():
            history = self.history(name.split()[0], *options, "-sheet_markers", 8)
            drag[name] = 2 * history["sheet_water_force_x"][history["time"] > 3].mean()
            print(f"{name}: {drag[name]:.3f}")
        self.assertGreater(drag["beside cloth"], 3 * drag["central"])
        self.assertGreater(drag["beside cloth"], 0.6 * drag["upwind"])
        self.assertGreater(history["numerical_dissipation"][-1], 0)

    def test_places_of_a_permeable_sheet(self):
        drag = {}
        for name, axis, options in (("as_it_is", "x", ()), ("along", "x", ("-sheet_center", f"{CELL / 2},0")),
                                    ("across", "x", ("-sheet_center", f"0,{CELL / 2}")), ("step", "x", ("-time_step", 5e-3)),
                                    ("markers", "x", ("-sheet_markers", 6)), ("swapped", "y", SWAPPED)):
            history = self.history(name, *options, "-sheet_permeance", 2.5)
            drag[name] = 2 * history[f"sheet_water_force_{axis}"][history["time"] > 3].mean()
        print(" ".join(f"{name} {value:.4f}" for name, value in drag.items()))
        for name, value in drag.items():
            with self.subTest(name):
                self.assertLess(abs(value / drag["as_it_is"] - 1), 1e-5 if name == "swapped" else 5e-3)

    def test_ranks(self):
        exact = ("-time_end", 0.1, "-coupling_tolerance", 1e-11, "-pressure_tolerance", 1e-10, "-momentum_tolerance", 1e-11)
        # along a sheet that slides, the force on a single row may be small: it agrees to a part of the largest
        for options, near in ((("-cloth_limits_advection", "-sheet_permeance", 0.3), {"rtol": 1e-6}), (WALL_MODEL, {"rtol": 0, "atol": 2e-5})):
            with self.subTest(options[0]):
                one, two = (self.history(f"on{ranks}", *exact, *options, ranks=ranks)["sheet_water_force_x"] for ranks in (1, 2))
                np.testing.assert_allclose(two, one, **near)

    def test_restart(self):
        self.assert_restart_goes_on(self.results, ("-cloth_limits_advection",), 0.1, 0.2)

    def test_restart_with_a_wall_model(self):
        self.assert_restart_goes_on(self.results, WALL_MODEL, 0.1, 0.2)

    def results(self, folder, *options, ranks):
        history = self.history(folder, *options, ranks=ranks)
        return {name: history[name][-3:] for name in ("time", "sheet_water_force_x", "kinetic_energy")}


if __name__ == "__main__":
    unittest.main()
