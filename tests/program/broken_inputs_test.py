# SPDX-License-Identifier: BSD-3-Clause
"""Inputs that something has broken: whatever they are, the program runs with finite results, or ends in one line with a
status that says why. What is broken, and how, is drawn at random from the number of the try.

    broken_inputs_test.py                  a sample
    broken_inputs_test.py full             some thousands; with the sanitizers, from a build by the preset sanitize
    broken_inputs_test.py options 1234     one try again, which shows its files
"""

import concurrent.futures
import dataclasses
import pathlib
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

import numpy as np

from support import PATIENCE, PROGRAM, SOURCE, alone, read_table

FULL = "full" in sys.argv
SECONDS = 60 * PATIENCE  # that a try may take [s]
WRONG_INPUT, DIVERGED, NOT_WRITTEN = 2, 3, 4
TRACES = ("PETSC ERROR", "Sanitizer", "runtime error", "Signal:", "terminate called", "This is an error of")
CELLS = {2: "32,32", 3: "12,12,12"}
SPACE = {"agitator_stl", "drape", "flag3d", "front_loader_filled", "plate", "re1.2e3", "sheet", "sphere", "stirred_tank", "water",
         "strip", "wash"}  # inputs in three dimensions
SAMPLE = {"cavity", "flag", "wash", "wash2d"}
WORDS = ["nan", "inf", "-inf", "1e308", "-1e308", "5e-324", "1e-300", "0", "-0", "-1", "1", "2.5", "2147483648",
         "9223372036854775808", "1e999", "", "''", "1,2", "1,2,3,4,5", ",", "1,,2", "0x10", "1e", "--5", "true", "maybe", "none",
         "../..", "/dev/null", "/", "\x01", "\u00e9", "a" * 3000, "%s%n", "-5 -6", "1;2", "random", "$HOME", "#", '"']
LINES = ["- 5", "-", "--", "5", "-fluid_viscosty 1", "-pc_type hypre", "-options_file", "-options_file nowhere.opts",
         '-cloths ""', '-bodies ""', '-bodies "', "-options_left", "-log_view ascii:/nowhere/x", "-PRESSURE_KSP_TYPE foo",
         "-mat_type foo", "-vec_type foo",
         "-pressure_ksp_max_it -5", "-pressure_ksp_rtol nan", "-momentum_ksp_type foo", "-momentum_pc_type lu",
         "-pressure_pc_type mg", "-cloth_ksp_type preonly", "-bodies", "-bodies a,a", "-cloths", "-cloths rag,drum",
         "-bodies Grid", "-check", "-check maybe", "-malloc_debug", "-help", "-version", "-dm_view", "\x00", "-\u00e9 1",
         "-prefix_push x_", "-prefix_pop", "alias a b", "-grid_dim 7", "-on_error_abort maybe", "-skip_petscrc"]
SIZES = re.compile(r"_(cells|markers|count|points|sweeps|spacing|iterations|samples|cycles|interval|restart)$")
SMALL = ["0", "-1", "1", "2", "3,3", "2,2,2", "0.5", "nan", "x", "", "1e300", "2147483648"]  # for what sets a size


@dataclasses.dataclass
class Outcome:
    """How a try ended; `fault` says what is wrong with that, if anything."""
    kind: str
    number: int
    status: int
    fault: str
    files: dict


