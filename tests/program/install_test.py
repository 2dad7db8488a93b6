# SPDX-License-Identifier: BSD-3-Clause
"""What is installed can be used: a project of others finds the library, builds on it and runs; the program runs too, also
from Python.
Argument: the folder of the build."""

import os
import re
import subprocess
import sys
import unittest

from support import PATIENCE, SOURCE, ProgramTest

BUILD = sys.argv.pop(1)


class Install(ProgramTest):
    def call(self, *words, environment=None):
        """Runs a command, which must succeed; returns what it prints."""
        outcome = subprocess.run([str(word) for word in words], cwd=self.folder, capture_output=True, text=True,
                                 check=False, timeout=PATIENCE * 250, env=environment)
        self.assertEqual(outcome.returncode, 0, outcome.stdout + outcome.stderr)
        return outcome.stdout

    def test_another_project_builds_on_it(self):
        place = self.folder / "installed"
        self.call("cmake", "--install", BUILD, "--prefix", place)
        self.call("cmake", "-S", SOURCE / "examples" / "taylor_green", "-B", "example", f"-DCMAKE_PREFIX_PATH={place}",
                  "-DCMAKE_BUILD_TYPE=Release")
        self.call("cmake", "--build", "example")
        printed = self.call("mpirun", "--oversubscribe", "--bind-to", "none", "-n", 2, "example/taylor_green")
        ratio = float(re.search(r"exact one ([0-9.]+)", printed).group(1))
        self.assertLess(abs(ratio - 1), 0.003)
        self.call(place / "bin" / "washfsi", "-options_file", place / "share" / "washfsi" / "inputs" / "cavity.opts",
                  "-max_steps", 2, "-output_dir", self.folder / "out")
        cavity = place / "share" / "washfsi" / "inputs" / "cavity.opts"
        lines = f"import washfsi; print(washfsi.run('{cavity}', 'python', {{'max_steps': 2}}).history['step'][-1])"
        module = {"PYTHONPATH": str(place / "lib" / "python3" / "dist-packages")}
        environment = {name: value for name, value in os.environ.items() if name != "WASHFSI_PROGRAM"} | module
        self.assertEqual(float(self.call(sys.executable, "-c", lines, environment=environment)), 2)
        lines = "import washfsi; from washfsi.report.page import page_of; print(page_of([washfsi.Results('python')]))"
        self.assertIn("washfsiReport", self.call(sys.executable, "-c", lines, environment=environment))


if __name__ == "__main__":
    unittest.main()
