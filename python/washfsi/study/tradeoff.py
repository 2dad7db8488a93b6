# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a study: washing action against work in a cycle and against the stress of the cloth."""

import statistics

import numpy as np
from matplotlib.figure import Figure

from washfsi.study.labels import label_points
from washfsi.study.tables import spread

ACTIONS = {"relative_speed": "speed of water along cloth", "water_shear": "shear of water on cloth"}
COSTS = {"work": "work in a cycle", "stress": "stress of cloth"}
COLORS = ["#24527a", "#c0392b", "#12806a", "#8e5bb5", "#b9770e", "#3a3a3a", "#d0569b", "#5d8a1d"]
POINTS = "os^Dv"  # with every round through the colours another form
DPI = 150
SIZE = 4.6, 4.2  # of a panel [in]


def points_of(samples, cost, action):
    """Returns name, (cost, action) and their spreads for each design that has both figures, and the two units."""
    points, units = [], ("", "")
    for design, figures in samples.items():
        keys = [next((key for key in figures if key[0] == name), None) for name in (cost, action)]
        if all(keys):
            values = [figures[key] for key in keys]
            points.append((design, tuple(map(statistics.fmean, values)), tuple(spread(one) or 0.0 for one in values)))
            units = tuple(key[1] for key in keys)
    return points, units


def label_of(text, unit):
    """Returns an axis's label."""
    return text if unit in ("", "-") else f"{text} [{unit}]"


def style_of(number):
    """Returns colour and form of a design's point."""
    return COLORS[number % len(COLORS)], POINTS[number // len(COLORS) % len(POINTS)]


def draw_panel(axes, samples, cost, action):
    """Draws one trade-off; returns what label_points needs to name its points."""
    points, units = points_of(samples, cost, action)
    axes.set(xlabel=label_of(COSTS[cost], units[0]), ylabel=label_of(ACTIONS[action], units[1]))
    axes.grid(color="#dddddd", linewidth=0.6)
    axes.ticklabel_format(scilimits=(-3, 4), useMathText=True)
    axes.locator_params(nbins=6)
    if not points:
        return (), (), (), ()
    places, widths = (np.array([point[which] for point in points]) for which in (1, 2))
    styles = [style_of(list(samples).index(point[0])) for point in points]
    for place, width, (color, form) in zip(places, widths, styles):
        axes.errorbar(*place, *width[::-1], fmt=form, color=color, elinewidth=0.8, capsize=2.5, markersize=4.5, alpha=0.85)
    axes.margins(0.22)
    bars = [(place - offset, place + offset) for place, width in zip(places, widths)
            for offset in (width * (1, 0), width * (0, 1)) if offset.any()]
    return places, [point[0] for point in points], [color for color, _ in styles], bars


def draw_tradeoff(groups, seeds, action="relative_speed"):
    """Returns the picture and its labels. `groups` has, for each group of cloths, the designs' figures: by name and unit, a
    value for each seed."""
    figure = Figure(figsize=(SIZE[0] * len(COSTS), SIZE[1] * len(groups) + 0.4), dpi=DPI, layout="constrained")
    bars = f"bars: standard deviation over {seeds} seeds" if seeds > 1 else "one seed: spread not known"
    figure.suptitle(f"Washing action and what it costs, mean over cycles ({bars})", fontsize=10)
    panels, grid = [], figure.subplots(len(groups), len(COSTS), squeeze=False)
    for row, (group, samples) in zip(grid, groups.items()):
        for axes, cost in zip(row, COSTS):
            if len(groups) > 1:
                axes.set_title(group, fontsize=10)
            panels.append((axes, draw_panel(axes, samples, cost, action)))
    figure.draw_without_rendering()
    figure.set_layout_engine("none")  # labels need panels that stay where they are
    return figure, [label_points(axes, *panel) for axes, panel in panels]
