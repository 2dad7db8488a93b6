# SPDX-License-Identifier: BSD-3-Clause
"""Runs of one case on several grids: each figure of a cycle, continued to cells of no width."""

import math
import statistics

from washfsi.report.figures import figure_rows
from washfsi.report.words import numbers
from washfsi.study.refinement import estimate
from washfsi.study.tables import OF_THE_CELLS, spread

OF_THE_GRID = {"grid_cells", "time_step", "contact_distance", "contact_body_distance"}
OF_THE_RUN = {"output_dir", "case_name", "history_interval", "output_interval", "checkpoint_interval", "restart"}


def case_of(run):
    """Returns what is the same in all runs of a case, whatever their grid and seed."""
    return tuple(sorted((name, value) for name, value in run["options"].items()
                        if name not in OF_THE_GRID | OF_THE_RUN and not name.endswith(("_markers", "_seed"))))


def cells_of(run):
    """Returns the cells of a run along each axis."""
    return tuple(map(int, numbers(run["options"], "grid_cells")))


def width_of(cells):
    """Returns the mean number of cells along an axis."""
    return math.prod(cells) ** (1 / len(cells))


def by_grid(runs):
    """Returns the runs of each case that was run on several grids: {cells: places of its runs}, the coarsest grid first."""
    cases = {}
    for place, run in enumerate(runs):
        if cells_of(run):
            cases.setdefault(case_of(run), {}).setdefault(cells_of(run), []).append(place)
    return [dict(sorted(grids.items(), key=lambda one: width_of(one[0]))) for grids in cases.values() if len(grids) > 1]


def continued(row, grids):
    """Returns a row of figures with its means over the seeds of each grid and the estimate; None where a grid has none."""
    samples = [[row["values"][place]["value"] for place in places if row["values"][place]] for places in grids.values()]
    if not all(samples) or None in sum(samples, []) or not any(sum(samples, [])):
        return None
    widths = [width_of(cells) for cells in grids]
    found = estimate({width / widths[0]: values for width, values in zip(widths, samples)})
    values = [{"value": statistics.fmean(mine), "std": spread(mine)} for mine in samples]
    return {name: row[name] for name in ("owner", "label", "unit")} | {
        "values": values, "estimate": {"value": found.value, "std": found.band}, "order": found.order, "observed": found.observed}


def on_grids(runs):
    """Returns the tables of the cases that were run on several grids: their designs, grids and rows."""
    every = figure_rows(runs)
    tables = []
    for grids in by_grid(runs):
        rows = [row for row in (continued(row, grids) for row in every if row["rest"] not in OF_THE_CELLS) if row]
        designs = dict.fromkeys(runs[place]["design"] for places in grids.values() for place in places)
        if rows:
            tables.append({"designs": list(designs), "grids": [" × ".join(map(str, cells)) for cells in grids], "rows": rows})
    return tables
