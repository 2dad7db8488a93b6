# SPDX-License-Identifier: BSD-3-Clause
"""Names of options: old ones hold and say so, and groups have defaults for all."""

import re
import unittest

from support import CAVITY, SOURCE, WASH, ProgramTest

MACHINE = SOURCE / "inputs" / "wash.opts"


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

    def test_help_tells_each_option_once(self):
        for case in (WASH, MACHINE):
            told = re.findall(r"^ +-(\w+)", self.run_well(1, "-options_file", case, "-help"), re.M)
            ours = [name for name in told if name.split("_")[0] in ("grid", "drum", "agitator", "towel", "long")]
            self.assertGreater(len(ours), 40)
            self.assertEqual(sorted(set(ours)), sorted(ours))

    def test_help_tells_the_defaults_of_the_chosen_shape(self):
        self.assertIn("-agitator_tip_radius <now 0.16 ", self.run_well(1, "-options_file", MACHINE, "-help"))

    def test_log_has_no_stage_without_a_name(self):
        log = self.run_well(1, "-options_file", CAVITY, "-grid_cells", "8,8", "-max_steps", 1, "-log_view")
        self.assertIn("Event Stage 0: Main Stage", log)
        self.assertNotRegex(log, r"Event Stage \d+: Unknown")


if __name__ == "__main__":
    unittest.main()
