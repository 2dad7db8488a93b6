# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the lid-driven cavity share: running a case, its centre lines, reference tables, differences.

The cavity is inputs/cavity.opts: unit square or cube, lid at y = 1 moving at 1 m/s in x, density 1. ctest sets the
environment: WASHFSI_PROGRAM is the program, WASHFSI_SOURCE the root of the sources.
"""

from typing import NamedTuple

import numpy as np

import results
from tables import (ARGUMENTS, CAVITY, SOURCE, print_head, print_origin, print_record,  # noqa: F401
                    print_record_head, print_row, read_columns)  # (for the tests)

REFERENCE = SOURCE / "tests" / "verification" / "reference" / "cavity"
RANKS = 2
COURANT = {"central": 0.8, "wide_central": 0.5}  # time step over spacing; the steady state does not depend on it
STEADY_AFTER = {100: 50, 400: 90, 1000: 160, 3200: 600, 5000: 900}  # [s] from rest, in the plane
MOST_DRIFT = 5e-6  # of the kinetic energy, relative, in the last ten seconds of a run that counts as steady
IN_SPACE = ["-grid_lower", "0,0,0", "-grid_upper", "1,1,1", "-bc_y_upper_velocity", "1,0,0"]
MISPRINTED = {("u", 3200): 0.4531, ("v", 400): 0.9063}  # places in the tables of Ghia et al.; see the README there


class Line(NamedTuple):
    """A velocity component along a centre line, or its reference, at some places from wall to wall."""
    places: np.ndarray
    values: np.ndarray


class Flow(NamedTuple):
    """The end of a run."""
    u: Line  # on the vertical centre line
    v: Line  # on the horizontal centre line
    drift: float  # relative change of the kinetic energy in the last ten seconds

    def is_steady(self):
        """Whether the kinetic energy had stopped to change."""
        return abs(self.drift) < MOST_DRIFT


def run_cavity(cells, reynolds, end=None, dimensions=2, advection="central", options=()):
    """Runs the cavity with so many cells a side from rest to the end [s], by default the steady state in the plane."""
    return read_flow(run_along(cells, reynolds, (*centre_line_options(cells, dimensions), *options), end, dimensions, advection).folder)


def run_along(cells, reynolds, profiles, end=None, dimensions=2, advection="central"):
    """The run of the cavity with some profiles."""
    end = end or STEADY_AFTER[reynolds]
    return results.run(RANKS, "-options_file", CAVITY, "-fluid_viscosity", repr(1 / reynolds), "-grid_cells",
                       ",".join([str(cells)] * dimensions), *(IN_SPACE if dimensions == 3 else []), "-advection", advection,
                       "-time_step", repr(COURANT[advection] / cells), "-time_end", end, "-output_interval", end,
                       "-checkpoint_interval", 0.1 * end, *profiles)


def centre_line_options(cells, dimensions):
    """Options that sample both centre lines at the grid's own points."""
    first, last, middle = repr(0.5 / cells), repr(1 - 0.5 / cells), ["0.5"] * (dimensions - 2)
    ends = {"vertical_from": ["0.5", first], "vertical_to": ["0.5", last],
            "horizontal_from": [first, "0.5"], "horizontal_to": [last, "0.5"]}
    options = ["-profiles", "vertical,horizontal", "-vertical_points", cells, "-horizontal_points", cells]
    for name, point in ends.items():
        options += [f"-{name}", ",".join(point + middle)]
    return options


def read_flow(folder):
    """Reads what a run left: centre lines, with the velocity of the walls at their ends, and the drift of the energy."""
    vertical = read_columns(folder / "profiles" / "vertical.csv")
    horizontal = read_columns(folder / "profiles" / "horizontal.csv")
    history = read_columns(folder / "history.csv")
    time, energy = history["time"], history["kinetic_energy"]
    earlier = np.interp(time[-1] - 10, time, energy)
    return Flow(between_walls(vertical["y"], vertical["u"], 1), between_walls(horizontal["x"], horizontal["v"], 0),
                energy[-1] / earlier - 1)


