# SPDX-License-Identifier: BSD-3-Clause
"""The machine and its load at the start as line drawings (SVG): from above, and in space from the front."""

import html

import numpy as np
from contourpy import FillType, contour_generator

from washfsi.paraview_view.command import surrounds

VIEWS = {"from above": (0, 1, 2), "from the front": (0, 2, 1)}  # axis across, axis up, axis along which one looks
LEAST_SEEN = 0.5  # of the cells in which a surface is seen, those that must be solid for the outline to be that of solid cells
LEVELS = 9  # at which a body is cut for its form to be seen
WIDTH = 360.0  # of a view [units of the drawing]
MARGIN = 30.0  # for the lengths
STEPS = (1, 2, 5)  # of the length of the scale, times a power of ten


def flattened(distance, view):
    """Returns a body as seen along an axis: its outline; of one that surrounds the water the cut half way. Rows are
    `up`."""
    if distance.ndim == 2:
        return distance
    across, up, along = (2 - axis for axis in view)  # arrays have x last
    half = distance.shape[along] // 2
    flat = np.take(distance, half, axis=along) if surrounds(distance) else distance.min(axis=along)
    return flat if up < across else flat.T


def shade(results, name, flat, view):
    """Returns the outline `flat` of a body; of one with parts thinner than cells, which lie between their centres, where its
    surface is seen instead."""
    surfaces, flow = results.surfaces, results.flow
    if flow.dim == 2 or not surfaces or name not in surfaces.bodies:
        return flat
    corners = surfaces.frame(0)["position"][surfaces.facets_of(name)]
    points = np.concatenate([*np.moveaxis(corners, 1, 0), corners.mean(axis=1)])
    across, up = view[:2]
    edges = [flow.lower[axis] + flow.spacing[axis] * np.arange(flow.cells[axis] + 1) for axis in (up, across)]
    seen = np.histogram2d(points[:, up], points[:, across], edges)[0] > 0
    return flat if (flat < 0).sum() > LEAST_SEEN * seen.sum() else np.where(seen, -1.0, 1.0)


def levels(distance, view):
    """Returns cuts through a body across the direction in which one looks, some of them, as fields like `flattened`."""
    if distance.ndim == 2 or surrounds(distance):
        return []
    across, up, along = (2 - axis for axis in view)
    places = np.linspace(0, distance.shape[along] - 1, LEVELS).astype(int)
    cuts = [np.take(distance, place, axis=along) for place in places]
    return [cut if up < across else cut.T for cut in cuts if cut.min() < 0 < cut.max()]


def rings(field, axes):
    """Returns the outlines of where a field of cells is negative, as closed lines; `axes` are the centres, across and
    up. To the faces of the box it goes on as in the outermost cells."""
    padded = np.pad(field, 1, mode="edge")
    places = [np.concatenate([[1.5 * line[0] - 0.5 * line[1]], line, [1.5 * line[-1] - 0.5 * line[-2]]])
              for line in axes]
    generator = contour_generator(*places, padded, fill_type=FillType.OuterOffset)
    points, offsets = generator.filled(padded.min() - 1, 0.0)
    return [part[start:end] for part, cuts in zip(points, offsets) for start, end in zip(cuts, cuts[1:])]


def scale_length(width):
    """Returns a round length of about a quarter of a width."""
    power = 10.0 ** np.floor(np.log10(width / 4))
    return float(max(step * power for step in STEPS if step * power <= width / 4))


class Sketch:
    """One view: lines in metres become lines of the drawing."""

    def __init__(self, lower, upper, title):
        self.lower, self.size, self.title = np.asarray(lower, float), np.subtract(upper, lower), title
        self.factor = WIDTH / self.size.max()
        self.parts = []

    def place(self, points):
        """Returns points of the drawing, y downwards."""
        moved = (np.asarray(points, float) - self.lower) * self.factor
        return np.column_stack([moved[:, 0] + MARGIN, self.size[1] * self.factor - moved[:, 1] + MARGIN])

    def add(self, lines, kind, closed=True):
        """Adds lines as one path."""
        end = "Z" if closed else ""
        words = ["M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in self.place(line)) + end for line in lines]
        if words:
            self.parts.append(f'<path class="{kind}" d="{"".join(words)}"/>')

    def text(self, x, y, words, turned=False):
        """Adds a text in the drawing's units."""
        turn = f' transform="rotate(-90 {x:.1f} {y:.1f})"' if turned else ""
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}"{turn}>{html.escape(words)}</text>')

    def add_lengths(self):
        """Adds the box's lengths and a scale."""
        width, height = self.size * self.factor
        self.text(MARGIN + width / 2, MARGIN - 10, f"{self.size[0]:.4g} m")
        self.text(MARGIN - 10, MARGIN + height / 2, f"{self.size[1]:.4g} m", turned=True)
        length = scale_length(self.size[0])
        end, level = MARGIN + length * self.factor, MARGIN + height + 14
        self.parts.append(f'<path class="scale" d="M{MARGIN} {level - 4:.1f}v8m0 -4H{end:.1f}m0 -4v8"/>')
        self.text(end + 30, level + 5, f"{length:.4g} m")

    def svg(self):
        """Returns the drawing."""
        self.add_lengths()
        width, height = self.size * self.factor + 2 * MARGIN
        return (f'<svg viewBox="0 0 {width:.0f} {height:.0f}" role="img" aria-label="{html.escape(self.title)}">'
                f'<rect class="water" x="{MARGIN}" y="{MARGIN}" width="{width - 2 * MARGIN:.1f}" '
                f'height="{height - 2 * MARGIN:.1f}"/>{"".join(self.parts)}</svg>')


def cloth_lines(results, view):
    """Returns the outlines of the cloths' cells as seen in a view, and whether they are closed."""
    if not results.cloth:
        return [], False
    positions = results.cloth.frame(0)["position"][:, list(view[:2])]
    return [positions[line] for line in results.cloth.lines], results.flow.dim == 3


def draw_view(results, title, view):
    """Returns one view."""
    flow = results.flow
    pick, centres = list(view[:2]), results.flow.centres()
    sketch = Sketch(flow.lower[pick], flow.upper[pick], title)
    for name, distance in (results.bodies.frame(0).data.items() if results.bodies else ()):
        if distance.min() < 0 < distance.max():
            axes = [centres[axis] for axis in pick]
            flat = flattened(distance, view)
            sketch.add(rings(flat if surrounds(distance) else shade(results, name, flat, view), axes), "solid")
            sketch.add([ring for cut in levels(distance, view) for ring in rings(cut, axes)], "level")
    lines, closed = cloth_lines(results, view)
    sketch.add(lines, "cloth" if closed else "fibre", closed)
    return {"title": title, "svg": sketch.svg()}


def drawings(results):
    """Returns the views of the start."""
    views = VIEWS if results.flow.dim == 3 else {"from above": (0, 1, None)}
    return [draw_view(results, title, view) for title, view in views.items()]
