# SPDX-License-Identifier: BSD-3-Clause
"""Time series: fields on the grid, surfaces of bodies, and markers of cloths."""

import collections
import copy
import logging
import pathlib
from dataclasses import dataclass, field

import h5py
import numpy as np

from washfsi.errors import ResultsError
from washfsi.table import Table

POLYLINE, QUADRILATERAL = 2, 5  # XDMF's numbers of these types of cells


class ByName:
    """Lets what holds `data`, arrays by name, be asked for one."""

    data: dict

    def __getitem__(self, name):
        try:
            return self.data[name]
        except KeyError:
            raise KeyError(f"no dataset '{name}'; there are {', '.join(self.data)}") from None

    def __iter__(self):
        return iter(self.data)


@dataclass
class Frame(ByName):
    """The datasets of one moment, by name."""

    time: float  # [s]
    step: int
    data: dict = field(repr=False)
    units: dict = field(default_factory=dict)


def text_of(attribute):
    """Returns an attribute of an HDF5 file as text; empty if there is none."""
    return attribute.decode() if isinstance(attribute, bytes) else str(attribute or "")


def data_and_units(group):
    """Returns the datasets of a frame, and the unit that stands beside each."""
    return ({name: dataset[()] for name, dataset in group.items()},
            {name: text_of(dataset.attrs.get("unit")) for name, dataset in group.items()})


@dataclass(frozen=True)
class Head:
    """What is known of a frame before it is read."""

    time: float  # [s]
    step: int
    shapes: tuple  # of its datasets, with their names


def head_of(frames, name):
    """Returns the head of a frame; None where its file is missing, cut off or no frame."""
    try:
        group = frames[name]
        shapes = tuple(sorted((dataset, item.shape) for dataset, item in group.items()))
        return Head(float(group.attrs["time"]), int(group.attrs["step"]), shapes)
    except (KeyError, OSError, RuntimeError, ValueError, AttributeError):
        return None


def heads_of(frames):
    """Returns the heads of the frames by name, and the names of those that cannot be read, or hold other data than most."""
    heads = {name: head_of(frames, name) for name in frames}
    usual = collections.Counter(head.shapes for head in heads.values() if head).most_common(1)
    good = {name: head for name, head in sorted(heads.items()) if head and head.shapes == usual[0][0]}
    return good, sorted(heads.keys() - good.keys())


