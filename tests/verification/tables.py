# SPDX-License-Identifier: BSD-3-Clause
"""What all long tables share: the program, its results, and rows of Markdown.

A record is a row that ends with the commit of the program and with the command that gives it again. Words after `--` on
the command line of a script are options for its runs of the program and override its own:
`flag_test.py 128 -- -coupling_mobility row_sums`.
"""

import functools
import pathlib
import subprocess
import sys
from typing import NamedTuple

import h5py
import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "program"))
import support  # noqa: E402  (found by the line above)
from support import CAVITY, SOURCE, read_columns  # noqa: E402, F401

CUT = sys.argv.index("--") if "--" in sys.argv else len(sys.argv)
ARGUMENTS, OPTIONS = sys.argv[1:CUT], sys.argv[CUT + 1:]


def command(ranks, *options, others=OPTIONS):
    """Returns the command line that runs the program with options, those after `--` last."""
    return support.command(ranks, *options, *others)


def read_markers(folder, axes=2):
    """Returns the times of a run's frames and the markers' places in them, frame by marker by axis (two: the plane)."""
    with h5py.File(pathlib.Path(folder) / "cloth.h5") as file:
        frames = sorted(file["frames"].values(), key=lambda frame: frame.attrs["time"])
        return (np.array([float(frame.attrs["time"]) for frame in frames]),
                np.array([frame["position"][:, :axes] for frame in frames]))


class Miss(NamedTuple):
    """In the place of a bound: a figure that is known to be beyond it. It may move neither way; a better one asks for a bound again."""
    figure: float
    within: float = 0.05  # relative


def agrees(found, expected, bound):
    """Whether a figure is within a relative bound of the one expected, or, where that is known to be missed, as it was."""
    return is_small(found, bound) if isinstance(bound, Miss) else abs(found / expected - 1) <= bound


def is_small(found, bound):
    """Whether a difference is within an absolute bound, or, where that is known to be missed, as it was."""
    return abs(found / bound.figure - 1) <= bound.within if isinstance(bound, Miss) else found <= bound


def run_tables(tables):
    """Prints the tables that the arguments name, by default all, each by a function that returns whether it holds; returns the exit code."""
    return 0 if all([tables[name]() for name in ARGUMENTS or tables]) else 1


def print_row(*words):
    """Prints a row of a Markdown table."""
    print("|", " | ".join(str(word) for word in words), "|", flush=True)


def print_head(*words):
    """Prints the first two rows of a Markdown table."""
    print_row(*words)
    print("|" + "---|" * len(words), flush=True)


def git(*words):
    """What git says of the tree that the program is in; nothing where there is none."""
    try:
        return subprocess.run(["git", "-C", support.PROGRAM.parent, *words], check=False, capture_output=True,
                              text=True).stdout.strip()
    except FileNotFoundError:
        return ""


@functools.cache
def commit():
    """Short hash of the commit that the program is of, with + where sources, inputs or tests are changed."""
    changed = git("status", "--porcelain", "--", ":/lib", ":/apps", ":/inputs", ":/tests")
    return (git("rev-parse", "--short", "HEAD") or "unknown") + ("+" if changed else "")


def again(arguments=None):
    """The command that gives something again: this script with these arguments, by default its own."""
    words = ARGUMENTS if arguments is None else arguments
    return f"`{' '.join(map(str, [pathlib.Path(sys.argv[0]).name, *words, *(['--', *OPTIONS] if OPTIONS else [])]))}`"


def print_origin():
    """Prints where all tables that follow come from."""
    print(f"Commit {commit()}, {again()}.\n", flush=True)


def print_record_head(*words):
    """Prints the first two rows of a table of records."""
    print_head(*words, "commit", "command")


def print_record(*words, arguments=None):
    """Prints a row and what gives it again: this script with these arguments, by default its own."""
    print_row(*words, commit(), again(arguments))


def scientific(value, digits=2):
    """A number with so many decimals and a short exponent: 1.64e-4."""
    return f"{value:.{digits}e}".replace("e-0", "e-").replace("e+0", "e")
