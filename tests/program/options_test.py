# SPDX-License-Identifier: BSD-3-Clause
"""Names of options: old ones hold and say so, and groups have defaults for all."""

import json
import re
import unittest

from support import CAVITY, SOURCE, WASH, ProgramTest, run

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

    def test_old_value_holds_and_says_so(self):
        printed, used = self.resolved("-options_file", WASH, "-contact", "cushion", "-contact_pressure", 100)
        self.assertIn("note: -contact cushion is the old name of penalty", printed)
        self.assertEqual(used["contact"], "penalty")

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

    def write(self, path, *lines):
        """Writes an options file into the test's folder."""
        path = self.folder / path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return path

    def test_empty_lists_switch_all_off(self):
        printed, used = self.resolved("-options_file", WASH, "-cloths", "", "-bodies", "", "-time_step", 1e-3)
        for name in ("long", "short", "drum", "agitator"):
            self.assertEqual(len(re.findall(rf"^warning: .* does not name {name} .*-{name}_\w+", printed, re.M)), 1)
            self.assertEqual([option for option in used if option.startswith(name + "_")], [])
        self.assertNotIn("cloth ", printed)

    def test_a_later_file_may_switch_off_what_an_earlier_one_has(self):
        later = self.write("later.opts", "-cloths long", "-agitator_shape sphere  # no vanes", "-agitator_radius 0.1")
        printed, used = self.resolved("-options_file", WASH, "-options_file", later)
        self.assertIn("warning: -cloths does not name short any more", printed)
        self.assertIn("warning: -agitator_shape is another now, so without effect: -agitator_hub_radius", printed)
        self.assertEqual(len(re.findall("^warning", printed, re.M)), 2)
        self.assertNotIn("short_size", used)
        nested = self.write("nested.opts", f"-options_file {WASH}", '-cloths ""')
        self.assertIn("-cloths does not name long", self.resolved("-options_file", nested)[0])
        self.assertNotIn("warning", self.resolved("-options_file", self.folder / "resolved.opts")[0])

    def test_defaults_are_what_we_recommend(self):
        """And nobody is told of a default that is of no matter to the run."""
        box = ["-grid_cells", "16,16", "-time_step", 1e-3, "-time_end", 1]
        ball = ["-bodies", "ball", "-ball_radius", 0.1, "-ball_center", "0.3,0.5"]
        line = ["-cloths", "line", "-line_size", 0.3, "-line_markers", 8, "-line_center", "0.7,0.5", "-line_direction", "0,1", "-line_ke", 100]
        for options, contact in (([*ball, *line], "barrier"), ([*ball, *line, "-contact", "penalty", "-contact_pressure", 100], "penalty"),
                                 ([*ball, *line, "-contact", "none"], "none"), ([*line, "-coupling_scheme", "midpoint"], "barrier"),
                                 ([*ball, *line, "-fluid", "none"], "barrier"), (ball, "none"), ([], "none")):
            with self.subTest(options):
                printed, used = self.resolved(*box, *options)
                self.assertEqual([used[name] for name in ("body_method", "contact", "coupling_order")], ["direct_forcing", contact, "2"])
                self.assertNotRegex(printed, r"(?m)^(warning|note): .*(body_method|contact|coupling_order)")

    def test_a_preset_stands_for_its_options_and_gives_way_to_all_others(self):
        machine = {"body_slip_tolerance": 5e-4, "coupling_tolerance": 1e-4, "time_tolerance": 5e-4, "time_cfl": 0.55}
        line = ["-cloths", "line", "-line_size", 0.3, "-line_markers", 8, "-line_center", "0.5,0.5", "-line_ke", 100, "-bodies", "ball",
                "-ball_radius", 0.1, "-ball_center", "0.3,0.2", "-grid_cells", "16,16", "-time_step", 1e-3, "-time_end", 1]
        own = self.write("own.opts", "-time_cfl 0.3")
        for options, cfl in ((line, 0.55), (["-options_file", own, *line], 0.3), ([*line, "-time_cfl", 0.4], 0.4)):
            with self.subTest(options):
                printed, used = self.resolved(*options, "-preset", "machine")
                self.assertEqual({name: float(used[name]) for name in machine}, {**machine, "time_cfl": cfl})
                self.assertNotIn("warning: -", printed)
        file = self.write("case.opts", "-preset machine")
        self.assertEqual(float(self.resolved("-options_file", file, *line, "-preset", "none")[1]["time_cfl"]), 0)
        again = self.resolved("-options_file", self.folder / "resolved.opts")[1]
        self.assertEqual(float(again["time_cfl"]), 0)

    def test_a_presets_options_that_have_no_effect_are_no_matter(self):
        box = ["-grid_cells", "16,16", "-time_step", 1e-3, "-time_end", 1, "-preset", "machine"]
        self.assertNotRegex(self.resolved(*box)[0], r"(?m)^(warning|note): -")
        self.assertIn("so without effect: -coupling_tolerance", self.resolved(*box, "-coupling_tolerance", 1e-3)[0])

    def test_default_shape_that_another_replaces(self):
        case = self.write("case.opts", "-grid_cells 16,16", "-bodies pole", "-body_method mapping", "-pole_radius 0.1", "-time_end 1",
                          "-time_step 0.1")
        printed, _ = self.resolved("-options_file", case, "-pole_shape", "box", "-pole_size", "0.2,0.2")
        self.assertIn("warning: -pole_shape is another now, so without effect: -pole_radius", printed)

    def test_misspelt_options_are_refused_beside_parts_that_are_switched_off(self):
        for options in (["-logn_size", 1], ["-long_sizee", 1], ["-agitator_vains", 3]):
            outcome = run(1, "-options_file", WASH, "-cloths", "short", "-agitator_shape", "sphere",
                          "-agitator_radius", 0.1, *options, folder=self.folder)
            self.assertEqual(outcome.returncode, 2, outcome.stdout)
            self.assertIn(f"{options[0]} {options[1]}: no part of this run reads this option", outcome.stderr)

    def test_an_option_of_another_shape_in_one_file_is_refused(self):
        case = self.write("case.opts", "-grid_cells 16,16", "-bodies pole", "-body_method mapping", "-pole_shape box",
                          "-pole_size 0.2,0.2", "-pole_radius 0.1", "-time_end 1", "-time_step 0.1")
        self.assertEqual(run(1, "-options_file", case, folder=self.folder).returncode, 2)

    def test_files_named_in_a_file_are_relative_to_it(self):
        self.write("cases/parts/drum.opts", "-bodies drum", "-body_method mapping", "-drum_motion_file ../tables/turn.csv")
        self.write("cases/tables/turn.csv", "0,0,0,0", "1,0,0,3")
        case = self.write("cases/case.opts", "-grid_cells 16,16", "-time_end 0.02", "-time_step 0.01",
                          "-options_file parts/drum.opts", "-drum_radius 0.2", "-drum_center 0.5,0.5")
        _, used = self.resolved("-options_file", case.relative_to(self.folder))
        self.assertEqual(used["drum_motion_file"], str(self.folder / "cases" / "tables" / "turn.csv"))
        moved = self.write("elsewhere/resolved.opts", (self.folder / "resolved.opts").read_text(encoding="utf-8"))
        self.assertEqual(self.resolved("-options_file", moved)[1], used)
        self.assertNotIn("drum_motion_file", self.resolved("-options_file", case, "-drum_motion_file", "")[1])
        here = self.write("here.csv", "0,0,0,0", "1,0,0,2").name
        self.assertEqual(self.resolved("-options_file", case, "-drum_motion_file", here)[1]["drum_motion_file"],
                         str(self.folder / here))

    def test_names_of_files_may_have_blanks(self):
        self.write("two words/turn.csv", "0,0,0,0", "1,0,0,3")
        case = self.write("two words/case.opts", "-grid_cells 16,16", "-time_end 0.02", "-time_step 0.01", "-bodies drum",
                          "-body_method mapping", "-drum_radius 0.2", "-drum_center 0.5,0.5", "-drum_motion_file 'turn.csv' # quoted")
        used = self.resolved("-options_file", case)[1]["drum_motion_file"]
        self.assertEqual(used, f'"{self.folder}/two words/turn.csv"')
        self.assertEqual(self.resolved("-options_file", self.folder / "resolved.opts")[1]["drum_motion_file"], used)

    def test_resolved_options_keep_the_name_of_the_case(self):
        small = ["-options_file", CAVITY, "-grid_cells", "8,8", "-max_steps", 2]
        self.run_well(1, *small, "-output_dir", "first")
        self.run_well(2, "-options_file", "first/resolved.opts", "-restart", "first/checkpoint.h5", "-max_steps", 4,
                      "-output_dir", "again")
        self.run_well(1, *small, "-case_name", "box", "-output_dir", "named")
        names = [json.loads((self.folder / name / "summary.json").read_text())["case"]
                 for name in ("first", "again", "named")]
        self.assertEqual(names, ["cavity", "cavity", "box"])

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
