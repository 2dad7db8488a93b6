# SPDX-License-Identifier: BSD-3-Clause
"""A cylinder that turns to and fro about its axis in water at rest, held by markers: its torque against Stokes' solution.

Prints a table of docs/validation/cylinder.md. Arguments: numbers of cells a side, by default 24 48 96, of a box of 3 d;
a drum at rest of 2.4 d, far beyond the layer of shear, surrounds the water. Steps are in proportion to the cells.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from oscillating_cylinder_test import bessel_k
from tables import ARGUMENTS, command, print_record, print_record_head, read_columns

RADIUS, SPEED, FREQUENCY, BOX = 0.5, 0.06, 0.5, 3
OMEGA = 2 * np.pi * FREQUENCY
VISCOSITIES = (0.032, 0.008)
MOST_OFF = 0.13  # of both parts together, where the layer is 2.2 cells thick and more


def stokes(viscosity):
    """Complex torque per angular velocity [N m s/m], of unit density: 2 pi R^2 times -mu k K_2(kR)/K_1(kR) R."""
    k = np.sqrt(1j * OMEGA / viscosity)
    return -2 * np.pi * RADIUS ** 3 * viscosity * k * bessel_k(2, k * RADIUS) / bessel_k(1, k * RADIUS)


def harmonic(time, values):
    """Complex amplitude of the part with the motion's frequency."""
    return np.linalg.lstsq(np.array([np.cos(OMEGA * time), -np.sin(OMEGA * time), np.ones_like(time)]).T, values, rcond=None)[0][:2] @ [1, 1j]


def torque(cells, viscosity):
    """The cylinder's, per angular velocity, over the last two of three periods."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(1, "-grid_cells", f"{cells},{cells}", "-grid_upper", f"{BOX},{BOX}", "-fluid_density", 1, "-fluid_viscosity", viscosity,
                               "-bodies", "post,drum", "-body_method", "direct_forcing", "-post_shape", "sphere", "-post_radius", RADIUS,
                               "-post_center", "1.51,1.49", "-post_angular_speed", SPEED, "-post_frequency", FREQUENCY, "-drum_shape", "sphere",
                               "-drum_radius", 1.2, "-drum_center", "1.51,1.49", "-drum_inverted", "true", "-time_end", 3 / FREQUENCY,
                               "-time_step", 0.24 / cells, "-history_interval", 0.02, "-output_dir", folder),
                       check=True, stdout=subprocess.DEVNULL)
        history = read_columns(Path(folder) / "history.csv")
    seen = history["time"] > 1 / FREQUENCY
    middle = history["time"][seen] - 0.5 * history["dt"][seen]  # loads are means over a step
    return harmonic(middle, history["post_torque"][seen]) / harmonic(middle, SPEED * np.sin(OMEGA * middle))


def main():
    passed = True
    print_record_head("viscosity", "cells a side", "layer, cells", "with the velocity, over exact", "with the acceleration, over exact", "off together")
    for viscosity in VISCOSITIES:
        exact, layer = stokes(viscosity), np.sqrt(2 * viscosity / OMEGA) / BOX
        for cells in map(int, ARGUMENTS or [24, 48, 96]):
            found = torque(cells, viscosity)
            off = abs(found / exact - 1)
            print_record(viscosity, cells, f"{layer * cells:.1f}", f"{found.real / exact.real:.3f}", f"{found.imag / exact.imag:.3f}",
                         f"{100 * off:.0f} %", arguments=[cells])
            passed &= off < MOST_OFF or layer * cells < 2.2
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
