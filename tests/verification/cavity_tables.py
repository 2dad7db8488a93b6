# SPDX-License-Identifier: BSD-3-Clause
"""Tables 2.3-1 to 2.3-5 of the thesis, computed again: the lid-driven cavity at Re = 1000.

Prints the tables of docs/verification/cavity.md. Beside our figures stand those of the thesis, of Ghia, Ghia and Shin
(1982) and of Botella and Peyret (1998). The thesis's "129 x 129" is taken as 129 cells a side, and its values as read
linearly between grid points; cubic reading is for the comparison with others. Fails when a run is not steady, when a
figure differs from the thesis by more than rounding, or when the two finer grids do not show second order.
"""

import sys

import numpy as np

import cavity
from cavity import interpolate_linearly, percent, print_head, print_origin, print_row

GRIDS = [33, 65, 129]  # cells a side
FINEST = 257
MOST_OFF = 2e-5  # from a value of the thesis, printed with five decimals
MOST_OFF_PERCENT = 0.011  # from a percentage of the thesis, printed with two
LEAST_RATE = 1.8  # between the two finer grids
NORMS = ["u_rms", "u_max", "v_rms", "v_max"]


def print_title(text):
    """Prints a title between empty lines."""
    print(f"\n**{text}**\n")


def print_comparison(flow):
    """Table 2.3-1, and the same norms for other pairs. Returns whether ours agree with the thesis's."""
    print_title("Table 2.3-1. Differences at the 15 points between the walls, 129 x 129, per cent of the lid speed")
    printed = cavity.read_reference("thesis_Re1000_differences_from_ghia.csv")
    thesis, ghia, spectral = cavity.thesis(), cavity.ghia(1000), cavity.botella_peyret()
    print_head("pair", *(name.replace("_", " ") for name in NORMS))
    print_row("washfsi, read linearly - Ghia et al.", *map(percent, cavity.norms(flow, ghia, interpolate_linearly)))
    print_row("thesis - Ghia et al., as printed", *(f"{printed[name][0]:.2f}" for name in NORMS))
    pairs = {"thesis - Ghia et al., from its tables": (thesis, ghia),
             "washfsi - Ghia et al.": (flow, ghia), "washfsi - Botella and Peyret": (flow, spectral),
             "thesis - Botella and Peyret": (thesis, spectral), "Ghia et al. - Botella and Peyret": (ghia, spectral)}
    for name, pair in pairs.items():
        print_row(name, *map(percent, cavity.norms(*pair)))
    signed = cavity.differences(flow.v, ghia[1], interpolate_linearly).max()
    print(f"\nLargest difference in v with its sign, washfsi read linearly - Ghia et al.: {percent(signed)} %")
    rms = cavity.norms(flow, ghia, interpolate_linearly)[0::2]
    return np.allclose([100 * value for value in rms], [printed[name][0] for name in NORMS[0::2]], rtol=0,
                       atol=MOST_OFF_PERCENT)


def print_points(title, axis, name, ours, references):
    """Tables 2.3-2 and 2.3-3: a component at the places of Ghia et al. Returns whether ours agrees with the thesis."""
    print_title(title)
    print_head(axis, f"{name}, read linearly", "thesis", f"{name}, read cubically", "Ghia et al.", "Botella and Peyret")
    thesis, *others = references
    linear, cubic = [read(ours, thesis.places) for read in (interpolate_linearly, cavity.interpolate)]
    for place, *values in zip(thesis.places, linear, thesis.values, cubic, *(line.values for line in others)):
        print_row(f"{place:.4f}", *(f"{value:.5f}" for value in values))
    off = cavity.largest(linear - thesis.values)
    print(f"\nLargest difference from the thesis: {off:.1e}")
    return off <= MOST_OFF


def print_extrema(coarse, fine):
    """Extrema of both lines, which the thesis does not give."""
    print_title("Extrema on the centre lines and their places")
    reference = cavity.read_reference("botella_peyret1998_Re1000_extrema.csv")
    print_head("extremum", "129 x 129", "257 x 257", "Botella and Peyret")
    for row, (name, find, line) in enumerate([("least u", cavity.lowest, 0), ("largest v", cavity.highest, 1),
                                              ("least v", cavity.lowest, 1)]):
        found = [find(flow[line]) for flow in (coarse, fine)] + [(reference["value"][row], reference["place"][row])]
        print_row(name, *(f"{value:.5f} at {place:.4f}" for value, place in found))


def rates_of(errors):
    """The rates that errors on the grids show, in each norm; a row less than there are grids."""
    return [[cavity.order(*pair, 2) for pair in zip(*rows)] for rows in zip(errors, errors[1:])]


def print_grids(title, name, ours, thesis):
    """Tables 2.3-4 and 2.3-5: differences of a component from the finest grid, and rates."""
    print_title(title)
    print_head("cells", f"{name} rms", "rate", f"{name} max", "rate", "thesis rms", "rate", "thesis max", "rate")
    for row, cells in enumerate(GRIDS):
        words = []
        for errors, digits in ((ours, 3), (thesis, 2)):
            rates = rates_of(errors)
            for norm in (0, 1):
                words += [f"{errors[row][norm]:.{digits}f}", f"{rates[row - 1][norm]:.2f}" if row else ""]
        print_row(f"{cells} x {cells}", *words)


def print_grid_tables(flows):
    """Tables 2.3-4 and 2.3-5. Returns whether ours agree with the thesis's and show second order."""
    printed = cavity.read_reference("thesis_Re1000_differences_from_257.csv")
    places = [line.places for line in cavity.ghia(1000)]
    fine = [cavity.Line(at, interpolate_linearly(line, at)) for at, line in zip(places, flows[FINEST])]
    ours = 100 * np.array([cavity.norms(flows[cells], fine, interpolate_linearly) for cells in GRIDS])
    thesis = np.array([printed[name] for name in NORMS]).T
    for first, name, number in ((0, "u", "2.3-4"), (2, "v", "2.3-5")):
        print_grids(f"Table {number}. Differences in {name} from {FINEST} x {FINEST}, per cent of the lid speed", name,
                    ours[:, first:first + 2], thesis[:, first:first + 2])
    return cavity.largest(ours - thesis) <= MOST_OFF_PERCENT and np.min(rates_of(ours)[-1]) >= LEAST_RATE


def main():
    flows = {cells: cavity.run_cavity(cells, 1000) for cells in [*GRIDS, FINEST]}
    medium = flows[129]
    print_origin()
    references = list(zip(cavity.thesis(), cavity.ghia(1000), cavity.botella_peyret()))
    passed = [flow.is_steady() for flow in flows.values()]
    passed.append(print_comparison(medium))
    passed.append(print_points("Table 2.3-2. u at x = 0.5, 129 x 129", "y", "u", medium.u, references[0]))
    passed.append(print_points("Table 2.3-3. v at y = 0.5, 129 x 129", "x", "v", medium.v, references[1]))
    print_extrema(medium, flows[FINEST])
    passed.append(print_grid_tables(flows))
    return 0 if all(passed) else 1


if __name__ == "__main__":
    sys.exit(main())
