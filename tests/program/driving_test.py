# SPDX-License-Identifier: BSD-3-Clause
"""Driven water: what drives it balances what holds it, on any number of ranks, and goes on after a restart."""

import unittest

import numpy as np

from support import TIGHT, ProgramTest, read_columns, relative_difference

PERIODIC = ["-bc_x_lower", "periodic", "-bc_x_upper", "periodic"]
CYLINDER = ["-grid_cells", "48,32", "-grid_upper", "1.5,1", *PERIODIC, "-fluid_density", "1", "-fluid_viscosity", "0.05",
            "-bodies", "post", "-post_shape", "sphere", "-post_radius", "0.2", "-post_center", "0.7,0.45",
            "-time_step", "0.01", "-history_interval", "0.1", *TIGHT]
CHANNEL_3D = ["-grid_cells", "16,12,8", "-grid_upper", "3,2,1.5", *PERIODIC, "-bc_z_lower", "periodic",
              "-bc_z_upper", "periodic", "-fluid_density", "1", "-fluid_viscosity", "0.01", "-fluid_initial", "channel",
              "-fluid_initial_velocity", "1,0,0", "-fluid_bulk_velocity", "1,0,0", "-fluid_initial_seed", "7",
              "-fluid_pressure_gradient", "0,0,-0.1", "-time_step", "0.02", *TIGHT]


class Driving(ProgramTest):
    def history(self, name, *options, ranks=1):
        """Runs a case and returns its history."""
        self.run_well(ranks, *options, "-output_dir", name)
        return read_columns(self.folder / name / "history.csv")

    def test_loads_balance_what_drives(self):
        for method in ("mapping", "direct_forcing"):
            for driven in (["-fluid_pressure_gradient", "-0.5,0"], ["-fluid_bulk_velocity", "0.3,0"]):
                with self.subTest(method=method, driven=driven[0]):
                    end = self.history(f"{method}{driven[0]}", *CYLINDER, *driven, "-body_method", method,
                                       "-body_balance", "true", "-time_end", "12")
                    end = {name: values[-1] for name, values in end.items()}
                    drives = -end["pressure_gradient_x"] * 1.5
                    self.assertGreater(drives, 0)
                    held = end["wall_y_lower_force_x"] + end["wall_y_upper_force_x"] + end["post_force_x"]
                    self.assertLess(abs(held / drives - 1), 2e-3)
                    self.assertLess(abs(end["post_balance_force_x"] / end["post_force_x"] - 1), 0.05)
                    self.assertLess(abs(end["driving_power"] / (drives * end["bulk_velocity_x"]) - 1), 1e-3)
                    self.assertLess(abs(end["driving_power"] / end["dissipation"] - 1), 0.1)

    def test_energy_of_a_driven_channel_is_in_balance(self):
        channel = ["-grid_cells", "8,32", *PERIODIC, "-fluid_density", "1", "-fluid_viscosity", "0.1", "-time_step",
                   "0.005", *TIGHT, "-fluid_pressure_gradient", "-1,0", "-time_end", "3"]
        history = self.history("channel", *channel)
        dt = np.diff(history["time"], prepend=0)
        put_in = (dt * history["driving_power"]).sum()
        left = put_in - (dt * history["dissipation"]).sum() - history["kinetic_energy"][-1]
        self.assertLess(abs(left / put_in), 5e-3)
        self.assertIn("energy open", (self.folder / "channel" / "summary.json").read_text())

    def test_history_agrees_on_one_to_three_ranks(self):
        tables = [self.history(f"on_{ranks}", *CHANNEL_3D, "-time_end", "0.4", ranks=ranks) for ranks in (1, 2, 3)]
        self.assertLess(np.abs(tables[0]["bulk_velocity_x"] - 1).max(), 1e-12)
        self.assertGreater(tables[0]["bulk_velocity_z"][-1], 0.03)
        for table in tables[1:]:
            for name in table.keys() - {"max_divergence"}:
                self.assertLess(relative_difference(table[name], tables[0][name]), 1e-8, name)

    def test_restart_goes_on_bit_for_bit(self):
        self.assert_restart_goes_on(self.history, CHANNEL_3D, 0.2, 0.4)

    def test_start_depends_on_the_seed(self):
        energies = [self.history(f"seed_{seed}", *CHANNEL_3D, "-fluid_initial_seed", seed, "-time_end", "0.02")
                    ["kinetic_energy"][0] for seed in (1, 1, 2)]
        self.assertEqual(energies[0], energies[1])
        self.assertNotEqual(energies[0], energies[2])

    def test_vortices_in_space_start_with_their_energy(self):
        sides = [word for axis in "xyz" for end in ("lower", "upper") for word in (f"-bc_{axis}_{end}", "periodic")]
        box = ["-grid_cells", "16,16,12", "-grid_upper", "2,2,3", *sides, "-fluid_density", "1", "-fluid_viscosity", "0",
               "-fluid_initial", "taylor_green_3d", "-time_step", "1e-4", "-max_steps", "1", "-time_end", "1"]
        for given, speed in (([], 1), (["-fluid_initial_velocity", "3,0,0"], 3)):
            history = self.history(f"vortices_{speed}", *box, *given)
            self.assertAlmostEqual(history["kinetic_energy"][0] / (12 * speed ** 2 / 8), 1, places=6)


if __name__ == "__main__":
    unittest.main()
