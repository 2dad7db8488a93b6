# SPDX-License-Identifier: BSD-3-Clause
"""The thesis's tables beside ours: with its own numerics, and with today's.

    thesis_test.py 3.5                    measures the rows of all tables whose numbers begin so, those that are kept
    thesis_test.py conclusions            runs nothing: asserts the thesis's conclusions (thesis/conclusions.py) on the kept figures
    thesis_test.py costs --page           runs nothing: prints what the rows without figures would cost (thesis/costs.py), by chapters
    thesis_test.py 3.5-1 --all            those too for which no figure is kept yet
    thesis_test.py 3.5-1 --new            only those for which none is kept yet
    thesis_test.py 3.5-1 --longest 20     stops runs that would take more minutes than that: they go on the next time
    thesis_test.py 3.5-1 --with theirs    with one of the numerics alone
    thesis_test.py 3.5 --minutes 20       those alone whose runs took no longer
    thesis_test.py 3.5-1 --keep           keeps what is found, in thesis/figures.csv, in the place of what was
    thesis_test.py 3.5-1 --page           runs nothing: prints the kept figures as docs/validation/thesis.md has them

Fails when a figure is farther from the kept one than its row allows, to the better or to the worse, or when a check of a table
(thesis/checks.py) does not hold of what was found and what is kept of the rest.
"""

import argparse
import math
import re
import shlex
import sys

import results
from tables import ARGUMENTS, print_head, print_row
from thesis import beam, cavity, conclusions, costs, couette, cylinder, drape, falling_plate, plate, rows, wash, wash2d
from thesis.rows import NUMERICS, THEIRS, TODAY, as_figures, as_text

SAID = {THEIRS: "with its numerics", TODAY: "today"}
CONCLUSIONS, COSTS = "conclusions", "costs"
TITLES = {cavity: "2.3 cavity", plate: "3.5.1 plate", beam: "3.5.2 beam", falling_plate: "3.5.3 falling plates", couette: "4.3.1 Couette flow",
          cylinder: "4.3.2 cylinder", drape: "4.3.3 drape", wash2d: "5.4 machine in two dimensions", wash: "5.5 machine in three dimensions"}
CHAPTERS = tuple(TITLES)


def selected(prefixes):
    """The rows of the tables and figures whose numbers begin so (3.5-1 is not the beginning of 3.5-10), all if there is no prefix."""
    return [row for chapter in CHAPTERS for row in chapter.rows() if is_of(row, prefixes)]


def selected_checks(prefixes):
    """Their checks; the conclusions where they are named."""
    of_chapters = [check for chapter in CHAPTERS if hasattr(chapter, "claims") for check in chapter.claims() if is_of(check, prefixes)]
    return of_chapters + (conclusions.claims() if CONCLUSIONS in prefixes else [])


def is_of(row, prefixes):
    """Whether the number of the table of a row or a check, or of the figure, begins with one of these, if there are any."""
    return not prefixes or any(re.match(r"(Figs?\. )?" + re.escape(prefix) + r"(?!\d)", row.table) for prefix in prefixes)


def ratio(row, kept):
    """Today's figure over the thesis's, in words."""
    ours, thesis = kept.get(row.key(TODAY)), row.printed()
    return f"{ours.figures[0] / thesis:.2f}" if ours and thesis and not math.isnan(ours.figures[0]) else ""


def cell(row, numerics, kept, known_costs):
    """What a table says of a row with one of the numerics: its figure, what it would cost, or why it cannot be."""
    if found := kept.get(row.key(numerics)):
        return as_text(found.figures)
    if cost := known_costs.get(row.key(numerics)):
        return cost.words()
    return "" if numerics in row.numerics else row.not_run


def minutes(row, kept):
    """How long the runs of a row took, with both numerics."""
    return ", ".join(f"{kept[row.key(numerics)].minutes:.1f}" for numerics in NUMERICS if row.key(numerics) in kept)


def print_checks(of_table, kept):
    """Prints the checks of a table: what they found with both numerics, what the thesis has, and their limits."""
    for number, check in enumerate(of_table):
        found = {numerics: check.found(kept, numerics) for numerics in check.numerics}
        words = [f"{'not yet' if value is None else as_text((value,))} {SAID[numerics]}" for numerics, value in found.items()]
        words += [f"{check.thesis} in the thesis"] * bool(check.thesis)
        print("\n" * (not number) + f"- {'Told' if check.is_told() else 'Checked'}: {check.claim}: {', '.join(words)} ({check.limits()}"
              f"{', an expected miss: ' * bool(check.miss)}{check.miss}).")


def print_page(chosen, checks_of, kept):
    """Prints the kept figures, a table for each of the thesis's, and its checks."""
    known_costs = costs.read()
    for table in dict.fromkeys(row.table for row in chosen):
        of_table = [row for row in chosen if row.table == table]
        print(f"\n**{table}**. {of_table[0].quantity}; `scripts/verification thesis {shlex.quote(table)}`\n")
        print_head("", "thesis", "its numerics here", "ours today", "ours over the thesis's", "commit", "minutes")
        for row in of_table:
            commits = dict.fromkeys(kept[row.key(numerics)].commit for numerics in NUMERICS if row.key(numerics) in kept)
            name = row.what if row.quantity == of_table[0].quantity else f"{row.what}, {row.quantity}"
            print_row(name, row.thesis, *(cell(row, numerics, kept, known_costs) for numerics in NUMERICS),
                      "larger: " * bool(row.miss) + ratio(row, kept), ", ".join(commits), minutes(row, kept))
        for reason in dict.fromkeys(row.miss for row in of_table if row.miss):
            print(f"\nExpected miss: {reason}")
        print_checks([check for check in checks_of if check.table == table], kept)


