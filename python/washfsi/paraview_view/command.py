# SPDX-License-Identifier: BSD-3-Clause
"""The command scripts/paraview."""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys

from washfsi.errors import ResultsError
from washfsi.results import Results

NORMALS = {"x": [1, 0, 0], "y": [0, 1, 0], "z": [0, 0, 1]}
HEAD = """# Scene of a run of washfsi for ParaView 5.11 or later, written by scripts/paraview. Open it by
#   paraview --script={path}
# or in ParaView by View, Python Shell, Run Script. Without a window:
#   pvpython {path} --screenshot picture.png
SCENE = {scene}

"""


def surrounds(distance):
    """Returns whether a body fills the corners of the box, as a drum does."""
    middle = distance[distance.shape[0] // 2] if distance.ndim == 3 else distance
    return bool(middle[0, 0] < 0)


def bodies_of(results):
    """Returns name, number on the surfaces and place of each body that has a surface in the box."""
    fields = results.bodies.frame(0).data if results.bodies else {}
    numbers = {name: number for number, name in enumerate(results.surfaces.bodies)} if results.surfaces else {}
    return [{"name": name, "number": numbers.get(name, -1), "surrounds": surrounds(distance)}
            for name, distance in fields.items() if distance.min() < 0 < distance.max()]


def scene_of(results, axis, height, colour):
    """Returns what the scene has to know of a run; `height` is the slice's place along its axis, from 0 to 1."""
    flow = results.flow
    origin = 0.5 * (flow.lower + flow.upper)
    if flow.dim == 3:
        place = "xyz".index(axis)
        origin[place] = flow.lower[place] + height * (flow.upper - flow.lower)[place]
    return {"case": results.case, "folder": str(results.folder.resolve()), "lower": list(map(float, flow.lower)),
            "upper": list(map(float, flow.upper)), "bodies": bodies_of(results), "groups": results.groups,
            "slice_origin": list(map(float, origin)), "slice_normal": NORMALS[axis],
            "opacity": 0.8 if axis == "z" else 1.0, "colour": colour}


def write_scene(results, path, axis="z", height=0.3, colour="stress"):
    """Writes the script for ParaView."""
    scene = json.dumps(scene_of(results, axis, height, colour), indent=4)
    scene = scene.replace("true", "True").replace("false", "False")
    body = (pathlib.Path(__file__).parent / "scene.py").read_text(encoding="utf-8")
    try:
        path.write_text(HEAD.format(path=path, scene=scene) + body, encoding="utf-8")
    except OSError as error:
        raise ResultsError(f"cannot write {path}: {error}") from None


def command_of(program, *words):
    """Returns a command line of ParaView; without a display in a virtual one."""
    if not shutil.which(program):
        raise ResultsError(f"there is no program {program}; Debian's package is paraview")
    if os.environ.get("DISPLAY") or program == "paraview":
        return [program, *words]
    if not shutil.which("xvfb-run"):
        raise ResultsError("there is no display; Debian's packages xvfb and xauth make one")
    # An X server that starts anew when its only program has closed a connection would lose the next one.
    return ["xvfb-run", "-a", "-s", "-screen 0 1600x1200x24 -noreset", program, *words]


def parse_arguments(description):
    """Returns the command line's options."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="OUT", type=pathlib.Path, help="output folder of a run, or of a -check")
    parser.add_argument("--output", metavar="FILE.py", type=pathlib.Path, help="script (default: OUT/paraview_scene.py)")
    parser.add_argument("--slice", choices=NORMALS, default="z", help="direction in which the slice of the flow is taken")
    parser.add_argument("--height", type=float, help="place of the slice in the box, from 0 to 1 "
                        "(default: the middle, of a horizontal slice 0.3, over the agitator)")
    parser.add_argument("--colour", choices=("stress", "group"), default="stress", help="of the cloths")
    parser.add_argument("--open", action="store_true", help="open it in ParaView")
    parser.add_argument("--screenshot", metavar="FILE.png", type=pathlib.Path, help="make a picture, without a window")
    parser.add_argument("--time", type=float, help="of the picture [s] (default: the last frame)")
    return parser.parse_args()


def show(options):
    """Writes the script, and opens it or makes a picture if asked to; returns the exit status."""
    path = options.output or options.folder / "paraview_scene.py"
    height = options.height if options.height is not None else 0.3 if options.slice == "z" else 0.5
    if not 0 <= height <= 1:
        raise ResultsError("--height must be from 0 to 1")
    write_scene(Results(options.folder).in_step(), path, options.slice, height, options.colour)
    print(path)
    if options.screenshot:
        time = [] if options.time is None else ["--time", str(options.time)]
        return subprocess.call(command_of("pvpython", str(path), "--screenshot", str(options.screenshot), *time))
    return subprocess.call(command_of("paraview", f"--script={path}")) if options.open else 0


def main(description):
    """Does what the command line asks; tells what is wrong in a line."""
    try:
        return show(parse_arguments(description))
    except ResultsError as error:
        print(f"paraview: {error}", file=sys.stderr)
        return 2
