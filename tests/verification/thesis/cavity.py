# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 2.3: the lid-driven cavity at Re = 1000. The thesis's "129 x 129" is taken as 129 cells a side."""

import functools

import numpy as np

import cavity
from thesis.rows import THEIRS, Row

COARSE, FINEST = (33, 65, 129), 257
NORMS = ("u_rms", "u_max", "v_rms", "v_max")
ROUNDING = 2e-5  # of the thesis's velocities, and of ours beside them


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
                          "difference from 257 x 257 cells [% of the lid speed]", f"{printed[NORMS[norm]][row]:.2f}",
                          functools.partial(from_finest, cells=cells, norm=norm))
