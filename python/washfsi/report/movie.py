# SPDX-License-Identifier: BSD-3-Clause
"""Movies of the playback: a headless browser draws the frames, ffmpeg puts them together."""

import base64
import io
import pathlib
import re
import subprocess
import tempfile

import numpy as np
from matplotlib import font_manager
from PIL import Image, ImageDraw, ImageFont

from washfsi.errors import ResultsError
from washfsi.report.picture import browse, write_picture_page

FRAMES_PER_SECOND, SLOWER = 20, 4  # of the movie; how much slower than the run it goes
LONGEST = 600  # frames
PATIENCE = 600000  # [ms] of the page's clock
INK, HALO = (40, 50, 65), (238, 242, 246)  # of the time, which stands out on any flow
FRAME = re.compile(r'class="frame" src="data:image/jpeg;base64,([^"]+)" alt="([^"]+)"')  # and the time as text


def times_of(results):
    """Returns the times that a movie shows [s]."""
    time = results.history["time"]
    count = round(float(np.clip((time[-1] - time[0]) * SLOWER * FRAMES_PER_SECOND, 2, LONGEST))) + 1
    return np.linspace(time[0], time[-1], count)


def frames_of(results, asked, folder):
    """Returns the frames of the playback at all times: each as the bytes of a JPEG file, and its time as text."""
    times = times_of(results)
    listed = ",".join(f"{time:.4f}" for time in times)
    address = write_picture_page(results, folder / "page.html", {**asked, "times": listed})
    frames = [(base64.b64decode(text), time) for text, time in FRAME.findall(browse(folder, address, PATIENCE, "--dump-dom"))]
    if len(frames) != len(times):
        raise ResultsError(f"chromium has drawn {len(frames)} of {len(times)} frames: the machine is too busy, or has no WebGL")
    return frames


def write_frame(path, frame, time):
    """Writes a frame with its time in the corner; of even size, as the codec needs."""
    picture = Image.open(io.BytesIO(frame)).convert("RGB")
    font = ImageFont.truetype(font_manager.findfont("DejaVu Sans"), picture.height // 28)
    place = picture.width // 50, picture.width // 50
    ImageDraw.Draw(picture).text(place, time, fill=INK, font=font, stroke_width=picture.height // 250, stroke_fill=HALO)
    picture.crop((0, 0, picture.width // 2 * 2, picture.height // 2 * 2)).save(path)


def write_movie(results, path, asked):
    """Writes a movie of the playback of a run (MP4, H.264); `asked` is that of pictures, without a time."""
    with tempfile.TemporaryDirectory(prefix="washfsi_", ignore_cleanup_errors=True) as name:
        folder = pathlib.Path(name)
        for number, (frame, time) in enumerate(frames_of(results, asked, folder)):
            write_frame(folder / f"{number:06d}.png", frame, time)
        command = ["ffmpeg", "-y", "-loglevel", "error", "-framerate", str(FRAMES_PER_SECOND), "-i", f"{folder}/%06d.png",
                   "-c:v", "libx264", "-crf", "28", "-preset", "slow", "-pix_fmt", "yuv420p", "-movflags", "+faststart", str(path)]
        try:
            done = subprocess.run(command, check=False, capture_output=True, text=True)
        except FileNotFoundError:
            raise ResultsError("a movie needs the program ffmpeg") from None
        if done.returncode:
            raise ResultsError(f"ffmpeg could not write {path}: {' '.join(done.stderr.splitlines()[-1:])}")
