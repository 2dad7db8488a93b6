# SPDX-License-Identifier: BSD-3-Clause
"""scripts/paraview writes a scene that ParaView shows. What needs ParaView is left out where there is none: Debian's packages
are paraview, xvfb and xauth."""

import os
import shutil
import subprocess
import sys
import unittest

import h5py
import numpy as np
from matplotlib.image import imread

from support import PATIENCE, SOURCE, WASH, ProgramTest, run

sys.path.insert(0, str(SOURCE / "python"))
from washfsi.errors import ResultsError  # noqa: E402
from washfsi.paraview_view.command import command_of, write_scene  # noqa: E402
from washfsi.results import Results  # noqa: E402

SPACE = ["-options_file", SOURCE / "inputs" / "wash.opts", "-grid_cells", "16,16,16", "-towel_count", 4, "-towel_markers", 4,
         "-time_end", 0.02, "-output_interval", 0.01]
PLANE = ["-options_file", WASH, "-grid_cells", "32,32", "-long_markers", 8, "-short_markers", 6, "-time_end", 0.02,
         "-output_interval", 0.01]
READER = """import sys
from paraview import simple
for name in sys.argv[2:]:
    series = simple.OpenDataFile(f"{sys.argv[1]}/{name}.xdmf")  # as by a double click
    for time in series.TimestepValues:
        series.UpdatePipeline(time)
        print(name, series.GetDataInformation().GetNumberOfCells())
"""
FIELDS = ("velocity", "pressure", "vorticity")
SHOWER = """import sys
from paraview import simple
for name in sys.argv[2:]:
    for open_series in (simple.OpenDataFile, lambda path: simple.XDMFReader(FileNames=[path])):
        series = open_series(f"{sys.argv[1]}/{name}.xdmf")
        representation = simple.Show(series).Representation.GetData()
        fields = series.GetDataInformation().GetCellDataInformation()
        print(name, representation, *sorted(fields.GetArrayInformation(n).GetName() for n in range(fields.GetNumberOfArrays())))
        simple.Delete(series)
"""
SHOWS = shutil.which("pvpython") and (os.environ.get("DISPLAY") or shutil.which("xvfb-run") and shutil.which("xauth"))


