# SPDX-License-Identifier: BSD-3-Clause
"""A vaned agitator that turns steadily in a drum: turns 8, 9 and 10 repeat each other, and moving the body is cheap.

Prints the table of docs/validation/bodies.md. Arguments: methods, by default mapping cut_stencil.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from tables import ARGUMENTS, SOURCE, command, print_record, print_record_head, read_columns

RANKS = 1
LAST_TURNS = (8, 9, 10)
MOST_APART = 0.01  # relative, between these turns
MOST_SHARE = 0.1  # of the time of a step, to move the body with the mapping
MEASURES = {"kinetic_energy": "kinetic energy [J/m]", "agitator_torque": "torque on the agitator [N]",
            "drum_torque": "torque on the drum [N]"}


def run_agitator(method, folder):
    """Runs inputs/agitator2d.opts; returns its history and the share of the time that moving the body took."""
    log = Path(folder) / "log"
    subprocess.run(command(RANKS, "-options_file", SOURCE / "inputs" / "agitator2d.opts", "-body_method", method,
                           "-output_dir", folder, "-log_view", f":{log}"), check=True, stdout=subprocess.DEVNULL)
    share = float(re.search(r"bodies: +\S+ +([\d.]+)%", log.read_text()).group(1)) / 100
    return read_columns(Path(folder) / "history.csv"), share


def by_turns(history, name):
    """Values of a column in each of the last turns, of one second each."""
    time = history["time"]
    return [history[name][(time > turn - 1 + 1e-9) & (time <= turn + 1e-9)] for turn in LAST_TURNS]


def main():
    passed = True
    print_record_head("method", "mean of", *(f"turn {turn}" for turn in LAST_TURNS), "deviation within a turn",
                      "largest divergence [1/s]", "share of the time for moving the body")
    for method in ARGUMENTS or ["mapping", "cut_stencil"]:
        with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
            history, share = run_agitator(method, folder)
        divergence = np.max(history["max_divergence"])
        for name, label in MEASURES.items():
            turns = by_turns(history, name)
            found = [turn.mean() for turn in turns]
            print_record(method, label, *(f"{value:.5g}" for value in found),
                         f"{100 * turns[-1].std() / abs(found[-1]):.1f} %", f"{divergence:.1e}",
                         f"{100 * share:.1f} %", arguments=[method])
            passed &= np.ptp(found) <= MOST_APART * abs(np.mean(found))
        passed &= method != "mapping" or share <= MOST_SHARE
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
