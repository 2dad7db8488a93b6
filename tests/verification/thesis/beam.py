# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 3.5.2: a beam held at its middle bends under its weight; each half against Bickley's heavy cantilever.

The error is the root mean square distance of the right half's markers, the middle one included, from the exact points at
their arclengths k ds from the support, over L = (n - 1/2) ds with n markers on a half. The support is where the spring
holds, the origin.
"""

import functools

import numpy as np

import results
from tables import SOURCE, read_columns
from thesis import checks
from thesis.rows import THEIRS, TODAY, Row, case_file

EXACT = SOURCE / "tests" / "verification" / "reference" / "elastica"
# cells a side: markers on a half, error in the thesis
GRIDS = {65: (9, "5.21e-2"), 129: (17, "8.5e-3"), 257: (33, "3.2e-3"), 513: (65, "1.9e-3")}
RATES = ("2.65", "1.42", "0.75")  # of the thesis
SOFT = ("-beam_ke", 1.27e4)  # [N/m] 1.27e3 w L as in the thesis, a sixteenth of ours
PULLS = (0.5, 1, 2, 5, 10)  # alpha_o
BENDING_LENGTH, WEIGHT = 0.1 ** (1 / 3), 10  # c = (Kb/w)^(1/3) [m], w [N/m2]; L = 1 m
STEPS = {65: 1e-3, 129: 2.5e-4}  # [s] about the longest that Broyden's method converges with
TODAY_ALONE = (257, 513)  # the others take hours
MOST_UNEVEN = 1e-8
LEAST_ORDER = 1.8
LATEST_REST = 39  # [s] a run that gets to 40 s did not come to rest
NO_REST = "the water is so viscous for the step there, mu dt/(rho h^2) = 30, that forces of the beam's shortest waves fade slowly"
NO_STRETCH = "so stiff a beam hardly stretches, and a pull straightens it, so the error falls with alpha_o"
UNEVEN, REST = "difference of the halves/L", "at rest after [s]"


def exact_points(alpha, arclengths):
    """Points of Bickley's cantilever, between those of the file by cubics that keep the slope."""
    table = np.genfromtxt(EXACT / f"bickley_b3_10_alpha_{alpha:g}.csv", delimiter=",", skip_header=2)
    s, slope = table[:, 0], np.column_stack([np.cos(table[:, 3]), np.sin(table[:, 3])])
    k = np.clip(np.searchsorted(s, arclengths) - 1, 0, len(s) - 2)
    step = (s[k + 1] - s[k])[:, None]
    t = (arclengths - s[k])[:, None] / step
    return ((1 + 2 * t) * (1 - t) ** 2 * table[k, 1:3] + t ** 2 * (3 - 2 * t) * table[k + 1, 1:3]
            + t * (1 - t) ** 2 * step * slope[k] - t ** 2 * (1 - t) * step * slope[k + 1])


def bend(numerics, cells, alpha=0, options=()):
    """The folder of a run to rest."""
    half, pull = GRIDS[cells][0], alpha * WEIGHT * BENDING_LENGTH
    return results.run(1, "-options_file", case_file(numerics, "beam"), "-grid_cells", f"{cells},{cells}", "-beam_markers", 2 * half - 1,
                       "-beam_end_force_last", f"{pull},0", "-beam_end_force_first", f"{-pull},0", "-checkpoint_interval", 1,
                       *(["-time_step", STEPS[cells]] if numerics == THEIRS else []), *options).folder


def markers(folder):
    """The beam's markers at the end of a run."""
    return np.genfromtxt(folder / "cloth_final.csv", delimiter=",", skip_header=2, usecols=(4, 5))


def error(numerics, cells, alpha=0, options=()):
    """Distance of the right half from Bickley's cantilever, over L."""
    half = GRIDS[cells][0]
    off = markers(bend(numerics, cells, alpha, options))[half - 1:] - exact_points(alpha, np.arange(half) / (half - 0.5))
    return np.sqrt(np.mean(np.sum(off ** 2, axis=1)))


def uneven(numerics, cells):
    """Largest distance of the right half from the mirrored left one, over L."""
    half, places = GRIDS[cells][0], markers(bend(numerics, cells))
    return np.abs(places[half - 1:] - places[half - 1::-1] * [-1, 1]).max()


def rest(numerics, cells):
    """When neither a marker nor the water at it had been faster than 1e-5 m/s for ten steps [s]; the end of the run if never."""
    return read_columns(bend(numerics, cells) / "history.csv")["time"][-1]


def name_of(cells):
    """What a grid is called in the table."""
    return f"{cells} x {cells}, {GRIDS[cells][0]} markers on a half"


def soft_rows():
    """Both tables with a beam that stretches as the thesis's."""
    for cells, (_, figure) in GRIDS.items():
        few = {"numerics": (TODAY,)} if cells in TODAY_ALONE else {}
        yield Row("3.5-10, Ke = 1.27e3 w L", name_of(cells), "rms error/L", figure,
                  functools.partial(error, cells=cells, options=SOFT), is_error=True, **few)
    for alpha in PULLS:
        yield Row("3.5-11, Ke = 1.27e3 w L", f"alpha_o = {alpha}, 129 x 129", "rms error/L", "not in our copy, 513 x 513",
                  functools.partial(error, cells=129, alpha=alpha, options=SOFT), numerics=(TODAY,))


def rows():
    """Tables 3.5-10 and 3.5-11."""
    for quantity, measure in (("rms error/L", error), (UNEVEN, uneven), (REST, rest)):
        for cells, (_, figure) in GRIDS.items():
            few = {"numerics": (TODAY,)} if cells in TODAY_ALONE else {}
            of_thesis = {"thesis": figure, "is_error": True} if measure is error else {"thesis": ""}
            within = {"within": float("inf")} if measure is uneven else {}
            yield Row("3.5-10", name_of(cells), quantity, measure=functools.partial(measure, cells=cells), **few, **of_thesis, **within)
    for alpha in PULLS:
        yield Row("3.5-11", f"alpha_o = {alpha}, 129 x 129", "rms error/L", "not in our copy, 513 x 513",
                  functools.partial(error, cells=129, alpha=alpha), numerics=(TODAY,))
    yield from soft_rows()


def claims():
    """Order, symmetry and rest."""
    only = {"numerics": (TODAY,)}
    for coarse, fine, rate in zip(GRIDS, list(GRIDS)[1:], RATES):
        yield checks.order("3.5-10", name_of(coarse), name_of(fine), fine / coarse, LEAST_ORDER, quantity="rms error/L", thesis=rate, **only)
        yield checks.order("3.5-10, Ke = 1.27e3 w L", name_of(coarse), name_of(fine), fine / coarse, thesis=rate, **only)
    for table, why in (("3.5-11", NO_STRETCH), ("3.5-11, Ke = 1.27e3 w L", "")):
        yield checks.Check(table, "least error between the least and the largest alpha_o over that at these",
                           tuple(f"alpha_o = {alpha}, 129 x 129" for alpha in PULLS),
                           lambda figures: min(figures[1:-1]) / min(figures[0], figures[-1]), most=1, miss=why, **only)
    yield checks.largest("3.5-10", UNEVEN, [name_of(cells) for cells in STEPS], MOST_UNEVEN)
    yield checks.largest("3.5-10", UNEVEN, [name_of(cells) for cells in TODAY_ALONE], MOST_UNEVEN, **only)
    yield checks.largest("3.5-10", REST, [name_of(cells) for cells in (65, 129, 257)], LATEST_REST, **only)
    yield checks.largest("3.5-10", REST, [name_of(513)], LATEST_REST, miss=NO_REST, **only)
