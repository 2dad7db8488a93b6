# SPDX-License-Identifier: BSD-3-Clause
"""Plates that flutter down in water (thesis 3.5.3): the tank test's half period, and Andersen et al.'s fluttering case.

Prints the table of docs/verification/falling_plate.md. Arguments: case:cells ..., by default tank:512 andersen:256. A
half period is the time between the extreme positions of the plate's centre. Fails when the mean of the first two is out
of range, when the plate bends or tumbles, or when Andersen's plate has a vertical speed without twice the frequency of
the horizontal.
"""

import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tables import ARGUMENTS, SOURCE, command, print_record, print_record_head, read_columns, read_markers, scientific

RANKS = 2
LEAST_WAY = 0.1  # lengths: a shorter way back is no turn
MOST_BENT = 1e-3  # lengths
MOST_INCLINED = 90  # [degrees]
RATIO = (1.5, 2.5)  # frequency of the vertical speed over that of the horizontal one
STEPS = {256: 5e-4, 512: 3e-4, 1024: 3e-4}  # [s] in the tank


class Case(NamedTuple):
    """Options beside those of inputs/falling_plate.opts, and the range of the half period [s]."""
    box: float  # [m]
    length: float  # [m]
    pace: float  # steps over those in the tank
    half_period: tuple
    options: tuple = ()


CASES = {
    "tank": Case(0.20313, 0.0183, 1, (0.28, 0.40)),
    "andersen": Case(0.06248, 0.0071, 0.5, (0.15, 0.21), (
        "-grid_lower", "-0.03124,0", "-grid_upper", "0.03124,0.06248", "-fluid_viscosity", 8e-4, "-plate_size", 0.0071,
        "-plate_center", "-0.005,0.055", "-plate_excess_mass", 0.8585, "-plate_thickness", 5.05e-4, "-plate_kb", 1e-3,
        "-time_end", 0.7, "-output_interval", 0.02)),
}


def fall(case, cells):
    """Runs a case, markers as far apart as cells are wide; returns the history, and the markers frame by frame."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        markers = round(case.length / case.box * cells)
        subprocess.run(command(RANKS, "-options_file", SOURCE / "inputs" / "falling_plate.opts", *case.options,
                               "-grid_cells", f"{cells},{cells}", "-plate_markers", markers, "-time_step",
                               case.pace * STEPS[cells], "-output_dir", folder), check=True,
                       stdout=subprocess.DEVNULL)
        return read_columns(Path(folder) / "history.csv"), read_markers(folder)[1]


def turns(values, least):
    """Indices of the extremes, a highest one first, from each of which the values then go back by more than least."""
    found, best, sign = [], 0, 1
    for k, value in enumerate(values):
        if sign * (value - values[best]) > 0:
            best = k
        elif sign * (values[best] - value) > least:
            found.append(best)
            best, sign = k, -sign
    return found


def frequency_ratio(history, found):
    """Frequency of the vertical speed over that of the horizontal one, from the first turn on."""
    time, rate = history["time"][found[0]:], np.gradient(history["plate_center_y"], history["time"])[found[0]:]
    swings = turns(rate, 0.25 * np.ptp(rate))
    return np.diff(history["time"][found]).mean() / np.diff(time[swings]).mean() if len(swings) > 1 else 0.0


def most_bent(places):
    """Largest distance of a marker from a straight line through all of its plate, in any frame, over the length."""
    length = np.linalg.norm(places[0, -1] - places[0, 0])
    straight = [place - place.mean(axis=0) for place in places]
    return max(np.abs(place @ np.linalg.svd(place, full_matrices=False)[2][1]).max() for place in straight) / length


def most_inclined(places):
    """Largest angle to the horizontal [degrees]; above 90 the plate has tumbled."""
    way = places[:, -1] - places[:, 0]
    return np.degrees(np.abs(np.unwrap(np.arctan2(way[:, 1], way[:, 0])))).max()


def main():
    cases, passed = [word.split(":") for word in ARGUMENTS] or [("tank", 512), ("andersen", 256)], True
    print_record_head("case", "cells", "h/l", "step [s]", "first turn [s]", "half periods [s]", "mean of two [s]",
                      "descent [m/s]", "largest angle", "frequency of Vy over that of Vx", "bent/l", "mean slip")
    for name, cells in cases:
        case, cells = CASES[name], int(cells)
        history, places = fall(case, cells)
        found = turns(history["plate_center_x"], LEAST_WAY * case.length)
        halves = np.diff(history["time"][found])
        words = [name, f"{cells} x {cells}", f"{case.box / cells / case.length:.4f}", f"{history['dt'][0]:.3g}",
                 ", ".join(f"{turn:.3f}" for turn in history["time"][found[:1]]),
                 ", ".join([*(f"{half:.3f}" for half in halves), *["then none"] * (len(halves) < 2)])]
        if len(halves) < 2:
            print_record(*words, *[""] * 6, arguments=[f"{name}:{cells}"])
            passed = False
            continue
        descent = -np.diff(history["plate_center_y"][found[::len(found) - 1]])[0] / halves.sum()
        ratio, bent, angle = frequency_ratio(history, found), most_bent(places), most_inclined(places)
        print_record(*words, f"{halves[:2].mean():.3f}", f"{descent:.3f}", f"{angle:.0f}", f"{ratio:.1f}",
                     scientific(bent, 1), f"{100 * history['cloth_slip'].mean():.1f} %", arguments=[f"{name}:{cells}"])
        passed &= bool(case.half_period[0] <= halves[:2].mean() <= case.half_period[1])
        passed &= bool(bent <= MOST_BENT and angle <= MOST_INCLINED)
        passed &= bool(name == "tank" or RATIO[0] <= ratio <= RATIO[1])
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
