# SPDX-License-Identifier: BSD-3-Clause
"""Options files, word by word as the program reads them."""

import pathlib
import re

WORD = re.compile(r"""#.*|"([^"]*)"|'([^']*)'|([^\s#"'][^\s#]*)""")  # the first is a comment, the next two are in quotes


def words_of_line(line):
    """Returns the words of a line; one in quotes may be empty, or contain blanks and #."""
    return [match[match.lastindex] for match in WORD.finditer(line) if match.lastindex]


def quoted(word):
    """Returns a word as it stands in an options file, in quotes where it needs them."""
    mark = "'" if '"' in word else '"'
    return word if re.fullmatch(r"""[^\s#"']+""", word) else mark + word + mark


def read_options(path):
    """Returns the options of an options file and their values, as texts; names without their dash."""
    lines = map(words_of_line, pathlib.Path(path).read_text(encoding="utf-8").splitlines())
    return {words[0].lstrip("-"): " ".join(words[1:]) for words in lines if words}
