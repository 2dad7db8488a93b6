# SPDX-License-Identifier: BSD-3-Clause
"""Turbulent channels whose viscous layers are far thinner than a cell, with -wall_model equilibrium, against the law of the wall.

Prints the tables of docs/validation/turbulence.md: U+ on 32 x 32 x 32 cells of a box of 2 pi x 2 x pi half heights. Arguments:
Re_tau and -turbulence, else 2000 vreman and 20000 vreman. From the second cell on U+ must be within 5 % of ln(y+)/0.41 + 5.2.
After the word `bodies` the walls are half spaces, held by markers: on 96 x 41 x 48 cubes of 1/16 half height, the floor 0.3 cells
above faces of cells, the roof 0.3 cells below them as seen from the water; both must be within 8 % beyond the second cell. After
the word `oblique` the channel lies at 20 degrees to the grid in a box that is periodic along all axes, between a slab and its
images; a ball that leaves the box stirs the start. It must be within 12 %.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

from tables import ARGUMENTS, SOURCE, command, print_head, print_origin, print_row, read_columns

CASE = ["-options_file", SOURCE / "inputs" / "channel_turbulent.opts", "-grid_cells", "32,32,32", "-wall_model", "equilibrium",
        "-fluid_bulk_velocity", "0,0,0", "-fluid_pressure_gradient", "-1,0,0", "-time_step", 0.004, "-time_end", 10,
        "-statistics_start", 4, "-statistics_spectra", 1.03125]
MOST_OFF, MOST_OFF_BODIES, MOST_OFF_OBLIQUE = 0.05, 0.08, 0.12
CELL = 1 / 16
BODIES = ["-grid_cells", "96,41,48", "-grid_lower", f"0,{-4.3 * CELL},0", "-grid_upper", f"6,{36.7 * CELL},3", "-time_cfl", 0.7,
          "-time_end", 6, "-statistics_start", 3, "-bodies", "floor,roof", "-body_method", "direct_forcing",
          "-floor_shape", "halfspace", "-floor_center", "0,0,0", "-floor_normal", "0,1,0",
          "-roof_shape", "halfspace", "-roof_center", "0,2,0", "-roof_normal", "0,-1,0"]

RUN, RISE = 104, 38  # cells after which the oblique channel has gone through the box once, and is where it began
LENGTHS = np.array([RUN, RISE]) * CELL
ALONG = LENGTHS / np.hypot(*LENGTHS)
ACROSS = np.array([-ALONG[1], ALONG[0]])
SLAB = LENGTHS[1] * ALONG[0] - 2  # its thickness, which leaves two half heights to the water
OBLIQUE = ["-grid_cells", f"{RUN},{RISE},32", "-grid_upper", f"{LENGTHS[0]},{LENGTHS[1]},2", "-bc_y_lower", "periodic",
           "-bc_y_upper", "periodic", "-fluid_pressure_gradient", f"{-ALONG[0]},{-ALONG[1]},0", "-fluid_initial", "uniform",
           "-time_cfl", 0.7, "-time_end", 4.6, "-statistics_start", 2.8, "-statistics_axes", "z", "-statistics_spectra", "",
           "-body_method", "direct_forcing", "-bodies", "slab,above,below,ball", "-ball_radius", 0.15,
           "-ball_center", f"2,{LENGTHS[1] / 2 + 2 * ALONG[1] / ALONG[0]},1",
           "-ball_velocity", f"{-4 * ALONG[0]},{-4 * ALONG[1]},0"]


def slab_options(name, height):
    """A slab along the diagonal of the box from a height on."""
    options = [f"-{name}_shape", "intersection", f"-{name}_parts", "roof,floor", f"-{name}_center", f"0,{height},0"]
    for part, side in (("roof", 1), ("floor", -1)):
        normal, place = side * ACROSS, side * SLAB / 2 * ACROSS
        options += [f"-{name}_{part}_shape", "halfspace", f"-{name}_{part}_normal", f"{normal[0]},{normal[1]},0",
                    f"-{name}_{part}_offset", f"{place[0]},{place[1]},0"]
    return options


def law(y):
    """The logarithmic law of the wall."""
    return np.log(y) / 0.41 + 5.2


def run_channel(re_tau, model, folder, *options, along=(1, 0)):
    """Runs a channel in which u_tau is 1 m/s, from its mean velocity by the law."""
    u, v = (law(re_tau) - 2.4) * np.array(along)
    subprocess.run(command(1, *CASE, *options, "-fluid_viscosity", 1 / re_tau, "-turbulence", model, "-fluid_initial_velocity",
                           f"{u},{v},0", "-output_dir", folder), check=True, stdout=subprocess.DEVNULL)


def print_profile(re_tau, distances, speeds):
    """Prints U+ over the distance from a wall in half heights; returns how far it is off the law."""
    places = distances * re_tau
    off = speeds / law(places) - 1
    print_head("y in cells", "y+", "U+", "law", "off")
    for row in zip(distances / CELL, places, speeds, law(places), off):
        print_row(f"{row[0]:.1f}", f"{row[1]:.1f}", f"{row[2]:.2f}", f"{row[3]:.2f}", f"{100 * row[4]:+.1f} %")
    return off


def judge_bodies(re_tau, model):
    """Prints what both walls of a channel between bodies do, and their loads in the mean; returns whether they follow the law."""
    passed = True
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        run_channel(re_tau, model, folder, *BODIES)
        table, history = read_columns(Path(folder) / "statistics.csv"), read_columns(Path(folder) / "history.csv")
    late = history["time"] > 2.8
    for wall, distance in (("floor", table["y"]), ("roof", 2 - table["y"])):
        order = np.argsort(distance)
        near = order[(distance[order] > 0) & (distance[order] < 1)]
        print(f"\n**Re_tau = {re_tau:g}, {model}, {wall}**: load {history[f'{wall}_force_x'][late].mean() / 6:.2f} Pa\n")
        off = print_profile(re_tau, distance[near], table["u"][near])
        passed &= bool(np.abs(off[2:]).max() <= MOST_OFF_BODIES)
    return passed


def means_by_distance(folder):
    """Distances from the nearer wall of an oblique channel, in layers a cell thick, and the mean velocity along it there."""
    with h5py.File(Path(folder) / "statistics.h5") as file:
        x, y = np.meshgrid(file["x"][()], file["y"][()])
        speeds = ALONG[0] * file["mean/u"][()] + ALONG[1] * file["mean/v"][()]
    height = (ACROSS[0] * x + ACROSS[1] * y) % (LENGTHS[1] * ALONG[0])  # above the middle of the slab below
    distance = 1 - np.abs(height - SLAB / 2 - 1)
    layers = np.floor(distance / CELL).astype(int)
    wet = range(int(1 / CELL))
    return np.array([distance[layers == n].mean() for n in wet]), np.array([speeds[layers == n].mean() for n in wet])


def judge_oblique(re_tau, model):
    """Prints what a channel at 20 degrees to the grid does; returns whether it follows the law."""
    slabs = [*slab_options("slab", 0), *slab_options("above", LENGTHS[1]), *slab_options("below", -LENGTHS[1])]
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        run_channel(re_tau, model, folder, *OBLIQUE, *slabs, along=ALONG)
        distances, speeds = means_by_distance(folder)
    print(f"\n**Re_tau = {re_tau:g}, {model}, 20 degrees to the grid**\n")
    off = print_profile(re_tau, distances, speeds)
    return bool(np.abs(off[2:]).max() <= MOST_OFF_OBLIQUE)


def judge(re_tau, model):
    """Prints a channel's table; returns whether it follows the law."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        run_channel(re_tau, model, folder)
        table = read_columns(Path(folder) / "statistics.csv")
    half = len(table["y"]) // 2  # the mean of both
    places, speeds = table["y"][:half] * re_tau, (table["u"][:half] + table["u"][::-1][:half]) / 2
    off = speeds / law(places) - 1
    print(f"\n**Re_tau = {re_tau:g}, {model}**\n")
    print_head("y+", "U+", "law", "off")
    for row in zip(places, speeds, law(places), off):
        print_row(f"{row[0]:.1f}", f"{row[1]:.2f}", f"{row[2]:.2f}", f"{100 * row[3]:+.1f} %")
    return bool(np.abs(off[1:]).max() <= MOST_OFF)


def main():
    print_origin()
    judges = {"bodies": judge_bodies, "oblique": judge_oblique}
    words = [word for word in ARGUMENTS if word not in judges]
    cases = list(zip(words[::2], words[1::2])) if words else [(2000, "vreman"), (20000, "vreman")]
    judge_one = next((judges[word] for word in ARGUMENTS if word in judges), judge)
    return 0 if all([judge_one(float(re_tau), model) for re_tau, model in cases]) else 1


if __name__ == "__main__":
    sys.exit(main())
