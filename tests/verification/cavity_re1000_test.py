# SPDX-License-Identifier: BSD-3-Clause
"""Lid-driven cavity at Re = 1000 against the spectral values of Botella and Peyret (1998): errors and order.

Prints the table of docs/verification.md. Arguments: cells per side (default 65 129 257).
"""

import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

REFERENCE = pathlib.Path(os.environ["WASHFSI_SOURCE"]) / "tests" / "verification" / "reference" / "cavity"
CASE = pathlib.Path(os.environ["WASHFSI_SOURCE"]) / "inputs" / "cavity.opts"
END = 80  # [s] by then the flow is steady: twice as long changes no printed digit
MOST_ALLOWED = {65: 0.035, 129: 0.008, 257: 0.003}  # of the lid speed


def read_table(path):
    """A CSV with # comments and a row of names, as a dictionary of columns."""
    lines = [line for line in path.read_text().splitlines() if line and not line.startswith("#")]
    values = np.array([[float(word) for word in line.split(",")] for line in lines[1:]])
    return dict(zip(lines[0].split(","), values.T))


def run_cavity(cells, folder):
    """Runs to the steady state and samples both centre lines at the grid's own points."""
    half = 0.5 / cells
    lines = ["-profiles", "vertical,horizontal",
             "-vertical_from", f"0.5,{half!r}", "-vertical_to", f"0.5,{1 - half!r}", "-vertical_points", str(cells),
             "-horizontal_from", f"{half!r},0.5", "-horizontal_to", f"{1 - half!r},0.5", "-horizontal_points", str(cells)]
    command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", "2", os.environ["WASHFSI_PROGRAM"],
               "-options_file", CASE, "-grid_cells", f"{cells},{cells}", "-fluid_viscosity", "1e-3",
               "-time_step", repr(0.45 / cells), "-time_end", str(END), "-output_interval", str(END),
               "-output_dir", folder, *lines]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return {name: read_table(pathlib.Path(folder) / "profiles" / f"{name}.csv") for name in ("vertical", "horizontal")}


def interpolate_cubic(x, values, places):
    """Lagrange's cubic through the four points round each place: its error is far below the scheme's."""
    result = []
    for place in places:
        first = int(np.clip(np.searchsorted(x, place) - 2, 0, len(x) - 4))
        near, f = x[first:first + 4], values[first:first + 4]
        weights = [np.prod([(place - near[j]) / (near[i] - near[j]) for j in range(4) if j != i]) for i in range(4)]
        result.append(np.dot(weights, f))
    return np.array(result)


def differences(profiles):
    """Computed minus reference at all tabulated points of both lines."""
    u = read_table(REFERENCE / "botella_peyret1998_Re1000_u_x0.5.csv")
    v = read_table(REFERENCE / "botella_peyret1998_Re1000_v_y0.5.csv")
    rows = [(profiles["vertical"], "y", "u", (0.0, 1.0), u), (profiles["horizontal"], "x", "v", (0.0, 0.0), v)]
    result = []
    for profile, axis, component, walls, reference in rows:
        x = np.concatenate([[0.0], profile[axis], [1.0]])
        values = np.concatenate([[walls[0]], profile[component], [walls[1]]])
        result.append(interpolate_cubic(x, values, reference[axis]) - reference[component])
    return result


def main():
    sizes = [int(word) for word in sys.argv[1:]] or [65, 129, 257]
    failed, previous = False, None
    print("cells    u max     u rms     v max     v rms     order of the rms")
    for cells in sizes:
        with tempfile.TemporaryDirectory() as folder:
            du, dv = differences(run_cavity(cells, folder))
        rms = np.sqrt(np.mean(np.concatenate([du, dv]) ** 2))
        order = "" if previous is None else f"{np.log(previous[1] / rms) / np.log(cells / previous[0]):.2f}"
        figures = [f"{100 * value:8.3f}%" for d in (du, dv) for value in (np.abs(d).max(), np.sqrt(np.mean(d ** 2)))]
        print(f"{cells:4d}^2 {' '.join(figures)}  {order}", flush=True)
        failed |= max(np.abs(du).max(), np.abs(dv).max()) > MOST_ALLOWED.get(cells, np.inf)
        failed |= order != "" and float(order) < 1.8
        previous = cells, rms
    return 1 if failed else 0


sys.exit(main())
