# SPDX-License-Identifier: BSD-3-Clause
"""A cylinder that oscillates in water at rest: first harmonic of the force against Stokes' solution.

Prints the table of docs/validation/cylinder.md. Arguments: method or method:cells, by default mapping cut_stencil; cells
are those of a side, by default 512, and the step grows with their width. The harmonic is that of the last two of five
periods, by the forcing and by the balance of momentum.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from tables import ARGUMENTS, SOURCE, command, print_record, print_record_head, read_columns

RANKS = 2
DIAMETER, SPEED, FREQUENCY, VISCOSITY, DENSITY = 1, 0.3, 1, 0.05, 1
OMEGA = 2 * np.pi * FREQUENCY
PERIODS_SEEN = 2
CELLS, STEP = 512, 5e-3  # of inputs/oscillating_cylinder.opts
# of the part, for each of both, on that grid
MOST_OFF = {"mapping": 0.05, "ghost": 0.05, "cut_stencil": 0.03, "direct_forcing": 0.03}


def bessel_k(order, z):
    """Modified Bessel function of the second kind, Re z > 0, by its integral over exp(-z cosh t) cosh(order t)."""
    t, step = np.linspace(0, 12, 200001, retstep=True)
    values = np.exp(-z * np.cosh(t)) * np.cosh(order * t)
    return step * (values.sum() - 0.5 * (values[0] + values[-1]))


def stokes():
    """Force in phase with the velocity U sin(w t) and in phase with the acceleration [N/m] (Stokes 1851)."""
    z = DIAMETER / 2 * np.sqrt(1j * OMEGA / VISCOSITY)
    factor = 1 + 4 * bessel_k(1, z) / (z * bessel_k(0, z))
    scale = DENSITY * np.pi * DIAMETER ** 2 / 4 * OMEGA * SPEED
    return scale * factor.imag, -scale * factor.real


def first_harmonic(history, column, dt):
    """The same of a computed force. Loads are means over a step, so they belong to its middle."""
    time = history["time"] - 0.5 * dt
    last = history["time"] > history["time"][-1] - PERIODS_SEEN / FREQUENCY + 0.5 * dt
    force = history[column][last]
    return 2 * np.mean(force * np.sin(OMEGA * time[last])), 2 * np.mean(force * np.cos(OMEGA * time[last]))


def harmonics(method, cells):
    """Runs the case; returns the first harmonic by each way to measure the load."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(RANKS, "-options_file", SOURCE / "inputs" / "oscillating_cylinder.opts",
                               "-body_method", method, "-grid_cells", f"{cells},{cells}", "-time_step", STEP * CELLS / cells,
                               "-output_dir", folder),
                       check=True, stdout=subprocess.DEVNULL)
        history = read_columns(Path(folder) / "history.csv")
    return [(way, first_harmonic(history, column, history["dt"][-1]))
            for way, column in (("forcing", "cylinder_force_x"), ("balance", "cylinder_balance_force_x")) if column in history]


def main():
    cases, passed, exact = ARGUMENTS or ["mapping", "cut_stencil"], True, stokes()
    print_record_head("method", "cells a side", "loads by", "with the velocity", "over exact", "with the acceleration",
                      "over exact")
    print_record("Stokes", "", "", f"{exact[0]:.4f}", "1", f"{exact[1]:.4f}", "1")
    for case in cases:
        method, cells = case.split(":") if ":" in case else (case, CELLS)
        for way, found in harmonics(method, int(cells)):
            parts = [f"{part:.4f} | {part / right:.3f}" for part, right in zip(found, exact)]
            print_record(method, cells, way, *parts, arguments=[case])
            passed &= int(cells) != CELLS or max(abs(np.divide(found, exact) - 1)) <= MOST_OFF[method]
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
