# SPDX-License-Identifier: BSD-3-Clause
"""A run that is killed, or meets a full disk or a bad sector, at any call that changes its folder: then it is finished, and
leaves what an undisturbed run leaves, to the bit.

    failing_writes_test.py         some of the calls of a run and of a restart
    failing_writes_test.py full    all of them
"""

import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

from support import PATIENCE, PROGRAM, SOURCE, ProgramTest, alone

FULL = "full" in sys.argv
LIBRARY = os.environ["WASHFSI_FAILING_WRITES"]
KINDS = ("kill", "torn", "ENOSPC", "EIO")
SAMPLE = 5  # calls of each kind, in a run and in a restart of it
NOT_WRITTEN, KILLED = 4, -9
CASE = ["-options_file", SOURCE / "inputs" / "thesis" / "wash2d64.opts", "-grid_cells", "16,16", "-time_cfl", 0, "-time_step", 1e-3,
        "-long_markers", 10, "-long_count", 2, "-short_markers", 5, "-short_count", 1,
        "-output_interval", 1e-3, "-checkpoint_interval", 1e-3]
HALF, END = 1e-3, 2e-3  # [s]


def frames_of(path):
    """Returns all datasets and attributes that are reached from an HDF5 file, those in files that it links to as well."""
    found = {}

    def read(name, group):
        found.update({f"{name}@{key}": value for key, value in group.attrs.items()})
        for key in group:
            member = group[key]
            if isinstance(member, h5py.Group):
                read(f"{name}/{key}", member)
            else:
                found[f"{name}/{key}"] = member[()]

    with h5py.File(path) as file:
        read("", file)
    return found


def summary_of(folder):
    """Returns what of a run's summary is not of the machine's time and memory; None if there is none."""
    path = folder / "summary.json"
    if not path.exists():
        return None
    summary = json.loads(path.read_text())
    return {key: value for key, value in summary.items()
            if key not in ("wall_seconds", "seconds_per_step", "peak_memory_bytes")}


class FailingWrites(ProgramTest):
    def setUp(self):
        super().setUp()
        self.expected = self.folder / "expected"
        self.assert_well(self.run_in(self.expected))
        self.half = self.folder / "half"
        self.assert_well(self.run_in(self.half, "-time_end", HALF))
        (self.half / "summary.json").unlink()  # as if it had been killed there

    def run_in(self, out, *options, **faults):
        """Runs the case into a folder, from its checkpoint if it has one, with a fault if any."""
        checkpoints = [out / name for name in ("checkpoint.h5", "checkpoint_before.h5")]
        restart = [word for path in checkpoints if path.exists() for word in ("-restart", path)][:2]
        environment = alone(out.parent)
        if faults:
            environment |= {"LD_PRELOAD": LIBRARY, "FAULT_FOLDER": str(out), **{key: str(faults[key]) for key in faults}}
        return subprocess.run([PROGRAM, *map(str, CASE), "-time_end", str(END), "-output_dir", out, *restart,
                               *map(str, options)],
                              cwd=out.parent, env=environment, capture_output=True, text=True, timeout=60 * PATIENCE,
                              check=False)

    def assert_well(self, outcome):
        """Checks that a run ended with status 0 and nothing to complain of."""
        self.assertEqual((outcome.returncode, outcome.stderr), (0, ""), outcome.stdout)

    def assert_as_expected(self, out):
        """Compares a folder with that of the undisturbed run."""
        left, expected = ({str(path.relative_to(folder)) for path in folder.rglob("*")
                           if path.name != ".lock" and ".locktest." not in path.name}  # the next run removes these
                          for folder in (out, self.expected))
        self.assertEqual(left, expected)
        self.assertEqual(summary_of(out), summary_of(self.expected))
        for name in sorted(expected):
            if name.endswith((".csv", ".xdmf")):
                self.assertEqual((out / name).read_text(), (self.expected / name).read_text(), name)
        for name in ("checkpoint.h5", "checkpoint_before.h5", "flow.h5", "cloth.h5", "bodies.h5"):
            found, wanted = frames_of(out / name), frames_of(self.expected / name)
            self.assertEqual(found.keys(), wanted.keys(), name)
            for key, value in wanted.items():
                if key not in ("/options",):  # with -restart
                    np.testing.assert_array_equal(found[key], value, f"{name}{key}")

    def assert_recovers(self, start, kind, call):
        """Runs with a fault, finishes the run without, and compares; `start` is the folder to begin from, if any."""
        with tempfile.TemporaryDirectory(dir=self.folder) as folder:
            out = pathlib.Path(folder) / "out"
            if start:
                shutil.copytree(start, out)
            outcome = self.run_in(out, FAULT_KIND=kind, FAULT_AT=call)
            if kind in ("kill", "torn"):
                self.assertEqual(outcome.returncode, KILLED, outcome.stderr)
            else:
                self.assertIn(outcome.returncode, (0, NOT_WRITTEN), outcome.stderr)
                lines = [line for line in outcome.stderr.splitlines() if "mca_" not in line]  # Open MPI's own
                self.assertEqual(len(lines), int(outcome.returncode != 0), outcome.stderr)
            if (summary_of(out) or {}).get("status") != "finished":
                self.assert_well(self.run_in(out))
            self.assert_as_expected(out)

    def number_of_calls(self, start):
        """Returns how many calls of a run change its folder."""
        out, count = self.folder / "counted", self.folder / "count"
        if start:
            shutil.copytree(start, out)
        self.assert_well(self.run_in(out, FAULT_COUNT=count))
        shutil.rmtree(out)
        return int(count.read_text())

    def assert_recovers_from_all(self, start):
        """Tries all calls of a run, or some of them spread over it, with all kinds of faults."""
        calls = self.number_of_calls(start)
        self.assertGreater(calls, 100)
        step = 1 if FULL else calls // SAMPLE
        tries = [(kind, call) for place, kind in enumerate(KINDS)
                 for call in range(1 if FULL else 1 + place * step // len(KINDS), calls + 1, step)]
        with concurrent.futures.ThreadPoolExecutor(2) as workers:  # a run waits for the disk most of its time
            jobs = {one: workers.submit(self.assert_recovers, start, *one) for one in tries}
            for (kind, call), job in jobs.items():
                with self.subTest(kind=kind, call=call, calls=calls):
                    job.result()
        print(f"{calls} calls of a {'restart' if start else 'run'}, {len(tries)} faults", flush=True)

    def test_a_run(self):
        self.assert_recovers_from_all(None)

    def test_a_restart(self):
        self.assert_recovers_from_all(self.half)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
