# SPDX-License-Identifier: BSD-3-Clause
"""The command scripts/report."""

import argparse
import os
import pathlib
import sys

from washfsi.errors import ResultsError
from washfsi.report.page import write_page
from washfsi.results import Results


def parse_arguments(description):
    """Returns the command line's options."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", metavar="OUT", type=pathlib.Path, nargs="+",
                        help="output folder of a run, or of a -check")
    parser.add_argument("--output", metavar="FILE.html", type=pathlib.Path,
                        help="the report (default: report.html in OUT, or where the folders OUT are)")
    return parser.parse_args()


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
        path = options.output or usual_output(options.folders)
        write_page(runs, path)
    except ResultsError as error:
        print(f"report: {error}", file=sys.stderr)
        return 2
    print(f"{path} ({path.stat().st_size / 1e6:.1f} MB)")
    return 0
