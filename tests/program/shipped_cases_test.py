# SPDX-License-Identifier: BSD-3-Clause
"""What -check warns of in a shipped case is explained in the case's header, by the name that the report gives it, and nothing else is.

`shipped_cases_test.py full` takes the large cases too, which take long to set up."""

import math
import re
import sys
import unittest

from support import SOURCE, ProgramTest

FULL = "full" in sys.argv
INPUTS = SOURCE / "inputs"
FRONT_DOOR = INPUTS / "wash.opts"
LARGE = 30000  # cells
NO_CASES = {INPUTS / "thesis" / "base" / name for name in ("plane.opts", "space.opts")}  # numerics that cases share
EXPLANATIONS = re.compile(r"^# -check warns[^\n]*\n((?:#   +\S[^\n]*\n)+)", re.M)
MACHINE = ["-options_file", FRONT_DOOR, "-grid_cells", "12,12,12", "-towel_markers", 4, "-contact_body_distance", 0, "-check"]


def explained(path):
    """Returns the findings that a case's header explains, with the reasons."""
    header = re.match(r"(?:#[^\n]*\n)*", path.read_text(encoding="utf-8"))[0]
    found = EXPLANATIONS.search(header)
    if not found:
        return {}
    text = re.sub(r"\n#     +", " ", found[1])  # lines that go on
    return dict(line[4:].split(": ", 1) for line in text.strip().splitlines())


def cell_count(path):
    """Returns the cells of a case, which may be those of a file that it names."""
    text = path.read_text(encoding="utf-8")
    cells = re.search(r"^-grid_cells (\S+)", text, re.M)
    if cells:
        return math.prod(map(int, cells[1].split(",")))
    return cell_count(path.parent / re.search(r"^-options_file (\S+)", text, re.M)[1])


class ShippedCases(ProgramTest):
    def findings(self, *options):
        """Returns the verdict on each thing that was looked at."""
        lines = [line for line in self.run_well(1, *options).splitlines() if line[:8] in ("  ok    ", "  warn  ", "  fail  ")]
        return {line[8:30].strip(): line[2:6].strip() for line in lines}

    def test_warnings_are_those_that_the_header_explains(self):
        cases = sorted(set(INPUTS.glob("**/*.opts")) - NO_CASES)
        self.assertGreater(len(cases), 40)
        for path in cases:
            if not FULL and path != FRONT_DOOR and cell_count(path) > LARGE:
                continue
            with self.subTest(str(path.relative_to(INPUTS))):
                found = self.findings("-options_file", path, "-check", "-output_dir", self.folder / "out")
                self.assertNotIn("fail", found.values())
                reasons = explained(path)
                self.assertEqual({name for name, verdict in found.items() if verdict == "warn"}, set(reasons))
                self.assertTrue(all(len(reason) > 10 for reason in reasons.values()), reasons)

    def test_a_demonstration_says_so(self):
        """So many cycles as are advised are no longer one, and no longer warned of."""
        line, = re.findall("^  cycles    .*", self.run_well(1, *MACHINE), re.M)
        self.assertIn("one, which is start-up: a demonstration; figures of a machine need 3", line)
        end = re.search(r"-time_end (\S+)", line)[1]
        printed = self.run_well(1, *MACHINE, "-time_end", end)
        self.assertNotIn("demonstration", printed)
        self.assertRegex(printed, r"(?m)^  ok    cycles +3 of")
        self.assertIn("cycles    not one complete: a demonstration", self.run_well(1, *MACHINE, "-time_end", 1))


if __name__ == "__main__":
    unittest.main(argv=[word for word in sys.argv if word != "full"])
