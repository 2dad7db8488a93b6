# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 3.5.3: plates that flutter down in water. A half period is the time between extreme positions of the centre."""

import functools
import math
from typing import NamedTuple

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
TANK_EXPERIMENT = 0.35  # [s] half period, +- 0.05


class Grid(NamedTuple):
    """Cells a side, markers, step [s] and the box where it is not that of the case."""
    cells: int
    markers: int
    step: float
    box: tuple = ()


WIDE = ("-grid_lower", "-0.06248,0", "-grid_upper", "0.06248,0.12496", "-plate_center", "-0.005,0.11748")  # 17.6 l, as far from the top
GRIDS = {"falling_plate": {"0.0216": Grid(512, 46, 3e-4), "0.0108": Grid(1024, 92, 3e-4)},
         "andersen": {"0.0344": Grid(512, 29, 2.5e-4, WIDE), "0.0172": Grid(1024, 58, 1.25e-4, WIDE), "0.0086": Grid(1024, 116, 1.25e-4)}}  # by h/l


def fall(numerics, name, spacing):
    """The folder of a fall; nothing if it failed."""
    cells, markers, step, box = GRIDS[name][spacing]
    result = results.run(1, "-options_file", case_file(numerics, name), "-grid_cells", f"{cells},{cells}", "-plate_markers", markers, "-time_step", step,
                         "-checkpoint_interval", 0.05, "-history_interval", 1e-3, *box, may_fail=True)
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


def motion(numerics, name, spacing):
    """The history of a fall, and the rows at which the plate turns; nothing if it failed."""
    folder = fall(numerics, name, spacing)
    if not folder:
        return None, []
    history = read_columns(folder / "history.csv")
    return history, turns(history["plate_center_x"], LEAST_WAY * LENGTH[name])


def half_period(numerics, name, spacing):
    """Mean of the first two half periods, or the first alone, [s]; NaN if there is none."""
    history, found = motion(numerics, name, spacing)
    return np.diff(history["time"][found])[:2].mean() if len(found) > 1 else math.nan


def speed(history, axis):
    """Speed of the plate's centre along an axis [m/s]."""
    return np.gradient(history[f"plate_center_{axis}"], history["time"])


def amplitudes(numerics, name, spacing):
    """Half the range of the centre's horizontal and vertical speed after the first turn [m/s]."""
    history, found = motion(numerics, name, spacing)
    if not history:
        return math.nan, math.nan
    return tuple(0.5 * np.ptp(speed(history, axis)[found[0] if found else 0:]) for axis in "xy")


def frequency_ratio(numerics, name, spacing):
    """Frequency of the vertical speed over that of the horizontal one, from the first turn on; NaN without two turns of each."""
    history, found = motion(numerics, name, spacing)
    if len(found) < 2:
        return math.nan
    time, rate = history["time"][found[0]:], speed(history, "y")[found[0]:]
    swings = turns(rate, 0.25 * np.ptp(rate))
    return np.diff(history["time"][found]).mean() / np.diff(time[swings]).mean() if len(swings) > 1 else math.nan


def amplitude_ratios(numerics):
    """Amplitudes of the horizontal and the vertical speed on the coarser grid over those on the finer one."""
    coarse, fine = (amplitudes(numerics, "andersen", spacing) for spacing in ("0.0172", "0.0086"))
    return tuple(first / second for first, second in zip(coarse, fine))


def unevenness(numerics, name, spacing):
    """The longest half period over the shortest; NaN if there are not two."""
    history, found = motion(numerics, name, spacing)
    periods = np.diff(history["time"][found]) if len(found) > 2 else [math.nan]
    return max(periods) / min(periods)


def angles(folder):
    """Times of the frames and the plate's angle to the horizontal in them [degrees]."""
    time, places = read_markers(folder)
    way = places[:, -1] - places[:, 0]
    return time, np.degrees(np.unwrap(np.arctan2(way[:, 1], way[:, 0])))


def angles_of_least_speeds(numerics, name, spacing):
    """The size of the angle at which the horizontal speed, and that downwards, is least after the first turn [degrees]."""
    history, found = motion(numerics, name, spacing)
    if not found:
        return math.nan, math.nan
    late = np.arange(len(history["time"])) >= found[0]
    angle = np.abs(np.interp(history["time"], *angles(fall(numerics, name, spacing))))[late]
    return angle[np.argmin(speed(history, "x")[late])], angle[np.argmin(-speed(history, "y")[late])]


