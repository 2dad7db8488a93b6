# SPDX-License-Identifier: BSD-3-Clause
"""The site that scripts/site builds of README.md, CHANGELOG.md, CONTRIBUTING.md and docs/, by Sphinx with MyST and Furo.

The pages are Markdown as it is read on its own; what Sphinx wants beyond it is added here, when a page is read."""

import pathlib
import re
import shutil

ROOT = pathlib.Path(__file__).resolve().parents[2]
JAVASCRIPT = pathlib.Path("/usr/share/javascript")

project = "washfsi"
author = "the washfsi developers"
project_copyright = "2026, the washfsi developers"
release = re.search(r"project\(washfsi VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)

extensions = ["myst_parser", "sphinx.ext.mathjax"]
root_doc = "README"
include_patterns = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "docs/**.md",
                    "tests/verification/reference/**.md"]
myst_heading_anchors = 4
highlight_language = "none"

html_theme = "furo"
html_title = f"washfsi {release}"
html_copy_source = False
html_show_sphinx = False
html_static_path = [str(JAVASCRIPT / "katex"), str(pathlib.Path(__file__).parent / "static")]
html_css_files = ["katex.min.css", "site.css"]
html_js_files = ["katex.min.js", "scripts/gumshoe-patched.js"]
mathjax_path = "equations.js"  # KaTeX in its place, from Debian's libjs-katex: no network is needed
mathjax_options = {"defer": "defer"}

# The navigation: what README.md lists in words.
CONTENTS = {
    "Start": ["install", "tutorials/README", "gallery/README"],
    "Use it": ["guide/README", "troubleshooting", "faq", "glossary"],
    "Look up": ["reference/options", "reference/quantities", "reference/python"],
    "Understand": ["theory/README", "validation/README", "developer/performance", "developer/durability"],
    "Take part": ["developer/README", "developer/release", "licences", "cite", "/CONTRIBUTING", "/CHANGELOG"],
}


def toctree(title, pages):
    """Returns an entry of the navigation."""
    places = [page if page.startswith("/") else f"/docs/{page}" for page in pages]
    return "\n".join(["", "```{toctree}", ":hidden:", f":caption: {title}" if title else ":maxdepth: 1", *places, "```", ""])


def below(first):
    """Returns the pages of its folder, and of folders in it, that the first page of a folder links, in its order."""
    path = ROOT / f"{first}.md"
    links = re.findall(r"\]\(([\w/.\-]+)\.md[)#]", path.read_text(encoding="utf-8"))
    pages = dict.fromkeys((path.parent / link).resolve().relative_to(ROOT) for link in links)
    return [f"/{page}" for page in pages if path.parent.relative_to(ROOT) in page.parents and str(page) != first]


def complete(_app, name, source):
    """Adds the navigation, and makes equations of code that is marked as such."""
    text = source[0].replace("```math\n", "```{math}\n")
    if name == "README":
        text += "".join(toctree(*entry) for entry in CONTENTS.items())
    elif name.endswith("/README") and name.startswith("docs/") and name != "docs/developer/README":
        text += toctree("", below(name))
    if name == "docs/validation/README":
        data = sorted((ROOT / "tests" / "verification" / "reference").glob("*/README.md"))
        text += toctree("", [f"/{path.relative_to(ROOT).with_suffix('')}" for path in data])
    source[0] = text


def mend_theme(app, _error):
    """Mends Debian's Furo 2022.12: its style imports a file by its place on a server, its code another as no page may that is
    opened without a server."""
    static = pathlib.Path(app.outdir) / "_static"
    shutil.copy(JAVASCRIPT / "normalize.css" / "normalize.css", static / "styles")
    for name, old, new in (("styles/furo.css", "url(/javascript/normalize.css/normalize.css)", "url(normalize.css)"),
                           ("scripts/furo.js", 'import Gumshoe from "./gumshoe-patched.js";', "")):
        path = static / name
        path.write_text(path.read_text(encoding="utf-8").replace(old, new), encoding="utf-8")


def setup(app):
    """Called by Sphinx."""
    app.connect("build-finished", mend_theme)
    app.connect("source-read", complete)
    return {"parallel_read_safe": True}
