"""Draws one snapshot of contact.pvd with matplotlib: part of scripts/paraview."""

from pathlib import Path

import numpy
from paraview import servermanager
from paraview.simple import XMLUnstructuredGridReader
from plot_common import label_axis, new_figure, save
from vtkmodules.util.numpy_support import vtk_to_numpy

FIELDS = {"contact_pressure": ("contact pressure  $p$", "viridis", "stress_end"),
          "gap": ("gap  $g - u$", "viridis_r", "gap")}  # has the unit of that column


def triangles_of(grid, n_points):
    """Corners of the quadrilaterals, and four triangles of each around its middle, which
    is a point behind the others; two of them would prefer a diagonal."""
    quads = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    middle = n_points + numpy.arange(len(quads))
    return quads, numpy.concatenate([numpy.stack([quads[:, i], quads[:, (i + 1) % 4],
                                                  middle], axis=1) for i in range(4)])


def draw_face(figure, axes, points, cells, values, colours, unit):
    """A map of the face of a block, y to the right and z upwards; the axis of its colours."""
    quads, triangles = cells
    y, z, shown = (numpy.concatenate([v, v[quads].mean(axis=1)])
                   for v in (points[:, 1], points[:, 2], values))
    high = max(values.max(), values.min() + 1e-9)
    shown = axes.tripcolor(y, z, triangles, shown, cmap=colours, vmin=values.min(),
                           vmax=high, shading="gouraud", rasterized=True)
    axes.set_aspect("equal")
    label_axis(axes.xaxis, "$y$", unit, y)
    label_axis(axes.yaxis, "$z$", unit, z)
    axes.grid(False)
    return figure.colorbar(shown, ax=axes, shrink=0.85).ax.yaxis


def draw_line(axes, y, values, unit):
    """A curve over the end of a strip or the radius of a round rod; its axis."""
    order = numpy.argsort(y, kind="stable")
    axes.plot(y[order], values[order])
    axes.set_xlim(y.min(), y.max())
    label_axis(axes.xaxis, "$y$", unit, y)
    return axes.yaxis


def draw(path, time, picture, width, units=None):
    """A panel for the pressure and one for the gap. In pixels.

    units: of the columns of contact.csv, by name
    """
    units = units or {}
    unit = units.get("displacement_end")
    reader = XMLUnstructuredGridReader(FileName=[path])
    reader.UpdatePipeline()
    grid = servermanager.Fetch(reader)
    points = vtk_to_numpy(grid.GetPoints().GetData())
    is_line = numpy.ptp(points[:, 2]) == 0
    figure = new_figure(7.6, 2.8 if is_line else 3.2)
    for axes, (name, (label, colours, column)) in zip(figure.subplots(1, 2),
                                                      FIELDS.items()):
        values = vtk_to_numpy(grid.GetPointData().GetArray(name))
        axis = draw_line(axes, points[:, 1], values, unit) if is_line else draw_face(
            figure, axes, points, triangles_of(grid, len(points)), values, colours, unit)
        label_axis(axis, label, units.get(column), values)
    figure.suptitle(f"contact end, t = {time:.3g} {units.get('time', '')}".strip(), fontsize="medium")
    save(figure, Path(picture), width / figure.get_figwidth())
