# SPDX-License-Identifier: BSD-3-Clause
"""Means over the azimuth and over the cycles of a machine, phase by phase: phases.h5."""

import pathlib
from dataclasses import dataclass, field

import h5py
import numpy as np

from washfsi.errors import ResultsError
from washfsi.series import ByName, text_of


@dataclass
class Phases(ByName):
    """What phases.h5 holds. Fields have the phase first, then z, then r; they are not a number where there was no liquid."""

    period: float  # [s]; 0 of a single phase of no period
    start: float  # time from which means are taken [s]
    axis: str  # of the machine: "x", "y" or "z"
    center: np.ndarray  # a place on it [m]
    data: dict = field(repr=False)
    units: dict = field(repr=False)

    def __len__(self):
        """Returns the number of phases."""
        return len(self.data["phase"])

    def span(self, phase):
        """Returns the begin and the end of a phase in the period [s]."""
        return phase * self.period / len(self), (phase + 1) * self.period / len(self)


def read_phases(path):
    """Returns the phase averages of a file."""
    path, datasets = pathlib.Path(path), {}
    if not path.is_file():
        raise ResultsError(f"no file {path}; runs with -statistics_phases write it")
    try:
        with h5py.File(path, "r") as file:
            file.visititems(lambda name, item: datasets.update({name: item}) if isinstance(item, h5py.Dataset) else None)
            return Phases(float(file.attrs["period"]), float(file.attrs["start"]), text_of(file.attrs["axis"]),
                          np.array([file.attrs[f"center_{axis}"] for axis in "xyz"]),
                          {name: item[()] for name, item in datasets.items()},
                          {name: text_of(item.attrs.get("unit")) for name, item in datasets.items()})
    except (OSError, KeyError) as error:
        raise ResultsError(f"cannot read {path}: {error}") from None
