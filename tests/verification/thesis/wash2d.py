# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 5.4: the washing machine in two dimensions, with our own agitator (the thesis's dimensions are in a lost figure).

Stress: mean over the cloths, ten of either length, of that over their markers (5.2-5), of each marker's average over time, and its
standard deviation [MPa]. Markers are as far apart as cells are wide.
"""

import functools
import json
import math

import numpy as np

import results
from tables import read_markers
from thesis import checks
from thesis.rows import THEIRS, TODAY, Row, case_file

CYCLE = 1.5707963  # [s]
CLOTHS = 10  # of either length
MARKERS = {"long": 24, "short": 16}  # of 64 x 64 cells
MOST_DEPTH = 0.5  # cells that a marker may be deep in a body
THIN = "a vane is two cells thick there, and a marker is pulled in between its neighbours on both sides of it"
BEND = "mean angle between neighbouring edges [degrees]"
STRESS, DEPTH = "mean stress (standard deviation) [MPa]", "deepest marker in a body [cells]"
BOX = 0.6912  # [m]
TABLE = {32: "1.492 (0.511)", 64: "0.386 (0.171)", 128: "0.135 (0.034)", 256: "0.087 (0.017)"}  # h/2r_o from 3.39e-2 on
STEP = 7.52e-6  # [s] 9.45e-5/Omega_max
LONGEST = 1.5e-5  # [s] dt* of Table 5.4-4
MOTION, SLACK = 0.3, 0.2  # cloths mix: figures move by so much between versions, depths by so many cells


def folder(numerics, cells, step, *options):
    """Where the results of one and a half cycles are; nothing if the run failed."""
    spacing = BOX / cells
    groups = [word for name, markers in MARKERS.items() for word in (f"-{name}_markers", markers * cells // 64)]
    others = ["-time_step", step] if numerics == THEIRS else ["-contact_distance", spacing, "-time_cfl", 0, "-time_step", step]
    result = results.run(1, "-options_file", case_file(numerics, "wash2d"), "-grid_cells", f"{cells},{cells}", *groups,
                         "-time_end", 1.5 * CYCLE, "-history_interval", 1e-3, "-output_interval", 0.1, *others, *options, may_fail=True)
    return None if result.failed else result.folder


def summary(numerics, cells, step, options):
    """What a run says of itself; nothing if it failed."""
    where = folder(numerics, cells, step, *options)
    return where and json.loads((where / "summary.json").read_text())


def stress(numerics, cells, steps, options=()):
    """Mean and standard deviation over all cloths, each of which counts the same, and their markers [MPa]."""
    found = summary(numerics, cells, steps[numerics], options)
    if not found:
        return math.nan, math.nan
    means, deviations = (np.array([found["cloths"][name][f"stress_{part}"] for name in MARKERS]) for part in ("mean", "std"))
    mean = means.mean()
    return mean / 1e6, np.sqrt((deviations ** 2 + means ** 2).mean() - mean ** 2) / 1e6


def depth(numerics, cells, steps, options=()):
    """Depth of the deepest marker in a body, in cells."""
    found = summary(numerics, cells, steps[numerics], options)
    return max(found["cloths"][name]["max_depth"] for name in MARKERS) / (BOX / cells) if found else math.nan


def bend(numerics, cells, steps, options=()):
    """Mean angle between edges that are neighbours, over all cloths, markers and frames [degrees]."""
    where = folder(numerics, cells, steps[numerics], *options)
    if not where:
        return math.nan
    counts = [markers * cells // 64 for markers in MARKERS.values() for _ in range(CLOTHS)]
    angles = []
    for cloth in np.split(read_markers(where)[1], np.cumsum(counts)[:-1], axis=1):
        edges = np.diff(cloth, axis=1)
        directions = np.arctan2(edges[..., 1], edges[..., 0])
        angles.append(np.abs((np.diff(directions, axis=1) + np.pi) % (2 * np.pi) - np.pi).mean())
    return np.degrees(np.mean(angles))


def stretch(numerics, cells, steps, options=()):
    """Largest stretch of an edge [%]."""
    found = summary(numerics, cells, steps[numerics], options)
    return 100 * max(found["cloths"][name]["max_stretch"] for name in MARKERS) if found else math.nan


def rows():
    """Tables 5.4-3 and 5.4-4, Figs. 5.4-3 and 5.4-4."""
    steps = {THEIRS: STEP, TODAY: 3.5e-4}
    for cells, figure in TABLE.items():
        few = {"numerics": (TODAY,)} if cells == 256 else {}
        for name, measure in ((STRESS, stress), ("largest stretch [%]", stretch), (DEPTH, depth)):
            yield Row("5.4-3", f"{cells} x {cells}", name, figure if measure is stress else "", functools.partial(measure, cells=cells, steps=steps),
                      within=MOTION, slack=SLACK if measure is depth else 0, **few)
    for part, name, figure in ((1, "dt*", "0.137 (0.042)"), (2, "dt*/2", "0.135 (0.034)"), (4, "dt*/4", "0.147 (0.048)")):
        few = {"numerics": (TODAY,)} if part == 4 else {}
        yield Row("5.4-4", f"128 x 128, {name}", STRESS, figure,
                  functools.partial(stress, cells=128, steps={THEIRS: LONGEST / part, TODAY: 7e-4 / part}), within=MOTION, **few)
    steps = {THEIRS: LONGEST, TODAY: 3.5e-4}
    for mask in ("sharp", "smooth"):
        yield Row("Fig. 5.4-3", f"128 x 128, {mask} mask", DEPTH,
                  "slightly inside" if mask == "sharp" else "kept away",
                  functools.partial(depth, cells=128, steps=steps, options=("-body_mask", mask)), within=MOTION, slack=SLACK)
    for stiffness, name in ((1e-5, "2.6e-5"), (1e-2, "2.6e-2")):
        for quantity, measure in ((BEND, bend), (STRESS, stress)):
            said = ("smoother" if stiffness > 1e-5 else "picture") if measure is bend else ""
            yield Row("Fig. 5.4-4", f"128 x 128, Be = {name}", quantity, said,
                      functools.partial(measure, cells=128, steps=steps, options=("-long_kb", stiffness, "-short_kb", stiffness)),
                      within=MOTION)


def claims():
    """Stress falls with the spacing; stiffer cloths are smoother; today's penalty contact keeps cloths out of the bodies."""
    names = [f"{cells} x {cells}" for cells in TABLE]
    yield checks.falls("5.4-3", names[:3], quantity=STRESS)
    yield checks.falls("5.4-3", names[2:], quantity=STRESS, numerics=(TODAY,))
    for name in names:
        yield checks.Check("5.4-3", f"{DEPTH}, {name}", (name,), max, most=MOST_DEPTH, quantity=DEPTH, numerics=(TODAY,),
                           miss=THIN if name == "32 x 32" else "")
    for numerics, parts in ((THEIRS, ("dt*", "dt*/2")), (TODAY, ("dt*", "dt*/2", "dt*/4"))):
        yield checks.Check("5.4-4", "largest mean stress over the smallest", tuple(f"128 x 128, {part}" for part in parts),
                           lambda figures: max(figures) / min(figures), most=1 + MOTION, numerics=(numerics,))
    yield checks.falls("Fig. 5.4-4", [f"128 x 128, Be = {name}" for name in ("2.6e-5", "2.6e-2")], quantity=BEND)
    for mask in ("sharp", "smooth"):
        yield checks.Check("Fig. 5.4-3", f"{DEPTH}, {mask} mask", (f"128 x 128, {mask} mask",), max, most=MOST_DEPTH, numerics=(TODAY,))
