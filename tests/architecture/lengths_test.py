# SPDX-License-Identifier: BSD-3-Clause
"""Files and functions of the library and of the Python module are short enough to see whole."""
import json
import os
import pathlib
import subprocess
import sys

SOURCE = pathlib.Path(os.environ["WASHFSI_SOURCE"])
MOST_OF_A_FILE = 350
MOST_OF_A_FUNCTION = 50
MOST_OF_NINE_IN_TEN = 18


def sources():
    """The files of the library, the program and the Python module."""
    ends = {"lib": "*.[hc]pp", "apps": "*.[hc]pp", "python": "*.py"}
    return sorted(path for folder, end in ends.items() for path in (SOURCE / folder).rglob(end))


def long_files():
    """Every file that is too long, as a line of text."""
    for path in sources():
        lines = len(path.read_text().splitlines())
        if lines > MOST_OF_A_FILE:
            yield f"{path.relative_to(SOURCE)} has {lines} lines; at most {MOST_OF_A_FILE}"


def functions():
    """Lines and place of each function that is defined, the shortest first."""
    command = ["ctags", "--output-format=json",
               "--languages=C++,Python", "--kinds-C++=f", "--kinds-Python=fm", "--fields=+ne", "-f", "-",
               *map(str, sources())]
    found = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    for tag in sorted(map(json.loads, found), key=lambda tag: tag["end"] - tag["line"]):
        yield tag["end"] - tag["line"] + 1, f"{pathlib.Path(tag['path']).relative_to(SOURCE)}: {tag['name']}"


def main():
    """Lists what is too long."""
    lengths = list(functions())
    problems = list(long_files())
    problems += [f"{place} has {lines} lines; at most {MOST_OF_A_FUNCTION}" for lines, place in lengths
                 if lines > MOST_OF_A_FUNCTION]
    ninetieth = lengths[int(0.9 * len(lengths))][0]
    if ninetieth > MOST_OF_NINE_IN_TEN:
        problems.append(f"nine in ten functions have up to {ninetieth} lines; at most {MOST_OF_NINE_IN_TEN}")
    print("\n".join(problems) or f"{len(lengths)} functions: median {lengths[len(lengths) // 2][0]}, nine in ten up to "
                                 f"{ninetieth}, longest {lengths[-1][0]} lines ({lengths[-1][1]})")
    return 1 if problems else 0


sys.exit(main())
