# SPDX-License-Identifier: BSD-3-Clause
"""The site of the documents is built without a warning, each of its links leads somewhere, and its equations are typeset."""

import pathlib
import subprocess
import tempfile
import time
import unittest
import urllib.parse
from html.parser import HTMLParser

import browser
from support import SOURCE

try:
    import furo  # noqa: F401
    import myst_parser  # noqa: F401
    THERE = pathlib.Path("/usr/share/javascript/katex").is_dir()
except ImportError:
    THERE = False

SITE = pathlib.Path()


class Page(HTMLParser):
    """The places of a page that can be linked to, and what it links to."""

    def __init__(self, path):
        super().__init__()
        self.places, self.links, self.titles = {"", "top"}, [], 0
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        """Takes a tag."""
        facts = dict(attrs)
        self.places.add(facts.get("id"))
        self.links += [facts[name] for name in ("href", "src") if facts.get(name)]
        self.titles += tag == "h1"
        if tag == "img" and not facts.get("alt"):
            self.links.append("picture without a text")


def broken_links(site):
    """Returns (page, link) for each link that leads nowhere."""
    pages = {path.resolve(): Page(path) for path in site.rglob("*.html")}
    broken = []
    for path, page in pages.items():
        for link in page.links:
            address = urllib.parse.urlsplit(link)
            if address.scheme or address.netloc:
                continue
            target = (path.parent / urllib.parse.unquote(address.path)).resolve() if address.path else path
            if not target.exists() or target in pages and address.fragment not in pages[target].places:
                broken.append((str(path.relative_to(site.resolve())), link))
    return broken


@unittest.skipUnless(THERE, "no generator of the site: scripts/install-dependencies --site")
class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        global SITE  # pylint: disable=global-statement
        folder = tempfile.TemporaryDirectory(prefix="washfsi_")
        cls.addClassCleanup(folder.cleanup)
        SITE = pathlib.Path(folder.name).resolve() / "site"
        cls.outcome = subprocess.run([SOURCE / "scripts" / "site", SITE], capture_output=True, text=True, check=False)

    def test_it_is_built_without_a_warning(self):
        self.assertEqual(self.outcome.returncode, 0, self.outcome.stdout + self.outcome.stderr)
        self.assertTrue((SITE / "searchindex.js").is_file())

    def test_every_link_leads_somewhere(self):
        self.assertGreater(len(list(SITE.rglob("*.html"))), 30)
        self.assertEqual(broken_links(SITE), [])

    def test_the_test_sees_broken_links(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "a.html").write_text('<h1 id="here">a</h1><a href="b.html"></a><a href="#there"></a><a href="a.html#here"></a>')
            self.assertEqual(broken_links(folder), [("a.html", "b.html"), ("a.html", "#there")])

    @unittest.skipUnless(browser.there(), browser.MISSING)
    def test_equations_are_typeset_and_the_search_finds(self):
        theory = {path.stem: path.read_text(encoding="utf-8").count("```math\n") for path in (SOURCE / "docs" / "theory").glob("*.md")}
        driver = browser.Browser(1200).driver
        self.addCleanup(driver.quit)
        self.assertGreater(sum(theory.values()), 10)
        for page, written in theory.items():
            driver.get(f"file://{SITE}/docs/theory/{page}.html")
            self.assertEqual(driver.execute_script("return document.querySelectorAll('.katex-display').length"), written, page)
        self.assertEqual([entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"], [])
        driver.get(f"file://{SITE}/search.html?q=crumpled")
        found, until = 0, time.monotonic() + 20
        while not found and time.monotonic() < until:
            time.sleep(0.1)
            found = driver.execute_script("return document.querySelectorAll('#search-results ul.search li').length")
        self.assertGreater(found, 0)


if __name__ == "__main__":
    unittest.main()
