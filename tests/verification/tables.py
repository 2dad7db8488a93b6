# SPDX-License-Identifier: BSD-3-Clause
"""What all long tables share: the program, its results, and rows of Markdown."""

import pathlib
import sys

import h5py
import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "program"))
from support import CAVITY, SOURCE, command, read_columns  # noqa: E402, F401  (found by the line above)


def read_markers(folder, axes=2):
    """Returns the times of a run's frames and the markers' places in them, frame by marker by axis (two: the plane)."""
    with h5py.File(pathlib.Path(folder) / "cloth.h5") as file:
        frames = sorted(file["frames"].values(), key=lambda frame: frame.attrs["time"])
        return (np.array([float(frame.attrs["time"]) for frame in frames]),
                np.array([frame["position"][:, :axes] for frame in frames]))


def print_row(*words):
    """Prints a row of a Markdown table."""
    print("|", " | ".join(str(word) for word in words), "|", flush=True)


def print_head(*words):
    """Prints the first two rows of a Markdown table."""
    print_row(*words)
    print("|" + "---|" * len(words), flush=True)
