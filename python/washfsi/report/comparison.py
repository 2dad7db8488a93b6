# SPDX-License-Identifier: BSD-3-Clause
"""Several runs beside each other: their figures, washing action against what it costs, what can be decided."""

import os
import re
import statistics

from washfsi.report.figures import MACHINE, figure_rows, value_of
from washfsi.report.grids import on_grids
from washfsi.study.tables import HEADLINES, spread
from washfsi.study.tradeoff import ACTIONS, COSTS
from washfsi.study.verdict import sentence

SEED = re.compile(r"seed_\d+")


def short_names(folders, cases):
    """Returns a name for each run: its case, or what tells its folder from the others where cases are the same."""
    if len(set(cases)) == len(cases):
        return list(cases)
    places = [str(folder.resolve()) for folder in folders]
    common = os.path.commonpath(places)
    return [os.path.relpath(place, common) if place != common else folder.name
            for place, folder in zip(places, folders)]


def design_of(folder, name):
    """Returns the design that a run belongs to: the runs of a study with several seeds are one."""
    return folder.resolve().parent.name if SEED.fullmatch(folder.resolve().name) else name


def figures_for(run, group):
    """Returns the figures of a run that concern a group or the machine by (name, unit): value, spread and whether it is
    of the first cycle alone. `work` is that of all bodies."""
    found = {}
    for figure in (run["cycles"] or {"figures": []})["figures"]:
        best = value_of(figure)
        if best["value"] is None:  # no number
            continue
        key = (figure["rest"], figure["unit"])
        if figure["rest"] == "work":
            before = found.get(key)
            best = best if not before else best | {"value": best["value"] + before["value"], "std": None}
            found[key] = best if figure["values"][0] or not before else before
        elif figure["owner"] in (group, MACHINE):
            found[key] = best
    return found


def samples_of(runs, group):
    """Returns the figures of each design, a list over its seeds of what figures_for returns."""
    samples = {}
    for run in runs:
        samples.setdefault(run["design"], []).append(figures_for(run, group))
    return samples


def point_of(seeds, name):
    """Returns a figure of a design: mean and spread over its seeds, with one seed over its cycles; None without. Seeds with a
    first cycle alone count only where no seed has more."""
    every = [(unit, figure) for figures in seeds for (key, unit), figure in figures.items() if key == name]
    found = [one for one in every if not one[1]["first"]] or every
    if not found:
        return None
    values = [figure["value"] for _, figure in found]
    return {"value": statistics.fmean(values), "std": spread(values) if len(values) > 1 else found[0][1]["std"],
            "unit": found[0][0], "seeds": len(values), "first": any(figure["first"] for _, figure in found)}


def tradeoffs(runs, groups):
    """Returns the panels of the picture: an action against a cost for a group, a point for each design."""
    panels = []
    for group in groups:
        samples = samples_of(runs, group)
        for action, action_title in ACTIONS.items():
            for cost, cost_title in COSTS.items():
                points = [{"name": design, "x": point_of(seeds, cost), "y": point_of(seeds, action)}
                          for design, seeds in samples.items()]
                points = [point for point in points if point["x"] and point["y"]]
                if points:
                    panels.append({"group": group, "x": cost_title, "y": action_title, "points": points})
    return panels


def verdicts(runs, groups):
    """Returns what can be decided of the headlines of each group, in sentences."""
    told = []
    for group in groups:
        samples = samples_of(runs, group)
        for name in HEADLINES:
            if name == "work" and group != groups[0]:  # that of all bodies is said once
                continue
            values, unit = {}, ""
            for design, seeds in samples.items():
                found = [(unit, figure) for figures in seeds for (key, unit), figure in figures.items() if key == name]
                if found and not any(figure["first"] for _, figure in found):
                    values[design], unit = [figure["value"] for _, figure in found], found[0][0]
            if len(values) > 1:
                title = name.replace("_", " ")
                title = title if len(groups) < 2 or name == "work" else f"{group}, {title}"
                told.append(sentence(title, values, unit))
    return told


def comparison_of(runs):
    """Returns the comparison for the page; None of one run. Each run has a name, a design, cycles and groups."""
    if len(runs) < 2:
        return None
    groups = list(dict.fromkeys(group for run in runs for group in run["groups"]))
    rows = figure_rows(runs)
    return {"rows": rows, "tradeoffs": tradeoffs(runs, groups), "verdicts": verdicts(runs, groups), "grids": on_grids(runs),
            "first": any(value["first"] for row in rows for value in row["values"] if value),
            "designs": list(dict.fromkeys(run["design"] for run in runs))}
