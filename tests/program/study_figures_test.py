# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/study makes of results: the tables, the sentences and the picture. The results are made up."""

import argparse
import csv
import itertools
import json
import signal
import subprocess
import sys
import unittest
import unittest.mock

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text

from study_fixtures import write_run, write_study
from support import SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "python"))
from washfsi.options_file import read_options  # noqa: E402
from washfsi.study import refinement, verdict  # noqa: E402
from washfsi.study.command import jobs_and_ranks  # noqa: E402
from washfsi.study.runs import Run, all_words, folder_of, seed_words  # noqa: E402
from washfsi.study.scheduler import Scheduler  # noqa: E402
from washfsi.study.tables import figures_of  # noqa: E402
from washfsi.study.tradeoff import draw_tradeoff  # noqa: E402

ALIKE = {"round": (10, 0.02, 2e5), "square": (10, 0.02, 2e5)}
APART = {"gentle": (10, 0.02, 2e5), "rough": (14, 0.03, 4e5)}


class Tables(ProgramTest):
    def study(self, designs, seeds, *words):
        """Writes a study and its table; returns what it prints."""
        files = write_study(self.folder, designs, seeds)
        outcome = subprocess.run([SOURCE / "scripts" / "study", "--table", "--output", self.folder / "study", *words, *files],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        return outcome.stdout

    def rows(self, name):
        """Returns the rows of one of the tables."""
        with open(self.folder / "study" / name, encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_means_and_spreads_are_those_over_the_seeds(self):
        self.study(APART, 3)
        runs, (gentle, rough) = self.rows("runs.csv"), self.rows("study.csv")
        self.assertEqual([(run["case"], run["seed"]) for run in runs],
                         [(case, str(seed)) for case in APART for seed in (1, 2, 3)])
        for case, row in (("gentle", gentle), ("rough", rough)):
            values = [float(run["agitator_work [J]"]) for run in runs if run["case"] == case]
            self.assertAlmostEqual(float(row["agitator_work [J]"]), np.mean(values), places=4)
            self.assertAlmostEqual(float(row["agitator_work spread [J]"]), np.std(values, ddof=1), places=3)
            self.assertEqual((row["seeds"], row["work [J]"]), ("3", row["agitator_work [J]"]))
        self.assertLess(float(gentle["water_shear [Pa]"]), float(rough["water_shear [Pa]"]))

    def test_every_figure_is_in_the_table_and_headlines_in_the_page(self):
        self.study(APART, 2)
        names = self.rows("study.csv")[0]
        for name in ("agitator_work [J]", "drum_work [J]", "agitator_power_mean [W]", "relative_speed [m/s]", "turns [-]"):
            self.assertIn(name, names)
        page = (self.folder / "study" / "study.md").read_text(encoding="utf-8")
        self.assertIn("| work [J] | relative_speed [m/s] | water_shear [Pa] | stress [Pa] | turns [-] |", page)
        self.assertNotIn("agitator_power_mean", page)
        self.assertIn("Welch", page)

    def test_says_what_differs_and_what_does_not(self):
        printed = self.study(APART, 3)
        self.assertRegex(printed, r"Stress of the cloth: gentle \(.* Pa\) and rough \(.* Pa\) differ by more than their spread "
                                  r"over 3 seeds \(Welch's t")
        self.assertRegex(printed, r"Turns of the cloths: .* are not told apart")
        self.assertTrue((self.folder / "study" / "study.png").is_file())

    def test_one_seed_decides_nothing(self):
        printed = self.study(APART, 1)
        self.assertEqual(printed.count("nothing can be decided"), 5)
        self.assertNotIn("differ by", printed)

    def test_without_figures_it_says_so(self):
        (self.folder / "short.opts").touch()
        write_run(self.folder / "study" / "short", cycles=1, agitator_work=1)
        printed = subprocess.run([SOURCE / "scripts" / "study", "--table", "--output", self.folder / "study",
                                  self.folder / "short.opts"], capture_output=True, text=True, check=True).stdout
        self.assertIn("No finished run has figures", printed)
        self.assertFalse((self.folder / "study" / "study.png").exists())

    def test_unfinished_runs_do_not_count(self):
        files = write_study(self.folder, APART, 3)
        path = self.folder / "study" / "rough" / "seed_3" / "summary.json"
        path.write_text(json.dumps(json.loads(path.read_text()) | {"status": "stopped", "time": 0.1}))
        subprocess.run([SOURCE / "scripts" / "study", "--table", "--output", self.folder / "study", *files],
                       stdout=subprocess.DEVNULL, check=True)
        rough = self.rows("study.csv")[1]
        self.assertEqual((rough["seeds"], rough["status"], rough["time_s"]), ("2", "2 of 3 finished", "6"))

    def test_figures_of_a_body_are_none_of_a_group(self):
        write_run(self.folder / "run", towel_rack_work=3.0, towel_stress=2e5)
        figures = figures_of(Run("case", self.folder / "case.opts", self.folder / "run"), "towel")
        self.assertEqual(set(figures), {"work", "towel_rack_work", "stress"})

    def test_the_work_is_that_of_every_design_whatever_its_groups(self):
        loads = {"a": ["mat", "sock"], "b": ["sock"], "c": []}
        figures = {"mat": {"mat_stress": 1e5}, "sock": {"sock_stress": 2e5}}
        for (case, groups), grid in itertools.product(loads.items(), ("", "_refined_2")):
            (self.folder / f"{case}.opts").touch()
            groups = groups[-1:] if grid else groups
            for seed in (1, 2):
                write_run(self.folder / "study" / (case + grid) / f"seed_{seed}", cloths=groups, agitator_work=10.0 * ord(case) + seed,
                          **{name: value + seed for group in groups for name, value in figures[group].items()})
        files = [self.folder / f"{case}.opts" for case in loads]
        printed = subprocess.run([SOURCE / "scripts" / "study", "--table", "--refine", "2", "--output", self.folder / "study", *files],
                                 capture_output=True, text=True, check=True).stdout
        self.assertIn("Work of the bodies in a cycle, cells x 1: ", printed)
        self.assertRegex(printed, r"Work of the bodies in a cycle: may be ranked\. On both grids b > a; c > a; c > b\.")
        self.assertIn("Stress of the cloth (sock), cells x 2: a (", printed)
        self.assertRegex(printed, r"\| Stress of the cloth \(sock\) \[Pa\] \| b \| [^|]+ \| [^|]+ \| [^|]+ \(order 1\) \|")


class Changes(ProgramTest):
    def test_a_run_begun_with_other_options_does_not_go_on(self):
        files = write_study(self.folder, APART, 1)
        begun, new = (self.folder / "study" / name for name in APART)
        for path in (begun / "summary.json", *new.iterdir()):
            path.unlink()
        (begun / "study.opts").write_text("-cloths mat\n")
        (begun / "checkpoint.h5").touch()
        outcome = subprocess.run([SOURCE / "scripts" / "study", "--program", "/bin/true", "--output", self.folder / "study", *files],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(outcome.returncode, 1, outcome.stderr)
        self.assertIn(f"study: gentle was begun with other options than it has now; delete {begun} to run it anew.\n", outcome.stdout)
        self.assertEqual((begun / "study.opts").read_text(), "-cloths mat\n")
        self.assertEqual((new / "study.opts").read_text(), "-cloths towel\n")


class Verdict(unittest.TestCase):
    def test_student_s_distribution(self):
        for t, freedom, chance in ((12.706, 1, 0.05), (4.303, 2, 0.05), (2.776, 4, 0.05), (4.604, 4, 0.01),
                                   (2.042, 30, 0.05), (0, 5, 1)):  # from any table
            self.assertAlmostEqual(verdict.two_sided_chance(t, freedom), chance, delta=1e-4)

    def test_welch(self):
        t, freedom = verdict.welch([19.8, 20.4, 19.6, 17.8, 18.5, 18.9, 18.3, 18.9, 19.5, 22.0],
                                   [28.2, 26.6, 20.1, 23.3, 25.2, 22.1, 17.7, 27.6, 20.6, 13.7,
                                    23.2, 17.5, 20.6, 18.0, 23.9, 21.6, 24.3, 20.4, 24.0, 13.2])  # Wikipedia's example 3
        self.assertAlmostEqual(t, -2.22, delta=0.005)
        self.assertAlmostEqual(freedom, 24.5, delta=0.05)

    def test_holm(self):
        for raised, wanted in zip(verdict.holm([0.01, 0.04, 0.03, 0.005]), [0.03, 0.06, 0.06, 0.02]):
            self.assertAlmostEqual(raised, wanted)

    def test_designs_that_are_alike_are_rarely_told_apart(self):
        random = np.random.default_rng(5)
        for designs in (2, 6):
            false = 0
            for _ in range(400):
                samples = {str(number): list(random.normal(10, 1, 3)) for number in range(designs)}
                false += any(test.differ for test in verdict.compare(samples))
            self.assertLess(false, 400 * 0.08)

    def test_one_far_design_of_many_is_found(self):
        random = np.random.default_rng(5)
        samples = {name: list(random.normal(13 if name == "f" else 10, 0.3, 3)) for name in "abcdefgh"}
        far = [test for test in verdict.compare(samples) if test.differ]
        self.assertEqual({"f" in (test.first, test.second) for test in far}, {True})
        self.assertEqual(len(far), 7)
        text = verdict.sentence("Work", samples, "J")
        self.assertIn("7 of the 28 pairs", text)
        self.assertIn("From a, the first, f differs", text)

    def test_seeds_that_change_nothing_decide_nothing(self):
        self.assertIn("seeds change nothing", verdict.sentence("Work", {"a": [1.0, 1.0], "b": [2.0, 2.0]}, "J"))


class Refinement(ProgramTest):
    def test_the_order_of_three_grids_is_found(self):
        for order in (0.5, 1, 2, 3):
            for factors in ((1, 1.5, 2.25), (1, 2, 3), (2, 2.5, 4)):
                values = [3 - 0.7 * factor ** -order for factor in factors]
                self.assertAlmostEqual(refinement.order_of(factors, values), order, places=6)
        self.assertIsNone(refinement.order_of((1, 2, 4), [1, 2, 1.5]))
        self.assertIsNone(refinement.order_of((1, 2, 4), [1, 1.1, 2.5]))

    def test_a_figure_of_first_order_is_continued_to_its_limit(self):
        found = refinement.estimate({1: [5 + 2.0], 1.5: [5 + 2 / 1.5]})
        self.assertAlmostEqual(found.value, 5)
        self.assertAlmostEqual(found.band, 2 / 1.5)
        self.assertFalse(found.observed)
        second = refinement.estimate({factor: [5 + 2 * factor ** -2.0] for factor in (1, 1.5, 3)})
        self.assertAlmostEqual(second.value, 5)
        self.assertTrue(second.observed)

    def test_the_band_holds_the_spread_over_seeds(self):
        random, misses = np.random.default_rng(3), 0
        for _ in range(300):
            found = refinement.estimate({factor: list(random.normal(5, 0.3, 4)) for factor in (1.0, 2.0)})
            misses += abs(found.value - 5) > found.band
        self.assertLess(misses, 300 * 0.15)

    def test_only_pairs_that_differ_alike_on_both_grids_are_ranked(self):
        low, high, higher = ([value + step for step in (-0.01, 0, 0.01)] for value in (1, 2, 3))
        coarse = {"a": low, "b": high, "c": higher}
        told = refinement.ranking("Work", [coarse, {"a": low, "b": high, "c": higher}])
        self.assertEqual(told, "Work: may be ranked. On both grids b > a; c > a; c > b.")
        self.assertEqual(refinement.ranking("Work", [coarse, {"a": low, "b": higher, "c": high}]),
                         "Work: may not be ranked. On the finer grid, other than on the coarser, b > c.")
        self.assertIn("may be ranked in part. On both grids b > a; c > a; not told apart on one of them at least: b > c",
                      refinement.ranking("Work", [coarse, {"a": low, "b": [2.1, 2.5, 2.9], "c": [2.0, 2.4, 2.9]}]))
        self.assertIn("No pair", refinement.ranking("Work", [coarse, {name: [1.0, 2.0, 3.0] for name in "abc"}]))
        self.assertIn("the order is the same", refinement.ranking("Work", [{"a": [1], "b": [2]}, {"a": [1], "b": [3]}]))
        self.assertIn("may not be ranked. The order is b > a on the coarser grid and a > b",
                      refinement.ranking("Work", [{"a": [1], "b": [2]}, {"a": [4], "b": [3]}]))

    def test_designs_that_one_grid_lacks_are_named(self):
        low, high = [0.99, 1, 1.01], [1.99, 2, 2.01]
        told = refinement.ranking("Work", [{"a": low, "b": high, "c": low}, {"d": low, "a": low, "b": high}])
        self.assertEqual(told, "Work: may be ranked. On both grids b > a. On one grid only: c, d.")
        self.assertEqual(refinement.ranking("Work", [{"a": low, "b": high}, {"a": low}]),
                         "Work: fewer than two designs have this figure on both grids. On one grid only: b.")

    def test_designs_whose_seeds_change_nothing_are_not_taken_for_one_seed(self):
        low, high, still = [0.99, 1, 1.01], [1.99, 2, 2.01], [3 * (1 + 1e-15), 3, 3]
        told = refinement.ranking("Work", [{"a": low, "b": high, "c": still}] * 2)
        self.assertEqual(told, "Work: may be ranked. On both grids b > a; c > a; c > b.")
        self.assertEqual(refinement.ranking("Work", [{"a": low, "b": high}, {"a": still, "b": [2.0, 2.0]}]),
                         "Work: seeds change nothing in a, b. The spread is not known, so nothing can be decided.")
        self.assertIn("One seed", refinement.ranking("Work", [{"a": still, "b": [2.0, 2.0]}, {"a": still, "b": [2.0]}]))

    def test_a_study_on_two_grids_says_which_figures_keep_their_ranking(self):
        files = write_study(self.folder, APART, 3)
        write_study(self.folder, {"gentle": (8, 0.04, 1e5), "rough": (10, 0.03, 2e5)}, 3, grid="_refined_1.5")
        outcome = subprocess.run([SOURCE / "scripts" / "study", "--table", "--refine", "1.5", "--output", self.folder / "study",
                                  *files], capture_output=True, text=True, check=False)
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        for text in ("Stress of the cloth: may be ranked. On both grids rough > gentle.",
                     "Speed of the water along the cloth: may not be ranked. On the finer grid, other than on the coarser, gentle > rough.",
                     "Turns of the cloths: may not be ranked. No pair", "Work of the bodies in a cycle, cells x 1.5: gentle"):
            self.assertIn(text, outcome.stdout)
        page = (self.folder / "study" / "study.md").read_text(encoding="utf-8")
        self.assertIn("| figure | design | cells x 1 | cells x 1.5 | estimate |", page)
        self.assertRegex(page, r"\| Work of the bodies in a cycle \[J\] \| gentle \| .* \| .* \| 4\.\d+ ± .* \(order 1\) \|")
        self.assertNotIn("| Speed of the water along the cloth", page)  # taken 1.5 cells from it
        with open(self.folder / "study" / "study.csv", encoding="utf-8") as file:
            self.assertEqual([row["case"] for row in csv.DictReader(file)],
                             ["gentle", "rough", "gentle_refined_1.5", "rough_refined_1.5"])

    def refuse(self, told, *words):
        """Holds the line in which a study is refused."""
        outcome = subprocess.run([SOURCE / "scripts" / "study", "--table", "--output", self.folder / "study", *words],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(outcome.returncode, 2, outcome.stdout)
        self.assertIn(told, outcome.stderr)
        self.assertNotIn("Traceback", outcome.stderr)

    def test_wrong_factors_are_told_in_a_line(self):
        files = write_study(self.folder, ALIKE, 1)
        for factor, told in (("0.5", "must be numbers above 1"), ("x", "must be numbers above 1"), ("2", "cannot be given together")):
            self.refuse(told, "--refine", factor, *files, "--", "-refine", "2")
        files[1].write_text("-Refine 2\n")
        self.refuse(f"{files[1]}: --refine and -refine cannot be given together", "--refine", "1.5", *files)

    def test_two_grids_in_one_folder_are_told_in_a_line(self):
        files = [self.folder / name for name in ("wash.opts", "wash_refined_1.5.opts")]
        for file in files:
            file.touch()
        self.refuse("two cases are named wash_refined_1.5", "--refine", "1.5", *files)


class Seeds(ProgramTest):
    def test_the_seed_of_every_group_changes(self):
        (self.folder / "base.opts").write_text("-cloths long,short,mat\n-cloths_seed 7 # of mat\n-long_seed 3\n")
        case = self.folder / "case.opts"
        case.write_text(f"-options_file {self.folder / 'base.opts'}\n")
        self.assertEqual(seed_words(case, ["-short_seed", "5"], 1), [])
        self.assertEqual(seed_words(case, ["-short_seed", "5"], 3),
                         ["-long_seed", "5", "-short_seed", "7", "-mat_seed", "9"])

    def test_a_seed_that_is_no_number_is_told_in_a_line(self):
        case = self.folder / "case.opts"
        case.write_text("-cloths towel\n-towel_seed one\n")
        outcome = subprocess.run([SOURCE / "scripts" / "study", "--table", "--seeds", "2", "--output", self.folder / "study", case],
                                 capture_output=True, text=True, check=False)
        self.assertEqual((outcome.returncode, outcome.stderr), (2, "study: the seed of towel, one, is not a whole number\n"))

    def test_the_first_seed_stays_where_it_was_run(self):
        case = self.folder / "case"
        self.assertEqual([folder_of(case, 1, seeds) for seeds in (1, 3)], [case, case / "seed_1"])
        case.mkdir()
        (case / "run.log").touch()
        self.assertEqual([folder_of(case, seed, 3) for seed in (1, 2)], [case, case / "seed_2"])
        (case / "seed_1").mkdir()
        self.assertEqual([folder_of(case, 1, seeds) for seeds in (1, 3)], [case / "seed_1"] * 2)

    def test_options_are_read_as_the_program_reads_them(self):
        (self.folder / "a #1.opts").write_text("-CLOTHS_seed 4\n-cloths 'Long,short' # two\n-Long_file \"my #2 towel\"\n"
                                               "-bodies \"\"#none\n")
        case = self.folder / "case.opts"
        case.write_text(f"-options_file '{self.folder / 'a #1.opts'}'\n--long_SEED 3\n")
        words = ["-CLOTHS_seed", "4", "-cloths", "Long,short", "-Long_file", "my #2 towel", "-bodies", "", "--long_SEED", "3"]
        self.assertEqual(all_words(case, []), words)
        self.assertEqual(seed_words(case, [], 2), ["-Long_seed", "4", "-short_seed", "5"])
        run = Run("case", case, self.folder)
        run.record.write_text(run.options())
        self.assertFalse(run.changed())
        self.assertEqual(read_options(run.record), dict(zip([name.lstrip("-") for name in words[::2]], words[1::2])))


class Jobs(unittest.TestCase):
    def test_runs_at_a_time_are_as_many_as_there_are_cores_for(self):
        with unittest.mock.patch("os.sched_getaffinity", return_value=set(range(8))):
            for jobs, ranks, runs, wanted in ((None, None, 20, (8, 1)), (None, 3, 20, (2, 3)), (None, None, 1, (1, 2)),
                                              (4, None, 20, (4, 1)), (4, 2, 20, (4, 2)), (1, None, 20, (1, 2)),
                                              (None, 16, 20, (1, 16))):
                options = argparse.Namespace(jobs=jobs, ranks=ranks)
                self.assertEqual(jobs_and_ranks(options, runs), wanted)


class Errors(ProgramTest):
    def test_an_error_stops_all_runs(self):
        def ended():
            raise RuntimeError("no space left")
        for number in (signal.SIGINT, signal.SIGTERM):
            self.addCleanup(signal.signal, number, signal.getsignal(number))
        runs = [Run(name, self.folder / f"{name}.opts", self.folder / name) for name in ("short", "long")]
        launchers = [subprocess.Popen(["sh", "-c", f"sleep {seconds}; true"], stderr=subprocess.DEVNULL) for seconds in (0.5, 60)]
        self.addCleanup(lambda: [launcher.kill() for launcher in launchers])
        with unittest.mock.patch("washfsi.study.scheduler.launch", side_effect=launchers), self.assertRaisesRegex(RuntimeError, "space"):
            Scheduler("washfsi", 1, 2, ended).work(runs)
        self.assertIsNotNone(launchers[1].poll())


class Picture(unittest.TestCase):
    def test_labels_do_not_overlap(self):
        random = np.random.default_rng(2)
        designs = {f"design_{number}": {("work", "J"): list(10 + 0.1 * random.standard_normal(3)),
                                        ("relative_speed", "m/s"): list(1 + 0.01 * random.standard_normal(3)),
                                        ("stress", "Pa"): list(2e5 + 1e3 * random.standard_normal(3))}
                   for number in range(12)} | {"far": {("work", "J"): [20.0, 20.2], ("relative_speed", "m/s"): [2.0, 2.1],
                                                       ("stress", "Pa"): [4e5, 4.1e5]}}
        figure, panels = draw_tradeoff({"towel": designs}, 3)
        canvas = FigureCanvasAgg(figure)
        canvas.draw()
        self.assertEqual([len(labels) for labels in panels], [13, 13])
        for labels in panels:
            boxes = {label.get_text(): Text.get_window_extent(label, canvas.get_renderer()) for label in labels}
            for (name, first), (other, second) in itertools.combinations(boxes.items(), 2):
                self.assertFalse(first.overlaps(second), f"{name} on {other}")


if __name__ == "__main__":
    unittest.main()
