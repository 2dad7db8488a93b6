# SPDX-License-Identifier: BSD-3-Clause
"""scripts/plot draws runs and dry runs, in the plane and in space, and nothing is cut off or covered."""

import itertools
import shutil
import subprocess
import sys
import unittest

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg

from support import SOURCE, WASH, ProgramTest, run

sys.path.insert(0, str(SOURCE / "python"))
from washfsi import Results  # noqa: E402
from washfsi.plot.history import draw_history  # noqa: E402
from washfsi.plot.perspective import draw_perspective  # noqa: E402
from washfsi.plot.scene import read_scene, vorticity_limit  # noqa: E402
from washfsi.plot.snapshot import cut, draw_snapshot  # noqa: E402
from washfsi.plot.style import GROUP_COLORS, even_size, DPI  # noqa: E402
from washfsi.plot.tracks import draw_tracks  # noqa: E402

LONG = "handkerchief_of_my_grandmother"
SPACE = ["-options_file", SOURCE / "inputs" / "wash.opts", "-grid_cells", "12,12,12", "-cloths", f"towel,{LONG}",
         "-towel_count", 4, "-towel_markers", 4, f"-{LONG}_count", 2, f"-{LONG}_size", 0.08, f"-{LONG}_markers", 3,
         f"-{LONG}_placement", "random", f"-{LONG}_center", "0,0,0.15", f"-{LONG}_height", 0.1, f"-{LONG}_radius", 0.28]
PLANE = ["-options_file", WASH, "-grid_cells", "32,32", "-long_markers", 8, "-short_markers", 6]


class Plot(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.root = cls.shared_folder()
        for name, words in (("space", [*SPACE, "-time_step", 1e-3, "-time_end", 0.01, "-output_interval", 0.005]),
                            ("plane", [*PLANE, "-time_end", 0.02, "-output_interval", 0.01]),
                            ("design", [*SPACE, "-check"])):
            outcome = run(1, *words, "-output_dir", name, folder=cls.root)
            if outcome.returncode:
                raise AssertionError(outcome.stderr)

    def plot(self, name, *words):
        """Draws results; returns the pictures' names."""
        before = set((self.root / name).iterdir())
        outcome = subprocess.run([SOURCE / "scripts" / "plot", self.root / name, *words], capture_output=True, text=True,
                                 check=False, cwd=self.folder)
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        self.printed = outcome.stdout
        made = set((self.root / name).iterdir()) - before
        for path in made:
            path.unlink()
        return {path.name for path in made}

    def test_pictures_of_a_run(self):
        self.assertEqual(self.plot("space"), {"perspective_0.0100.png", "snapshot_0.0100.png", "history.png", "tracks.png"})
        self.assertEqual({name[:9] for name in self.plot("plane")}, {"snapshot_", "history.p"})
        self.assertEqual(len(self.plot("plane", "--all")), 4)
        self.assertIn("snapshot_0.0050.png", self.plot("space", "--time", "0.006"))

    def test_pictures_of_a_design(self):
        self.assertEqual(self.plot("design"), {"perspective_0.0000.png", "snapshot_0.0000.png"})
        self.assertIn("design before the run", self.printed)

    def test_mistakes_are_told_in_a_line(self):
        for folder, words in (("nowhere", []), ("space", ["--frame", "7"]), ("space", ["--history", "speed"]),
                              ("space", ["--time", "3"])):
            outcome = subprocess.run([SOURCE / "scripts" / "plot", self.root / folder, *words], capture_output=True,
                                     text=True, check=False)
            with self.subTest(words=words):
                self.assertEqual(outcome.returncode, 2)
                self.assertRegex(outcome.stderr, r"\Aplot: .*\n\Z")

    def test_perspective_names_its_axes_inside_the_picture(self):
        figure = draw_perspective(read_scene(Results(self.root / "space"), -1))
        canvas = FigureCanvasAgg(figure)
        canvas.draw()
        axes, = figure.axes
        for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
            box = axis.label.get_window_extent(canvas.get_renderer())
            self.assertTrue(figure.bbox.x0 <= box.x0 and box.x1 <= figure.bbox.x1, axis.label.get_text())
            self.assertTrue(figure.bbox.y0 <= box.y0 and box.y1 <= figure.bbox.y1, axis.label.get_text())

    def test_long_names_do_not_overlap(self):
        results = Results(self.root / "space")
        scene = read_scene(results, -1)
        for figure in (draw_snapshot(scene, vorticity_limit(scene)), draw_perspective(scene), draw_tracks(results),
                       draw_history(results.history, results.case)):
            canvas = FigureCanvasAgg(figure)
            canvas.draw()
            legends = [legend for owner in (figure, *figure.axes)
                       for legend in (owner.legends if owner is figure else [owner.get_legend()]) if legend]
            texts = [text for legend in legends for text in legend.get_texts()]
            self.assertIn(LONG, [text.get_text() for text in texts])
            boxes = [text.get_window_extent(canvas.get_renderer()) for text in texts]
            for first, second in itertools.combinations(boxes, 2):
                self.assertFalse(first.overlaps(second))

    def test_tracks_show_the_machine_and_the_groups(self):
        results = Results(self.root / "space")
        axes, = draw_tracks(results).axes
        self.assertGreaterEqual(axes.get_xlim()[1], 1)  # the drum's radius
        np.testing.assert_allclose(axes.get_ylim(), [0, 0.2376 / 0.31])
        legend = axes.get_legend()
        self.assertEqual([text.get_text() for text in legend.get_texts()], ["towel", LONG])
        self.assertEqual([line.get_color() for line in legend.get_lines()], GROUP_COLORS[:2])

    def test_a_plane_cuts_a_quadrilateral(self):
        corners = np.array([[0, 0, 0], [1, 0, 0], [1, 0, 2], [0, 0, 2]], float)
        np.testing.assert_allclose(sorted(map(tuple, cut(corners, 0.5))), [(0, 0), (1, 0)])
        self.assertIsNone(cut(corners, 3))

    @unittest.skipUnless(shutil.which("ffmpeg"), "there is no ffmpeg")
    def test_movies_have_no_black_row(self):
        for name in ("plane", "space"):
            movie = self.folder / f"{name}.mp4"
            self.plot(name, "--movie", movie)
            width, height = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "stream=width,height", "-of", "csv=p=0",
                                            movie], capture_output=True, text=True, check=True).stdout.strip().split(",")
            raw = subprocess.run(["ffmpeg", "-v", "error", "-i", movie, "-frames:v", "1", "-f", "rawvideo", "-pix_fmt",
                                  "gray", "-"], capture_output=True, check=True).stdout
            picture = np.frombuffer(raw, np.uint8).reshape(int(height), int(width))
            self.assertGreater(picture[-1].min(), 200)
            self.assertGreater(picture[:, -1].min(), 200)

    def test_sizes_are_even(self):
        for height in np.linspace(3, 5, 50):
            self.assertEqual([round(length * DPI) % 2 for length in even_size(6.01, height)], [0, 0])


if __name__ == "__main__":
    unittest.main()
