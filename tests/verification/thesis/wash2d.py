# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 5.4: the washing machine in two dimensions, with our own agitator (the thesis's dimensions are in a lost figure).

Stress: mean over the markers of both groups of each marker's average over time, and its standard deviation [MPa]. Markers
are as far apart as cells are wide.
"""

import functools
import json
import math

import results
import wash2d_test
from thesis.rows import THEIRS, TODAY, Row, case_file
from wash2d_test import CYCLE, MARKERS

BOX = 0.6912  # [m]
TABLE = {32: "1.492 (0.511)", 64: "0.386 (0.171)", 128: "0.135 (0.034)", 256: "0.087 (0.017)"}  # h/2r_o from 3.39e-2 on
STEP = 7.52e-6  # [s] 9.45e-5/Omega_max
LONGEST = 1.5e-5  # [s] dt* of Table 5.4-4
MOTION = 0.3  # cloths mix: figures move by so much between versions


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
    """Mean and standard deviation over the markers of all cloths [MPa]."""
    found = summary(numerics, cells, steps[numerics], options)
    return wash2d_test.stress(found) if found else (math.nan, math.nan)


def depth(numerics, cells, steps, options=()):
    """Depth of the deepest marker in a body, in cells."""
    found = summary(numerics, cells, steps[numerics], options)
    return wash2d_test.depth(found, BOX / cells) if found else math.nan


def stretch(numerics, cells, steps, options=()):
    """Largest stretch of an edge [%]."""
    found = summary(numerics, cells, steps[numerics], options)
    return 100 * max(found["cloths"][name]["max_stretch"] for name in MARKERS) if found else math.nan


def rows():
    """Tables 5.4-3 and 5.4-4, Figs. 5.4-3 and 5.4-4."""
    steps = {THEIRS: STEP, TODAY: 3.5e-4}
    for cells, figure in TABLE.items():
        few = {"numerics": (TODAY,), "not_run": "not run: 12 h on one core"} if cells == 256 else {}
        for name, measure in (("mean stress (standard deviation) [MPa]", stress), ("largest stretch [%]", stretch)):
            yield Row("5.4-3", f"{cells} x {cells}", name, figure if measure is stress else "",
                      functools.partial(measure, cells=cells, steps=steps), within=MOTION, **few)
    for part, name, figure in ((1, "dt*", "0.137 (0.042)"), (2, "dt*/2", "0.135 (0.034)"), (4, "dt*/4", "0.147 (0.048)")):
        few = {"numerics": (TODAY,), "not_run": "not run: 4 h on one core"} if part == 4 else {}
        yield Row("5.4-4", f"128 x 128, {name}", "mean stress (standard deviation) [MPa]", figure,
                  functools.partial(stress, cells=128, steps={THEIRS: LONGEST / part, TODAY: 7e-4 / part}), within=MOTION, **few)
    steps = {THEIRS: LONGEST, TODAY: 3.5e-4}
    for mask in ("sharp", "smooth"):
        yield Row("Fig. 5.4-3", f"128 x 128, {mask} mask", "deepest marker in a body [cells]",
                  "slightly inside" if mask == "sharp" else "kept away",
                  functools.partial(depth, cells=128, steps=steps, options=("-body_mask", mask)), within=MOTION)
    for stiffness, name in ((1e-5, "2.6e-5"), (1e-2, "2.6e-2")):
        yield Row("Fig. 5.4-4", f"128 x 128, Be = {name}", "mean stress (standard deviation) [MPa]", "pictures",
                  functools.partial(stress, cells=128, steps=steps, options=("-long_kb", stiffness, "-short_kb", stiffness)),
                  within=MOTION)