class Paraview(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.root = cls.shared_folder()
        for name, words in (("space", SPACE), ("plane", PLANE), ("design", [*SPACE, "-check"])):
            outcome = run(1, *words, "-output_dir", name, folder=cls.root)
            if outcome.returncode:
                raise AssertionError(outcome.stderr)

    def pvpython_lines(self, *words):
        """Runs a script in ParaView's Python; returns what it prints as lists of words."""
        outcome = subprocess.run(command_of("pvpython", *map(str, words)), capture_output=True, text=True, check=False,
                                 timeout=PATIENCE * 120)
        self.assertEqual(outcome.returncode, 0, outcome.stdout + outcome.stderr)
        return [line.split() for line in outcome.stdout.splitlines()]

    def pvpython(self, *words):
        """The same, of lines that are a name and a number."""
        lines = self.pvpython_lines(*words)
        return [(line[0], int(line[1])) for line in lines if len(line) == 2 and line[1].isdigit()]

    def test_the_script_knows_the_run(self):
        path = self.folder / "scene.py"
        write_scene(Results(self.root / "space"), path, axis="y", height=0.25)
        text = path.read_text(encoding="utf-8")
        compile(text, path, "exec")
        place = {}
        exec(text[text.index("SCENE = "):text.index("# What follows")], place)  # pylint: disable=exec-used
        scene = place["SCENE"]
        self.assertEqual(sorted((body["name"], body["surrounds"]) for body in scene["bodies"]),
                         [("agitator", False), ("drum", True)])
        self.assertEqual((scene["groups"], scene["slice_normal"]), (["towel"], [0, 1, 0]))
        np.testing.assert_allclose(scene["slice_origin"], [0, 0.25 * 2 * 0.3564 - 0.3564, 0.1188], atol=1e-12)

    def test_mistakes_are_told_in_a_line(self):
        for folder, words in (("nowhere", []), ("space", ["--height", "2"]), (".", [])):
            outcome = subprocess.run([SOURCE / "scripts" / "paraview", self.root / folder, *words], capture_output=True,
                                     text=True, check=False)
            with self.subTest(folder=folder, words=words):
                self.assertEqual(outcome.returncode, 2)
                self.assertRegex(outcome.stderr, r"\Aparaview: .*\n\Z")
        with self.assertRaisesRegex(ResultsError, "there is no program nothing"):
            command_of("nothing")

    @unittest.skipUnless(SHOWS, "there is no ParaView with a display: no pvpython, or neither DISPLAY nor xvfb-run")
    def test_paraview_opens_every_frame_of_every_series(self):
        script = self.folder / "reader.py"
        script.write_text(READER)
        for name, flow, cloth, slices in (("space", 16 ** 3, 4 * 9, [("slices", 3 * 16 ** 2)]), ("plane", 32 ** 2, 20, [])):
            with h5py.File(self.root / name / "surfaces.h5") as file:
                facets = len(file["topology"])
            self.assertGreater(facets, 100)
            expected = [("flow", flow), ("bodies", flow), ("surfaces", facets), ("cloth", cloth), *slices]
            self.assertEqual(self.pvpython(script, self.root / name, *dict(expected)),
                             [(series, cells) for series, cells in expected for _ in range(3)])

    @unittest.skipUnless(SHOWS, "there is no ParaView with a display: no pvpython, or neither DISPLAY nor xvfb-run")
    def test_paraview_shows_slices_surfaces_and_cloths_at_once(self):
        script = self.folder / "shower.py"
        script.write_text(SHOWER)
        shown = self.pvpython_lines(script, self.root / "space", "slices", "surfaces", "cloth")
        self.assertEqual([line[:2] for line in shown if line], [[name, "Surface"] for name in ("slices", "surfaces", "cloth")
                                                                for _ in range(2)])
        self.assertEqual([line[2:] for line in shown if line[:1] == ["slices"]], 2 * [sorted(FIELDS)])

    def test_slices_are_the_middle_layers_of_the_flow(self):
        flow = Results(self.root / "space").flow
        with h5py.File(self.root / "space" / "slices.h5") as file:
            for axis, plane in enumerate(("yz", "xz", "xy")):
                places = file[plane]["position"][()]
                self.assertEqual(places.shape, (17, 17, 3))
                middle = flow.centres()[axis][8]
                np.testing.assert_allclose(places[..., axis], middle, atol=1e-15)
                others = np.delete(np.arange(3), axis)
                np.testing.assert_allclose(places[0, 0, others], flow.lower[others], atol=1e-15)
                np.testing.assert_allclose(places[-1, -1, others], flow.upper[others], atol=1e-15)
                self.assertEqual(list(file["frames"]), flow.names)
                for frame, of_flow in zip(file["frames"].values(), flow):
                    self.assertEqual((frame.attrs["time"], frame.attrs["step"]), (of_flow.time, of_flow.step))
                    for field in FIELDS:
                        np.testing.assert_array_equal(frame[plane][field], np.take(of_flow[field], 8, axis=2 - axis))
        self.assertFalse((self.root / "plane" / "slices.xdmf").exists())

    @unittest.skipUnless(SHOWS, "there is no ParaView with a display: no pvpython, or neither DISPLAY nor xvfb-run")
    def test_the_scene_shows_flow_bodies_and_cloths(self):
        for name in ("space", "plane", "design"):
            moved = self.folder / name  # results may have gone elsewhere since the script was written
            shutil.copytree(self.root / name, moved)
            write_scene(Results(self.root / name), moved / "paraview_scene.py")
            picture = self.folder / f"{name}.png"
            shown = dict(self.pvpython(moved / "paraview_scene.py", "--count", "--screenshot", picture))
            with self.subTest(name=name):
                self.assertEqual(set(shown), {"flow", "agitator", "drum", "cloth"})
                self.assertGreater(shown["flow"], 100)
                self.assertGreater(min(shown.values()), 15)
                self.check_picture(imread(picture)[..., :3], name)

    def check_picture(self, picture, name):
        """Something is drawn in the middle, in many colours, and the rim is empty but for title, bars and axes."""
        self.assertEqual(picture.shape, (1000, 1400, 3))
        drawn = (picture < 0.97).any(axis=2)
        self.assertGreater(drawn[250:750, 400:1000].mean(), 0.5, name)
        self.assertLess(drawn[:, :100].mean(), 0.05, name)
        colours = np.unique((15 * picture[250:750, 400:1000]).astype(int).reshape(-1, 3), axis=0)
        self.assertGreater(len(colours), 30, name)


if __name__ == "__main__":
    unittest.main()
