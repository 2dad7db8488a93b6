# SPDX-License-Identifier: BSD-3-Clause
"""What a step of the wash costs on some ranks, and by a model on many more: the tables of docs/developer/performance.md.

Steps of inputs/thesis/wash33.opts of equal length, all the same on each number of ranks, and of a cavity on the same cells. Whatever
number of steps is measured, set-up is not: each figure is the difference of two runs. Fails where results differ between ranks.
Arguments: the numbers of ranks, 1 2 if none are given; more than there are cores tell of messages and results alone. The model wants 1 and 2.

The model. What a rank does is taken to be shared evenly, but for what all ranks do: they look which cloths are near among the boxes of
blocks of markers of all. Cells have the work of momentum, pressure, masks and measures; markers of walls grow as the square of the cells a
side, and those of cloths too.
Messages have a latency each and a bandwidth, sums and gathers of all ranks a latency times log2 of them. On more than two ranks a box has
six neighbours, not one, and a transform exchanges with as many ranks as a row of pencils has.
"""

import math
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from tables import ARGUMENTS, SOURCE, print_head, print_origin, print_row, read_columns
import support

CELLS = 33
STEPS = 50, 300
WASH = ["-options_file", SOURCE / "inputs" / "thesis" / "wash33.opts", "-time_cfl", 0, "-time_tolerance", 0, "-time_step", 1e-3]
FINE_CELLS, FINE = 65, ["-grid_cells", "65,65,65", "-towel_markers", 12, "-contact_distance", 0]
CAVITY = ["-grid_cells", f"{CELLS},{CELLS},{CELLS}", "-bc_y_upper_velocity", "1,0,0", "-fluid_density", 1, "-fluid_viscosity", 1e-3,
          "-time_step", 5e-3, "-time_end", 10]
# As they grow: with the cells, with the markers, of walls for the most part, and with those of cloths.
CELL_STAGES = "Main Stage", "bodies", "momentum", "pressure", "measures", "output"
MARKER_STAGES = "spread", "interpolate", "wall_forces"
CLOTH_STAGES = "mobility", "cloth_solve", "cloth_force", "contact_search"
UNUSED = "PCMPI"  # of PETSc's own
LATENCY, BANDWIDTH = 1.5e-6, 10e9  # of a cluster's network [s], [bytes/s a rank]: taken, not measured
CLOTH_MARKERS, BLOCK, CHOICES = 576, 32, 4  # on CELLS; of a box; how often a step looks which are near
BOX, BOX_BYTES = 11e-9, 48  # for each box of all ranks [s, bytes]: measured of 3e5
TRANSPOSES = 12  # a step: three solves of two transforms each, there and back
MONITORING = {"pml_monitoring_enable": 2, "pml_monitoring_enable_output": 3}  # of Open MPI: counts sums and gathers
SAME = 1e-6


class Counted:
    """One run: seconds, those of each stage on its slowest rank; messages, bytes and collective calls of a rank; history."""

    def __init__(self, ranks, steps, case, folder):
        log, calls, out = folder / "log.py", folder / "calls", folder / "out"
        line = support.command(ranks, *case, "-max_steps", steps, "-output_dir", out, "-log_view", f":{log}:ascii_info_detail")
        if ranks > 1:
            for name, value in {**MONITORING, "pml_monitoring_filename": calls}.items():
                line[1:1] = ["--mca", name, str(value)]
        subprocess.run(line, check=True, capture_output=True, cwd=folder)
        logged = {}
        exec(log.read_text(), logged)  # PETSc writes its log as assignments
        stages = {name: list(events["summary"].values()) for name, events in logged["Stages"].items()}
        self.slowest = {name: max(of_rank["time"] for of_rank in of_ranks) for name, of_ranks in stages.items()}
        self.seconds, self.messages, self.bytes = (sum(of_rank[what] for of_ranks in stages.values() for of_rank in of_ranks) / ranks
                                                   for what in ("time", "numMessages", "messageLength"))
        self.collectives = self._collectives(Path(f"{calls}.0.prof")) if ranks > 1 else 0
        self.history = read_columns(out / "history.csv")

    @staticmethod
    def _collectives(path):
        """Those in which all ranks take part."""
        count, counts = 0, False
        for line in path.read_text().splitlines():
            if line.startswith("D"):
                counts = "," in line.split("procs:")[1]
            elif counts:
                count += int(re.search(r"(\d+) msgs", line)[1])
        return count


class Step:
    """What a step takes on some ranks, set-up apart."""

    def __init__(self, ranks, case):
        with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
            few, many = (Counted(ranks, steps, case, Path(folder)) for steps in STEPS)
        steps = STEPS[1] - STEPS[0]
        self.stages = {name: (many.slowest[name] - few.slowest.get(name, 0)) / steps for name in many.slowest}
        self.seconds, self.messages, self.bytes, self.collectives = (
            (getattr(many, name) - getattr(few, name)) / steps for name in ("seconds", "messages", "bytes", "collectives"))
        self.history = many.history

    def of(self, stages):
        """Seconds of these stages together."""
        return sum(self.stages.get(name, 0) for name in stages)


