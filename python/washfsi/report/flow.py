# SPDX-License-Identifier: BSD-3-Clause
"""The flow of the playback: speed and pressure, in the plane vorticity too, in cells as fine as there is room for."""

import numpy as np

REACH = 1.5  # cells from a wall up to which the distance from it is told
LOW, HIGH = 0.5, 99.5  # percentiles at which colours saturate


def speed(frame):
    """Returns the speed [m/s]."""
    return np.linalg.norm(frame["velocity"], axis=-1)


FIELDS = {"speed": ("speed", "m/s", speed, False),
          "pressure": ("pressure", "Pa", lambda frame: frame["pressure"], True),
          "vorticity": ("vorticity", "1/s", lambda frame: frame["vorticity"], True)}


def fields_of(dim):
    """Returns the names of the fields: in the plane vorticity first; in space it has three components."""
    return ["vorticity", "speed", "pressure"] if dim == 2 else ["speed", "pressure"]


def taken(cells, coarser):
    """Returns the numbers of the cells along each axis that are taken, x first: those in the middle of each lot, one at least."""
    return [np.arange(min(coarser, count) // 2, count, coarser) for count in cells]


def thinned(cells, frames, fields, room):
    """Returns every how many cells and frames are taken for all to fit into some bytes: cells are spared first while
    there are many, at least 24 along each axis, then frames down to one, then cells again."""
    coarser, apart = 1, 1
    while np.prod([len(line) for line in taken(cells, coarser)]) * -(-frames // apart) * fields > room:
        if min(cells) // (coarser + 1) >= 24 or apart >= frames:
            coarser += 1
        else:
            apart += 1
        if coarser > max(cells):
            break
    return coarser, apart


def limits(samples, solid, signed):
    """Returns where the colours saturate: percentiles in the water; of a signed field alike to both sides of zero."""
    values = samples[~solid & np.isfinite(samples)]
    if not values.size:
        return 0.0, 1.0
    low, high = np.percentile(values, [LOW, HIGH])
    if not signed:
        return 0.0, float(high) or 1.0
    reach = max(abs(low), abs(high)) or 1.0
    return -float(reach), float(reach)


def flow_of(results, frames, pack, room):
    """Returns the flow for the page, None without: each field by frame, z, y, x. `frames` are the playback's, `room` is
    in bytes."""
    if results.options.get("fluid") == "none":
        return None
    flow = results.flow
    names = fields_of(flow.dim)
    coarser, apart = thinned(flow.cells, len(frames), len(names) + 1, room)
    lines = taken(flow.cells, coarser)
    pick = np.ix_(*lines[::-1])
    chosen = frames[::apart]
    distance = np.array([water_distance(results, number, pick) for number in chosen])
    data = [flow.frame(number) for number in chosen]
    made = [packed_field(np.array([FIELDS[name][2](frame)[pick] for frame in data]), distance < 0, name, pack)
            for name in names]
    reach = REACH * coarser * float(flow.spacing.max())
    return {"cells": [len(line) for line in lines], "spacing": [float(step * coarser) for step in flow.spacing],
            "first": [float(low + step * (line[0] + 0.5)) for low, step, line in zip(flow.lower, flow.spacing, lines)],
            "apart": apart, "coarser": coarser, "frames": len(chosen), "fields": made,
            "distance": pack.add_scaled(distance, -reach, reach, "u1")}


def water_distance(results, number, pick):
    """Returns the distance from the nearest body [m], negative in it, in the cells taken."""
    least = np.full(np.broadcast_shapes(*(line.shape for line in pick)), np.inf)
    for distance in results.bodies.frame(number).data.values() if results.bodies else ():
        least = np.minimum(least, distance[pick])
    return least


def packed_field(samples, solid, name, pack):
    """Returns one field for the page; pressure is taken from its mean in the water, as it is known up to a constant."""
    title, unit, _, signed = FIELDS[name]
    if name == "pressure":
        means = [frame[~mask].mean() if (~mask).any() else 0.0 for frame, mask in zip(samples, solid)]
        samples = samples - np.reshape(means, (-1, *[1] * (samples.ndim - 1)))
    low, high = limits(samples, solid, signed)
    return {"name": name, "title": title, "unit": unit, "signed": signed, "low": low, "high": high,
            "values": pack.add_scaled(samples, low, high, "u1")}
