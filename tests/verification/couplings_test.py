# SPDX-License-Identifier: BSD-3-Clause
"""The couplings of cloth and water at the two-dimensional wash, soft and stiff: step, cost, tracks and tension.

Prints the tables of docs/validation/couplings.md. Arguments: stiffnesses Ke in N/m, by default 8e3 and 8e5, and
coupling:damping:step ... for these runs alone. The reference is the explicit coupling, damped, at a quarter of its
bound, over the first quarter of an agitation cycle; options after `--` are not for it. Tracks: rms difference of all
markers over the marker spacing, and the median marker's, when the reference has travelled ten spacings. Tension: rms
over the edges of the difference of the time means, over the rms of the reference's.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from tables import ARGUMENTS, OPTIONS, SOURCE, command, print_record, print_record_head, read_markers

RANKS = 1
QUARTER, INTERVAL, TRAVEL = 0.392, 0.004, 10  # s, s, spacings
GROUPS = {"long": (10, 24), "short": (10, 16)}
SPACING = 0.0108
DAMPING = 1e-4  # of the explicit couplings [s]
# steps in units of the explicit bound without damping
STEPS = {"explicit": (0.25, 0.5), "midpoint": (0.5,), "semi_implicit": (0.5, 1, 2, 4, 8, 16, 32), "implicit": (2, 8)}


class Run:
    """A run over a quarter of a cycle, or what is left of one that failed."""

    def __init__(self, stiffness, coupling, step, damping, others, folder):
        options = [f"-{group}_{name}" for group in GROUPS for name in ("ke", "damping")]
        values = [stiffness, damping] * len(GROUPS)
        outcome = subprocess.run(
            command(RANKS, "-options_file", SOURCE / "inputs" / "thesis" / "wash2d64.opts", "-coupling_scheme", coupling,
                    "-time_cfl", 0, "-time_step", step, "-time_end", QUARTER, "-output_interval", INTERVAL,
                    "-checkpoint_interval", 1, "-output_dir", folder,
                    *(word for pair in zip(options, values) for word in pair), others=others),
            check=False, capture_output=True, text=True)
        self.stable = outcome.returncode == 0
        summary = json.loads((Path(folder) / "summary.json").read_text())
        self.ms = 1e3 * summary["seconds_per_step"]
        self.cost = summary["seconds_per_step"] / step
        self.places = read_markers(folder)[1]
        edges = np.linalg.norm(np.diff(self.places, axis=1), axis=2)
        self.tension = (stiffness * 0.5 * ((edges / SPACING) ** 2 - 1)[:, within_cloths()]).mean(axis=0)

    def tracks_off(self, reference):
        """Distance from the reference's markers in spacings, when those have gone their way: rms and median."""
        gone = np.sqrt(((reference.places - reference.places[0]) ** 2).sum(axis=2).mean(axis=1)) / SPACING
        frame = int(np.argmax(gone >= TRAVEL)) or len(gone) - 1
        off = np.linalg.norm(self.places[frame] - reference.places[frame], axis=1) / SPACING
        return np.sqrt(np.mean(off ** 2)), np.median(off)

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
        text = subprocess.run(command(1, "-options_file", SOURCE / "inputs" / "thesis" / "wash2d64.opts", "-check",
                                      "-coupling_scheme", "explicit", "-output_dir", folder, *options, others=[]),
                              check=True, capture_output=True, text=True).stdout
    return float(re.search(r"bound of the coupling (\S+) s", text)[1])


def in_folder(*arguments):
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        return Run(*arguments, folder)


def usual_cases(stiffness):
    """Coupling, damping and step of the runs of a table."""
    for coupling, steps in STEPS.items():
        explicit = coupling in ("explicit", "midpoint")
        for damping in (0, DAMPING) if explicit else (0,):
            for part in steps:
                step = part * bound(stiffness, damping if explicit else 0)
                if step < 2.5e-3:  # beyond, the CFL number exceeds 1
                    yield coupling, damping, step


def print_run(run, coupling, damping, step, reference, arguments):
    """Prints the row of a run."""
    words = [coupling, f"{damping:g}", f"{step:.3g}"]
    if not run.stable:
        return print_record(*words, "diverged", *5 * [""], arguments=arguments)
    off = [f"{value:.2f}" for value in (*run.tracks_off(reference), run.tension_off(reference))]
    return print_record(*words, f"{run.ms:.1f}", f"{run.cost:.3g}", *(off if run is not reference else 3 * [""]),
                        f"{np.abs(run.tension).mean():.1f}", arguments=arguments)


def table(word, cases):
    """Prints the runs at a stiffness, given as a word, beside their reference."""
    stiffness = float(word)
    step = bound(stiffness, DAMPING) / 4
    reference = in_folder(stiffness, "explicit", step, DAMPING, [])
    print(f"\nKe = {stiffness:g} N/m; bound of the explicit step {bound(stiffness, 0):.3g} s undamped,"
          f" {4 * step:.3g} s with damping {DAMPING:g} s\n")
    print_record_head("coupling", "damping [s]", "step [s]", "ms a step", "s per simulated s", "tracks [spacings]",
                      "median marker", "tension", "mean tension [N/m]")
    print_run(reference, "explicit (reference)", DAMPING, step, reference, [word])
    for case in cases or usual_cases(stiffness):
        coupling, damping, step = case
        print_run(in_folder(stiffness, coupling, step, damping, OPTIONS), *case, reference,
                  [word, *([f"{coupling}:{damping:g}:{step:g}"] if cases else [])])


def main():
    cases = [(name, float(damping), float(step)) for name, damping, step in
             (word.split(":") for word in ARGUMENTS if ":" in word)]
    for word in [word for word in ARGUMENTS if ":" not in word] or ["8e3", "8e5"]:
        table(word, cases)
    return 0


if __name__ == "__main__":
    sys.exit(main())
