# SPDX-License-Identifier: BSD-3-Clause
"""A short wash leaves every file that is promised, and what the files say is consistent."""

import contextlib
import csv
import json
import os
import pty
import re
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

import h5py
import numpy as np

from support import (CAVITY, CHANNEL, COUETTE, EXPLICIT_WASH, PROGRAM, TIGHT, ProgramTest, alone, read_columns, read_options, read_table,
                     run)

CASE = [*EXPLICIT_WASH, "-time_end", 0.05, "-output_interval", 0.01,
        "-profiles", "middle", "-middle_from", "-0.3,0", "-middle_to", "0.3,0", "-middle_points", 61]
TIMES = [0, 0.01, 0.02, 0.03, 0.04, 0.05]
SERIES = ("flow", "cloth", "bodies", "surfaces")
FILES = ["resolved.opts", "summary.json", "history.csv", "profiles/middle.csv", "cloth_final.csv", "tracks.csv", "cycles.csv",
         "checkpoint.h5",
         *(f"{name}/constants.h5" for name in SERIES),
         *(name + end for name in SERIES
           for end in (".xdmf", ".h5", *(f"/{frame:06d}.h5" for frame in range(len(TIMES)))))]
SUMMARY = ["program", "version", "git", "case", "status", "ranks", "steps", "time", "wall_seconds", "seconds_per_step",
           "iterations", "max_divergence", "max_cfl", "peak_memory_bytes", "bodies", "walls", "cloths", "trust", "cycles"]
HISTORY = ["step", "time", "dt", "cfl", "kinetic_energy", "max_divergence"]
BODIES, CLOTHS, MARKERS = ["drum", "agitator"], ["long", "short"], 400
SOLVER_OPTION = re.compile(r"-(momentum|pressure|cloth)_(ksp|pc|snes)_")  # PETSc's own, listed under its objects


class Agitator:
    """The vaned agitator of resolved.opts, as in lib/washfsi/shapes/vaned.cpp."""

    def __init__(self, options):
        self.hub, self.tip, self.thickness, self.vanes, self.speed, self.frequency = (
            float(options[f"-agitator_{name}"]) for name in
            ("hub_radius", "tip_radius", "vane_thickness", "vanes", "angular_speed", "frequency"))

    def angle(self, time):
        """Returns the angle turned since the start, of a speed that varies as a sine."""
        rate = 2 * np.pi * self.frequency
        return self.speed / rate * (1 - np.cos(rate * time))

    def distance(self, x, y, time):
        """Returns the signed distance of points, negative inside."""
        sector = 2 * np.pi / self.vanes
        angle = np.arctan2(y, x) - self.angle(time)
        angle -= sector * np.round(angle / sector)
        along, across = np.hypot(x, y) * np.array([np.cos(angle), np.sin(angle)])
        nearest = np.clip(along, 0, self.tip - self.thickness / 2)
        return np.minimum(np.hypot(along - nearest, across) - self.thickness / 2, np.hypot(x, y) - self.hub)


def frames(file):
    """Returns the frames of a series in the order of their names."""
    return [file["frames"][name] for name in sorted(file["frames"])]


def cell_centers(file):
    """Returns x and y of the cells of a series on the grid."""
    ny, nx = frames(file)[0]["agitator"].shape
    x, y = (file.attrs[f"lower_{axis}"] + file.attrs[f"spacing_{axis}"] * (np.arange(n) + 0.5)
            for axis, n in (("x", nx), ("y", ny)))
    return np.meshgrid(x, y)


def as_text(value):
    """Returns an attribute's text."""
    return value.decode() if isinstance(value, bytes) else str(value)


