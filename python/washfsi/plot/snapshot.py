# SPDX-License-Identifier: BSD-3-Clause
"""The flow in the plane: vorticity, bodies, cloths; in 3D in the middle plane, with the cloths cut by it."""

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patheffects import Normal, Stroke

from washfsi.plot.style import OUTLINE_COLOR, SOLID_COLOR, WIDTH, add_group_legend, even_size, group_color, wrapped


def draw_body(axes, distance, extent):
    """Fills where the signed distance is negative, and outlines the surface."""
    padded = np.pad(distance, 1, mode="edge")  # From the outermost centres on to the box's faces.
    x, y = (np.concatenate(([low], low + (high - low) * (np.arange(n) + 0.5) / n, [high]))
            for low, high, n in zip(extent[::2], extent[1::2], distance.shape[::-1]))
    axes.contourf(x, y, padded, levels=[padded.min() - 1, 0], colors=[SOLID_COLOR])
    axes.contour(x, y, padded, levels=[0], colors=[OUTLINE_COLOR], linewidths=1.2)


def cut(corners, height):
    """Returns the line in which a plane of constant z cuts a quadrilateral, as x,y of its two ends; None if it does not."""
    ends = []
    for first, second in zip(corners, np.roll(corners, -1, axis=0)):
        below, above = first[2] - height, second[2] - height
        if (below < 0) != (above < 0):
            ends.append((first + (second - first) * below / (below - above))[:2])
    return ends[:2] if len(ends) >= 2 else None


def cloth_paths(scene, group):
    """Returns the lines of a group in the picture [m]."""
    lines = [scene.positions[line] for line in scene.lines if scene.group[line[0]] == group]
    if scene.dim == 2:
        return [line[:, :2] for line in lines]
    cuts = (cut(line, 0.5 * (scene.lower[2] + scene.upper[2])) for line in lines)
    return [line for line in cuts if line is not None]


def draw_cloths(axes, scene, scale):
    """Draws each group of cloth in its colour, with a legend for several."""
    for group in scene.groups:
        axes.add_collection(LineCollection(
            [scale * np.asarray(path) for path in cloth_paths(scene, group)], colors=group_color(group), linewidths=1.9,
            capstyle="round", zorder=4, path_effects=[Stroke(linewidth=3.3, foreground=OUTLINE_COLOR), Normal()]))
    add_group_legend(axes, scene.names, scene.groups, loc="lower center", bbox_to_anchor=(0.5, 1))


def draw_flow(axes, scene, limit, extent):
    """Draws the vorticity, where there is any."""
    image = axes.imshow(scene.vorticity, extent=extent, origin="lower", interpolation="bicubic", cmap="RdBu_r",
                        vmin=-limit, vmax=limit)
    if scene.vorticity.any():
        axes.figure.colorbar(image, cax=axes.inset_axes([1.03, 0, 0.04, 1]), extend="both", extendfrac=0.03,
                             label="vorticity [1/s]")


def draw_snapshot(scene, limit):
    """Returns the picture of one frame; colours saturate at `limit` [1/s]."""
    size = scene.upper - scene.lower
    scale, unit = (100, "cm") if max(size) < 2 else (1, "m")
    extent = scale * np.array([scene.lower[0], scene.upper[0], scene.lower[1], scene.upper[1]])
    height = 0.74 * WIDTH * size[1] / size[0] + 1.1
    figure = Figure(figsize=even_size(WIDTH, np.clip(height, 2.4, 12)), layout="constrained")
    figure.suptitle(wrapped(scene.title if scene.dim == 2 else f"{scene.title}, mid-plane"))
    axes = figure.add_subplot(aspect="equal", xlabel=f"x [{unit}]", ylabel=f"y [{unit}]")
    draw_flow(axes, scene, limit, extent)
    for distance in (body for body in scene.planes() if body.min() < 0 < body.max()):
        draw_body(axes, distance, extent)
    draw_cloths(axes, scene, scale)
    axes.set(xlim=extent[:2], ylim=extent[2:])
    return figure