def judged(row, numerics, found, known):
    """What is wrong with figures that were found; nothing if they are as kept."""
    if known is None:
        return "not kept"
    if (off := rows.moved(row, found, known.figures)) > 1:
        return f"moved by {off:.1f} of what is allowed"
    if numerics == TODAY and rows.is_missed(row, found) != bool(row.miss):
        return "no longer a miss" if row.miss else "a miss that is not marked as one"
    return ""


def is_wanted(known, options):
    """Whether a row is to be measured of which these figures are kept, or none."""
    if options.new:
        return not known
    return known.minutes <= options.minutes if known else options.all


def measure(chosen, kept, options):
    """Measures rows; returns whether all figures are where they were, and the figures, those kept of rows that are not measured."""
    passed, figures = True, dict(kept)
    print_head("table", "row", "numerics", "thesis", "found", "kept", "minutes", "")
    for row in chosen:
        for numerics in row.numerics:
            known = kept.get(row.key(numerics))
            if numerics not in options.numerics or not is_wanted(known, options):
                continue
            try:
                found, spent = results.timed(lambda row=row, numerics=numerics: as_figures(row.measure(numerics)))
            except results.Unfinished as late:
                print_row(row.table, row.what, numerics, row.thesis, "", "", "", late)
                if options.keep:
                    keep_cost(row.key(numerics), late)
                passed = False
                continue
            wrong = judged(row, numerics, found, known)
            print_row(row.table, row.what, numerics, row.thesis, as_text(found), as_text(known.figures) if known else "",
                      f"{spent / 60:.1f}", wrong)
            passed = passed and not wrong
            figures[row.key(numerics)] = rows.Kept(found, spent / 60, results.program_identity())
            if options.keep:
                keep(row.key(numerics), figures[row.key(numerics)])
    return passed, figures


def are_of_rows(checks_of):
    """Whether all rows that checks name are there, with their numerics; prints those that are not."""
    known = {(row.table, row.what, numerics) for row in selected(()) for numerics in row.numerics}
    lost = [name for check in checks_of for row in check.named_rows() for numerics in check.numerics if (name := (*row, numerics)) not in known]
    for name in lost:
        print("\nA check names a row that there is not:", *name)
    return not lost


def assert_checks(checks_of, figures, options):
    """Prints the checks of which all figures are there; returns whether they hold, or do not where that is known."""
    passed = are_of_rows(checks_of)
    print()
    print_head("table", "check", "numerics", "limits", "found", "")
    for check in checks_of:
        for numerics in check.numerics:
            value = check.found(figures, numerics)
            if numerics not in options.numerics or value is None:
                continue
            wrong = ("no longer a miss" if check.miss else "beyond its limits") if check.holds(value) == bool(check.miss) else ""
            print_row(check.table, check.claim, numerics, check.limits(), f"{value:.3g}", wrong)
            passed = passed and not wrong
    return passed


def keep(key, found):
    """Keeps figures, in the order of the rows, without those of rows that there are no more."""
    kept = {**rows.read_figures(), key: found}
    keys = [row.key(numerics) for row in selected(()) for numerics in row.numerics]
    rows.write_figures({key: kept[key] for key in keys if key in kept})
    of_rows = {row.key(numerics) for row in selected(()) for numerics in NUMERICS}
    costs.write({key: cost for key, cost in costs.read().items() if key in of_rows and key not in kept})


def keep_cost(key, late):
    """Keeps how long the run of a row without figures would take, by how far it came; not of a row of several runs."""
    known = costs.read()
    run = known[key].run if key in known else ", ".join((key[0], key[1], key[3]))
    if " + " not in run:
        costs.write({**known, key: costs.Cost(late.seconds / 60, late.ranks, costs.STOPPED, run, "by how far it came")})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", nargs="*")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--new", action="store_true")
    parser.add_argument("--longest", type=float, default=math.inf)
    parser.add_argument("--with", dest="numerics", nargs="+", choices=NUMERICS, default=NUMERICS)
    parser.add_argument("--minutes", type=float, default=math.inf)
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("--page", action="store_true")
    options = parser.parse_args(ARGUMENTS)
    results.LONGEST["run"] = 60 * options.longest
    chosen, checks_of, kept = selected(options.tables), selected_checks(options.tables), rows.read_figures()
    if options.page:
        if options.tables == [CONCLUSIONS]:
            return conclusions.print_page(kept, print_head, print_row)
        if options.tables == [COSTS]:
            return costs.print_page({title: list(chapter.rows()) for chapter, title in TITLES.items()}, kept, print_head, print_row)
        return print_page(chosen, checks_of, kept)
    as_kept, figures = measure(chosen, kept, options)
    hold = assert_checks(checks_of, figures, options)
    return 0 if (as_kept and hold) or options.keep else 1


if __name__ == "__main__":
    sys.exit(main())
