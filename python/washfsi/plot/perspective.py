# SPDX-License-Identifier: BSD-3-Clause
"""A frame in space: cloths, bodies, the box."""

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from washfsi.plot.style import OUTLINE_COLOR, SOLID_COLOR, WIDTH, add_group_legend, even_size, group_color, wrapped

VIEW = (28, -60)  # elevation, azimuth [degrees]
LIGHT = np.array([0.3, -0.5, 0.81])  # where it comes from
SHADOW = 0.72  # of the colour, where no light falls
FINEST = 80  # faces of a body along an axis


def centres(scene):
    """Returns the centres of the cells along x, y, z [m]."""
    counts = scene.bodies[0].shape[::-1]
    return [low + (high - low) * (np.arange(n) + 0.5) / n for low, high, n in zip(scene.lower, scene.upper, counts)]


def top_of(distance, z):
    """Returns the height of a body's top over each column of cells [m], nan where there is none."""
    inside = distance < 0
    topmost = len(z) - 1 - np.argmax(inside[::-1], axis=0)
    above = np.minimum(topmost + 1, len(z) - 1)
    rows, columns = np.indices(topmost.shape)
    here, there = distance[topmost, rows, columns], distance[above, rows, columns]
    share = np.where(there > here, here / np.where(there > here, here - there, 1), 0)
    return np.where(inside.any(axis=0), z[topmost] + (z[above] - z[topmost]) * share, np.nan)


def faces_of(scene, distance):
    """Returns the faces of a body's top, as seen from above."""
    x, y, z = centres(scene)
    step = max(1, -(-max(len(x), len(y)) // FINEST))
    x, y, top = x[::step], y[::step], top_of(distance, z)[::step, ::step]
    points = np.dstack([*np.meshgrid(x, y), top])
    faces = np.stack([points[:-1, :-1], points[:-1, 1:], points[1:, 1:], points[1:, :-1]], axis=2).reshape(-1, 4, 3)
    return faces[np.isfinite(faces).all(axis=(1, 2))]


def shaded(faces, color):
    """Returns the colour of each face in the light."""
    normals = np.cross(faces[:, 2] - faces[:, 0], faces[:, 3] - faces[:, 1])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    light = np.abs(normals / np.where(lengths > 0, lengths, 1) @ LIGHT)
    return np.outer(SHADOW + (1 - SHADOW) * light, to_rgb(color))


def surrounds(distance):
    """Returns whether a body fills the corners of the box, as a drum does."""
    return distance[distance.shape[0] // 2, 0, 0] < 0


def draw_faces(axes, scene):
    """Draws cloths and bodies as one collection, so that what is in front hides what is behind."""
    faces, colors = [np.empty((0, 4, 3))], [np.empty((0, 3))]
    for distance in (body for body in scene.bodies if not surrounds(body)):
        faces.append(faces_of(scene, distance))
        colors.append(shaded(faces[-1], SOLID_COLOR))
    for group in scene.groups:
        quads = [scene.positions[line] for line in scene.lines if scene.group[line[0]] == group and len(line) == 4]
        faces.append(np.reshape(quads, (-1, 4, 3)))
        colors.append(shaded(faces[-1], group_color(group)))
    if sum(map(len, faces)):
        axes.add_collection3d(Poly3DCollection(np.concatenate(faces), facecolors=np.concatenate(colors),
                                               edgecolors=0.6 * np.concatenate(colors), linewidths=0.3))


def draw_outlines(axes, scene):
    """Draws the outlines of bodies that surround the water, on the floor and at the top."""
    for distance in filter(surrounds, scene.bodies):
        x, y, _ = centres(scene)
        for height in (scene.lower[2], scene.upper[2]):
            axes.contour(x, y, distance[distance.shape[0] // 2], levels=[0], offset=height, zdir="z",
                         colors=[OUTLINE_COLOR], linewidths=1)


def draw_perspective(scene):
    """Returns the picture of one frame in perspective."""
    figure = Figure(figsize=even_size(WIDTH, 0.72 * WIDTH))
    figure.suptitle(wrapped(scene.title), y=0.97)
    axes = figure.add_axes([0.02, -0.02, 0.84, 0.94], projection="3d")
    draw_outlines(axes, scene)
    draw_faces(axes, scene)
    lower, upper = scene.lower, scene.upper
    axes.set(xlim=(lower[0], upper[0]), ylim=(lower[1], upper[1]), zlim=(lower[2], upper[2]), xlabel="x [m]",
             ylabel="y [m]", zlabel="z [m]")
    axes.set_box_aspect(upper - lower, zoom=1.22)
    axes.locator_params(nbins=4)
    axes.locator_params(axis="z", nbins=3)
    axes.view_init(*VIEW)
    add_group_legend(figure, scene.names, scene.groups, loc="upper center", bbox_to_anchor=(0.5, 0.935))
    return figure
