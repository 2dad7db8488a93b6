# SPDX-License-Identifier: BSD-3-Clause
"""Rows of the thesis's tables: its figure, how to find ours, and what was found.

A row is measured with two numerics: the thesis's own ("theirs") and today's ("today"). The figures found are kept in
figures.csv beside this file. A test fails when a figure moves away from the kept one, be it to the better or to the worse.
"""

import csv
import math
import pathlib
import re
from typing import Callable, NamedTuple

from tables import SOURCE

FIGURES = pathlib.Path(__file__).with_name("figures.csv")
THEIRS, TODAY = "theirs", "today"
NUMERICS = (THEIRS, TODAY)
WITHIN = 0.05  # of a kept figure, unless a row says otherwise


def case_file(numerics, name):
    """The options of a case with the thesis's numerics, or with today's."""
    return SOURCE / "inputs" / "thesis" / ("" if numerics == THEIRS else "today") / f"{name}.opts"


def first_number(text):
    """The first figure that the thesis prints; none where it says that the run diverged or was unstable."""
    found = re.match(r"-?\d[\d.]*(e-?\d+)?", text)
    return float(found[0]) if found and "stable" not in text else None


class Row(NamedTuple):
    """A figure, or several, of a table of the thesis."""
    table: str  # of the thesis: 3.5-1, conclusion 7
    what: str  # in the table
    quantity: str  # with its unit
    thesis: str  # as printed
    measure: Callable  # takes the numerics; returns a figure or several, NaN for a run that failed
    numerics: tuple = NUMERICS  # it is measured with these
    not_run: str = ""  # why it cannot be with the others; what it would cost is in costs.csv
    within: float = WITHIN  # infinite: the kept figure is only told, and checks judge (checks.py)
    within_spread: float = 0  # the same of its standard deviation, the second figure; 0: as the first
    slack: float = 0  # it may move by so much however small it is
    is_error: bool = False  # the thesis's figure is an error itself: smaller is better
    miss: str = ""  # why ours is worse, where it is
    comparable: bool = True  # no ratio is told where the thesis's figure is of something else: a percentage, another grid, step or reference, a misprint

    def printed(self):
        """The thesis's figure that ours compares with; none where there is no such figure."""
        return first_number(self.thesis) if self.comparable else None

    def key(self, numerics):
        """By which its figures are kept."""
        return self.table, self.what, self.quantity, numerics


class Kept(NamedTuple):
    """Figures that were found."""
    figures: tuple
    minutes: float
    commit: str


def as_figures(value):
    """One figure or several as a tuple."""
    return tuple(map(float, value)) if hasattr(value, "__len__") else (float(value),)


def as_text(figures):
    """Figures as a table prints them: the second in parentheses, a standard deviation."""
    words = ["failed" if math.isnan(figure) else f"{figure:.3g}" for figure in figures]
    return words[0] if len(words) == 1 else f"{words[0]} ({', '.join(words[1:])})"


def read_figures():
    """All figures that are kept, by row and numerics."""
    if not FIGURES.is_file():
        return {}
    with open(FIGURES, encoding="utf-8", newline="") as file:
        return {(row["table"], row["what"], row["quantity"], row["numerics"]):
                Kept(tuple(map(float, row["figures"].split())), float(row["minutes"]), row["commit"])
                for row in csv.DictReader(file)}


def write_figures(kept):
    """Keeps figures."""
    with open(FIGURES, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["table", "what", "quantity", "numerics", "figures", "minutes", "commit"])
        for key, (figures, minutes, commit) in kept.items():
            writer.writerow([*key, " ".join(f"{figure:.6g}" for figure in figures), f"{minutes:.1f}", commit])


def moved(row, figures, kept):
    """How far figures are from those kept, over what the row allows; infinite where one failed and the other did not."""
    if len(figures) != len(kept):
        return math.inf
    largest = 0.0
    for place, (found, known) in enumerate(zip(figures, kept)):
        within = row.within_spread or row.within if place else row.within
        if math.isnan(found) != math.isnan(known):
            return math.inf
        if not math.isnan(found) and within < math.inf:
            largest = max(largest, abs(found - known) / max(within * abs(known), row.slack, 1e-12))
    return largest


def is_missed(row, figures):
    """Whether ours is a larger error than the thesis's, or failed where the thesis's run did not; never of other figures."""
    thesis = row.printed()
    return row.is_error and thesis is not None and not abs(figures[0]) <= abs(thesis)
