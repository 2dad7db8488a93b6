# SPDX-License-Identifier: BSD-3-Clause
"""Taylor and Green's vortices in space: dissipation at Re = 1600, and the energy that schemes gain or lose without viscosity.

Prints the tables of docs/validation/turbulence.md. Arguments: cells a side, by default 64; without viscosity half as many;
`inviscid`: that table alone.
The box has 2 pi a side, so lengths and speeds are those of the vortices; energies are per mass. Reference: the peak of the
dissipation -dE/dt is 0.01286 at t = 8.97.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from tables import ARGUMENTS, command, print_head, print_origin, print_row, read_columns, scientific

SIDE = 2 * np.pi
REFERENCE_PEAK, REFERENCE_TIME = 0.01286, 8.97
SCHEMES = ("central", "wide_central", "upwind")
MOST_DRIFT = {("central", 3): 0.001, ("central", 2): 0.01, ("wide_central", 3): 0.1}  # of the energy, by advection and its steps
MOST_OFF = {"central": 0.1, "wide_central": 0.05, "upwind": 0.5}  # of the peak, on 64 cells


def energies(cells, end, courant, *options):
    """Runs the vortices; returns times and kinetic energies, and the seconds a step took."""
    sides = [word for axis in "xyz" for end in ("lower", "upper") for word in (f"-bc_{axis}_{end}", "periodic")]
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(1, "-grid_cells", f"{cells},{cells},{cells}", "-grid_lower", "0,0,0", "-grid_upper",
                               f"{SIDE!r},{SIDE!r},{SIDE!r}", *sides, "-fluid_density", 1, "-fluid_initial", "taylor_green_3d",
                               "-time_cfl", courant, "-time_step", 0.1, "-time_end", end, "-output_interval", 100,
                               "-checkpoint_interval", 100, *options, "-output_dir", folder),
                       check=True, stdout=subprocess.DEVNULL)
        history = read_columns(Path(folder) / "history.csv")
        summary = json.loads((Path(folder) / "summary.json").read_text(encoding="utf-8"))
    return history["time"], history["kinetic_energy"] / SIDE ** 3, summary["seconds_per_step"]


def peak_of(time, energy):
    """Returns the largest rate of loss of energy and its time, and all that was lost until t = 5."""
    loss = -np.gradient(energy, time)
    late = time > 1  # the start, where a step without history is of first order, counts for nothing
    best = np.flatnonzero(late)[loss[late].argmax()]
    return loss[best], time[best], 0.125 - np.interp(5, time, energy)


def judge_viscous(cells):
    """Prints the dissipation at Re = 1600; returns whether its peak is right."""
    passed = True
    print_head("advection", "cells", "peak of -dE/dt", "off", "at t", "lost until t = 5", "s a step")
    for scheme in SCHEMES:
        time, energy, seconds = energies(cells, 10, 0.5, "-fluid_viscosity", 1 / 1600, "-advection", scheme)
        peak, when, early = peak_of(time, energy)
        print_row(f"`{scheme}`", f"{cells}³", f"{peak:.5f}", f"{100 * (peak / REFERENCE_PEAK - 1):+.1f} %", f"{when:.2f}",
                  f"{early:.5f}", f"{seconds:.2f}")
        passed &= cells < 64 or abs(peak / REFERENCE_PEAK - 1) <= MOST_OFF[scheme]
    print_row("reference", "", f"{REFERENCE_PEAK}", "", f"{REFERENCE_TIME}", "", "")
    return passed


def judge_inviscid(cells):
    """Prints what the energy changes by without viscosity; returns whether it stays."""
    passed = True
    print_head("advection", "steps", "cells", "CFL", "change of energy until t = 12, of the start's", "the most until then", "s a step")
    for scheme, steps, courant in (("central", 3, 0.5), ("central", 3, 0.25), ("central", 2, 0.5), ("central", 2, 0.25),
                                   ("wide_central", 3, 0.5)):
        _, energy, seconds = energies(cells, 12, courant, "-fluid_viscosity", 0, "-advection", scheme, "-advection_steps", steps)
        drift, most = energy[-1] / 0.125 - 1, abs(energy / 0.125 - 1).max()
        print_row(f"`{scheme}`", steps, f"{cells}³", courant, scientific(drift), scientific(most), f"{seconds:.3f}")
        passed &= abs(drift) < MOST_DRIFT[scheme, steps]
    return passed


def main():
    cells = int(next((word for word in ARGUMENTS if word.isdigit()), 64))
    print_origin()
    passed = "inviscid" in ARGUMENTS or judge_viscous(cells)
    print()
    return 0 if judge_inviscid(cells // 2) and passed else 1


if __name__ == "__main__":
    sys.exit(main())
