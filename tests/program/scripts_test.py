# SPDX-License-Identifier: BSD-3-Clause
"""scripts/run and scripts/test install and build no more than they need, tell how far they are, and are silent when nothing is to
be done. Stand-ins take the places of apt, dpkg, cmake, ninja, mpirun and ctest."""

import os
import pty
import shutil
import subprocess
import time
import unittest

from support import SOURCE, ProgramTest

STAND_IN = """#!/usr/bin/python3
import pathlib, sys
here = pathlib.Path(__file__).resolve().parent
with open(here / "calls", "a") as file:
    print(pathlib.Path(sys.argv[0]).name, *sys.argv[1:], file=file)
"""
APT = STAND_IN + """
if "install" in sys.argv:
    print("Reading package lists...")
    for percent in range(101):
        print(f"dlstatus:1:{percent}.5:Retrieving file")
        print("Preparing to unpack ...")
    for percent in range(101):
        print(f"pmstatus:g++:{percent}.25:Unpacking g++")
    if (here / "apt_fails").exists():
        print("E: Unable to locate package petsc-dev")
        sys.exit(100)
"""
DPKG = STAND_IN + """
if (here / "installed").exists():
    for name in sys.argv[3:]:
        print(name, "installed")
"""
CMAKE = STAND_IN + """
pathlib.Path("build").mkdir(exist_ok=True)
pathlib.Path("build/build.ninja").touch()
if any("BUILD_TESTING" in word for word in sys.argv):
    pathlib.Path("build/CMakeCache.txt").write_text("BUILD_TESTING:BOOL=" + sys.argv[-1].split("=")[1] + "\\n")
print("-- Configuring done")
"""
NINJA = STAND_IN + """
print("ninja: Entering directory `build'")
print("[0 2] Re-checking globbed directories...")
print("[1 4] cd somewhere && cmake -P version.cmake")
if not pathlib.Path("build/bin/washfsi").exists():
    for number in range(1, 217):
        print(f"[{number} 216] Building CXX object {number}.cpp.o", flush=True)
        if number == 100 and (here / "compiler_fails").exists():
            print("FAILED: 101.cpp.o\\nerror: no such thing\\nninja: build stopped: subcommand failed.")
            sys.exit(1)
    pathlib.Path("build/bin").mkdir(parents=True)
    pathlib.Path("build/bin/washfsi").touch()
    pathlib.Path("build/bin/washfsi").chmod(0o755)
"""
MPIRUN = STAND_IN + 'print("the program")\n'
STAND_INS = {"apt-get": APT, "dpkg-query": DPKG, "cmake": CMAKE, "ninja": NINJA, "mpirun": MPIRUN, "ctest": STAND_IN}


