# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 4.3.1: circular Couette flow, 20 s from the exact field, by tests/body/couette_test.cpp.

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
from thesis.rows import THEIRS, Row

TEST = support.PROGRAM.with_name("couette_test")
TREATMENTS = {"mapping": 0, "smooth": 1, "cut_stencil": 4, "direct_forcing": 5}  # of the test's parameters
GRIDS = {129: "Coarse", 257: "Fine", 513: "Finest"}
LINE = re.compile(r"^ *(\d+)\^2 +(.*?) +rms (\S+) +max (\S+)", re.M)


@functools.cache
def printed(name):
    """What one of the long tests prints; it is kept as runs are."""
    output = results.root() / f"couette-{results.program_identity()[:12]}-{name.replace('/', '-')}.txt"
    if not output.is_file():
        begun = time.time()
        text = subprocess.run([TEST, "--gtest_also_run_disabled_tests", f"--gtest_filter=*CouetteTable.{name}"], check=True,
                              capture_output=True, text=True, env={**os.environ, "OMPI_MCA_ess_singleton_isolated": "1"}).stdout
        output.parent.mkdir(parents=True, exist_ok=True)
        output.write_text(f"{text}\nseconds {time.time() - begun:.1f}\n")
    results.USED[output] = float(output.read_text().split()[-1])
    return output.read_text()


def errors(numerics, cells, smooth=False):
    """The largest and the rms error."""
    treatment = ("smooth" if smooth else "mapping") if numerics == THEIRS else "direct_forcing"
    lines = [line for line in LINE.findall(printed(f"{GRIDS[cells]}/{TREATMENTS[treatment]}"))
             if int(line[0]) == cells and "one place" not in line[1]]
    return float(lines[-1][3]), float(lines[-1][2])


def rows():
    """Tables 4.3-1 and 4.3-2."""
    sharp, smooth = ("3.65e-2 (1.05e-2)", "3.09e-2 (7.95e-3)", "1.2e-2 (3.47e-3)"), ("1.133e-1 (4.69e-2)", "4e-2 (1.67e-2)", "1e-2 (4.0e-3)")
    for cells, figures in zip(GRIDS, sharp):
        yield Row("4.3-1", f"sharp mask, {cells} x {cells}", "largest (rms) error", figures, functools.partial(errors, cells=cells),
                  is_error=True)
    for cells, figures in zip(GRIDS, smooth):
        yield Row("4.3-2", f"smooth mask, {cells} x {cells}", "largest (rms) error", figures,
                  functools.partial(errors, cells=cells, smooth=True), is_error=True)
