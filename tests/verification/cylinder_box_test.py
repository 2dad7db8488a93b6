# SPDX-License-Identifier: BSD-3-Clause
"""What the box adds to the Strouhal number of a cylinder at Re = 100: each side of it twice as far away, then all.

Prints a table of docs/validation/cylinder.md. On grids of 8.5 cells a diameter, with today's numerics. Fails when the three
changes do not add up to that of all, or the box of 30 diameters adds less or more than is recorded.
"""

import sys

import results
from tables import SOURCE, print_record, print_record_head, read_columns
from thesis.cylinder import shedding

CELL = 30 / 256  # diameters
NEAR, FAR = (-7.5, 22.5, 15), (-15, 45, 30)  # inflow, outflow, half width, in diameters
BOXES = {"30 d": (0, 0, 0), "inflow 15 d ahead": (1, 0, 0), "outflow 45 d behind": (0, 1, 0), "sides 30 d away": (0, 0, 1),
         "60 d": (1, 1, 1)}
ADDED = 0.0045  # to St by the box of 30 d, less by that of 60 d
WITHIN = 0.25  # of what is recorded, and the sum of what was changed


def strouhal(far):
    """Strouhal number in a box some sides of which are far away."""
    left, right, half = (pair[index] for pair, index in zip(zip(NEAR, FAR), far))
    cells = f"{round((right - left) / CELL)},{round(2 * half / CELL)}"
    result = results.run(1, "-options_file", SOURCE / "inputs" / "cylinder.opts", "-grid_cells", cells, "-grid_lower",
                         f"{left},{-half}", "-grid_upper", f"{right},{half}", "-body_balance", "false", "-time_end", 170,
                         "-checkpoint_interval", 10)
    return shedding(read_columns(result.folder / "history.csv")).st


def main():
    print_record_head("box", "St", "less than in 30 d")
    found = {name: strouhal(far) for name, far in BOXES.items()}
    first = found["30 d"]
    for name, value in found.items():
        print_record(name, f"{value:.4f}", f"{100 * (1 - value / first):.2f} %")
    total = first - found["60 d"]
    parts = sum(first - value for name, value in found.items() if sum(BOXES[name]) == 1)
    print(f"\nOne side at a time {100 * parts / first:.2f} %, all together {100 * total / first:.2f} %.")
    return 0 if abs(parts - total) <= WITHIN * total and abs(total - ADDED) <= WITHIN * ADDED else 1


if __name__ == "__main__":
    sys.exit(main())
