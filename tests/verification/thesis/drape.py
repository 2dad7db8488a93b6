# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 4.3.3: a square cloth draped over a square prism on three grids (Fig. 4.3-3, shapes only)."""

import functools
import math

import results
from drape_test import HEIGHT, MARKERS, asymmetry
from tables import read_columns, read_markers
from thesis.rows import THEIRS, Row, case_file


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


def uneven(numerics, cells):
    """How far the shape is from its images by rotations and mirrors, over the side."""
    folder = drape(numerics, cells)
    return asymmetry(read_markers(folder, axes=3)[1][-1].reshape(MARKERS[cells], MARKERS[cells], 3)) if folder else math.nan


def depth(numerics, cells):
    """Depth of the deepest marker in the prism, in cells' heights."""
    folder = drape(numerics, cells)
    return read_columns(folder / "history.csv")["sheet_depth"].max() / (HEIGHT / cells) if folder else math.nan


def rows():
    """Table 4.3-9 and Fig. 4.3-3."""
    for name, measure in (("lowest place [m]", lowest), ("deepest marker [cells' heights]", depth),
                          ("difference from its mirror images over the side", uneven)):
        for cells in MARKERS:
            yield Row("4.3-9", f"{cells}^3 / {MARKERS[cells]}^2", name, "picture", functools.partial(measure, cells=cells), within=0.2)