def model(one, counted, cells, ranks):
    """Seconds of each part of a step on a grid of so many cells a side: `one` rank tells of work, two, `counted`, of messages, on CELLS."""
    larger = cells / CELLS
    share = larger**3 / ranks
    surface = (larger**3 / ranks)**(2 / 3) * 2**(2 / 3)  # of a rank's part, over that of half the box
    markers = larger**2
    messages = counted.messages if ranks <= 2 else 6 * counted.messages + TRANSPOSES * math.sqrt(ranks)
    return {
        "cells": one.of(CELL_STAGES) * share,
        "markers": one.of(MARKER_STAGES) * markers / ranks,
        "cloths' equations and contact": one.of(CLOTH_STAGES) * markers / ranks,
        "boxes of all cloths, on each rank": 0 if ranks == 1 else CHOICES * CLOTH_MARKERS / BLOCK * markers * (BOX + BOX_BYTES / BANDWIDTH),
        "messages": 0 if ranks == 1 else messages * LATENCY + counted.bytes * surface / BANDWIDTH,
        "sums and gathers": counted.collectives * LATENCY * math.log2(ranks),
    }


def print_measured(steps):
    """The table of what was run; tells whether all ranks had the same."""
    print_head("ranks", "ms a step", "of the cavity on as many cells", "messages of a rank", "kB", "sums and gathers",
               "largest difference of a column of the history from one rank's")
    same = True
    for ranks, (wash, cavity) in steps.items():
        columns = wash.history.keys() - {"step", "dt", "max_divergence"}
        worst = max(support.relative_difference(wash.history[name], steps[min(steps)][0].history[name]) for name in columns)
        same &= worst < SAME
        print_row(ranks, f"{1e3 * wash.seconds:.1f}", f"{1e3 * cavity.seconds:.1f}", f"{wash.messages:.0f}",
                  f"{1e-3 * max(0, wash.bytes):.0f}", f"{wash.collectives:.0f}", f"{worst:.1e}")
    return same


def print_stages(steps):
    """Milliseconds of each stage, slowest first."""
    all_names = {name for wash, _ in steps.values() for name in wash.stages} - {UNUSED}
    names = sorted(all_names, key=lambda name: max(wash.stages.get(name, 0) for wash, _ in steps.values()), reverse=True)
    print()
    print_head("ms a step on ranks", *steps)
    for name in names:
        print_row("what is in no stage" if name == "Main Stage" else name.replace("_", " "),
                  *(f"{1e3 * wash.stages.get(name, 0):.2f}" for wash, _ in steps.values()))


def print_weak(ranks):
    """As many cells on each rank: what messages and sums a step has, and what it costs on a core."""
    cores = len(os.sched_getaffinity(0))
    print()
    print_head("ranks", "cells a side", "ms a step", "us of a core a step and thousand cells", "messages of a rank", "kB", "sums and gathers")
    for number in ranks:
        cells = round(CELLS * (number / 2)**(1 / 3))
        step = Step(number, [*WASH, "-grid_cells", f"{cells},{cells},{cells}"])
        print_row(number, cells, f"{1e3 * step.seconds:.1f}", f"{1e9 * step.seconds * min(number, cores) / cells**3:.0f}",
                  f"{step.messages:.0f}", f"{1e-3 * max(0, step.bytes):.0f}", f"{step.collectives:.0f}")


def print_model(one, counted):
    """Milliseconds of each part, where it can be measured too, and on a cluster."""
    measured = {(CELLS, 2): counted, (FINE_CELLS, 1): Step(1, [*WASH, *FINE])}
    cases = [*measured, (129, 16), (257, 128), (1025, 4096)]
    parts = [model(one, counted, *case) for case in cases]
    print()
    print_head("ms a step by the model", *(f"{cells}³ cells, {ranks} rank{'s' * (ranks > 1)}" for cells, ranks in cases))
    for name in parts[0]:
        print_row(name, *(f"{1e3 * part[name]:.1f}" for part in parts))
    print_row("all", *(f"{1e3 * sum(part.values()):.1f}" for part in parts))
    print_row("measured", *(f"{1e3 * measured[case].seconds:.1f}" if case in measured else "" for case in cases))


def main():
    """Runs all, prints the tables, returns the exit status."""
    ranks = [int(word) for word in ARGUMENTS] or [1, 2]
    print_origin()
    steps = {number: (Step(number, WASH), Step(number, CAVITY)) for number in ranks}
    same = print_measured(steps)
    print_stages(steps)
    print_weak(ranks)
    if 1 in steps and 2 in steps:
        print_model(steps[1][0], steps[2][0])
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
