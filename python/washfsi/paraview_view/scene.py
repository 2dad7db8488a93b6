# SPDX-License-Identifier: BSD-3-Clause
# What follows is the same for all runs: it makes the scene of SCENE.
import argparse
import os
import sys

from paraview import simple as pv

pv._DisableFirstRenderCameraReset()
SOLID, EDGE = [0.78, 0.78, 0.78], [0.2, 0.2, 0.2]
# Colours from the lowest value to the highest.
SPEED = [0, 0.95, 0.97, 1.0, 0.5, 0.50, 0.72, 0.88, 1, 0.03, 0.22, 0.50]
VORTICITY = [0, 0.02, 0.19, 0.38, 0.25, 0.40, 0.66, 0.81, 0.5, 0.97, 0.97, 0.97, 0.75, 0.94, 0.54, 0.38, 1, 0.55, 0.0, 0.15]
FIBRE = [0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.45, 0.12, 1, 0.30, 1.0, 0.20]  # on the vorticity
FABRIC = [0, 1.0, 0.93, 0.62, 0.5, 0.95, 0.50, 0.18, 1, 0.55, 0.03, 0.12]
SIZE = [1400, 1000]  # of a screenshot
NOISE = 1e-5  # less than this counts as nothing, as at the start


def folder():
    """Returns the folder of the results: that of this script, if they are still beside it."""
    here = os.path.dirname(os.path.abspath(globals().get("__file__", ".")))
    return here if os.path.isfile(os.path.join(here, "flow.xdmf")) else SCENE["folder"]


def open_series(name):
    """Opens one of the series; None if the run has none."""
    path = os.path.join(folder(), name + ".xdmf")
    if not os.path.isfile(path):
        return None
    series = pv.XDMFReader(registrationName=name, FileNames=[path])
    series.UpdatePipeline(series.TimestepValues[-1] if len(series.TimestepValues) else 0)
    return series


def plane():
    """Returns whether the run is two-dimensional."""
    return len(SCENE["lower"]) == 2


def middle():
    """Returns the middle of the box."""
    return [0.5 * (low + high) for low, high in zip(SCENE["lower"], SCENE["upper"])] + [0.0] * plane()


def diagonal():
    """Returns the length of the box's diagonal."""
    return sum((high - low) ** 2 for low, high in zip(SCENE["lower"], SCENE["upper"])) ** 0.5


def clip(source, name, inside):
    """Returns the part of a source inside or outside a body."""
    part = pv.Clip(registrationName=("inside " if inside else "outside ") + name, Input=source, ClipType="Scalar")
    part.Scalars = ["POINTS", name]
    part.Value, part.Invert = 0.0, int(inside)  # after the scalars, which set it to the middle of their range
    return part


def surface_of(points, body, surfaces):
    """Returns the solid of a body in the plane, its surface in space: its triangles, or where its distance is zero."""
    if plane():
        return clip(points, body["name"], inside=True)
    if surfaces is None or body["number"] < 0:
        surface = pv.Contour(registrationName=body["name"], Input=points)
        surface.ContourBy = ["POINTS", body["name"]]
        surface.Isosurfaces, surface.ComputeScalars = [0.0], 0
        return surface
    surface = pv.Threshold(registrationName=body["name"], Input=surfaces)
    surface.Scalars = ["POINTS", "body"]
    surface.LowerThreshold = surface.UpperThreshold = body["number"]
    return surface


def show_bodies(points, view):
    """Shows each body in grey; one round the water can be seen through."""
    shown, surfaces = {}, None if plane() else open_series("surfaces")
    for body in SCENE["bodies"]:
        shown[body["name"]] = surface_of(points, body, surfaces)
        display = pv.Show(shown[body["name"]], view)
        display.ColorArrayName = ["POINTS", ""]
        display.DiffuseColor = display.AmbientColor = SOLID
        display.Opacity = 0.12 if body["surrounds"] and not plane() else 1.0
    return shown


def in_water(source):
    """Returns what of a source is outside all bodies."""
    for body in SCENE["bodies"]:
        source = clip(source, body["name"], inside=False)
    return source


def show_flow(points, view):
    """Shows the flow in the water: all of it in the plane, a slice in space."""
    name = "vorticity" if plane() else "velocity"
    slice_ = points
    if not plane():
        slice_ = pv.Slice(registrationName="slice", Input=points, SliceType="Plane")
        slice_.SliceType.Origin = SCENE["slice_origin"]
        slice_.SliceType.Normal = SCENE["slice_normal"]
    water = in_water(slice_)
    display = pv.Show(water, view)
    display.Representation = "Surface"
    display.Opacity = 1.0 if plane() else SCENE["opacity"]
    display.Ambient, display.Diffuse = 0.4, 0.6
    colour(display, name, "vorticity [1/s]" if plane() else "speed [m/s]", VORTICITY if plane() else SPEED, view, 0.08)
    return water


