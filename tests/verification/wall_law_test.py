# SPDX-License-Identifier: BSD-3-Clause
"""Turbulent channels whose viscous layers are far thinner than a cell, with -wall_model equilibrium, against the law of the wall.

Prints the tables of docs/verification/turbulence.md: U+ on 32 x 32 x 32 cells of a box of 2 pi x 2 x pi half heights. Arguments:
Re_tau and -turbulence, else 2000 vreman and 20000 vreman. From the second cell on U+ must be within 5 % of ln(y+)/0.41 + 5.2.
After the word `bodies` the walls are half spaces, held by markers: on 48 x 41 x 32 cubes of 1/16 half height, the floor 0.3 cells
above faces of cells, the roof 0.3 cells below them as seen from the water; both must be within 8 % beyond the second cell.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from tables import ARGUMENTS, SOURCE, command, print_head, print_origin, print_row, read_columns

CASE = ["-options_file", SOURCE / "inputs" / "channel_turbulent.opts", "-grid_cells", "32,32,32", "-wall_model", "equilibrium",
        "-fluid_bulk_velocity", "0,0,0", "-fluid_pressure_gradient", "-1,0,0", "-time_step", 0.004, "-time_end", 10,
        "-statistics_start", 4, "-statistics_spectra", 1.03125]
MOST_OFF, MOST_OFF_BODIES = 0.05, 0.08
CELL = 1 / 16
BODIES = ["-grid_cells", "48,41,32", "-grid_lower", f"0,{-4.3 * CELL},0", "-grid_upper", f"3,{36.7 * CELL},2", "-time_cfl", 0.7,
          "-time_end", 4.6, "-statistics_start", 2.8, "-bodies", "floor,roof", "-body_method", "direct_forcing",
          "-floor_shape", "halfspace", "-floor_center", "0,0,0", "-floor_normal", "0,1,0",
          "-roof_shape", "halfspace", "-roof_center", "0,2,0", "-roof_normal", "0,-1,0"]


def law(y):
    """The logarithmic law of the wall."""
    return np.log(y) / 0.41 + 5.2


def profile_of(re_tau, model, folder):
    """Runs a channel in which u_tau is 1 m/s; returns y+ and U+ of the mean of both halves."""
    subprocess.run(command(1, *CASE, "-fluid_viscosity", 1 / re_tau, "-turbulence", model, "-fluid_initial_velocity",
                           f"{law(re_tau) - 2.4},0,0", "-output_dir", folder), check=True, stdout=subprocess.DEVNULL)
    table = read_columns(Path(folder) / "statistics.csv")
    half = len(table["y"]) // 2
    return table["y"][:half] * re_tau, (table["u"][:half] + table["u"][::-1][:half]) / 2


def judge_bodies(re_tau, model):
    """Prints what both walls of a channel between bodies do, and their loads in the mean; returns whether they follow the law."""
    passed = True
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(1, *CASE, *BODIES, "-fluid_viscosity", 1 / re_tau, "-turbulence", model, "-fluid_initial_velocity",
                               f"{law(re_tau) - 2.4},0,0", "-output_dir", folder), check=True, stdout=subprocess.DEVNULL)
        table, history = read_columns(Path(folder) / "statistics.csv"), read_columns(Path(folder) / "history.csv")
    late = history["time"] > 2.8
    for wall, distance in (("floor", table["y"]), ("roof", 2 - table["y"])):
        order = np.argsort(distance)
        near = order[(distance[order] > 0) & (distance[order] < 1)]
        places, speeds = distance[near] * re_tau, table["u"][near]
        off = speeds / law(places) - 1
        print(f"\n**Re_tau = {re_tau:g}, {model}, {wall}**: load {history[f'{wall}_force_x'][late].mean() / 6:.2f} Pa\n")
        print_head("y in cells", "y+", "U+", "law", "off")
        for n, row in enumerate(zip(places, speeds, law(places), off)):
            print_row(f"{distance[near][n] / CELL:.1f}", f"{row[0]:.1f}", f"{row[1]:.2f}", f"{row[2]:.2f}", f"{100 * row[3]:+.1f} %")
        passed &= bool(np.abs(off[2:]).max() <= MOST_OFF_BODIES)
    return passed


def judge(re_tau, model):
    """Prints a channel's table; returns whether it follows the law."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        places, speeds = profile_of(re_tau, model, folder)
    off = speeds / law(places) - 1
    print(f"\n**Re_tau = {re_tau:g}, {model}**\n")
    print_head("y+", "U+", "law", "off")
    for row in zip(places, speeds, law(places), off):
        print_row(f"{row[0]:.1f}", f"{row[1]:.2f}", f"{row[2]:.2f}", f"{100 * row[3]:+.1f} %")
    return bool(np.abs(off[1:]).max() <= MOST_OFF)


def main():
    print_origin()
    words = [word for word in ARGUMENTS if word != "bodies"]
    cases = list(zip(words[::2], words[1::2])) if words else [(2000, "vreman"), (20000, "vreman")]
    judge_one = judge_bodies if "bodies" in ARGUMENTS else judge
    return 0 if all([judge_one(float(re_tau), model) for re_tau, model in cases]) else 1


if __name__ == "__main__":
    sys.exit(main())
