# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 4.3.2: flow past a circular cylinder at Re = 100. Mean drag, amplitude of the lift and Strouhal number."""

import functools
from typing import NamedTuple

import numpy as np

import results
from tables import read_columns
from thesis.rows import THEIRS, TODAY, Row, case_file

SETTLED = 110  # [s] by then the shedding is periodic
COST = "not run: {} h on one core"


class Shedding(NamedTuple):
    """Mean drag, amplitude of the lift, Strouhal number and whole periods seen."""
    cd: float
    cl: float
    st: float
    periods: int


def shedding(history, prefix="cylinder_force"):
    """Coefficients over the last whole periods of the lift, which rises through its mean once in each."""
    late = history["time"] >= SETTLED
    time, cd, cl = history["time"][late], 2 * history[f"{prefix}_x"][late], 2 * history[f"{prefix}_y"][late]
    level = cl - 0.5 * (cl.max() + cl.min())
    rises = np.flatnonzero((level[:-1] < 0) & (level[1:] >= 0))
    crossings = time[rises] - level[rises] * (time[rises + 1] - time[rises]) / (level[rises + 1] - level[rises])
    whole = (time >= crossings[0]) & (time <= crossings[-1])
    mean = np.trapz(cd[whole], time[whole]) / (time[whole][-1] - time[whole][0])
    amplitude = np.mean([0.5 * np.ptp(cl[a:b]) for a, b in zip(rises, rises[1:])])
    periods = len(crossings) - 1
    return Shedding(mean, amplitude, periods / (crossings[-1] - crossings[0]), periods)


def flow(numerics, cells, width, *options):
    """The shedding in a box of a width in diameters, a quarter of it ahead of the cylinder."""
    result = results.run(1, "-options_file", case_file(numerics, "cylinder"), "-grid_cells", f"{cells},{cells}", "-grid_lower",
                         f"{-0.25 * width},{-0.5 * width}", "-grid_upper", f"{0.75 * width},{0.5 * width}", "-body_balance",
                         "false", "-time_end", 170, "-checkpoint_interval", 10, *options)
    return shedding(read_columns(result.folder / "history.csv"))


def loads(numerics, cells, width, options=()):
    """Mean drag coefficient and amplitude of the lift's."""
    return flow(numerics, cells, width, *options)[:2]


def strouhal(numerics, cells, width, options=()):
    """Strouhal number."""
    return flow(numerics, cells, width, *options).st


def of_mask(smooth):
    """Options of the smooth mask, which today's walls do not have."""
    return ("-body_mask", "smooth") if smooth else ()


def far_field_rows(table, smooth, figures):
    """Tables 4.3-3 and 4.3-4: the box, at 34.2 cells a diameter, and at 17.1 where that is too dear."""
    name = "smooth" if smooth else "sharp"
    only = {"numerics": (THEIRS,), "not_run": "no mask"} if smooth else {}
    for width, figure in zip((15, 30, 60), figures):
        cells = 34 * width if width < 30 else 17 * width
        yield Row(table, f"{name} mask, a/d = {width}, d/h = {cells // width}", "Cd (Cl)", figure,
                  functools.partial(loads, cells=round(512 * cells / 510), width=width, options=of_mask(smooth)), **only)


def rows():
    """Tables 4.3-3 to 4.3-8."""
    yield from far_field_rows("4.3-3", False, ("1.53 (0.38)", "1.39 (0.35)", "1.34 (0.33)"))
    yield from far_field_rows("4.3-4", True, ("1.63 (0.45)", "1.48 (0.40)", "1.41 (0.37)"))
    only = {"numerics": (THEIRS,), "not_run": "no mask"}
    for cells, sharp, smooth in ((512, "1.33 (0.29)", "1.59 (0.45)"), (1024, "1.39 (0.35)", "1.48 (0.40)"),
                                 (2048, "1.40 (0.35)", "1.43 (0.37)")):
        never = {"numerics": (), "not_run": COST.format(30)} if cells == 2048 else {}
        yield Row("4.3-5", f"sharp mask, {cells} x {cells}", "Cd (Cl)", sharp, functools.partial(loads, cells=cells, width=30), **never)
        yield Row("4.3-6", f"smooth mask, {cells} x {cells}", "Cd (Cl)", smooth,
                  functools.partial(loads, cells=cells, width=30, options=of_mask(True)), **(never or only))
    for name, cfl in (("dt*", 0.5), ("dt*/2", 0.25)):
        yield Row("4.3-7", f"sharp mask, 512 x 512, {name}", "Cd (Cl)", "1.39 (0.35), 1024 x 1024",
                  functools.partial(loads, cells=512, width=30, options=("-time_cfl", cfl)))
    yield Row("4.3-8", "a/d = 30, 512 x 512", "St", "0.166 +- 0.010", functools.partial(strouhal, cells=512, width=30))
    yield Row("4.3-8", "a/d = 60, 1024 x 1024", "St", "0.166 +- 0.010", functools.partial(strouhal, cells=1024, width=60))
