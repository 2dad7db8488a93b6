# SPDX-License-Identifier: BSD-3-Clause
"""What all long tables share: the program, its results, and rows of Markdown."""

import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "program"))
from support import CAVITY, SOURCE, command, read_columns  # noqa: E402, F401  (found by the line above)


def print_row(*words):
    """Prints a row of a Markdown table."""
    print("|", " | ".join(str(word) for word in words), "|", flush=True)


def print_head(*words):
    """Prints the first two rows of a Markdown table."""
    print_row(*words)
    print("|" + "---|" * len(words), flush=True)
