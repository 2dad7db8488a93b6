# SPDX-License-Identifier: BSD-3-Clause
"""scripts/report writes pages whose numbers are those of the run, that need nothing but themselves, and work in a browser."""

import itertools
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np
from matplotlib.image import imread

import browser
from support import SOURCE, WASH, ProgramTest, read_columns, run

sys.path.insert(0, str(SOURCE / "python"))
from washfsi import Results  # noqa: E402
from washfsi.report.comparison import comparison_of  # noqa: E402
from washfsi.report.curves import energy_balance, kept  # noqa: E402
from washfsi.report.figures import cycle_figures  # noqa: E402
from washfsi.report.flow import taken, thinned  # noqa: E402
from washfsi.report.page import COUNT, colour_scales, page_of, write_page  # noqa: E402
from washfsi.report.solids import light_surface, rigid_motion  # noqa: E402
from washfsi.report.words import words_of  # noqa: E402

MACHINE = ["-options_file", SOURCE / "inputs" / "wash.opts", "-grid_cells", "12,12,12", "-towel_count", 4,
           "-towel_markers", 4, "-time_step", 4e-3, "-agitator_frequency", 10, "-agitator_angular_speed", 15,
           "-output_interval", 0.025]
PLANE = ["-options_file", WASH, "-grid_cells", "32,32", "-long_markers", 8, "-short_markers", 6, "-time_end", 0.02,
         "-output_interval", 0.01]
EVIL = "a</script><!--<script><img src=x onerror=alert(1)>&"
PREFIX = {"G": 1e9, "M": 1e6, "k": 1e3, "m": 1e-3, "µ": 1e-6}
NORMAL_DIGITS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
# What dichromats see of linear red, green and blue (Viénot, Brettel and Mollon 1999; the third by Brettel's half planes in one).
SIGHTS = {"all": np.eye(3),
          "no red": [[0.11238, 0.88762, 0], [0.11238, 0.88762, 0], [0.00401, -0.00401, 1]],
          "no green": [[0.29275, 0.70725, 0], [0.29275, 0.70725, 0], [-0.02234, 0.02234, 1]]}


ROOT = pathlib.Path()


def setUpModule():  # pylint: disable=invalid-name
    """Makes the runs of all tests, two designs of a machine, the plane and a dry run, and their reports."""
    global ROOT  # pylint: disable=global-statement
    folder = tempfile.TemporaryDirectory(prefix="washfsi_")
    unittest.addModuleCleanup(folder.cleanup)
    ROOT = pathlib.Path(folder.name)
    for name, words in (("three", [*MACHINE, "-time_end", 0.3]), ("two", [*MACHINE, "-agitator_vanes", 2, "-time_end", 0.3]),
                        ("plane", PLANE), ("design", [*MACHINE, "-check"])):
        outcome = run(1, *words, "-output_dir", name, folder=ROOT)
        if outcome.returncode:
            raise AssertionError(outcome.stderr)
    outcome = report(ROOT / "three", ROOT / "two", "--output", ROOT / "both.html")
    if outcome.returncode:
        raise AssertionError(outcome.stderr)
    for name in ("three", "plane"):
        write_page([Results(ROOT / name)], ROOT / name / "report.html")


def report(*words):
    """Runs scripts/report."""
    return subprocess.run([SOURCE / "scripts" / "report", *words], capture_output=True, text=True, check=False)


def linear(colour):
    """Returns linear red, green and blue of a colour as #rrggbb or numbers from 0 to 255."""
    if isinstance(colour, str):
        colour = [int(colour[place:place + 2], 16) for place in (1, 3, 5)]
    share = np.array(colour) / 255
    return np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)


def lab(light):
    """Returns CIE L*a*b* of linear red, green and blue."""
    xyz = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]) @ light
    f = np.cbrt(np.maximum(xyz, 0) / [0.9505, 1, 1.089])
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def contrast(one, other):
    """Returns the contrast of two colours as WCAG defines it."""
    levels = sorted(0.05 + np.dot([0.2126, 0.7152, 0.0722], linear(colour)) for colour in (one, other))
    return levels[1] / levels[0]


