# SPDX-License-Identifier: BSD-3-Clause
"""Rows and checks of the thesis's tables fail when they should, and name each other rightly. Runs nothing of the program."""

import argparse
import contextlib
import io
import math
import unittest
import unittest.mock

import results
import thesis_test
from thesis import checks, conclusions, costs, rows
from thesis.checks import Smaller
from thesis.costs import EARLIER, ESTIMATED, MEASURED, STOPPED, Cost
from thesis.rows import NUMERICS, THEIRS, TODAY, Kept, Row

EVERYTHING = argparse.Namespace(numerics=NUMERICS)


def kept(*figures, numerics=TODAY):
    """Kept figures of rows a, b, ... of a table."""
    return {("t", name, "error", numerics): Kept((figure,), 1.0, "") for name, figure in zip("abc", figures)}


def hold(check, figures):
    """Whether a check holds of figures, as a run of the tables finds."""
    with contextlib.redirect_stdout(io.StringIO()), unittest.mock.patch.object(thesis_test, "are_of_rows", lambda _: True):
        return thesis_test.assert_checks([check], figures, EVERYTHING)


class Checks(unittest.TestCase):
    def test_an_order_is_that_of_the_errors_whatever_their_sign(self):
        check = checks.order("t", "a", "b", 2, 1.9)
        self.assertAlmostEqual(check.found(kept(-0.4, 0.1), TODAY), 2)
        self.assertTrue(hold(check, kept(-0.4, 0.1)))
        self.assertFalse(hold(check, kept(0.4, 0.2)))

    def test_a_standard_deviation_may_have_a_limit_of_its_own(self):
        row = Row("t", "a", "stress", "", lambda _: 0, within=0.1, within_spread=0.5)
        self.assertLess(rows.moved(row, (1.05, 1.4), (1, 1)), 1)
        self.assertGreater(rows.moved(row, (1.15, 1), (1, 1)), 1)
        self.assertGreater(rows.moved(row, (1, 1.6), (1, 1)), 1)
        self.assertGreater(rows.moved(row._replace(within_spread=0), (1, 1.4), (1, 1)), 1)

    def test_trends_and_limits(self):
        self.assertTrue(hold(checks.falls("t", "abc"), kept(3, 2, 1)))
        self.assertFalse(hold(checks.falls("t", "abc"), kept(3, 1, 2)))
        self.assertTrue(hold(checks.rises("t", "abc"), kept(1, 2, 3)))
        self.assertFalse(hold(checks.rises("t", "abc"), kept(2, 1, 3)))
        self.assertTrue(hold(checks.largest("t", "error", "ab", 1), kept(0.5, -0.9)))
        self.assertFalse(hold(checks.largest("t", "error", "ab", 1), kept(0.5, -1.1)))

    def test_a_failed_run_does_not_hold(self):
        self.assertFalse(hold(checks.largest("t", "error", "a", 1), kept(math.nan)))

    def test_a_failed_run_is_a_larger_error_than_any_but_no_larger_figure(self):
        errors, figures = Smaller("t", "a", "b", of_errors=True), Smaller("t", "a", "b")
        self.assertTrue(hold(errors, kept(-0.1, 0.2)))
        self.assertFalse(hold(errors, kept(-0.3, 0.2)))
        self.assertTrue(hold(errors, kept(0.1, math.nan)))
        self.assertFalse(hold(errors, kept(math.nan, 0.1)))
        self.assertFalse(hold(errors, kept(math.nan, math.nan)))
        self.assertFalse(hold(figures, kept(0.1, math.nan)))
        self.assertEqual(errors.words(kept(0.1, math.nan), TODAY), "0.1 < failed")

    def test_distances_from_a_reference_compare(self):
        self.assertTrue(hold(Smaller("t", "a", "b", reference=0.35), kept(0.3, 0.2)))
        self.assertFalse(hold(Smaller("t", "a", "b", reference=0.35), kept(0.1, 0.3)))

    def test_a_number_without_limits_is_only_told(self):
        self.assertTrue(hold(checks.order("t", "a", "b", 2), kept(math.nan, 1)))

    def test_what_is_not_comparable_has_no_ratio_and_is_no_miss(self):
        row = Row("t", "a", "error", "56 % below", float, is_error=True)
        self.assertTrue(rows.is_missed(row, (60,)))
        self.assertFalse(rows.is_missed(row._replace(comparable=False), (60,)))
        self.assertEqual(thesis_test.ratio(row._replace(comparable=False), {row.key(TODAY): Kept((28,), 1, "")}), "")

    def test_a_miss_fails_when_it_is_none_any_more(self):
        check = checks.falls("t", "ab", miss="why")
        self.assertTrue(hold(check, kept(1, 2)))
        self.assertFalse(hold(check, kept(2, 1)))

    def test_nothing_is_said_of_what_is_missing_or_not_asked_for(self):
        self.assertIsNone(checks.falls("t", "ab").found(kept(1), TODAY))
        self.assertTrue(hold(checks.falls("t", "ab", numerics=(TODAY,)), kept(1, 2, numerics=THEIRS)))

    def test_rows_move(self):
        row = Row("t", "a", "error", "", float)
        self.assertLess(rows.moved(row, (1.04,), (1.0,)), 1)
        self.assertGreater(rows.moved(row, (1.06,), (1.0,)), 1)
        self.assertGreater(rows.moved(row, (0.94,), (1.0,)), 1)
        self.assertEqual(rows.moved(row, (math.nan,), (1.0,)), math.inf)
        self.assertEqual(rows.moved(row, (0.0,), (0.0,)), 0)
        self.assertLess(rows.moved(row._replace(slack=0.2), (0.1,), (0.0,)), 1)
        self.assertEqual(rows.moved(row._replace(within=math.inf), (2.0,), (1.0,)), 0)
        self.assertEqual(rows.moved(row._replace(within=math.inf), (math.nan,), (1.0,)), math.inf)

    def test_all_rows_have_names_of_their_own_and_all_checks_have_rows(self):
        names = [row.key(numerics) for row in thesis_test.selected(()) for numerics in row.numerics]
        self.assertEqual(len(names), len(set(names)))
        self.assertGreater(len(names), 300)
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            self.assertTrue(thesis_test.are_of_rows(thesis_test.selected_checks(()) + conclusions.claims()), printed.getvalue())

    def test_prefixes_select_tables_and_figures(self):
        tables = {row.table for row in thesis_test.selected(["3.5-1", "5.4"])}
        self.assertEqual(tables, {"3.5-1", "3.5-1, step", "3.5-1, lowest modes", "3.5-1, high modes", "5.4-3", "5.4-4", "Fig. 5.4-3", "Fig. 5.4-4"})


