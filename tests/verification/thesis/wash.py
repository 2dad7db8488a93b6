# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 5.5: the washing machine in three dimensions: stresses over the step, Reynolds number and load, and motion.

Stresses are averages over all markers and the first cycles, with the standard deviation over the markers [MPa]. The
thesis's runs crashed or were stopped; ours of its numerics go as far as they go.
"""

import functools
import json
import math

import numpy as np

import results
from tables import read_columns
from thesis import checks
from thesis.rows import THEIRS, TODAY, Row, case_file
from wash_runs import CYCLE, STRESSES, read_centers

RADIUS, HEIGHT = 0.31, 0.2376  # of the drum and of the water [m]
ORBIT = (0.25 * 0.7128 / RADIUS, 0.5 * HEIGHT / RADIUS)  # what cloths tumble round, radius and height over the drum's radius
WATER, EXCESS_MASS, THICKNESS, SIDE = 1000, 0.093, 2.4e-4, 0.15  # densities [kg/m3, kg/m2] and sizes of a cloth [m]
INNER, OUTER = 0.45, 0.65  # of the drum's radius: where cloths are to sink, and to rise
LEAST_SPEED = 0.02  # [m/s] with which they do
MOTION = 0.3  # cloths mix: figures move by so much between versions
STEPS = {"dt": ("0.418 (0.242)", "0.424 (0.244)", "0.0375 (0.0169)"), "dt_half": ("0.615 (0.317)", "0.630 (0.307)", "0.0409 (0.0188)"),
         "dt_quarter": ("0.699 (0.366)", "0.747 (0.358)", "0.0441 (0.0208)")}
EIGHT = {"re1.2e2": ("0.069 (0.021)", "0.061 (0.018)", "0.0280 (0.0084)"), "re1.2e3": ("0.160 (0.096)", "0.153 (0.079)", "0.0268 (0.0086)"),
         "re1.2e4": ("0.651 (0.345)", "0.847 (0.340)", "0.0516 (0.0171)"), "re1.2e5": ("1.022 (0.286)", "1.067 (0.836)", "0.0723 (0.0178)")}
TWO = {"re1.2e2": ("0.077 (0.028)", "0.062 (0.022)", "0.0270 (0.0093)"), "re1.2e3": ("0.096 (0.055)", "0.103 (0.049)", "0.0197 (0.0073)"),
       "re1.2e4": ("0.699 (0.366)", "0.748 (0.358)", "0.0441 (0.0208)"), "re1.2e5": ("1.119 (0.477)", "1.608 (1.535)", "0.0525 (0.0201)"),
       "re1.2e6": ("1.308 (0.571)", "1.294 (0.532)", "0.0697 (0.0307)")}
LOAD = {"re1.2e3": ("0.119 (0.069)", "0.127 (0.066)", "0.023 (0.007)"), "cloths32": ("0.143 (0.080)", "0.131 (0.077)", "0.027 (0.012)"),
        "cloths64": ("0.163 (0.119)", "0.170 (0.114)", "0.028 (0.014)")}
MASS = {"re1.2e3": (16, "1.7e-3"), "cloths32": (32, "3.3e-3"), "cloths64": (64, "6.6e-3")}  # cloths; their dry mass over the water's
LENGTHS = {**dict.fromkeys(EIGHT, (2, 5, 8)), "cloths32": (2, 5), "cloths64": (1, 2, 5), "width1.5": (1,), "dt": (2, 2.9), "dt_half": (2,),
           "dt_quarter": (2,), "ratio1to2": (2,), "smooth": (2,), "re1.2e6": (2,)}  # cycles from which longer runs go on
VARIANTS = {"ratio1to1": ("ratio1to2", ("-towel_markers", 6)),  # of cases: their file and what is changed in it
            "width1.5, 16 cloths": ("width1.5", ("-towel_count", 16))}
CASE_NAMES = {"dt": "dt*", "dt_half": "dt*/2", "dt_quarter": "dt*/4", "cloths32": "32 cloths", "cloths64": "64 cloths",
              "width1.5": "64 cloths, half width 1.5 h", "width1.5, 16 cloths": "16 cloths, half width 1.5 h",
              "ratio1to1": "markers as far apart as cells are wide", "ratio1to2": "markers half as far apart", "smooth": "smooth mask",
              **{f"re{number}": f"Re = {number}" for number in ("1.2e2", "1.2e3", "1.2e4", "1.2e5", "1.2e6")}}
AXIS, DRUM = "near the axis", "near the drum"
IN_THICK_LIQUID = "in thick liquid the cloths are still round the post, where the agitator drags them, after two cycles"
FOR_LONG_IN_THICK_LIQUID = "in thick liquid the cloths stay near the post, where the agitator drags them"
DRAGGED = "the thicker the liquid, the farther out the agitator drags it, and the cloths with it"
CLOTHS_DECIDE = "beyond Re = 1.2e3 it is where cloths touch the drum that decides, and eddies have no model"

MPA = 1e-6
LONG, LOADED = tuple(EIGHT), ("cloths64",)  # measured today alone: with the thesis's numerics they take hours


def wash(numerics, name, cycles):
    """A run of a case over so many cycles, going on from that of the fewer cycles before; it may fail."""
    before = [number for number in LENGTHS.get(name, ()) if number < cycles]
    try:
        earlier = wash(numerics, name, before[-1]) if before else None
    except results.Unfinished as late:
        raise results.Unfinished(late.seconds * cycles / before[-1]) from late
    if earlier and earlier.failed:
        return earlier
    file, changed = VARIANTS.get(name, (name, ()))
    return results.run(1, "-options_file", case_file(numerics, file), "-history_interval", 1e-3, "-output_interval", 0.1, "-checkpoint_interval", 0.1,
                       "-time_end", cycles * CYCLE, *changed, may_fail=True, earlier=earlier)


def history(numerics, name, cycles):
    """The history of the first cycles of a run, as far as it came."""
    columns = read_columns(wash(numerics, name, cycles).folder / "history.csv")
    until = columns["time"] <= cycles * CYCLE + 1e-3
    return {key: values[until] for key, values in columns.items()}


def cycles_run(numerics, name, cycles):
    """How far a run came, in cycles."""
    return history(numerics, name, cycles)["time"][-1] / CYCLE


def stress(numerics, name, cycles, component):
    """Mean stress of the markers and its standard deviation [MPa]; NaN if the run failed."""
    result = wash(numerics, name, cycles)
    if result.failed:
        return math.nan, math.nan
    towel = json.loads((result.folder / "summary.json").read_text())["cloths"]["towel"]
    return tuple(MPA * towel[f"stress_{component}_{part}"] for part in ("mean", "std"))


def tumbles(numerics, name, cycles):
    """Turns of a cloth in the plane of radius and height, in a cycle."""
    found = history(numerics, name, cycles)
    return found["towel_tumbles"][-1] / (found["time"][-1] / CYCLE)


def depth(numerics, name, cycles):
    """How deep the deepest face of a cloth reaches into a body [mm]."""
    return 1e3 * history(numerics, name, cycles)["towel_depth"].max()


def drum_torque(numerics, name, cycles):
    """Torque on the drum, root mean square [N m]."""
    found = history(numerics, name, cycles)
    return np.sqrt(np.average(found["drum_torque_z"] ** 2, weights=found["dt"]))


def rising(numerics, name, cycles, near_drum):
    """Mean vertical speed of the cloths' centres near the axis or near the drum [m/s]; NaN if none came there."""
    time, centers = read_centers(wash(numerics, name, cycles).folder)
    until = time <= cycles * CYCLE + 1e-3
    x, y, z = np.moveaxis(centers[..., until], 1, 0)
    radius = np.hypot(x, y)[:, :-1] / RADIUS
    part = radius > OUTER if near_drum else radius < INNER
    return (np.diff(z, axis=1) / np.diff(time[until]))[part].mean() if part.any() else math.nan


