# SPDX-License-Identifier: BSD-3-Clause
"""Lid-driven cavity at Re = 100, 400, 3200 and 5000 against Ghia, Ghia and Shin (1982) and Erturk et al. (2005).

Prints the table of docs/verification.md. The argument "quick" leaves out the 257 x 257 cells.
"""

import sys
from typing import NamedTuple

import cavity


class Case(NamedTuple):
    """A run and the largest difference allowed from each reference, of the lid speed."""
    reynolds: int
    cells: int
    limits: dict


# Ghia et al. are themselves off by 1 to 3 % at the extrema, so their limits only catch gross errors.
CASES = [Case(100, 129, {"Ghia": 0.012}), Case(400, 129, {"Ghia": 0.01}), Case(3200, 129, {"Ghia": 0.035}),
         Case(5000, 129, {"Ghia": 0.05, "Erturk": 0.05}), Case(5000, 257, {"Ghia": 0.03, "Erturk": 0.015})]
REFERENCES = {"Ghia": cavity.ghia, "Erturk": cavity.erturk}


def main():
    quick, passed = "quick" in sys.argv, True
    cavity.print_head("Re", "cells", "reference", "u rms", "u max", "v rms", "v max", "drift of the energy in 10 s",
                      "wall [s]")
    for case in CASES:
        if quick and case.cells > 129:
            continue
        flow = cavity.run_cavity(case.cells, case.reynolds)
        passed &= flow.is_steady()
        for name, limit in case.limits.items():
            errors = cavity.norms(flow, REFERENCES[name](case.reynolds))
            cavity.print_row(case.reynolds, f"{case.cells} x {case.cells}", name, *map(cavity.percent, errors),
                             f"{flow.drift:.1e}", f"{flow.seconds:.0f}")
            passed &= max(errors) <= limit
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