def run(folder, *options):
    """Runs the program without a launcher; returns status and standard error."""
    (folder / "inputs").symlink_to(SOURCE / "inputs")  # some include others
    (folder / "agitator_stl").symlink_to(SOURCE / "inputs" / "agitator_stl")
    environment = {**alone(folder), "ASAN_OPTIONS": "detect_leaks=0:abort_on_error=0:allocator_may_return_null=1",
                   "HOME": str(folder)}
    try:
        done = subprocess.run([PROGRAM, *map(str, options)], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return 124, f"longer than {SECONDS:.0f} s"
    return done.returncode, done.stderr.decode("utf-8", "replace")


def fault_of(status, errors, out):
    """Returns what is wrong with how a run ended; empty if nothing."""
    if any(trace in errors for trace in TRACES):
        return "a trace"
    lines = [line for line in errors.splitlines() if not line.startswith(("note: ", "warning: ", "WARNING! "))]
    if status == 0:
        if lines:
            return "complains, but ends well"
        if (out / "history.csv").exists() and len((out / "history.csv").read_text().splitlines()) > 2:
            names, _, rows = read_table(out / "history.csv")
            bad = [name for name, column in zip(names, rows.T) if not np.isfinite(column).all()]
            return f"not finite: {' '.join(bad)}" if bad else ""
        return ""
    if status not in (WRONG_INPUT, DIVERGED, NOT_WRITTEN):
        return f"status {status}"
    if len(lines) != 1 or not lines[0].startswith("washfsi: ") or len(lines[0]) > 5000:
        return f"{len(lines)} lines"
    return ""


def broken_number(draw, text):
    """Returns a number of a text, changed in size or sign."""
    found = re.search(r"[-+]?\d[\d.]*(e[-+]?\d+)?", text, re.IGNORECASE)
    if not found:
        return draw.choice(WORDS)
    number = float(found[0]) * draw.choice([-1, 1e-12, 1e-6, 1e-3, 0.1, 10, 1e3, 1e6, 1e12, 1e200])
    return text[:found.start()] + f"{number:g}" + text[found.end():]


def break_value(draw, lines):
    """Gives an option another value."""
    places = [n for n, line in enumerate(lines) if line.startswith("-")]
    place = draw.choice(places)
    name, _, value = lines[place].partition(" ")
    if SIZES.search(name):
        lines[place] = f"{name} {draw.choice(SMALL)}"
    else:
        lines[place] = f"{name} {draw.choice(WORDS) if draw.random() < 0.5 else broken_number(draw, value)}"


def break_lines(draw, lines):
    """Removes, doubles, swaps, misspells or adds a line, or takes one option's value for another."""
    place, other = draw.randrange(len(lines)), draw.randrange(len(lines))
    what = draw.randrange(6)
    if what == 0:
        del lines[place]
    elif what == 1:
        lines.insert(other, lines[place])
    elif what == 2:
        words, others = lines[place].split(" ", 1), lines[other].split(" ", 1)
        if not SIZES.search(words[0]):
            lines[place] = words[0] + " " + others[-1]
    elif what == 3 and len(lines[place]) > 3:
        letter = draw.randrange(1, len(lines[place]))
        lines[place] = lines[place][:letter] + draw.choice("abcxyz_-019 ,.") + lines[place][letter + 1:]
    else:
        lines.insert(place, draw.choice(LINES))


def break_bytes(draw, content):
    """Flips, cuts out, doubles or zeroes some bytes, or cuts the end off."""
    content = bytearray(content)
    for _ in range(draw.choice([1, 1, 2, 5, 20])):
        place, length = draw.randrange(len(content) + 1), draw.choice([1, 1, 4, 8, 64, 512])
        what = draw.randrange(5)
        if what == 0 and place < len(content):
            content[place] ^= 1 << draw.randrange(8)
        elif what == 1:
            del content[place:place + length]
        elif what == 2:
            content[place:place] = content[place:place + length]
        elif what == 3:
            content[place:place + length] = bytes(len(content[place:place + length]))
        elif draw.random() < 0.2:
            del content[place:]
    return bytes(content)


def tetrahedron(ascii_form):
    """Returns an STL file of a small closed surface."""
    corners = np.array([[0.2, 0.2, 0.2], [-0.2, -0.2, 0.2], [-0.2, 0.2, -0.2], [0.2, -0.2, -0.2]])
    facets = [corners[list(facet)] for facet in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))]
    facets = [facet if np.dot(np.cross(facet[1] - facet[0], facet[2] - facet[0]), facet.mean(axis=0)) > 0 else facet[::-1]
              for facet in facets]
    if ascii_form:
        lines = ["solid t"]
        for facet in facets:
            lines += ["facet normal 0 0 0", "outer loop", *(f"vertex {x:g} {y:g} {z:g}" for x, y, z in facet), "endloop",
                      "endfacet"]
        return "\n".join([*lines, "endsolid t", ""]).encode()
    return b"\0" * 80 + struct.pack("<I", len(facets)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *facet.ravel(), 0) for facet in facets)


