# SPDX-License-Identifier: BSD-3-Clause
"""A filament in a vacuum: period of a hanging chain's first mode, and the tip of one that swings from 0.1 pi.

Prints the table of docs/validation/filament.md. Chain: J0(j01 sqrt(s/L)), s from the free end, omega = j01/2
sqrt(g/L).
"""

import subprocess
import sys
import tempfile

import numpy as np

from tables import SOURCE, command, print_record, print_record_head, read_markers, scientific

SWING = SOURCE / "tests" / "verification" / "reference" / "filament" / "swing_tip_0.1pi_gamma0.01.csv"
LENGTH, GRAVITY = 1, 10
ROOT = 2.404825557695773  # first zero of J0
PERIOD = 4 * np.pi / ROOT * np.sqrt(LENGTH / GRAVITY)
ANGLE = 0.01 * np.pi  # of the chain at the start
MOST_OFF_PERIOD, MOST_OFF_SWING, MOST_STRETCH = 0.01, 0.02, 0.003  # relative


def bessel_j0(z):
    """Bessel function of the first kind of order 0, by its integral over cos(z sin t)."""
    middles = (np.arange(2000) + 0.5) * np.pi / 2000
    return np.cos(np.outer(z, np.sin(middles))).mean(axis=1)


def swing(*options):
    """Runs inputs/filament.opts; returns the times of its frames and the markers' places, frame by marker by axis."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(1, "-options_file", SOURCE / "inputs" / "filament.opts", *options,
                               "-output_dir", folder), check=True, stdout=subprocess.DEVNULL)
        return read_markers(folder)


def most_stretch(places):
    """Largest growth of the filament's length since the start."""
    lengths = np.linalg.norm(np.diff(places, axis=1), axis=2).sum(axis=1)
    return max(lengths) / lengths[0] - 1


def first_mode_period():
    """Period of the part of the first mode in a chain released from a small angle, and its stretch."""
    markers = 40
    arm = 0.5 * (markers - 1) * LENGTH / (markers - 0.5)  # from the hinge to the middle
    sideways, down = np.sin(ANGLE), -np.cos(ANGLE)
    time, places = swing("-line_markers", markers, "-line_kb", 0, "-line_direction", f"{sideways},{down}",
                         "-line_center", f"{arm * sideways},{arm * down}", "-time_end", 6)
    from_end = 1 - np.arange(markers) / (markers - 0.5)
    part = places[:, :, 0] @ bessel_j0(ROOT * np.sqrt(from_end))
    before = np.flatnonzero(part[:-1] * part[1:] < 0)
    zeros = time[before] + (time[before + 1] - time[before]) * part[before] / (part[before] - part[before + 1])
    return 2 * np.mean(np.diff(zeros)), most_stretch(places)


def swing_error():
    """Difference of the tip's path from the reference over that path, root of mean squares, and the stretch."""
    reference = np.genfromtxt(SWING, delimiter=",", skip_header=1, names=True)
    time, places = swing()
    if not np.allclose(time, reference["t"]):
        raise ValueError(f"{SWING}: its times are not those of the frames")
    tip = 1.5 * places[:, -1] - 0.5 * places[:, -2]  # half a spacing beyond the last marker
    off = tip - np.column_stack([reference["y_rich"], -reference["x_N80"]])
    return np.sqrt(np.mean(off ** 2, axis=0)) / np.sqrt(np.mean(reference["y_rich"] ** 2)), most_stretch(places)


def main():
    print_record_head("case", "measure", "computed", "exact", "off", "stretch")
    period, chain_stretch = first_mode_period()
    print_record("hanging chain", "period of mode 1 [s]", f"{period:.5f}", f"{PERIOD:.5f}",
                 f"{100 * (period / PERIOD - 1):+.3f} %", scientific(chain_stretch, 1))
    off, swing_stretch = swing_error()
    for axis, error in zip(("sideways", "down"), off):
        print_record("swing", f"tip {axis}, rms over rms sideways", "", "", f"{100 * error:.2f} %",
                     scientific(swing_stretch, 1))
    passed = abs(period / PERIOD - 1) <= MOST_OFF_PERIOD and max(off) <= MOST_OFF_SWING
    return 0 if passed and max(chain_stretch, swing_stretch) <= MOST_STRETCH else 1


if __name__ == "__main__":
    sys.exit(main())
