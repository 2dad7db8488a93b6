# SPDX-License-Identifier: BSD-3-Clause
"""Lid-driven cavity at Re = 1000 against the spectral values of Botella and Peyret (1998): errors, order, and extrema on the centre lines.

Prints the tables of docs/validation/cavity.md. Arguments: cells per side (default 65 129 257).
"""

import sys

import numpy as np

import cavity

MOST_ALLOWED = {65: 0.035, 129: 0.008, 257: 0.003}  # of the lid speed
LEAST_ORDER = 1.8


def print_extrema(flows):
    """Extrema on the centre lines and their places."""
    print()
    cavity.print_record_head("cells", "least u", "largest v", "least v")
    for cells, flow in flows.items():
        found = [find(flow[line]) for find, line in ((cavity.lowest, 0), (cavity.highest, 1), (cavity.lowest, 1))]
        cavity.print_record(f"{cells} x {cells}", *(f"{value:.5f} at {place:.4f}" for value, place in found))
    reference = cavity.read_reference("botella_peyret1998_Re1000_extrema.csv")
    cavity.print_row("Botella and Peyret", *(f"{value:.5f} at {place:.4f}" for value, place in zip(reference["value"], reference["place"])),
                     "", "")


def main():
    sizes = [int(word) for word in cavity.ARGUMENTS] or [65, 129, 257]
    passed, previous, flows = True, None, {}
    cavity.print_record_head("cells", "u rms", "u max", "v rms", "v max", "order of the rms")
    for cells in sizes:
        flow = flows[cells] = cavity.run_cavity(cells, 1000)
        errors = cavity.norms(flow, cavity.botella_peyret())
        both = np.hypot(errors[0], errors[2])
        order = previous and cavity.order(previous[1], both, cells / previous[0])
        cavity.print_record(f"{cells} x {cells}", *map(cavity.percent, errors), f"{order:.2f}" if order else "")
        passed &= flow.is_steady() and max(errors) <= MOST_ALLOWED.get(cells, np.inf)
        passed &= order is None or order >= LEAST_ORDER
        previous = cells, both
    print_extrema(flows)
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
