# SPDX-License-Identifier: BSD-3-Clause
"""Thesis 6.2: its conclusions, each by comparisons of kept figures of its tables."""

from typing import NamedTuple

from thesis.checks import figure_of
from thesis.rows import NUMERICS


class Smaller(NamedTuple):
    """A claim that the figure of one row is smaller in size than that of another, of the same table if no other is named."""
    table: str
    smaller: str
    larger: str
    other_table: str = ""

    def found(self, kept, numerics):
        """Both figures in words and whether the claim holds; nothing where a figure is missing."""
        first = figure_of(kept, self.table, self.smaller, numerics)
        second = figure_of(kept, self.other_table or self.table, self.larger, numerics)
        if first is None or second is None:
            return ""
        return f"{first:.3g} {'<' if abs(first) < abs(second) else 'not <'} {second:.3g}"


class Conclusion(NamedTuple):
    """A conclusion in short, and what shows it."""
    number: int
    claim: str
    shown_by: tuple


CONCLUSIONS = (
    Conclusion(1, "In thick liquid the common centre of the cloths hardly moves, and they turn over slowly.",
               (Smaller("Figs. 5.5-8 to 12", "Re = 1.2e3", "Re = 1.2e4"), Smaller("Figs. 5.5-8 to 12", "Re = 1.2e2", "Re = 1.2e6"),
                Smaller("5.5.5.2", "Re = 1.2e2", "Re = 1.2e3"))),
    Conclusion(2, "More cloths move like one body; a narrower kernel makes them more mobile, and less stable.",
               (Smaller("5.5.5.3", "64 cloths", "32 cloths"), Smaller("5.5.5.3", "32 cloths", "Re = 1.2e3"),
                Smaller("Figs. 5.5-18, 19", "64 cloths", "64 cloths, half width 1.5 h"))),
    Conclusion(3, "Bending wants markers at least one cell apart; extension does not.",
               (Smaller("3.5-6", "in plane, ds/h = 0.29", "in plane, ds/h = 1.42"), Smaller("3.5-5", "case (b), ds/h = 1.18", "case (b), ds/h = 0.57"))),
    Conclusion(4, "A kernel four cells wide suits best; a narrower one is more accurate and less stable.",
               (Smaller("3.5-9", "case (b), half width 1.5 h", "case (b), half width 2 h"),
                Smaller("3.5-9", "case (b), half width 2 h", "case (b), half width 3 h"))),
    Conclusion(5, "Frequencies and bent shapes converge with the grid.",
               (Smaller("3.5-1", "case (a), mode 6/7, 65^3 / 30^2", "case (a), mode 6/7, 33^3 / 15^2"),
                Smaller("3.5-10", "129 x 129, 17 markers on a half", "65 x 65, 9 markers on a half"))),
    Conclusion(6, "The sharp mask is more accurate than the smooth one.", (
        Smaller("4.3-1", "sharp mask, 129 x 129", "smooth mask, 129 x 129", "4.3-2"),)),
    Conclusion(7, "With the sharp mask cloths come to the agitator, and into it; the smooth one keeps them away.",
               (Smaller("Fig. 5.4-3", "128 x 128, smooth mask", "128 x 128, sharp mask"),)),
    Conclusion(8, "A stiff plate flutters as it falls, the better the finer the grid.", ()),
    Conclusion(9, "With longer steps cloths go into the agitator.",
               (Smaller("5.5.5.1, depth", "dt*/4", "dt*"), Smaller("5.5.5.1, depth", "dt*/2", "dt*"))),
)


def print_page(kept, print_head, print_row):
    """Prints the conclusions with what the kept figures say of them."""
    print_head("", "conclusion", "shown by", "its numerics here", "ours today")
    for conclusion in CONCLUSIONS:
        for place, claim in enumerate(conclusion.shown_by or (None,)):
            name = f"{claim.table}: {claim.smaller} below {claim.larger}" if claim else "tables 3.5-12 and 3.5-13"
            words = [claim.found(kept, numerics) for numerics in NUMERICS] if claim else ["", ""]
            print_row(conclusion.number if not place else "", conclusion.claim if not place else "", name, *words)
