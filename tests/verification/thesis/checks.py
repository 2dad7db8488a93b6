# SPDX-License-Identifier: BSD-3-Clause
"""Checks of the thesis's tables: a number that is made of figures of their rows lies between two limits.

A row says that a figure has not moved. A check says what must hold of figures however they move: an order of convergence, a
symmetry, that one figure falls where another rises. It is made of figures that have just been found, or of those kept.
"""

import math
from typing import Callable, NamedTuple

from thesis.rows import NUMERICS


def figure_of(kept, table, what, numerics, quantity=""):
    """The first figure of a row, of the first of its quantities if none is named; nothing if none is kept."""
    return next((found.figures[0] for (of_table, of_what, of_quantity, of_numerics), found in kept.items()
                 if (of_table, of_what, of_numerics) == (table, what, numerics) and quantity in ("", of_quantity)), None)


class Check(NamedTuple):
    """A claim on rows of a table."""
    table: str
    claim: str  # what the number is
    rows: tuple  # by what they are called in the table
    number: Callable  # takes their figures
    least: float = -math.inf
    most: float = math.inf
    quantity: str = ""  # of the rows, where the table has several
    numerics: tuple = NUMERICS
    miss: str = ""  # why it does not hold, where that is known

    def found(self, kept, numerics):
        """The number, nothing where a figure is missing."""
        figures = [figure_of(kept, self.table, what, numerics, self.quantity) for what in self.rows]
        return None if None in figures else self.number(figures)

    def holds(self, number):
        """Whether the number is between its limits; one that is none is not."""
        return self.least <= number <= self.most

    def limits(self):
        """Its limits in words."""
        words = [f"at least {self.least:g}"] if self.least > -math.inf else []
        return " and ".join(words + ([f"at most {self.most:g}"] if self.most < math.inf else []))


def steps_of(figures):
    """Each figure over the one before."""
    return [second / first for first, second in zip(figures, figures[1:])]


def named(rows):
    """Rows in words."""
    return "; ".join(rows)


def order(table, coarse, fine, refined, least, **others):
    """The order with which an error falls between two grids, the second finer by a ratio."""
    return Check(table, f"order from {coarse} to {fine}", (coarse, fine),
                 lambda figures: math.log(abs(figures[0] / figures[1])) / math.log(refined), least, **others)


def falls(table, rows, **others):
    """A figure that falls from each row to the next."""
    return Check(table, f"fall from row to row ({named(rows)}), each over the one before", tuple(rows),
                 lambda figures: max(steps_of(figures)), most=1, **others)


def rises(table, rows, **others):
    """A figure that rises from each row to the next."""
    return Check(table, f"rise from row to row ({named(rows)}), each over the one before", tuple(rows),
                 lambda figures: min(steps_of(figures)), least=1, **others)


def largest(table, quantity, rows, most, **others):
    """The largest size of a quantity over rows."""
    return Check(table, f"{quantity}{', largest' * (len(rows) > 1)} ({named(rows)})", tuple(rows),
                 lambda figures: max(map(abs, figures)), most=most, quantity=quantity, **others)
