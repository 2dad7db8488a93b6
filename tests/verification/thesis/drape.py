# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 4.3.3: a square cloth draped over a square prism on three grids (Fig. 4.3-3, shapes only)."""

import functools
import math

import numpy as np

import results
from tables import read_columns, read_markers
from thesis import checks
from thesis.rows import THEIRS, TODAY, Row, case_file

MARKERS = {15: 15, 33: 30, 65: 60}
HEIGHT, SIDE = 0.255, 0.5  # of the box and of the cloth [m]
EARLY = 0.4  # [s] before folds form
MOST_UNEVEN = 1e-8  # over the side
MOST_UNEVEN_AT_REST = {15: 1e-8, 33: 1e-4, 65: 1e-8}  # folds on 33^3 cells let round-off grow by 12 /s
MOST_DEPTH, SLACK = 0.1, 0.05  # cells' heights
LATEST_REST = 9.9  # [s] a run that gets to 10 s did not come to rest
LOWEST, DEPTH, UNEVEN, REST = "lowest place [m]", "deepest marker [cells' heights]", "difference from its mirror images over the side", "at rest after [s]"
UNEVEN_EARLY = f"{UNEVEN}, at {EARLY} s"
SAID = {LOWEST: "picture", DEPTH: "0.3 h"}  # by the thesis, of which h and of which grid it does not say


def asymmetry(places):
    """Largest difference of the cloth from its images by rotations and mirrors, over its side."""
    turned = np.stack([-places[..., 1], places[..., 0], places[..., 2]], axis=-1)
    images = [(turned, places[::-1].transpose(1, 0, 2)),
              (places * [-1, -1, 1], places[::-1, ::-1]),
              (places * [-1, 1, 1], places[::-1]),
              (places * [1, -1, 1], places[:, ::-1]),
              (places[..., [1, 0, 2]], places.transpose(1, 0, 2))]
    return max(np.abs(image - place).max() for image, place in images) / SIDE


def drape(numerics, cells):
    """The folder of the run; nothing if it failed."""
    others = ["-time_step", 2e-4 * 33 / cells] if numerics == THEIRS else ["-contact_distance", HEIGHT / cells]
    result = results.run(2, "-options_file", case_file(numerics, "drape"), "-grid_cells", ",".join([str(cells)] * 3),
                         "-sheet_markers", MARKERS[cells], "-checkpoint_interval", 0.2, *others, may_fail=True)
    return None if result.failed else result.folder


def lowest(numerics, cells):
    """The lowest place [m]."""
    folder = drape(numerics, cells)
    return read_markers(folder, axes=3)[1][-1][:, 2].min() if folder else math.nan


def uneven(numerics, cells, at=math.inf):
    """How far the shape at a time, or at the end, is from its images by rotations and mirrors, over the side."""
    folder = drape(numerics, cells)
    if not folder:
        return math.nan
    time, places = read_markers(folder, axes=3)
    frame = np.argmin(np.abs(time - min(at, time[-1])))
    return asymmetry(places[frame].reshape(MARKERS[cells], MARKERS[cells], 3))


def rest(numerics, cells):
    """When no marker was faster than 1 cm/s any more [s]; the end of the run if never."""
    folder = drape(numerics, cells)
    return read_columns(folder / "history.csv")["time"][-1] if folder else math.nan


def depth(numerics, cells):
    """Depth of the deepest marker in the prism, in cells' heights."""
    folder = drape(numerics, cells)
    return read_columns(folder / "history.csv")["sheet_depth"].max() / (HEIGHT / cells) if folder else math.nan


def name_of(cells):
    """What a grid is called in the table."""
    return f"{cells}^3 / {MARKERS[cells]}^2"


def rows():
    """Table 4.3-9 and Fig. 4.3-3."""
    early = functools.partial(uneven, at=EARLY)
    for name, measure, within in ((LOWEST, lowest, 0.2), (DEPTH, depth, 0.2), (UNEVEN, uneven, math.inf),
                                  (UNEVEN_EARLY, early, math.inf), (REST, rest, 0.2)):
        for cells in MARKERS:
            yield Row("4.3-9", name_of(cells), name, SAID.get(name, ""), functools.partial(measure, cells=cells),
                      within=within, slack=SLACK if measure is depth else 0, comparable=False)


def claims():
    """Symmetry, rest, and that the cloth stays outside the prism."""
    names, only = [name_of(cells) for cells in MARKERS], {"numerics": (TODAY,)}
    yield checks.largest("4.3-9", UNEVEN_EARLY, names, MOST_UNEVEN)
    for cells, most in MOST_UNEVEN_AT_REST.items():
        yield checks.largest("4.3-9", UNEVEN, [name_of(cells)], most, **only)
    yield checks.largest("4.3-9", REST, names, LATEST_REST, **only)
    yield checks.Check("4.3-9", "deepest marker of all grids [cells' heights]", tuple(names), max, most=MOST_DEPTH, quantity=DEPTH, **only)
