# SPDX-License-Identifier: BSD-3-Clause
"""Lid-driven cavity at Re = 100, 400, 3200 and 5000 against Ghia, Ghia and Shin (1982) and Erturk et al. (2005).

Prints the table of docs/validation/cavity.md. Arguments: Re:cells ..., by default those with limits; "quick" leaves
out the 257 x 257 cells.
"""

import math
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


def wanted_cases(words):
    """The cases that the arguments name; those without limits are against Ghia et al."""
    if words == ["quick"]:
        return [case for case in CASES if case.cells <= 129]
    known = {f"{case.reynolds}:{case.cells}": case for case in CASES}
    return [known.get(word) or Case(*map(int, word.split(":")), {"Ghia": math.inf}) for word in words or known]


def main():
    passed = True
    cavity.print_record_head("Re", "cells", "reference", "u rms", "u max", "v rms", "v max",
                             "drift of the energy in 10 s")
    for case in wanted_cases(cavity.ARGUMENTS):
        flow = cavity.run_cavity(case.cells, case.reynolds)
        passed &= flow.is_steady()
        for name, limit in case.limits.items():
            errors = cavity.norms(flow, REFERENCES[name](case.reynolds))
            cavity.print_record(case.reynolds, f"{case.cells} x {case.cells}", name, *map(cavity.percent, errors),
                                f"{flow.drift:.1e}", arguments=[f"{case.reynolds}:{case.cells}"])
            passed &= max(errors) <= limit
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
