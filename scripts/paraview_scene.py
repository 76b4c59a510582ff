"""Runs under pvbatch: the part of scripts/paraview that needs ParaView."""

import json
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import numpy
import paraview_space_time
from paraview import servermanager
from paraview.simple import (Box, ColorBy, CreateView, ExtractSurface,
                             GetColorTransferFunction, GetScalarBar, PVDReader,
                             Render, SaveScreenshot, Show, Text, Tube,
                             WarpByVector)
from vtkmodules.util.numpy_support import vtk_to_numpy

RADIUS = 0.05  # of the rod
USUAL = ["temperature", "stress", "displacement", "velocity"]


def fail(problem):
    print(f"\nscripts/paraview: {problem}", flush=True)
    sys.exit(0)


class Snapshots:
    """Times, and what is to be known of all of them before one is drawn."""

    def __init__(self, path, colour):
        self.reader = PVDReader(FileName=path)
        times = self.reader.TimestepValues
        self.times = [times] if isinstance(times, float) else list(times)
        self.motion, self.reach, self.compression = 0., 0., 0.
        self.low, self.high = math.inf, -math.inf
        for time in self.times:
            self.reader.UpdatePipeline(time)
            grid = servermanager.Fetch(self.reader)
            names = [grid.GetPointData().GetArrayName(i) for i in
                     range(grid.GetPointData().GetNumberOfArrays())]
            if colour == "automatic":
                colour = next(name for name in USUAL if name in names)
            if colour not in names:
                fail(f"--colour {colour}: no such field; give one of "
                     + ", ".join(names))
            self.add(grid, colour)
        self.colour, self.moves = colour, "displacement" in names
        bounds = grid.GetBounds()
        self.dim = 1 + (bounds[3] > bounds[2]) + (bounds[5] > bounds[4])
        self.bounds = bounds

    def add(self, grid, colour):
        arrays = grid.GetPointData()
        values = vtk_to_numpy(arrays.GetArray(colour))
        values = values[:, 0] if values.ndim > 1 else values
        self.low = min(self.low, values.min())
        self.high = max(self.high, values.max())
        if not arrays.GetArray("displacement"):
            return
        u = vtk_to_numpy(arrays.GetArray("displacement"))[:, 0]
        x = vtk_to_numpy(grid.GetPoints().GetData())[:, 0]
        places, of = numpy.unique(numpy.round(x, 6), return_inverse=True)
        means = numpy.bincount(of, u) / numpy.bincount(of)
        strains = numpy.diff(means) / numpy.diff(places)
        self.motion = max(self.motion, abs(u).max())
        self.reach = max(self.reach, u[x > 1 - 1e-6].max())
        self.compression = max(self.compression, -strains.min())

    def scale(self):
        """A third of the length; lengths shrink to a quarter at most."""
        scale = 0.33 / self.motion if self.motion > 0 else 1.
        if self.compression > 0:
            scale = min(scale, 0.75 / self.compression)
        power = 10. ** math.floor(math.log10(scale))
        return float(f"{math.floor(scale / power) * power:.1g}")

    def nearest(self, time):
        return min(self.times, key=lambda t: abs(t - time))


def show_box(view, low, high, colour, opacity=1.):
    box = Box(XLength=high[0] - low[0], YLength=high[1] - low[1],
              ZLength=high[2] - low[2],
              Center=[(a + b) / 2 for a, b in zip(low, high)])
    shown = Show(box, view)
    shown.AmbientColor = shown.DiffuseColor = colour
    shown.Opacity = opacity


def show_body(view, snapshots, scale):
    body = snapshots.reader
    if snapshots.moves:
        body = WarpByVector(Input=body, Vectors=["POINTS", "displacement"],
                            ScaleFactor=scale)
    if snapshots.dim == 1:
        body = Tube(Input=ExtractSurface(Input=body), Radius=RADIUS,
                    NumberofSides=32)
        body.Scalars = ["POINTS", ""]
        body.Vectors = ["POINTS", ""]
    shown = Show(body, view)
    shown.Representation = "Surface With Edges" if snapshots.dim > 1 else \
        "Surface"
    if snapshots.dim > 1:
        shown.EdgeColor, shown.LineWidth = [0.35] * 3, 0.5
    # light tells shapes in space apart; elsewhere it would falsify the colours
    shown.Ambient, shown.Diffuse = (1, 0) if snapshots.dim == 2 else (0.5, 0.6)
    shown.Specular = 0
    values = snapshots.reader.PointData[snapshots.colour]
    axial = values.GetNumberOfComponents() > 1
    ColorBy(shown, ("POINTS", snapshots.colour, "X") if axial and
            values.GetNumberOfComponents() == 3 else
            ("POINTS", snapshots.colour, "0") if axial else
            ("POINTS", snapshots.colour))
    return shown


