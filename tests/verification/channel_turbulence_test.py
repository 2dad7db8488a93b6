# SPDX-License-Identifier: BSD-3-Clause
"""Turbulent channel flow at Re_tau of 180 to 200 on a coarse grid, without a model, against Del Alamo and Jimenez (2003).

Prints the tables of docs/validation/turbulence.md. Runs inputs/channel_turbulent.opts, an hour and more; an argument is the
folder of a run of it that has ended. Wall units are of the run itself: u_tau² = -(mean pressure gradient) times the half
height over rho.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

from tables import ARGUMENTS, SOURCE, command, print_head, print_origin, print_row, read_columns

REFERENCE = Path(__file__).parent / "reference" / "channel" / "alamo2003_Re180.csv"
DENSITY, VISCOSITY, HALF = 1, 1 / 180, 1
COLUMNS = {"U+": "u_mean", "u'": "u_rms", "v'": "v_rms", "w'": "w_rms", "-uv": "minus_uv"}
MOST_OFF_ACROSS, MOST_OFF_STRESS = 0.1, 0.03  # of v' and w' beyond y+ = 30, of their peaks; of the total stress, of the wall's


def mean_gradient(folder):
    """Returns the pressure gradient in the mean over the time of the statistics."""
    history = read_columns(folder / "history.csv")
    with h5py.File(folder / "statistics.h5") as file:
        counts = history["time"] > file.attrs["start"]
    weights = np.diff(history["time"], prepend=0)[counts]
    return np.average(history["pressure_gradient_x"][counts], weights=weights)


def folded(values, sign=1):
    """Returns the mean of both halves of a profile, that of the upper one with a sign."""
    half = len(values) // 2
    return (values[:half] + sign * values[::-1][:half]) / 2


def wall_units(folder):
    """Returns u_tau and the lower half's profiles in wall units, by the reference's names."""
    table = read_columns(folder / "statistics.csv")
    speed = np.sqrt(-mean_gradient(folder) * HALF / DENSITY)
    profile = {"y": table["y"][:len(table["y"]) // 2] * speed / VISCOSITY,
               "u_mean": folded(table["u"]) / speed, "minus_uv": -folded(table["uv"], -1) / speed ** 2}
    profile |= {f"{c}_rms": np.sqrt(folded(table[2 * c])) / speed for c in "uvw"}
    return speed, profile


def total_stress_error(profile, speed):
    """Returns how far viscous and turbulent stress together are from the straight line that the balance of force asks for."""
    place = profile["y"] * VISCOSITY / speed / HALF
    viscous = np.gradient(profile["u_mean"], profile["y"])
    return np.abs(viscous + profile["minus_uv"] - (1 - place))[4:].max()  # the difference has no neighbour at the wall


def print_profiles(profile, reference):
    """Prints the run at the reference's places between its cells; returns the largest errors beyond y+ = 30: of U+, and of v' and
    w' over their peaks."""
    print_head("y+", *(f"{name}{end}" for name in COLUMNS for end in (", run", ", reference")))
    off_mean = off_across = 0
    for row in reference:
        if not profile["y"][0] <= row["y"] <= profile["y"][-1]:
            continue
        pairs = [(np.interp(row["y"], profile["y"], profile[column]), row[column]) for column in COLUMNS.values()]
        print_row(f"{row['y']:.1f}", *(f"{value:.2f}" for pair in pairs for value in pair))
        if row["y"] > 30:
            off_mean = max(off_mean, abs(pairs[0][0] / pairs[0][1] - 1))
            off_across = max(off_across, *(abs(pairs[n][0] - pairs[n][1]) / reference[("v_rms", "w_rms")[n - 2]].max()
                                           for n in (2, 3)))
    return off_mean, off_across


def judge(folder):
    """Prints the tables of a run; returns whether it is as near to the reference as it should be."""
    reference = np.genfromtxt(REFERENCE, delimiter=",", names=True, skip_header=1)
    speed, profile = wall_units(folder)
    print_origin()
    (off_mean, off_across), stress = print_profiles(profile, reference), total_stress_error(profile, speed)
    print(f"\nRe_tau {speed * HALF / VISCOSITY:.1f}; first cell's centre at y+ {profile['y'][0]:.2f}; peak of u' "
          f"{profile['u_rms'].max():.3f} at y+ {profile['y'][profile['u_rms'].argmax()]:.1f} (reference "
          f"{reference['u_rms'].max():.3f} at {reference['y'][reference['u_rms'].argmax()]:.1f}); U+ beyond y+ = 30 at most "
          f"{100 * off_mean:.1f} % off, v' and w' {100 * off_across:.1f} % of their peaks; total stress at most "
          f"{stress:.3f} of the wall's off the straight line.")
    return off_across <= MOST_OFF_ACROSS and stress <= MOST_OFF_STRESS


def main():
    if ARGUMENTS:
        return 0 if judge(Path(ARGUMENTS[0])) else 1
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        subprocess.run(command(1, "-options_file", SOURCE / "inputs" / "channel_turbulent.opts", "-output_dir", folder),
                       check=True, stdout=subprocess.DEVNULL)
        return 0 if judge(Path(folder)) else 1


if __name__ == "__main__":
    sys.exit(main())
