# SPDX-License-Identifier: BSD-3-Clause
"""What is installed can be used: a project of others finds the library, builds on it and runs; the program and the scripts run
by their names, Python finds the module, a shell completes options, and the manual pages tell all options.
Argument: the folder of the build."""

import os
import re
import subprocess
import sys
import unittest

from support import PATIENCE, SOURCE, ProgramTest

BUILD = sys.argv.pop(1)
COMPLETE = """source {file}
COMP_WORDS=(washfsi {words}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); COMPREPLY=()
_washfsi 2>/dev/null; echo "${{COMPREPLY[@]}}"
"""


class Install(ProgramTest):
    def setUp(self):
        super().setUp()
        self.place = self.folder / "installed"
        self.call("cmake", "--install", BUILD, "--prefix", self.place)
        self.inputs = self.place / "share" / "washfsi" / "inputs"

    def call(self, *words, environment=None):
        """Runs a command, which must succeed; returns what it prints."""
        outcome = subprocess.run([str(word) for word in words], cwd=self.folder, capture_output=True, text=True,
                                 check=False, timeout=PATIENCE * 250, env=environment)
        self.assertEqual(outcome.returncode, 0, outcome.stdout + outcome.stderr)
        return outcome.stdout

    def as_user(self, *words):
        """Runs an installed command as somebody does who has no source: nothing tells where program and module are."""
        environment = {name: value for name, value in os.environ.items()
                       if name not in ("WASHFSI_PROGRAM", "WASHFSI_SOURCE", "PYTHONPATH")}
        return self.call(self.place / "bin" / words[0], *words[1:], environment=environment)

    def test_another_project_builds_on_it(self):
        self.call("cmake", "-S", SOURCE / "examples" / "taylor_green", "-B", "example", f"-DCMAKE_PREFIX_PATH={self.place}",
                  "-DCMAKE_BUILD_TYPE=Release")
        self.call("cmake", "--build", "example")
        printed = self.call("mpirun", "--oversubscribe", "--bind-to", "none", "-n", 2, "example/taylor_green")
        ratio = float(re.search(r"exact one ([0-9.]+)", printed).group(1))
        self.assertLess(abs(ratio - 1), 0.003)

    def test_program_module_and_scripts_run_from_there(self):
        cavity = self.inputs / "cavity.opts"
        self.as_user("washfsi", "-options_file", cavity, "-max_steps", 2, "-output_dir", self.folder / "out")
        self.assertIn("report.html", self.as_user("washfsi-report", "out"))
        self.assertIn("washfsiReport", (self.folder / "out" / "report.html").read_text(encoding="utf-8"))
        self.as_user("washfsi-plot", "out")
        self.assertTrue((self.folder / "out" / "history.png").is_file())
        self.as_user("washfsi-study", "--jobs", 1, "--ranks", 1, cavity, "--", "-max_steps", 2)
        self.assertTrue((self.folder / "out" / "study" / "study.csv").is_file(), "a study is where it was called")
        self.as_user("washfsi-write-agitator", "agitator.stl")
        lines = f"import washfsi; print(washfsi.run('{cavity}', 'python', {{'max_steps': 2}}).history['step'][-1])"
        module = {"PYTHONPATH": str(self.place / "share" / "washfsi" / "python")}
        environment = {name: value for name, value in os.environ.items() if name != "WASHFSI_PROGRAM"} | module
        self.assertEqual(float(self.call(sys.executable, "-c", lines, environment=environment)), 2)

    def complete(self, *words):
        """Returns what bash offers for the last word."""
        file = self.place / "share" / "bash-completion" / "completions" / "washfsi"
        return self.call("bash", "-c", COMPLETE.format(file=file, words=" ".join(words))).split()

    def test_a_shell_completes_options(self):
        self.assertIn("-coupling_scheme", self.complete("-coup"))
        self.assertEqual(self.complete("-coupling_scheme", "im"), ["implicit"])
        wash = ("-options_file", str(self.inputs / "wash.opts"))
        self.assertIn("-agitator_vanes", self.complete(*wash, "-agitator_v"))
        self.assertEqual(self.complete(*wash, "-towel_fab"), ["-towel_fabric"])
        self.assertIn("-tub_shape", self.complete("-bodies", "drum,tub", "-tub_sh"))
        self.assertIn("cylinder", self.complete("-bodies", "tub", "-tub_shape", "cyl"))
        self.assertEqual(self.complete("-nothing_of_that_name"), [])

    def test_manual_pages_tell_every_option(self):
        text = (self.place / "share" / "man" / "man1" / "washfsi.1").read_text(encoding="utf-8").replace("\\-", "-")
        listed = (SOURCE / "docs" / "reference" / "options.md").read_text(encoding="utf-8").split("## Old names")[0]
        names = re.findall(r"^\| `-(\w+)`", listed, re.M)
        self.assertGreater(len(names), 150)
        self.assertEqual([name for name in names if f".B -{name}\n" not in text], [])


if __name__ == "__main__":
    unittest.main()
