# SPDX-License-Identifier: BSD-3-Clause
"""The two-dimensional washing machine of thesis 5.4: average stress against grid, step, mask and bending stiffness.

Prints the tables of docs/verification/wash2d.md. Arguments: which of grid, step, mask, bending, cycles, by default all;
or numbers of cells a side for these grids alone. Stress: mean over the markers of both groups of each marker's average
over time, and its standard deviation, in MPa.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from tables import ARGUMENTS, SOURCE, command, print_record, print_record_head, read_columns

RANKS = 1
CYCLE = 1.5707963
STEP = 3.5e-4  # s: CFL 0.5 on the finest grid; the same on all, since the step damps
MARKERS = {"long": 24, "short": 16}  # of 64 x 64 cells
DEPTH = 0.5  # spacings, that no marker may be deeper in a body
# h/2r_o, thesis Table 5.4-3, in MPa
THESIS = {32: "1.492 (0.511)", 64: "0.386 (0.171)", 128: "0.135 (0.034)", 256: "0.087 (0.017)"}


def wash(*options, cells=64, end=1.5 * CYCLE, step=STEP):
    """Runs the case; returns its summary and its history, and the cell size."""
    spacing = 0.6912 / cells
    groups = [word for name, markers in MARKERS.items() for word in (f"-{name}_markers", markers * cells // 64)]
    clock = ["-time_cfl", 0.5] if step is None else ["-time_cfl", 0, "-time_step", step]
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(RANKS, "-options_file", SOURCE / "inputs" / "thesis" / "wash2d64.opts", "-grid_cells", f"{cells},{cells}",
                               "-contact_distance", spacing, *groups, *clock, "-time_end", end, "-output_interval", end,
                               "-checkpoint_interval", end, "-output_dir", folder, *options),
                       check=True, stdout=subprocess.DEVNULL)
        return json.loads((Path(folder) / "summary.json").read_text()), read_columns(Path(folder) / "history.csv"), spacing


def stress(summary):
    """Mean and standard deviation over the markers of all cloths [MPa]."""
    numbers = np.array([markers * 10 for markers in MARKERS.values()], dtype=float)
    groups = [summary["cloths"][name] for name in MARKERS]
    means, deviations = (np.array([group[key] for group in groups]) for key in ("stress_mean", "stress_std"))
    mean = np.average(means, weights=numbers)
    deviation = np.sqrt(np.average(deviations ** 2 + means ** 2, weights=numbers) - mean ** 2)
    return mean / 1e6, deviation / 1e6


def bending_part(summary):
    """Mean of the bending stress over the markers of all cloths [MPa]."""
    return np.average([summary["cloths"][name]["bending_stress_mean"] for name in MARKERS],
                      weights=list(MARKERS.values())) / 1e6


def depth(summary, spacing):
    """Depth of the deepest marker of the run in a body, in spacings."""
    return max(summary["cloths"][name]["max_depth"] for name in MARKERS) / spacing


def row(argument, name, run, *more):
    """Prints the row of a run, which the argument gives again. Returns whether no marker is too deep in a body."""
    summary, history, spacing = run
    mean, deviation = stress(summary)
    print_record(name, f"{mean:.3f} ({deviation:.3f})", *more, f"{bending_part(summary):.3f}",
                 f"{100 * max(summary['cloths'][group]['max_stretch'] for group in MARKERS):.1f} %",
                 f"{depth(summary, spacing):.2f}", f"{history['cfl'].max():.2f}", f"{summary['wall_seconds']:.0f}",
                 arguments=[argument])
    return depth(summary, spacing) <= DEPTH


COLUMNS = ("bending part", "largest stretch", "deepest marker [spacings]", "largest CFL number", "wall [s]")


def grids(sizes=tuple(THESIS)):
    """Table 5.4-3; on the finest grid half a cycle. The stress is to fall with the spacing."""
    print_record_head("cells", "stress [MPa]", "thesis", *COLUMNS)
    shallow, means = True, []
    for cells in sizes:
        half = cells == 256
        run = wash(cells=cells, end=0.5 * CYCLE if half else 1.5 * CYCLE)
        shallow &= row(cells, f"{cells} x {cells}" + half * ", half a cycle", run, THESIS[cells])
        means += [] if half else [stress(run[0])[0]]
    return shallow and all(np.diff(means) < 0)


def steps():
    print_record_head("step [s]", "stress [MPa]", *COLUMNS)
    return all([row("step", f"{step:.3g}", wash(step=step)) for step in (7e-4, 3.5e-4, 1.75e-4)])


def masks():
    print_record_head("mask", "stress [MPa]", *COLUMNS)
    return all([row("mask", mask, wash("-body_mask", mask)) for mask in ("sharp", "smooth")])


def bending():
    print_record_head("Kb [N m] (Be)", "stress [MPa]", *COLUMNS)
    return all([row("bending", f"{kb:g} ({2.56 * kb:.2g})", wash("-long_kb", kb, "-short_kb", kb))
                for kb in (1e-5, 1e-2)])


def cycles():
    """Ten cycles with the steps of the input file."""
    print_record_head("run", "stress [MPa]", *COLUMNS)
    return all([row("cycles", f"{number:g} cycles", wash(step=None, end=number * CYCLE)) for number in (1.5, 10)])


def main():
    tables = {"grid": grids, "step": steps, "mask": masks, "bending": bending, "cycles": cycles}
    sizes = [int(word) for word in ARGUMENTS if word not in tables]
    passed = grids(sizes) if sizes else True
    for name in [word for word in ARGUMENTS if word in tables] if ARGUMENTS else tables:
        print()
        passed &= tables[name]()
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
