# SPDX-License-Identifier: BSD-3-Clause
"""What the tables of the three-dimensional wash share: the agitation cycle, and where the cloths were."""

import numpy as np

from tables import read_columns

CYCLE = np.pi / 2  # of the agitator of inputs/thesis/wash33.opts [s]
STRESSES = ("ss", "rr", "sr")


def read_centers(folder):
    """Returns the times of a run's tracks.csv and the cloths' centres, cloth by axis by time [m]."""
    tracks = read_columns(folder / "tracks.csv")
    centers = np.array([tracks[name] for name in tracks if name.startswith("towel_")])
    return tracks["time"], centers.reshape(-1, 3, len(tracks["time"]))