def bent(numerics, name, spacing):
    """Largest distance of a marker from a straight line through all of its plate, in any frame, over the length."""
    folder = fall(numerics, name, spacing)
    if not folder:
        return math.nan
    places = read_markers(folder)[1]
    straight = [place - place.mean(axis=0) for place in places]
    off = max(np.abs(place @ np.linalg.svd(place, full_matrices=False)[2][1]).max() for place in straight)
    return off / np.linalg.norm(places[0, -1] - places[0, 0])


def inclined(numerics, name, spacing):
    """Largest angle to the horizontal [degrees]."""
    folder = fall(numerics, name, spacing)
    if not folder:
        return math.nan
    return np.abs(angles(folder)[1]).max()


BENT, INCLINED, FREQUENCIES = "bent, over the length", "largest angle to the horizontal [degrees]", "frequency of Vy over that of Vx"
AMPLITUDE, RATIO_OF_GRIDS, HALF_PERIOD = "amplitude of Vx (of Vy) [m/s]", "h/l = 0.0172 over h/l = 0.0086", "half period [s]"
UNEVEN, LEAST = "longest half period over the shortest", "angle at the least Vx (the least -Vy) [degrees]"


def other_rows(table, name, names):
    """What a plate must do besides."""
    for quantity, measure, within in ((BENT, bent, math.inf), (INCLINED, inclined, 0.2)):
        for spacing, what in names.items():
            yield Row(table, what, quantity, "", functools.partial(measure, name=name, spacing=spacing), within=within)


def uneven_rows(table, name, names):
    """How uniform the flutter is, which the thesis says of its coarser grids alone."""
    for spacing, what in names.items():
        yield Row(table, what, UNEVEN, "not uniform" if spacing == "0.0344" else "", functools.partial(unevenness, name=name, spacing=spacing),
                  within=0.2)


TANK_NAMES = {spacing: f"h/l = {spacing} (tank: {TANK_EXPERIMENT:.2f} +- 0.05)" for spacing in GRIDS["falling_plate"]}
ANDERSEN_NAMES = {spacing: f"h/l = {spacing}" for spacing in list(GRIDS["andersen"])[1:]}
COARSEST = {"0.0344": "h/l = 0.0344"}  # the grids that the thesis calls coarser are not named


def tank_rows():
    """Table 3.5-12 and Fig. 3.5-7."""
    for (spacing, what), figure in zip(TANK_NAMES.items(), ("0.21", "0.275")):
        yield Row("3.5-12", what, HALF_PERIOD, figure, functools.partial(half_period, name="falling_plate", spacing=spacing), within=0.1)
    for spacing, what in TANK_NAMES.items():
        yield Row("3.5-12", what, LEAST, "around 20 (around 20)" if spacing == "0.0108" else "",
                  functools.partial(angles_of_least_speeds, name="falling_plate", spacing=spacing), within=0.3)
    yield from other_rows("3.5-12", "falling_plate", TANK_NAMES)
    yield from uneven_rows("3.5-12", "falling_plate", TANK_NAMES)


def rows():
    """Tables 3.5-12 and 3.5-13: the cases, and what the text says of them."""
    yield from tank_rows()
    for (spacing, what), figure in zip(ANDERSEN_NAMES.items(), ("56 (39) % below Andersen et al.", "21 (14) % below")):
        yield Row("3.5-13", what, AMPLITUDE, figure, functools.partial(amplitudes, name="andersen", spacing=spacing),
                  within=0.1, comparable=False)
    yield Row("3.5-13", RATIO_OF_GRIDS, "amplitude of Vx (of Vy), one over the other", "0.557 (0.709)", amplitude_ratios, within=0.1)
    for spacing, what in ANDERSEN_NAMES.items():
        yield Row("3.5-13", what, FREQUENCIES, "", functools.partial(frequency_ratio, name="andersen", spacing=spacing), within=0.2)
    yield from other_rows("3.5-13", "andersen", ANDERSEN_NAMES)
    yield from uneven_rows("3.5-13", "andersen", {**COARSEST, **ANDERSEN_NAMES})


def claims():
    """The plate stays straight and does not tumble; its vertical speed has twice the frequency of the horizontal one."""
    for table, names in (("3.5-12", TANK_NAMES), ("3.5-13", ANDERSEN_NAMES)):
        for what in names.values():
            yield checks.largest(table, BENT, [what], MOST_BENT)
            yield checks.largest(table, INCLINED, [what], MOST_INCLINED)
    for what in ANDERSEN_NAMES.values():
        yield checks.Check("3.5-13", f"{FREQUENCIES}, {what}", (what,), max, *RATIO, quantity=FREQUENCIES)