class Output(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.root = cls.shared_folder()
        cls.outcome = run(2, *CASE, "-output_dir", "out", folder=cls.root)
        if cls.outcome.returncode != 0:
            raise AssertionError(cls.outcome.stderr)
        cls.out = cls.root / "out"
        cls.options = read_options(cls.out / "resolved.opts")

    def test_leaves_every_file_and_no_complaint(self):
        self.assertEqual(self.outcome.stderr, "")
        left = {str(path.relative_to(self.out)) for path in self.out.rglob("*") if path.is_file()}
        self.assertEqual(left, set(FILES))

    def test_summary(self):
        summary = json.loads((self.out / "summary.json").read_text())
        self.assertEqual(list(summary), SUMMARY)
        self.assertEqual([summary[key] for key in ("program", "case", "status", "ranks", "steps")],
                         ["washfsi", "wash2d64", "finished", 2, 500])
        self.assertAlmostEqual(summary["time"], 0.05)
        self.assertEqual(set(summary["iterations"]), {"momentum", "pressure", "cloth"})
        self.assertEqual(list(summary["bodies"]), BODIES)
        for body in summary["bodies"].values():
            self.assertEqual(set(body), {"force", "torque", "power"})
            self.assertEqual(len(body["force"]), 2)
        self.assertEqual(list(summary["cloths"]), CLOTHS)
        for cloth in summary["cloths"].values():
            means = ("stress", "membrane_stress", "bending_stress", "stretch", "curvature", "relative_speed", "water_shear")
            self.assertEqual(set(cloth), {f"{name}_{what}" for name in means for what in ("mean", "std")} |
                             {"max_stretch", "max_depth", "tumbles", "path"})

    def test_history(self):
        names, units, rows = read_table(self.out / "history.csv")
        wanted = [f"{body}_{measure}" for body in BODIES for measure in ("force_x", "force_y", "torque", "power")]
        wanted += [f"{cloth}_{measure}" for cloth in CLOTHS
                   for measure in ("elastic_energy", "stress_mean", "center_x", "center_y")]
        self.assertEqual(names[:len(HISTORY)], HISTORY)
        self.assertLessEqual(set(wanted), set(names))
        self.assertEqual(len(units), len(names))
        self.assertTrue(all(units))
        np.testing.assert_array_equal(rows[:, 0], np.arange(1, 501))
        np.testing.assert_allclose(rows[:, 1], 1e-4 * np.arange(1, 501))
        self.assertTrue(np.isfinite(rows).all())

    def test_history_of_some_steps_has_the_same_rows(self):
        self.run_well(2, *CASE, "-history_interval", 0.005, "-output_dir", "some")
        some, tracks = (read_columns(self.folder / "some" / f"{name}.csv") for name in ("history", "tracks"))
        every, all_tracks = read_columns(self.out / "history.csv"), read_columns(self.out / "tracks.csv")
        kept = np.arange(49, 500, 50)
        np.testing.assert_array_equal(some["step"], kept + 1)
        for cloth in CLOTHS:
            np.testing.assert_allclose(some[f"{cloth}_path"], every[f"{cloth}_path"][kept], rtol=0.01)  # of what is seen
        for name in every.keys() - {f"{cloth}_{so_far}" for cloth in CLOTHS for so_far in ("max_stretch", "path")}:
            with self.subTest(column=name):
                np.testing.assert_array_equal(some[name], every[name][kept])
        np.testing.assert_array_equal(tracks["long_0_x"], all_tracks["long_0_x"][kept])

    def test_profile(self):
        names, units, rows = read_table(self.out / "profiles" / "middle.csv")
        self.assertEqual((names, units), (["x", "y", "u", "v", "p"], ["m", "m", "m/s", "m/s", "Pa"]))
        np.testing.assert_allclose(rows[:, 0], np.linspace(-0.3, 0.3, 61), atol=1e-12)
        np.testing.assert_allclose(rows[:, 1], 0, atol=1e-12)
        self.assertTrue(np.isfinite(rows).all())

    def test_profile_to_a_periodic_side_ends_as_it_begins(self):
        sides = [word for side in ("lower", "upper") for word in (f"-bc_y_{side}", "periodic")]
        self.run_well(2, "-grid_cells", "16,32", *sides, "-bc_x_lower_velocity", "0,1", "-fluid_viscosity", 100,
                      "-time_step", 0.01, "-time_end", 0.1, "-profiles", "across", "-across_from", "0.3,0",
                      "-across_to", "0.3,1", "-output_dir", "out")
        profile = read_columns(self.folder / "out" / "profiles" / "across.csv")
        self.assertGreater(profile["v"][0], 0)
        for name in "uvp":
            self.assertAlmostEqual(profile[name][-1], profile[name][0], places=12)

    def test_new_run_removes_the_ends_of_an_old_one(self):
        out = self.folder / "out"
        (out / "profiles").mkdir(parents=True)
        old = [out / "cloth_final.csv", out / "profiles" / "old.csv"]  # this run has neither cloth nor profiles
        for file in old:
            file.touch()
        self.run_well(2, "-options_file", CAVITY, "-time_step", 0.01, "-time_end", 0.02, "-output_dir", out)
        self.assertEqual([file for file in old if file.exists()], [])

    def test_steps_see_a_body_that_starts_off(self):
        rest = "".join(f"{0.1 * n},0,0,0\n" for n in range(51))  # long steps until 5 s, then a quick start
        (self.folder / "motion.csv").write_text(f"time,x,y,angle\n{rest}5.2,0,0,2\n5.6,0,0,8\n7,0,0,28\n")
        self.run_well(2, "-grid_cells", "24,24", "-bodies", "bar", "-body_method", "mapping", "-bar_shape", "box", "-bar_size", "0.6,0.2",
                      "-bar_center", "0.5,0.5", "-bar_motion_file", "motion.csv", "-fluid_viscosity", 0.1,
                      "-time_cfl", 0.5, "-time_end", 5.3, "-output_dir", "out")

    def test_turning_drum_in_space_is_that_of_the_plane(self):
        case = ["-options_file", COUETTE, *TIGHT, "-time_end", 0.02, "-time_step", 2e-3]
        space = ["-grid_lower", "-1.415,-1.415,0", "-grid_upper", "1.415,1.415,0.5", "-bc_z_lower", "periodic",
                 "-bc_z_upper", "periodic", "-gap_from", "0.34,0,0", "-gap_to", "1,0,0"]
        for body in ("drum", "roller"):
            space += [f"-{body}_shape", "cylinder", f"-{body}_height", 4]
        torques = {}
        for name, options in (("plane", ["-grid_cells", "33,33"]), ("space", ["-grid_cells", "33,33,6", *space])):
            self.run_well(2, *case, *options, "-output_dir", name)
            bodies = json.loads((self.folder / name / "summary.json").read_text())["bodies"]
            torques[name] = [np.ravel(body["torque"])[-1] for body in bodies.values()]
        np.testing.assert_allclose(torques["space"], 0.5 * np.array(torques["plane"]), rtol=1e-6)

    def test_first_step_keeps_to_the_cfl_number(self):
        self.run_well(1, "-options_file", CAVITY, "-time_step", 0.5, "-time_cfl", 0.5, "-time_end", 0.05,
                      "-output_dir", "out")
        self.assertLess(read_columns(self.folder / "out" / "history.csv")["dt"].max(), 0.02)

    def test_cloth_that_has_not_moved_is_not_at_rest(self):
        self.run_well(1, "-grid_cells", "16,16", "-cloths", "line", "-line_size", 0.3, "-line_markers", 8,
                      "-line_center", "0.5,0.5", "-line_ke", 100, "-line_excess_mass", 0.1, "-gravity", "0,-9.81",
                      "-contact", "none", "-coupling_order", 1, "-time_step", 1e-5, "-rest_speed", 1e-3, "-time_end", 1e-3, "-output_dir", "out")
        self.assertEqual(len(read_columns(self.folder / "out" / "history.csv")["step"]), 100)

    def test_solvers_report_what_they_have_done(self):
        text = self.run_well(1, "-options_file", CAVITY, "-time_step", 0.01, "-time_end", 0.02,
                             "-pressure_ksp_converged_reason", "-momentum_ksp_view", "-output_dir", "out")
        self.assertIn("Linear pressure_ solve converged", text)

    def test_markers_at_the_end(self):
        with open(self.out / "cloth_final.csv", encoding="utf-8") as file:
            names, units, *rows = csv.reader(file)
        self.assertEqual(names, ["group", "cloth", "i", "j", "x", "y", "u", "v"])
        self.assertTrue(units[0].startswith("#"))
        self.assertEqual([row[0] for row in rows], 240 * ["long"] + 160 * ["short"])
        with h5py.File(self.out / "cloth.h5") as file:
            last = frames(file)[-1]
            places, velocities = last["position"][:, :2], last["velocity"][:, :2]
        np.testing.assert_array_equal(np.array(rows)[:, 4:].astype(float), np.hstack([places, velocities]))

    def test_every_field_has_its_unit_and_groups_their_names(self):
        means = read_table(self.out / "history.csv")
        units = {name[len("long_"):-len("_mean")]: unit for name, unit in zip(*means[:2])
                 if name.startswith("long_") and name.endswith("_mean")}
        with h5py.File(self.out / "cloth.h5") as file:
            last = frames(file)[-1]
            for name, unit in {**units, "position": "m", "velocity": "m/s"}.items():
                self.assertEqual(as_text(last[name].attrs["unit"]), unit, name)
            self.assertEqual(as_text(file["group"].attrs["names"]), "long,short")
            # the history's mean is that of the markers
            long = file["group"][()] == 0
            for name in units:
                mean = means[2][-1][means[0].index(f"long_{name}_mean")]
                self.assertAlmostEqual(last[name][()][long].mean() / (mean or 1), 1 if mean else 0, places=10)

    def test_surfaces_move_with_their_bodies(self):
        agitator = Agitator(self.options)
        with h5py.File(self.out / "surfaces.h5") as file:
            self.assertEqual(as_text(file["body"].attrs["names"]), "drum,agitator")
            of_agitator = file["body"][()] == 1
            self.assertGreater(of_agitator.sum(), 50)
            self.assertLess(file["topology"][()].max(), len(of_agitator))
            for frame in frames(file):
                x, y, _ = frame["position"][()].T
                distance = agitator.distance(x[of_agitator], y[of_agitator], frame.attrs["time"])
                self.assertLess(np.median(np.abs(distance)), 1e-4)
                np.testing.assert_allclose(np.hypot(x, y)[~of_agitator], float(self.options["-drum_radius"]), atol=1e-3)

    def test_xdmf_refers_to_what_exists(self):
        for name in SERIES:
            items = list(ElementTree.parse(self.out / f"{name}.xdmf").iter("DataItem"))
            references = [item for item in items if item.get("Format") == "HDF"]
            self.assertGreaterEqual(len(references), 2 * len(TIMES))
            for item in references:
                file_name, dataset = item.text.strip().split(":")
                with self.subTest(item.text), h5py.File(self.out / file_name) as file:
                    self.assertEqual(file[dataset].shape, tuple(map(int, item.get("Dimensions").split())))

    def test_nodes_of_the_plane_are_those_of_the_grid(self):
        lower, upper, cells = (np.array(self.options[f"-grid_{name}"].split(","), float) for name in ("lower", "upper", "cells"))
        with h5py.File(self.out / "flow.h5") as file:
            for d, axis in enumerate("xy"):
                np.testing.assert_allclose(file[axis][()], np.linspace(lower[d], upper[d], int(cells[d]) + 1), atol=1e-12)

    def test_xdmf_has_the_times_of_the_frames(self):
        for name in SERIES:
            times = [float(time.get("Value")) for time in ElementTree.parse(self.out / f"{name}.xdmf").iter("Time")]
            with self.subTest(name), h5py.File(self.out / f"{name}.h5") as file:
                self.assertEqual(times, [frame.attrs["time"] for frame in frames(file)])
                np.testing.assert_allclose(times, TIMES, atol=1e-12)

    def test_cloth_moves_and_stays_in_the_water(self):
        agitator, radius = Agitator(self.options), float(self.options["-drum_radius"])
        with h5py.File(self.out / "flow.h5") as file:
            half_cell = 0.5 * file.attrs["spacing_x"]
        before = None
        with h5py.File(self.out / "cloth.h5") as file:
            for frame in frames(file):
                x, y, _ = position = frame["position"][()].T
                self.assertEqual(position.shape, (3, MARKERS))
                self.assertLess(np.hypot(x, y).max(), radius, frame.name)
                self.assertGreater(agitator.distance(x, y, frame.attrs["time"]).min(), -half_cell, frame.name)
                self.assertTrue(before is None or (position != before).any(axis=0).all(), f"{frame.name}: no motion")
                before = position

    def test_bodies_are_where_the_options_say(self):
        agitator = Agitator(self.options)
        with h5py.File(self.out / "bodies.h5") as file:
            x, y = cell_centers(file)
            for frame in frames(file):
                expected = agitator.distance(x, y, frame.attrs["time"])
                np.testing.assert_allclose(frame["agitator"][()], expected, atol=1e-12)
                np.testing.assert_allclose(frame["drum"][()], float(self.options["-drum_radius"]) - np.hypot(x, y),
                                           atol=1e-12)

    def test_resolved_options_give_the_same_run(self):
        self.run_well(2, "-options_file", self.out / "resolved.opts", "-output_dir", "again")
        again = self.folder / "again"
        self.assertEqual((again / "history.csv").read_text(), (self.out / "history.csv").read_text())
        options = read_options(again / "resolved.opts")
        self.assertEqual({**options, "-output_dir": "out"}, self.options)

    def test_resolved_options_of_open_sides_give_the_same_run(self):
        self.run_well(2, "-options_file", CHANNEL, "-max_steps", 5, "-output_dir", "channel")
        self.run_well(2, "-options_file", "channel/resolved.opts", "-output_dir", "again")
        histories = [(self.folder / name / "history.csv").read_text() for name in ("channel", "again")]
        self.assertEqual(*histories)

    def test_help_explains_every_option(self):
        text = self.run_well(2, *CASE, "-help")
        explained = set(re.findall(r"^  (-\w+) <.*>: \w.*", text, re.MULTILINE))
        ours = {name for name in self.options if not SOLVER_OPTION.match(name)}
        self.assertEqual(ours - explained, set())

    def test_help_needs_no_case(self):
        for word in ("-help", "--help", "-h"):
            with self.subTest(word):
                self.assertIn("-grid_cells", self.run_well(1, word))

    def test_check_writes_the_start_only(self):
        old = self.folder / "out" / "cloth_final.csv"
        old.parent.mkdir()
        old.touch()
        text = self.run_well(2, *CASE, "-check", "-output_dir", "out")
        self.assertTrue(old.exists(), "a check removes nothing")
        for word in ("64 x 64", f"{MARKERS} markers", "bound", "memory", "duration"):
            self.assertIn(word, text)
        for name in SERIES:
            with h5py.File(self.folder / "out" / f"{name}.h5") as file:
                self.assertEqual([frame.attrs["time"] for frame in frames(file)], [0])
        for name in ("history.csv", "summary.json", "checkpoint.h5"):
            self.assertFalse((self.folder / "out" / name).exists(), name)


class ProgressLine(ProgramTest):
    def test_never_tells_more_than_all_nor_less_than_nothing(self):
        """The last step passes the end by half a step; on a terminal there is a line each 0.2 s, less than a step here."""
        terminal, end = pty.openpty()
        with subprocess.Popen([PROGRAM, "-options_file", CAVITY, "-grid_cells", "512,512", "-time_cfl", "0", "-time_step",
                               "1e-3", "-time_end", "2.5e-3"], cwd=self.folder, stdout=end,
                              env=alone(self.folder)) as process:
            os.close(end)
            shown = b""
            with contextlib.suppress(OSError):  # how a terminal without a writer ends
                while part := os.read(terminal, 4096):
                    shown += part
        os.close(terminal)
        self.assertEqual(process.returncode, 0)
        shares = [float(share) for share in re.findall(r"([\d.]+) %", shown.decode())]
        self.assertLessEqual(max(shares), 100)
        self.assertNotIn(b" -", b"".join(re.findall(rb"ms/step.*? left", shown)))


if __name__ == "__main__":
    unittest.main()
