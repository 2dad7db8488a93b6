# SPDX-License-Identifier: BSD-3-Clause
"""The bodies of the playback: their surfaces once, and the rigid motion of each in every frame."""

import numpy as np

from washfsi.paraview_view.command import bodies_of

MOST_FACETS = 24000  # of a body's surface
COARSER = 1.3  # factor of the patches' size from try to try
ANYWHERE = np.array([0.8, 0.36, 0.48])


def faces_away(vertices, facets):
    """Returns for each vertex whether the surface there faces away from a place far off, in no direction that bodies have; in the
    plane never."""
    if facets.shape[1] == 2:
        return np.zeros(len(vertices), dtype=bool)
    corners = vertices[facets]
    normals = np.zeros_like(vertices)
    for corner in facets.T:
        np.add.at(normals, corner, np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    return normals @ ANYWHERE < 0


def coarse(vertices, facets, away, size):
    """Returns a surface whose vertices within each box of a size are one, in their middle, if they face the same way (`away`): the
    two faces of what is thin stay apart. Facets that have shrunk are left out."""
    boxes = np.floor((vertices - vertices.min(axis=0)) / size).astype(np.int64)
    _, which = np.unique(np.column_stack([boxes, away]), axis=0, return_inverse=True)
    which = which.ravel()
    counts = np.bincount(which)
    merged = np.column_stack([np.bincount(which, column) / counts for column in vertices.T])
    joined = which[facets]
    whole = (joined != np.roll(joined, 1, axis=1)).all(axis=1)
    return merged, joined[whole]


def light_surface(vertices, facets, most=MOST_FACETS):
    """Returns a surface of at most so many facets."""
    if len(facets) <= most:
        return vertices, facets
    away = faces_away(vertices, facets)
    size = float(np.median(np.linalg.norm(vertices[facets[:, 0]] - vertices[facets[:, 1]], axis=1)))
    light = coarse(vertices, facets, away, size)
    while len(light[1]) > most:
        size *= COARSER
        light = coarse(vertices, facets, away, size)
    return light


def rigid_motion(start, now):
    """Returns rotation and displacement that bring points nearest to where they are now (Kabsch): now = R start + d."""
    middle, there = start.mean(axis=0), now.mean(axis=0)
    left, _, right = np.linalg.svd((now - there).T @ (start - middle))
    sign = np.diag([1.0, 1.0, np.sign(np.linalg.det(left @ right))])
    rotation = left @ sign @ right
    return rotation, there - rotation @ middle


def motion_rows(positions, dim):
    """Returns the motions of all frames, twelve numbers each: rotation by rows, displacement. `positions` are of one
    body's vertices, a frame each. In the plane the turn about z follows from points in it."""
    start = positions[0]
    rows = []
    for now in positions:
        if dim == 2:  # out of the plane too, or the turn would not be known
            lift = np.array([0.0, 0.0, np.ptp(start)])
            rotation, moved = rigid_motion(np.vstack([start, start + lift]), np.vstack([now, now + lift]))
        else:
            rotation, moved = rigid_motion(start, now)
        rows.append(np.concatenate([rotation.ravel(), moved]))
    return np.array(rows)


def compact(vertices, facets):
    """Returns the vertices that facets use, and the facets by their new numbers."""
    used, numbers = np.unique(facets, return_inverse=True)
    return vertices[used], numbers.reshape(facets.shape)


def solids_of(results, frames, pack, subject):
    """Returns the bodies for the page; `frames` are the numbers of the frames in the playback. Bodies are a part of the subject."""
    surfaces = results.surfaces
    if not surfaces:
        return []
    positions = [surfaces.frame(number)["position"] for number in frames]
    solids = []
    for body in bodies_of(results):
        facets = surfaces.facets_of(body["name"]) if body["name"] in surfaces.bodies else np.empty((0, 3), int)
        if not len(facets):
            continue
        mine = surfaces.body == body["number"]
        vertices, light = light_surface(*compact(positions[0], facets))
        motion = motion_rows([frame[mine] for frame in positions], results.flow.dim)
        subject.add_moving(vertices, motion)
        solids.append({"name": body["name"], "surrounds": body["surrounds"], "corners": int(facets.shape[1]),
                       "vertices": pack.add(vertices), "facets": pack.add(light, "u4"),
                       "motion": pack.add(motion)})
    return solids
