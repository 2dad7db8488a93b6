# SPDX-License-Identifier: BSD-3-Clause
"""Draws what the thesis has pictures of, from the runs of its tables: docs/images/thesis_*.png.

    scripts/verification --resume thesis_pictures [plate] [tracks] [wash2d]      runs what has not been run

plate: the falling plate's places and its velocities over its angle (Figs. 3.5-6 to 3.5-8). tracks: the cloths' centres in the
plane of radius and height (Figs. 5.5-8 to 12, 18 to 23). wash2d: cloths with sharp and smooth mask, soft and stiff (Figs. 5.4-3
and 5.4-4).
"""

import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

from tables import ARGUMENTS, SOURCE, read_columns, read_markers  # noqa: E402
from thesis import falling_plate, wash, wash2d  # noqa: E402
from thesis.rows import NUMERICS, THEIRS, TODAY  # noqa: E402

IMAGES = SOURCE / "docs" / "images"
NAMES = {THEIRS: "the thesis's numerics", TODAY: "today's numerics"}
ORBITS = {"re1.2e2": 2, "re1.2e3": 2, "re1.2e4": 2, "re1.2e5": 2, "re1.2e6": 2}
OTHERS = {"cloths64": 1, "width1.5": 1, "ratio1to1": 3, "ratio1to2": 3, "dt": 2.9, "smooth": 2.9}


def save(figure, name):
    """Writes a picture."""
    figure.tight_layout()
    figure.savefig(IMAGES / f"thesis_{name}.png", dpi=110)
    plt.close(figure)


def draw_fall(axes, numerics, name, spacing):
    """The plate at equal times, and both velocities of its centre over its angle."""
    folder, length = falling_plate.fall(numerics, name, spacing), falling_plate.LENGTH[name]
    time, places = read_markers(folder)
    for place in places:
        axes[0].plot(*(place / length).T, color="tab:blue", linewidth=1)
    axes[0].set(aspect="equal", xlabel="x / l", ylabel="y / l", title=f"{name.replace('_', ' ')}, {NAMES[numerics]}")
    way = places[:, -1] - places[:, 0]
    angle = np.degrees(np.unwrap(np.arctan2(way[:, 1], way[:, 0])))
    velocity = np.gradient(places.mean(axis=1), time, axis=0)
    for panel, values, label in zip(axes[1:], (velocity[:, 0], -velocity[:, 1]), ("Vx [m/s]", "-Vy [m/s]")):
        panel.plot(angle, values)
        panel.set(xlabel="angle to the horizontal [degrees]", ylabel=label)


def plate():
    """Figs. 3.5-6 to 3.5-8."""
    for name, spacing in (("falling_plate", "0.0216"), ("andersen", "0.0172")):
        figure, panels = plt.subplots(2, 3, figsize=(11, 9))
        for axes, numerics in zip(panels, NUMERICS):
            draw_fall(axes, numerics, name, spacing)
        save(figure, name)


def draw_tracks(axes, numerics, name, cycles):
    """The common centre on the left, each cloth's on the right."""
    tracks = wash.plane_tracks(numerics, name, cycles)
    axes[0].plot(*tracks.mean(axis=0), color="black", linewidth=1)
    for track in tracks:
        axes[1].plot(*track, linewidth=0.6)
    for panel in axes:
        panel.set(xlim=(0, 1), ylim=(0, 0.8), aspect="equal", xlabel="r / r_o", ylabel="z / r_o")
        panel.set_title(f"{wash.CASE_NAMES[name]}, {NAMES[numerics]}", fontsize=8)


def tracks():
    """Figs. 5.5-8 to 5.5-12, and 5.5-18 to 5.5-23; the smooth mask with the thesis's numerics alone."""
    for picture, runs in (("orbits", ORBITS), ("orbits_of_variants", OTHERS)):
        figure, panels = plt.subplots(len(runs), 4, figsize=(13, 2.9 * len(runs)))
        for axes, (name, cycles) in zip(panels, runs.items()):
            draw_tracks(axes[:2], THEIRS, name, cycles)
            if name != "smooth":
                draw_tracks(axes[2:], TODAY, name, cycles)
        save(figure, picture)


def draw_cloths(axes, numerics, options):
    """The cloths at four quarters of an agitation cycle."""
    step = {THEIRS: wash2d.LONGEST, TODAY: 3.5e-4}[numerics]
    time, places = read_markers(wash2d.folder(numerics, 128, step, *options))
    for panel, quarter in zip(axes, (2, 3, 4, 5)):
        frame = places[np.argmin(np.abs(time - quarter * 0.25 * wash2d.CYCLE))]
        begin = 0
        for markers in [2 * number for number in wash2d.MARKERS.values() for _ in range(10)]:
            panel.plot(*frame[begin:begin + markers].T, linewidth=0.8)
            begin += markers
        panel.set(aspect="equal", xlim=(-0.33, 0.33), ylim=(-0.33, 0.33), xticks=[], yticks=[])
        panel.set_title(f"{quarter} quarters of a cycle", fontsize=8)


def cloths():
    """Figs. 5.4-3 and 5.4-4."""
    for picture, variants in (("mask", {"sharp": ("-body_mask", "sharp"), "smooth": ("-body_mask", "smooth")}),
                              ("stiffness", {"soft": ("-long_kb", 1e-5, "-short_kb", 1e-5), "stiff": ("-long_kb", 1e-2, "-short_kb", 1e-2)})):
        figure, panels = plt.subplots(4, 4, figsize=(12, 12))
        lines = [(numerics, options) for options in variants.values() for numerics in NUMERICS]
        for axes, (numerics, options), label in zip(panels, lines, [f"{name}, {NAMES[numerics]}" for name in variants
                                                                    for numerics in NUMERICS]):
            draw_cloths(axes, numerics, options)
            axes[0].set_ylabel(label)
        save(figure, f"wash2d_{picture}")


def main():
    drawings = {"plate": plate, "tracks": tracks, "wash2d": cloths}
    for name in ARGUMENTS or drawings:
        drawings[name]()
    return 0


if __name__ == "__main__":
    sys.exit(main())