def plane_tracks(numerics, name, cycles):
    """Places of the cloths' centres in the plane of radius and height over the drum's radius, cloth by axis by time."""
    time, centers = read_centers(wash(numerics, name, cycles).folder)
    centers = centers[..., time <= cycles * CYCLE + 1e-3]
    return np.stack([np.hypot(centers[:, 0], centers[:, 1]), centers[:, 2]], axis=1) / RADIUS


def centre_moves(numerics, name, cycles):
    """How far the common centre strays from its mean place in the plane of radius and height, rms over the drum's radius."""
    centre = plane_tracks(numerics, name, cycles).mean(axis=0)
    return np.sqrt(((centre - centre.mean(axis=1, keepdims=True)) ** 2).sum(axis=0).mean())


def centre_turns(numerics, name, cycles):
    """Turns of the common centre about what cloths tumble round, the middle of the radius and of the height."""
    r, z = plane_tracks(numerics, name, cycles).mean(axis=0) - np.array(ORBIT)[:, None]
    angle = np.unwrap(np.arctan2(z, r))
    return (angle[-1] - angle[0]) / (2 * np.pi)


def apart(numerics, name, cycles):
    """How far the cloths' centres are from their common one in the plane of radius and height, rms over the drum's radius."""
    tracks = plane_tracks(numerics, name, cycles)
    return np.sqrt(((tracks - tracks.mean(axis=0)) ** 2).sum(axis=1).mean())


