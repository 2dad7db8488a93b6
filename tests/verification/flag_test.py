# SPDX-License-Identifier: BSD-3-Clause
"""A flag in a stream (Huang, Shin and Sung 2007): amplitude of its free end and Strouhal number.

Prints the table of docs/verification/flag.md. Arguments: numbers of cells a side, by default 256. Swings of the last
marker are taken once it flaps steadily. Fails when it does not, when the flag stretches, or when amplitude or frequency
are off those that docs/verification/flag.md records for 256 cells.
"""

import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tables import ARGUMENTS, SOURCE, command, print_record, print_record_head, read_columns, read_markers

RANKS = 2
LENGTH = 1  # [m] from the first marker, where the hinge is, to the free end
SETTLED = 12  # [s] by then the flapping is periodic
STEPS = {128: 8e-3, 256: 4e-3, 512: 2e-3}
MOST_UNEVEN = 0.1  # of the mean swing: its standard deviation
MOST_STRETCH = 0.01
RECORDED = {"amplitude": (1.0, 1.3), "strouhal": (0.26, 0.31)}


class Flapping(NamedTuple):
    """Peak to peak amplitude over L and its unevenness, Strouhal number, periods seen, largest stretch."""
    amplitude: float
    uneven: float
    strouhal: float
    periods: int
    stretch: float


def flag_options(cells):
    """The size keeps hinge and free end LENGTH apart: the hinge is half a spacing inside the cloth's end."""
    markers = cells // 8
    size = LENGTH * markers / (markers - 0.5)
    middle = 0.5 * size * (1 - 1 / markers)
    direction = np.cos(0.1 * np.pi), np.sin(0.1 * np.pi)
    return ["-grid_cells", f"{cells},{cells}", "-flag_markers", markers, "-flag_size", size,
            "-flag_center", f"{middle * direction[0]},{middle * direction[1]}", "-time_step", STEPS[cells]]


def peaks(values):
    """Heights of the local maxima, by a parabola through each and its neighbours."""
    top = 1 + np.flatnonzero((values[1:-1] > values[:-2]) & (values[1:-1] >= values[2:]) & (values[1:-1] > 0))
    before, at, after = values[top - 1], values[top], values[top + 1]
    return at + 0.125 * (after - before) ** 2 / (2 * at - before - after)


def flapping(time, markers, spacing):
    """What the free end does once it has settled."""
    late = time >= SETTLED
    time, tip = time[late], markers[late, -1, 1]
    rises = np.flatnonzero((tip[:-1] < 0) & (tip[1:] >= 0))
    crossings = time[rises] - tip[rises] * (time[rises + 1] - time[rises]) / (tip[rises + 1] - tip[rises])
    high, low = peaks(tip), peaks(-tip)
    swings = high[:min(len(high), len(low))] + low[:min(len(high), len(low))]
    edges = np.linalg.norm(np.diff(markers[late], axis=1), axis=2)
    return Flapping(swings.mean() / LENGTH, swings.std() / swings.mean(), LENGTH / np.diff(crossings).mean(),
                    len(crossings) - 1, edges.max() / spacing - 1)


def agrees(found):
    """Whether the flag flaps as recorded."""
    values = found._asdict()
    return (found.periods >= 3 and found.uneven <= MOST_UNEVEN and found.stretch <= MOST_STRETCH
            and all(low <= values[name] <= high for name, (low, high) in RECORDED.items()))


def main():
    passed = True
    print_record_head("cells", "step [L/U]", "amplitude/L, peak to peak", "varies by", "f L/U", "largest stretch",
                      "mean slip")
    for cells in [int(word) for word in ARGUMENTS] or [256]:
        with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
            subprocess.run(command(RANKS, "-options_file", SOURCE / "inputs" / "flag.opts", *flag_options(cells),
                                   "-output_dir", folder), check=True, stdout=subprocess.DEVNULL)
            time, markers = read_markers(folder)
            history = read_columns(Path(folder) / "history.csv")
        found = flapping(time, markers, LENGTH / (cells // 8 - 0.5))
        slip = history["cloth_slip"][history["time"] >= SETTLED].mean()
        print_record(f"{cells} x {cells}", f"{history['dt'][0]:.3g}", f"{found.amplitude:.2f}",
                     f"{100 * found.uneven:.0f} %", f"{found.strouhal:.3f}", f"{100 * found.stretch:.1f} %",
                     f"{100 * slip:.1f} %", arguments=[cells])
        passed &= agrees(found)
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
