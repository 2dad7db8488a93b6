# SPDX-License-Identifier: BSD-3-Clause
"""The drag of a sphere that markers hold, at two places within a cell.

Prints the table of docs/verification/sphere.md. Arguments: cells a diameter, by default 5 10; options after `--`, as
`-fluid_viscosity 0.05` for Re = 20.
"""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

from tables import ARGUMENTS, SOURCE, command, print_record, print_record_head, read_columns

BOX = (12, 10, 10)  # diameters
EXACT, MOST_OFF = 1.09, 0.08


def drag(cells, shift):
    """Runs the case; returns the drag coefficient at its end."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(2, "-options_file", SOURCE / "inputs" / "sphere.opts", "-grid_cells",
                               ",".join(str(length * cells) for length in BOX), "-time_step", min(0.05, 0.4 / cells),
                               "-ball_center", ",".join([str(shift / cells)] * 3), "-output_interval", 100, "-output_dir", folder),
                       check=True, stdout=subprocess.DEVNULL)
        force = read_columns(Path(folder) / "history.csv")["ball_force_x"][-10:].mean()
    return 2 * force / (math.pi / 4)


def main():
    print_record_head("cells a diameter", "Cd", "half a cell aside", "apart")
    passed = True
    for cells in [int(word) for word in ARGUMENTS] or (5, 10):
        here, aside = drag(cells, 0), drag(cells, 0.5)
        print_record(cells, f"{here:.3f}", f"{aside:.3f}", f"{100 * abs(here - aside) / here:.1f} %", arguments=ARGUMENTS)
        passed &= abs(here / EXACT - 1) <= MOST_OFF
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
