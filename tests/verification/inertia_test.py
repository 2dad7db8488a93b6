# SPDX-License-Identifier: BSD-3-Clause
"""Cloth that carries its own mass, from none to far more than the water's.

Prints the tables of docs/validation/inertia.md. First, the flag of inputs/flag.opts for 2 L/U at a CFL number of 0.3 with excess
masses from 0 to 100 rho_f L: the slip after fifty steps, and what is left of the balance of its momentum. Second, a square
sheet of 10 kg/m2 let go in a box of water, flat and edgewise: its speed after 0.1 s beside that of a thin plate with its added
mass, and that of a wide plate between Stokes layers. Arguments, by default both: masses, sheet. Fails where slip or balance are
beyond their bounds, or what a flat sheet moves, extrapolated to cells of no width, is farther off than FLAT.
"""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from tables import SOURCE, command, print_record, print_record_head, read_columns, run_tables, scientific

RANKS = 2
MASSES = 0, 0.01, 0.1, 1, 10, 100
SLIP, BALANCE, FLAT = 0.02, 0.01, 0.10
GRAVITY = 9.81
SIDE, MASS, WATER = 0.16, 10, 1000  # of the sheet [m, kg/m2], of the water [kg/m3]


def history_of(*options):
    """Runs the program; returns its history."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(RANKS, *options, "-output_interval", 10, "-output_dir", folder), check=True,
                       stdout=subprocess.DEVNULL)
        return read_columns(Path(folder) / "history.csv")


def unbalanced(history, mass):
    """Impulse of water, springs and weight less the momentum at the end, over the largest impulse of one of them."""
    steps, length = history["dt"], 32 / 31.5
    impulses, last = [], []
    for axis in "xy":
        weight = 0.5 * mass * length if axis == "x" else 0
        parts = [history[f"flag_{part}_force_{axis}"] for part in ("water", "hold")]
        velocity = np.diff(history[f"flag_center_{axis}"]) / steps[1:]
        impulses.append([np.sum(part * steps) for part in parts] + [weight * steps.sum()])
        last.append(mass * length * (1.5 * velocity[-1] - 0.5 * velocity[-2]))
    return np.linalg.norm(np.sum(impulses, axis=1) - last) / np.abs(impulses).max()


def masses():
    """Prints the table of masses; returns whether all are within the bounds."""
    print_record_head("mass over rho_f L", "steps", "largest slip after 50 steps", "momentum left over")
    passed = True
    for mass in MASSES:
        history = history_of("-options_file", SOURCE / "inputs" / "flag.opts", "-flag_excess_mass", mass, "-time_cfl",
                             0.3, "-time_step", 0.01, "-time_end", 2)
        slip, left = history["cloth_slip"][50:].max(), unbalanced(history, mass)
        print_record(mass, len(history["time"]), f"{100 * slip:.1f} %", f"{100 * left:.2f} %", arguments=["masses"])
        passed &= slip <= SLIP and left <= BALANCE
    return passed


def sheet_options(cells_on_side, direction, viscosity):
    """A stiff sheet in the middle of a box four times as wide."""
    cells, markers = 4 * cells_on_side, 3 * cells_on_side // 4
    edgewise = direction == "edgewise"
    return ["-grid_cells", f"{cells},{cells},{cells}", "-grid_lower", "-0.32,-0.32,-0.32", "-grid_upper", "0.32,0.32,0.32",
            "-fluid_density", WATER, "-fluid_viscosity", viscosity, "-gravity", f"0,0,{-GRAVITY}", "-cloths", "sheet",
            "-sheet_size", f"{SIDE},{SIDE}", "-sheet_markers", f"{markers},{markers}", "-sheet_excess_mass", MASS,
            "-sheet_direction", "0,0,1" if edgewise else "1,0,0", "-sheet_across", "0,1,0", "-sheet_center", "0,0,0",
            "-sheet_ke", 1e4, "-sheet_kb", 0.2, "-contact", "none", "-coupling_order", 2, "-time_step", 1e-3, "-time_end", 0.1]


def plate_speed(direction, viscosity, time):
    """In a wide box: a square plate moving normally has the added mass 0.579 pi/4 rho a^3; Stokes' layers on a wide one."""
    if direction == "flat":
        added = 0.579 * math.pi / 4 * WATER * SIDE
        return GRAVITY * time * MASS / (MASS + added)
    b = 2 * math.sqrt(WATER * viscosity) / MASS
    return GRAVITY / b**2 * (math.exp(b**2 * time) * math.erfc(b * math.sqrt(time)) - 1 + 2 * b * math.sqrt(time / math.pi))


def drop(direction, viscosity, cells):
    """Prints the row of a sheet with so many cells on its side; returns its mass in units of the plate's."""
    history = history_of(*sheet_options(cells, direction, viscosity))
    speed = -np.diff(history["sheet_center_z"])[-1] / history["dt"][-1]
    expected = plate_speed(direction, viscosity, 0.1)
    print_record(direction, scientific(viscosity, 0), cells, f"{speed:.4f}", f"{expected:.4f}", f"{expected / speed:.2f}",
                 arguments=["sheet"])
    return expected / speed


def sheet():
    """Prints the table of the sheet; returns whether the flat one moves its added mass."""
    print_record_head("moves", "viscosity [Pa s]", "cells on its side", "speed at 0.1 s [m/s]", "thin plate [m/s]",
                      "mass moved over the plate's")
    passed = True
    for direction, viscosity in (("flat", 1e-3), ("edgewise", 1e-3), ("edgewise", 1)):
        moved = [drop(direction, viscosity, cells) for cells in (16, 32)]
        print_record(direction, scientific(viscosity, 0), "extrapolated", "", "", f"{2 * moved[1] - moved[0]:.2f}",
                     arguments=["sheet"])
        passed &= direction == "edgewise" or abs(2 * moved[1] - moved[0] - 1) <= FLAT
    return passed


def main():
    return run_tables({"masses": masses, "sheet": sheet})


if __name__ == "__main__":
    sys.exit(main())