class Series:
    """A series of frames in an HDF5 file. The file is open only while something is read. Frames that are damaged are left out: a
    line of the log "washfsi" tells so, and `damaged` has their names."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        heads, self.damaged = self._read(lambda file: heads_of(file["frames"]))
        if not heads:
            raise ResultsError(f"{self.path} has no frames" + " that can be read" * bool(self.damaged))
        if self.damaged:
            places = ", ".join(f"{self.path.stem}/{name}.h5" for name in self.damaged)
            logging.getLogger("washfsi").warning("warning: %s: %s cannot be read, left out", self.path, places)
        self.names = list(heads)
        self.times = np.array([head.time for head in heads.values()])
        self.steps = np.array([head.step for head in heads.values()])

    def of_steps(self, steps):
        """Returns the series of those frames that were written in some steps."""
        chosen = np.flatnonzero(np.isin(self.steps, list(steps)))
        series = copy.copy(self)
        series.names = [self.names[number] for number in chosen]
        series.times, series.steps = self.times[chosen], self.steps[chosen]
        return series

    def _read(self, reader):
        """Returns what `reader` makes of the open file."""
        if not self.path.is_file():
            raise ResultsError(f"no file {self.path}")
        try:
            with h5py.File(self.path, "r") as file:
                return reader(file)
        except KeyError as error:
            raise ResultsError(f"{self.path}: {str(error).strip(chr(34))}") from None
        except OSError as error:
            raise ResultsError(f"cannot read {self.path}: {error}") from None

    def __len__(self):
        return len(self.names)

    def __iter__(self):
        return (self.frame(number) for number in range(len(self)))

    def nearest(self, time):
        """Returns the number of the frame nearest to a time [s]."""
        return int(np.argmin(np.abs(self.times - time)))

    def at(self, time):
        """Returns the frame nearest to a time [s]."""
        return self.frame(self.nearest(time))

    def frame(self, number=-1):
        """Returns the frame of this number, the last one unless told otherwise."""
        if not -len(self) <= number < len(self):
            raise ResultsError(f"no frame {number}; they run from 0 to {len(self) - 1}")
        name = self.names[number]
        data, units = self._read(lambda file: data_and_units(file["frames"][name]))
        return Frame(self.times[number], int(self.steps[number]), data, units)


class Fields(Series):
    """Fields in the cells of the grid, x last: flow or signed distances of bodies."""

    def __init__(self, path):
        super().__init__(path)
        def read_box(file):
            axes = [axis for axis in "xyz" if f"lower_{axis}" in file.attrs]
            return [[file.attrs[f"{name}_{axis}"] for axis in axes] for name in ("lower", "spacing")] + [
                self._cells(file["frames"][self.names[0]], len(axes))]
        lower, spacing, self.cells = self._read(read_box)
        self.lower, self.spacing = np.array(lower), np.array(spacing)

    @staticmethod
    def _cells(frame, dim):
        """Returns the numbers of cells, x first."""
        return next(iter(frame.values())).shape[:dim][::-1]

    @property
    def dim(self):
        """Returns the number of dimensions."""
        return len(self.lower)

    @property
    def upper(self):
        """Returns the upper corner of the box [m]."""
        return self.lower + self.spacing * self.cells

    def centres(self):
        """Returns the centres of the cells along each axis [m], x first."""
        return [low + step * (np.arange(count) + 0.5) for low, step, count in
                zip(self.lower, self.spacing, self.cells)]


class Surfaces(Series):
    """Surfaces of all bodies, in each frame the `position` of their vertices: `facets` joins these to triangles, in the plane
    to lines, and `body` is the number of each one's body in `bodies`."""

    def __init__(self, path):
        super().__init__(path)
        self.facets, self.body, names = self._read(
            lambda file: (file["topology"][()], file["body"][()].astype(int), text_of(file["body"].attrs["names"])))
        self.bodies = names.split(",")

    def facets_of(self, name):
        """Returns the facets of one body."""
        if name not in self.bodies:
            raise KeyError(f"no body '{name}'; there are {', '.join(self.bodies)}")
        return self.facets[self.body[self.facets[:, 0]] == self.bodies.index(name)]


class Markers(Series):
    """Markers of all cloths: `group` and `cloth` number them, `lines` joins them to polylines or quadrilaterals."""

    def __init__(self, path):
        super().__init__(path)
        self.group, self.cloth, topology = self._read(
            lambda file: (file["group"][()].astype(int), file["cloth"][()].astype(int), file["topology"][()]))
        self.lines = cells_of(topology)

    def table(self, number=-1):
        """Returns the markers of a frame as a table."""
        frame = self.frame(number)
        columns = {"group": self.group, "cloth": self.cloth}
        units = {"group": "-", "cloth": "-"}
        vectors = {"position": "xyz", "velocity": "uvw"}
        for dataset, names in vectors.items():
            for place, name in enumerate(names):
                columns[name], units[name] = frame[dataset][:, place], frame.units[dataset]
        numbers = {name: values for name, values in frame.data.items() if name not in vectors}
        return Table(columns | numbers, frame.units | units)


def cells_of(topology):
    """Splits a topology of XDMF's kind "Mixed" into its polylines and quadrilaterals."""
    cells, place = [], 0
    while place < len(topology):
        if topology[place] == POLYLINE:
            first, count = place + 2, topology[place + 1]
        elif topology[place] == QUADRILATERAL:
            first, count = place + 1, 4
        else:
            raise ResultsError(f"a cell of cloth is of type {topology[place]}, neither polyline nor quadrilateral")
        cells.append(topology[first:first + count])
        place = first + count
    return cells
