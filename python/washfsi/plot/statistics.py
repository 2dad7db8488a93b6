# SPDX-License-Identifier: BSD-3-Clause
"""Profiles of means and stresses of a turbulent flow."""

from matplotlib.figure import Figure

from washfsi.plot.style import GRID_COLOR, LINE_COLORS, WIDTH, wrapped

PANELS = {"mean velocity": ("u", "v", "w"), "normal stresses": ("uu", "vv", "ww"), "shear stresses": ("uv", "uw", "vw")}


def draw_statistics(table, case):
    """Returns the picture of statistics.csv, a panel each for velocities, normal and shear stresses."""
    place = next(iter(table))
    figure = Figure(figsize=(WIDTH, 3.4))
    figure.subplots_adjust(left=0.1, right=0.98, top=0.87, bottom=0.15, wspace=0.3)
    grid = figure.subplots(1, len(PANELS), sharey=True)
    for axes, (title, names) in zip(grid, PANELS.items()):
        shown = [name for name in names if name in table]
        for name, color in zip(shown, LINE_COLORS):
            axes.plot(table[name], table[place], color=color, linewidth=1.5, label=name)
        axes.set_xlabel(f"{title} [{table.units[shown[0]]}]", fontsize=8)
        axes.ticklabel_format(axis="x", scilimits=(-2, 4), useMathText=True)
        axes.grid(color=GRID_COLOR, linewidth=0.6)
        axes.legend(frameon=False, fontsize=8, handlelength=1.2)
    grid[0].set_ylabel(f"{place} [m]")
    figure.suptitle(wrapped(case), fontsize=10)
    return figure