def independence(numerics, name, cycles):
    """Speed of the cloths' centres against their common one in the plane of radius and height over their speed, each an rms."""
    steps = np.diff(plane_tracks(numerics, name, cycles), axis=2)
    return np.sqrt(((steps - steps.mean(axis=0)) ** 2).sum() / (steps ** 2).sum())


def low(numerics, name, cycles):
    """The part of the time that the cloths' centres spend in the lowest quarter of the water [%]."""
    return 100 * (plane_tracks(numerics, name, cycles)[:, 1] < 0.25 * HEIGHT / RADIUS).mean()


def turning(numerics, name, cycles):
    """Way of the cloths' centres about the axis, to and fro, in turns a cycle."""
    time, centers = read_centers(wash(numerics, name, cycles).folder)
    until = time <= cycles * CYCLE + 1e-3
    angles = np.unwrap(np.arctan2(centers[:, 1, until], centers[:, 0, until]), axis=1)
    return np.abs(np.diff(angles, axis=1)).sum(axis=1).mean() / (2 * np.pi * time[until][-1] / CYCLE)


def time_ratio(numerics, name, other, cycles):
    """The time that one run takes over that of another."""
    return wash(numerics, name, cycles).seconds / wash(numerics, other, cycles).seconds


def mass_ratio(_, count):
    """Dry mass of so many cloths over that of the water in a drum without agitator."""
    cloth = (EXCESS_MASS + WATER * THICKNESS) * SIDE ** 2
    return count * cloth / (WATER * math.pi * RADIUS ** 2 * HEIGHT)


def track_length(numerics, name, cycles):
    """Mean length of a cloth's track in the plane of radius and height, over the drum's radius."""
    return np.linalg.norm(np.diff(plane_tracks(numerics, name, cycles), axis=2), axis=1).sum(axis=1).mean()


def stress_rows(tables, figures, cycles, today_alone=(), **others):
    """Three tables of stresses: along warp, along weft, shear."""
    for place, (table, component) in enumerate(zip(tables, STRESSES)):
        for name, of_thesis in figures.items():
            few = {"numerics": (TODAY,)} if name in today_alone else {}
            yield Row(table, f"{CASE_NAMES[name]}, {cycles} cycles", f"sigma_{component}, mean (standard deviation) [MPa]",
                      of_thesis[place], functools.partial(stress, name=name, cycles=cycles, component=component),
                      within=MOTION, within_spread=2 * MOTION, **few, **others)  # of two builds the means differed by 9 %, spreads by 33 %


TURNS, TURNS_OF_3, TURNS_OF_29 = (f"turns of a cloth in a cycle, of {cycles}" for cycles in ("two", "three", "2.9"))
CRASH, CENTRE, CENTRE_TURNS = "cycles run", "common centre's way from its mean, rms over r_o", "turns of the common centre"
APART, INDEPENDENT = "centres' distance from the common one, rms over r_o", "speed of centres against the common one over their speed"
LOW, TURNING = "time of centres in the lowest quarter of the water [%]", "way of centres about the axis, turns a cycle, of two"


def wash_rows(table, quantity, measure, said, cycles, suffix="", within=MOTION, **others):
    """Rows of a table, a case each, with what the thesis says of it."""
    for name, words in said.items():
        yield Row(table, CASE_NAMES[name] + suffix, quantity, words, functools.partial(measure, name=name, cycles=cycles), within=within, **others)


