# SPDX-License-Identifier: BSD-3-Clause
"""Files and functions of the library, of the Python module and of the report's page are short enough to see whole, and classes of
the library small enough to hold in the head."""
import collections
import json
import os
import pathlib
import re
import subprocess
import sys

SOURCE = pathlib.Path(os.environ["WASHFSI_SOURCE"])
MOST_OF_A_FILE = 350
MOST_OF_A_FUNCTION = 50
MOST_OF_NINE_IN_TEN = 18
MOST_FUNCTIONS_OF_A_CLASS = 20  # public and private, overloads counted
MOST_MEMBERS_OF_A_CLASS = 15


def sources():
    """The files of the library, the program, the Python module and the report's page."""
    ends = [("lib", "*.[hc]pp"), ("apps", "*.[hc]pp"), ("python", "*.py"), ("python", "*.js")]
    return sorted(path for folder, end in ends for path in (SOURCE / folder).rglob(end))


def long_files():
    """Every file that is too long, as a line of text."""
    for path in sources():
        lines = len(path.read_text().splitlines())
        if lines > MOST_OF_A_FILE:
            yield f"{path.relative_to(SOURCE)} has {lines} lines; at most {MOST_OF_A_FILE}"


def functions_of_scripts():
    """Lines and place of each function and method of several lines in JavaScript, of which ctags does not know the ends: it ends
    with the first brace that stands as far to the left as it begins."""
    for path in (path for path in sources() if path.suffix == ".js"):
        lines = path.read_text().splitlines()
        for start, line in enumerate(lines):
            begun = re.match(r"( *)(?:async )?(?:function |get )?(\w+)\(.*\{$", line)
            if begun and begun[2] not in ("for", "if", "while", "switch") and (not begun[1] or len(begun[1]) == 2):
                end = next(place for place in range(start, len(lines)) if lines[place].rstrip(",;") == begun[1] + "}")
                yield end - start + 1, f"{path.relative_to(SOURCE)}: {begun[2]}"


def functions_of_others():
    """Lines and place of each function that is defined in C++ and Python."""
    command = ["ctags", "--output-format=json",
               "--languages=C++,Python", "--kinds-C++=f", "--kinds-Python=fm", "--fields=+ne", "-f", "-",
               *(str(path) for path in sources() if path.suffix != ".js")]
    found = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    for tag in map(json.loads, found):
        yield tag["end"] - tag["line"] + 1, f"{pathlib.Path(tag['path']).relative_to(SOURCE)}: {tag['name']}"


def large_classes():
    """Every class of the library with too many functions or members, as a line of text. What is deleted is not counted."""
    command = ["ctags", "--output-format=json", "--languages=C++", "--kinds-C++=pfm", "--fields=+Kn", "-f", "-",
               *(str(path) for path in sources() if path.suffix == ".hpp")]
    found = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    functions, members = collections.defaultdict(set), collections.defaultdict(set)
    for tag in map(json.loads, found):
        if tag.get("scopeKind") not in ("class", "struct") or "= delete" in tag["pattern"] or "static constexpr" in tag["pattern"]:
            continue
        counted = members if tag["kind"] == "member" else functions
        counted[tag["scope"]].add((tag["name"], tag["pattern"]) if counted is functions else tag["name"])
    for name in sorted({*functions, *members}):
        if len(functions[name]) > MOST_FUNCTIONS_OF_A_CLASS or len(members[name]) > MOST_MEMBERS_OF_A_CLASS:
            yield (f"{name} has {len(functions[name])} functions and {len(members[name])} members; at most "
                   f"{MOST_FUNCTIONS_OF_A_CLASS} and {MOST_MEMBERS_OF_A_CLASS}")


def main():
    """Lists what is too long."""
    lengths = sorted([*functions_of_others(), *functions_of_scripts()])
    problems = [*long_files(), *large_classes()]
    problems += [f"{place} has {lines} lines; at most {MOST_OF_A_FUNCTION}" for lines, place in lengths
                 if lines > MOST_OF_A_FUNCTION]
    ninetieth = lengths[int(0.9 * len(lengths))][0]
    if ninetieth > MOST_OF_NINE_IN_TEN:
        problems.append(f"nine in ten functions have up to {ninetieth} lines; at most {MOST_OF_NINE_IN_TEN}")
    print("\n".join(problems) or f"{len(lengths)} functions: median {lengths[len(lengths) // 2][0]}, nine in ten up to "
                                 f"{ninetieth}, longest {lengths[-1][0]} lines ({lengths[-1][1]})")
    return 1 if problems else 0


sys.exit(main())
