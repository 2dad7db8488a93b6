# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 4.3.3: a square cloth draped over a square prism on three grids (Fig. 4.3-3, shapes only)."""

import functools
import math

import numpy as np

import results
from tables import SOURCE, read_columns, read_markers
from thesis.rows import THEIRS, Row

CASES = SOURCE / "inputs" / "thesis"
MARKERS = {15: 15, 33: 30, 65: 60}
HEIGHT, SIDE = 0.255, 0.5  # [m]


def drape(numerics, cells):
    """The folder of the run; nothing if it failed."""
    case = CASES / "drape.opts" if numerics == THEIRS else CASES / "today" / "drape.opts"
    others = ["-time_step", 2e-4 * 33 / cells] if numerics == THEIRS else ["-contact_distance", HEIGHT / cells]
    result = results.run(2, "-options_file", case, "-grid_cells", ",".join([str(cells)] * 3), "-sheet_markers", MARKERS[cells],
                         "-checkpoint_interval", 0.2, *others, may_fail=True)
    return None if result.failed else result.folder


def shape(numerics, cells):
    """The lowest place [m], and how far the shape is from its images by rotations and mirrors, over the side."""
    folder = drape(numerics, cells)
    if not folder:
        return math.nan, math.nan
    places = read_markers(folder, axes=3)[1][-1].reshape(MARKERS[cells], MARKERS[cells], 3)
    turned = np.stack([-places[..., 1], places[..., 0], places[..., 2]], axis=-1)
    images = [(turned, places[::-1].transpose(1, 0, 2)), (places * [-1, -1, 1], places[::-1, ::-1]),
              (places * [-1, 1, 1], places[::-1]), (places * [1, -1, 1], places[:, ::-1]),
              (places[..., [1, 0, 2]], places.transpose(1, 0, 2))]
    return places[..., 2].min(), max(np.abs(image - place).max() for image, place in images) / SIDE


def depth(numerics, cells):
    """Depth of the deepest marker in the prism, in cells' heights."""
    folder = drape(numerics, cells)
    return read_columns(folder / "history.csv")["sheet_depth"].max() / (HEIGHT / cells) if folder else math.nan


def rows():
    """Table 4.3-9 and Fig. 4.3-3."""
    for cells in MARKERS:
        yield Row("4.3-9", f"{cells}^3 / {MARKERS[cells]}^2", "lowest place [m]", "picture",
                  lambda numerics, cells=cells: shape(numerics, cells)[0])
    for cells in MARKERS:
        yield Row("4.3-9", f"{cells}^3 / {MARKERS[cells]}^2", "deepest marker [cells' heights]", "picture",
                  functools.partial(depth, cells=cells), within=0.2)
