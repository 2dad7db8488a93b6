# SPDX-License-Identifier: BSD-3-Clause
"""The drag of a sphere that markers hold, at two places within a cell.

Prints the table of docs/validation/sphere.md. Arguments: cells a diameter, by default 5 10, or cells:width with the
width of the box in diameters, by default 10; options after `--`. `-fluid_viscosity 0.05` is Re = 20.
"""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

from tables import ARGUMENTS, OPTIONS, SOURCE, Miss, command, is_small, print_record, print_record_head, read_columns

WIDTH, AHEAD, BEHIND = 10, 4, 8  # of the box, and from the sphere to its ends [diameters]
EXACT = {100: 1.09, 20: 2.71}  # in water without end, by Reynolds number
MOST_OFF, MOST_APART = {5: 0.08, 10: 0.03}, 0.01
APART_AT_RE_100 = {5: Miss(0.037, 0.15)}  # the layer is half a cell thick there


def drag(cells, width, shift):
    """Runs the case; returns the drag coefficient at its end."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        half = width / 2
        subprocess.run(command(1, "-options_file", SOURCE / "inputs" / "sphere.opts", "-grid_cells",
                               ",".join(str(length * cells) for length in (AHEAD + BEHIND, width, width)),
                               "-grid_lower", f"{-AHEAD},{-half},{-half}", "-grid_upper", f"{BEHIND},{half},{half}",
                               "-time_step", min(0.05, 0.4 / cells),
                               "-ball_center", ",".join([str(shift / cells)] * 3), "-output_interval", 100, "-output_dir", folder),
                       check=True, stdout=subprocess.DEVNULL)
        force = read_columns(Path(folder) / "history.csv")["ball_force_x"][-10:].mean()
    return 2 * force / (math.pi / 4)


def reynolds():
    """The Reynolds number that the options after `--` ask for."""
    viscosity = OPTIONS[OPTIONS.index("-fluid_viscosity") + 1] if "-fluid_viscosity" in OPTIONS else 0.01
    return round(1 / float(viscosity))


def main():
    exact = EXACT[reynolds()]
    print_record_head("Re", "box", "cells a diameter", "Cd", "over exact", "half a cell aside", "apart")
    passed = True
    for word in ARGUMENTS or ("5", "10"):
        cells, width = map(int, word.split(":") if ":" in word else (word, WIDTH))
        here, aside = drag(cells, width, 0), drag(cells, width, 0.5)
        apart = abs(here - aside) / here
        most_apart = APART_AT_RE_100.get(cells, MOST_APART) if reynolds() == 100 else MOST_APART
        print_record(reynolds(), f"{AHEAD + BEHIND} x {width} x {width}", cells, f"{here:.3f}", f"{here / exact:.3f}",
                     f"{aside:.3f}", f"{100 * apart:.1f} %", arguments=[word])
        passed &= abs(here / exact - 1) <= MOST_OFF.get(cells, 0.03) and is_small(apart, most_apart)
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