def show_colours(view, shown, snapshots, size):
    table = GetColorTransferFunction(snapshots.colour)
    table.ApplyPreset("Viridis (matplotlib)", True)
    high = snapshots.high + 1e-9 * max(1, abs(snapshots.high)) * (
        snapshots.high == snapshots.low)
    table.RescaleTransferFunction(snapshots.low, high)
    bar = GetScalarBar(table, view)
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength = [0.3, 0.07], 0.4
    bar.Title = snapshots.colour
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.TitleFontSize = bar.LabelFontSize = size
    bar.ScalarBarThickness = size
    bar.AutomaticLabelFormat, bar.LabelFormat = 0, "%-#.3g"
    bar.RangeLabelFormat = "%-#.3g"
    shown.SetScalarBarVisibility(view, True)


def make_view(snapshots, right, width):
    """Looks at the plane of x and y; at a block obliquely, from above."""
    low, high = snapshots.bounds[2::2], snapshots.bounds[3::2]
    across = max(2 * RADIUS, high[0] - low[0])
    if snapshots.dim == 3:
        across *= 1.8
    length = right + 0.14
    pixels = int(width * min(1., max(0.25, across / length + 0.2)))
    view = CreateView("RenderView")
    view.ViewSize = [width, pixels]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    Render(view)  # the first time it moves the camera
    view.CameraParallelProjection = 1
    view.CameraParallelScale = length * pixels / width / 2
    # the body is above the middle: below it is the colour bar
    focus = [right / 2, (low[0] + high[0]) / 2 - 0.03, (low[1] + high[1]) / 2]
    away = [-0.35, 0.45, 1.5] if snapshots.dim == 3 else [0, 0, 3]
    view.CameraFocalPoint = focus
    view.CameraPosition = [f + a for f, a in zip(focus, away)]
    view.CameraViewUp = [0, 1, 0]
    return view


def show_text(view, size, place):
    text = Text()
    shown = Show(text, view)
    shown.WindowLocation = place
    shown.Color, shown.FontSize = [0, 0, 0], size
    return text


def render(settings):
    snapshots = Snapshots(settings["snapshots"], settings["colour"])
    if settings["scale"] is None:
        settings["scale"] = snapshots.scale() if snapshots.moves else 0.
    scale, gap = settings["scale"], settings["gap"]
    plate = 1 + scale * gap if gap is not None else math.inf
    has_plate = plate <= 2 and snapshots.moves
    back = 1 + scale * snapshots.reach  # farthest that the end comes
    right = max(plate, back) + 0.03 if has_plate else back
    view = make_view(snapshots, right, settings["width"])
    size = max(10, settings["width"] // 55)
    show_colours(view, show_body(view, snapshots, scale), snapshots, size)
    low, high = ([-RADIUS] * 2, [RADIUS] * 2) if snapshots.dim == 1 else (
        list(snapshots.bounds[2::2]), list(snapshots.bounds[3::2]))
    more = 0.04
    low, high = [v - more for v in low], [v + more for v in high]
    show_box(view, [-0.03, *low], [0, *high], [0.45] * 3)
    if has_plate:
        show_box(view, [plate, *low], [right, *high], [0.84, 0.37, 0], 0.55)
    time_text = show_text(view, size, "Upper Left Corner")
    if snapshots.moves:
        show_text(view, size, "Upper Right Corner").Text = \
            f"displacement \u00d7 {scale:g}"

    def draw(time, path):
        view.ViewTime = time
        time_text.Text = f"t = {time:.2f}"
        Render(view)
        SaveScreenshot(path, view)

    marks = {name: snapshots.nearest(time) for name, time in
             settings["marks"].items()}
    marks.update(first=snapshots.times[0], last=snapshots.times[-1])
    for name, time in marks.items():
        draw(time, f"{settings['output']}/{name}.png")
    stride = math.ceil(len(snapshots.times) / max(1, settings["frames"]))
    if settings["frames"]:
        for i, time in enumerate(snapshots.times[::stride]):
            draw(time, f"{settings['scratch']}/frame-{i:04d}.png")


def main():
    settings = json.loads(sys.argv[1])
    if "space_time" in settings:
        paraview_space_time.draw(settings["space_time"],
                                 settings["output"] + "/space-time.png",
                                 settings["width"])
    if "snapshots" in settings:
        render(settings)
    print("\ndone", flush=True)


main()
