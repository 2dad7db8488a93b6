# SPDX-License-Identifier: BSD-3-Clause
"""Names of options: old ones hold and say so, and groups have defaults for all."""

import unittest

from support import CAVITY, WASH, ProgramTest


class Options(ProgramTest):
    def resolved(self, *options):
        """Returns what a check prints, and the options that it says it used."""
        printed = self.run_well(1, *options, "-check", "-output_dir", self.folder)
        lines = (self.folder / "resolved.opts").read_text(encoding="utf-8").splitlines()
        return printed, dict(line[1:].split(" ", 1) for line in lines if line.startswith("-") and " " in line)

    def test_old_name_holds_and_says_so(self):
        printed, used = self.resolved("-options_file", WASH, "-cloth_coupling", "explicit", "-cloth_tolerance", 1e-4)
        self.assertIn("note: -cloth_coupling is the old name of -coupling_scheme", printed)
        self.assertIn("note: -cloth_tolerance is the old name of -coupling_tolerance", printed)
        self.assertEqual(used["coupling_scheme"], "explicit")  # the command line counts more than the file
        self.assertEqual(float(used["coupling_tolerance"]), 1e-4)
        self.assertNotIn("cloth_coupling", used)

    def test_new_name_on_the_command_line_overrides_the_old_one_in_a_file(self):
        case = self.folder / "case.opts"
        case.write_text("-cloth_coupling explicit\n", encoding="utf-8")
        _, used = self.resolved("-options_file", CAVITY, "-options_file", case, "-coupling_scheme", "midpoint")
        self.assertEqual(used["coupling_scheme"], "midpoint")

    def test_groups_have_defaults_for_all(self):
        _, used = self.resolved("-options_file", WASH, "-cloths_hold_stiffness", 7, "-cloths_ke", 5e3,
                                "-bodies_center", "0.001,0")
        self.assertEqual(used["drum_center"], "0.001,0")
        self.assertEqual(used["agitator_center"], "0.001,0")
        self.assertEqual(float(used["short_hold_stiffness"]), 7)
        self.assertEqual(float(used["long_ke"]), 8e3)  # the group's own counts more


if __name__ == "__main__":
    unittest.main()
