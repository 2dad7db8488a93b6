# SPDX-License-Identifier: BSD-3-Clause
"""The command scripts/plot."""

import argparse
import pathlib
import sys

import numpy as np

from washfsi.errors import ResultsError
from washfsi.plot.history import draw_history
from washfsi.plot.movie import make_movie
from washfsi.plot.perspective import draw_perspective
from washfsi.plot.phases import draw_phases
from washfsi.plot.scene import choose_frames, read_scene, vorticity_limit
from washfsi.plot.snapshot import draw_snapshot
from washfsi.plot.statistics import draw_statistics
from washfsi.plot.style import save
from washfsi.plot.tracks import draw_tracks
from washfsi.results import Results


def parse_arguments(description):
    """Returns the command line's options."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("folder", metavar="OUT", type=pathlib.Path, help="output folder of a run, or of a -check")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--time", type=float, help="draw the frame nearest to this time [s]")
    which.add_argument("--frame", type=int, help="draw this frame (default: the last)")
    which.add_argument("--all", action="store_true", help="draw every frame, a snapshot each")
    parser.add_argument("--movie", metavar="FILE.mp4", type=pathlib.Path, help="make a movie of all frames")
    parser.add_argument("--history", metavar="COLUMN,...", help="draw these columns, a panel each")
    parser.add_argument("--output", metavar="FILE.png", type=pathlib.Path, help="snapshot's name")
    options = parser.parse_args()
    if options.all and options.output:
        raise ResultsError("--output names a single snapshot, so it does not go with --all")
    return options


def plot_frames(results, options):
    """Writes the snapshots asked for, all with the same limits of colour."""
    numbers = choose_frames(results.flow.times, options)
    limit = np.median([vorticity_limit(read_scene(results, number)) for number in numbers])
    for number in numbers:
        scene, time = read_scene(results, number), f"{results.flow.times[number]:.4f}"
        if scene.dim == 3:
            save(draw_perspective(scene), results.folder / f"perspective_{time}.png", tight=False)
        save(draw_snapshot(scene, limit), options.output or results.folder / f"snapshot_{time}.png")


def plot(options):
    """Writes all pictures. A folder of a dry run has a start and no history."""
    results = Results(options.folder).in_step()
    design = not (results.folder / "history.csv").exists() and len(results.flow) == 1
    figure = None if design and not options.history else draw_history(results.history, results.case, options.history)
    plot_frames(results, options)
    if figure is None:
        print("no history: this is the design before the run")
    else:
        save(figure, results.folder / "history.png")
        tracks = draw_tracks(results)
        if tracks:
            save(tracks, results.folder / "tracks.png")
    if (results.folder / "statistics.csv").is_file():
        save(draw_statistics(results.statistics, results.case), results.folder / "statistics.png")
    if (results.folder / "phases.h5").is_file():
        save(draw_phases(results.phases, results.case), results.folder / "phases.png")
    if options.movie:
        make_movie(results, options.movie)


def main(description):
    """Draws the pictures; tells what is wrong in a line."""
    try:
        plot(parse_arguments(description))
    except ResultsError as error:
        print(f"plot: {error}", file=sys.stderr)
        return 2
    return 0
