# SPDX-License-Identifier: BSD-3-Clause
"""Runs of one case on several grids: each figure of a cycle, continued to cells of no width."""

import math
import statistics

from washfsi.report.figures import figure_rows
from washfsi.report.words import numbers
from washfsi.study.refinement import estimate
from washfsi.study.tables import OF_THE_CELLS, spread

OF_THE_GRID = {"grid_cells", "time_step", "contact_distance", "contact_body_distance"}
# As in simulation/changed_options.cpp, without time_end: a longer run has means over other cycles.
OF_THE_RUN = {"max_steps", "output_dir", "history_interval", "case_name", "output_interval", "checkpoint_interval", "restart", "check",
              "strict"}
ROUNDING = 1.05  # of ratios of cells that count as one


def options_of(run, of_grid):
    """Returns the options of a run that make its grid, markers and steps, or else those that make its case; seeds do neither."""
    return tuple(sorted((name, value) for name, value in run["options"].items()
                        if name not in OF_THE_RUN and not name.endswith("_seed")
                        and (name in OF_THE_GRID or name.endswith("_markers")) == of_grid))


def cells_of(run):
    """Returns the cells of a run along each axis."""
    return tuple(map(int, numbers(run["options"], "grid_cells")))


def cells_per_axis(cells):
    """Returns the mean number of cells along an axis, of those with more than one, which alone are refined."""
    several = [count for count in cells if count > 1]
    return math.prod(several) ** (1 / max(len(several), 1))


def ratios(coarse, fine):
    """Returns how many times as many cells the finer grid has along each axis."""
    return [new / old for old, new in zip(coarse, fine) if max(old, new) > 1]


def refined(grids):
    """Returns the grids of a case, the coarsest first, without those that do not refine it by the same ratio along each axis."""
    coarsest, *finer = sorted(grids, key=cells_per_axis)
    kept = [coarsest]
    for cells in finer:
        factors = ratios(coarsest, cells)
        if max(factors) <= ROUNDING * min(factors) and min(ratios(kept[-1], cells)) > 1:
            kept.append(cells)
    return {cells: grids[cells] for cells in kept}


def by_grid(runs):
    """Returns the runs of each case that was run on several grids: {cells: places of its runs}, the coarsest grid first. Runs on the same
    cells with other markers or steps are no seeds of one figure: their case is left out."""
    cases = {}
    for place, run in enumerate(runs):
        if cells_of(run):
            cases.setdefault(options_of(run, of_grid=False), {}).setdefault(options_of(run, of_grid=True), []).append(place)
    tables = []
    for resolutions in cases.values():
        grids = {cells_of(runs[places[0]]): places for places in resolutions.values()}
        tables += [refined(grids)] if len(grids) == len(resolutions) else []
    return [grids for grids in tables if len(grids) > 1]


def values_on(grids, row):
    """Returns the values of a figure on each grid: means over cycles; first cycles, which are start-up, only where no grid has a mean."""
    found = [[row["values"][place] for place in places if row["values"][place]] for places in grids.values()]
    means = [[figure["value"] for figure in mine if not figure["first"]] for mine in found]
    return means if any(means) else [[figure["value"] for figure in mine] for mine in found]


def continued(row, grids):
    """Returns a row of figures with its means over the seeds of each grid and the estimate; None where a grid has none."""
    samples = values_on(grids, row)
    if not all(samples) or None in sum(samples, []) or not any(sum(samples, [])):
        return None
    counts = [cells_per_axis(cells) for cells in grids]
    found = estimate({count / counts[0]: values for count, values in zip(counts, samples)})
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
