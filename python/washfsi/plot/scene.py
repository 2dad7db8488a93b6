# SPDX-License-Identifier: BSD-3-Clause
"""What is in one frame of a run: flow, bodies, cloths."""

from dataclasses import dataclass

import numpy as np

from washfsi.errors import ResultsError

PERCENTILE = 98.0  # of |vorticity| in the fluid, where the colours saturate


@dataclass
class Scene:
    """One frame. Fields have x last."""

    title: str
    names: list  # of the groups of cloths
    lower: np.ndarray  # corners of the box [m]
    upper: np.ndarray
    vorticity: np.ndarray  # about z, in the middle plane in 3D [1/s]
    bodies: list  # signed distances in all cells [m]
    positions: np.ndarray  # of markers [m]
    group: np.ndarray  # of each marker
    lines: list  # markers of each polyline or quadrilateral

    @property
    def dim(self):
        """Returns the number of dimensions."""
        return len(self.lower)

    @property
    def groups(self):
        """Returns the numbers of the groups that there are."""
        return np.unique(self.group)

    def planes(self):
        """Returns the signed distances in the middle plane."""
        return [middle_plane(body, self.dim) for body in self.bodies]


def middle_plane(field, dim):
    """Returns a field of cells as rows along x: itself in 2D, its slice half way up z in 3D."""
    return field if dim == 2 else field[field.shape[0] // 2]


def read_scene(results, number):
    """Returns the scene of a frame of a run."""
    flow = results.flow
    frame = flow.frame(number)
    vorticity = middle_plane(frame["vorticity"], flow.dim)
    bodies = list(results.bodies.frame(number).data.values()) if results.bodies else []
    cloth = results.cloth
    positions = cloth.frame(number)["position"] if cloth else np.empty((0, 3))
    group, lines = (cloth.group, cloth.lines) if cloth else (np.empty(0, int), [])
    return Scene(f"{results.case}, t = {frame.time:.4f} s", results.groups, flow.lower, flow.upper,
                 vorticity if flow.dim == 2 else vorticity[..., 2], bodies, positions, group, lines)


def vorticity_limit(scene):
    """Returns where the colours saturate [1/s]: a percentile in the fluid, to two digits."""
    fluid = np.isfinite(scene.vorticity)
    for distance in scene.planes():
        fluid &= distance > 0
    limit = np.percentile(np.abs(scene.vorticity[fluid]), PERCENTILE) if fluid.any() else 0.0
    return float(f"{limit:.1e}") or 1.0


def choose_frames(times, options):
    """Returns the numbers of the frames to draw, of those at `times` [s]."""
    if options.all:
        return list(range(len(times)))
    if options.time is not None:
        margin = 0.5 * (times[-1] - times[0]) / max(len(times) - 1, 1) + 1e-9
        if not times[0] - margin <= options.time <= times[-1] + margin:
            raise ResultsError(f"no frame at {options.time:g} s; they run from {times[0]:g} to {times[-1]:g} s")
        return [int(np.argmin(np.abs(times - options.time)))]
    number = len(times) - 1 if options.frame is None else options.frame
    if not 0 <= number < len(times):
        raise ResultsError(f"no frame {number}; they run from 0 to {len(times) - 1}")
    return [number]
