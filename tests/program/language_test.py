# SPDX-License-Identifier: BSD-3-Clause
"""The language of the documents that users read: the field's words, and sentences that are understood at once."""

import re
import unittest

from support import SOURCE

PAGES = ("README.md", "docs/*.md", "docs/guide/*.md", "docs/theory/*.md", "docs/tutorials/*.md", "docs/developer/*.md", "docs/reference/python.md",
         "docs/validation/*.md", "docs/gallery/*.md")
EXCEPT = ("docs/validation/thesis.md",)  # the thesis's rows, in its words
# Words of our own where the field has its own: docs/developer/README.md, "Dictionary".
PRIVATE = re.compile(r"\bin space\b|\bin the plane\b(?! of)|\bdeltas?\b(?! function)|\bpush(es)?\b|\benergy open\b|\bcushion\b|\bwants\b|\blost to the scheme\b"
                     r"|\blaw for the friction\b|\bwalls by markers\b|\bheld by markers\b|\bsteps by accuracy\b|\blaws? of fabric\b")
MOST_WORDS = 30
MOST_LONG = 0.05  # of a page's sentences


def prose(text):
    """A page without code, comments and the addresses of links."""
    text = re.sub(r"^(```|~~~).*?^\1", "", text, flags=re.S | re.M)
    text = re.sub(r"^( {4}|\t).*$|<!--.*?-->", "", text, flags=re.M)
    return re.sub(r"\]\([^)]*\)", "]", re.sub(r"`[^`\n]*`", "code", text))


def sentences(text):
    """The sentences of a page, and the cells of its tables."""
    for block in re.split(r"\n\s*\n|\n(?=[-*|#>]|\d+\.)", prose(text)):
        block = " ".join(block.split())
        if block and not block.startswith("#"):
            for cell in block.strip("|").split("|") if block.startswith("|") else [block]:
                yield from (sentence for sentence in re.split(r"(?<=[.!?:;])\s+", cell.strip(" -*")) if sentence)


PAGES_BY_NAME = {str(path.relative_to(SOURCE)): path.read_text(encoding="utf-8") for pattern in PAGES for path in sorted(SOURCE.glob(pattern))
                 if str(path.relative_to(SOURCE)) not in EXCEPT}


class Language(unittest.TestCase):
    def test_words_are_those_of_the_field(self):
        for page, text in PAGES_BY_NAME.items():
            with self.subTest(page):
                self.assertEqual([match[0] for match in PRIVATE.finditer(prose(text))], [])

    def test_sentences_are_short(self):
        for page, text in PAGES_BY_NAME.items():
            with self.subTest(page):
                counts = [len(re.findall(r"[A-Za-z]\w*", sentence)) for sentence in sentences(text)]
                self.assertLessEqual(sum(count > MOST_WORDS for count in counts), MOST_LONG * len(counts))

    def test_the_test_sees_them(self):
        self.assertTrue(PRIVATE.search(prose("Bodies in the plane\n`delta_kernel` is code")))
        self.assertFalse(PRIVATE.search(prose("in the plane of radius and height, the delta function, `delta_kernel`")))
        self.assertEqual(list(sentences("One. Two\nlines.\n\n    code\n\n| a | b |\n")), ["One.", "Two lines.", "a", "b"])


if __name__ == "__main__":
    unittest.main()
