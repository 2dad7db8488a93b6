# SPDX-License-Identifier: BSD-3-Clause
"""A long run that is killed at random and restarted again and again: it ends as one that was left alone, to the bit, and
takes no more memory at its end than at its start.

    soak_test.py           two cycles of the agitation
    soak_test.py full      fifty
"""

import filecmp
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import time
import unittest

import numpy as np

from support import PATIENCE, PROGRAM, SOURCE, ProgramTest, alone, read_columns

FULL = "full" in sys.argv
CYCLES = 50 if FULL else 0.5
STRIDE = 1000 if FULL else 100  # steps, at most between kills
PERIOD = np.pi / 2  # of the agitator [s]
CASE = ["-options_file", SOURCE / "inputs" / "thesis" / "wash33.opts", "-grid_cells", "12,12,12", "-towel_count", 4, "-time_step", 4e-3,
        "-time_end", CYCLES * PERIOD, "-output_interval", PERIOD / 2, "-checkpoint_interval", PERIOD / 8]
KILLED = -signal.SIGKILL


def last_step(out):
    """Returns the step of the last whole row of a history, 0 if there is none."""
    try:
        with open(out / "history.csv", "rb") as file:
            file.seek(-min(file.seek(0, os.SEEK_END), 8000), os.SEEK_END)
            whole = file.read().split(b"\n")[-2]
    except (OSError, IndexError):
        return 0
    return int(whole.split(b",")[0]) if whole[:1].isdigit() else 0


class Soak(ProgramTest):
    def start(self, out):
        """Starts the program into a folder, from its checkpoint if it has one."""
        checkpoint = out / "checkpoint.h5"
        restart = ["-restart", checkpoint] if checkpoint.exists() else []
        return subprocess.Popen([PROGRAM, *map(str, [*CASE, "-output_dir", out, *restart])], cwd=self.folder, env=alone(self.folder),
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def assert_ended_well(self, program):
        """Checks that a run ended with status 0 and nothing to complain of."""
        _, errors = program.communicate(timeout=7200 * PATIENCE)
        self.assertEqual((program.returncode, errors), (0, ""))

    def run_alone(self, out):
        """Runs without a disturbance; returns its resident memory [kB], taken each tenth of a second."""
        program, memory = self.start(out), []
        while program.poll() is None:
            found = re.search(r"VmRSS:\s*(\d+)", pathlib.Path(f"/proc/{program.pid}/status").read_text())
            if found:
                memory.append(int(found[1]))
            time.sleep(0.1)
        self.assert_ended_well(program)
        return np.array(memory)

    def wait_for_step(self, program, out, step):
        """Waits until a run has written the row of a step, or has ended."""
        while program.poll() is None and last_step(out) < step:
            time.sleep(0.02)

    def run_with_kills(self, out):
        """Runs to the end in spite of kills at random steps, a third of them while it starts; returns their number."""
        draw, kills = random.Random(1), 0
        while True:
            step = last_step(out) + draw.uniform(0, STRIDE)
            program = self.start(out)
            if draw.random() < 1 / 3:
                time.sleep(draw.uniform(0, 0.5))
            else:
                self.wait_for_step(program, out, step)
            program.kill()
            if program.wait() != KILLED:
                self.assert_ended_well(program)
                return kills
            kills += 1
            program.stderr.close()

    def assert_flat(self, memory):
        """Compares the memory at the end with that after a tenth of the run."""
        early, late = (memory[int(share * len(memory)):][:max(len(memory) // 20, 1)].mean() for share in (0.1, 0.94))
        print(f"memory {early / 1e3:.1f} MB after a tenth of the run, {late / 1e3:.1f} MB at its end")
        self.assertLess(late, 1.02 * early)

    def assert_no_drift(self, history):
        """Compares means over the third and the fourth quarter of the cycles with the spread of the cycles' means."""
        cycle = np.floor(history["time"] / PERIOD * (1 - 1e-9))
        for name in ("kinetic_energy", "towel_elastic_energy", "agitator_power"):
            means = np.array([history[name][cycle == number].mean() for number in range(CYCLES // 2, CYCLES)])
            third, fourth = np.array_split(means, 2)
            error = np.sqrt(third.var(ddof=1) / len(third) + fourth.var(ddof=1) / len(fourth))
            print(f"{name}: {third.mean():.4g} and {fourth.mean():.4g}, standard error of their difference {error:.2g}")
            self.assertLess(abs(fourth.mean() - third.mean()), 4 * error, name)
        print(f"largest stretch {100 * history['towel_max_stretch'].max():.2f} %, divergence {history['max_divergence'].max():.1e}")

    def test_kills_do_not_matter(self):
        alone, killed = self.folder / "alone", self.folder / "killed"
        memory = self.run_alone(alone)
        kills = self.run_with_kills(killed)
        print(f"{CYCLES} cycles, {kills} kills")
        self.assertGreater(kills, 2)
        for name in ("history.csv", "tracks.csv", "cloth_final.csv", "flow.xdmf"):
            self.assertTrue(filecmp.cmp(alone / name, killed / name, shallow=False), name)
        frames = sorted(path.relative_to(alone) for path in alone.glob("*/0*.h5"))
        self.assertEqual(frames, sorted(path.relative_to(killed) for path in killed.glob("*/0*.h5")))
        for name in ("checkpoint.h5", *frames):
            outcome = subprocess.run(["h5diff", *(["--exclude-path=/options"] if name == "checkpoint.h5" else []),
                                      alone / name, killed / name], capture_output=True, text=True, check=False)
            self.assertEqual((outcome.returncode, outcome.stdout), (0, ""), name)
        if FULL:
            self.assert_flat(memory)
            self.assert_no_drift(read_columns(alone / "history.csv"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
