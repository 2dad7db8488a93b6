# SPDX-License-Identifier: BSD-3-Clause
"""The couplings at the three-dimensional wash: step, damping, cost and the stresses of the first agitation cycle.

Prints the tables of docs/validation/wash.md. Arguments: `--shipped` for `inputs/thesis/wash33.opts` as it is, which chooses its
steps, instead of the thesis's machine; `--cycles PART` for a part of the cycle only; `--ranks`, 2 if not given. Results
are kept as results.py says. The reference is the explicit coupling with the damping that the semi-implicit step of the machine has by itself, about one
step. Tracks: rms distance of the cloths' centres from the reference's, over the marker spacing. Fails where the
default's stresses are more than 8 % from the reference's.
"""

import argparse
import json
import sys

import numpy as np

import results
from tables import ARGUMENTS, OPTIONS, SOURCE, print_record, print_record_head, read_columns
from wash_runs import CYCLE, STRESSES, read_centers

MACHINE = SOURCE / "inputs" / "thesis" / "wash33.opts"
WITH_MASK = ("-body_method", "mapping", "-contact", "penalty", "-contact_pressure", 1e5, "-contact_distance", 0.01,
             "-advection_steps", 2, "-time_cfl", 0.7)
INTERVAL = 1e-3  # between measurements: the default's step [s]
SPACING = 0.025  # of the markers [m]
MOST_OFF = 0.08
# coupling, damping [s], step [s]: the reference, the default, the others; the thesis's dt* is 8e-5 s, undamped
REFERENCE, DEFAULT = ("explicit", 1e-3, 1e-5), ("semi_implicit", 0, 1e-3)
RUNS = [REFERENCE, DEFAULT, ("semi_implicit", 0, 5e-4), ("semi_implicit", 0, 2.5e-4), ("explicit", 1e-4, 6e-5),
        ("explicit", 0, 8e-5), ("explicit", 0, 4e-5), ("midpoint", 0, 8e-5)]
AS_SHIPPED = ("as shipped", 0, 0)
SHIPPED_RUNS = [REFERENCE, ("explicit", 1e-4, 6e-5), AS_SHIPPED]


class Run:
    """The start of a machine."""

    def __init__(self, ranks, end, machine, coupling, damping, step):
        equal_steps = ["-coupling_scheme", coupling, "-coupling_order", 1, "-time_tolerance", 0, "-time_step", step,
                       *(["-towel_damping", damping] if damping else [])]
        folder, _, failed = results.run(ranks, "-options_file", MACHINE, *machine, *(equal_steps if step else []), "-time_end", end,
                                        "-history_interval", INTERVAL, "-checkpoint_interval", 0.1, *OPTIONS, may_fail=True)
        result = json.loads((folder / "summary.json").read_text())
        self.stable = not failed
        self.ms = 1e3 * result["seconds_per_step"]
        cloth = result["cloths"]["towel"]
        self.stretch, self.crossings = cloth["max_stretch"], result["cloth_crossings"]
        self.membrane, self.bending = (
            np.array([1e-6 * cloth[f"{part}_stress_{stress}_mean"] for stress in STRESSES])
            for part in ("membrane", "bending"))
        self.time, self.centers = read_centers(folder)
        self.cost = result["seconds_per_step"] * result["steps"] / self.time[-1]  # of a run that diverged too
        self.work = first_cycle(folder)

    def tracks_off(self, reference, time):
        """Rms distance of the cloths' centres from the reference's at a time, over the marker spacing."""
        centers, others = (run.centers[..., np.argmin(np.abs(run.time - time))] for run in (self, reference))
        return np.sqrt(np.mean(np.sum((centers - others) ** 2, axis=1))) / SPACING


def first_cycle(folder):
    """Work of the agitator in the first cycle [J] in words; none where a run did not come so far."""
    cycles = read_columns(folder / "cycles.csv").get("agitator_work", []) if (folder / "cycles.csv").is_file() else []
    return f"{cycles[0]:.1f}" if len(cycles) else ""


def off(values, reference):
    """Largest relative difference of the components."""
    return np.abs(values / reference - 1).max()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--shipped", action="store_true")
    parser.add_argument("--cycles", type=float, default=1)
    parser.add_argument("--ranks", type=int, default=2)
    options = parser.parse_args(ARGUMENTS)
    machine, cases, default = ((), SHIPPED_RUNS, AS_SHIPPED) if options.shipped else (WITH_MASK, RUNS, DEFAULT)
    end = options.cycles * CYCLE
    print_record_head("coupling", "damping [s]", "step [s]", "ms a step", "s per simulated s",
                      "membrane ss, rr, sr [MPa]", "bending ss, rr, sr [MPa]", "membrane off", "bending off",
                      "tracks off half-way and at the end", "largest stretch", "crossings", "work [J]")
    runs = {}
    for case in cases:
        run = runs[case] = Run(options.ranks, end, machine, *case)
        words = [case[0], f"{case[1]:g}", f"{case[2]:g}", f"{run.ms:.1f}", f"{run.cost:.0f}"]
        if not run.stable:
            print_record(*words, "diverged", *[""] * 7)
            continue
        reference = runs[REFERENCE]
        differences = [f"{100 * off(run.membrane, reference.membrane):.0f} %",
                       f"{100 * off(run.bending, reference.bending):.0f} %",
                       ", ".join(f"{run.tracks_off(reference, part * end):.2f}" for part in (0.5, 1))]
        print_record(*words, *(", ".join(f"{value:.4f}" for value in part) for part in (run.membrane, run.bending)),
                     *(differences if run is not reference else 3 * [""]), f"{100 * run.stretch:.2f} %", run.crossings,
                     run.work)
    reference, default = runs[REFERENCE], runs[default]
    return 0 if max(off(default.membrane, reference.membrane), off(default.bending, reference.bending)) <= MOST_OFF else 1


if __name__ == "__main__":
    sys.exit(main())
