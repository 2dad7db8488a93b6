# SPDX-License-Identifier: BSD-3-Clause
"""A frame that is missing, empty, cut off or something else costs itself alone: report, pictures and the Python module leave it out,
and tell so in a line."""

import shutil
import subprocess
import sys
import unittest

import numpy as np

from support import SOURCE, WASH, ProgramTest, run

sys.path.insert(0, str(SOURCE / "python"))
from washfsi import Results, ResultsError  # noqa: E402
from washfsi.paraview_view.command import scene_of  # noqa: E402
from washfsi.plot.scene import read_scene  # noqa: E402
from washfsi.plot.tracks import draw_tracks  # noqa: E402
from washfsi.report.page import run_data  # noqa: E402

SERIES = ("flow", "bodies", "surfaces", "cloth")
PLACES = {"first": 0, "middle": 2, "last": 4}
DAMAGES = {"missing": lambda path: path.unlink(),
           "empty": lambda path: path.write_bytes(b""),
           "cut off": lambda path: path.write_bytes(path.read_bytes()[:path.stat().st_size // 2]),
           "its head alone": lambda path: path.write_bytes(path.read_bytes()[:300]),
           "rubbish": lambda path: path.write_bytes(b"no HDF5 file" * 500)}


class DamagedFrames(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.whole = cls.shared_folder() / "whole"
        outcome = run(1, "-options_file", WASH, "-grid_cells", "24,24", "-long_count", 1, "-short_count", 1, "-time_end", 0.08,
                      "-output_interval", 0.02, "-contact_distance", 0.02, "-output_dir", cls.whole, folder=cls.whole.parent)
        if outcome.returncode:
            raise RuntimeError(outcome.stderr)
        cls.times = Results(cls.whole).flow.times

    def damaged(self, series, place, damage):
        """Returns a copy of the results with a damaged frame."""
        folder = self.folder / "out"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.whole, folder)
        DAMAGES[damage](folder / series / f"{PLACES[place]:06d}.h5")
        return folder

    def each(self):
        """Yields every damage of a frame of every series, and the results."""
        for series in SERIES:
            for place in PLACES:
                for damage in DAMAGES:
                    with self.subTest(f"{place} frame of {series} {damage}"):
                        yield series, place, self.damaged(series, place, damage)

    def script(self, name, *words):
        """Calls a script, which must end well with one line on what it has left out."""
        outcome = subprocess.run([SOURCE / "scripts" / name, *map(str, words)], capture_output=True, text=True, check=False)
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        line, = outcome.stderr.splitlines()
        self.assertIn("cannot be read, left out", line)

    def test_series_leave_it_out(self):
        for series, place, folder in self.each():
            with self.assertLogs("washfsi", "WARNING") as log:
                read = getattr(Results(folder), series)
                self.assertEqual(len(list(read)), 4)
            self.assertEqual(len(log.output), 1)
            self.assertIn(f"{series}/{PLACES[place]:06d}.h5 cannot be read", log.output[0])
            np.testing.assert_array_equal(read.times, np.delete(self.times, PLACES[place]))
            self.assertEqual(read.damaged, [f"{PLACES[place]:06d}"])

    def test_report_and_scenes_are_of_moments_that_are_whole(self):
        for series, place, folder in self.each():
            with self.assertLogs("washfsi", "WARNING"):
                results = Results(folder).in_step()
                np.testing.assert_array_equal(results.flow.times, np.delete(self.times, PLACES[place]))
                for other in SERIES:
                    np.testing.assert_array_equal(getattr(results, other).steps, results.flow.steps)
            data, _ = run_data(results, 1e6)
            self.assertEqual(len(data["playback"]["times"]), 4)
            for number in range(4):
                self.assertTrue(np.isfinite(read_scene(results, number).positions).all())
            draw_tracks(results)
            scene_of(results, "z", 0.3, "stress")

    def test_scripts_end_well(self):
        folder = self.damaged("cloth", "middle", "cut off")
        self.script("report", folder)
        self.script("plot", folder, "--all")
        self.assertEqual(len(list(folder.glob("snapshot_*.png"))), 4)
        self.script("plot", folder, "--time", self.times[2])  # of which there is none: the nearest
        self.script("plot", self.damaged("flow", "last", "missing"))
        self.script("report", self.damaged("surfaces", "first", "missing"))

    def test_several_are_told_in_a_line(self):
        folder = self.damaged("flow", "first", "missing")
        DAMAGES["cut off"](folder / "flow" / "000003.h5")
        with self.assertLogs("washfsi", "WARNING") as log:
            self.assertEqual(len(Results(folder).flow), 3)
        self.assertEqual(len(log.output), 1)
        self.assertIn("flow/000000.h5, flow/000003.h5", log.output[0])

    def test_nothing_left_is_an_error_of_a_line(self):
        folder = self.damaged("flow", "first", "missing")
        shutil.rmtree(folder / "flow")
        with self.assertRaisesRegex(ResultsError, "no frames that can be read"):
            _ = Results(folder).flow
        outcome = subprocess.run([SOURCE / "scripts" / "report", folder], capture_output=True, text=True, check=False)
        self.assertEqual((outcome.returncode, outcome.stderr.count("\n")), (2, 1), outcome.stderr)


if __name__ == "__main__":
    unittest.main()
