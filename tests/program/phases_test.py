# SPDX-License-Identifier: BSD-3-Clause
"""Phase averages of a tank with an agitator that goes to and fro: what the file holds, on any number of ranks, and after a
restart."""

import subprocess
import sys
import unittest

import h5py
import numpy as np

from support import SOURCE, TIGHT, ProgramTest, read_columns, relative_difference, run

sys.path.insert(0, str(SOURCE / "python"))
from washfsi import Results  # noqa: E402
from washfsi.plot.phases import draw_phases  # noqa: E402

TANK = ["-grid_cells", "14,14,10", "-grid_lower", "-0.14,-0.14,0", "-grid_upper", "0.14,0.14,0.2", "-bc_z_upper", "slip",
        "-fluid_viscosity", "0.2", "-bodies", "tank,agitator", "-body_method", "mapping", "-tank_shape", "cylinder",
        "-tank_radius", "0.12", "-tank_height", "2", "-tank_inverted", "-agitator_shape", "box", "-agitator_size", "0.14,0.03,0.08",
        "-agitator_center", "0,0,0.08", "-agitator_angular_speed", "6", "-agitator_frequency", "5", "-turbulence", "vreman",
        "-time_step", "0.01", "-history_interval", "0.1", *TIGHT]
PHASES = [*TANK, "-statistics_phases", "4"]
TAYLOR_GREEN = ["-grid_cells", "12,10,8", "-grid_upper", "6.283185307179586,6.283185307179586,6.283185307179586",
                "-fluid_density", "2", "-fluid_viscosity", "0.1", "-fluid_initial", "taylor_green_3d", "-turbulence", "sigma",
                "-time_step", "0.01", "-max_steps", "1", "-time_end", "1", "-history_interval", "0", *TIGHT,
                *(word for axis in "xyz" for end in ("lower", "upper") for word in (f"-bc_{axis}_{end}", "periodic"))]


