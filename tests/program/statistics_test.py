# SPDX-License-Identifier: BSD-3-Clause
"""Statistics of a disturbed channel: what the files hold, on any number of ranks, and after a restart."""

import unittest

import h5py
import numpy as np

from driving_test import CHANNEL_3D
from support import ProgramTest, read_columns, read_table, relative_difference

CASE = [*CHANNEL_3D, "-statistics", "true", "-statistics_start", "0.1", "-statistics_interval", "0.06",
        "-statistics_spectra", "0.3,1"]


class Statistics(ProgramTest):
    def datasets(self, name, *options, ranks=1):
        """Runs a case and returns all datasets of its statistics."""
        self.run_well(ranks, *CASE, *options, "-output_dir", name)
        found = {}
        with h5py.File(self.folder / name / "statistics.h5") as file:
            file.visititems(lambda path, item: found.update({path: item[()]}) if isinstance(item, h5py.Dataset) else None)
            found["time"] = file.attrs["averaged_time"]
            self.assertEqual(file["stress/uv"].attrs["unit"].decode(), "m2/s2")
        return found

    def test_files_agree_with_each_other_and_with_the_history(self):
        found = self.datasets("run", "-time_end", "0.4")
        self.assertAlmostEqual(found["time"], 0.3, places=12)
        names, units, rows = read_table(self.folder / "run" / "statistics.csv")
        self.assertEqual((names[:3], units[:3]), (["y", "u", "v"], ["m", "m/s", "m/s"]))
        table = read_columns(self.folder / "run" / "statistics.csv")
        np.testing.assert_allclose(table["uw"], found["stress/uw"], rtol=0, atol=1e-15)
        self.assertEqual(rows.shape, (12, 12))
        self.assertAlmostEqual(table["u"].mean(), 1, places=12)  # the bulk velocity
        self.assertTrue((np.array([table[name] for name in ("uu", "vv", "ww")]) > 0).all())
        self.assertEqual(found["spectra/0/energy"].shape, (3, 9))
        energy = found["spectra/0/energy"].sum(axis=1) * found["spectra/0/wave_number"][1]
        layer = int(0.3 / 2 * 12)
        for component, name in enumerate("uvw"):
            mean_square = table[2 * name][layer] + table[name][layer] ** 2
            self.assertAlmostEqual(energy[component], mean_square, places=12)

    def test_ranks_do_not_matter(self):
        expected = self.datasets("on_1", "-time_end", "0.3")
        for ranks in (2, 3):
            found = self.datasets(f"on_{ranks}", "-time_end", "0.3", ranks=ranks)
            for name, values in expected.items():
                self.assertLess(relative_difference(found[name], values) if np.abs(values).max() > 1e-9 else 0, 1e-8, name)

    def test_restart_goes_on_bit_for_bit(self):
        self.assert_restart_goes_on(self.datasets, [], 0.2, 0.4)

    def test_statistics_begin_at_a_restart_of_a_run_without(self):
        self.run_well(1, *CHANNEL_3D, "-time_end", "0.1", "-output_dir", "run")
        found = self.datasets("run", "-time_end", "0.3", "-restart", "run/checkpoint.h5")
        self.assertAlmostEqual(found["time"], 0.18, places=12)  # three samples of 0.06 s


if __name__ == "__main__":
    unittest.main()
