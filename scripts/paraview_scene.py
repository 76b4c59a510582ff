"""Runs under pvbatch: the part of scripts/paraview that needs ParaView."""

import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import paraview_contact
import paraview_space_time
from paraview import servermanager
from paraview.simple import (Box, Calculator, Clean, ColorBy, CreateView,
                             ExtractSurface, GetColorTransferFunction, GetScalarBar,
                             LinearExtrusion, PVDReader, Render,
                             SaveScreenshot, Show, Text, Tube, WarpByVector,
                             XMLUnstructuredGridReader)
from paraview_numbers import (Ranges, field_of, scale_label, time_labels,
                              times_of_pictures, view_of)
from vtkmodules.util.numpy_support import vtk_to_numpy

RADIUS = 0.05  # of the rod, in its lengths
BAR = 0.24  # width of what stands beside the scene, in widths of the picture


def fail(problem):
    print(f"\nscripts/paraview: {problem}", flush=True)
    sys.exit(0)


class Snapshots:
    """Times, and what is to be known of all of them before one is drawn."""

    def __init__(self, path, colour):
        self.reader = PVDReader(FileName=path)
        times = self.reader.TimestepValues
        self.times = [times] if isinstance(times, float) else list(times)
        self.ranges = Ranges()
        for time in self.times:
            self.reader.UpdatePipeline(time)
            grid = servermanager.Fetch(self.reader)
            names = [grid.GetPointData().GetArrayName(i) for i in
                     range(grid.GetPointData().GetNumberOfArrays())]
            self.colour = field_of(colour, names)
            if self.colour is None:
                fail(f"--colour {colour}: no such field; give one of "
                     + ", ".join(names))
            self.moves = "displacement" in names
            arrays = {name: vtk_to_numpy(grid.GetPointData().GetArray(name))
                      for name in names}
            self.ranges.add(vtk_to_numpy(grid.GetPoints().GetData()),
                            arrays[self.colour], arrays.get("displacement"))
        self.bounds = grid.GetBounds()
        self.dim = 1 + sum(self.bounds[2 * d + 1] > self.bounds[2 * d]
                           for d in (1, 2))


def show_plain(view, source, colour, opacity=1.):
    shown = Show(source, view)
    shown.AmbientColor = shown.DiffuseColor = colour
    shown.Opacity = opacity
    return shown


def show_box(view, low, high, colour, opacity=1.):
    box = Box(XLength=high[0] - low[0], YLength=high[1] - low[1],
              ZLength=high[2] - low[2],
              Center=[(a + b) / 2 for a, b in zip(low, high)])
    show_plain(view, box, colour, opacity)
    return box


def reader_of(path):
    """Of an obstacle that stands still or of one that moves."""
    return PVDReader(FileName=path) if path.endswith(".pvd") else \
        XMLUnstructuredGridReader(FileName=[path])


def range_of_gaps(settings, times):
    """Smallest and largest gap, at all times if the obstacle moves."""
    if settings["path"]:
        return min(settings["path"]), max(settings["path"])
    if not settings["shape"]:
        return settings["gap"], settings["gap"]
    reader, ends = reader_of(settings["shape"]), []
    for time in times if settings["shape"].endswith(".pvd") else [0.]:
        reader.UpdatePipeline(time)
        gaps = vtk_to_numpy(servermanager.Fetch(reader).GetPointData().GetArray("gap"))
        ends += [gaps.min(), gaps.max()]
    return min(ends), max(ends)


def show_shape(view, path, length, scale, back, colour, opacity):
    """An obstacle whose gap is not the same everywhere or that moves, as far as the
    end reaches: a solid behind its face with a flat back.

    length: of the body, where the gap begins
    back: where the obstacle ends
    """
    face = WarpByVector(Input=reader_of(path),
                        Vectors=["POINTS", "displacement"], ScaleFactor=scale)
    # sides of cells that are one do not become walls
    surface = Clean(Input=ExtractSurface(Input=face))
    sheet = LinearExtrusion(Input=surface, ScaleFactor=length, Vector=[1, 0, 0])
    solid = Calculator(Input=sheet, CoordinateResults=1, Function=(
        f"if(coordsX > {length} * 1.5 + {scale} * gap, {back}, coordsX) * iHat"
        " + coordsY * jHat + coordsZ * kHat"))
    show_plain(view, solid, colour, opacity).ColorArrayName = ["POINTS", ""]


def body_of(snapshots, scale):
    """The snapshots, moved; the rod is a tube."""
    body = snapshots.reader
    if snapshots.moves:
        body = WarpByVector(Input=body, Vectors=["POINTS", "displacement"],
                            ScaleFactor=scale)
    if snapshots.dim == 1:
        body = Tube(Input=ExtractSurface(Input=body), Radius=RADIUS * snapshots.ranges.length,
                    NumberofSides=32)
        body.Scalars = ["POINTS", ""]
        body.Vectors = ["POINTS", ""]
    return body


def show_body(view, snapshots, scale):
    body = body_of(snapshots, scale)
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


