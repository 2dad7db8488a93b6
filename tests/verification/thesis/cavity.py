# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 2.3: the lid-driven cavity at Re = 1000. The thesis's "129 x 129" is taken as 129 cells a side."""

import functools
import math

import numpy as np

import cavity
from thesis import checks
from thesis.rows import THEIRS, Row

COARSE, FINEST = (33, 65, 129), 257
NORMS = ("u_rms", "u_max", "v_rms", "v_max")
ROUNDING = 2e-5  # of the thesis's velocities, and of ours beside them
OFF = {"2.3-1": 0.011, "2.3-2": 1e-5, "2.3-3": 1e-5, "2.3-4": 0.011, "2.3-5": 0.011}  # from the thesis: its last digit
LEAST_ORDER = 2.1
DRIFT = "change of the kinetic energy in the last ten seconds, relative"
PERCENT = "difference from 257 x 257 cells [% of the lid speed]"


def flow(numerics, cells):
    """The steady flow."""
    return cavity.run_cavity(cells, 1000, options=("-advection_steps", 2) if numerics == THEIRS else ())


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


def drift(numerics, cells):
    """Relative change of the kinetic energy in the last ten seconds."""
    return abs(flow(numerics, cells).drift)


def rows():
    """Tables 2.3-1 to 2.3-5."""
    printed = cavity.read_reference("thesis_Re1000_differences_from_ghia.csv")
    for norm, name in enumerate(NORMS):
        yield Row("2.3-1", name.replace("_", " "), "difference from Ghia et al. [% of the lid speed]", f"{printed[name][0]:.2f}",
                  functools.partial(from_ghia, norm=norm))
    for line, (table, axis, name) in enumerate((("2.3-2", "y", "u"), ("2.3-3", "x", "v"))):
        for place, value in zip(*cavity.thesis()[line]):
            yield Row(table, f"{axis} = {place:.4f}", f"{name} [m/s]", f"{value:.5f}",
                      functools.partial(velocity, line=line, place=place), within=max(0.002, ROUNDING / max(abs(value), ROUNDING)))
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
        printed = {row.what: float(row.thesis) for row in rows() if row.table == table and row.thesis and row.what != "v max"}
        yield checks.Check(table, "largest difference from the thesis's figures" + " but v max" * (table == "2.3-1"), tuple(printed),
                           lambda figures, printed=tuple(printed.values()): max(abs(ours - theirs) for ours, theirs in zip(figures, printed)),
                           most=off)
    for norm, name in enumerate(NORMS):
        what = name.replace("_", " ")
        yield checks.order("2.3-4" if norm < 2 else "2.3-5", f"65 x 65, {what}", f"129 x 129, {what}", 2, LEAST_ORDER, quantity=PERCENT)
    yield checks.largest("2.3-4", DRIFT, [f"{cells} x {cells}" for cells in (*COARSE, FINEST)], cavity.MOST_DRIFT)
