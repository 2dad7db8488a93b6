# SPDX-License-Identifier: BSD-3-Clause
"""The load of a permeable square sheet of cloth across a stream of Re = 1000, against Taylor's law.

Prints the table of docs/validation/contact.md. Arguments: cells across the sheet, by default 6. The sheet is too heavy to move, at rest in a
stream of speed U that starts at once, in a box of 8 x 6 x 6 sides; means from t = 3 to 4 sides over U.

G. I. Taylor, Air resistance of a flat plate of very porous material (Aeronautical Research Council, R. & M. 2236, 1944): a sheet
across which the pressure falls by k rho u^2/2 lets u = U/(1 + k/4) through and has a drag coefficient of k/(1 + k/4)^2. With w = u/U
that is 4 w (1 - w), and by Darcy's law w is permeance rho U Cd/2.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

from tables import ARGUMENTS, command, print_record, print_record_head, read_columns

SPEED, DENSITY, VISCOSITY, START, END = 1, 1, 1e-3, 3, 4
PARTS = (0.9, 0.8, 0.7)  # of the stream that the law lets through
MOST_OFF = 0.15


def drag(cells, permeance):
    """Returns the sheet's mean drag coefficient."""
    sides = [word for axis in "yz" for end in ("lower", "upper") for word in (f"-bc_{axis}_{end}", "slip")]
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(1, "-grid_cells", f"{8 * cells},{6 * cells},{6 * cells}", "-grid_lower", "-3,-3,-3", "-grid_upper", "5,3,3",
                               "-bc_x_lower", "inflow", "-bc_x_lower_velocity", f"{SPEED},0,0", "-bc_x_upper", "outflow", *sides,
                               "-fluid_density", DENSITY, "-fluid_viscosity", VISCOSITY, "-fluid_initial", "uniform",
                               "-fluid_initial_velocity", f"{SPEED},0,0", "-cloths", "sheet", "-sheet_size", "1,1", "-sheet_markers",
                               f"{2 * cells},{2 * cells}", "-sheet_center", "0,0,0", "-sheet_direction", "0,1,0", "-sheet_across", "0,0,1",
                               "-sheet_ke", 1e3, "-sheet_excess_mass", 1e7, "-sheet_hold", "middle", "-sheet_permeance", permeance,
                               "-contact", "none", "-coupling_order", 1,
                               "-time_step", 0.24 / cells, "-time_end", END, "-output_interval", END, "-output_dir", folder),
                       check=True, stdout=subprocess.DEVNULL)
        history = read_columns(Path(folder) / "history.csv")
    return history["sheet_water_force_x"][history["time"] > START].mean() / (0.5 * DENSITY * SPEED ** 2)


def main():
    passed = True
    print_record_head("cells across", "k", "Cd", "Taylor", "off", "lets through", "Taylor")
    for cells in (int(word) for word in ARGUMENTS or (6,)):
        for part in PARTS:
            permeance = 0.5 / ((1 - part) * DENSITY * SPEED)
            found, expected = drag(cells, permeance), 4 * part * (1 - part)
            off = found / expected - 1
            passed = passed and abs(off) < MOST_OFF
            print_record(cells, f"{4 * (1 / part - 1):.2f}", f"{found:.3f}", f"{expected:.3f}", f"{100 * off:+.1f} %",
                         f"{0.5 * permeance * DENSITY * SPEED * found:.2f}", part, arguments=ARGUMENTS)
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
