# SPDX-License-Identifier: BSD-3-Clause
"""Movies of all frames."""

import pathlib
import shutil
import subprocess
import tempfile

from washfsi.errors import ResultsError
from washfsi.plot.perspective import draw_perspective
from washfsi.plot.scene import read_scene, vorticity_limit
from washfsi.plot.snapshot import draw_snapshot
from washfsi.plot.style import DPI

FRAMES_PER_SECOND = 20


def make_movie(results, path):
    """Writes a movie of all frames: in perspective in 3D."""
    if not shutil.which("ffmpeg"):
        raise ResultsError("--movie needs the program ffmpeg")
    limit = vorticity_limit(read_scene(results, len(results.flow) - 1))
    with tempfile.TemporaryDirectory() as pictures:
        for number in range(len(results.flow)):
            scene = read_scene(results, number)
            figure = draw_perspective(scene) if scene.dim == 3 else draw_snapshot(scene, limit)
            figure.savefig(pathlib.Path(pictures) / f"{number:06d}.png", dpi=DPI)  # of even size, as the codec needs
        command = ["ffmpeg", "-y", "-loglevel", "error", "-framerate", str(FRAMES_PER_SECOND), "-i",
                   f"{pictures}/%06d.png", "-vf", "scale=trunc(iw/2)*2:trunc(ih/2)*2", "-pix_fmt", "yuv420p", str(path)]
        if subprocess.run(command, check=False).returncode:
            raise ResultsError(f"ffmpeg could not write {path}")
    print(path)
