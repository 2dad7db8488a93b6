# SPDX-License-Identifier: BSD-3-Clause
"""The paths of the cloths' centres in the plane of the distance from the machine's axis and the height."""

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from washfsi.plot.style import (GRID_COLOR, OUTLINE_COLOR, SOLID_COLOR, WIDTH, add_group_legend, group_color, wrapped)

ANGLES = 72  # round the axis, to look for solid
DARKEST, BRIGHTEST = 0.55, 1.15  # of the colour of a group's cloths


def read_tracks(results):
    """Returns group, place in it and path (time by axis) of every cloth."""
    columns = results.tracks
    cloths = [name[:-2] for name in columns if name.endswith("_z")]
    groups = results.groups or sorted({cloth.rpartition("_")[0] for cloth in cloths})
    return [(groups.index(cloth.rpartition("_")[0]), int(cloth.rpartition("_")[2]),
             np.column_stack([columns[f"{cloth}_{axis}"] for axis in "xyz"])) for cloth in cloths]


def machine_axis(results):
    """Returns the machine's axis [m]."""
    given = results.options.get("machine_axis")
    if given:
        return np.array([float(number) for number in given.split(",")])
    return 0.5 * (results.flow.lower + results.flow.upper)[:2]


def drum_radius(options):
    """Returns the radius of the drum [m], the first inverted body with one, or None."""
    for option, value in options.items():
        radius = options.get(option.replace("inverted", "radius"))
        if option.endswith("_inverted") and value in ("true", "") and radius:
            return float(radius)
    return None


def turned_round(distance, scene_axes, axis, radii):
    """Returns the least signed distance on circles round the axis, by height and radius [m]: what a turn sweeps."""
    x, y = scene_axes
    angles = 2 * np.pi * np.arange(ANGLES) / ANGLES
    places = [axis[0] + np.outer(radii, np.cos(angles)), axis[1] + np.outer(radii, np.sin(angles))]
    columns, rows = (np.clip((place - line[0]) / (line[1] - line[0]), 0, len(line) - 1.001)
                     for place, line in zip(places, (x, y)))
    i, j = columns.astype(int), rows.astype(int)
    s, t = columns - i, rows - j
    values = ((1 - s) * (1 - t) * distance[:, j, i] + s * (1 - t) * distance[:, j, i + 1] +
              (1 - s) * t * distance[:, j + 1, i] + s * t * distance[:, j + 1, i + 1])
    return values.min(axis=2)


def draw_bodies(axes, results, axis, radii, scale):
    """Draws what the bodies sweep when they turn."""
    if not results.bodies:
        return
    x, y, z = results.bodies.centres()
    edges = np.concatenate([[results.flow.lower[2]], z, [results.flow.upper[2]]])
    for distance in results.bodies.frame(0).data.values():
        swept = np.pad(turned_round(distance, (x, y), axis, radii), ((1, 1), (0, 0)), mode="edge")
        if swept.min() < 0 < swept.max():
            axes.contourf(scale * radii, scale * edges, swept, levels=[swept.min() - 1, 0], colors=[SOLID_COLOR])
            axes.contour(scale * radii, scale * edges, swept, levels=[0], colors=[OUTLINE_COLOR], linewidths=1)


def shade(group, number, count):
    """Returns the colour of one cloth of a group."""
    factor = DARKEST + (BRIGHTEST - DARKEST) * number / max(count - 1, 1)
    return np.clip(factor * np.array(to_rgb(group_color(group))), 0, 1)


def draw_tracks(results):
    """Returns the picture; None without tracks in space."""
    tracks = read_tracks(results) if (results.folder / "tracks.csv").is_file() else []
    if not tracks:
        return None
    axis, radius, box = machine_axis(results), drum_radius(results.options), results.flow
    scale, unit = (1 / radius, "/$r_o$") if radius else (1, " [m]")
    reach = radius or float(np.min([box.upper[:2] - axis, axis - box.lower[:2]]))
    figure = Figure(figsize=(WIDTH, 0.8 * WIDTH), layout="constrained")
    figure.suptitle(wrapped(f"{results.case}: centres of cloths, and what the bodies sweep"))
    axes = figure.add_subplot(aspect="equal", xlabel=f"r{unit}", ylabel=f"z{unit}")
    draw_bodies(axes, results, axis, np.linspace(0, 1.04 * reach, 120), scale)
    for group, number, track in tracks:
        color = shade(group, number, sum(other == group for other, _, _ in tracks))
        r, z = np.hypot(track[:, 0] - axis[0], track[:, 1] - axis[1]), track[:, 2]
        axes.plot(scale * r, scale * z, color=color, linewidth=0.8)
        axes.plot(scale * r[:1], scale * z[:1], "o", color=color, markersize=3)
    furthest = max(np.hypot(*(track[:, :2] - axis).T).max() for _, _, track in tracks)
    axes.set(xlim=(0, scale * max(1.04 * reach, 1.02 * furthest)), ylim=scale * np.array([box.lower[2], box.upper[2]]))
    axes.grid(color=GRID_COLOR, linewidth=0.6)
    add_group_legend(axes, results.groups, sorted({group for group, _, _ in tracks}), loc="lower center",
                     bbox_to_anchor=(0.5, 1))
    return figure
