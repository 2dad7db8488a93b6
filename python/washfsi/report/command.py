# SPDX-License-Identifier: BSD-3-Clause
"""The command scripts/report."""

import argparse
import os
import pathlib
import sys

from washfsi.errors import ResultsError
from washfsi.report.movie import write_movie
from washfsi.report.page import write_page
from washfsi.report.picture import write_picture
from washfsi.report.playback import COLOURS
from washfsi.results import Results


def parse_arguments(description):
    """Returns the command line's options."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", metavar="OUT", type=pathlib.Path, nargs="+",
                        help="output folder of a run, or of a -check")
    parser.add_argument("--output", metavar="FILE.html", type=pathlib.Path,
                        help="the report (default: report.html in OUT, or where the folders OUT are)")
    picture = parser.add_argument_group("a picture or a movie of the playback instead, by chromium")
    kinds = picture.add_mutually_exclusive_group()
    kinds.add_argument("--picture", metavar="FILE.png", type=pathlib.Path, help="of one run")
    kinds.add_argument("--movie", metavar="FILE.mp4", type=pathlib.Path, help="of one run, four times slower, by ffmpeg")
    picture.add_argument("--time", type=float, help="[s] (default: the frame at three quarters of the run)")
    picture.add_argument("--view", choices=("3d", "top", "front", "side"))
    picture.add_argument("--slice", choices=("x", "y", "z", "none"), help="axis that the slice lies across (default: z)")
    picture.add_argument("--height", type=float, help="place of the slice along it, from 0 to 1 (default: 0.3)")
    picture.add_argument("--colour", choices=(*COLOURS, "number"), help="of the cloths (default: stress)")
    options = parser.parse_args()
    still = options.picture or options.movie
    if still and len(options.folders) > 1:
        parser.error("--picture and --movie are of one run")
    of_pictures = (options.time, options.view, options.slice, options.height, options.colour)
    if not still and any(given is not None for given in of_pictures):
        parser.error("--time, --view, --slice, --height and --colour are of a --picture or a --movie")
    if still and options.output:
        parser.error("--output is of a report")
    if options.movie and options.time is not None:
        parser.error("a --movie shows all times")
    return options


def asked_of(options):
    """Returns what the page is asked to show in a picture."""
    return {name: getattr(options, name) for name in ("time", "view", "slice", "height", "colour")}


def usual_output(folders):
    """Returns where the report goes: into the folder of one run, of several into the folder that they share."""
    if len(folders) == 1:
        return folders[0] / "report.html"
    return pathlib.Path(os.path.commonpath([folder.resolve() for folder in folders])) / "report.html"


def main(description):
    """Writes the report; tells what is wrong in a line."""
    options = parse_arguments(description)
    try:
        runs = [Results(folder) for folder in options.folders]
        path = options.picture or options.movie or options.output or usual_output(options.folders)
        if options.picture:
            write_picture(runs[0], path, asked_of(options))
        elif options.movie:
            write_movie(runs[0], path, asked_of(options))
        else:
            write_page(runs, path)
    except ResultsError as error:
        print(f"report: {error}", file=sys.stderr)
        return 2
    print(f"{path} ({path.stat().st_size / 1e6:.1f} MB)")
    return 0
