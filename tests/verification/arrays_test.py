# SPDX-License-Identifier: BSD-3-Clause
"""Cylinders and spheres in creeping flow, held by markers: the radius with which they act.

Prints the table of docs/validation/marker_walls.md. Arguments: cells a diameter, by default 4 5 6 8 10 20. Bodies lie four
diameters apart in a periodic array, through which water flows with a kept bulk velocity, at a Reynolds number of 0.1. Drag of
cylinders: Sangani and Acrivos, Int. J. Multiphase Flow 8 (1982) 193; of spheres: Hasimoto, J. Fluid Mech. 5 (1959) 317.
"""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

from tables import ARGUMENTS, command, print_record, print_record_head, read_columns

APART, VISCOSITY, RADIUS = 4, 10, 0.5
MOST_OFF = {2: 0.01, 3: 0.01}  # of the radius, by the dimension, from six cells a diameter on


def drag_of_cylinder(radius):
    """Returns the drag of a cylinder of the array at the bulk velocity 1 [N/m]."""
    part = math.pi * radius ** 2 / APART ** 2
    return 4 * math.pi * VISCOSITY / (-0.5 * math.log(part) - 0.738 + part - 0.887 * part ** 2 + 2.038 * part ** 3)


def drag_of_sphere(radius):
    """Returns the drag of a sphere of the array at the bulk velocity 1 [N]."""
    part = 4 / 3 * math.pi * radius ** 3 / APART ** 3
    return 6 * math.pi * VISCOSITY * radius / (1 - 1.7601 * part ** (1 / 3) + part - 1.5593 * part ** 2)


def drag(dimension, cells, shift):
    """Runs the case; returns the drag at its end."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        def all_axes(value):
            return ",".join([str(value)] * dimension)
        periodic = [word for axis in "xyz"[:dimension] for end in ("lower", "upper")
                    for word in (f"-bc_{axis}_{end}", "periodic")]
        subprocess.run(command(1, "-grid_cells", all_axes(APART * cells), "-grid_lower", all_axes(-APART / 2), "-grid_upper",
                               all_axes(APART / 2), *periodic, "-fluid_density", 1, "-fluid_viscosity", VISCOSITY,
                               "-fluid_bulk_velocity", "1" + ",0" * (dimension - 1), "-body_method", "direct_forcing",
                               "-bodies", "ball", "-ball_shape", "sphere", "-ball_radius", RADIUS, "-ball_center",
                               all_axes(shift / cells), "-time_step", 0.02, "-time_end", 3, "-body_slip_tolerance", 1e-4,
                               "-output_interval", 100, "-output_dir", folder), check=True, stdout=subprocess.DEVNULL)
        return read_columns(Path(folder) / "history.csv")["ball_force_x"][-1]


def radius_of(force, drag_of):
    """Returns the radius with the given drag, by halving."""
    low, high = 0.5 * RADIUS, 2 * RADIUS
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if drag_of(middle) < force else (low, middle)
    return low


def main():
    passed = True
    print_record_head("body", "cells a diameter", "acting over true radius", "0.3 cells aside")
    for name, dimension, drag_of in (("cylinder", 2, drag_of_cylinder), ("sphere", 3, drag_of_sphere)):
        for word in ARGUMENTS or ("4", "5", "6", "8", "10", "20"):
            cells = int(word)
            ratios = [radius_of(drag(dimension, cells, shift), drag_of) / RADIUS for shift in (0, 0.3)]
            print_record(name, cells, *(f"{ratio:.4f}" for ratio in ratios), arguments=[word])
            passed &= cells < 6 or max(abs(ratio - 1) for ratio in ratios) <= MOST_OFF[dimension]
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
