# SPDX-License-Identifier: BSD-3-Clause
"""Flags in a stream: free end, drag and lift against the curves of others.

In the plane Huang, Shin and Sung (2007) and de Tullio and Pascazio (2016), in space Huang and Sung (2010) and Lee and Choi.
Prints the tables of docs/validation/flag.md. Arguments, by default 512 (h = L/64): cells a side of the box of 8 L, and, after
a colon, markers on L; or 3d. Then, after a colon, nodal for the lattice whose first and last marker lie at the ends of L, by
default a cell apart: 512:nodal, 512:77:nodal. On the centred one the free end lies half a spacing beyond the last marker; in space
it is the middle of the trailing edge. Fails where frequency, swing, drag or one of the first ten extrema is farther off than the bounds say.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tables import (ARGUMENTS, SOURCE, Miss, agrees, command, is_small, print_record, print_record_head, print_row,
                    read_columns, read_markers)

RANKS = 2
EXTREMA = 10


class Bounds(NamedTuple):
    """Relative ones of frequency, swing and mean drag, or known misses; absolute ones of an extremum's height [L] and time [L/U]."""
    frequency: float | Miss
    swing: float | Miss
    drag: float | Miss
    height: float | Miss = np.inf
    time: float | Miss = np.inf


class Flag(NamedTuple):
    """A case and what others find of it; from `settled` on [L/U] it swings steadily."""
    dimension: int
    input: str
    extrema: str
    frequency: float
    swing: float
    drag: float
    lift: float
    settled: float
    bounds: dict  # by the cells on L

    def expected_extrema(self):
        return np.loadtxt(SOURCE / "tests" / "verification" / "reference" / "flag" / self.extrema, delimiter=",").T


PLANE = Flag(2, "flag.opts", "plane.csv", 0.310, 0.68, 0.72, 1.61, 18,
             {32: Bounds(0.03, Miss(0.782), 0.10, Miss(0.043, 0.15), Miss(0.31, 0.15)),
              64: Bounds(Miss(0.317, 0.02), Miss(0.797), 0.04, Miss(0.053, 0.15), 0.2)})
SPACE = Flag(3, "flag3d.opts", "space.csv", 0.263, 0.765, 0.55, 0.84, 8, {32: Bounds(Miss(0.252, 0.02), 0.08, Miss(0.685))})


def start(lattice, size):
    """The hinge, the first row of markers, is at the origin and the free end 1 L from it."""
    middle = 0.5 if lattice == "nodal" else 1 - 0.5 * size
    return ["-flag_lattice", lattice, "-flag_size", size], (middle * np.cos(0.1 * np.pi), middle * np.sin(0.1 * np.pi))


def plane_options(cells, lattice, markers):
    """So many cells a side of the box."""
    markers = int(markers or cells // 8 + (lattice == "nodal"))
    options, middle = start(lattice, 1 if lattice == "nodal" else markers / (markers - 0.5))
    return ["-grid_cells", f"{cells},{cells}", "-flag_markers", markers, *options, "-flag_center", "{},{}".format(*middle)]


def space_options(lattice):
    """The input has the centred lattice."""
    if lattice == "centred":
        return []
    options, middle = start(lattice, 1)
    return ["-flag_markers", "33,33", *options, "-flag_center", "{},0,{}".format(*middle)]


def extrema(time, height):
    """Times and heights of the local extrema, by a parabola through each and its neighbours."""
    at = 1 + np.flatnonzero(np.diff(height)[:-1] * np.diff(height)[1:] < 0)
    before, here, after = height[at - 1], height[at], height[at + 1]
    off = 0.5 * (before - after) / (before - 2 * here + after)
    return time[at] + off * (time[at + 1] - time[at]), here - 0.25 * (before - after) * off


def free_end(flag, lattice, folder):
    """Times, and heights of the free end."""
    time, markers = read_markers(folder, flag.dimension)
    across = 1 if flag.dimension == 2 else round(np.sqrt(markers.shape[1]))
    rows = markers.reshape(len(time), -1, across, flag.dimension)
    middle = rows[:, :, [(across - 1) // 2, across // 2]].mean(axis=2)
    overhang = 0 if lattice == "nodal" else 0.5
    return time, ((1 + overhang) * middle[:, -1] - overhang * middle[:, -2])[:, -1]


def late(flag, times, heights, history):
    """Frequency, peak to peak, mean drag and largest lift once it is settled."""
    settled = times >= flag.settled
    steps = history["time"] >= flag.settled
    force = [2 * history[f"flag_water_force_{axis}"][steps] for axis in ("x", "xyz"[flag.dimension - 1])]
    return (0.5 / np.diff(times[settled]).mean(), np.abs(np.diff(heights[settled])).mean(), force[0].mean(),
            np.abs(force[1]).max())


def evaluate(flag, cells_on_length, lattice, folder):
    """What a row of the table says of a run, and whether it is within the bounds."""
    history = read_columns(Path(folder) / "history.csv")
    wall = json.loads((Path(folder) / "summary.json").read_text(encoding="utf-8"))["wall_seconds"]
    times, heights = extrema(*free_end(flag, lattice, folder))
    frequency, swing, drag, lift = late(flag, times, heights, history)
    expected_times, expected_heights = flag.expected_extrema()
    count = min(EXTREMA, len(times))
    off = np.abs(heights - np.resize(expected_heights, len(heights)))[:count].max(), \
        np.abs(times - np.resize(expected_times, len(times)))[:count].max()
    bounds = flag.bounds[cells_on_length]
    passed = (agrees(frequency, flag.frequency, bounds.frequency) and agrees(swing, flag.swing, bounds.swing)
              and agrees(drag, flag.drag, bounds.drag) and is_small(off[0], bounds.height) and is_small(off[1], bounds.time))
    return (f"{history['dt'][-1]:g}", f"{frequency:.3f}", f"{swing:.3f}", f"{drag:.3f}", f"{lift:.2f}",
            f"{off[0]:.3f}, {off[1]:.2f}", f"{100 * history['cloth_slip'].mean():.1f} %",
            f"{100 * history['flag_max_stretch'].max():.1f} %", f"{wall:.0f}"), passed


def run(word):
    """Prints the row of one argument; returns whether it is within the bounds."""
    cells, *rest = word.split(":")
    lattice = "nodal" if "nodal" in rest else "centred"
    markers = rest[0] if rest and rest[0] != "nodal" else None
    flag = SPACE if cells == "3d" else PLANE
    cells_on_length = 32 if flag is SPACE or int(cells) < 512 else 64
    options = space_options(lattice) if flag is SPACE else plane_options(int(cells), lattice, markers)
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(RANKS, "-options_file", SOURCE / "inputs" / flag.input, *options, "-output_interval",
                               0.05, "-output_dir", folder), check=True, stdout=subprocess.DEVNULL)
        figures, passed = evaluate(flag, cells_on_length, lattice, folder)
    print_record(word, *figures, arguments=[word])
    return passed


def main():
    words = ARGUMENTS or ["512"]
    print_record_head("cells : markers", "step [L/U]", "f L/U", "peak to peak/L", "C_D", "C_L", "extrema off by [L], [L/U]",
                      "slip", "largest stretch", "wall [s]")
    for flag in (PLANE, SPACE):
        if any(word.startswith("3d") == (flag is SPACE) for word in words):
            print_row("reference", "", flag.frequency, flag.swing, flag.drag, flag.lift, *[""] * 6)
    return 0 if all([run(word) for word in words]) else 1


if __name__ == "__main__":
    sys.exit(main())