MOTION = "\n".join(["# time, x, y, angle", *(f"{0.001 * n},{1e-5 * n},0,{0.01 * n}" for n in range(9)), ""]).encode()


class Tries:
    """The inputs to break, and how to run with them. Each try has a folder of its own."""

    def __init__(self, root):
        self.root = root
        self.inputs = {}  # of each file of options, what it and what its run resolved
        for path in [*sorted((SOURCE / "inputs").glob("*.opts")), SOURCE / "inputs" / "thesis" / "re1.2e3.opts"]:
            if FULL or path.stem in SAMPLE:
                self.inputs[path.stem] = (path, self.resolved(path))
        self.wash = ["-options_file", SOURCE / "inputs" / "thesis" / "wash2d64.opts", "-grid_cells", "16,16", "-long_markers", 10,
                     "-long_count", 2, "-short_markers", 5, "-short_count", 1, "-time_cfl", 0, "-time_step", 1e-3]
        (root / "motion.csv").write_bytes(MOTION)
        self.must_run("motion", *self.wash, "-drum_motion_file", root / "motion.csv", "-max_steps", 1, "-output_dir", "out")
        (root / "ball.stl").write_bytes(tetrahedron(True))
        self.must_run("stl", *self.ball(root / "ball.stl"))
        self.must_run("checkpoint", *self.wash, "-max_steps", 2, "-output_dir", "out")
        self.checkpoint = (root / "checkpoint" / "out" / "checkpoint.h5").read_bytes()
        self.must_run("straight", *self.wash, "-max_steps", 3, "-output_dir", "out")
        self.last_row = (root / "straight" / "out" / "history.csv").read_text().splitlines()[-1]

    def must_run(self, name, *options):
        """Runs an unbroken input."""
        folder = self.root / name
        folder.mkdir(exist_ok=True)
        status, errors = run(folder, *options)
        if status != 0:
            raise AssertionError(f"{name} does not run: {errors}")

    @staticmethod
    def small(path):
        """Returns options that make the case of a file quick to run."""
        cells = CELLS[3 if path.stem in SPACE else 2]
        few = ["-flag_markers", "8,8"] if path.stem == "flag3d" else []
        return ["-grid_cells", cells, *few, "-max_steps", "1", "-output_dir", "out"]

    def resolved(self, path):
        self.must_run(path.stem, "-options_file", path, *self.small(path))
        return self.root / path.stem / "out" / "resolved.opts"

    def options(self, draw, folder):
        """Breaks a file of options."""
        stem = draw.choice(sorted(self.inputs))
        path = draw.choice(self.inputs[stem])
        text = path.read_text().replace("file base/", "file inputs/thesis/base/").replace("file wash", "file inputs/wash")
        lines = text.splitlines()  # inputs is a link
        for _ in range(draw.choice([1, 1, 1, 2, 4])):
            draw.choice([break_value, break_value, break_lines])(draw, lines)
        content = "\n".join(lines).encode()
        if draw.random() < 0.1:
            content = break_bytes(draw, content)
        (folder / "broken.opts").write_bytes(content)
        return ["-options_file", "broken.opts", *self.small(self.inputs[stem][0])]

    def stl(self, draw, folder):
        """Breaks an STL file."""
        content = tetrahedron(draw.random() < 0.5)
        (folder / "broken.stl").write_bytes(break_bytes(draw, content))
        return self.ball("broken.stl")

    @staticmethod
    def ball(path):
        """Returns the options of a body from an STL file."""
        return ["-grid_cells", "8,8,8", "-grid_lower", "-1,-1,-1", "-grid_upper", "1,1,1", "-fluid_viscosity", 0.05,
                "-fluid_density", 1, "-bodies", "ball", "-body_method", "mapping", "-ball_shape", "stl", "-ball_file", path,
                "-time_step", 0.02, "-time_end", 1, "-max_steps", 1, "-output_dir", "out"]

    def motion(self, draw, folder):
        """Breaks the table of a motion."""
        content = MOTION
        for _ in range(draw.choice([1, 2])):
            if draw.random() < 0.5:
                lines = content.decode("utf-8", "replace").split("\n")
                place = draw.randrange(len(lines))
                lines[place] = broken_number(draw, lines[place]) if draw.random() < 0.5 else draw.choice(WORDS)
                content = "\n".join(lines).encode()
            else:
                content = break_bytes(draw, content)
        (folder / "broken.csv").write_bytes(content)
        return [*self.wash, "-drum_motion_file", "broken.csv", "-max_steps", 1, "-output_dir", "out"]

    def checkpoints(self, draw, folder):
        """Breaks a checkpoint."""
        (folder / "broken.h5").write_bytes(break_bytes(draw, self.checkpoint))
        return [*self.wash, "-restart", "broken.h5", "-max_steps", 1, "-output_dir", "out"]

    def attempt(self, kind, number, show=False):
        """Makes one try."""
        draw, folder = random.Random(f"{kind} {number}"), self.root / f"{kind}_{number}"
        folder.mkdir()
        options = getattr(self, kind)(draw, folder)
        status, errors = run(folder, *options)
        fault = fault_of(status, errors, folder / "out")
        if kind == "checkpoints" and status == 0 and not fault:
            if (folder / "out" / "history.csv").read_text().splitlines()[-1] != self.last_row:
                fault = "another state"
        files = {path.name: path.read_bytes() for path in folder.glob("broken.*") if fault or show}
        if fault or show:
            files["command"] = " ".join(map(str, options)).encode()
            files["errors"] = errors.encode()
        shutil.rmtree(folder, ignore_errors=True)
        return Outcome(kind, number, status, fault, files)


