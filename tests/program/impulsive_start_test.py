# SPDX-License-Identifier: BSD-3-Clause
"""Water that meets walls or cloth at once flows faster than it did: the first step must be as short as its own CFL number wants, and
trying it must leave no trace."""

import json
import unittest

import numpy as np
from support import SOURCE, ProgramTest, read_columns

COURANT = 0.4
TUNNEL = ["-grid_cells", "72,24", "-grid_upper", "3,1", "-bc_x_lower", "inflow", "-bc_x_lower_velocity", "1,0", "-bc_x_lower_profile",
          "parabolic", "-bc_x_upper", "outflow", "-fluid_density", 1, "-fluid_viscosity", 0.01, "-fluid_initial", "uniform",
          "-fluid_initial_velocity", "0.6,0", "-output_interval", 100]
FLAP = [*TUNNEL, "-cloths", "fl", "-fl_size", 0.5, "-fl_markers", 11, "-fl_ke", 1e3, "-fl_kb", 0.05, "-fl_excess_mass", 0.1, "-fl_center",
        "1,0.28", "-fl_direction", "0,1", "-fl_hold", "edge", "-contact", "none", "-coupling_order", 1]
GATE = [*TUNNEL, "-bodies", "gate", "-body_method", "mapping", "-gate_shape", "box", "-gate_size", "0.1,0.8", "-gate_center", "1,0.5"]
BOX = ["-grid_cells", "24,12,12", "-grid_upper", "2,1,1", "-bc_x_lower", "periodic", "-bc_x_upper", "periodic", "-fluid_density", 1,
       "-fluid_viscosity", 0.02, "-fluid_initial", "uniform", "-fluid_initial_velocity", "1,0,0", "-output_interval", 100]
SHEET = [*BOX, "-cloths", "sail", "-sail_size", "0.8,0.8", "-sail_markers", "9,9", "-sail_ke", 1e3, "-sail_kb", 1e-3, "-sail_excess_mass",
         0.1, "-sail_center", "1,0.5,0.5", "-sail_direction", "0,1,0", "-sail_across", "0,0,1", "-sail_hold", "corners", "-contact", "none",
         "-coupling_order", 1]
BLOCK = [*BOX, "-bodies", "block", "-body_method", "mapping", "-block_shape", "box", "-block_size", "0.3,0.8,0.8", "-block_center",
         "1,0.5,0.5"]
PLUNGE = ["-grid_cells", "32,32", "-grid_upper", "1,1", "-fluid_density", 1, "-fluid_viscosity", 0.01, "-bodies", "ram", "-body_method",
          "mapping", "-ram_shape", "box", "-ram_size", "0.7,0.2", "-ram_center", "0.5,0.3", "-ram_velocity", "0,1", "-output_interval", 100]
MACHINE = ["-options_file", SOURCE / "inputs" / "wash.opts", "-grid_cells", "16,16,8", "-towel_count", 2, "-towel_markers", 4,
           "-agitator_frequency", 0, "-time_tolerance", 0, "-output_interval", 100]


class ImpulsiveStart(ProgramTest):
    def history(self, *options, ranks=1, folder="out"):
        self.run_well(ranks, *options, "-output_dir", folder)
        return read_columns(self.folder / folder / "history.csv")

    def test_the_first_step_obeys_its_own_number(self):
        cases = {"flap": FLAP, "flap implicit": [*FLAP, "-coupling_scheme", "implicit"],
                 "flap by tolerance": [*FLAP, "-time_tolerance", 0.01],
                 "gate": GATE, "gate of markers": [*GATE, "-body_method", "direct_forcing"], "gate cut": [*GATE, "-body_method", "cut_stencil"],
                 "sail": SHEET, "block": BLOCK, "block of markers": [*BLOCK, "-body_method", "direct_forcing"],
                 "ram": PLUNGE, "ram of markers": [*PLUNGE, "-body_method", "direct_forcing"]}
        for name, case in cases.items():
            with self.subTest(case=name):
                history = self.history(*case, "-time_cfl", COURANT, "-max_steps", 12, "-time_end", 1)
                self.assertLessEqual(history["cfl"][0], 1.02 * COURANT)
                self.assertLess(history["cfl"].max(), 1.5 * COURANT)

    def test_steps_of_equal_length_are_chosen_by_it_too(self):
        history = self.history(*FLAP, "-max_steps", 12, "-time_end", 1)
        self.assertEqual(np.ptp(np.diff(history["time"])) < 1e-12, True)
        self.assertLess(history["cfl"].max(), 0.8)

    def test_a_trial_leaves_no_trace(self):
        """A run that is given the step that another found has the same first steps, to the bit; so has one on other ranks, nearly."""
        for name, case in (("flap", FLAP), ("gate", [*GATE, "-body_method", "direct_forcing"]), ("sail", SHEET), ("machine", MACHINE)):
            with self.subTest(case=name):
                found = self.history(*case, "-time_cfl", COURANT, "-max_steps", 1, "-time_end", 1, "-cycle_time", 1)
                given = self.history(*case, "-time_step", repr(float(found["dt"][0])), "-time_cfl", 0, "-max_steps", 1, "-time_end", 1,
                                     "-cycle_time", 1, folder="given")
                for column, values in found.items():
                    np.testing.assert_array_equal(given[column], values, column)
                for key in ("iterations", "bodies", "cloths"):
                    one, other = (json.loads((self.folder / folder / "summary.json").read_text(encoding="utf-8")).get(key)
                                  for folder in ("out", "given"))
                    self.assertEqual(one, other)

    def test_the_flap_goes_on(self):
        history = self.history(*FLAP, "-time_cfl", COURANT, "-time_end", 2, "-history_interval", 0.05, ranks=2)
        self.assertAlmostEqual(history["time"][-1], 2, delta=0.02)
        self.assertLess(history["cfl"].max(), 1.5 * COURANT)


if __name__ == "__main__":
    unittest.main()
