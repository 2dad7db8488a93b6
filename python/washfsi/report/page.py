# SPDX-License-Identifier: BSD-3-Clause
"""The page: its template with styles, code, libraries and the data of the runs put in."""

import json
import pathlib

import numpy as np
from matplotlib import colormaps

from washfsi.errors import ResultsError
from washfsi.report.comparison import comparison_of, design_of, short_names
from washfsi.report.curves import curves_of
from washfsi.report.drawing import drawings
from washfsi.report.figures import body_figures, cloth_figures, cycle_figures, headlines, run_figures
from washfsi.report.libraries import libraries
from washfsi.report.pack import Pack
from washfsi.report.playback import playback_of
from washfsi.report.tracks import tracks_of
from washfsi.report.words import words_of

WEB = pathlib.Path(__file__).parent / "web"
SCRIPTS = ("dom", "numbers", "unpack", "theme", "story", "tables", "charts", "tracks", "colours", "geometry", "solids",
           "cloths", "slice", "fit", "view", "playback", "comparison", "picture", "main")
ROOM = 9_000_000  # [bytes] for the playbacks of all runs in a report, before compression
# Told apart by all eyes: lightness grows with the number, or from both ends to the middle.
SHADES = {"cloth": ("YlOrBr", 0.12, 1.0), "flow": ("Blues", 0.02, 1.0), "signed": ("PuOr_r", 0.04, 0.96)}
COUNT = 64  # of colours in a scale


def colour_scales():
    """Returns the scales of colour, each a list of red, green and blue from 0 to 255."""
    return {name: np.rint(255 * colormaps[source](np.linspace(low, high, COUNT))[:, :3]).astype(int).tolist()
            for name, (source, low, high) in SHADES.items()}


def run_data(results, room):
    """Returns what the page has of one run, but for its name, and the pack of its arrays."""
    pack, summary = Pack(), results.summary
    cycles = cycle_figures(results)
    data = {"case": results.case, "status": summary.get("status", "without a summary"), "words": words_of(results),
            "groups": results.groups, "drawings": drawings(results), "options": results.options, "cycles": cycles,
            "complete": summary.get("cycles", {}).get("complete", 0), "headlines": headlines(cycles),
            "figures": cloth_figures(summary) + body_figures(summary, results.flow.dim == 2) + run_figures(summary),
            "trust": summary.get("trust", {}), "curves": curves_of(results, pack), "tracks": tracks_of(results, pack),
            "playback": playback_of(results, pack, room)}
    return data, pack


def inside_script(text):
    """Returns code that may stand in a script element: nothing in it ends the element."""
    return text.replace("</", "<\\/").replace("<!--", "<\\!--")


def data_elements(runs, packs):
    """Returns the elements of the page that hold the data."""
    data = {"runs": runs, "comparison": comparison_of(runs), "scales": colour_scales()}
    text = json.dumps(data, allow_nan=False, separators=(",", ":"), default=float)
    text = text.replace("<", "\\u003c")  # which is the same in JSON, and ends no element
    elements = [f'<script type="application/json" id="data">{text}</script>']
    return elements + [f'<script type="text/plain" class="pack">{pack.text()}</script>' for pack in packs]


def code_elements(found):
    """Returns the elements with the libraries and with the page's own code, all of which is one function."""
    own = "\n".join((WEB / f"{name}.js").read_text(encoding="utf-8") for name in SCRIPTS)
    return [f"<script>\n{inside_script(library['code'])}\n</script>" for library in found] + [
        f'<script>\n(() => {{\n"use strict";\n{inside_script(own)}\n}})();\n</script>']


def escaped(text):
    """Returns a text as HTML."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def licence_elements(found):
    """Returns the licences of the libraries in the page."""
    return [f"<details><summary>{escaped(library['title'])} {escaped(library['release'])}</summary>"
            f"<pre>{escaped(library['licence'])}</pre></details>" for library in found]


def finite(data):
    """Returns data with None in place of numbers that JSON does not have."""
    if isinstance(data, dict):
        return {name: finite(value) for name, value in data.items()}
    if isinstance(data, (list, tuple)):
        return [finite(value) for value in data]
    return None if isinstance(data, float) and not np.isfinite(data) else data


def page_of(runs, room=ROOM):
    """Returns the page of some runs (Results), as text; `room` is that of their playbacks [bytes]."""
    runs = [results.in_step() for results in runs]
    names = short_names([results.folder for results in runs], [results.case for results in runs])
    made = [run_data(results, room / len(runs)) for results in runs]
    data = [finite(one) | {"name": name, "design": design_of(results.folder, name)}
            for (one, _), name, results in zip(made, names, runs)]
    found = libraries()
    parts = {"title": escaped(" · ".join(names)), "style": (WEB / "style.css").read_text(encoding="utf-8"),
             "licences": "\n".join(licence_elements(found)),
             "data": "\n".join(data_elements(data, [pack for _, pack in made])),
             "code": "\n".join(code_elements(found))}
    text = (WEB / "index.html").read_text(encoding="utf-8")
    for name, part in parts.items():
        text = text.replace(f"<!-- put {name} here -->", part)
    return text


def write_page(runs, path):
    """Writes the page of some runs."""
    text = page_of(runs)
    try:
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        raise ResultsError(f"cannot write {path}: {error}") from None