NUMBERS = ({"options": 2400, "stl": 600, "motion": 600, "checkpoints": 600} if FULL else
           {"options": 40, "stl": 12, "motion": 12, "checkpoints": 12})


class BrokenInputs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="washfsi_")
        self.addCleanup(folder.cleanup)
        self.tries = Tries(pathlib.Path(folder.name))

    def test_all_end_well_or_in_one_line(self):
        outcomes = []
        with concurrent.futures.ThreadPoolExecutor(2) as workers:
            jobs = [workers.submit(self.tries.attempt, kind, n) for kind, count in NUMBERS.items() for n in range(count)]
            for job in concurrent.futures.as_completed(jobs):
                outcomes.append(outcome := job.result())
                if outcome.fault:
                    shown = "\n".join(f"--- {name}\n{content[-3000:].decode('utf-8', 'replace')}"
                                      for name, content in outcome.files.items() if name != "broken.opts")
                    print(f"{outcome.kind} {outcome.number}: {outcome.fault}\n{shown}", flush=True)
        print("| what | tried | ran | refused | diverged | not written | bad |\n|---|---|---|---|---|---|---|")
        for kind in NUMBERS:
            of_kind = [outcome for outcome in outcomes if outcome.kind == kind]
            ends = [sum(outcome.status == status and not outcome.fault for outcome in of_kind)
                    for status in (0, WRONG_INPUT, DIVERGED, NOT_WRITTEN)]
            print("|", " | ".join(map(str, [kind, len(of_kind), *ends, sum(bool(o.fault) for o in of_kind)])), "|", flush=True)
        self.assertEqual([f"{o.kind} {o.number}: {o.fault}" for o in outcomes if o.fault], [])


def show_one(kind, number):
    """Makes one try again and shows it."""
    with tempfile.TemporaryDirectory(prefix="washfsi_") as folder:
        outcome = Tries(pathlib.Path(folder)).attempt(kind, number, show=True)
    for name, content in outcome.files.items():
        print(f"--- {name}\n{content.decode('utf-8', 'replace')}")
    print(f"status {outcome.status} {outcome.fault}")


if __name__ == "__main__":
    if len(sys.argv) == 3:
        show_one(sys.argv[1], int(sys.argv[2]))
    else:
        unittest.main(argv=sys.argv[:1])
