# SPDX-License-Identifier: BSD-3-Clause
"""A run that is told to stop finishes its step and leaves a checkpoint from which another goes on."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import time
import unittest

import h5py
import numpy as np

from support import EXPLICIT_WASH, PATIENCE, PROGRAM, ProgramTest, command, read_columns

LONG = [*EXPLICIT_WASH, "-time_end", 100, "-output_dir", "out"]
SECONDS = 60 * PATIENCE  # [s]


def processes_of_program(launcher):
    """Returns the process numbers of the program's ranks that mpirun has started."""
    threads = pathlib.Path(f"/proc/{launcher.pid}/task").iterdir()
    children = [pid for thread in threads for pid in (thread / "children").read_text().split()]
    return [int(pid) for pid in children if os.path.realpath(f"/proc/{pid}/exe") == str(PROGRAM.resolve())]


class Signals(ProgramTest):
    def start_long_run(self):
        """Starts a run that would take hours."""
        launcher = subprocess.Popen(command(2, *LONG), cwd=self.folder, text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(launcher.wait)
        self.addCleanup(launcher.terminate)  # cleanups run last in, first out
        return launcher

    def wait_for_steps(self):
        """Waits until the run has written some steps."""
        history, end = self.folder / "out" / "history.csv", time.monotonic() + SECONDS
        while not history.exists() or len(history.read_text().splitlines()) < 20:
            self.assertLess(time.monotonic(), end, "the run did not start")
            time.sleep(0.05)

    def assert_stopped(self):
        """Checks that summary, history and checkpoint tell of the same step; returns it."""
        summary = json.loads((self.folder / "out" / "summary.json").read_text())
        self.assertEqual(summary["status"], "stopped")
        self.assertEqual(read_columns(self.folder / "out" / "history.csv")["step"][-1], summary["steps"])
        with h5py.File(self.folder / "out" / "checkpoint.h5") as checkpoint:
            self.assertEqual(checkpoint.attrs["step"], summary["steps"])
        return summary["steps"]

    def assert_stops_well_after(self, number, rank):
        """Sends a signal to one rank of a long run, then restarts the run for five steps."""
        launcher = self.start_long_run()
        self.wait_for_steps()
        ranks = processes_of_program(launcher)
        self.assertEqual(len(ranks), 2)
        os.kill(ranks[rank], number)
        output, errors = launcher.communicate(timeout=SECONDS)
        self.assertEqual((launcher.returncode, errors), (0, ""), output)
        step = self.assert_stopped()

        self.run_well(2, *LONG, "-restart", "out/checkpoint.h5", "-max_steps", 5)
        steps = read_columns(self.folder / "out" / "history.csv")["step"]
        np.testing.assert_array_equal(steps, np.arange(1, step + 6))

    def test_stops_after_sigterm_to_the_last_rank(self):
        self.assert_stops_well_after(signal.SIGTERM, rank=-1)

    def test_stops_after_sigint_to_the_first_rank(self):
        self.assert_stops_well_after(signal.SIGINT, rank=0)

    def test_finishes_after_other_signals(self):
        for number in (signal.SIGHUP, signal.SIGQUIT, signal.SIGXCPU, signal.SIGUSR1):
            with self.subTest(number):
                self.assert_stops_well_after(number, rank=0)
                shutil.rmtree(self.folder / "out")


if __name__ == "__main__":
    unittest.main()
