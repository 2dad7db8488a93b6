# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the playback, by a headless browser."""

import pathlib
import shutil
import subprocess
import tempfile
import urllib.parse

from PIL import Image

from washfsi.errors import ResultsError
from washfsi.report.page import page_of

SIZE = 1200, 760  # [px]
ROOM = 60_000_000  # [bytes] for the playback: more than in a report, so that the flow of every frame is there
COLOURS = 255  # of the file, which keeps it small
PATIENCE = 10000, 60000  # [ms] of the page's clock, one try after the other
LEAST_COLOURS = 40  # of a picture that shows something
AXES = {"x": 0, "y": 1, "z": 2, "none": "none"}  # what a slice lies across, as the page names it
FLAGS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars", "--use-gl=angle",
         "--use-angle=swiftshader-webgl", "--force-device-scale-factor=1", "--no-first-run", "--disable-sync",
         "--disable-background-networking", "--disable-component-update", "--disable-extensions"]


def write_picture_page(results, path, asked):
    """Writes the page that shows the playback alone; returns its address. `asked` has some of time [s], view, slice (x, y, z,
    none), height and colour; for a movie times [s], with commas between."""
    path.write_text(page_of([results], ROOM).replace("<body>", '<body class="picture">', 1), encoding="utf-8")
    words = {name: AXES[value] if name == "slice" else value for name, value in asked.items() if value is not None}
    return f"{path.as_uri()}#{urllib.parse.urlencode(words)}"


def find_chromium():
    """Returns the browser that makes the pictures."""
    chromium = shutil.which("chromium")
    if not chromium:
        raise ResultsError("there is no program chromium, which makes the pictures; Debian's package is chromium")
    return chromium


def browse(folder, address, patience, *words):
    """Opens an address in a browser, with its profile and what it says in a folder; returns what it prints."""
    printed = folder / "printed"
    with open(folder / "log", "wb") as said, open(printed, "wb") as out:  # no pipes: helpers of the browser keep them open for seconds
        subprocess.run([find_chromium(), *FLAGS, f"--user-data-dir={folder}/profile", f"--window-size={SIZE[0]},{SIZE[1]}",
                        f"--virtual-time-budget={patience}", *words, address], stdout=out, stderr=said, check=False)
    return printed.read_text(encoding="utf-8", errors="replace")


def take_picture(folder, address, patience):
    """Returns what a browser shows at an address, None when that is nothing: the page was not ready."""
    shot = folder / "shot.png"
    browse(folder, address, patience, f"--screenshot={shot}")
    if not shot.is_file():
        raise ResultsError(f"chromium has made no picture: {' '.join((folder / 'log').read_text().splitlines()[-1:])}")
    picture = Image.open(shot).convert("RGB")
    return picture if len(picture.getcolors(SIZE[0] * SIZE[1])) > LEAST_COLOURS else None


def write_picture(results, path, asked):
    """Writes a picture of the playback of a run (PNG)."""
    find_chromium()
    with tempfile.TemporaryDirectory(prefix="washfsi_", ignore_cleanup_errors=True) as name:
        folder = pathlib.Path(name)
        address = write_picture_page(results, folder / "page.html", asked)
        picture = next(filter(None, (take_picture(folder, address, patience) for patience in PATIENCE)), None)
        if picture is None:
            raise ResultsError("chromium shows no playback: the machine is too busy, or has no WebGL")
        try:
            picture.quantize(COLOURS, dither=Image.Dither.NONE).save(path, optimize=True)
        except (OSError, ValueError) as error:
            raise ResultsError(f"cannot write {path}: {error}") from None
