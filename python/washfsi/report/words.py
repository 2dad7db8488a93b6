# SPDX-License-Identifier: BSD-3-Clause
"""What was simulated, in words: sentences from the options and the summary of a run."""

import math

import numpy as np

SHAPES = {"stl": "surface from an STL file", "agitator": "vaned agitator", "vaned": "vaned agitator"}
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def number(value):
    """Returns a number in four digits."""
    digits, _, power = f"{value:.4g}".partition("e")
    return f"{digits} × 10{str(int(power)).translate(RAISED)}" if power else digits


def plural(count, name):
    """Returns a count with its thing."""
    return f"{count} {name}{'' if count == 1 else 's'}"


def numbers(options, name):
    """Returns the numbers of an option, none where it has no value that is numbers."""
    try:
        return [float(word) for word in options.get(name, "").split(",") if word]
    except ValueError:
        return []


def value(options, name, default=0.0):
    """Returns the first number of an option."""
    return (numbers(options, name) or [default])[0]


def true(options, name):
    """Returns whether an option is set."""
    return options.get(name, "false") in ("true", "")


def product(lengths, unit):
    """Returns lengths as a product: all with one factor and unit."""
    factor, prefixed = (1e3, f"m{unit}") if max(lengths) < 0.1 else (1, unit)
    return " × ".join(number(factor * length) for length in lengths) + f" {prefixed}"


def box_words(options):
    """Returns the sentence on box and grid."""
    cells = [int(count) for count in numbers(options, "grid_cells")]
    lower, upper = numbers(options, "grid_lower"), numbers(options, "grid_upper")
    if not cells or not len(cells) == len(lower) == len(upper):
        return ""
    size, every = np.subtract(upper, lower), f"{math.prod(cells):,}".replace(",", "\u202f")
    return (f"The box of {product(size, 'm')} has {' × '.join(map(str, cells))} cells of {product(size / cells, 'm')}, "
            f"{every} in all.")


def liquid_words(options):
    """Returns the sentence on the liquid."""
    if options.get("fluid") == "none":
        return "There is no liquid: the cloth moves alone."
    density, viscosity = value(options, "fluid_density", 1000), value(options, "fluid_viscosity")
    times = viscosity / 1e-3
    beside = f" ({number(times)} times that of water)" if abs(times - 1) > 0.3 and times > 0 and density > 500 else ""
    gravity = numbers(options, "gravity")
    weight = f" Gravity is ({', '.join(map(number, gravity))}) m/s²." if any(gravity) else ""
    start = options.get("fluid_initial", "rest").replace("_", " ")
    return (f"The liquid has a density of {number(density)} kg/m³ and a viscosity of {number(viscosity)} Pa s{beside}; "
            f"it starts {'at rest' if start == 'rest' else f'as {start}'}.{weight}")


def size_words(options, body):
    """Returns the dimensions of a body that are given, in words."""
    sizes = {"radius": "radius", "height": "height", "size": "size", "tip_radius": "reach of the vanes",
             "vane_height": "height of the vanes", "post_radius": "radius of the post"}
    told = []
    for option, name in sizes.items():
        lengths = [length for length in numbers(options, f"{body}_{option}") if length]
        told += [f"{name} {product(lengths, 'm')}"] if lengths else []
    vanes = int(value(options, f"{body}_vanes"))
    return ([plural(vanes, "vane")] if vanes else []) + told


def motion_words(options, body):
    """Returns how a body moves."""
    files = [options.get(f"{body}_{kind}_file", "none") for kind in ("motion", "speed")]
    for file in files:
        if file not in ("none", ""):
            return f"moves as the table {file.rpartition('/')[2]} says"
    speed, frequency = value(options, f"{body}_angular_speed"), value(options, f"{body}_frequency")
    speed = speed or value(options, f"{body}_rpm") * math.pi / 30
    turning = f"{number(abs(speed))} rad/s ({number(abs(speed) * 30 / math.pi)} rpm)"
    stroke, pause = value(options, f"{body}_stroke"), value(options, f"{body}_pause")
    if speed and frequency:
        return f"turns to and fro at up to {turning}, a cycle in {number(1 / frequency)} s"
    if speed and stroke:
        rest = f", resting {number(pause)} s after each" if pause else ""
        return f"turns to and fro at {turning}, strokes of {number(stroke)} s{rest}"
    if speed:
        return f"turns steadily at {turning}"
    velocity = numbers(options, f"{body}_velocity")
    if any(velocity):
        way = f"moves {'to and fro at up to' if frequency else 'at'} ({', '.join(map(number, velocity))}) m/s"
        return way + (f", {number(frequency)} times a second" if frequency else "")
    return "is at rest"


def body_words(options, body):
    """Returns the sentence on a body."""
    shape = options.get(f"{body}_shape", "body").replace("_", " ")
    shape = SHAPES.get(shape, shape)
    if shape == "sphere" and len(numbers(options, "grid_cells")) == 2:
        shape = "circle"
    if shape in ("union", "intersection", "difference"):
        shape += " of " + ", ".join(names_in(options, f"{body}_parts"))
    side = "the water is inside" if true(options, f"{body}_inverted") else ""
    told = ", ".join(filter(None, [side, *size_words(options, body)]))
    return f"The {body} ({shape}{': ' if told else ''}{told}) {motion_words(options, body)}."


def cloth_words(options, group):
    """Returns the sentence on a group of cloths."""
    count = int(value(options, f"{group}_count", 1))
    size, markers = numbers(options, f"{group}_size"), [int(one) for one in numbers(options, f"{group}_markers")]
    space = len(numbers(options, "grid_cells")) == 3
    size, markers = ([*line, *line][:2] if space and line else line for line in (size, markers))
    lattice = " × ".join(map(str, markers))
    mass = value(options, f"{group}_excess_mass")
    ready = [f"of {product(size, 'm')}" if size else "", f"with {lattice} markers" if markers else "", "each"]
    stiff = numbers(options, f"{group}_ke")
    return (f"Group {group}: {plural(count, 'cloth')} {' '.join(filter(None, ready))}"
            f"{f', {number(mass)} kg/m² heavier than the water they displace' if mass else ''}"
            f"{', stretching stiffness ' + ', '.join(map(number, stiff)) + ' N/m' if stiff else ''}, "
            f"placement {options.get(f'{group}_placement', 'line')}.")


def run_words(summary):
    """Returns the sentence on the run itself."""
    if not summary:
        return "There is no summary: the run goes on, has been cut off, or is a dry run (-check)."
    commit = f", commit {summary['git']}" if summary.get("git") else ""
    return (f"The run {summary['status']} after {plural(summary['steps'], 'step')} at {number(summary['time'])} s. It took "
            f"{number(summary['wall_seconds'])} s on {plural(summary['ranks'], 'rank')} of washfsi {summary['version']}"
            f"{commit}.")


def names_in(options, name):
    """Returns the names in a list of an option."""
    return [word for word in options.get(name, "").split(",") if word]


def words_of(results):
    """Returns the sentences on a run, by what they are about."""
    options = results.options
    story = {"Machine": " ".join(body_words(options, body) for body in names_in(options, "bodies")),
             "Load": " ".join(cloth_words(options, group) for group in names_in(options, "cloths")),
             "Liquid": liquid_words(options), "Grid": box_words(options), "Run": run_words(results.summary)}
    return [{"about": about, "text": text} for about, text in story.items() if text]