def cost(minutes, run="a", cores=1, how=ESTIMATED):
    """What a row would cost."""
    return Cost(minutes, cores, how, run, "as another")


class Costs(unittest.TestCase):
    def test_no_cell_is_empty(self):
        figures, known = rows.read_figures(), costs.read()
        empty = [row.key(numerics) for row in thesis_test.selected(()) for numerics in NUMERICS
                 if not thesis_test.cell(row, numerics, figures, known)]
        self.assertEqual(empty, [], "neither a figure nor a cost nor a reason")

    def test_costs_are_of_rows_without_figures_and_say_why(self):
        known, figures = costs.read(), rows.read_figures()
        of_rows = {row.key(numerics) for row in thesis_test.selected(()) for numerics in NUMERICS}
        self.assertEqual(known.keys() - of_rows, set())
        self.assertEqual(known.keys() & figures.keys(), set())
        for key, found in known.items():
            with self.subTest(key=key):
                self.assertIn(found.how, costs.HOW)
                self.assertIn(found.cores, (1, 2))
                self.assertGreater(found.minutes, 0)
                self.assertTrue(found.run and found.reason)

    def test_what_is_not_measured_is_about(self):
        self.assertEqual(cost(16.4, how=MEASURED).words(), "not run: 16 min on one core")
        for how in (EARLIER, STOPPED, ESTIMATED):
            self.assertEqual(cost(90, cores=2, how=how).words(), "not run: about 1.5 h on 2 cores")
        self.assertEqual(cost(0.1).words(), "not run: under a minute on one core")

    def test_a_row_prints_its_figure_then_its_cost_then_its_reason(self):
        row = Row("t", "a", "error", "", float, numerics=(THEIRS,), not_run="no mask")
        self.assertEqual(thesis_test.cell(row, TODAY, {}, {}), "no mask")
        self.assertEqual(thesis_test.cell(row, TODAY, {}, {row.key(TODAY): cost(5)}), "not run: about 5 min on one core")
        self.assertEqual(thesis_test.cell(row, TODAY, kept(3), {row.key(TODAY): cost(5)}), "3")
        self.assertEqual(thesis_test.cell(row, THEIRS, {}, {}), "")

    def test_a_stopped_run_says_how_long_it_would_take_and_on_how_many_cores(self):
        key, two = ("t", "a", "error", TODAY), ("t", "b", "error", TODAY)
        written = {}
        with unittest.mock.patch.object(costs, "read", lambda: {key: cost(5, "a run"), two: cost(9, "a run + another")}), \
                unittest.mock.patch.object(costs, "write", written.update):
            thesis_test.keep_cost(key, results.Unfinished(600, 2))
            self.assertEqual(written[key], Cost(10, 2, STOPPED, "a run", "by how far it came"))
            written.clear()
            thesis_test.keep_cost(two, results.Unfinished(600, 2))
            self.assertEqual(written, {})

    def test_shared_runs_count_once_and_the_longest_of_a_run_counts(self):
        self.assertAlmostEqual(costs.hours([cost(60), cost(60), cost(120)]), 2)
        self.assertAlmostEqual(costs.hours([cost(90, "a + b"), cost(60, "a"), cost(30, "b")]), 1.5)
        self.assertAlmostEqual(costs.hours([cost(90, "a + b"), cost(90, "a + b"), cost(60, "a")]), 1.5)
        self.assertAlmostEqual(costs.hours([cost(60, cores=2)]), 2)


if __name__ == "__main__":
    unittest.main()
