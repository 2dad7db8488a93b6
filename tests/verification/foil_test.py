# SPDX-License-Identifier: BSD-3-Clause
"""A thin foil, NACA 0012 at a Reynolds number of 500 in a stream between slip sides: its lift by two ways of holding it.

Prints the tables of docs/validation/bodies.md. Arguments: cells a chord, by default 32 64 (a minute; 128 takes three more), or `places`:
at no angle, where the chord lies in its cells.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from tables import ARGUMENTS, command, print_record, print_record_head, read_columns

HALF = 0.5 * (1 - np.cos(np.linspace(0, np.pi, 61)))
THICK = 0.6 * (0.2969 * np.sqrt(HALF) - 0.126 * HALF - 0.3516 * HALF ** 2 + 0.2843 * HALF ** 3 - 0.1036 * HALF ** 4)
THICK[-1] = 0
BLUNT = 1.4 / 64  # chords: the thinner trailing edge of the blunt foil
WAYS = (("cut_stencil", 0.005), ("direct_forcing", 0.005), ("direct_forcing", 5e-4))
MOST_OFF, MOST_LIFT = 0.2, 0.03  # of the mean of both ways from 64 cells on; at no angle


def outline(least=0.0):
    """Corners of the foil, its chord from -1/2 to 1/2, at least so thick behind its nose."""
    thick = np.maximum(THICK, least / 2)
    thick[0] = 0
    upper = [(float(x) - 0.5, float(y)) for x, y in zip(HALF, thick)]
    lower = [(x, -y) for x, y in upper if y > 0]
    return ",".join(f"{x:.12g},{y:.12g}" for x, y in upper + lower[::-1])


def coefficients(method, tolerance, cells, degrees, shift=0.0, least=0.0, end=4):
    """Mean lift and drag coefficient over the last fifth of a run, and how much the lift spreads from step to step there."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(1, "-grid_cells", f"{3 * cells},{2 * cells}", "-grid_upper", "3,2", "-bc_x_lower", "inflow",
                               "-bc_x_lower_velocity", "1,0", "-bc_x_upper", "outflow", "-bc_y_lower", "slip", "-bc_y_upper", "slip",
                               "-fluid_density", 1, "-fluid_viscosity", 0.002, "-fluid_initial", "uniform", "-fluid_initial_velocity", "1,0",
                               "-bodies", "foil", "-foil_shape", "polygon", "-foil_vertices", outline(least), "-foil_center",
                               f"1,{1 + shift / cells}", "-foil_turn", -degrees, "-body_method", method, "-body_slip_tolerance", tolerance,
                               "-time_cfl", 0.5, "-time_end", end, "-output_interval", 100, "-output_dir", folder),
                       check=True, stdout=subprocess.DEVNULL)
        history = read_columns(Path(folder) / "history.csv")
    late = history["time"] > 0.8 * end
    lift = 2 * history["foil_force_y"][late]
    return lift.mean(), 2 * history["foil_force_x"][late].mean(), np.abs(np.diff(lift)).mean()


def at_an_angle(sizes):
    """The foil at ten degrees, and one whose trailing edge is blunt."""
    passed = True
    print_record_head("cells a chord", "way", "slip tolerance", "lift", "drag", "lift from step to step", "lift of the blunt foil")
    for cells in sizes:
        lifts = []
        for method, tolerance in WAYS:
            lift, drag, apart = coefficients(method, tolerance, cells, 10)
            blunt = coefficients(method, tolerance, cells, 10, least=BLUNT)[0]
            lifts.append(lift)
            print_record(cells, method, tolerance if method == "direct_forcing" else "", f"{lift:.3f}", f"{drag:.3f}", f"{apart:.4f}",
                         f"{blunt:.3f}", arguments=[str(cells)])
        passed &= cells < 64 or np.ptp(lifts) < MOST_OFF * np.mean(lifts)
    return passed


def places():
    """At no angle, with the chord on faces of cells and aside."""
    passed = True
    print_record_head("way", "cells aside", "lift", "drag")
    for method in ("cut_stencil", "direct_forcing"):
        for shift in (0, 0.25, 0.5):
            lift, drag, _ = coefficients(method, 5e-4, 32, 0, shift)
            print_record(method, shift, f"{lift:+.4f}", f"{drag:.3f}", arguments=["places"])
            passed &= abs(lift) < (MOST_LIFT if shift else 1e-6)
    return passed


if __name__ == "__main__":
    sys.exit(0 if (places() if ARGUMENTS == ["places"] else at_an_angle([int(word) for word in ARGUMENTS or ("32", "64")])) else 1)