def style_of(theme):
    """Returns the colours of a theme in the style sheet."""
    text = (SOURCE / "python" / "washfsi" / "report" / "web" / "style.css").read_text()
    blocks = {"light": text.split(":root {")[1].split("}")[0], "dark": text.split('[data-theme="dark"] {')[1].split("}")[0]}
    return dict(re.findall(r"--([\w-]+): (#[0-9a-f]{6})", blocks[theme]))


def number_of(text, unit):
    """Returns the number, its spread and the size of its last digit, that a cell of a table shows; `unit` is that of the data."""
    shown = text.translate(NORMAL_DIGITS)
    for tail in (f" {prefix}{unit}" for prefix in ("", *PREFIX)):
        if unit != "-" and shown.endswith(tail):
            factor = PREFIX.get(tail.strip().removesuffix(unit), 1)
            shown = shown.removesuffix(tail)
            break
    else:
        factor = 1
    parts = [re.sub(r" × 10", "e", part) for part in shown.split(" ± ")]
    return [factor * float(part) for part in parts]


class Contents(ProgramTest):
    """What Python puts into the page."""

    @classmethod
    def setUpClass(cls):
        cls.results = Results(ROOT / "three")

    def test_energy_is_that_of_the_cycles(self):
        history, cycles = self.results.history, read_columns(ROOT / "three" / "cycles.csv")
        parts = energy_balance(history, ["drum", "agitator"], ["towel"])
        rows = [int(np.argmin(np.abs(history["time"] - end))) for end in cycles["end"]]
        names = {"put in": "agitator_work", "lost to friction": "dissipated", "lost at moving walls": "mask_dissipated",
                 "lost in cloth": "cloth_dissipated", "kept as motion": "kinetic_energy_change", "open": "energy_open"}
        for part, name in names.items():
            np.testing.assert_allclose(np.diff(parts[part][rows]), cycles[name][1:], rtol=1e-9, atol=1e-12, err_msg=name)

    def test_long_curves_keep_their_peaks(self):
        values = np.sin(np.linspace(0, 60, 50001))
        values[12345], values[40000] = 7, -9
        rows = kept(values)
        self.assertLess(len(rows), 5000)
        self.assertEqual((values[rows].max(), values[rows].min(), rows[0], rows[-1]), (7, -9, 0, 50000))

    def test_motion_of_bodies_is_rigid_and_found(self):
        surfaces = self.results.surfaces
        start, now = (surfaces.frame(number)["position"][surfaces.body == surfaces.bodies.index("agitator")]
                      for number in (0, 3))
        rotation, moved = rigid_motion(start, now)
        np.testing.assert_allclose(start @ rotation.T + moved, now, atol=1e-6)
        self.assertGreater(np.abs(start - now).max(), 0.01)
        np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)

    def test_light_surfaces_stay_where_they_are(self):
        angles, heights = np.meshgrid(np.linspace(0, 2 * np.pi, 200, endpoint=False), np.linspace(0, 1, 100))
        vertices = np.column_stack([np.cos(angles.ravel()), np.sin(angles.ravel()), heights.ravel()])
        i, j = (grid.ravel() for grid in np.meshgrid(np.arange(200), np.arange(99)))
        corners = [j * 200 + i, j * 200 + (i + 1) % 200, (j + 1) * 200 + i, (j + 1) * 200 + (i + 1) % 200]
        facets = np.concatenate([np.column_stack([corners[0], corners[1], corners[2]]),
                                 np.column_stack([corners[1], corners[3], corners[2]])])
        points, light = light_surface(vertices, facets, 5000)
        self.assertTrue(1000 < len(light) <= 5000)
        sides = points[light[:, 1:]] - points[light[:, :1]]
        area = 0.5 * np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1).sum()
        low, high = points[:, 2].min(), points[:, 2].max()  # ends shrink by less than the size of what is merged
        self.assertTrue(low < 0.06 and high > 0.94, (low, high))
        self.assertLess(abs(area / (2 * np.pi * (high - low)) - 1), 0.01)
        self.assertLess(np.abs(np.hypot(points[:, 0], points[:, 1]) - 1).max(), 0.02)

    def test_light_surfaces_keep_the_two_faces_of_a_sheet_apart(self):
        x, y = (grid.ravel() for grid in np.meshgrid(np.linspace(0, 1, 100), np.linspace(0, 1, 100)))
        i, j = (grid.ravel() for grid in np.meshgrid(np.arange(99), np.arange(99)))
        corners = [j * 100 + i, j * 100 + i + 1, (j + 1) * 100 + i, (j + 1) * 100 + i + 1]
        facets = np.concatenate([np.column_stack(corners[:3]), np.column_stack([corners[1], corners[3], corners[2]])])
        faces = [np.column_stack([x, y, np.full_like(x, height)]) for height in (0, 0.001)]
        points, light = light_surface(np.concatenate(faces), np.concatenate([facets[:, ::-1], facets + len(x)]), 5000)
        self.assertTrue(1000 < len(light) <= 5000)
        sides = points[light[:, 1:]] - points[light[:, :1]]
        upwards = np.cross(sides[:, 0], sides[:, 1])[:, 2]
        on_top = points[light][:, :, 2].mean(axis=1) > 0.0005
        self.assertTrue((upwards[on_top] > 0).all() and (upwards[~on_top] < 0).all())
        self.assertEqual(sorted(set(np.round(points[:, 2], 9))), [0, 0.001])

    def test_flow_of_any_grid_is_thinned_to_fit(self):
        for cells, room in (((33, 33, 33), 1e7), ((256, 64, 256), 2e6), ((208, 208, 10), 1e6), ((512, 512), 1e6), ((2000, 3, 3), 100)):
            coarser, apart = thinned(cells, 40, 3, room)
            lines = taken(cells, coarser)
            self.assertLessEqual(np.prod([len(line) for line in lines]) * -(-40 // apart) * 3, room)
            for line, count in zip(lines, cells):
                self.assertTrue(len(line) and line[-1] < count)

    def test_words_tell_the_case(self):
        told = {part["about"]: part["text"] for part in words_of(self.results)}
        self.assertIn("4 cloths of 0.15 × 0.15 m with 4 × 4 markers", told["Load"])
        self.assertIn("The agitator (vaned agitator: 3 vanes", told["Machine"])
        self.assertIn("15 rad/s (143.2 rpm), a cycle in 0.1 s", told["Machine"])
        self.assertIn("1.006 Pa s (1006 times that of water)", told["Liquid"])
        self.assertIn("12 × 12 × 12 cells", told["Grid"])
        self.assertRegex(told["Run"], r"finished after \d+ steps at 0\.30?\d* s")

    def test_a_design_makes_a_page(self):
        text = page_of([Results(ROOT / "design")])
        self.assertIn("dry run", text)

    def test_names_cannot_break_the_page(self):
        results = Results(ROOT / "plane")
        results.__dict__["summary"] = {**results.summary, "case": EVIL}
        text = page_of([results])
        data, = re.findall(r'<script type="application/json" id="data">(.*?)</script>', text, re.DOTALL)
        self.assertEqual(json.loads(data)["runs"][0]["case"], EVIL)
        self.assertNotIn("<img", text.split("<main")[0])

    def test_designs_of_several_seeds_are_points_with_their_spread(self):
        runs = []
        for design, seed, work in (("a", 1, 10.0), ("a", 2, 12.0), ("b", 1, 30.0), ("b", 2, 31.0)):
            figures = [{"owner": owner, "rest": rest, "label": rest, "unit": "J", "values": [1, value], "mean": value,
                        "std": 0.1, "name": f"{owner}_{rest}"}
                       for owner, rest, value in (("agitator", "work", work), ("towel", "relative_speed", work / 100),
                                                  ("towel", "stress", 5.0 + seed))]
            runs.append({"name": f"{design}/{seed}", "design": design, "groups": ["towel"], "cycles": {"figures": figures},
                         "options": {}})
        made = comparison_of(runs)
        first = made["tradeoffs"][0]["points"]
        self.assertEqual([(point["name"], point["x"]["value"], point["x"]["seeds"]) for point in first],
                         [("a", 11.0, 2), ("b", 30.5, 2)])
        self.assertAlmostEqual(first[0]["x"]["std"], np.sqrt(2))
        self.assertTrue(any(line.startswith("work: ") and "differ by more than their spread" in line
                            for line in made["verdicts"]), made["verdicts"])

    @staticmethod
    def run_on(cells, work, mean=True, vanes=3, **options):
        """Makes up a run on a grid, of which nothing but the start-up is known without a mean."""
        figures = [{"owner": owner, "rest": rest, "label": rest, "unit": "J", "values": [1, work] if mean else [work],
                    "mean": work if mean else None, "std": 0.1, "name": f"{owner}_{rest}"}
                   for owner, rest in (("agitator", "work"), ("towel", "relative_speed"))]
        options = {"grid_cells": cells, "towel_markers": cells[:2], "agitator_vanes": str(vanes), "time_end": "3"} | options
        return {"name": cells, "design": f"{vanes}", "groups": ["towel"], "cycles": {"figures": figures}, "options": options}

    def test_start_up_on_one_grid_is_not_continued_with_later_cycles_of_another(self):
        coarse, fine, fine_start = self.run_on("20,20", 10.0), self.run_on("40,40", 8.0), self.run_on("40,40", 3.0, mean=False)
        self.assertEqual(comparison_of([coarse, fine_start])["grids"], [])
        row, = comparison_of([coarse, fine, fine_start])["grids"][0]["rows"]
        self.assertEqual([figure["value"] for figure in row["values"]], [10.0, 8.0])
        row, = comparison_of([self.run_on("20,20", 4.0, mean=False), fine_start])["grids"][0]["rows"]
        self.assertEqual([figure["value"] for figure in row["values"]], [4.0, 3.0])

    def test_only_grids_that_are_refined_alike_are_continued(self):
        def grids_of(*cells):
            return [table["grids"] for table in comparison_of([self.run_on(one, 10.0 + place) for place, one in enumerate(cells)])["grids"]]
        self.assertEqual(grids_of("64,32", "32,64"), [])
        self.assertEqual(grids_of("32,32", "64,32"), [])
        self.assertEqual(grids_of("64,64", "33,32", "66,32", "99,96", "96,98"), [["33 × 32", "64 × 64", "99 × 96"]])
        self.assertEqual(grids_of("1,32", "1,64"), [["1 × 32", "1 × 64"]])

    def test_runs_with_other_markers_or_steps_are_no_seeds(self):
        coarse, fine = self.run_on("20,20", 10.0), self.run_on("40,40", 8.0)
        for options in ({"towel_markers": "9"}, {"time_step": "1e-3"}):
            self.assertEqual(comparison_of([coarse, fine, self.run_on("40,40", 7.0, **options)])["grids"], [])
        for options in ({"towel_seed": "2"}, {"max_steps": "900", "strict": "true"}):
            row, = comparison_of([coarse, fine, self.run_on("40,40", 7.0, **options)])["grids"][0]["rows"]
            self.assertEqual([figure["value"] for figure in row["values"]], [10.0, 7.5])
        row, = comparison_of([coarse, fine, self.run_on("40,40", 7.0, time_end="9")])["grids"][0]["rows"]
        self.assertEqual([figure["value"] for figure in row["values"]], [10.0, 8.0])

    def test_a_case_on_several_grids_is_continued_to_cells_of_no_width(self):
        runs = [self.run_on(cells, work, vanes=vanes, towel_seed=seed)
                for cells, seed, work, vanes in (("20,20,10", "1", 10.0, 3), ("20,20,10", "2", 12.0, 3), ("40,40,20", "1", 8.0, 3),
                                                 ("40,40,20", "2", 8.4, 3), ("20,20,10", "1", 7.0, 2))]
        table, = comparison_of(runs)["grids"]
        self.assertEqual((table["designs"], table["grids"]), (["3"], ["20 × 20 × 10", "40 × 40 × 20"]))
        row, = table["rows"]
        self.assertEqual([figure["value"] for figure in row["values"]], [11.0, 8.2])
        self.assertAlmostEqual(row["estimate"]["value"], 8.2 - (11.0 - 8.2))
        self.assertGreater(row["estimate"]["std"], 11.0 - 8.2)

    def test_mistakes_are_told_in_a_line(self):
        (self.folder / "empty").mkdir()
        for folder in (self.folder / "nowhere", self.folder / "empty"):
            outcome = report(folder)
            self.assertEqual(outcome.returncode, 2)
            self.assertRegex(outcome.stderr, r"\Areport: .*\n\Z")


class Colours(unittest.TestCase):
    """Colours that all can tell apart."""

    def test_curves(self):
        for theme in ("light", "dark"):
            colours = style_of(theme)
            series = [colours[f"series-{number}"] for number in range(7)]
            for name, sight in SIGHTS.items():
                seen = [lab(np.asarray(sight) @ linear(colour)) for colour in series]
                for place, one in enumerate(seen[:4]):  # more than four curves differ by their dashes and legend too
                    for other in seen[:place]:
                        self.assertGreater(np.linalg.norm(one - other), 10, f"{theme}, {name}: {place}")
            for colour in series:
                self.assertGreater(contrast(colour, colours["sheet"]), 2.7, f"{theme}: {colour}")

    def test_texts(self):
        for theme in ("light", "dark"):
            colours = style_of(theme)
            for name in ("text", "quiet", "accent", "ok", "warn", "fail"):
                self.assertGreater(contrast(colours[name], colours["sheet"]), 4.5, f"{theme}: {name}")

    def test_scales_grow_darker_for_all_eyes(self):
        scales = colour_scales()
        for sight in SIGHTS.values():
            for name, parts in (("cloth", [scales["cloth"]]), ("flow", [scales["flow"]]),
                                ("signed", [scales["signed"][COUNT // 2:], scales["signed"][COUNT // 2 - 1::-1]])):
                for part in parts:
                    light = [lab(np.asarray(sight) @ linear(colour))[0] for colour in part]
                    self.assertLess(np.diff(light).max(), 0.6, name)
                    self.assertGreater(light[0] - light[-1], 50, name)


@unittest.skipUnless(browser.there(), browser.MISSING)
class InBrowser(ProgramTest):
    """What a reader sees."""

    opened = None

    @classmethod
    def setUpClass(cls):
        cls.page = browser.Browser()
        cls.addClassCleanup(cls.page.close)

    def open(self, path):
        """Opens a report, which must not complain."""
        self.page.open(ROOT / path)
        InBrowser.opened = path
        self.addCleanup(lambda: self.assertEqual(self.page.errors(), []))

    def look(self, path):
        """Opens a report only to read it: one that is open stays."""
        if self.opened != path:
            self.open(path)

    def test_numbers_are_those_of_the_summary(self):
        self.look("three/report.html")
        summary = json.loads((ROOT / "three" / "summary.json").read_text())
        cells = self.page.run("return [...document.querySelectorAll('td[data-path]')].map((cell) => "
                              "[JSON.parse(cell.dataset.path), cell.dataset.value, cell.textContent]);")
        self.assertGreater(len(cells), 30)
        units = {tuple(row["path"]): row["unit"] for row in self.page.run("return report.data.runs[0].figures;")}
        for path, value, text in cells:
            expected = summary
            for name in path:
                expected = expected[name]
            self.assertEqual(float(value), expected, path)
            np.testing.assert_allclose(number_of(text, units[tuple(path)])[0], expected, rtol=6e-4, err_msg=str(path))

    def test_cycles_are_those_of_the_summary(self):
        self.look("three/report.html")
        figures = json.loads((ROOT / "three" / "summary.json").read_text())["cycles"]["figures"]
        cycles = read_columns(ROOT / "three" / "cycles.csv")
        rows = self.page.run("return [...document.querySelectorAll('#cycles tr[data-figure]')].map((row) => [row.dataset.figure, "
                             "[...row.cells].slice(1).map((cell) => cell.dataset.value ?? null), row.cells[1].textContent]);")
        self.assertEqual({name for name, _, _ in rows}, set(cycles) - {"cycle", "start_up", "start", "end"})
        self.assertEqual(len(cycles["cycle"]), 3)
        for name, values, text in rows:
            np.testing.assert_array_equal(np.array(values, float), [figures[name]["mean"], *cycles[name]], name)
            mean, std = number_of(text, figures[name]["unit"])
            np.testing.assert_allclose([mean], [figures[name]["mean"]], rtol=6e-4, err_msg=name)
            np.testing.assert_allclose([std], [figures[name]["std"]], rtol=6e-2, err_msg=name)
        cards = self.page.run("return [...document.querySelectorAll('.card [data-figure]')].map((card) => "
                              "[card.dataset.figure, Number(card.dataset.value)]);")
        self.assertIn("agitator_work", dict(cards))
        self.assertEqual(dict(cards), {name: figures[name]["mean"] for name, _ in cards})

    def test_findings_are_those_of_the_summary(self):
        self.look("three/report.html")
        trust = json.loads((ROOT / "three" / "summary.json").read_text())["trust"]
        lines = self.page.run("return [...document.querySelectorAll('.findings li')].map((line) => [line.className, line.textContent]);")
        expected = [*trust["start"], *trust["end"]]
        self.assertEqual([verdict for verdict, _ in lines], [finding["verdict"] for finding in expected])
        for (_, text), finding in zip(lines, expected):
            self.assertIn(f"{finding['name']} {finding['found']}", text)
            self.assertIn(finding.get("advice", ""), text)

    def test_slider_moves_the_cloths_to_where_they_were(self):
        self.open("three/report.html")
        with h5py.File(ROOT / "three" / "cloth.h5") as file:
            frames = [(group.attrs["time"], group["position"][()]) for group in file["frames"].values()]
        pictures = []
        for time, position in (frames[0], frames[5], frames[-1]):
            self.page.set("#time", time)
            shown = np.reshape(self.page.run("return [...report.page.playback.cloths.shape.positions.array];"), (-1, 3))
            np.testing.assert_allclose(shown, position, atol=2e-5)
            pictures.append(self.page.picture(".stage"))
            self.assertGreater(len(np.unique(pictures[-1].reshape(-1, 3), axis=0)), 500)  # not blank
        self.assertGreater((pictures[0] != pictures[1]).mean(), 0.01)
        self.assertGreater((pictures[1] != pictures[2]).mean(), 0.01)

    def test_playback_plays_turns_and_colours(self):
        self.open("three/report.html")
        still = self.page.picture(".stage")
        for selector, value, event in (("#colour", "number", "change"), ("#slice", "1", "change"), ("#height", "0.8", "input"),
                                       ("#field", "pressure", "change"), ("#view", "top", "change")):
            self.page.set(selector, value, event)
            changed = self.page.picture(".stage")
            self.assertGreater((still != changed).mean(), 0.005, selector)
            still = changed
        time = self.page.run("return report.page.playback.time;")
        self.page.driver.find_element("css selector", "#play").click()
        self.page.picture(".stage")
        self.assertNotEqual(self.page.run("return report.page.playback.time;"), time)
        from selenium.webdriver import ActionChains
        self.page.driver.find_element("css selector", "#play").click()
        still = self.page.picture(".stage")
        stage = self.page.driver.find_element("css selector", ".stage")
        ActionChains(self.page.driver).move_to_element(stage).click_and_hold().move_by_offset(120, 60).release().perform()
        self.assertGreater((still != self.page.picture(".stage")).mean(), 0.02)

    def test_curves_are_those_of_the_history(self):
        self.look("three/report.html")
        history = read_columns(ROOT / "three" / "history.csv")
        curves = self.page.run("return report.data.runs[0].curves.flatMap((panel) => panel.curves).map((curve) => "
                               "[curve.column, [...report.packs[0](curve.values)]]);")
        columns = [column for column, _ in curves if column]
        for name in ("agitator_torque_z", "agitator_power", "towel_stress_mean", "towel_relative_speed_mean"):
            self.assertIn(name, columns)
        for column, values in curves:
            if column:
                np.testing.assert_allclose(values, history[column], rtol=1e-6, atol=1e-30)
        drawn = self.page.run("return report.page.charts.charts.map(({chart}) => chart.getDatasetMeta(0).data.length);")
        self.assertGreater(min(drawn), 1)

    def test_a_drag_takes_a_stretch_of_time_and_a_click_a_time(self):
        self.look("three/report.html")
        where = "document.querySelector('#curves canvas').scrollIntoView({block: 'center'}); return report.page.playback.time;"
        before = self.page.run(where)
        canvas = self.page.driver.find_element("css selector", "#curves canvas")
        browser.webdriver.ActionChains(self.page.driver).move_to_element_with_offset(canvas, -60, 0).click_and_hold() \
            .move_by_offset(80, 5).release().perform()
        stretch = self.page.run("return report.page.charts.window;")
        self.assertLess(0, stretch[0])
        self.assertLess(stretch[1], 0.3)
        self.assertEqual(self.page.run(where), before)
        browser.webdriver.ActionChains(self.page.driver).move_to_element_with_offset(canvas, -90, 0).click().perform()
        self.assertNotAlmostEqual(self.page.run(where), before, 3)

    def test_tracks_and_what_the_bodies_sweep(self):
        self.open("three/report.html")
        tracks = read_columns(ROOT / "three" / "tracks.csv")
        row = len(tracks["time"]) // 2
        self.page.set("#time", tracks["time"][row])
        dots = self.page.run("return report.page.tracks.dots.data.map(({x, y}) => [x, y]);")
        expected = [(np.hypot(tracks[f"towel_{n}_x"][row], tracks[f"towel_{n}_y"][row]), tracks[f"towel_{n}_z"][row])
                    for n in range(4)]
        np.testing.assert_allclose(dots, expected, rtol=1e-5)
        picture = self.page.picture("#tracks canvas")
        solid = [int(style_of("light")["solid"][place:place + 2], 16) for place in (1, 3, 5)]
        for radius, height, filled in ((0.315, 0.02, 1), (0.315, 0.22, 1), (0.30, 0.02, 0), (0.30, 0.22, 0)):
            x, y = self.page.run("const {x, y} = report.page.tracks.chart.scales;"
                                 "return [x.getPixelForValue(given[0]), y.getPixelForValue(given[1])];", radius, height)
            self.assertEqual(np.abs(picture[round(y), round(x)] - solid).max() < 9, bool(filled), (radius, height))

    def test_needs_nothing_but_itself(self):
        path = ROOT / "three" / "report.html"
        self.assertLess(path.stat().st_size, 15e6)
        text = path.read_text()
        self.assertNotRegex(text.split("<!-- put")[0], r"<(link|script|img)[^>]*(src|href)=")
        for words in ("default-src 'none'", "three.js authors", "Chart.js Contributors", "WITHOUT WARRANTY OF ANY"):
            self.assertIn(words, text)
        self.open("three/report.html")
        self.assertEqual(self.page.run("return performance.getEntriesByType('resource').map((entry) => entry.name);"), [])

    def test_fits_a_telephone_and_is_light_or_dark(self):
        self.addCleanup(self.page.resize, 900)
        self.addCleanup(self.page.prefer, "light")
        backs = []
        for scheme in ("light", "dark"):
            self.page.prefer(scheme)
            self.page.resize(360, 740)
            self.open("both.html")
            self.assertLessEqual(self.page.run("return document.documentElement.scrollWidth;"), 360)
            wide = self.page.run("return [...document.querySelectorAll('main section, .stage, .plot')].map((one) => "
                                 "one.getBoundingClientRect().right).reduce((most, one) => Math.max(most, one), 0);")
            self.assertLessEqual(wide, 360)
            backs.append(self.page.picture("#overview")[20, 20].mean())
        self.assertGreater(backs[0], 200)
        self.assertLess(backs[1], 60)
        self.page.driver.find_element("css selector", "#theme").click()
        self.assertGreater(self.page.picture("#overview")[20, 20].mean(), 200)

    def test_compares(self):
        self.open("both.html")
        summaries = [json.loads((ROOT / name / "summary.json").read_text())["cycles"]["figures"] for name in ("three", "two")]
        panels = self.page.run("return report.comparison.charts.map((chart) => chart.data.datasets.map(({data}) => data[0]));")
        self.assertEqual(len(panels), 4)
        for points in panels:
            self.assertEqual([point["name"] for point in points], ["three", "two"])
        for point, figures in zip(panels[0], summaries):
            self.assertAlmostEqual(point["x"], figures["agitator_work"]["mean"], 9)
            self.assertAlmostEqual(point["y"], figures["towel_relative_speed"]["mean"], 9)
        cells = self.page.run("return [...document.querySelectorAll('#comparison tbody tr')].filter((row) => row.cells[0].textContent "
                              "=== 'work').map((row) => [...row.cells].slice(1).map((cell) => Number(cell.dataset.value)));")
        self.assertIn([figures["agitator_work"]["mean"] for figures in summaries], cells)
        self.page.set("#run", "1", "change")
        self.assertEqual(self.page.run("return document.querySelector('#overview h2').textContent;"), "two")
        self.assertGreater(len(np.unique(self.page.picture(".stage").reshape(-1, 3), axis=0)), 500)

    def test_pictures_are_as_asked(self):
        path = self.folder / "picture.png"
        outcome = report(ROOT / "three", "--picture", path, "--time", "0", "--view", "front", "--slice", "none")
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        picture = np.rint(255 * imread(path)[..., :3]).astype(int)
        self.assertEqual(picture.shape[1], 1200)
        half, picture = picture.shape[0] / 2, picture[:-120]  # without the bars of colours
        blue = (picture[..., 2] > picture[..., 0] + 20).mean()  # there is no slice of the flow ...
        yellow = picture[..., 2] < picture[..., 0] - 30  # ... and cloths to both sides of the middle, above it
        self.assertLess(blue, 1e-3)
        self.assertGreater(yellow.sum(), 200)
        rows, columns = np.nonzero(yellow)
        self.assertLess(abs(columns.mean() - 600), 60)
        self.assertLess(rows.mean(), half)
        outcome = report(ROOT / "three", ROOT / "two", "--picture", self.folder / "both.png")
        self.assertEqual(outcome.returncode, 2)
        outcome = report(ROOT / "plane", "--picture", path, "--height", "0.5", "--slice", "z", "--colour", "stretch")
        self.assertEqual(outcome.returncode, 0, outcome.stderr)  # a plane has no slice to move
        self.assertGreater(len(np.unique(imread(path).reshape(-1, imread(path).shape[-1]), axis=0)), 40)

    def test_movies_show_all_times(self):
        path = self.folder / "movie.mp4"
        outcome = report(ROOT / "three", "--movie", path, "--slice", "none")
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        subprocess.run(["ffmpeg", "-loglevel", "error", "-i", path, self.folder / "%d.png"], check=True)
        frames = sorted(self.folder.glob("*.png"), key=lambda frame: int(frame.stem))
        self.assertEqual(len(frames), 25)  # 0.3 s, four times slower, 20 a second, and both ends
        first, middle, last = (imread(frames[number])[100:, :, :3] for number in (0, 12, 24))  # without the time
        self.assertGreater((np.abs(first - middle) > 0.1).mean(), 0.003)
        self.assertGreater((np.abs(middle - last) > 0.1).mean(), 0.003)

    def test_views_fill_the_picture(self):
        for path, names in (("three/report.html", ("3d", "top", "front", "side")), ("plane/report.html", ("top",))):
            self.open(path)
            for name, width in itertools.product(names, (900, 500)):
                self.page.resize(width)
                self.page.set("#view", name, "change")
                seen = self.page.run("const {view} = report.page.playback; view.camera.updateMatrixWorld(); return view.seen().map("
                                     "(point) => new THREE.Vector3(...point).project(view.camera).toArray());")
                low, high = np.min(seen, axis=0), np.max(seen, axis=0)
                self.assertLess(np.abs(seen).max(), 1, (path, name, width))
                filled = np.isclose(low[:2], -0.9, atol=1e-3) & np.isclose(high[:2], 0.9, atol=1e-3)
                self.assertTrue(filled.any(), (path, name, width, low, high))
        self.page.resize(900)

    def test_pictures_tell_the_time(self):
        self.open("three/report.html")
        self.page.set("#time", 0.1)
        self.assertEqual(self.page.run("return document.querySelector('.stage #clock').textContent;"), "t = 0.100 s")

    def test_shows_the_plane(self):
        self.open("plane/report.html")
        still = self.page.picture(".stage")
        self.assertGreater(len(np.unique(still.reshape(-1, 3), axis=0)), 500)
        self.page.set("#time", 0)
        self.assertGreater((still != self.page.picture(".stage")).mean(), 0.01)


if __name__ == "__main__":
    unittest.main()
