# SPDX-License-Identifier: BSD-3-Clause
"""The washing machine of inputs/thesis/wash33.opts: balances, ranks, restart. `wash_test.py full` takes its own grid and a tenth
of a cycle, and a whole cycle for the balances; else a coarse grid and short times."""

import pathlib
import sys
import unittest

import numpy as np

from support import SOURCE, TIGHT, ProgramTest, read_columns, relative_difference, run

FULL = "full" in sys.argv
CASE = ["-options_file", SOURCE / "inputs" / "thesis" / "wash33.opts", *([] if FULL else ["-grid_cells", "17,17,17"])]
SHORT, LONG = (0.157, 1.571) if FULL else (0.05, 0.4)  # [s]
CYCLE = ["-time_end", LONG, "-output_interval", LONG]
NOT_PHYSICAL = {"step", "dt", "max_divergence"}
OPEN_ENERGY = 0.01 if FULL else 0.02  # of the work
OPEN_TORQUE = 0.005 if FULL else 0.05  # rms, of the agitator's amplitude
AVERAGED = 0.02  # [s]


class Wash(ProgramTest):
    def history(self, folder, ranks, *options):
        """Runs the machine; returns the columns of its history."""
        outcome = run(ranks, *CASE, *options, "-output_dir", folder, folder=self.folder, seconds=1800)
        self.assertEqual(outcome.returncode, 0, outcome.stdout + outcome.stderr)
        return read_columns(pathlib.Path(self.folder) / folder / "history.csv")

    def test_is_the_same_on_one_two_and_four_ranks(self):
        options = [*TIGHT, "-coupling_tolerance", 1e-11, "-time_end", SHORT]
        expected = self.history("on_1", 1, *options)
        for ranks in (2, 4):
            history = self.history(f"on_{ranks}", ranks, *options)
            for name in expected.keys() - NOT_PHYSICAL:
                with self.subTest(ranks=ranks, column=name):
                    self.assertLess(relative_difference(history[name], expected[name]), 1e-6)

    def test_restart_in_the_middle_equals_the_uninterrupted_run(self):
        straight = self.history("straight", 2, "-time_end", SHORT)
        self.history("half", 2, "-time_end", 0.5 * SHORT)
        restarted = self.history("half", 2, "-time_end", SHORT, "-restart", "half/checkpoint.h5")
        for name, values in straight.items():
            with self.subTest(column=name):
                np.testing.assert_array_equal(restarted[name], values)

    def test_energy_and_angular_momentum_are_balanced(self):
        history = self.history("cycle", 2, *CYCLE)
        dt = history["dt"]
        work = np.sum(dt * (history["agitator_power"] + history["drum_power"]))
        # friction of cloth is in cloth_dissipation
        lost = np.sum(dt * sum(history[name] for name in ("dissipation", "mask_dissipation", "numerical_dissipation", "cloth_dissipation")))
        kept = history["kinetic_energy"][-1] + history["towel_elastic_energy"][-1]
        print(f"work {work:.4g} J, lost {lost:.4g} J, kept {kept:.4g} J: open {100 * (1 - (lost + kept) / work):.2f} %")
        self.assertLess(abs(work - lost - kept), OPEN_ENERGY * work)
        torque = sum(history[f"{name}_torque_z"] for name in ("agitator", "drum", "wall_z_lower"))
        open_torque = np.diff(history["angular_momentum"]) / dt[1:] + torque[1:]
        time, impulse = history["time"][1:], np.cumsum(open_torque * dt[1:])  # steps differ in length
        averaged = (np.interp(time + AVERAGED, time, impulse) - impulse)[time + AVERAGED < time[-1]] / AVERAGED
        amplitude = np.abs(history["agitator_torque_z"]).max()
        print(f"dL/dt + T, averaged over {AVERAGED} s: rms {100 * np.sqrt(np.mean(averaged ** 2)) / amplitude:.2f} %,"
              f" max {100 * np.abs(averaged).max() / amplitude:.2f} % of the agitator's amplitude {amplitude:.3g} N m")
        self.assertLess(np.sqrt(np.mean(averaged ** 2)), OPEN_TORQUE * amplitude)
        self.assertLess(history["towel_max_stretch"][-1], 0.05)


if __name__ == "__main__":
    unittest.main(argv=[word for word in sys.argv if word != "full"])
