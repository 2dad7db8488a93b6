# SPDX-License-Identifier: BSD-3-Clause
"""A clamped strip of cloth under its weight: tip and overhang angle against the exact heavy elastica.

Prints the table of docs/validation/strip.md. The tip is half a spacing beyond the last row of markers.
"""

import csv
import subprocess
import sys
import tempfile

import numpy as np

from tables import SOURCE, command, print_record, print_record_head, read_markers

ELASTICA = SOURCE / "tests" / "verification" / "reference" / "elastica"
MARKERS = (33, 5)
OVERHANG = 41.5  # [degrees] of the chord, where the strip is 2.0004 bending lengths long (Peirce's test)
MOST_OFF_TIP, MOST_OFF_OVERHANG = 4e-4, 2e-3


def tip_of(weight):
    """Place of the tip of the strip with this weight per area [N/m2]; Kb and the free length are 1."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(1, "-options_file", SOURCE / "inputs" / "strip.opts", "-gravity", f"0,0,{-weight}",
                               "-output_dir", folder), check=True, stdout=subprocess.DEVNULL)
        time, places = read_markers(folder, axes=3)
    rows = places[-1].reshape(*MARKERS, 3).mean(axis=1)
    return time[-1], 1.5 * rows[-1] - 0.5 * rows[-2]


def chord_table():
    """Angles of the chord [degrees] and the exact lengths over the bending length."""
    with open(ELASTICA / "peirce_cantilever.csv", encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return np.array([[float(row["theta_deg"]), float(row["L_over_c_exact"])] for row in rows]).T


def main():
    print_record_head("w L^3/Kb", "at rest after [s]", "measure", "computed", "exact", "off")
    exact = np.genfromtxt(ELASTICA / "bickley_b3_10_alpha_0.csv", delimiter=",", skip_header=2)
    time, tip = tip_of(10)
    wanted = exact[-1, 1:3]
    off = np.hypot(*(tip[[0, 2]] - wanted))
    print_record(10, f"{time:.1f}", "tip [L]", f"{tip[0]:.5f}, {tip[2]:.5f}", f"{wanted[0]:.5f}, {wanted[1]:.5f}",
                 f"{100 * off:.2f} % of L")
    angles, lengths = chord_table()
    length = np.interp(OVERHANG, angles, lengths)
    time, tip = tip_of(length ** 3)
    angle = np.degrees(np.arctan2(-tip[2], tip[0]))
    found = np.interp(angle, angles, lengths)  # of the exact strip with the computed angle
    print_record(f"{length ** 3:.4f}", f"{time:.1f}", f"overhang at {OVERHANG} degrees [c]", f"{found:.4f}",
                 f"{length:.4f}", f"{100 * (found / length - 1):+.2f} %")
    return 0 if off <= MOST_OFF_TIP and abs(found / length - 1) <= MOST_OFF_OVERHANG else 1


if __name__ == "__main__":
    sys.exit(main())
