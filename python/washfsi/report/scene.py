# SPDX-License-Identifier: BSD-3-Clause
"""What the view of the playback has to show: the cloths and bodies of all frames, and the flow round them in open water."""

import itertools

import numpy as np

DIRECTIONS = 200  # in which farthest points are looked for: a sphere loses 1 % of its radius
AROUND = 0.5  # of the subject's size, the water to see at each of its sides
WAKE = 5.0  # of the subject's size, the water to see downstream of it
STREAM = 0.5  # of the root mean square of the velocity: a mean velocity above this is a stream


def directions():
    """Returns unit vectors to all sides, evenly spread (a Fibonacci lattice), and those along the axes."""
    number = np.arange(DIRECTIONS)
    height = 1 - (2 * number + 1) / DIRECTIONS
    angle = number * np.pi * (3 - np.sqrt(5))
    radius = np.sqrt(1 - height**2)
    return np.vstack([np.eye(3), -np.eye(3), np.column_stack([radius * np.cos(angle), radius * np.sin(angle), height])])


class Subject:
    """The cloths and bodies of a run, by those of their points that lie farthest out: a view that shows these shows them all."""

    def __init__(self):
        self._directions = directions()
        self.points = np.empty((0, 3))

    def add(self, points):
        """Adds points of cloths or bodies; those of a run that has diverged may be no numbers and are left out."""
        every = np.vstack([self.points, points[np.isfinite(points).all(axis=1)]])
        if not len(every):
            return
        self.points = every[np.unique(np.argmax(every @ self._directions.T, axis=0))]

    def add_moving(self, points, motion):
        """Adds points of a rigid body in all frames; `motion` has twelve numbers each: rotation by rows, displacement."""
        body = Subject()
        body.add(points)
        rotations = motion[:, :9].reshape(-1, 3, 3)
        self.add((body.points @ rotations.transpose(0, 2, 1) + motion[:, np.newaxis, 9:]).reshape(-1, 3))


def stream_of(velocity):
    """Returns the direction of the stream that passes through the box, zero where there is none."""
    velocity = velocity.reshape(-1, velocity.shape[-1])
    mean = velocity.mean(axis=0)
    speed = np.linalg.norm(mean)
    return mean / speed if speed > STREAM * np.sqrt((velocity**2).sum(axis=1).mean()) else np.zeros_like(mean)


def surroundings(lower, upper, stream):
    """Returns the corners of a subject's box, moved outwards to hold the water round it and its wake."""
    size = np.max(upper - lower)
    wake = WAKE * size * stream
    return lower - AROUND * size + np.minimum(wake, 0), upper + AROUND * size + np.maximum(wake, 0)


def scene_of(results, subject, enclosed, pack):
    """Returns the scene for the page: the farthest points of the subject, without one the corners of the box; the box that a view
    is about; and whether that box is open water, which no body encloses."""
    flow = results.flow
    box = np.array([flow.lower, flow.upper])
    space = np.pad(box, ((0, 0), (0, 3 - flow.dim)))
    found = len(subject.points) > 0
    points = np.clip(subject.points, *space) if found else np.array(list(itertools.product(*space.T)))
    about = np.array([points.min(axis=0), points.max(axis=0)])
    open_water = found and not enclosed and results.options.get("fluid") != "none"
    if open_water:
        about = np.clip(surroundings(*about, stream_of(flow.frame(len(flow) - 1)["velocity"])), *space)
    lower, upper = about[:, :flow.dim].tolist()
    return {"points": pack.add(points), "lower": lower, "upper": upper, "open": open_water}
