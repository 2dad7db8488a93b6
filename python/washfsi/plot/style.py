# SPDX-License-Identifier: BSD-3-Clause
"""Sizes, colours and legends of all pictures."""

import textwrap

from matplotlib.lines import Line2D

from washfsi.errors import ResultsError

WIDTH, DPI = 6.0, 150  # of a picture [in, 1/in]
GROUP_COLORS = ["#ffb000", "#12a150", "#a03cc8", "#00b4c8", "#f062a6", "#7a5230"]
LINE_COLORS = ["#24527a", "#c0392b", "#3a3a3a", "#12806a", "#8e5bb5", "#b9770e"]
SOLID_COLOR = "#bdbdbd"
OUTLINE_COLOR = "#2b2b2b"
GRID_COLOR = "#dddddd"
LETTERS = 62  # that fit into the width of a picture


def group_color(group):
    """Returns the colour of a group of cloths."""
    return GROUP_COLORS[group % len(GROUP_COLORS)]


def group_name(names, group):
    """Returns the name of a group of cloths."""
    return names[group] if group < len(names) else f"group {group}"


def wrapped(title):
    """Returns a title in lines that fit."""
    return "\n".join(textwrap.wrap(title, LETTERS))


def even_size(width, height):
    """Returns a size [in] of even numbers of pixels, as movies need."""
    return tuple(2 * round(length * DPI / 2) / DPI for length in (width, height))


def add_group_legend(owner, names, groups, **place):
    """Adds a legend of several groups to axes or a figure: as many columns as the names leave room for."""
    if len(groups) < 2:
        return
    handles = [Line2D([], [], color=group_color(group), linewidth=3, label=group_name(names, group)) for group in groups]
    longest = max(len(handle.get_label()) for handle in handles)
    owner.legend(handles=handles, frameon=False, ncol=max(1, min(len(handles), LETTERS // (longest + 6))), **place)


def save(figure, path, tight=True):
    """Writes a picture and prints its name."""
    try:
        figure.savefig(path, dpi=DPI, **({"bbox_inches": "tight", "pad_inches": 0.08} if tight else {}))
    except (OSError, ValueError) as error:
        raise ResultsError(f"cannot write {path}: {error}") from None
    print(path)
