# SPDX-License-Identifier: BSD-3-Clause
"""Every place that names the version names the same."""

import re
import unittest

from support import SOURCE

PLACES = {  # file -> what stands before the version
    "CMakeLists.txt": r"project\(washfsi VERSION ",
    "CITATION.cff": r"\nversion: ",
    "CHANGELOG.md": r"\n## \[",
    "packaging/debian/changelog": r"^washfsi \(",
    "packaging/spack/packages/washfsi/package.py": r"\n    version\(\"",
}


class Release(unittest.TestCase):
    def test_versions_agree(self):
        found = {name: re.search(before + r"(\d+\.\d+\.\d+)", (SOURCE / name).read_text(encoding="utf-8"))
                 for name, before in PLACES.items()}
        self.assertEqual([name for name, match in found.items() if match is None], [])
        self.assertEqual(len({match.group(1) for match in found.values()}), 1, found)

    def test_packages_depend_on_what_the_source_needs(self):
        """What scripts/install-dependencies installs to build with, the Debian package is built with."""
        script = (SOURCE / "scripts" / "install-dependencies").read_text(encoding="utf-8")
        control = (SOURCE / "packaging" / "debian" / "control").read_text(encoding="utf-8")
        needed = [word for word in re.search(r"packages=\((.*?)\)", script, re.S).group(1).split()
                  if word.endswith("-dev") and "gtest" not in word]
        self.assertGreater(len(needed), 5)
        self.assertEqual([word for word in needed if word not in control], [])


if __name__ == "__main__":
    unittest.main()
