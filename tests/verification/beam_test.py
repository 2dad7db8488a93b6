# SPDX-License-Identifier: BSD-3-Clause
"""A beam held at its middle under its weight: each half against Bickley's heavy cantilever (thesis 3.5.2).

Prints the tables of docs/verification/beam.md. Argument: how many of the four grids, by default all. The error is the
root mean square distance of the right half's markers, middle one included, from the exact points at their arclengths k
ds from the support, over L = (n - 1/2) ds. The support is where the spring holds, the origin.
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from tables import ARGUMENTS, SOURCE, command, print_record, print_record_head, read_columns, scientific

RANKS = 1
EXACT = SOURCE / "tests" / "verification" / "reference" / "elastica"
# cells a side: markers on a half, error in the thesis
GRIDS = {65: (9, 5.21e-2), 129: (17, 8.5e-3), 257: (33, 3.2e-3), 513: (65, 1.9e-3)}
PULLED = 129
PULLS = (0.5, 1, 2, 5, 10)  # alpha_o
MOST_OFF_PULLED = GRIDS[PULLED][1]
BENDING_LENGTH, WEIGHT = 0.1 ** (1 / 3), 10  # c = (Kb/w)^(1/3) [m], w [N/m2]; L = 1 m
LEAST_ORDER = 1.3
MOST_UNEVEN = 1e-8  # between the halves, over L
NEVER_AT_REST = (513,)  # the water is too viscous there for the step; see docs/verification/beam.md
END_OF_RUN = 40  # -time_end: a run that gets there did not come to rest


def exact_points(alpha, arclengths):
    """Points of Bickley's cantilever, between those of the file by cubics that keep the slope."""
    table = np.genfromtxt(EXACT / f"bickley_b3_10_alpha_{alpha:g}.csv", delimiter=",", skip_header=2)
    s, slope = table[:, 0], np.column_stack([np.cos(table[:, 3]), np.sin(table[:, 3])])
    k = np.clip(np.searchsorted(s, arclengths) - 1, 0, len(s) - 2)
    step = (s[k + 1] - s[k])[:, None]
    t = (arclengths - s[k])[:, None] / step
    return ((1 + 2 * t) * (1 - t) ** 2 * table[k, 1:3] + t ** 2 * (3 - 2 * t) * table[k + 1, 1:3]
            + t * (1 - t) ** 2 * step * slope[k] - t ** 2 * (1 - t) * step * slope[k + 1])


def run_beam(cells, alpha):
    """Runs inputs/beam.opts to rest; returns its error, how uneven its halves are, its last time, and the wall time."""
    half, pull = GRIDS[cells][0], alpha * WEIGHT * BENDING_LENGTH
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        begin = time.monotonic()
        subprocess.run(command(RANKS, "-options_file", SOURCE / "inputs" / "beam.opts",
                               "-grid_cells", f"{cells},{cells}", "-beam_markers", 2 * half - 1,
                               "-beam_end_force_last", f"{pull},0", "-beam_end_force_first", f"{-pull},0",
                               "-output_dir", folder),
                       check=True, stdout=subprocess.DEVNULL)
        wall = time.monotonic() - begin
        table = np.genfromtxt(Path(folder) / "cloth_final.csv", delimiter=",", skip_header=2, usecols=(4, 5))
        last = read_columns(Path(folder) / "history.csv")["time"][-1]
    right, left = table[half - 1:], table[half - 1::-1] * [-1, 1]
    off = right - exact_points(alpha, np.arange(half) / (half - 0.5))
    return np.sqrt(np.mean(np.sum(off ** 2, axis=1))), np.abs(right - left).max(), last, wall


def rest(last):
    """When a run came to rest, by its last time."""
    return f"{last:.1f}" if last < END_OF_RUN - 1 else f"not within {last:.0f}"


def fitted_order(grids, errors):
    """Slope of log error over log cell size, by least squares."""
    return -np.polyfit(np.log(grids), np.log(errors), 1)[0]


def main():
    passed, errors = True, []
    print_record_head("cells", "markers on a half", "rms error/L", "order", "thesis", "at rest after [s]", "wall [s]")
    grids = list(GRIDS)[:int(ARGUMENTS[0]) if ARGUMENTS else None]
    for cells in grids:
        half, thesis = GRIDS[cells]
        error, uneven, last, wall = run_beam(cells, 0)
        errors.append(error)
        order = f"{fitted_order(grids[len(errors) - 2:len(errors)], errors[-2:]):.2f}" if len(errors) > 1 else ""
        print_record(f"{cells} x {cells}", half, scientific(error), order, scientific(thesis), rest(last),
                     f"{wall:.0f}")
        passed &= error <= thesis and uneven <= MOST_UNEVEN and (last < END_OF_RUN - 1 or cells in NEVER_AT_REST)
    if len(grids) > 1:
        order = fitted_order(grids, errors)
        print(f"\nOrder fitted over these grids: {order:.2f}\n")
        passed &= order >= LEAST_ORDER
    print_record_head("alpha_o", "rms error/L")
    for alpha in PULLS:
        error, uneven, last, _ = run_beam(PULLED, alpha)
        print_record(alpha, scientific(error))
        passed &= error <= MOST_OFF_PULLED and uneven <= MOST_UNEVEN and last < END_OF_RUN - 1
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
