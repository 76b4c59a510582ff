"""Draws space-time.vtu with matplotlib: part of scripts/paraview."""

from pathlib import Path

import numpy
from paraview import servermanager
from paraview.simple import XMLUnstructuredGridReader
from plot_common import in_unit, label_axis, new_figure, save
from vtkmodules.util.numpy_support import vtk_to_numpy

FIELDS = {"temperature": (r"temperature  $\theta$", "viridis"),
          "displacement": (r"displacement  $u$", "RdBu_r"),
          "velocity": (r"velocity  $u_t$", "RdBu_r"),
          "stress": (r"stress  $\sigma$", "RdBu_r")}


def triangles_of(grid):
    """Two for each quadrilateral, whose corners go around."""
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    return numpy.concatenate([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])


def limits_of(values, colours):
    """Range of the colours: 1 in 200 values may be beyond either end."""
    values = values[numpy.isfinite(values)]  # some bodies have no velocity at first
    low, high = numpy.percentile(values, [0.5, 99.5])
    if colours == "RdBu_r":  # white is 0
        high = max(abs(low), abs(high))
        low = -high
    if high <= low:
        low, high = low - 1e-9, high + 1e-9
    beyond = (values.min() < low, values.max() > high)
    return low, high, {(False, False): "neither", (True, False): "min",
                       (False, True): "max", (True, True): "both"}[beyond]


def draw(path, picture, width, units=None):
    """A panel for each field; space to the right, time upwards. In pixels.

    units: of the columns of contact.csv, by name
    """
    units = units or {}
    reader = XMLUnstructuredGridReader(FileName=[path])
    reader.UpdatePipeline()
    grid = servermanager.Fetch(reader)
    x, t = vtk_to_numpy(grid.GetPoints().GetData())[:, :2].T
    arrays = {name: grid.GetPointData().GetArray(name) for name in FIELDS}
    arrays = {name: vtk_to_numpy(a) for name, a in arrays.items()
              if a is not None}
    figure = new_figure(2.6 * len(arrays) + 0.4, 4.6)
    panels = figure.subplots(1, len(arrays), sharey=True, squeeze=False)[0]
    triangles = triangles_of(grid)
    for axes, (name, values) in zip(panels, arrays.items()):
        label, colours = FIELDS[name]
        low, high, extend = limits_of(values, colours)
        shown = numpy.isfinite(values[triangles]).all(axis=1)
        mesh = axes.tripcolor(x, t, triangles[shown], values, cmap=colours, vmin=low,
                              vmax=high, shading="gouraud", rasterized=True)
        axes.set_xlabel("$x$")
        axes.set_xlim(0, x.max())
        if units:
            axes.set_xticks([0, x.max() / 2, x.max()])
            label_axis(axes.xaxis, "$x$", units["displacement_end"], x)
        else:
            axes.set_xticks([0, 0.5, 1], ["0", "1/2", "1"])
        axes.set_ylim(t.min(), t.max())
        axes.grid(False)
        bar = figure.colorbar(mesh, ax=axes, orientation="horizontal", extend=extend, pad=0.02)
        label_axis(bar.ax.xaxis, label, units.get(f"{name}_end"), [low, high])
    panels[0].set_ylabel(in_unit("time  $t$", units.get("time")))
    save(figure, Path(picture), width / figure.get_figwidth())
