# SPDX-License-Identifier: BSD-3-Clause
"""What is told of each cycle is what the history has of it, and a restart in the middle of a cycle changes nothing."""

import json
import shutil
import unittest

import h5py
import numpy as np

from support import SOURCE, ProgramTest, read_columns, read_table

WASH = ["-options_file", SOURCE / "inputs" / "wash.opts", "-grid_cells", "12,12,12", "-towel_markers", 4,
        "-time_step", 4e-3, "-cycle_time", 0.02]
CYCLE, END, PAUSE = 0.02, 0.084, 0.048  # [s]
PLATE = ["-options_file", SOURCE / "inputs" / "falling_plate.opts", "-cycle_time", 0.1, "-max_steps", 1]
KEPT_OR_LOST = ("kinetic_energy_change", "towel_elastic_energy_change", "dissipated", "mask_dissipated", "advection_dissipated",
                "cloth_dissipated")


class Cycles(ProgramTest):
    def read(self, folder):
        return read_columns(folder / "history.csv"), read_columns(folder / "cycles.csv")

    def assert_close(self, value, expected):
        np.testing.assert_allclose(value, expected, rtol=1e-10, atol=1e-14)

    def check_cycle(self, history, cycles, n):
        """Compares one row of cycles.csv with sums over rows of the history."""
        dt, time = history["dt"], history["time"]
        middle = time - 0.5 * dt
        rows = (middle >= n * CYCLE) & (middle < (n + 1) * CYCLE) & (time > 0)
        first, last = np.flatnonzero(rows)[[0, -1]]

        def mean(values):
            return (values * dt)[rows].sum() / dt[rows].sum()

        power, torque = history["agitator_power"], history["agitator_torque_z"]
        expected = {
            "cycle": n + 1, "start_up": n == 0, "start": time[first] - dt[first], "end": time[last],
            "agitator_work": (power * dt)[rows].sum(), "agitator_power_mean": mean(power),
            "agitator_power_rms": np.sqrt(mean(power**2)), "agitator_torque_peak": np.abs(torque[rows]).max(),
            "agitator_torque_mean": mean(torque), "dissipated": (history["dissipation"] * dt)[rows].sum(),
            "mask_dissipated": (history["mask_dissipation"] * dt)[rows].sum(),
            "cloth_dissipated": (history["cloth_dissipation"] * dt)[rows].sum(),
            "cfl": history["cfl"][rows].max(), "towel_relative_speed": mean(history["towel_relative_speed_mean"]),
            "towel_water_shear": mean(history["towel_water_shear_mean"]), "towel_stress": mean(history["towel_stress_mean"]),
            "towel_depth": history["towel_depth"][rows].max()}
        if first > 0:  # the history has no row of the start
            for name, column in (("kinetic_energy_change", "kinetic_energy"), ("towel_turns", "towel_tumbles"),
                                 ("towel_path", "towel_path"), ("towel_elastic_energy_change", "towel_elastic_energy")):
                expected[name] = history[column][last] - history[column][first - 1]
        for name, value in expected.items():
            with self.subTest(cycle=n + 1, figure=name):
                self.assert_close(cycles[name][n], value)

    def test_rows_are_sums_over_the_history(self):
        self.run_well(2, *WASH, "-time_end", END, "-output_dir", self.folder / "run")
        history, cycles = self.read(self.folder / "run")
        self.assertEqual(list(cycles["cycle"]), [1, 2, 3, 4])
        for n in range(4):
            self.check_cycle(history, cycles, n)
        self.assert_close(cycles["energy_open"], cycles["agitator_work"] - sum(cycles[name] for name in KEPT_OR_LOST))
        self.check_summary(cycles)
        self.check_checkpoints()
        self.check_restart()

    def check_summary(self, cycles):
        """Compares the means over cycles with the table."""
        summary = json.loads((self.folder / "run" / "summary.json").read_text())["cycles"]
        self.assertEqual((summary["time"], summary["complete"], summary["first"]), (CYCLE, 4, 2))
        names, units, _ = read_table(self.folder / "run" / "cycles.csv")
        self.assertEqual(list(summary["figures"]), names[4:])
        for name, unit in zip(names[4:], units[4:]):
            figure = summary["figures"][name]
            self.assertEqual(figure["unit"], unit)
            self.assert_close(figure["mean"], cycles[name][1:].mean())
            self.assert_close(figure["std"], cycles[name][1:].std(ddof=1))

    def check_checkpoints(self):
        """The one before the last is of an earlier step, though the last was due when the run ended."""
        steps = []
        for name in ("checkpoint_before.h5", "checkpoint.h5"):
            with h5py.File(self.folder / "run" / name) as file:
                steps.append(file.attrs["step"])
        self.assertEqual(steps[1], 21)
        self.assertLess(steps[0], 21)

    def check_restart(self):
        """Goes on from the middle of the third cycle: the table, its means and the history are the same to the bit."""
        whole, parts = self.folder / "run", self.folder / "parts"
        self.run_well(2, *WASH, "-time_end", PAUSE, "-output_dir", parts)
        self.assertEqual(len(read_columns(parts / "cycles.csv")["cycle"]), 2)
        self.run_well(2, *WASH, "-time_end", END, "-output_dir", parts, "-restart", parts / "checkpoint.h5")
        for name in ("cycles.csv", "history.csv"):
            self.assertEqual((parts / name).read_bytes(), (whole / name).read_bytes(), name)
        figures = [json.loads((folder / "summary.json").read_text())["cycles"] for folder in (whole, parts)]
        self.assertEqual(*figures)
        # another length of cycles is another table, which begins with the next whole cycle
        other = self.folder / "other"
        shutil.copytree(parts, other)
        self.run_well(1, *WASH, "-time_end", 0.108, "-cycle_time", 0.01, "-output_dir", other,
                      "-restart", other / "checkpoint.h5")
        self.assertEqual(list(read_columns(other / "cycles.csv")["cycle"][-1:]), [10])

    def test_weight_puts_energy_in(self):
        self.run_well(1, *PLATE, "-output_dir", "run")
        for file, column in (("history.csv", "load_power"), ("cycles.csv", "load_work")):
            self.assertIn(column, (self.folder / "run" / file).read_text().splitlines()[0].split(","))

    def test_without_a_period_there_is_no_table(self):
        self.run_well(1, "-options_file", SOURCE / "inputs" / "cavity.opts", "-grid_cells", "16,16", "-max_steps", 1)
        self.assertFalse((self.folder / "out" / "cycles.csv").exists())


if __name__ == "__main__":
    unittest.main()