class Phases(ProgramTest):
    def datasets(self, name, *options, ranks=1):
        """Runs a case and returns all datasets of its phase averages."""
        self.run_well(ranks, *options, "-output_dir", name)
        found = {}
        with h5py.File(self.folder / name / "phases.h5") as file:
            file.visititems(lambda path, item: found.update({path: item[()]}) if isinstance(item, h5py.Dataset) else None)
        return found

    def test_the_file_tells_of_the_machine(self):
        self.datasets("run", *PHASES, "-time_end", "0.4", "-statistics_start", "0.1")
        phases = Results(self.folder / "run").phases
        self.assertEqual((phases.period, phases.start, phases.axis), (0.2, 0.1, "z"))
        np.testing.assert_array_equal(phases.center, [0, 0, 0.08])
        np.testing.assert_allclose(phases["averaged_time"], [0.05, 0.05, 0.1, 0.1], rtol=1e-12)
        np.testing.assert_array_equal(phases["samples"], [5, 5, 10, 10])
        self.assertEqual(phases["mean/u_theta"].shape, (4, 10, 10))
        self.assertEqual(phases.units["turbulence_energy"], "m2/s2")
        self.assertEqual(phases.units["dissipation"], "m2/s3")
        share = phases["liquid_share"]
        self.assertEqual(share[:, :, phases["r"] > 0.14].max(), 0)  # beyond the tank's wall
        self.assertTrue(np.isnan(phases["mean/u_r"][share == 0]).all())
        wet = share > 0
        for name in ("turbulence_energy", "dissipation", "model_dissipation"):
            self.assertGreaterEqual(phases[name][wet].min(), 0)
        turned = np.nansum(share * phases["mean/u_theta"] * phases["r"] ** 2, axis=(1, 2))
        self.assertTrue((turned[:2] > 0).all(), turned)  # with the agitator, and back with it a quarter later
        self.assertLess(turned[3], 0)

    def test_pictures_have_a_row_for_each_phase(self):
        self.datasets("run", *PHASES, "-time_end", "0.12")  # nothing of the last phase
        outcome = subprocess.run([SOURCE / "scripts" / "plot", self.folder / "run"], capture_output=True, text=True,
                                 check=False)
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        self.assertGreater((self.folder / "run" / "phases.png").stat().st_size, 10_000)
        figure = draw_phases(Results(self.folder / "run").phases, "tank")
        self.assertEqual(len(figure.axes), 4 * 3 + 3)  # with the scales of colour
        self.assertIn("0.05 to 0.1 s", figure.axes[3].get_ylabel())

    def test_dissipation_is_that_of_the_history(self):
        found = self.datasets("waves", *TAYLOR_GREEN, "-statistics_phases", "1")
        end = {name: values[-1] for name, values in read_columns(self.folder / "waves" / "history.csv").items()}
        half = 0.5 * 2 * np.pi
        r, cells = np.hypot(*np.meshgrid(2 * np.pi / 12 * (np.arange(12) + 0.5) - half,
                                         2 * np.pi / 10 * (np.arange(10) + 0.5) - half)).ravel(), np.zeros(len(found["r"]))
        np.add.at(cells, (r / (2 * np.pi / 10) + 1e-9).astype(int), 1)
        lost = found["dissipation"] + found["model_dissipation"]
        volume = (2 * np.pi) ** 3 / (12 * 10 * 8)
        total = 2 * volume * np.nansum(cells * lost)
        self.assertAlmostEqual(total / end["dissipation"], 1, places=11)
        energy = found["turbulence_energy"] + 0.5 * sum(found[f"mean/u_{c}"] ** 2 for c in ("r", "theta", "z"))
        self.assertLess(2 * volume * np.nansum(cells * energy), end["kinetic_energy"])  # of faces, without interpolation
        self.assertGreater(found["model_dissipation"][np.isfinite(lost)].max(), 0)

    def test_ranks_do_not_matter(self):
        expected = self.datasets("on_1", *PHASES, "-time_end", "0.1")
        for ranks in (2, 3):
            found = self.datasets(f"on_{ranks}", *PHASES, "-time_end", "0.1", ranks=ranks)
            for name, values in expected.items():
                np.testing.assert_array_equal(np.isnan(found[name]), np.isnan(values), name)
                if np.isfinite(values).any():
                    self.assertLess(relative_difference(np.nan_to_num(found[name]), np.nan_to_num(values)), 1e-7, name)

    def test_restart_goes_on_bit_for_bit(self):
        self.assert_restart_goes_on(self.datasets, PHASES, 0.13, 0.26)

    def test_other_averages_begin_at_a_restart(self):
        self.run_well(1, *TANK, "-time_end", "0.1", "-output_dir", "run")
        found = self.datasets("run", *PHASES, "-time_end", "0.2", "-restart", "run/checkpoint.h5")
        self.assertAlmostEqual(found["averaged_time"].sum(), 0.1, places=12)
        found = self.datasets("run", *PHASES, "-statistics_phase_period", "0.4", "-time_end", "0.25",
                              "-restart", "run/checkpoint.h5")
        self.assertAlmostEqual(found["averaged_time"].sum(), 0.05, places=12)

    def test_bins_and_axis_are_the_users(self):
        found = self.datasets("run", *PHASES, "-time_end", "0.02", "-statistics_phase_axis", "x", "-statistics_phase_center",
                              "0,0,0.1", "-statistics_phase_bins_r", "5", "-statistics_phase_bins_z", "7")
        self.assertEqual(found["liquid_share"].shape, (4, 7, 5))
        np.testing.assert_allclose(found["z"], 0.04 * (np.arange(7) - 3), atol=1e-15)
        np.testing.assert_allclose(found["r"], np.hypot(0.14, 0.1) / 5 * (np.arange(5) + 0.5))

    def test_mistakes_are_told_in_a_line(self):
        steady = [*PHASES, "-time_end", "0.1", "-agitator_frequency", "0"]
        for options, words in ((["-statistics_phases", "4"], ["-statistics_phase_period is missing"]),
                               (["-statistics_phases", "-1"], ["-statistics_phases -1"]),
                               (["-statistics_phase_bins_r", "-3"], ["-statistics_phase_bins_r -3"]),
                               (["-statistics_phase_bins_z", "2.5"], ["-statistics_phase_bins_z 2.5"]),
                               (["-statistics_phase_axis", "r"], ["-statistics_phase_axis r"]),
                               (["-statistics_phase_center", "0,0"], ["-statistics_phase_center 0,0", "three numbers"]),
                               (["-statistics_phase_period", "-1"], ["-statistics_phase_period -1"]),
                               (["-statistics_phase_period", "1", "-grid_cells", "4,4,4000", "-statistics_phases", "1000"],
                                ["too many"])):
            with self.subTest(options=options):
                outcome = run(1, *steady, *options, "-output_dir", "wrong", folder=self.folder)
                self.assertEqual(outcome.returncode, 2, outcome.stdout)
                self.assertEqual(outcome.stderr.count("\n"), 1, outcome.stderr)
                for word in words:
                    self.assertIn(word, outcome.stderr)
        self.run_well(1, *steady, "-statistics_phases", "1", "-max_steps", "2", "-output_dir", "steady")  # needs no period


if __name__ == "__main__":
    unittest.main()
