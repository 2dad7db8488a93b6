# SPDX-License-Identifier: BSD-3-Clause
"""Checks of the thesis's tables: a number that is made of figures of their rows lies between two limits.

A row says that a figure has not moved. A check says what must hold of figures however they move: an order of convergence, a
symmetry, that one figure falls where another rises. It is made of figures that have just been found, or of those kept.
"""

import math
from typing import Callable, NamedTuple

from thesis.rows import NUMERICS, as_text


def figure_of(kept, table, what, numerics, quantity="", part=0):
    """A figure of a row, the first if no other is named, of the first of its quantities if none is named; nothing if none is kept."""
    return next((found.figures[part] for (of_table, of_what, of_quantity, of_numerics), found in kept.items()
                 if (of_table, of_what, of_numerics) == (table, what, numerics) and quantity in ("", of_quantity)), None)


class Check(NamedTuple):
    """A claim on rows of a table."""
    table: str
    claim: str  # what the number is
    rows: tuple  # by what they are called in the table, with the table where it is another
    number: Callable  # takes their figures
    least: float = -math.inf
    most: float = math.inf
    quantity: str = ""  # of the rows, where the table has several
    numerics: tuple = NUMERICS
    miss: str = ""  # why it does not hold, where that is known
    part: int = 0  # of a row's figures
    thesis: str = ""  # the number that the thesis prints

    def named_rows(self):
        """The rows with their tables."""
        return [(self.table, row) if isinstance(row, str) else row for row in self.rows]

    def found(self, kept, numerics):
        """The number, nothing where a figure is missing."""
        figures = [figure_of(kept, *row, numerics, self.quantity, self.part) for row in self.named_rows()]
        return None if None in figures else self.number(figures)

    def is_told(self):
        """Whether the number has no limits and is only told."""
        return self.least == -math.inf and self.most == math.inf

    def holds(self, number):
        """Whether the number is between its limits; one that is none is not, unless it is only told."""
        return self.is_told() or self.least <= number <= self.most

    def limits(self):
        """Its limits in words."""
        words = [f"at least {self.least:g}"] if self.least > -math.inf else []
        words += [f"at most {self.most:g}"] if self.most < math.inf else []
        return " and ".join(words) or "no limit"

    def words(self, kept, numerics):
        """What a table of conclusions says of it; nothing where a figure is missing."""
        number = self.found(kept, numerics)
        return "" if number is None else f"{number:.3g} ({self.limits()}{'' if self.holds(number) else ': does not hold'})"


def distance(figure, reference, of_errors):
    """The size of a figure, or how far it is from a reference; infinite for an error of a run that failed."""
    return math.inf if of_errors and math.isnan(figure) else abs(figure - reference)


class Smaller(NamedTuple):
    """A claim that the figure of one row is smaller in size than that of another, of the same table if no other is named."""
    table: str
    smaller: str
    larger: str
    other_table: str = ""
    quantity: str = ""  # of the rows, where the tables have several
    part: int = 0  # of the rows' figures
    reference: float = 0  # it is the distances from this that are compared
    of_errors: bool = False  # or of stability: a run that failed is worse than any figure; of other figures it shows nothing
    numerics: tuple = NUMERICS
    miss: str = ""  # why it does not hold, where that is known

    def named_rows(self):
        """The rows with their tables."""
        return [(self.table, self.smaller), (self.other_table or self.table, self.larger)]

    @property
    def claim(self):
        """The claim in words."""
        other = f"{self.other_table}: " * bool(self.other_table)
        details = [f"{self.quantity}"] * bool(self.quantity) + [f"distances from {self.reference:g}"] * bool(self.reference)
        details += ["the figure in parentheses"] * bool(self.part)
        return f"{self.smaller} below {other}{self.larger}" + f" ({', '.join(details)})" * bool(details)

    def figures(self, kept, numerics):
        """Both figures, nothing where one is missing."""
        figures = [figure_of(kept, *row, numerics, self.quantity, self.part) for row in self.named_rows()]
        return None if None in figures else figures

    def found(self, kept, numerics):
        """The size of the first over that of the second; infinite where the first failed or the second is nothing."""
        figures = self.figures(kept, numerics)
        if not figures:
            return None
        first, second = (distance(figure, self.reference, self.of_errors) for figure in figures)
        return math.inf if math.isinf(first) or second == 0 else first / second

    def holds(self, number):
        """Whether the first is smaller."""
        return number < 1

    def limits(self):
        """Its limits in words."""
        return "below 1"

    def words(self, kept, numerics):
        """What a table of conclusions says of it; nothing where a figure is missing."""
        figures = self.figures(kept, numerics)
        return f" {'<' if self.holds(self.found(kept, numerics)) else 'not <'} ".join(as_text((figure,)) for figure in figures) if figures else ""


def steps_of(figures):
    """Each figure over the one before."""
    return [second / first for first, second in zip(figures, figures[1:])]


def named(rows):
    """Rows in words."""
    return "; ".join(rows)


def order(table, coarse, fine, refined, least=-math.inf, **others):
    """The order with which an error falls between two grids, the second finer by a ratio; only told if it has no limit."""
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
