# SPDX-License-Identifier: BSD-3-Clause
"""scripts/study runs a list of cases, goes on after an interruption, and lists what has not been run."""

import csv
import os
import pathlib
import signal
import subprocess
import time
import unittest

from support import PROGRAM, SOURCE, ProgramTest, read_columns

STUDY = SOURCE / "scripts" / "study"
CASE = f"-options_file {SOURCE / 'inputs' / 'sheet.opts'}\n-fluid_viscosity {{}}\n-time_end 0.5\n-time_cfl 0\n-time_step 2e-3\n"


class Study(ProgramTest):
    def setUp(self):
        super().setUp()
        self.cases = []
        for name, viscosity in (("thick", 4), ("thin", 2), ("thinner", 1)):
            self.cases.append(self.folder / f"{name}.opts")
            self.cases[-1].write_text(CASE.format(viscosity))
        self.command = [STUDY, "--program", PROGRAM, "--output", self.folder / "study", *self.cases]
        self.environment = dict(os.environ, OMPI_MCA_mpi_yield_when_idle="1", OMPI_MCA_rmaps_base_oversubscribe="1")

    def table(self):
        """Returns the rows of the study's table by case."""
        with open(self.folder / "study" / "study.csv", encoding="utf-8") as file:
            return {row["case"]: row for row in csv.DictReader(file)}

    def steps_of(self, case):
        """Returns how far a case has come."""
        history = self.folder / "study" / case / "history.csv"
        return len(history.read_text().splitlines()) - 2 if history.is_file() else 0

    def test_interrupted_study_goes_on_where_it_was(self):
        study = subprocess.Popen(self.command, env=self.environment, stdout=subprocess.DEVNULL)
        for _ in range(1200):
            if self.steps_of("thin") > 40 or study.poll() is not None:
                break
            time.sleep(0.05)
        study.send_signal(signal.SIGTERM)
        self.assertEqual(study.wait(timeout=60), 130)
        rows = self.table()
        self.assertEqual([rows[case]["status"] for case in ("thick", "thin", "thinner")],
                         ["finished", "stopped", "not run"])
        before = pathlib.Path(self.folder / "study" / "thick" / "summary.json").stat().st_mtime
        subprocess.run(self.command, env=self.environment, stdout=subprocess.DEVNULL, check=True, timeout=120)
        rows = self.table()
        self.assertEqual({row["status"] for row in rows.values()}, {"finished"})
        self.assertEqual(before, pathlib.Path(self.folder / "study" / "thick" / "summary.json").stat().st_mtime)
        steps = read_columns(self.folder / "study" / "thin" / "history.csv")["step"]
        self.assertEqual(list(steps), list(range(1, 251)))
        self.assertGreater(float(rows["thin"]["stress_ss_mean_MPa"]), 0)

    def test_table_alone_runs_nothing(self):
        subprocess.run([*self.command, "--table"], env=self.environment, stdout=subprocess.DEVNULL, check=True)
        self.assertEqual({row["status"] for row in self.table().values()}, {"not run"})


if __name__ == "__main__":
    unittest.main()
