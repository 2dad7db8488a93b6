# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 3.5.3: plates that flutter down in water. A half period is the time between extreme positions of the centre."""

import functools
import math

import numpy as np

import results
from falling_plate_test import LEAST_WAY, turns
from tables import read_columns
from thesis.rows import Row, case_file

LENGTH = {"falling_plate": 0.0183, "andersen": 0.0071}  # [m]
TANK = {256: (23, 5e-4), 512: (46, 3e-4), 1024: (92, 3e-4)}  # markers, step [s]
ANDERSEN = {256: (29, 2.5e-4), 512: (58, 1.25e-4), 1024: (116, 1.25e-4)}


def fall(numerics, name, cells):
    """The history of a fall; nothing if it failed."""
    markers, step = (TANK if name == "falling_plate" else ANDERSEN)[cells]
    result = results.run(1, "-options_file", case_file(numerics, name), "-grid_cells", f"{cells},{cells}", "-plate_markers", markers, "-time_step", step,
                         "-checkpoint_interval", 0.05, "-history_interval", 1e-3, may_fail=True)
    return None if result.failed else result.folder


def half_period(numerics, name, cells):
    """Mean of the first two half periods, or the first alone, [s]; NaN if there is none."""
    folder = fall(numerics, name, cells)
    if not folder:
        return math.nan
    history = read_columns(folder / "history.csv")
    halves = np.diff(history["time"][turns(history["plate_center_x"], LEAST_WAY * LENGTH[name])])
    return halves[:2].mean() if len(halves) else math.nan


def amplitudes(numerics, name, cells):
    """Half the range of the centre's horizontal and vertical speed after the first turn [m/s]."""
    folder = fall(numerics, name, cells)
    if not folder:
        return math.nan, math.nan
    history = read_columns(folder / "history.csv")
    found = turns(history["plate_center_x"], LEAST_WAY * LENGTH[name])
    later = slice(found[0] if found else 0, None)
    return tuple(0.5 * np.ptp(np.gradient(history[f"plate_center_{axis}"], history["time"])[later]) for axis in "xy")


def rows():
    """Tables 3.5-12 and 3.5-13: the cases, and what the text says of them."""
    for cells, figure in ((512, "0.21"), (1024, "0.275")):
        yield Row("3.5-12", f"h/l = {0.20313 / cells / 0.0183:.4f} (tank: 0.35 +- 0.05)", "half period [s]", figure,
                  functools.partial(half_period, name="falling_plate", cells=cells), within=0.1)
    for cells, figure in ((512, "56 (39) % below Andersen et al."), (1024, "21 (14) % below")):
        yield Row("3.5-13", f"h/l = {0.06248 / cells / 0.0071:.4f}", "amplitude of Vx (of Vy) [m/s]", figure,
                  functools.partial(amplitudes, name="andersen", cells=cells), within=0.1)
