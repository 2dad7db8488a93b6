# SPDX-License-Identifier: BSD-3-Clause
"""What the playback shows: cloths, bodies and flow of the frames."""

import numpy as np

from washfsi.report.flow import flow_of
from washfsi.report.scene import Subject, scene_of
from washfsi.report.solids import solids_of

COLOURS = {"stress": "stress", "water_shear": "shear of the water", "relative_speed": "speed of the water along it",
           "stretch": "stretch", "shear_angle": "shear angle"}  # by which cloths are coloured, where they are known
NOISE = {"Pa": 1e-3}  # a limit below this is that of rounding, as at the start
PERCENTILE = 98.0  # where colours saturate
MOST_FRAMES = 600


def chosen_frames(results, room):
    """Returns the numbers of the frames: those that all series have, as many as there is room for in bytes."""
    series = [one for one in (results.flow, results.cloth, results.bodies, results.surfaces) if one]
    count = min(map(len, series))
    markers = len(results.cloth.group) if results.cloth else 0
    fit = max(2, int(room // max(markers * (6 + 2 * len(COLOURS)), 1)))
    apart = -(-count // min(fit, MOST_FRAMES))
    numbers = list(range(0, count, apart))
    return numbers if numbers[-1] == count - 1 else [*numbers, count - 1]


def cloth_lines(cloth, dim):
    """Returns the markers of the cells: four each in space; in the plane each line's, behind its length."""
    if dim == 3:
        return np.array(cloth.lines, np.uint32).reshape(-1, 4)
    return np.concatenate([[len(line), *line] for line in cloth.lines]).astype(np.uint32)


def packed_colours(data, units, pack):
    """Returns the quantities by which cloths are coloured, each with the limit of its colours."""
    made = []
    for name, title in COLOURS.items():
        if name in data[0].data:
            values = np.nan_to_num([frame[name] for frame in data])
            high = float(np.percentile(np.abs(values), PERCENTILE))
            high = high if high > NOISE.get(units[name], 0.0) else 1.0
            made.append({"name": name, "title": title, "unit": units[name], "limit": high,
                         "values": pack.add_scaled(values, 0.0, max(float(values.max()), high))})
    return made


def cloths_of(results, frames, pack, subject):
    """Returns the cloths for the page, None without: places by frame, marker and axis; they are a part of the subject."""
    cloth = results.cloth
    if not cloth:
        return None
    data = [cloth.frame(number) for number in frames]
    positions = np.array([frame["position"] for frame in data])
    for places in positions:
        subject.add(places)
    lower, upper = positions.min(), positions.max()
    return {"group": pack.add(cloth.group, "u2"), "cloth": pack.add(cloth.cloth, "u2"),
            "lines": pack.add(cloth_lines(cloth, results.flow.dim), "u4"), "markers": len(cloth.group),
            "positions": pack.add_scaled(positions, lower, upper), "colours": packed_colours(data, data[0].units, pack)}


def playback_of(results, pack, room):
    """Returns the playback of a run; `room` is in bytes, half of it for the flow."""
    frames = chosen_frames(results, room / 2)
    flow, subject = results.flow, Subject()
    solids, cloths = solids_of(results, frames, pack, subject), cloths_of(results, frames, pack, subject)
    enclosed = any(solid["surrounds"] for solid in solids)
    return {"dim": flow.dim, "lower": list(map(float, flow.lower)), "upper": list(map(float, flow.upper)),
            "times": [float(flow.times[number]) for number in frames], "every": len(flow), "groups": results.groups,
            "scene": scene_of(results, subject, enclosed, pack), "solids": solids, "cloths": cloths,
            "flow": flow_of(results, frames, pack, room / 2)}
