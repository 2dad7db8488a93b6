# SPDX-License-Identifier: BSD-3-Clause
"""Bodies that move by a programme of speeds or by a table, in short runs."""

import unittest

import numpy as np

from support import ProgramTest, read_columns

DRUM = ["-grid_cells", "24,24", "-grid_lower", "-0.35,-0.35", "-grid_upper", "0.35,0.35", "-fluid_viscosity", 1,
        "-bodies", "drum", "-body_method", "mapping", "-drum_radius", 0.3, "-drum_inverted", "-time_step", 2e-3, "-time_end", 0.1]
IN_SPACE = ["-grid_cells", "16,16,8", "-grid_lower", "-0.35,-0.35,0", "-grid_upper", "0.35,0.35,0.3",
            "-drum_shape", "cylinder", "-drum_height", 2, "-bc_z_lower", "slip", "-bc_z_upper", "slip"]
# with ends of its own, two cells from those of the box, which rest
CLOSED = ["-grid_cells", "16,16,12", "-grid_lower", "-0.35,-0.35,0", "-grid_upper", "0.35,0.35,0.3",
          "-drum_shape", "cylinder", "-drum_height", 0.2, "-drum_center", "0,0,0.15"]
PROGRAMME = ["-drum_rpm", 45, "-drum_ramp", 0.02, "-drum_stroke", 0.05, "-drum_pause", 0.02]


class Motion(ProgramTest):
    def history(self, folder, *options):
        """Runs the drum and returns the columns of its history."""
        self.run_well(1, *DRUM, "-output_dir", folder, *options)
        return read_columns(self.folder / folder / "history.csv")

    def test_drum_that_starts_by_a_ramp_has_no_jolt(self):
        jolt = self.history("jolt", "-drum_rpm", 45, "-max_steps", 5)["drum_torque"]
        ramp = self.history("ramp", "-drum_rpm", 45, "-drum_ramp", 0.08)["drum_torque"]
        self.assertGreater(np.abs(jolt).max(), 200 * np.abs(ramp).max())
        self.assertLess(np.abs(ramp[0]), 0.05 * np.abs(ramp).max())

    def test_water_that_turns_with_the_drum_needs_no_torque(self):
        for options in ([], IN_SPACE, CLOSED):
            turning = ["-drum_rpm", 45, "-max_steps", 5, *options]
            for start in ([], ["-fluid_initial_body", "drum"]):
                rotation = self.history("rotation", *turning, "-fluid_initial", "rotation", *start)
                torque = rotation["drum_torque_z" if options else "drum_torque"]
                self.assertLess(rotation["max_divergence"].max(), 1e-12)
                energy = rotation["kinetic_energy"]
                self.assertLess(np.ptp(energy), 1e-3 * energy[0])
            rest = self.history("rest", *turning)
            self.assertLess(np.abs(torque).max(), 1e-4 * np.abs(rest["drum_torque_z" if options else "drum_torque"]).max())

    def test_walls_behind_a_turning_drum_have_no_columns(self):
        columns = self.history("out", "-drum_rpm", 45, "-max_steps", 1)
        self.assertIn("drum_torque", columns)
        self.assertEqual([name for name in columns if name.startswith("wall_")], [])

    def test_programme_is_a_function_of_time_alone(self):
        whole = self.history("out", *PROGRAMME)
        self.history("parts", *PROGRAMME, "-time_end", 0.06)
        self.history("parts", *PROGRAMME, "-restart", "parts/checkpoint.h5")
        self.assertEqual((self.folder / "out" / "history.csv").read_text(),
                         (self.folder / "parts" / "history.csv").read_text())
        self.assertGreater(np.abs(whole["drum_torque"]).max(), 1)

    def test_table_of_speeds_gives_the_speed(self):
        (self.folder / "speeds.csv").write_text("time,speed\n# s,rpm\n0,0\n0.04,45\n0.1,45\n")
        table = self.history("table", "-drum_speed_file", "speeds.csv")
        speed = -table["drum_power"] / table["drum_torque"]  # of the drum on the water, and of the water on the drum
        middle = table["time"] - 0.5 * table["dt"]  # where loads are taken
        np.testing.assert_allclose(speed, 45 * np.pi / 30 * np.minimum(middle / 0.04, 1), rtol=1e-6)

    def test_angles_in_degrees_are_angles_in_radians(self):
        for name, turn in (("rad", np.pi / 6), ("deg", 30)):
            (self.folder / f"{name}.csv").write_text(f"0,0,0,0\n0.1,0,0,{turn!r}\n")
            self.history(name, "-drum_motion_file", f"{name}.csv", "-drum_angle_unit", name)
        energy = [read_columns(self.folder / name / "history.csv")["kinetic_energy"] for name in ("rad", "deg")]
        np.testing.assert_allclose(*energy, rtol=1e-9)


if __name__ == "__main__":
    unittest.main()