def show_colours(view, shown, snapshots, size, unit):
    table = GetColorTransferFunction(snapshots.colour)
    table.ApplyPreset("Viridis (matplotlib)", True)
    table.RescaleTransferFunction(*snapshots.ranges.colours())
    bar = GetScalarBar(table, view)
    bar.Orientation = "Vertical"
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength = [1 - 0.8 * BAR, 0.2], 0.6
    bar.Title = snapshots.colour
    bar.ComponentTitle = f"[{unit}]" if unit else ""
    bar.HorizontalTitle = 1
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.TitleFontSize = bar.LabelFontSize = size
    bar.ScalarBarThickness = size
    bar.AutomaticLabelFormat, bar.LabelFormat = 0, "%-#.3g"
    bar.RangeLabelFormat = "%-#.3g"
    shown.SetScalarBarVisibility(view, True)


def make_view(snapshots, low, high, width):
    """Looks at the plane of x and y; at a block obliquely, from above. The scene
    is on the left, so that beside it there is room for the colour bar.

    low, high: corners of the box with all that is shown
    """
    away, to_right, seen, across = view_of(low, high, snapshots.dim == 3)
    length = (seen + 0.08 * snapshots.ranges.length) / (1 - BAR)
    pixels = int(width * min(1., max(0.3, 1.25 * across / length + 0.1)))
    view = CreateView("RenderView")
    view.ViewSize = [width, pixels]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    Render(view)  # the first time it moves the camera
    view.CameraParallelProjection = 1
    # as wide as the picture, or as high if that is more
    view.CameraParallelScale = max(length * pixels / width, 1.3 * across) / 2
    focus = [(a + b) / 2 + BAR * length / 2 * r for a, b, r in zip(low, high, to_right)]
    view.CameraFocalPoint = focus
    # in front of all, since what is behind the camera is cut away
    far = 2 * (sum(high) - sum(low)) + length
    view.CameraPosition = [f + far * a for f, a in zip(focus, away)]
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
        settings["scale"] = snapshots.ranges.scale() if snapshots.moves else 0.
    scale = settings["scale"]
    has_obstacle = snapshots.moves and settings["gap"] is not None
    nearest_gap, farthest_gap = range_of_gaps(settings, snapshots.times) if \
        has_obstacle else (None, None)
    plate, right = snapshots.ranges.plate(scale, nearest_gap)
    depth = scale * (farthest_gap - nearest_gap) if has_obstacle else 0
    unit, units = snapshots.ranges.length, settings.get("units", {})
    radius = RADIUS * unit
    low, high = ([-radius] * 2, [radius] * 2) if snapshots.dim == 1 else (
        snapshots.ranges.box_across(scale).tolist())
    more = 0.04 * unit
    low, high = [v - more for v in low], [v + more for v in high]
    # an obstacle that goes farther than a length leaves the picture
    view = make_view(snapshots, [-0.03 * unit, *low], [right + min(depth, unit), *high],
                     settings["width"])
    size = max(10, settings["width"] // 55)
    show_colours(view, show_body(view, snapshots, scale), snapshots, size,
                 units.get(f"{snapshots.colour}_end"))
    if settings["held"]:
        show_box(view, [-0.03 * unit, *low], [0, *high], [0.45] * 3)
    block = None
    if plate is not None and settings["shape"]:
        show_shape(view, settings["shape"], unit, scale, right + depth, [0.84, 0.37, 0], 0.55)
    elif plate is not None:
        block = show_box(view, [plate, *low], [right, *high], [0.84, 0.37, 0], 0.55)
    time_text = show_text(view, size, "Upper Left Corner")
    if snapshots.moves:
        show_text(view, size, "Upper Right Corner").Text = scale_label(scale)
    labels = time_labels(snapshots.times, units.get("time", ""))

    def draw(time, path):
        view.ViewTime = time
        if block and settings["path"]:
            face = unit + scale * settings["path"][snapshots.times.index(time)]
            block.Center = [face + (right - plate) / 2, *block.Center[1:]]
        time_text.Text = labels[time]
        Render(view)
        SaveScreenshot(path, view)

    pictures, frames = times_of_pictures(snapshots.times, settings["marks"],
                                         settings["frames"])
    for name, time in pictures.items():
        draw(time, f"{settings['output']}/{name}.png")
    for i, time in enumerate(frames):
        draw(time, f"{settings['scratch']}/frame-{i:04d}.png")


def main():
    settings = json.loads(sys.argv[1])
    if "space_time" in settings:
        paraview_space_time.draw(settings["space_time"],
                                 settings["output"] + "/space-time.png",
                                 settings["width"], settings.get("units"))
    if "contact_face" in settings:
        time, path = settings["contact_face"]
        paraview_contact.draw(path, time,
                              settings["output"] + "/contact-face.png",
                              settings["width"], settings.get("units"))
    if "snapshots" in settings:
        render(settings)
    print("\ndone", flush=True)


if __name__ == "__main__":
    main()
