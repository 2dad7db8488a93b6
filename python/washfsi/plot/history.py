# SPDX-License-Identifier: BSD-3-Clause
"""Columns of the history over time."""

from matplotlib.figure import Figure

from washfsi.errors import ResultsError
from washfsi.plot.style import GRID_COLOR, GROUP_COLORS, LINE_COLORS, WIDTH, wrapped

USUAL_PANELS = {"kinetic energy": LINE_COLORS, "torque": LINE_COLORS, "stress mean": GROUP_COLORS,
                "elastic energy": GROUP_COLORS, "CFL": LINE_COLORS}


def belongs(name, part):
    """Returns whether a column belongs to the usual panel of a name."""
    if part == "stress_mean":
        return name.endswith("_stress_mean") and "membrane" not in name and "bending" not in name
    return part in name and not name.endswith(("torque_x", "torque_y")) and "_balance" not in name


def label_of(name, part):
    """Returns what a column's name says beside the name of its panel."""
    axis_less = name.removesuffix("_z") if part == "torque" else name
    return axis_less.replace(part, "").strip("_").replace("__", "_")


def choose_panels(columns, wanted):
    """Returns (title, labels by column, colours) of each panel: those wanted or the usual ones."""
    if wanted is not None:
        for name in wanted.split(","):
            if name not in columns:
                raise ResultsError(f"history.csv has no column '{name}'; it has {', '.join(columns)}")
        return [(name.replace("_", " "), {name: ""}, LINE_COLORS) for name in wanted.split(",")]
    panels = []
    for title, colors in USUAL_PANELS.items():
        part = title.lower().replace(" ", "_")
        names = {name: label_of(name, part) for name in columns if belongs(name, part)}
        panels += [(title, names, colors)] if names else []
    if not panels:
        raise ResultsError("history.csv has no usual column; name some with --history")
    return panels


def draw_panel(axes, panel, history):
    """Draws the columns of one panel over time."""
    title, names, colors = panel
    for index, (name, label) in enumerate(names.items()):
        axes.plot(history["time"], history[name], color=colors[index % len(colors)], linewidth=1.5,
                  linestyle=("-", "--", ":")[index // len(colors) % 3],
                  marker="o" if history.rows == 1 else None, label=label)
    unit = history.units[name]
    axes.set_ylabel(title if unit in ("", "-", "1") else f"{title}\n[{unit}]")
    axes.ticklabel_format(axis="y", scilimits=(-2, 4), useMathText=True)
    axes.locator_params(axis="y", nbins=5)
    axes.grid(color=GRID_COLOR, linewidth=0.6)
    axes.margins(x=0)
    if any(names.values()):  # beside the panel, where names may be as long as they are
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.04), frameon=False, fontsize=8, handlelength=1.2)


def draw_history(history, case, wanted=None):
    """Returns the picture of the history."""
    if "time" not in history or not history.rows:
        raise ResultsError("history.csv has no rows or no column 'time'")
    panels = choose_panels(history, wanted)
    figure = Figure(figsize=(WIDTH, 1.0 + 1.45 * len(panels)))
    figure.subplots_adjust(left=0.15, right=0.98, top=1 - 0.45 / figure.get_figheight(),
                           bottom=0.5 / figure.get_figheight(), hspace=0.3)
    grid = figure.subplots(len(panels), sharex=True, squeeze=False)[:, 0]
    for axes, panel in zip(grid, panels):
        draw_panel(axes, panel, history)
    grid[0].set_title(wrapped(case))
    grid[-1].set_xlabel("time [s]")
    figure.align_ylabels(grid)
    return figure
