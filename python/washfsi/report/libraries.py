# SPDX-License-Identifier: BSD-3-Clause
"""The libraries that go into a report, taken from Debian's packages as installed, with their licences."""

import pathlib
import re

from washfsi.errors import ResultsError

SHARED = pathlib.Path("/usr/share")
FILES = {  # in the order in which the page needs them
    "libjs-three": ["three/three.min.js", "three/examples/js/controls/OrbitControls.js"],
    "libjs-chart.js": ["chart.js/chart.min.js"],
}
TITLES = {"libjs-three": "three.js", "libjs-chart.js": "Chart.js"}
RELEASE = re.compile(r"REVISION\s*=\s*[\"']([^\"']+)|Chart\.js v([\d.]+)")


def read(path, package):
    """Returns the text of a file of a package."""
    try:
        return path.read_text(encoding="utf-8")
    except OSError:
        raise ResultsError(f"no file {path}: install Debian's packages {' and '.join(FILES)} "
                           f"(scripts/install-dependencies does), of which {package} has it") from None


def release_of(text):
    """Returns the release that a library's text names."""
    found = RELEASE.search(text)
    return next(filter(None, found.groups()), "") if found else ""


def libraries(shared=SHARED):
    """Returns each library: package, title, release, its code and the text of its licence."""
    found = []
    for package, names in FILES.items():
        texts = [read(shared / "javascript" / name, package) for name in names]
        found.append({"package": package, "title": TITLES[package], "release": release_of(texts[0]),
                      "code": "\n".join(texts), "licence": read(shared / "doc" / package / "copyright", package)})
    return found
