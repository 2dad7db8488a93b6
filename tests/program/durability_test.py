# SPDX-License-Identifier: BSD-3-Clause
"""What a run leaves when it is killed or its files are damaged: a restart goes on, or one line says why not."""

import random
import shutil
import subprocess
import unittest

import h5py
import numpy as np

from support import SOURCE, ProgramTest, command, read_columns, run

CASE = ["-options_file", SOURCE / "inputs" / "thesis" / "wash2d64.opts", "-grid_cells", "32,32", "-time_cfl", 0, "-time_step", 1e-3,
        "-checkpoint_interval", 0.01]
WRONG_INPUT, NOT_WRITTEN = 2, 4


class Durability(ProgramTest):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out"
        self.run_well(1, *CASE, "-time_end", 0.02, "-output_interval", 0.01, "-output_dir", self.out)

    def restart(self, *options, end=0.03, checkpoint="out/checkpoint.h5"):
        return run(1, *CASE, "-time_end", end, "-output_interval", 0.01, "-restart", checkpoint, "-output_dir", self.out,
                   *options, folder=self.folder)

    def test_a_run_that_died_before_its_summary_is_finished(self):
        refused = self.restart(end=0.02)
        self.assertEqual(refused.returncode, WRONG_INPUT)
        self.assertIn("-time_end", refused.stderr)
        (self.out / "summary.json").unlink()
        finished = self.restart(end=0.02)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertTrue((self.out / "summary.json").exists())

    def test_what_a_restart_changes_is_said(self):
        outcome = self.restart("-fluid_viscosity", 2, "-long_ke", 7000)
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        notes = [line for line in outcome.stdout.splitlines() if line.startswith("note: ")]
        self.assertEqual(notes, ["note: -fluid_viscosity was 0.9812, is now 2", "note: -long_ke was 8e3, is now 7000"])

    def test_no_bit_of_a_checkpoint_changes_unseen(self):
        good, damaged = (self.out / "checkpoint.h5").read_bytes(), self.folder / "damaged.h5"
        expected = self.restart()
        self.assertEqual(expected.returncode, 0, expected.stderr)
        history = (self.out / "history.csv").read_bytes()
        places = random.Random(1)
        for _ in range(12):
            content, place = bytearray(good), places.randrange(len(good))
            content[place] ^= 1 << places.randrange(8)
            damaged.write_bytes(content)
            with self.subTest(place=place):
                outcome = self.restart(checkpoint="damaged.h5")
                if outcome.returncode == 0:  # nothing that is read
                    self.assertEqual((self.out / "history.csv").read_bytes(), history)
                else:
                    self.assertEqual(outcome.returncode, WRONG_INPUT, outcome.stderr)
                    self.assertIn("-restart damaged.h5", outcome.stderr.splitlines()[0])

    def test_numbers_of_a_checkpoint_are_numbers(self):
        for what, value in (("nan", float("nan")), ("array", [1.0, 2.0]), ("text", "two")):
            damaged = self.folder / "damaged.h5"
            shutil.copy(self.out / "checkpoint.h5", damaged)
            with h5py.File(damaged, "a") as file:
                file.attrs["format"] = value
            with self.subTest(what):
                outcome = self.restart(checkpoint="damaged.h5")
                self.assertEqual(outcome.returncode, WRONG_INPUT, outcome.stderr)
                self.assertIn("format", outcome.stderr.splitlines()[0])

    def test_the_checkpoint_before_the_last_is_kept(self):
        outcome = self.restart(checkpoint="out/checkpoint_before.h5")
        self.assertEqual(outcome.returncode, 0, outcome.stderr)

    def times_of_frames(self, name):
        """Returns the times of a series' frames, which NAME.h5 links to."""
        with h5py.File(self.out / f"{name}.h5") as file:
            return [frame.attrs["time"] for frame in file["frames"].values()]

    def test_an_unfinished_frame_is_dropped(self):
        for part in ("checkpoint.h5.part", "flow/000002.h5.part"):
            (self.out / part).write_text("half", encoding="utf-8")
        outcome = self.restart()
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        np.testing.assert_allclose(self.times_of_frames("flow"), [0, 0.01, 0.02, 0.03])
        self.assertEqual(list(self.out.rglob("*.part")), [])

    def test_a_damaged_frame_is_put_aside_alone(self):
        (self.out / "flow" / "000001.h5").write_bytes(b"not an HDF5 file")
        (self.out / "flow.h5").write_bytes(b"nor this")
        outcome = self.restart()
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        self.assertIn("flow/000001.h5.damaged", outcome.stderr)
        np.testing.assert_allclose(self.times_of_frames("flow"), [0, 0.02, 0.03])
        np.testing.assert_allclose(self.times_of_frames("cloth"), [0, 0.01, 0.02, 0.03])

    def test_a_series_of_an_earlier_version_is_put_aside(self):
        shutil.rmtree(self.out / "flow")
        outcome = self.restart()
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        self.assertIn("flow.h5.damaged", outcome.stderr)

    def test_a_row_that_was_cut_off_is_dropped(self):
        rows = len(read_columns(self.out / "history.csv")["time"])
        with open(self.out / "history.csv", "a", encoding="utf-8") as file:
            file.write("1,0.0")
        outcome = self.restart(end=0.021)
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        steps = read_columns(self.out / "history.csv")["step"]
        self.assertEqual(list(steps), list(range(1, rows + 2)))

    def test_one_run_at_a_time_writes_into_a_folder(self):
        with subprocess.Popen(command(1, *CASE, "-time_end", 100, "-output_dir", "busy"), cwd=self.folder,
                              stdout=subprocess.PIPE, text=True) as first:
            first.stdout.readline()
            second = run(1, *CASE, "-time_end", 0.01, "-output_dir", "busy", folder=self.folder)
            first.kill()
        subprocess.run(["pkill", "-9", "-f", "time_end 100 -output_dir busy"], check=False)
        self.assertEqual(second.returncode, NOT_WRITTEN, second.stderr)
        self.assertIn("-output_dir busy: another run", second.stderr)


if __name__ == "__main__":
    unittest.main()
