# SPDX-License-Identifier: BSD-3-Clause
"""The Python module reads what the program writes and starts runs; the lines of Python in the documents run."""

import os
import re
import signal
import subprocess
import sys
import time
import unittest

import h5py
import numpy as np

from study_fixtures import write_cycles
from support import SOURCE, WASH, ProgramTest, read_columns

sys.path.insert(0, str(SOURCE / "python"))
import washfsi  # noqa: E402
from washfsi.running import words_of  # noqa: E402

PLANE = {"grid_cells": (32, 32), "long_markers": 8, "short_markers": 6, "time_end": 0.02, "output_interval": 0.01}
SPACE = {"grid_cells": (12, 12, 12), "towel_count": 4, "towel_markers": 4, "time_end": 0.02, "output_interval": 0.01}
MACHINE = SOURCE / "inputs" / "wash.opts"
INTERRUPTED = """import signal, washfsi
signal.signal(signal.SIGTERM, signal.default_int_handler)
washfsi.run({case!r}, "long", {options!r} | {{"time_end": 60}})
"""


def python_blocks(page):
    """Returns the blocks of Python of a document."""
    return re.findall(r"^```python\n(.*?)^```", (SOURCE / "docs" / page).read_text(encoding="utf-8"), re.M | re.S)


class Module(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.root = cls.shared_folder()
        cls.plane = washfsi.run(WASH, cls.root / "plane" / "out", PLANE, ranks=2)
        cls.space = washfsi.run(MACHINE, cls.root / "space" / "out", SPACE)
        for results in (cls.plane, cls.space):
            write_cycles(results.folder, {"agitator_work": 3.0})  # these runs end within the first

    def test_tables(self):
        for results in (self.plane, self.space):
            for name in ("history", "tracks"):
                table, columns = getattr(results, name), read_columns(results.folder / f"{name}.csv")
                self.assertEqual(list(table), list(columns))
                for column, values in columns.items():
                    np.testing.assert_array_equal(table[column], values)
            self.assertEqual(results.history.units["agitator_power"], "W" if results is self.space else "W/m")
            self.assertEqual(results.history.rows, results.summary["steps"])
            self.assertEqual(results.history.array["time"][-1], results.history["time"][-1])
            self.assertEqual(set(results.markers["group"]), set(results.groups))
        self.assertIn("agitator_torque", self.plane.history)
        self.assertIn("agitator_torque_z", self.space.history)
        with self.assertRaisesRegex(KeyError, "no column 'speed'; there are step, time"):
            _ = self.plane.history["speed"]

    def test_cycles_without_the_first(self):
        cycles = self.space.cycles
        later = cycles.where(cycles["start_up"] == 0)
        self.assertEqual(later.rows, max(cycles.rows - 1, 0))
        self.assertEqual(cycles.units["agitator_work"], "J")

    def test_a_row_that_is_not_complete_is_left_out(self):
        table = self.folder / "history.csv"
        table.write_text("step,time\n# -,s\n1,0.1\n2,0.2\n3")
        np.testing.assert_array_equal(washfsi.read_table(table)["time"], [0.1, 0.2])

    def test_fields(self):
        for results, cells in ((self.plane, (32, 32)), (self.space, (12, 12, 12))):
            self.assertEqual(results.flow.cells, cells)
            self.assertEqual(len(results.flow), 3)
            np.testing.assert_allclose(results.flow.times[1:], results.history["time"][results.flow.steps[1:] - 1])
            frame = results.flow.frame()
            self.assertEqual(frame["velocity"].shape, (*cells[::-1], 3))
            self.assertEqual((frame.units["pressure"], frame.step), ("Pa", results.summary["steps"]))
            self.assertEqual(results.flow.at(results.flow.times[1] + 1e-3).time, results.flow.times[1])
            upper = [float(number) for number in results.options["grid_upper"].split(",")]
            np.testing.assert_allclose(results.flow.upper, upper)
            self.assertEqual(set(results.bodies.frame(0)), {"drum", "agitator"})
            self.assertEqual(results.bodies.frame(0).units["drum"], "m")
            with h5py.File(results.folder / "flow.h5") as file:
                np.testing.assert_array_equal(file["frames/000002/pressure"], frame["pressure"])

    def test_surfaces(self):
        for results in (self.plane, self.space):
            surfaces = results.surfaces
            self.assertEqual(surfaces.bodies, ["drum", "agitator"])
            np.testing.assert_array_equal(surfaces.times, results.flow.times)
            self.assertEqual(surfaces.frame().units["position"], "m")
            self.assertEqual(surfaces.facets.shape[1], results.flow.dim)
            of_drum, of_agitator = (surfaces.facets_of(name) for name in surfaces.bodies)
            self.assertEqual(len(of_drum) + len(of_agitator), len(surfaces.facets))
            places = surfaces.frame(0)["position"]
            np.testing.assert_allclose(np.hypot(*places[of_drum].T[:2]), float(results.options["drum_radius"]), rtol=0.02)
            self.assertGreater(np.abs(surfaces.frame()["position"] - places)[of_agitator].max(), 0)
            with self.assertRaisesRegex(KeyError, "no body 'tub'; there are drum, agitator"):
                surfaces.facets_of("tub")
        self.assertIsNone(washfsi.Results(self.folder).surfaces)

    def test_markers(self):
        for results in (self.plane, self.space):
            last, end = results.cloth.table(), results.markers
            for name in [name for name in ("x", "y", "z", "u") if name in end]:
                np.testing.assert_array_equal(last[name], end[name])
                self.assertEqual(last.units[name], end.units[name])
            self.assertEqual((last.units["stress"], last.units["stretch"], last.units["curvature"]), ("Pa", "-", "1/m"))
            self.assertEqual(set(last), {"group", "cloth", *"xyzuvw", *(results.cloth.frame().data.keys() -
                                                                        {"position", "velocity"})})
            self.assertEqual({len(line) for line in results.cloth.lines}, {8, 6} if results is self.plane else {4})

    def test_options_become_words(self):
        self.assertEqual(words_of({"grid_cells": (8, 8), "-check": True, "drum_inverted": False, "help": None, "time_end": 0.5}),
                         ["-grid_cells", "8,8", "-check", "true", "-drum_inverted", "false", "-help", "-time_end", "0.5"])

    def test_what_is_wrong_is_told(self):
        with self.assertRaises(washfsi.RunError) as caught:
            washfsi.run(WASH, self.folder / "bad", {"fluid_viscosity": -1})
        self.assertEqual((str(caught.exception), caught.exception.status),
                         ("washfsi: -fluid_viscosity -1: must be a number >= 0", 2))
        with self.assertRaisesRegex(FileNotFoundError, "no program /nowhere"):
            washfsi.run(WASH, self.folder / "bad", program="/nowhere")
        with self.assertRaisesRegex(washfsi.ResultsError, "no folder"):
            washfsi.Results(self.folder / "nothing")
        (self.folder / "history.csv").write_text("<html>")
        with self.assertRaisesRegex(washfsi.ResultsError, "is no table"):
            _ = washfsi.Results(self.folder).history
        with self.assertRaisesRegex(washfsi.ResultsError, "no file .*flow.h5"):
            _ = washfsi.Results(self.folder).flow
        self.assertIsNone(washfsi.Results(self.folder).cloth)

    def test_an_interruption_leaves_a_checkpoint(self):
        lines = INTERRUPTED.format(case=str(MACHINE), options=SPACE)
        run = subprocess.Popen([sys.executable, "-c", lines], cwd=self.folder, env=self.environment(),
                               stderr=subprocess.DEVNULL)
        history = self.folder / "long" / "history.csv"
        for _ in range(1200):
            if history.is_file() and len(history.read_text().splitlines()) > 5 or run.poll() is not None:
                break
            time.sleep(0.05)
        run.send_signal(signal.SIGTERM)
        run.wait(timeout=60)
        self.assertEqual(washfsi.Results(self.folder / "long").summary["status"], "stopped")
        self.assertTrue((self.folder / "long" / "checkpoint.h5").is_file())

    @staticmethod
    def environment():
        """Returns the environment in which Python finds the module."""
        return dict(os.environ, PYTHONPATH=str(SOURCE / "python"))

    def run_lines(self, blocks, folder):
        """Runs blocks of Python one after another."""
        outcome = subprocess.run([sys.executable, "-W", "error", "-c", "\n".join(blocks)], cwd=folder, check=False,
                                 env=self.environment(), capture_output=True, text=True, timeout=240)
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        return outcome.stdout

    def test_lines_of_the_documents_read_runs_in_plane_and_space(self):
        for page, count in (("guide/results.md", 3), ("reference/python.md", 6)):
            blocks = [block for block in python_blocks(page) if "washfsi.run" not in block]
            self.assertEqual(len(blocks), count)
            for results in (self.plane, self.space):
                with self.subTest(page=page, folder=results.folder):
                    self.run_lines(blocks, results.folder.parent)

    def test_lines_of_the_documents_run_cases(self):
        (self.folder / "inputs").symlink_to(SOURCE / "inputs")
        blocks = [block for block in python_blocks("reference/python.md") if "washfsi.run" in block]
        self.assertEqual(len(blocks), 2)
        printed = self.run_lines([*blocks, "print(results.summary['status'])"], self.folder)
        said, = re.findall(r"# (washfsi: .*)", "\n".join(blocks))
        self.assertEqual(printed.splitlines(), [said, "finished"])


if __name__ == "__main__":
    unittest.main()
