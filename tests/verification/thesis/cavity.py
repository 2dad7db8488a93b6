# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 2.3: the lid-driven cavity at Re = 1000. The thesis's "129 x 129" is taken as 129 cells a side."""

import functools
import math

import numpy as np

import cavity
from tables import read_columns
from thesis import checks
from thesis.rows import THEIRS, Row

COARSE, FINEST = (33, 65, 129), 257
NORMS = ("u_rms", "u_max", "v_rms", "v_max")
ROUNDING = 2e-5  # of the thesis's velocities, and of ours beside them
OFF = {"2.3-1": 0.011, "2.3-2": 1e-5, "2.3-3": 1e-5, "2.3-4": 0.011, "2.3-5": 0.011}  # from the thesis: its last digit
MISPRINTED = "v_max"  # less than v_rms, and than Table 2.3-3 gives
LEAST_ORDER = 2.1
DRIFT = "change of the kinetic energy in the last ten seconds, relative"
VORTICES = "length along the floor, over the side"
LEAST_VORTEX = 0.1  # over the side: shorter ones are not seen on a picture
PERCENT = "difference from 257 x 257 cells [% of the lid speed]"


def two_steps(numerics):
    """Options of the thesis's advection."""
    return ("-advection_steps", 2) if numerics == THEIRS else ()


def flow(numerics, cells):
    """The steady flow."""
    return cavity.run_cavity(cells, 1000, options=two_steps(numerics))


def from_ghia(numerics, norm):
    """A norm of the differences from Ghia et al. on 129 x 129 cells [% of the lid speed]."""
    return 100 * cavity.norms(flow(numerics, 129), cavity.ghia(1000), cavity.interpolate_linearly)[norm]


def velocity(numerics, line, place):
    """A velocity on a centre line of 129 x 129 cells, between grid points linearly."""
    return cavity.interpolate_linearly(flow(numerics, 129)[line], np.array([place]))[0]


def from_finest(numerics, cells, norm):
    """A norm of the differences from 257 x 257 cells at the places of Ghia et al. [% of the lid speed]."""
    places = [line.places for line in cavity.ghia(1000)]
    fine = [cavity.Line(at, cavity.interpolate_linearly(line, at)) for at, line in zip(places, flow(numerics, FINEST))]
    return 100 * cavity.norms(flow(numerics, cells), fine, cavity.interpolate_linearly)[norm]


def vortices(numerics):
    """Lengths along the floor of the vortices in the bottom left and right corner over the side, where the water half a cell above it
    flows the other way than in the middle, on 129 x 129 cells."""
    height = repr(0.5 / 129)
    result = cavity.run_along(129, 1000, ("-profiles", "floor", "-floor_points", 1001, "-floor_from", f"0,{height}", "-floor_to", f"1,{height}",
                                          *two_steps(numerics)))
    floor = read_columns(result.folder / "profiles" / "floor.csv")
    turned = floor["x"][floor["u"] < 0]
    return turned[0], 1 - turned[-1]


def drift(numerics, cells):
    """Relative change of the kinetic energy in the last ten seconds."""
    return abs(flow(numerics, cells).drift)


def rows():
    """Tables 2.3-1 to 2.3-5."""
    printed = cavity.read_reference("thesis_Re1000_differences_from_ghia.csv")
    for norm, name in enumerate(NORMS):
        misprint = ", a misprint" * (name == MISPRINTED)
        yield Row("2.3-1", name.replace("_", " "), "difference from Ghia et al. [% of the lid speed]", f"{printed[name][0]:.2f}{misprint}",
                  functools.partial(from_ghia, norm=norm), comparable=not misprint)
    for line, (table, axis, name) in enumerate((("2.3-2", "y", "u"), ("2.3-3", "x", "v"))):
        for place, value in zip(*cavity.thesis()[line]):
            yield Row(table, f"{axis} = {place:.4f}", f"{name} [m/s]", f"{value:.5f}",
                      functools.partial(velocity, line=line, place=place), within=max(0.002, ROUNDING / max(abs(value), ROUNDING)))
    yield Row("2.3, vortices", "bottom left (right), 129 x 129", VORTICES, "seen", vortices)
    printed = cavity.read_reference("thesis_Re1000_differences_from_257.csv")
    for table, first in (("2.3-4", 0), ("2.3-5", 2)):
        for row, cells in enumerate(COARSE):
            for norm in (first, first + 1):
                yield Row(table, f"{cells} x {cells}, {NORMS[norm].replace('_', ' ')}",
                          PERCENT, f"{printed[NORMS[norm]][row]:.2f}",
                          functools.partial(from_finest, cells=cells, norm=norm))
        if first == 0:
            for cells in (*COARSE, FINEST):
                yield Row(table, f"{cells} x {cells}", DRIFT, "", functools.partial(drift, cells=cells), within=math.inf)


def claims():
    """All digits that the thesis prints, steady flows, and order 2."""
    for table, off in OFF.items():
        printed = {row.what: row.printed() for row in rows() if row.table == table and row.printed() is not None}
        yield checks.Check(table, "largest difference from the thesis's figures" + " but v max" * (table == "2.3-1"), tuple(printed),
                           lambda figures, printed=tuple(printed.values()): max(abs(ours - theirs) for ours, theirs in zip(figures, printed)),
                           most=off)
    for part, corner in enumerate(("left", "right")):
        yield checks.Check("2.3, vortices", f"{VORTICES}, {corner}", ("bottom left (right), 129 x 129",), max, least=LEAST_VORTEX, part=part)
    of_grids = cavity.read_reference("thesis_Re1000_differences_from_257.csv")
    for norm, name in enumerate(NORMS):
        what, (_, figure_65, figure_129) = name.replace("_", " "), of_grids[name]
        yield checks.order("2.3-4" if norm < 2 else "2.3-5", f"65 x 65, {what}", f"129 x 129, {what}", 2, LEAST_ORDER, quantity=PERCENT,
                           thesis=f"{math.log2(figure_65 / figure_129):.2f}")
    yield checks.largest("2.3-4", DRIFT, [f"{cells} x {cells}" for cells in (*COARSE, FINEST)], cavity.MOST_DRIFT)
