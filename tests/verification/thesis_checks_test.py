# SPDX-License-Identifier: BSD-3-Clause
"""Rows and checks of the thesis's tables fail when they should, and name each other rightly. Runs nothing of the program."""

import argparse
import contextlib
import io
import math
import unittest
import unittest.mock

import thesis_test
from thesis import checks, conclusions, rows
from thesis.checks import Smaller
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


if __name__ == "__main__":
    unittest.main()
