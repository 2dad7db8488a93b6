# SPDX-License-Identifier: BSD-3-Clause
"""The thesis's runs of section 5.5 beside its tables: stresses, tumbling, orbits and the drum's torque over the Reynolds
number and the load.

Reads what `scripts/study inputs/thesis/*.opts` has left in out/study, or in the folder given, and prints the tables of
docs/verification/wash.md; runs not made, or too short, are listed as such. Stresses are averages over all markers and
the first cycles: two (`--cycles`) over the Reynolds number, five (`--load-cycles`) over the load. Fails where a run
that is there breaks one of the thesis's trends, or that of the torque on the drum, which falls with the Reynolds number
(Akcabay, Dowling and Schultz, Clothes washing simulations, Computers & Fluids, 2014).
"""

import argparse
import sys
from pathlib import Path

import numpy as np

from tables import ARGUMENTS, SOURCE, print_record, print_record_head, read_columns
from wash_runs import CYCLE, STRESSES, read_centers

RADIUS = 0.31  # of the drum [m]
INNER, OUTER = 0.45, 0.65  # of the drum's radius: where cloths are to sink, and to rise
# Tables 5.5-9 .. 11 and 5.5-12 .. 14: averages of ss, rr and sr [MPa]
BY_REYNOLDS = {"re1.2e2": (0.077, 0.062, 0.0270), "re1.2e3": (0.096, 0.103, 0.0197), "re1.2e4": (0.699, 0.748, 0.0441),
               "re1.2e5": (1.119, 1.608, 0.0525), "re1.2e6": (1.308, 1.294, 0.0697)}
BY_LOAD = {"re1.2e3": (0.119, 0.127, 0.023), "cloths32": (0.143, 0.131, 0.027), "cloths64": (0.163, 0.170, 0.028)}


class Run:
    """The first cycles of a run, or nothing if they have not been run."""

    def __init__(self, folder, cycles):
        self.there = (folder / "history.csv").is_file()
        if not self.there:
            return
        history = read_columns(folder / "history.csv")
        until = within(history["time"], cycles)
        self.there = history["time"][-1] >= cycles * CYCLE - 1e-2
        if not self.there:
            return
        self.stresses, self.bending = (
            [1e-6 * np.average(history[f"towel_{part}stress_{stress}_mean"][until], weights=history["dt"][until])
             for stress in STRESSES] for part in ("", "bending_"))
        self.tumbles = history["towel_tumbles"][until][-1]
        self.crossings = history["cloth_crossings"][until][-1]
        self.stretch = history["towel_max_stretch"][until].max()
        self.drum_torque = np.sqrt(np.average(history["drum_torque_z"][until] ** 2, weights=history["dt"][until]))
        self.depth = history["towel_depth"][until].max()
        self.sinking, self.rising = vertical_speeds(*read_centers(folder), cycles)


def within(time, cycles):
    """Which rows belong to the first cycles."""
    return time <= cycles * CYCLE + 1e-3


def vertical_speeds(time, centers, cycles):
    """Mean vertical speed of the cloths' centres near the axis and near the drum [m/s]."""
    until = within(time, cycles)
    x, y, z = np.moveaxis(centers[..., until], 1, 0)
    radius = np.hypot(x, y)[:, :-1] / RADIUS
    speed = np.diff(z, axis=1) / np.diff(time[until])
    return [speed[part].mean() if part.any() else np.nan for part in (radius < INNER, radius > OUTER)]


def joined(stresses):
    """Stresses [MPa] in one cell."""
    return ", ".join(f"{stress:.3f}" for stress in stresses)


def table(study, runs, cycles):
    """Prints the runs beside the thesis's averages; returns those that there are by name, in the same order."""
    print(f"\nFirst {cycles} cycles:\n")
    print_record_head("run", "computed", "of that bending", "thesis", "turns per cloth", "near the axis [m/s]",
                      "near the drum [m/s]", "drum [N m]", "largest stretch", "deepest marker [mm]", "crossings")
    results = {}
    for name, thesis in runs.items():
        run = results[name] = Run(study / name, cycles)
        if not run.there:
            print_record(name, "not run", "", ", ".join(map(str, thesis)), *[""] * 7)
            continue
        print_record(name, joined(run.stresses), joined(run.bending), ", ".join(map(str, thesis)), f"{run.tumbles:.2f}",
                     *("none there" if np.isnan(speed) else f"{speed:+.3f}" for speed in (run.sinking, run.rising)),
                     f"{run.drum_torque:.2f}", f"{100 * run.stretch:.2f} %", f"{1e3 * run.depth:.2f}",
                     f"{run.crossings:.0f}")
    return {name: run for name, run in results.items() if run.there}


def rises(values):
    """Whether each value is above the one before it."""
    return all(np.diff(values) > 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("study", nargs="?", type=Path, default=SOURCE / "out" / "study")
    parser.add_argument("--cycles", type=int, default=2)
    parser.add_argument("--load-cycles", type=int, default=5)
    options = parser.parse_args(ARGUMENTS)
    by_reynolds = table(options.study, BY_REYNOLDS, options.cycles)
    by_load = table(options.study, BY_LOAD, options.load_cycles)
    trends = {}
    for name, runs in (("Re", by_reynolds), ("load", by_load)):
        if len(runs) > 1:
            trends[f"ss stress rises with {name} ({', '.join(runs)})"] = (
                rises([run.stresses[0] for run in runs.values()]))
    if len(by_reynolds) > 1:
        trends["torque on the drum falls with Re"] = rises([-run.drum_torque for run in by_reynolds.values()])
    if "re1.2e3" in by_reynolds and "re1.2e4" in by_reynolds:
        trends["tumbling slower at Re 1.2e4 than at 1.2e3"] = (
            by_reynolds["re1.2e4"].tumbles < by_reynolds["re1.2e3"].tumbles)
    if "re1.2e3" in by_load and "cloths64" in by_load:
        trends["tumbling slower with 64 cloths"] = by_load["cloths64"].tumbles < by_load["re1.2e3"].tumbles
    for name in ("re1.2e3", "re1.2e4"):
        if name in by_reynolds:
            trends[f"{name}: up along the drum, down at the centre"] = (
                by_reynolds[name].sinking < 0 < by_reynolds[name].rising)
    print()
    for trend, holds in trends.items():
        print("holds " if holds else "BROKEN", trend)
    return 0 if all(trends.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
