# SPDX-License-Identifier: BSD-3-Clause
"""A square cloth draped over a square prism, thesis 4.3.3: penetration, symmetry and time to rest on three grids.

Prints the table of docs/verification/drape.md; the limits hold for 65^3 cells. Arguments: numbers of cells along the
side of the grids (15 33 65), and `--keep FOLDER` for the runs' results, from which scripts/plot draws.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

from tables import ARGUMENTS, SOURCE, command, print_record, print_record_head, read_markers, scientific

MARKERS = {15: 15, 33: 30, 65: 60}
BOX, HEIGHT, SIDE = 0.51, 0.255, 0.5  # [m]
LIMITED = 65  # cells of the run that the limits are for
MOST_PENETRATION, MOST_ASYMMETRY_EARLY, MOST_ASYMMETRY_AT_REST = 0.1, 1e-6, 0.02  # [h], [side], [side]
EARLY = 0.4  # [s] before folds form


def asymmetry(places):
    """Largest difference of the cloth from its images by rotations and mirrors, over its side."""
    turned = np.stack([-places[..., 1], places[..., 0], places[..., 2]], axis=-1)
    images = [(turned, places[::-1].transpose(1, 0, 2)),
              (places * [-1, -1, 1], places[::-1, ::-1]),
              (places * [-1, 1, 1], places[::-1]),
              (places * [1, -1, 1], places[:, ::-1]),
              (places[..., [1, 0, 2]], places.transpose(1, 0, 2))]
    return max(np.abs(image - place).max() for image, place in images) / SIDE


def drape(cells, folder):
    """Runs inputs/drape.opts; returns times, places of the markers and the summary."""
    markers = MARKERS[cells]
    subprocess.run(command(2, "-options_file", SOURCE / "inputs" / "drape.opts", "-grid_cells",
                           ",".join([str(cells)] * 3), "-sheet_markers", markers, "-contact_distance",
                           HEIGHT / cells, "-output_dir", folder), check=True, stdout=subprocess.DEVNULL)
    time, places = read_markers(folder, axes=3)
    summary = json.loads((pathlib.Path(folder) / "summary.json").read_text())
    return time, places.reshape(len(time), markers, markers, 3), summary


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("cells", nargs="*", type=int, default=[15, 33, 65])
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args(ARGUMENTS)
    passed = True
    print_record_head("cells / markers", "at rest after [s]", "deepest marker [h]", f"asymmetry at {EARLY} s",
                      "at rest", "lowest place [m]", "largest stretch")
    for cells in options.cells:
        with tempfile.TemporaryDirectory(prefix="washfsi_") as temporary:
            folder = options.keep / f"drape_{cells}" if options.keep else temporary
            time, places, summary = drape(cells, folder)
        sheet = summary["cloths"]["sheet"]
        penetration = sheet["max_depth"] / (BOX / cells)
        early, late = (asymmetry(places[n]) for n in (np.argmin(np.abs(time - EARLY)), -1))
        within = (penetration <= MOST_PENETRATION and early <= MOST_ASYMMETRY_EARLY and
                  late <= MOST_ASYMMETRY_AT_REST)
        passed = passed and (within or cells != LIMITED)
        print_record(f"{cells}^3 / {MARKERS[cells]}^2", f"{time[-1]:.2f}",
                     f"{penetration:.3f}" if penetration > 0 else "outside", scientific(early, 1), scientific(late, 1),
                     f"{places[-1, ..., 2].min():.3f}", f"{100 * sheet['max_stretch']:.1f} %", arguments=[cells])
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
