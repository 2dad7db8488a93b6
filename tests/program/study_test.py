# SPDX-License-Identifier: BSD-3-Clause
"""scripts/study runs a list of cases, some at a time, goes on after an interruption, and lists what has not been run."""

import csv
import os
import pathlib
import signal
import subprocess
import time
import unittest

import numpy as np

from support import PROGRAM, SOURCE, ProgramTest, read_columns, read_options

STUDY = SOURCE / "scripts" / "study"
# Short strokes of a slow agitator among few cloths: two cycles after the first take a second.
CYCLES = f"""-options_file {SOURCE / 'inputs' / 'wash.opts'}
-grid_cells 12,12,12
-towel_count 4
-towel_markers 4
-agitator_frequency 10
-agitator_angular_speed {{}}
-time_step 5e-3
-time_end 0.3
"""
CASE = f"-options_file {SOURCE / 'inputs' / 'sheet.opts'}\n-fluid_viscosity {{}}\n-time_end 0.5\n-time_cfl 0\n-time_step 2e-3\n"


class Study(ProgramTest):
    def setUp(self):
        super().setUp()
        self.cases = []
        for name, viscosity in (("thick", 4), ("thin", 2), ("thinner", 1)):
            self.cases.append(self.folder / f"{name}.opts")
            self.cases[-1].write_text(CASE.format(viscosity))
        self.command = [STUDY, "--program", PROGRAM, "--output", self.folder / "study", "--jobs", "1", "--ranks", "2",
                        *self.cases]
        self.environment = dict(os.environ, OMPI_MCA_mpi_yield_when_idle="1", OMPI_MCA_rmaps_base_oversubscribe="1")

    def table(self):
        """Returns the rows of the study's table by case."""
        with open(self.folder / "study" / "study.csv", encoding="utf-8") as file:
            return {row["case"]: row for row in csv.DictReader(file)}

    def steps_of(self, case):
        """Returns how far a case has come."""
        history = self.folder / "study" / case / "history.csv"
        return len(history.read_text().splitlines()) - 2 if history.is_file() else 0

    def interrupt(self, *cases):
        """Runs the study and interrupts it when these cases have come some way."""
        study = subprocess.Popen(self.command, env=self.environment, stdout=subprocess.DEVNULL)
        for _ in range(1200):
            if min(map(self.steps_of, cases)) > 40 or study.poll() is not None:
                break
            time.sleep(0.05)
        study.send_signal(signal.SIGTERM)
        self.assertEqual(study.wait(timeout=60), 130)

    def go_on(self):
        """Runs the study to its end; returns what it prints."""
        return subprocess.run(self.command, env=self.environment, stdout=subprocess.PIPE, text=True, check=True,
                              timeout=240).stdout

    def test_interrupted_study_goes_on_where_it_was(self):
        self.interrupt("thin")
        rows = self.table()
        self.assertEqual([rows[case]["status"] for case in ("thick", "thin", "thinner")],
                         ["finished", "stopped", "not run"])
        before = pathlib.Path(self.folder / "study" / "thick" / "summary.json").stat().st_mtime
        self.go_on()
        rows = self.table()
        self.assertEqual({row["status"] for row in rows.values()}, {"finished"})
        self.assertEqual(before, pathlib.Path(self.folder / "study" / "thick" / "summary.json").stat().st_mtime)
        steps = read_columns(self.folder / "study" / "thin" / "history.csv")["step"]
        self.assertEqual(list(steps), list(range(1, 251)))
        self.assertGreater(float(rows["thin"]["stress_ss_mean_MPa"]), 0)

    def test_cases_run_at_the_same_time_and_stop_together(self):
        self.command = [STUDY, "--program", PROGRAM, "--output", self.folder / "study", "--jobs", "2", *self.cases]
        self.interrupt("thick", "thin")
        self.assertEqual([row["status"] for row in self.table().values()], ["stopped", "stopped", "not run"])
        for case in ("thick", "thin"):
            self.assertTrue((self.folder / "study" / case / "checkpoint.h5").is_file())
        self.go_on()
        self.assertEqual({row["status"] for row in self.table().values()}, {"finished"})
        for case in ("thick", "thin"):
            steps = read_columns(self.folder / "study" / case / "history.csv")["step"]
            self.assertEqual(list(steps), list(range(1, 251)))

    def test_a_case_that_fails_does_not_end_the_study(self):
        self.cases[1].write_text("-options_file none.opts\n-fluid_viscosity -1\n-grid_cells 8,8\n-time_end 1\n")
        self.cases[2].write_text("-grid_cells 16,16\n-fluid_viscosity -1\n-time_end 1\n")
        outcome = subprocess.run([*self.command, "--", "-time_end", "0.01"], env=self.environment, capture_output=True,
                                 text=True, check=False, timeout=120)
        self.assertEqual(outcome.returncode, 1)
        self.assertIn("study: thinner failed: washfsi: -fluid_viscosity -1: must be a number >= 0", outcome.stdout)
        self.assertEqual([row["status"] for row in self.table().values()], ["finished", "unfinished", "unfinished"])

    def test_a_case_that_has_changed_since_is_told(self):
        command = [*self.command[:-3], self.cases[0], "--", "-time_end", "0.01"]
        told = "thick was run with other options than it has now"
        for viscosity, changed in ((4, False), (4, False), (5, True)):
            self.cases[0].write_text("# a comment\n" + CASE.format(viscosity))
            printed = subprocess.run(command, env=self.environment, capture_output=True, text=True, check=True,
                                     timeout=120).stdout
            self.assertEqual(told in printed, changed, printed)
        self.assertIn(told, (self.folder / "study" / "study.md").read_text(encoding="utf-8"))

    def test_seeds_place_the_cloths_anew_and_give_the_spread(self):
        cases = [self.folder / f"{name}.opts" for name in ("slow", "fast")]
        for case, speed in zip(cases, (2, 6)):
            case.write_text(CYCLES.format(speed))
        self.command = [STUDY, "--program", PROGRAM, "--output", self.folder / "study", "--seeds", "2", *cases]
        printed = self.go_on()
        self.assertEqual(self.go_on().count("has finished before"), 4)
        folders = [self.folder / "study" / "slow" / f"seed_{seed}" for seed in (1, 2)]
        seeds = [read_options(folder / "resolved.opts")["-towel_seed"] for folder in folders]
        self.assertEqual(seeds, ["1", "2"])
        starts = [read_columns(folder / "tracks.csv")["towel_0_x"][0] for folder in folders]
        self.assertNotEqual(*starts)
        self.assertEqual([row["seeds"] for row in self.table().values()], ["2", "2"])
        self.check_figures(folders, printed)

    def check_figures(self, folders, printed):
        """Holds the table against cycles.csv."""
        if not (folders[0] / "cycles.csv").is_file():
            self.skipTest("this program writes no cycles.csv")
        works = [cycles["agitator_work"][cycles["start_up"] == 0].mean()
                 for cycles in (read_columns(folder / "cycles.csv") for folder in folders)]
        row = self.table()["slow"]
        self.assertAlmostEqual(float(row["agitator_work [J]"]), np.mean(works), delta=1e-4 * abs(np.mean(works)))
        self.assertAlmostEqual(float(row["agitator_work spread [J]"]), np.std(works, ddof=1),
                               delta=1e-4 * abs(np.mean(works)))
        for figure in ("relative_speed [m/s]", "water_shear [Pa]", "stress [Pa]", "turns [-]"):
            self.assertIn(figure, row)
        self.assertRegex(printed, r"Work of the bodies in a cycle: slow \(.* J\) and fast \(.* J\)")
        self.assertTrue((self.folder / "study" / "study.png").is_file())

    def test_table_alone_runs_nothing(self):
        subprocess.run([*self.command, "--table"], env=self.environment, stdout=subprocess.DEVNULL, check=True)
        self.assertEqual({row["status"] for row in self.table().values()}, {"not run"})


if __name__ == "__main__":
    unittest.main()
