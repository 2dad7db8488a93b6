# SPDX-License-Identifier: BSD-3-Clause
"""The cloths' centres in the plane of radius and height, and what the bodies sweep there, for the page."""

import numpy as np

from washfsi.plot.tracks import drum_radius, machine_axis, read_tracks, turned_round
from washfsi.report.drawing import rings

MOST_PLACES = 400  # of a track
RADII = 120


def swept_rings(results, axis, reach):
    """Returns the outlines of what the bodies sweep when they turn, as lines of radius and height [m]."""
    radii, lines = np.linspace(0, reach, RADII), []
    x, y, z = results.bodies.centres()
    for distance in results.bodies.frame(0).data.values():
        swept = turned_round(distance, (x, y), axis, radii)
        if swept.min() < 0 < swept.max():
            lines += rings(swept, [radii, z])
    return [np.maximum(line, [0, results.flow.lower[2]]).round(5).tolist() for line in lines]


def tracks_of(results, pack):
    """Returns the tracks of a run in space, None without."""
    if not (results.folder / "tracks.csv").is_file() or results.flow.dim != 3:
        return None
    tracks, flow = read_tracks(results), results.flow
    if not tracks or not results.tracks.rows:
        return None
    axis = machine_axis(results)
    furthest = max(np.hypot(*(track[:, :2] - axis).T).max() for _, _, track in tracks)
    reach = max(1.04 * (drum_radius(results.options) or 0), 1.02 * furthest)
    rows = np.unique(np.linspace(0, results.tracks.rows - 1, MOST_PLACES).astype(int))
    places = [{"group": group, "name": f"{results.groups[group]} {number}",
               "radius": pack.add(np.hypot(track[rows, 0] - axis[0], track[rows, 1] - axis[1])),
               "height": pack.add(track[rows, 2])} for group, number, track in tracks]
    return {"time": pack.add(results.tracks["time"][rows]), "tracks": places, "reach": reach,
            "lower": float(flow.lower[2]), "upper": float(flow.upper[2]),
            "swept": swept_rings(results, axis, reach) if results.bodies else []}
