# SPDX-License-Identifier: BSD-3-Clause
"""A flag in a stream: its free end, drag and lift against Huang, Shin and Sung (2007) and de Tullio and Pascazio (2016).

Prints the tables of docs/verification/flag.md. Arguments: cells a side of the box of 8 L, by default 512 (h = L/64). The free
end lies half a spacing beyond the last marker. Fails where frequency, swing, drag or one of the first ten extrema is
farther off than BOUNDS says.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tables import ARGUMENTS, SOURCE, command, print_record, print_record_head, read_columns, read_markers

RANKS = 2
REFERENCE = SOURCE / "tests" / "verification" / "reference" / "flag" / "plane.csv"
FREQUENCY, SWING, DRAG = 0.310, 0.68, 0.72
SETTLED = 18  # [L/U]
EXTREMA = 10
STEP = 4e-3


class Bounds(NamedTuple):
    """Relative ones of frequency, swing and mean drag; absolute ones of an extremum's height [L] and time [L/U]."""
    frequency: float
    swing: float
    drag: float
    height: float
    time: float


BOUNDS = {512: Bounds(0.02, 0.06, 0.10, 0.03, 0.2), 256: Bounds(0.03, 0.09, 0.10, 0.03, 0.2)}


def flag_options(cells):
    """The size keeps the hinge, the first marker, and the free end 1 L apart."""
    markers = cells // 8
    size = markers / (markers - 0.5)
    middle = 0.5 * size * (1 - 1 / markers)
    direction = np.cos(0.1 * np.pi), np.sin(0.1 * np.pi)
    return ["-grid_cells", f"{cells},{cells}", "-flag_markers", markers, "-flag_size", size,
            "-flag_center", f"{middle * direction[0]},{middle * direction[1]}", "-time_step", STEP]


def extrema(time, height):
    """Times and heights of the local extrema, by a parabola through each and its neighbours."""
    at = 1 + np.flatnonzero(np.diff(height)[:-1] * np.diff(height)[1:] < 0)
    before, here, after = height[at - 1], height[at], height[at + 1]
    off = 0.5 * (before - after) / (before - 2 * here + after)
    return time[at] + off * (time[at + 1] - time[at]), here - 0.25 * (before - after) * off


def read_run(folder):
    """Times and heights of the free end, and the history."""
    time, markers = read_markers(folder)
    end = 1.5 * markers[:, -1] - 0.5 * markers[:, -2]
    return time, end[:, 1], read_columns(Path(folder) / "history.csv")


def late(times, heights, history):
    """Frequency, peak to peak, mean drag and largest lift after SETTLED."""
    settled = times >= SETTLED
    swings = np.abs(np.diff(heights[settled]))
    steps = history["time"] >= SETTLED
    return (0.5 / np.diff(times[settled]).mean(), swings.mean(), 2 * history["flag_water_force_x"][steps].mean(),
            2 * np.abs(history["flag_water_force_y"][steps]).max())


def main():
    passed = True
    expected_times, expected_heights = np.loadtxt(REFERENCE, delimiter=",").T
    print_record_head("cells", "step [L/U]", "f L/U", "peak to peak/L", "C_D", "C_L", "extrema off by [L], [L/U]",
                      "slip", "largest stretch", "wall [s]")
    print("| reference |  | 0.310 | 0.68 | 0.72 | 1.61 |  |  |  |  |  |  |")
    for cells in [int(word) for word in ARGUMENTS] or [512]:
        with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
            subprocess.run(command(RANKS, "-options_file", SOURCE / "inputs" / "flag.opts", *flag_options(cells),
                                   "-output_interval", 0.05, "-output_dir", folder), check=True,
                           stdout=subprocess.DEVNULL)
            time, height, history = read_run(folder)
            wall = json.loads((Path(folder) / "summary.json").read_text(encoding="utf-8"))["wall_seconds"]
        times, heights = extrema(time, height)
        frequency, swing, drag, lift = late(times, heights, history)
        off = (np.abs(heights[:EXTREMA] - expected_heights[:EXTREMA]).max(),
               np.abs(times[:EXTREMA] - expected_times[:EXTREMA]).max())
        print_record(f"{cells} x {cells}", STEP, f"{frequency:.3f}", f"{swing:.3f}", f"{drag:.3f}", f"{lift:.2f}",
                     f"{off[0]:.3f}, {off[1]:.2f}", f"{100 * history['cloth_slip'].mean():.1f} %",
                     f"{100 * history['flag_max_stretch'].max():.1f} %", f"{wall:.0f}", arguments=[cells])
        bounds = BOUNDS.get(cells, BOUNDS[256])
        passed &= (abs(frequency / FREQUENCY - 1) <= bounds.frequency and abs(swing / SWING - 1) <= bounds.swing
                   and abs(drag / DRAG - 1) <= bounds.drag and off[0] <= bounds.height and off[1] <= bounds.time)
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
