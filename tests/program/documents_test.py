# SPDX-License-Identifier: BSD-3-Clause
"""The documents that the program writes of itself are those in docs/."""

import re
import shutil
import subprocess
import unittest

from support import PROGRAM, SOURCE, ProgramTest


# Options of PETSc and of the build, and beginnings of names.
PETSCS = re.compile(r"\w+_$|(momentum|pressure|cloth|walls)_(overlap_)?(ksp|pc|snes|mg)_|options_(file|view)$|log_view$|skip_petscrc$|h$|DWASHFSI_NATIVE$")


class Documents(ProgramTest):
    def test_pages_say_what_the_program_says(self):
        outcome = subprocess.run([SOURCE / "scripts" / "document", "--program", PROGRAM, "--check"],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(outcome.returncode, 0, outcome.stdout + outcome.stderr + "\nscripts/document writes them anew")

    def test_the_guide_names_every_option_and_no_other(self):
        listed = (SOURCE / "docs" / "reference" / "options.md").read_text(encoding="utf-8")
        known = set(re.findall(r"^\| `-(\w+)`", listed, re.M))
        self.assertTrue({"coupling_scheme", "CLOTH_ke", "BODY_shape", "cloth_coupling"} <= known, "names are missing")
        guide = "\n".join(path.read_text(encoding="utf-8") for path in sorted((SOURCE / "docs" / "guide").glob("*.md")))
        explained = set(re.findall(r"`-((?:NAME_)?\w+)", guide))
        generic = {re.sub(r"^(CLOTH|BODY|LINE)_", "NAME_", name) for name in known - self.old_names(listed)}
        self.assertEqual(sorted(generic - explained), [], "docs/guide names every option")
        own = generic | {"bodies_center", "cloths_ke", "drum_hub_radius", "drum_motion_file", "drum_radius"}  # NAMEs of examples
        self.assertEqual([name for name in sorted(explained) if name not in known | own and not PETSCS.match(name)], [])

    def old_names(self, listed):
        """The options under "Old names"."""
        return set(re.findall(r"^\| `-(\w+)`", listed.split("## Old names")[1], re.M))

    def test_every_case_has_a_page_with_what_it_found(self):
        gallery = SOURCE / "docs" / "gallery"
        listed = (gallery / "README.md").read_text(encoding="utf-8")
        studies = [path.name for path in (SOURCE / "inputs").iterdir() if path.is_dir() and (gallery / f"{path.name}.md").is_file()
                   and any(path.glob("*.opts"))]
        for name in [*(path.stem for path in (SOURCE / "inputs").glob("*.opts")), *studies]:
            with self.subTest(name):
                page = (gallery / f"{name}.md").read_text(encoding="utf-8")
                self.assertIn(f"({name}.md)", listed)
                self.assertTrue((gallery / f"{name}.png").is_file())
                block = re.search(r"<!-- run -->\n(.*?)<!-- end -->", page, re.S)
                self.assertTrue(block and block.group(1).strip(), "scripts/gallery writes it")

    def test_the_curves_of_the_validation_can_be_drawn_and_are_on_a_page(self):
        for name in ("scripts", "docs/validation", "tests/verification/reference"):
            shutil.copytree(SOURCE / name, self.folder / name)
        drawn, kept = (root / "docs" / "images" for root in (self.folder, SOURCE))
        drawn.mkdir()
        outcome = subprocess.run([self.folder / "scripts" / "figures"], capture_output=True, text=True, check=False)
        self.assertEqual((outcome.returncode, outcome.stdout + outcome.stderr), (0, ""))
        pictures = {path.name for path in drawn.iterdir()}
        self.assertEqual(pictures, {path.name for path in kept.glob("validation_*.png")})
        pages = "".join(path.read_text(encoding="utf-8") for path in (SOURCE / "docs" / "validation").glob("*.md") if path.stem != "README")
        self.assertEqual({name for name in pictures if f"](../images/{name})" not in pages}, set())


class Headlines(unittest.TestCase):
    """The summary of the validation has the figures of the pages that it summarises, perhaps rounded, or as what one is off by, in per cent."""

    NUMBER = re.compile(r"(?<![\w.,^/])\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w^])")
    VALIDATION = SOURCE / "docs" / "validation"

    def numbers(self, text):
        return self.NUMBER.findall(re.sub(r"`[^`\n]*`|\]\([^)]*\)", "", text))

    @staticmethod
    def stands_for(figure, number):
        """Whether a figure of the summary is this number of a page."""
        half = 0.05 * float(figure) if "e" in figure else 0.5000001 * 10.0**-len(figure.partition(".")[2])
        return any(abs(value - float(figure)) <= half for value in (float(number), 100 * abs(float(number) - 1)))

    def without_page(self, headline, pages):
        """The figures of a headline that stand on none of the pages."""
        known = {number for page in pages for number in self.numbers((self.VALIDATION / page).read_text(encoding="utf-8"))}
        return [figure for figure in self.numbers(headline) if not any(self.stands_for(figure, number) for number in known)]

    def test_figures_are_those_of_the_pages(self):
        rows = 0
        for line in (self.VALIDATION / "README.md").read_text(encoding="utf-8").splitlines():
            cells, pages = line.strip("| ").split(" | "), re.findall(r"\(([\w/]+\.md)(?:#[^)]*)?\)", line)
            if line.startswith("| ") and len(cells) == 4 and pages:
                rows += 1
                with self.subTest(cells[0]):
                    self.assertEqual(self.without_page(cells[2], pages), [])
        self.assertGreater(rows, 30)

    def test_the_test_sees_them(self):
        self.assertEqual(self.without_page("St 0.9517, Re = 100", ["cylinder.md"]), ["0.9517"])


if __name__ == "__main__":
    unittest.main()
