# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the program share: running it as a user would, and reading what it leaves behind.

ctest sets the environment: WASHFSI_PROGRAM is the program, WASHFSI_SOURCE the root of the sources, WASHFSI_PATIENCE how many
times longer than usual a run may take (with the sanitizers).
"""

import os
import pathlib
import subprocess
import tempfile
import time
import unittest

import numpy as np

PROGRAM = pathlib.Path(os.environ["WASHFSI_PROGRAM"])
SOURCE = pathlib.Path(os.environ["WASHFSI_SOURCE"])
PATIENCE = float(os.environ.get("WASHFSI_PATIENCE", 1))
WASH = SOURCE / "inputs" / "thesis" / "wash2d64.opts"
CAVITY = SOURCE / "inputs" / "cavity.opts"
SHEET = SOURCE / "inputs" / "sheet.opts"
CHANNEL = SOURCE / "inputs" / "channel.opts"
COUETTE = SOURCE / "inputs" / "couette.opts"
# in steps of equal length, whose number a test then knows
EXPLICIT_WASH = ["-options_file", WASH, "-coupling_scheme", "explicit", "-long_damping", "1e-4", "-short_damping", "1e-4",
                 "-time_cfl", "0", "-time_step", "1e-4"]
TIGHT = ["-momentum_tolerance", "1e-13", "-pressure_tolerance", "1e-12"]


class ProgramTest(unittest.TestCase):
    """Tests in a fresh temporary folder each, removed afterwards. Each prints how long it took."""

    def setUp(self):
        start = time.monotonic()
        self.addCleanup(lambda: print(f"{self.id()}: {time.monotonic() - start:.1f} s"))
        folder = tempfile.TemporaryDirectory(prefix="washfsi_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    @classmethod
    def shared_folder(cls):
        """Returns a temporary folder for all tests of the class, for its setUpClass; removed after the last."""
        folder = tempfile.TemporaryDirectory(prefix="washfsi_")
        cls.addClassCleanup(folder.cleanup)
        return pathlib.Path(folder.name)

    def run_well(self, ranks, *options):
        """Runs the program, which must end with exit status 0; returns its standard output."""
        outcome = run(ranks, *options, folder=self.folder)
        self.assertEqual(outcome.returncode, 0, outcome.stdout + outcome.stderr)
        return outcome.stdout

    def assert_restart_goes_on(self, results_of, case, middle, end):
        """Compares, to the bit, the arrays that `results_of` reads of a run and of one that stopped in between, on two ranks."""
        straight = results_of("straight", *case, "-time_end", end, ranks=2)
        results_of("split", *case, "-time_end", middle, ranks=2)
        split = results_of("split", *case, "-time_end", end, "-restart", "split/checkpoint.h5", ranks=2)
        for name, values in straight.items():
            np.testing.assert_array_equal(split[name], values, name)


def command(ranks, *options):
    """Returns the command line that runs the program: one rank without mpirun, as it starts much sooner."""
    if ranks == 1:
        return [str(PROGRAM), *map(str, options)]
    # A rank that spins while it waits makes every run many times slower when the machine has other work.
    return ["mpirun", "--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1",
            "-n", str(ranks), str(PROGRAM), *map(str, options)]


def alone(folder):
    """Returns the environment of a run without mpirun and without networks, which starts in a sixth of a second; several at once need
    folders of their own."""
    return {**os.environ, "OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_pml": "ob1", "OMPI_MCA_btl": "self", "TMPDIR": str(folder)}


def run(ranks, *options, folder, seconds=120, launcher=()):
    """Runs the program in a folder; its status is 124 when it had to be ended after some seconds."""
    return subprocess.run(["timeout", "--kill-after=10", str(PATIENCE * seconds), *launcher, *command(ranks, *options)],
                          cwd=folder, capture_output=True, text=True, check=False,
                          env=alone(folder) if ranks == 1 else None)


def read_table(path):
    """Returns the names, the units and the numbers (a row per line) of one of the program's CSV files."""
    with open(path, encoding="utf-8") as file:
        names, units = file.readline().strip().split(","), file.readline().strip()
    if not units.startswith("#"):
        raise ValueError(f"{path}: the second row holds no units: {units}")
    return names, units.lstrip("# ").split(","), np.loadtxt(path, delimiter=",", skiprows=2, ndmin=2)


def read_columns(path):
    """Returns the columns of one of the program's CSV files by name."""
    names, _, numbers = read_table(path)
    return dict(zip(names, numbers.T))


def read_options(path):
    """Returns the options of an options file and their values, as texts."""
    lines = (line.split("#")[0].split(maxsplit=1) for line in path.read_text().splitlines())
    return {words[0]: words[1].strip() if len(words) > 1 else "" for words in lines if words}


def relative_difference(value, expected):
    """Returns the largest difference of two arrays over the largest number of the expected one."""
    largest = np.abs(expected).max()
    return np.abs(value - expected).max() / largest if largest > 0 else np.abs(value).max()