def between_walls(places, values, upper):
    """Adds both walls to a line: the lower one is at rest."""
    return Line(np.concatenate([[0], places, [1]]), np.concatenate([[0], values, [upper]]))


def read_reference(name):
    """A table of published data, with # comments and a row of names, as a dictionary of columns."""
    lines = [line for line in (REFERENCE / name).read_text().splitlines() if line and not line.startswith("#")]
    values = np.array([[float(word) for word in line.split(",")] for line in lines[1:]])
    return dict(zip(lines[0].split(","), values.T))


def reference_lines(u_name, v_name, u_column="u", v_column="v"):
    """The lines of u and v of two tables."""
    u, v = read_reference(u_name), read_reference(v_name)
    return Line(u["y"], u[u_column]), Line(v["x"], v[v_column])


def botella_peyret():
    """Botella and Peyret (1998): spectral, Re = 1000."""
    return reference_lines("botella_peyret1998_Re1000_u_x0.5.csv", "botella_peyret1998_Re1000_v_y0.5.csv")


def ghia(reynolds):
    """Ghia, Ghia and Shin (1982) without their misprinted values."""
    lines = reference_lines("ghia1982_u_x0.5.csv", "ghia1982_v_y0.5.csv", f"u_Re{reynolds}", f"v_Re{reynolds}")
    good = [line.places != MISPRINTED.get((name, reynolds)) for name, line in zip("uv", lines)]
    return tuple(Line(line.places[keep], line.values[keep]) for line, keep in zip(lines, good))


def thesis():
    """The thesis's tables 2.3-2 and 2.3-3: 129 x 129, Re = 1000."""
    return reference_lines("thesis_Re1000_u_x0.5.csv", "thesis_Re1000_v_y0.5.csv")


def erturk(reynolds):
    """Erturk, Corke and Gokcol (2005), 601 x 601 points."""
    return reference_lines("erturk2005_u_x0.5.csv", "erturk2005_v_y0.5.csv", f"Re{reynolds}", f"Re{reynolds}")


def interpolate(line, places):
    """Lagrange's cubic through the four points round each place: its error is far below the scheme's."""
    places = np.atleast_1d(places)
    first = np.clip(np.searchsorted(line.places, places) - 2, 0, len(line.places) - 4)
    near = line.places[first[:, None] + np.arange(4)]
    weights = np.ones_like(near)
    for i in range(4):
        for j in set(range(4)) - {i}:
            weights[:, i] *= (places - near[:, j]) / (near[:, i] - near[:, j])
    return np.sum(weights * line.values[first[:, None] + np.arange(4)], axis=1)


def interpolate_linearly(line, places):
    """The thesis's way of reading a line between grid points; it costs up to 0.25 % of the lid speed at 129 x 129."""
    return np.interp(places, line.places, line.values)


def differences(line, reference, read=interpolate):
    """Line minus reference at the reference's places between the walls."""
    inside = (reference.places > 0) & (reference.places < 1)
    return read(line, reference.places[inside]) - reference.values[inside]


def lowest(line):
    """The least value on a line and its place."""
    places = np.linspace(0, 1, 100001)
    values = interpolate(line, places)
    return values.min(), places[values.argmin()]


def highest(line):
    """The largest value on a line and its place."""
    value, place = lowest(Line(line.places, -line.values))
    return -value, place


def norms(flow, reference, read=interpolate):
    """Root mean square and maximum of the difference in u, then in v, between two pairs of lines."""
    by_line = [differences(*pair, read) for pair in zip(flow[:2], reference)]
    return [norm(line) for line in by_line for norm in (rms, largest)]


def rms(values):
    """Root mean square."""
    return np.sqrt(np.mean(np.square(values)))


def largest(values):
    """Largest magnitude."""
    return np.abs(values).max()


def order(coarse, fine, ratio):
    """Order of convergence that two errors show, the grids being finer by a ratio."""
    return np.log(coarse / fine) / np.log(ratio)


def percent(value):
    """In per cent of the lid speed."""
    return f"{100 * value:.3f}"
