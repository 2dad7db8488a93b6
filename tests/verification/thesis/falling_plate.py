# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 3.5.3: plates that flutter down in water. A half period is the time between extreme positions of the centre."""

import functools
import math

import numpy as np

import results
from tables import read_columns, read_markers
from thesis import checks
from thesis.rows import Row, case_file

LEAST_WAY = 0.1  # lengths: a shorter way back is no turn
MOST_BENT = 1e-3  # lengths
MOST_INCLINED = 90  # [degrees] beyond, the plate has tumbled
RATIO = (1.5, 2.5)  # frequency of the vertical speed over that of the horizontal one
LENGTH = {"falling_plate": 0.0183, "andersen": 0.0071}  # [m]
TANK = {256: (23, 5e-4), 512: (46, 3e-4), 1024: (92, 3e-4)}  # markers, step [s]
ANDERSEN = {256: (29, 2.5e-4), 512: (58, 1.25e-4), 1024: (116, 1.25e-4)}


def fall(numerics, name, cells):
    """The history of a fall; nothing if it failed."""
    markers, step = (TANK if name == "falling_plate" else ANDERSEN)[cells]
    result = results.run(1, "-options_file", case_file(numerics, name), "-grid_cells", f"{cells},{cells}", "-plate_markers", markers, "-time_step", step,
                         "-checkpoint_interval", 0.05, "-history_interval", 1e-3, may_fail=True)
    return None if result.failed else result.folder


def turns(values, least):
    """Indices of the extremes, a highest one first, from each of which the values then go back by more than least."""
    found, best, sign = [], 0, 1
    for k, value in enumerate(values):
        if sign * (value - values[best]) > 0:
            best = k
        elif sign * (values[best] - value) > least:
            found.append(best)
            best, sign = k, -sign
    return found


def motion(numerics, name, cells):
    """The history of a fall, and the rows at which the plate turns; nothing if it failed."""
    folder = fall(numerics, name, cells)
    if not folder:
        return None, []
    history = read_columns(folder / "history.csv")
    return history, turns(history["plate_center_x"], LEAST_WAY * LENGTH[name])


def half_period(numerics, name, cells):
    """Mean of the first two half periods, or the first alone, [s]; NaN if there is none."""
    history, found = motion(numerics, name, cells)
    return np.diff(history["time"][found])[:2].mean() if len(found) > 1 else math.nan


def speed(history, axis):
    """Speed of the plate's centre along an axis [m/s]."""
    return np.gradient(history[f"plate_center_{axis}"], history["time"])


def amplitudes(numerics, name, cells):
    """Half the range of the centre's horizontal and vertical speed after the first turn [m/s]."""
    history, found = motion(numerics, name, cells)
    if not history:
        return math.nan, math.nan
    return tuple(0.5 * np.ptp(speed(history, axis)[found[0] if found else 0:]) for axis in "xy")


def frequency_ratio(numerics, name, cells):
    """Frequency of the vertical speed over that of the horizontal one, from the first turn on; NaN without two turns of each."""
    history, found = motion(numerics, name, cells)
    if len(found) < 2:
        return math.nan
    time, rate = history["time"][found[0]:], speed(history, "y")[found[0]:]
    swings = turns(rate, 0.25 * np.ptp(rate))
    return np.diff(history["time"][found]).mean() / np.diff(time[swings]).mean() if len(swings) > 1 else math.nan


def bent(numerics, name, cells):
    """Largest distance of a marker from a straight line through all of its plate, in any frame, over the length."""
    folder = fall(numerics, name, cells)
    if not folder:
        return math.nan
    places = read_markers(folder)[1]
    straight = [place - place.mean(axis=0) for place in places]
    off = max(np.abs(place @ np.linalg.svd(place, full_matrices=False)[2][1]).max() for place in straight)
    return off / np.linalg.norm(places[0, -1] - places[0, 0])


def inclined(numerics, name, cells):
    """Largest angle to the horizontal [degrees]."""
    folder = fall(numerics, name, cells)
    if not folder:
        return math.nan
    places = read_markers(folder)[1]
    way = places[:, -1] - places[:, 0]
    return np.degrees(np.abs(np.unwrap(np.arctan2(way[:, 1], way[:, 0])))).max()


def in_tank(cells):
    """What a grid is called in Table 3.5-12."""
    return f"h/l = {0.20313 / cells / LENGTH['falling_plate']:.4f} (tank: 0.35 +- 0.05)"


def of_andersen(cells):
    """What a grid is called in Table 3.5-13."""
    return f"h/l = {0.06248 / cells / LENGTH['andersen']:.4f}"


BENT, INCLINED, FREQUENCIES = "bent, over the length", "largest angle to the horizontal [degrees]", "frequency of Vy over that of Vx"


def other_rows(table, name, names):
    """What a plate must do besides."""
    for quantity, measure, within in ((BENT, bent, math.inf), (INCLINED, inclined, 0.2)):
        for cells, what in names.items():
            yield Row(table, what, quantity, "", functools.partial(measure, name=name, cells=cells), within=within)


TANK_NAMES, ANDERSEN_NAMES = ({cells: name(cells) for cells in (512, 1024)} for name in (in_tank, of_andersen))


def rows():
    """Tables 3.5-12 and 3.5-13: the cases, and what the text says of them."""
    for (cells, what), figure in zip(TANK_NAMES.items(), ("0.21", "0.275")):
        yield Row("3.5-12", what, "half period [s]", figure, functools.partial(half_period, name="falling_plate", cells=cells), within=0.1)
    yield from other_rows("3.5-12", "falling_plate", TANK_NAMES)
    for (cells, what), figure in zip(ANDERSEN_NAMES.items(), ("56 (39) % below Andersen et al.", "21 (14) % below")):
        yield Row("3.5-13", what, "amplitude of Vx (of Vy) [m/s]", figure, functools.partial(amplitudes, name="andersen", cells=cells),
                  within=0.1)
    for cells, what in ANDERSEN_NAMES.items():
        yield Row("3.5-13", what, FREQUENCIES, "", functools.partial(frequency_ratio, name="andersen", cells=cells), within=0.2)
    yield from other_rows("3.5-13", "andersen", ANDERSEN_NAMES)


def claims():
    """The plate stays straight and does not tumble; its vertical speed has twice the frequency of the horizontal one."""
    for table, names in (("3.5-12", TANK_NAMES), ("3.5-13", ANDERSEN_NAMES)):
        for what in names.values():
            yield checks.largest(table, BENT, [what], MOST_BENT)
            yield checks.largest(table, INCLINED, [what], MOST_INCLINED)
    for what in ANDERSEN_NAMES.values():
        yield checks.Check("3.5-13", f"{FREQUENCIES}, {what}", (what,), max, *RATIO, quantity=FREQUENCIES)
