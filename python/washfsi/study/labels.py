# SPDX-License-Identifier: BSD-3-Clause
"""Labels of points in a plot that neither overlap each other nor cover points."""

import itertools
import math

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text
from matplotlib.transforms import Bbox

DIRECTIONS = [45, 0, 90, 135, 315, 180, 270, 225, 20, 70, 110, 160, 200, 250, 290, 340]  # [degrees], the best first
DISTANCES = [9, 16, 24, 34, 46, 60, 78, 100]  # from the point [1/72 in]
LEADER = 10  # a label farther away gets a line [1/72 in]
HALF_POINT = 4  # [1/72 in]
MARGIN = 1  # round a label [1/72 in]


def alignment(value):
    """Returns which edge of a label faces its point, of (low, middle, high)."""
    return 0 if value > 0.35 else 2 if value < -0.35 else 1


def place_label(axes, point, text, color, angle, distance):
    """Puts a label at a distance from its point."""
    x, y = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return axes.annotate(text, point, (distance * x, distance * y), textcoords="offset points", fontsize=8, color=color,
                         ha=("left", "center", "right")[alignment(x)], va=("bottom", "center", "top")[alignment(y)],
                         arrowprops={"arrowstyle": "-", "lw": 0.6, "color": color, "shrinkA": 0, "shrinkB": 2}
                         if distance >= LEADER else None)


def overlap(first, second):
    """Returns the area that two boxes share."""
    shared = Bbox.intersection(first, second)
    return shared.width * shared.height if shared else 0.0


def outside(inner, outer):
    """Returns the area of a box that lies outside another one."""
    return inner.width * inner.height - overlap(inner, outer)


def box_of(label, renderer, pixel):
    """Returns the box of a label's text, without its line."""
    label.update_positions(renderer)
    return Text.get_window_extent(label, renderer).padded(MARGIN * pixel)


def label_points(axes, points, texts, colors, bars=()):
    """Labels points; `bars` are lines in data that should stay free as well. Call it when the limits are final."""
    figure = axes.figure
    renderer, pixel = FigureCanvasAgg(figure).get_renderer(), figure.dpi / 72
    places = axes.transData.transform(points) if len(points) else []
    taken = [Bbox([place - HALF_POINT * pixel, place + HALF_POINT * pixel]) for place in places]
    taken += [Bbox(axes.transData.transform(bar)).padded(MARGIN * pixel) for bar in bars]
    labels = []
    for point, text, color in zip(points, texts, colors):
        best = None
        for distance, angle in itertools.product(DISTANCES, DIRECTIONS):
            label = place_label(axes, point, text, color, angle, distance)
            box = box_of(label, renderer, pixel)
            cost = sum(overlap(box, other) for other in taken) + 2 * outside(box, axes.bbox)
            label.remove()
            if best is None or cost < best[0]:
                best = cost, angle, distance, box
            if cost == 0:
                break
        labels.append(place_label(axes, point, text, color, *best[1:3]))
        taken.append(best[3])
    return labels
