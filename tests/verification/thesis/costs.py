# SPDX-License-Identifier: BSD-3-Clause
"""What the rows without figures would cost: costs.csv beside this file, by row and numerics.

A cost is of the run that gives the row, or of the runs, joined by " + ". Rows that share a run name it alike. Where one is of fewer
cycles, the longest counts in a sum, since the others are its beginning.
"""

import csv
from typing import NamedTuple

from thesis.rows import FIGURES, NUMERICS

COSTS = FIGURES.with_name("costs.csv")
KEY = ("table", "what", "quantity", "numerics")
MEASURED = "measured"  # such a run was made, and took so long
EARLIER = "earlier"  # an earlier program's run took so long
STOPPED = "stopped"  # a run came a part of the way
ESTIMATED = "estimated"  # scaled from other runs
HOW = (MEASURED, EARLIER, STOPPED, ESTIMATED)
LONGEST = 6  # runs that are named


class Cost(NamedTuple):
    """Of a row with one of the numerics."""
    minutes: float  # by the clock
    cores: int
    how: str
    run: str
    reason: str  # what it is scaled from, and how

    def runs(self):
        """The names of its runs."""
        return self.run.split(" + ")

    def core_minutes(self):
        """What it would take on one core."""
        return self.minutes * self.cores

    def words(self):
        """As a table says it."""
        about = "" if self.how == MEASURED else "about "
        cores = "one core" if self.cores == 1 else f"{self.cores} cores"
        if self.minutes < 0.95:
            return f"not run: under a minute on {cores}"
        return f"not run: {about}{f'{self.minutes / 60:.1f} h' if self.minutes >= 59.5 else f'{self.minutes:.0f} min'} on {cores}"


def read():
    """All costs, by row and numerics."""
    with open(COSTS, encoding="utf-8", newline="") as file:
        return {tuple(row[name] for name in KEY): Cost(float(row["minutes"]), int(row["cores"]), row["how"], row["run"], row["reason"])
                for row in csv.DictReader(file)}


def write(costs):
    """Keeps them."""
    with open(COSTS, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([*KEY, *Cost._fields])
        writer.writerows([*key, f"{cost.minutes:.3g}", *cost[1:]] for key, cost in costs.items())


def by_run(costs):
    """Minutes on one core of each run once; of several runs of a row together where no other row has them."""
    found = {}
    for cost in sorted(costs, key=lambda cost: len(cost.runs())):
        lacking = [run for run in cost.runs() if run not in found]
        if len(cost.runs()) == 1:
            found[cost.run] = max(found.get(cost.run, 0), cost.core_minutes())
        elif lacking:
            found[" + ".join(lacking)] = cost.core_minutes() - sum(found.get(run, 0) for run in cost.runs())
    return found


def hours(costs):
    """What all of their runs take together, on one core."""
    return sum(by_run(costs).values()) / 60


def has_figure(row, numerics, kept):
    """Whether a figure of a row is kept."""
    return row.key(numerics) in kept


def print_page(chapters, kept, print_head, print_row):
    """Prints, of each chapter, how many cells have a figure, a cost, or words alone, and what the runs that are not made take."""
    costs = read()
    print_head("chapter", "rows", "figures, its numerics", "figures today", "costs, its numerics", "costs today", "words", "neither", "runs",
               "hours on one core, its numerics", "today")
    total = [0] * 7
    of_all = {numerics: [] for numerics in NUMERICS}
    for name, of_chapter in chapters.items():
        counts, lacking = cells(of_chapter, kept, costs)
        print_row(name, *counts, len({run for those in lacking.values() for cost in those for run in cost.runs()}),
                  *(f"{hours(those):.1f}" for those in lacking.values()))
        total = [one + other for one, other in zip(total, counts)]
        for numerics, those in lacking.items():
            of_all[numerics] += those
    print_row("**all**", *total, len({run for those in of_all.values() for cost in those for run in cost.runs()}),
              *(f"**{hours(those):.0f}**" for those in of_all.values()))
    both = [cost for those in of_all.values() for cost in those]
    longest = sorted(by_run(both).items(), key=lambda run: -run[1])[:LONGEST]
    print(f"\nAll that is not run takes about **{hours(both):.0f} h** on one core. The longest runs are these:\n")
    for run, spent in longest:
        print(f"- {run}: {spent / 60:.0f} h")


def cells(of_chapter, kept, costs):
    """How many rows there are, and of their cells those with figures and with costs, each by the numerics, with words alone, and with
    nothing; and the costs by the numerics."""
    figures = [sum(has_figure(row, numerics, kept) for row in of_chapter) for numerics in NUMERICS]
    lacking = {numerics: [costs[row.key(numerics)] for row in of_chapter if not has_figure(row, numerics, kept) and row.key(numerics) in costs]
               for numerics in NUMERICS}
    others = [not row.not_run or numerics in row.numerics for row in of_chapter for numerics in NUMERICS
              if not has_figure(row, numerics, kept) and row.key(numerics) not in costs]
    return (len(of_chapter), *figures, *map(len, lacking.values()), others.count(False), others.count(True)), lacking