class Scripts(ProgramTest):
    def setUp(self):
        super().setUp()
        self.tree, self.tools = self.folder / "tree", self.folder / "tools"
        shutil.copytree(SOURCE / "scripts", self.tree / "scripts")
        self.tools.mkdir()
        for name, text in STAND_INS.items():
            (self.tools / name).write_text(text, encoding="utf-8")
            (self.tools / name).chmod(0o755)

    def call(self, *words):
        """Calls a script beside the stand-ins; returns its status and what it prints."""
        outcome = subprocess.run([self.tree / "scripts" / words[0], *words[1:]], capture_output=True, text=True, check=False,
                                 env={**os.environ, "PATH": f"{self.tools}:{os.environ['PATH']}"}, timeout=60)
        return outcome.returncode, outcome.stdout, outcome.stderr

    def calls(self, name):
        """Returns the words of each call of a stand-in."""
        lines = (self.tools / "calls").read_text(encoding="utf-8").splitlines()
        return [line.split()[1:] for line in lines if line.split()[0] == name]

    @unittest.skipIf(os.geteuid() != 0, "apt is asked as root")
    def test_a_first_run_tells_what_it_does_and_builds_the_program_alone(self):
        status, printed, _ = self.call("run", "-time_end", "1")
        self.assertEqual(status, 0)
        lines = printed.splitlines()
        self.assertRegex(lines[0], r"a first build takes some 2 minutes .* about \d+ minutes to compile")
        self.assertEqual(lines[-1], "the program")
        self.assertEqual([words[-1] for words in self.calls("ninja")], ["washfsi"])
        for what in ("fetched", "set up", "compiling"):  # a line for each tenth, and no others
            self.assertIn(sum(what in line for line in lines), range(9, 13), printed)
        self.assertIn("compiling 216 of 216", printed)
        self.assertIn("washfsi: configuring", lines)
        self.assertLess(len(lines), 45)
        install = next(words for words in self.calls("apt-get") if "install" in words)
        self.assertIn("petsc-dev", install)
        for of_others in ("libgtest-dev", "ffmpeg", "universal-ctags", "python3-matplotlib", "hdf5-tools"):
            self.assertNotIn(of_others, install)

    def test_a_second_run_is_silent_and_soon(self):
        (self.tools / "installed").touch()
        self.call("run")
        before = time.monotonic()
        status, printed, errors = self.call("run")
        self.assertLess(time.monotonic() - before, 2)
        self.assertEqual((status, printed, errors), (0, "the program\n", ""))
        self.assertEqual(self.calls("apt-get"), [])
        self.assertEqual(len([words for words in self.calls("cmake") if "--preset" in words]), 1)

    def test_on_a_terminal_one_line_renews_itself(self):
        (self.tools / "installed").touch()
        ours, its = pty.openpty()
        with subprocess.Popen([self.tree / "scripts" / "build"], stdout=its, stderr=its,
                              env={**os.environ, "PATH": f"{self.tools}:{os.environ['PATH']}"}) as process:
            os.close(its)
            printed = b""
            while part := self.part_of(ours):
                printed += part
            self.assertEqual(process.wait(), 0)
        os.close(ours)
        self.assertEqual(printed.count(b"\r\n"), 3, printed)  # what is ahead, configuring, compiling
        self.assertGreater(printed.count(b"\rwashfsi: compiling "), 100)

    @staticmethod
    def part_of(terminal):
        """Returns what can be read of a terminal, nothing after its end."""
        try:
            return os.read(terminal, 65536)
        except OSError:
            return b""

    def test_what_a_compiler_says_goes_through(self):
        (self.tools / "installed").touch()
        (self.tools / "compiler_fails").touch()
        status, printed, _ = self.call("run")
        self.assertEqual(status, 1)
        self.assertIn("error: no such thing", printed)
        self.assertNotIn("the program", printed)

    @unittest.skipIf(os.geteuid() != 0, "apt is asked as root")
    def test_what_apt_says_is_told_where_it_fails(self):
        (self.tools / "apt_fails").touch()
        status, _, errors = self.call("run")
        self.assertEqual(status, 1)
        self.assertIn("E: Unable to locate package petsc-dev", errors)
        self.assertIn("apt failed", errors)

    @unittest.skipIf(os.geteuid() != 0, "apt is asked as root")
    def test_the_tests_install_and_build_all_after_a_run_too(self):
        self.call("run")
        status, printed, errors = self.call("test", "-R", "grid")
        self.assertEqual(status, 0, printed + errors)
        asked = [word for words in self.calls("apt-get") for word in words]
        for package in ("libgtest-dev", "hdf5-tools", "ffmpeg", "universal-ctags", "python3-h5py", "python3-matplotlib", "libjs-three"):
            self.assertIn(package, asked)
        self.assertEqual([words[-1] for words in self.calls("cmake") if "--preset" in words],
                         ["-DBUILD_TESTING=OFF", "-DBUILD_TESTING=ON"])
        self.assertEqual(self.calls("ninja")[-1][-1], "all")

    def test_results_are_read_by_what_is_there(self):
        (self.tools / "installed").touch()
        self.assertEqual(self.call("install-dependencies", "--results"), (0, "", ""))
        self.assertEqual(self.call("install-dependencies", "--count", "--run")[1], "0\n")
        status, _, errors = self.call("install-dependencies", "--everything")
        self.assertEqual(status, 2)
        self.assertIn("--everything", errors)


if __name__ == "__main__":
    unittest.main()
