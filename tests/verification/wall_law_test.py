# SPDX-License-Identifier: BSD-3-Clause
"""Turbulent channels whose viscous layers are far thinner than a cell, with -wall_model equilibrium, against the law of the wall.

Prints the tables of docs/verification/turbulence.md: U+ on 32 x 32 x 32 cells of a box of 2 pi x 2 x pi half heights. Arguments:
Re_tau and -turbulence, else 2000 vreman and 20000 vreman. From the second cell on U+ must be within 5 % of ln(y+)/0.41 + 5.2.
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
MOST_OFF = 0.05


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
    cases = list(zip(ARGUMENTS[::2], ARGUMENTS[1::2])) if ARGUMENTS else [(2000, "vreman"), (20000, "vreman")]
    return 0 if all([judge(float(re_tau), model) for re_tau, model in cases]) else 1


if __name__ == "__main__":
    sys.exit(main())