def range_of(table, symmetric):
    """Returns the range of a table of colours: from zero, or round it and narrower than the peaks where both signs count."""
    low, high = table.RGBPoints[0], table.RGBPoints[-4]
    if symmetric:
        high = 0.4 * max(abs(low), abs(high))
    high = high if high > NOISE else 1.0
    return -high if symmetric else 0.0, high


def colour(display, name, title, colours, view, height):
    """Colours by a field, with one range for all times, and a bar at a height of the picture."""
    pv.ColorBy(display, ("POINTS", name, "Magnitude") if name == "velocity" else ("POINTS", name))
    display.RescaleTransferFunctionToDataRangeOverTime()
    table = pv.GetColorTransferFunction(name)
    limits = range_of(table, colours is VORTICITY)
    table.RGBPoints, table.ColorSpace = colours, "Lab"
    table.RescaleTransferFunction(*limits)
    bar = pv.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle, bar.ScalarBarLength, bar.ScalarBarThickness = title, "", 0.34, 20
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.TitleFontSize = bar.LabelFontSize = 20
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%-.2g", "%-.2g"
    bar.WindowLocation, bar.Position = "Any Location", [0.84, height]
    display.SetScalarBarVisibility(view, True)


def show_cloths(cloths, view):
    """Shows the cloths, coloured by their stress; SCENE's "colour" may be group instead."""
    display = pv.Show(cloths, view)
    display.Representation = "Surface" if plane() else "Surface With Edges"
    display.EdgeColor, display.LineWidth = EDGE, 5.0 if plane() else 1.0
    display.Position = [0, 0, 1e-3 * diagonal() * plane()]  # in front of the flow
    display.Ambient, display.Diffuse = 0.45, 0.6
    name = SCENE["colour"]
    colour(display, name, "stress [Pa]" if name == "stress" else name, FIBRE if plane() else FABRIC, view, 0.56)
    return cloths


def place_camera(view):
    """Looks at the box: from above in the plane, from above and one side in space."""
    centre, reach = middle(), diagonal()
    view.CameraFocalPoint = centre
    if plane():
        view.CameraParallelProjection, view.CameraParallelScale = 1, 0.41 * reach
        view.CameraPosition, view.CameraViewUp = [centre[0], centre[1], 3 * reach], [0, 1, 0]
    else:
        view.CameraViewAngle, view.CameraViewUp = 25, [0, 0, 1]
        view.CameraPosition = [centre[0] + 0.55 * reach, centre[1] - 1.35 * reach, centre[2] + 1.05 * reach]


def make_scene():
    """Makes the scene and returns view and sources by name."""
    view = pv.GetActiveViewOrCreate("RenderView")
    view.UseColorPaletteForBackground, view.BackgroundColorMode, view.Background = 0, "Single Color", [1, 1, 1]
    view.OrientationAxesLabelColor = [0, 0, 0]
    flow, bodies, cloths = (open_series(name) for name in ("flow", "bodies", "cloth"))
    scene = pv.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.GoToLast()
    fields = pv.AppendAttributes(registrationName="fields", Input=[flow, bodies]) if bodies else flow
    points = pv.CellDatatoPointData(registrationName="at points", Input=fields)
    sources = {"flow": show_flow(points, view)}
    sources.update(show_bodies(points, view) if bodies else {})
    if cloths:
        sources["cloth"] = show_cloths(cloths, view)
    clock = pv.AnnotateTimeFilter(registrationName="time", Input=flow, Format=SCENE["case"] + ", t = {time:.3f} s")
    text = pv.Show(clock, view)
    text.Color, text.FontSize, text.WindowLocation = [0, 0, 0], 26, "Upper Center"
    place_camera(view)
    return view, scene, sources


def main():
    """Makes the scene; under pvpython it may go to a time, save a picture and count what is visible."""
    parser = argparse.ArgumentParser(description="Scene of a run of washfsi")
    parser.add_argument("--screenshot", metavar="FILE.png")
    parser.add_argument("--time", type=float, help="[s]; the last frame unless given")
    parser.add_argument("--count", action="store_true", help="print the number of cells of each thing shown")
    options, _ = parser.parse_known_args(getattr(sys, "argv", [""])[1:])
    view, scene, sources = make_scene()
    if options.screenshot:
        view.ViewSize = SIZE
    if options.time is not None:
        scene.AnimationTime = min(scene.TimeKeeper.TimestepValues, key=lambda time: abs(time - options.time))
    pv.Render(view)
    for name, source in sources.items() if options.count else ():
        print(name, source.GetDataInformation().GetNumberOfCells())
    if options.screenshot:
        pv.SaveScreenshot(options.screenshot, view, ImageResolution=SIZE)
        print(options.screenshot)


main()
