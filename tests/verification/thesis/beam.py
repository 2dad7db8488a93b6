# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 3.5.2: a beam held at its middle bends under its weight; each half against Bickley's heavy cantilever.

The error is the root mean square distance of the right half's markers, the middle one included, from the exact points at
their arclengths k ds from the support, over L = (n - 1/2) ds with n markers on a half.
"""

import functools

import numpy as np

import results
from beam_test import BENDING_LENGTH, GRIDS, PULLS, WEIGHT, exact_points
from tables import scientific
from thesis.rows import THEIRS, TODAY, Row, case_file

STEPS = {65: 1e-3, 129: 2.5e-4}  # [s] about the longest that Broyden's method converges with
NOT_RUN = {257: "not run: 3 h", 513: "not run: 50 h"}


def bend(numerics, cells, alpha):
    """The beam's markers at rest."""
    half, pull = GRIDS[cells][0], alpha * WEIGHT * BENDING_LENGTH
    result = results.run(1, "-options_file", case_file(numerics, "beam"), "-grid_cells", f"{cells},{cells}", "-beam_markers", 2 * half - 1,
                         "-beam_end_force_last", f"{pull},0", "-beam_end_force_first", f"{-pull},0", "-checkpoint_interval", 1,
                         *(["-time_step", STEPS[cells]] if numerics == THEIRS else []))
    return np.genfromtxt(result.folder / "cloth_final.csv", delimiter=",", skip_header=2, usecols=(4, 5))


def error(numerics, cells, alpha=0):
    """Distance of the right half from Bickley's cantilever, over L."""
    half = GRIDS[cells][0]
    off = bend(numerics, cells, alpha)[half - 1:] - exact_points(alpha, np.arange(half) / (half - 0.5))
    return np.sqrt(np.mean(np.sum(off ** 2, axis=1)))


def rows():
    """Tables 3.5-10 and 3.5-11."""
    for cells, (half, figure) in GRIDS.items():
        few = {"numerics": (TODAY,), "not_run": NOT_RUN[cells]} if cells in NOT_RUN else {}
        yield Row("3.5-10", f"{cells} x {cells}, {half} markers on a half", "rms error/L", scientific(figure),
                  functools.partial(error, cells=cells), is_error=True, **few)
    for alpha in PULLS:
        yield Row("3.5-11", f"alpha_o = {alpha}, 129 x 129", "rms error/L", "not in our copy, 513 x 513",
                  functools.partial(error, cells=129, alpha=alpha), numerics=(TODAY,), not_run="not run: 0.2 h each")