def step_rows():
    """5.5.5.1: crashes and how deep cloths come, over the step."""
    yield from wash_rows("5.5.5.1", "cycles run, of two", cycles_run, dict.fromkeys(STEPS, "2"), 2, within=0.2)
    for name, cycles, crash in (("dt", 4, "2.9"), ("dt_half", 6, "5.3"), ("dt_quarter", 8, "7.4 and on")):
        few = {} if name == "dt" else {"numerics": (TODAY,)}  # hours for a crash alone
        yield from wash_rows("5.5.5.1, crash", CRASH, cycles_run, {name: crash}, cycles, f", of {cycles} cycles", 0.2, comparable=False, **few)
    yield from wash_rows("5.5.5.1, depth", "deepest face of a cloth in a body [mm]", depth,
                         {"dt": "slight penetration", "dt_half": "slight penetration", "dt_quarter": ""}, 2)


def reynolds_rows():
    """5.5.5.2: tumbling, rings and the common centre over the Reynolds number."""
    yield from wash_rows("5.5.5.2", TURNS, tumbles, {"re1.2e2": "very low", "re1.2e3": "tumbled", **dict.fromkeys(list(TWO)[2:], "slower")}, 2)
    yield from wash_rows("5.5.5.2, rings", APART, apart, {**dict.fromkeys(TWO, ""), "re1.2e2": "aligned, to 11 cycles", "re1.2e3": "rings, different phases",
                                                          "re1.2e4": "rings not as dominant"}, 2, ", 2 cycles")
    yield from wash_rows("5.5.5.2, with the agitator", TURNING, turning, dict.fromkeys(TWO, "") | {"re1.2e6": "more pronounced with Re"}, 2)
    yield from wash_rows("5.5.5.2, bottom", LOW, low, dict.fromkeys(TWO, "") | {"re1.2e6": "some stayed there"}, 2, ", 2 cycles",
                         slack=3)  # one of sixteen towels more or less there for half of the time
    yield from wash_rows("5.5.5.2, bottom", CRASH, cycles_run, {"re1.2e6": "stress discontinuous after 2"}, 5.5, ", of 5.5 cycles", 0.2,
                         numerics=(TODAY,))
    yield from wash_rows("5.5.5.2, drum", "torque on the drum, rms of two cycles [N m]", drum_torque, dict.fromkeys(TWO, ""), 2)
    for place in (AXIS, DRUM):
        yield from wash_rows("5.5.5.2, orbits", "vertical speed of cloths, mean of two cycles [m/s]",
                             functools.partial(rising, near_drum=place == DRUM), dict.fromkeys(("re1.2e3", "re1.2e4"), ""), 2, f", {place}")
    yield from wash_rows("Figs. 5.5-8 to 12", CENTRE, centre_moves, dict.fromkeys(TWO, ""), 2, ", 2 cycles")
    for name, words in {"re1.2e2": "", "re1.2e3": "stagnant", **dict.fromkeys(list(TWO)[2:], "wider")}.items():
        few = {} if name == "re1.2e3" else {"numerics": (TODAY,)}
        yield from wash_rows("Figs. 5.5-8 to 12", CENTRE, centre_moves, {name: words}, 5.5, ", 5.5 cycles", **few)


def load_rows():
    """5.5.5.3: masses, tumbling and how much cloths move on their own, over the load."""
    for name, (count, figure) in MASS.items():
        yield Row("5.5-12, mass", f"{count} cloths", "dry mass of the cloths over that of the water", figure,
                  functools.partial(mass_ratio, count=count))
    yield from wash_rows("5.5.5.3", TURNS, tumbles, dict.fromkeys(LOAD, "slower with the load"), 2)
    yield from wash_rows("5.5.5.3, alone", INDEPENDENT, independence, dict.fromkeys(LOAD, "less with the load"), 2, ", 2 cycles")
    for name, words in (("re1.2e3", "more than 1"), ("cloths32", ""), ("cloths64", "0.25")):
        few = {"numerics": (TODAY,)} if name in LOADED else {}
        yield from wash_rows("Figs. 5.5-15 to 17", CENTRE_TURNS, centre_turns, {name: words}, 6, ", 6 cycles", **few)


