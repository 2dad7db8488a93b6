# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 4.3.1: circular Couette flow, 20 s from the exact field, by tests/mask/couette_test.cpp.

Errors of the velocity at cell centres over its local exact value: the rms in the mean over four places of the centre within
a cell, and the largest of all four. The thesis has one place, which is not known.
"""

import functools
import os
import re
import subprocess
import time

import results
from tables import support
from thesis import checks
from thesis.rows import THEIRS, Row

TEST = support.PROGRAM.with_name("couette_test")
TREATMENTS = {"mapping": 0, "smooth": 1, "ghost": 3, "cut_stencil": 4, "direct_forcing": 5}  # of the test's parameters
GRIDS = {129: "Coarse", 257: "Fine", 513: "Finest"}
LINE = re.compile(r"^ *(\d+)\^2 +(.*?) +rms (\S+) +max (\S+)", re.M)


def output_of(name):
    """Where what one of the long tests prints is kept."""
    return results.root() / f"couette-{results.program_identity()[:12]}-{name.replace('/', '-')}.txt"


def refuse_if_long(cells, treatment):
    """Raises Unfinished where a grid would take longer than a run may: eight times what the grid of half its cells took."""
    coarser = [other for other in GRIDS if other < cells]
    if not coarser or output_of(f"{GRIDS[cells]}/{treatment}").is_file():
        return
    try:
        refuse_if_long(coarser[-1], treatment)
    except results.Unfinished as late:
        raise results.Unfinished(8 * late.seconds) from late
    seconds = 8 * float(printed(f"{GRIDS[coarser[-1]]}/{treatment}").split()[-1])
    if seconds > results.LONGEST["run"]:
        raise results.Unfinished(seconds)


@functools.cache
def printed(name):
    """What one of the long tests prints; it is kept as runs are."""
    output = output_of(name)
    if not output.is_file():
        begun = time.time()
        text = subprocess.run([TEST, "--gtest_also_run_disabled_tests", f"--gtest_filter=*CouetteTable.{name}"], check=True,
                              capture_output=True, text=True, env={**os.environ, "OMPI_MCA_ess_singleton_isolated": "1"}).stdout
        output.parent.mkdir(parents=True, exist_ok=True)
        output.write_text(f"{text}\nseconds {time.time() - begun:.1f}\n")
    results.USED[output] = float(output.read_text().split()[-1])
    return output.read_text()


def errors(numerics, cells, treatment="mapping"):
    """The largest and the rms error, with a treatment of the walls in the place of which today's has markers."""
    treatment = treatment if numerics == THEIRS else "direct_forcing"
    refuse_if_long(cells, TREATMENTS[treatment])
    lines = [line for line in LINE.findall(printed(f"{GRIDS[cells]}/{TREATMENTS[treatment]}"))
             if int(line[0]) == cells and "one place" not in line[1]]
    return float(lines[-1][3]), float(lines[-1][2])


def name_of(mask, cells):
    """What a grid is called in the tables."""
    return f"{mask} mask, {cells} x {cells}"


def rows():
    """Tables 4.3-1 and 4.3-2, and the method of Yokoi (4.3.1.2)."""
    sharp, smooth = ("3.65e-2 (1.05e-2)", "3.09e-2 (7.95e-3)", "1.2e-2 (3.47e-3)"), ("1.133e-1 (4.69e-2)", "4e-2 (1.67e-2)", "1e-2 (4.0e-3)")
    for table, mask, treatment, figures in (("4.3-1", "sharp", "mapping", sharp), ("4.3-2", "smooth", "smooth", smooth)):
        for cells, figure in zip(GRIDS, figures):
            yield Row(table, name_of(mask, cells), "largest (rms) error", figure,
                      functools.partial(errors, cells=cells, treatment=treatment), is_error=True)
    yield Row("4.3.1.2", "method of Yokoi (2003), 129 x 129", "largest (rms) error", "2.15e-2 (4.0e-3)",
              functools.partial(errors, cells=129, treatment="ghost"), is_error=True)


def claims():
    """The rates of the largest and of the rms error, as the thesis prints them, and that the smooth mask's are higher."""
    for table, mask, rates in (("4.3-1", "sharp", (("0.24", "1.4"), ("0.40", "1.2"))), ("4.3-2", "smooth", (("1.5", "2.0"), ("1.5", "2.1")))):
        for part, (error, of_error) in enumerate(zip(("largest", "rms"), rates)):
            for coarse, fine, rate in zip(GRIDS, list(GRIDS)[1:], of_error):
                check = checks.order(table, name_of(mask, coarse), name_of(mask, fine), fine / coarse, part=part, thesis=rate)
                yield check._replace(claim=f"{check.claim}, {error} error")
    ends = [(table, name_of(mask, cells)) for table, mask in (("4.3-2", "smooth"), ("4.3-1", "sharp")) for cells in (129, 513)]
    yield checks.Check("4.3-2", "fall of the rms error from 129 x 129 to 513 x 513 over that with the sharp mask", tuple(ends),
                       lambda figures: figures[0] / figures[1] * figures[3] / figures[2], least=1, part=1, numerics=(THEIRS,))
