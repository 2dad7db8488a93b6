# SPDX-License-Identifier: BSD-3-Clause
"""Cubic lid-driven cavity at Re = 1000 with rigid end walls against Albensoeder and Kuhlmann (2005).

Prints the tables of docs/validation/cavity.md. Arguments: cells per side (default 48 64). From the last two grids the
values are extrapolated to zero spacing, at second order. On 64 cells wide_central advection is run too: its error is
the one that is bounded, that of central only by the extrapolation.
"""

import sys

import numpy as np

import cavity

END = 100  # [s]
WIDE = 64  # cells of the run with wide_central advection
MOST_ALLOWED_WIDE = 0.02  # of the lid speed
MOST_ALLOWED_EXTRAPOLATED = 0.01


def albensoeder_kuhlmann():
    """u and v on the centre lines in the middle plane of the cube."""
    return cavity.reference_lines("albensoeder2005_Re1000_u_vertical.csv", "albensoeder2005_Re1000_v_horizontal.csv",
                                  "u_cube", "v_cube")


def read_at(flow, reference):
    """The lines of a flow at the places of the reference."""
    return [cavity.Line(known.places, cavity.interpolate(line, known.places))
            for line, known in zip(flow[:2], reference)]


def extrapolate(coarse, fine, ratio):
    """Lines without their error of second order, the grids being finer by a ratio."""
    return [cavity.Line(far.places, near.values + (near.values - far.values) / (ratio ** 2 - 1))
            for far, near in zip(coarse, fine)]


def print_points(axis, name, columns, reference):
    """A component at all tabulated places."""
    print()
    cavity.print_head(axis, *(f"{name}, {label}" for label in columns), "Albensoeder and Kuhlmann")
    for place, *values in zip(reference.places, *(line.values for line in columns.values()), reference.values):
        cavity.print_row(f"{place:.4f}", *(f"{value:.5f}" for value in values))


def main():
    sizes = [int(word) for word in cavity.ARGUMENTS] or [48, 64]
    passed, lines, reference = True, {}, albensoeder_kuhlmann()
    cavity.print_origin()
    cavity.print_head("cells", "u rms", "u max", "v rms", "v max", "drift of the energy in 10 s")
    runs = [(f"{cells}^3", cells, "central") for cells in sizes] + [(f"{WIDE}^3, wide_central", WIDE, "wide_central")]
    for label, cells, advection in runs:
        flow = cavity.run_cavity(cells, 1000, END, dimensions=3, advection=advection)
        lines[label] = read_at(flow, reference)
        errors = cavity.norms(flow, reference)
        cavity.print_row(label, *map(cavity.percent, errors), f"{flow.drift:.1e}")
        passed &= flow.is_steady() and max(errors) <= (MOST_ALLOWED_WIDE if advection == "wide_central" else np.inf)
    if len(sizes) > 1:
        lines["extrapolated"] = extrapolate(*(lines[f"{cells}^3"] for cells in sizes[-2:]), sizes[-1] / sizes[-2])
        errors = cavity.norms(lines["extrapolated"], reference)
        cavity.print_row("extrapolated", *map(cavity.percent, errors), "")
        passed &= max(errors) <= MOST_ALLOWED_EXTRAPOLATED
    for number, (axis, name) in enumerate(("yu", "xv")):
        print_points(axis, name, {label: pair[number] for label, pair in lines.items()}, reference[number])
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
