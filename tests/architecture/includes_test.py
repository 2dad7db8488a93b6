# SPDX-License-Identifier: BSD-3-Clause
"""No file includes against the arrows of the house: a folder may include itself and what its library uses."""
import os
import pathlib
import re
import sys

LIBRARY = pathlib.Path(os.environ["WASHFSI_SOURCE"]) / "lib" / "washfsi"

# The arrows, as docs/developer/README.md draws them; CMake must declare the same.
ARROWS = {
    "support": set(),
    "geometry": {"support"},
    "grid": {"support"},
    "fluid": {"grid"},
    "shapes": {"grid", "geometry"},
    "motion": {"shapes"},
    "mask": {"motion"},
    "cloth": {"geometry"},
    "contact": {"motion", "cloth"},
    "immersed_boundary": {"grid", "geometry", "cloth"},
    "placement": {"motion", "cloth"},
    "output": {"grid", "cloth", "motion"},
    "marker_layout": {"mask", "immersed_boundary"},
    "wall_law": {"fluid", "marker_layout"},
    "wall_forces": {"wall_law"},
    "bodies": {"wall_forces"},
    "coupling": {"bodies", "contact"},
    "statistics": {"output"},
    "measure": {"coupling", "statistics"},
    "trust": {"measure"},
    "simulation": {"trust", "placement"},
}


def reachable(folder):
    """All folders that one may include: along the arrows, itself too."""
    found = {folder}
    for used in ARROWS[folder]:
        found |= reachable(used)
    return found


def declared_uses():
    """The USES of each washfsi_library in CMake."""
    text = (LIBRARY / "CMakeLists.txt").read_text()
    calls = re.findall(r"^washfsi_library\((\w+)(.*?)\)", text, re.S | re.M)
    return {name: set(re.search(r"USES ([a-z_ ]+)", body).group(1).split()) if "USES" in body else set()
            for name, body in calls}


def wrong_includes():
    """Every include that goes against an arrow, as a line of text."""
    for path in sorted(LIBRARY.rglob("*.[hc]pp")):
        folder = path.relative_to(LIBRARY).parts[0]
        for used in re.findall(r'#include "washfsi/(\w+)/', path.read_text()):
            if used not in reachable(folder):
                yield f"{path.relative_to(LIBRARY)} includes {used}/"


def main():
    folders = {path.name for path in LIBRARY.iterdir() if path.is_dir()}
    problems = list(wrong_includes())
    problems += [f"folder {folder}/ has no arrows" for folder in sorted(folders - ARROWS.keys())]
    if declared_uses() != ARROWS:
        problems.append(f"lib/washfsi/CMakeLists.txt declares other arrows: {declared_uses()}")
    print("\n".join(problems) or f"{len(folders)} folders, all includes follow the arrows")
    return 1 if problems else 0


sys.exit(main())