def variant_rows():
    """5.5.5.4 to 5.5.5.6: the width of the delta, markers nearer to each other, and the smooth mask."""
    yield from wash_rows("Figs. 5.5-18, 19", "length of a cloth's track over r_o, first cycle", track_length,
                         {"cloths64": "less mobile", "width1.5": "more mobile, then a crash"}, 1)
    yield from wash_rows("5.5.5.4", "cycles run, of two", cycles_run, {"width1.5": "a crash", "width1.5, 16 cloths": "a crash after 1"}, 2, within=0.2)
    yield Row("5.5.5.4", "half width 1 h", "cycles run, of two", "unstable", cycles_run, numerics=(), not_run="not run: no kernel so narrow")
    yield from wash_rows("Figs. 5.5-20, 21", TURNS_OF_3, tumbles, {"ratio1to1": "circular orbits", "ratio1to2": "cusps, less tumbling"}, 3)
    yield Row("5.5.5.5", "markers half as far apart over as far apart as cells are wide, three cycles", "time that a run takes, over the other's",
              "more than 2", functools.partial(time_ratio, name="ratio1to2", other="ratio1to1", cycles=3), within=math.inf)
    yield from wash_rows("Figs. 5.5-22, 23", TURNS_OF_29, tumbles, {"dt": "circular orbits"}, 2.9)
    yield from wash_rows("Figs. 5.5-22, 23", TURNS_OF_29, tumbles, {"smooth": "ambiguous"}, 2.9, numerics=(THEIRS,), not_run="no mask")


def rows():
    """Tables 5.5-3 to 5.5-14 and what is said of the motion."""
    yield from stress_rows(("5.5-3", "5.5-4", "5.5-5"), STEPS, 2, comparable=False)  # today's steps are 12.5 times as long
    yield from stress_rows(("5.5-6", "5.5-7", "5.5-8"), EIGHT, 8, LONG)
    yield from stress_rows(("5.5-9", "5.5-10", "5.5-11"), TWO, 2)
    yield from stress_rows(("5.5-12", "5.5-13", "5.5-14"), LOAD, 5, LOADED)
    for part in (step_rows, reynolds_rows, load_rows, variant_rows):
        yield from part()


def claims():
    """The thesis's trends over the Reynolds number and the load, and that of the torque on the drum, which falls with the Reynolds
    number (Akcabay, Dowling and Schultz, Clothes washing simulations, Computers & Fluids, 2014)."""
    only = {"numerics": (TODAY,)}
    yield checks.rises("5.5-3", [f"{CASE_NAMES[name]}, 2 cycles" for name in STEPS], numerics=(THEIRS,))
    names = [f"{CASE_NAMES[name]}, 2 cycles" for name in TWO]
    yield checks.rises("5.5-9", names, numerics=(THEIRS,))
    yield checks.rises("5.5-9", names[:2], miss=IN_THICK_LIQUID, **only)
    yield checks.rises("5.5-9", names[1:], **only)
    for table in ("5.5-6", "5.5-7", "5.5-8"):
        names = [f"{CASE_NAMES[name]}, 8 cycles" for name in EIGHT]
        if table != "5.5-8":  # in the thesis, too, shear stress falls there
            yield checks.rises(table, names[:2], miss=FOR_LONG_IN_THICK_LIQUID, **only)
        yield checks.rises(table, names[1:3], **only)
    yield checks.rises("5.5-12", [f"{CASE_NAMES[name]}, 5 cycles" for name in LOAD], **only)
    names = [CASE_NAMES[name] for name in TWO]
    yield checks.falls("5.5.5.2", names[1:], **only)
    yield checks.rises("5.5.5.2, with the agitator", names, miss=DRAGGED, **only)
    yield checks.falls("5.5.5.2, drum", names[:2], **only)
    yield checks.falls("5.5.5.2, drum", names[1:], miss=CLOTHS_DECIDE, **only)
    yield checks.falls("5.5.5.3", [CASE_NAMES[name] for name in ("re1.2e3", "cloths64")], **only)
    for name in names[1:3]:
        yield checks.Check("5.5.5.2, orbits", f"vertical speed, {name}, {AXIS} [m/s]", (f"{name}, {AXIS}",), max, most=-LEAST_SPEED, **only)
        yield checks.Check("5.5.5.2, orbits", f"vertical speed, {name}, {DRUM} [m/s]", (f"{name}, {DRUM}",), min, least=LEAST_SPEED, **only)
