# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 4.3.2: flow past a circular cylinder at Re = 100. Mean drag, amplitude of the lift and Strouhal number."""

import functools
from typing import NamedTuple

import numpy as np

import results
from tables import read_columns
from thesis import checks
from thesis.rows import THEIRS, Row, case_file

SETTLED = 110  # [s] by then the shedding is periodic
NEVER = {"numerics": ()}  # on 2048 x 2048 cells
NO_MASK, LOADS = "no mask", "Cd (Cl)"
OF_STEP = 0.01  # Cd may change by so much with half the step


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


def load_row(table, mask, what, thesis, **arguments):
    """A row of mean drag and lift, of the smooth mask with the thesis's numerics alone."""
    smooth = mask == "smooth"
    only = {"numerics": (THEIRS,), "not_run": NO_MASK} if smooth else {}
    options = {key: arguments.pop(key) for key in ("numerics", "comparable") if key in arguments}
    return Row(table, f"{mask} mask, {what}", LOADS, thesis, functools.partial(loads, options=of_mask(smooth), **arguments), **{**only, **options})


def far_field_rows(table, mask, figures):
    """Tables 4.3-3 and 4.3-4: the box, at 34.2 cells a diameter, and the widest at 17.1 too."""
    for width, cells, figure in zip((15, 30), (512, 1024), figures):
        yield load_row(table, mask, f"a/d = {width}, d/h = 34", figure, cells=cells, width=width)
    yield load_row(table, mask, "a/d = 60, d/h = 34", figures[2], cells=2048, width=60, **NEVER)
    coarse = f"{figures[2]}, by Table 4.3-8" if mask == "smooth" else f"{figures[2]}, d/h = 34.2"
    yield load_row(table, mask, "a/d = 60, d/h = 17", coarse, cells=1024, width=60, comparable=mask == "smooth")


def literature_rows():
    """Table 4.3-8, on the finest grids that we have."""
    for mask, width, figure, cells in (("sharp", 30, "1.40 (0.35)", 2049), ("sharp", 60, "1.34 (0.33)", 2049),
                                       ("smooth", 30, "1.43 (0.37)", 2049), ("smooth", 60, "1.41 (0.37)", 1025)):
        what = f"a/d = {width}, 1024 x 1024"
        yield load_row("4.3-8", mask, what, f"{figure}, {cells} x {cells}", cells=1024, width=width, comparable=cells == 1025)
        only = {"numerics": (THEIRS,), "not_run": NO_MASK} if mask == "smooth" else {}
        yield Row("4.3-8", f"{mask} mask, {what}", "St", f"0.166 +- 0.0098, {cells} x {cells}",
                  functools.partial(strouhal, cells=1024, width=width, options=of_mask(mask == "smooth")), **only)


def on(mask, cells):
    """What a grid is called in Tables 4.3-5 to 4.3-7."""
    return f"{mask} mask, {cells} x {cells}"


def rows():
    """Tables 4.3-3 to 4.3-8. The thesis's grids have one cell more: 513, 1025 and 2049."""
    yield from far_field_rows("4.3-3", "sharp", ("1.53 (0.38)", "1.39 (0.35)", "1.34 (0.33)"))
    yield from far_field_rows("4.3-4", "smooth", ("1.63 (0.45)", "1.48 (0.40)", "1.41 (0.37)"))
    for cells, sharp, smooth in ((512, "1.33 (0.29)", "1.59 (0.45)"), (1024, "1.39 (0.35)", "1.48 (0.40)"),
                                 (2048, "1.40 (0.35)", "1.43 (0.37)")):
        for table, mask, figure in (("4.3-5", "sharp", sharp), ("4.3-6", "smooth", smooth)):
            yield load_row(table, mask, f"{cells} x {cells}", f"{figure}, {cells + 1} x {cells + 1}", cells=cells, width=30,
                            **(NEVER if cells == 2048 else {}))
    for name, cfl in (("dt*", 0.5), ("dt*/2", 0.25)):
        yield Row("4.3-7", f"{on('sharp', 512)}, {name}", LOADS, "1.39 (0.35), 1025 x 1025",
                  functools.partial(loads, cells=512, width=30, options=("-time_cfl", cfl)), comparable=False)
    yield from literature_rows()


def claims():
    """With the thesis's numerics loads rise with the grid with the sharp mask, and fall with the smooth one; steps do not matter."""
    for table, mask, trend in (("4.3-5", "sharp", checks.rises), ("4.3-6", "smooth", checks.falls)):
        for part, load in enumerate(("Cd", "Cl")):
            check = trend(table, [on(mask, cells) for cells in (512, 1024)], part=part, numerics=(THEIRS,))
            yield check._replace(claim=f"{load}: {check.claim}")
    yield checks.Check("4.3-7", "Cd with dt*/2 over that with dt*", tuple(f"{on('sharp', 512)}, {name}" for name in ("dt*", "dt*/2")),
                       lambda figures: figures[1] / figures[0], 1 - OF_STEP, 1 + OF_STEP)
