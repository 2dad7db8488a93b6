# SPDX-License-Identifier: BSD-3-Clause
"""Tables with units, as the program writes them: a row of names, a row of units behind `# `, rows of values."""

import collections.abc
import csv
import pathlib

import numpy as np

from washfsi.errors import ResultsError


class Table(collections.abc.Mapping):
    """Columns by name, in the file's order; `units` has the unit of each."""

    def __init__(self, columns, units):
        self._columns = dict(columns)
        self.units = {name: units.get(name, "") for name in self._columns}

    def __getitem__(self, name):
        try:
            return self._columns[name]
        except KeyError:
            raise KeyError(f"no column '{name}'; there are {', '.join(self._columns)}") from None

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        return len(self._columns)

    @property
    def rows(self):
        """Returns the number of rows."""
        return len(next(iter(self._columns.values()), ()))

    @property
    def array(self):
        """Returns all columns as one structured array of numpy."""
        array = np.empty(self.rows, [(name, column.dtype) for name, column in self._columns.items()])
        for name, column in self._columns.items():
            array[name] = column
        return array

    def where(self, choice):
        """Returns the table of some rows: `choice` is a mask, a slice or a list of numbers."""
        return Table({name: column[choice] for name, column in self._columns.items()}, self.units)

    def __repr__(self):
        columns = ", ".join(f"{name} [{self.units[name]}]" for name in self._columns)
        return f"Table of {self.rows} rows: {columns}"


def column_of(texts):
    """Returns a column as numbers, or as texts where they are none."""
    try:
        return np.array(texts, float)
    except ValueError:
        return np.array(texts)


def read_table(path):
    """Reads one of the program's tables. A last row that is not complete, as of a run that goes on, is left out."""
    path = pathlib.Path(path)
    try:
        rows = list(csv.reader(path.read_text(encoding="utf-8").splitlines()))
    except FileNotFoundError:
        raise ResultsError(f"no file {path}") from None
    except (OSError, ValueError) as error:
        raise ResultsError(f"cannot read {path}: {error}") from None
    if len(rows) < 2 or not rows[1][0].startswith("#"):
        raise ResultsError(f"{path} is no table of washfsi: a row of names and a row of units are missing")
    names = [name.strip() for name in rows[0]]
    units = dict(zip(names, (unit.strip("# ") for unit in rows[1])))
    whole = [row for row in rows[2:] if len(row) == len(names)]
    return Table({name: column_of([row[place] for row in whole]) for place, name in enumerate(names)}, units)
