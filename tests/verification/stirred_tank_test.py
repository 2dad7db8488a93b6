# SPDX-License-Identifier: BSD-3-Clause
"""A Rushton turbine in a baffled tank: its power number, and what must not matter to it.

Prints the tables of docs/validation/stirred_tank.md. Arguments: grids (cells a side, by default 48 64), or `places`: 48
cells, the turbine shifted by a quarter and half a cell along z, by half a cell along x, turned by 15 and 30 degrees. Means are over the
half turn from t = 0.1 to 0.2 s after an impulsive start. Or `water` and grids: at Re = 5e4, with an eddy viscosity and a law for friction;
means are over the second turn. Or `heights` and grids: the same with the disc at several heights above a row of faces.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

from tables import ARGUMENTS, SOURCE, command, print_record, print_record_head, read_columns

SPEED, DIAMETER, DENSITY, TURNS_A_SECOND = 31.41592653589793, 0.1, 1000, 5
START, END, CLEARANCE, COARSE = 0.1, 0.2, 0.1, 48
WIDTH, HEIGHT = 0.32, 0.3  # of the box [m]
MOST_APART = 0.03          # of the mean power number, between places
BAND = (3.5, 4.5)          # at Re = 100: Rushton, Costich and Everett
WATER_BAND = (4.6, 6.0)    # at Re = 5e4; thin blades have more than thick ones
MOST_APART_IN_WATER = 0.05
HEIGHTS = (0, 0.25, 0.5, 0.75)  # of the disc above a row of faces [cells]
WATER = ["-fluid_viscosity", 1e-3, "-turbulence", "vreman", "-wall_model", "equilibrium", "-time_cfl", 0.5, "-time_end", 0.4]


def center(across, up):
    """Returns the option that shifts the turbine by parts of a cell of the coarse grid."""
    return ["-impeller_center", f"{across * WIDTH / COARSE},0,{CLEARANCE + up * HEIGHT / COARSE}"]


PLACES = {"as it is": [], "h/4 up": center(0, 0.25), "h/2 up": center(0, 0.5), "h/2 across": center(0.5, 0),
          "15 degrees": ["-impeller_turn", 15], "30 degrees": ["-impeller_turn", 30]}


def power_number(cells, options, start=START):
    """Runs the case; returns the mean power number from `start` on, the torque's standard deviation over its mean, and the open
    energy and that lost at moving walls over the work."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(2, "-options_file", SOURCE / "inputs" / "stirred_tank.opts", "-time_end", END, "-time_cfl", 0,
                               "-time_step", 1e-3 * COARSE / cells, "-grid_cells", f"{cells},{cells},{cells}",
                               "-output_interval", 1, "-output_dir", folder, *options), check=True, stdout=subprocess.DEVNULL)
        history = read_columns(Path(folder) / "history.csv")
    torque = -history["impeller_torque_z"][history["time"] > start]
    dt = history["dt"]
    work, lost = (history["impeller_power"] * dt).sum(), (history["mask_dissipation"] * dt).sum()
    scheme = (history["numerical_dissipation"] * dt).sum() if "numerical_dissipation" in history else 0
    left = work - history["kinetic_energy"][-1] - (history["dissipation"] * dt).sum() - lost - scheme
    scale = SPEED / (DENSITY * TURNS_A_SECOND ** 3 * DIAMETER ** 5)
    return torque.mean() * scale, torque.std() / torque.mean(), left / work, lost / work


def at_height(part, cells):
    """Returns the option that lays the disc this part of a cell above a row of faces, below its place."""
    return ["-impeller_center", f"0,0,{(CLEARANCE * cells // HEIGHT + part) * HEIGHT / cells}"]


def water(cases):
    """Runs the turbine in water, cases being names, cells and options; prints its power numbers and returns whether they agree with
    the measured ones and with each other."""
    print_record_head("turbine", "cells", "Np, second turn", "torque's deviation", "energy open", "lost at moving walls")
    numbers = []
    for name, cells, options in cases:
        number, *parts = power_number(cells, [*WATER, *options], start=0.2)
        numbers.append(number)
        print_record(name, f"{cells}³", f"{number:.2f}", *(f"{100 * part:.1f} %" for part in parts), arguments=ARGUMENTS)
    apart = max(numbers) / min(numbers) - 1
    return WATER_BAND[0] <= min(numbers) and max(numbers) <= WATER_BAND[1] and apart < MOST_APART_IN_WATER


def main():
    if ARGUMENTS[:1] == ["water"]:
        return 0 if water([("as it is", int(cells), []) for cells in ARGUMENTS[1:] or (64, 96)]) else 1
    if ARGUMENTS[:1] == ["heights"]:
        return 0 if water([(f"{part} cells above a row", int(cells), at_height(part, int(cells)))
                           for cells in ARGUMENTS[1:] or (64,) for part in HEIGHTS]) else 1
    places = ARGUMENTS == ["places"]
    cases = [(name, COARSE, options) for name, options in PLACES.items()] if places else [
        ("as it is", int(cells), []) for cells in ARGUMENTS or (48, 64)]
    print_record_head("place", "cells", "Np", "torque's deviation", "energy open", "lost at moving walls")
    numbers = []
    for name, cells, options in cases:
        number, deviation, left, lost = power_number(cells, options)
        numbers.append(number)
        print_record(name, f"{cells}³", f"{number:.3f}", f"{100 * deviation:.1f} %", f"{100 * left:.1f} %", f"{100 * lost:.1f} %",
                     arguments=ARGUMENTS)
    if places:
        return 0 if max(numbers) - min(numbers) < MOST_APART * sum(numbers) / len(numbers) else 1
    return 0 if BAND[0] <= numbers[-1] <= BAND[1] else 1


if __name__ == "__main__":
    sys.exit(main())
