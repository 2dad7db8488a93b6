# SPDX-License-Identifier: BSD-3-Clause
"""The couplings of cloth and water at the two-dimensional wash, soft and stiff: step, cost, tracks and tension.

Prints the tables of docs/verification.md. Arguments: stiffnesses Ke in N/m, by default 8e3 and 8e5. The reference is the
explicit coupling, damped, at a quarter of its bound, over the first quarter of an agitation cycle. Tracks: rms difference
of all markers over the marker spacing, when the reference has travelled ten spacings. Tension: rms over the edges of the
difference of the time means, over the rms of the reference's.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from tables import SOURCE, command, print_head, print_row, read_markers

RANKS = 1
QUARTER, INTERVAL, TRAVEL = 0.392, 0.004, 10  # s, s, spacings
GROUPS = {"long": (10, 24), "short": (10, 16)}
SPACING = 0.0108
DAMPING = 1e-4  # of the explicit couplings [s]
# steps in units of the explicit bound without damping
STEPS = {"explicit": (0.25, 0.5), "midpoint": (0.5,), "semi_implicit": (0.5, 1, 2, 4, 8, 16, 32), "implicit": (2, 8)}


class Run:
    """A run over a quarter of a cycle, or what is left of one that failed."""

    def __init__(self, stiffness, coupling, step, damping, folder):
        options = [f"-{group}_{name}" for group in GROUPS for name in ("ke", "damping")]
        values = [stiffness, damping] * len(GROUPS)
        outcome = subprocess.run(
            command(RANKS, "-options_file", SOURCE / "inputs" / "wash2d.opts", "-cloth_coupling", coupling,
                    "-time_cfl", 0, "-time_step", step, "-time_end", QUARTER, "-output_interval", INTERVAL, "-checkpoint_interval", 1,
                    "-output_dir", folder, *(word for pair in zip(options, values) for word in pair)),
            check=False, capture_output=True, text=True)
        self.stable = outcome.returncode == 0
        summary = json.loads((Path(folder) / "summary.json").read_text())
        self.ms = 1e3 * summary["seconds_per_step"]
        self.iterations = summary["iterations"]
        self.cost = summary["seconds_per_step"] / step
        self.places = read_markers(folder)[1]
        edges = np.linalg.norm(np.diff(self.places, axis=1), axis=2)
        self.tension = (stiffness * 0.5 * ((edges / SPACING) ** 2 - 1)[:, within_cloths()]).mean(axis=0)

    def tracks_off(self, reference):
        """Rms distance from the reference's markers in spacings, when those have gone their way."""
        gone = np.sqrt(((reference.places - reference.places[0]) ** 2).sum(axis=2).mean(axis=1)) / SPACING
        frame = int(np.argmax(gone >= TRAVEL)) or len(gone) - 1
        return np.sqrt(((self.places[frame] - reference.places[frame]) ** 2).sum(axis=1).mean()) / SPACING

    def tension_off(self, reference):
        """Relative rms difference of the edges' mean tensions."""
        return np.sqrt(((self.tension - reference.tension) ** 2).mean() / (reference.tension ** 2).mean())


def within_cloths():
    """Which differences of neighbouring markers are edges of a cloth."""
    lengths = [markers for count, markers in GROUPS.values() for _ in range(count)]
    edge = np.ones(sum(lengths), dtype=bool)
    edge[np.cumsum(lengths) - 1] = False
    return edge[:-1]


def bound(stiffness, damping):
    """The step bound that the program states."""
    options = [word for group in GROUPS for word in (f"-{group}_ke", stiffness, f"-{group}_damping", damping)]
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        text = subprocess.run(command(1, "-options_file", SOURCE / "inputs" / "wash2d.opts", "-check", "-cloth_coupling",
                                      "explicit", "-output_dir", folder, *options),
                              check=True, capture_output=True, text=True).stdout
    return float(re.search(r"bound of the coupling (\S+) s", text)[1])


def in_folder(*arguments):
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        return Run(*arguments, folder)


def table(stiffness):
    undamped = bound(stiffness, 0)
    reference = in_folder(stiffness, "explicit", bound(stiffness, DAMPING) / 4, DAMPING)
    print(f"\nKe = {stiffness:g} N/m; bound of the explicit step {undamped:.3g} s undamped,"
          f" {bound(stiffness, DAMPING):.3g} s with damping {DAMPING:g} s\n")
    print_head("coupling", "damping [s]", "step [s]", "over the bound", "pressure and cloth iterations a step", "ms a step",
               "s per simulated s", "tracks [spacings]", "tension", "mean tension [N/m]")

    def row(run, coupling, damping, step):
        words = [coupling, f"{damping:g}", f"{step:.3g}", f"{step / undamped:.2g}"]
        if not run.stable:
            return print_row(*words, *["diverged"] + 5 * [""])
        return print_row(*words, f"{run.iterations['pressure']:.1f} + {run.iterations['cloth']:.1f}", f"{run.ms:.2f}",
                         f"{run.cost:.1f}", f"{run.tracks_off(reference):.3f}", f"{run.tension_off(reference):.2f}",
                         f"{np.abs(run.tension).mean():.1f}")

    row(reference, "explicit (reference)", DAMPING, bound(stiffness, DAMPING) / 4)
    for coupling, steps in STEPS.items():
        explicit = coupling in ("explicit", "midpoint")
        for damping in (0, DAMPING) if explicit else (0,):
            for part in steps:
                step = part * (bound(stiffness, damping) if explicit else undamped)
                if step > 2.5e-3:
                    continue  # beyond a CFL number of 1
                row(in_folder(stiffness, coupling, step, damping), coupling, damping, step)


def main():
    for stiffness in map(float, sys.argv[1:] or ["8e3", "8e5"]):
        table(stiffness)
    return 0


if __name__ == "__main__":
    sys.exit(main())
