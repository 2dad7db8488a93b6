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
COLOURS = 255  # of the file, which keeps it small
PATIENCE = 10000, 60000  # [ms] of the page's clock, one try after the other
LEAST_COLOURS = 40  # of a picture that shows something
FLAGS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars", "--use-gl=angle",
         "--use-angle=swiftshader-webgl", "--force-device-scale-factor=1", "--no-first-run", "--disable-sync",
         "--disable-background-networking", "--disable-component-update", "--disable-extensions"]


def write_picture_page(results, path, asked):
    """Writes the page that shows the playback alone; returns its address. `asked` has time, view, slice, height and colour."""
    path.write_text(page_of([results]).replace("<body>", '<body class="picture">', 1), encoding="utf-8")
    words = {name: value for name, value in asked.items() if value is not None}
    return f"{path.as_uri()}#{urllib.parse.urlencode(words)}"


def take_picture(chromium, folder, address, patience):
    """Returns what a browser shows at an address, None when that is nothing: the page was not ready."""
    shot, log = folder / "shot.png", folder / "log"
    with open(log, "wb") as said:  # no pipe: helpers of the browser keep it open for seconds
        subprocess.run([chromium, *FLAGS, f"--user-data-dir={folder}/profile", f"--window-size={SIZE[0]},{SIZE[1]}",
                        f"--virtual-time-budget={patience}", f"--screenshot={shot}", address],
                       stdout=subprocess.DEVNULL, stderr=said, check=False)
    if not shot.is_file():
        raise ResultsError(f"chromium has made no picture: {' '.join(log.read_text().splitlines()[-1:])}")
    picture = Image.open(shot).convert("RGB")
    return picture if len(picture.getcolors(SIZE[0] * SIZE[1])) > LEAST_COLOURS else None


def write_picture(results, path, asked):
    """Writes a picture of the playback of a run (PNG)."""
    chromium = shutil.which("chromium")
    if not chromium:
        raise ResultsError("there is no program chromium, which makes the pictures; Debian's package is chromium")
    with tempfile.TemporaryDirectory(prefix="washfsi_", ignore_cleanup_errors=True) as name:
        folder = pathlib.Path(name)
        address = write_picture_page(results, folder / "page.html", asked)
        picture = next(filter(None, (take_picture(chromium, folder, address, patience) for patience in PATIENCE)), None)
        if picture is None:
            raise ResultsError("chromium shows no playback: the machine is too busy, or has no WebGL")
        try:
            picture.quantize(COLOURS, dither=Image.Dither.NONE).save(path, optimize=True)
        except (OSError, ValueError) as error:
            raise ResultsError(f"cannot write {path}: {error}") from None
