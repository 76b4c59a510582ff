# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stands in for ParaView where it is not installed: as much of its modules as
scripts/paraview uses, read by meshio. Filters have their properties, and their
output has the points and bounds that these properties make; nothing is drawn.
"""
import sys
import types
import xml.etree.ElementTree as xml
from pathlib import Path

import meshio
import numpy


class Named:
    """An array or table of VTK, or many of them by name."""

    def __init__(self, arrays):
        self.arrays = arrays

    def GetNumberOfArrays(self):
        return len(self.arrays)

    def GetArrayName(self, i):
        return list(self.arrays)[i]

    def GetArray(self, name):
        return self.arrays.get(name)


class Grid:
    def __init__(self, points, arrays, quads=None):
        self.points, self.arrays, self.quads = points, arrays, quads

    def GetPointData(self):
        return Named(self.arrays)

    def GetPoints(self):
        return types.SimpleNamespace(GetData=lambda: self.points)

    def GetBounds(self):
        return tuple(f(self.points[:, d]) for d in range(3)
                     for f in (numpy.min, numpy.max))

    def corners(self):
        """Of its bounds."""
        bounds = self.GetBounds()
        return numpy.array([[bounds[i], bounds[2 + j], bounds[4 + k]]
                            for i in (0, 1) for j in (0, 1) for k in (0, 1)])

    def GetCells(self):
        return types.SimpleNamespace(
            GetConnectivityArray=lambda: self.quads.ravel())


def read(path):
    mesh = meshio.read(path)
    return Grid(mesh.points, mesh.point_data, mesh.cells_dict.get("quad"))


class Proxy:
    """Takes any property; its output is that of its input."""

    def __init__(self, **properties):
        self.Input = None
        self.__dict__.update(properties)

    def UpdatePipeline(self, time=None):
        if self.Input:
            self.Input.UpdatePipeline(time)

    def output(self):
        return self.Input.output()

    def SetScalarBarVisibility(self, view, visible):
        pass


class Reader(Proxy):
    def __init__(self, FileName):
        super().__init__()
        self.path, self.grid = Path(FileName), None
        self.files = {float(entry.get("timestep")): entry.get("file")
                      for entry in xml.parse(self.path).iter("DataSet")}
        self.TimestepValues = list(self.files)

    def UpdatePipeline(self, time=None):
        nearest = min(self.files, key=lambda t: abs(t - time))
        self.grid = read(self.path.parent / self.files[nearest])

    def output(self):
        return self.grid

    @property
    def PointData(self):
        return {name: types.SimpleNamespace(
            GetNumberOfComponents=lambda a=a: 1 if a.ndim == 1 else a.shape[1])
            for name, a in self.grid.arrays.items()}


class GridReader(Proxy):
    def output(self):
        return read(self.FileName[0])


class WarpByVector(Proxy):
    def output(self):
        grid = self.Input.output()
        vectors = grid.arrays[self.Vectors[1]]
        return Grid(grid.points + self.ScaleFactor * vectors, grid.arrays)


class LinearExtrusion(Proxy):
    def output(self):
        grid = self.Input.output()
        shift = self.ScaleFactor * numpy.array(self.Vector)
        return Grid(numpy.concatenate([grid.points, grid.points + shift]),
                    {name: numpy.concatenate([a, a]) for name, a in grid.arrays.items()})


class Calculator(Proxy):
    """New coordinates of points."""

    def output(self):
        grid = self.Input.output()
        unit = dict(zip(("iHat", "jHat", "kHat"), numpy.eye(3)))
        names = {f"coords{axis}": grid.points[:, [d]] for d, axis in enumerate("XYZ")} | {
            name: a.reshape(len(grid.points), -1) for name, a in grid.arrays.items()}
        assert self.CoordinateResults == 1
        return Grid(eval(self.Function.replace("if(", "where("), {"where": numpy.where},
                         unit | names), grid.arrays)


class Box(Proxy):
    def output(self):
        half = numpy.array([self.XLength, self.YLength, self.ZLength]) / 2
        centre = numpy.array(self.Center)
        return Grid(numpy.array([centre - half, centre + half]), {})


class Table(Proxy):
    def RescaleTransferFunction(self, low, high):
        self.RGBPoints = [low, 0, 0, 0, high, 1, 1, 1]

    def ApplyPreset(self, name, rescale):
        pass


def install():
    """Makes the modules that the scripts import."""
    names = ["paraview", "paraview.simple", "paraview.servermanager",
             "vtkmodules", "vtkmodules.util", "vtkmodules.util.numpy_support"]
    modules = {name: types.ModuleType(name) for name in names}
    for name, module in modules.items():
        sys.modules[name] = module
        package, _, last = name.rpartition(".")
        if package:
            setattr(modules[package], last, module)
    modules[names[-1]].vtk_to_numpy = numpy.asarray
    modules["paraview.servermanager"].Fetch = lambda proxy: proxy.output()
    proxies = {name: Proxy for name in ("Clean", "ExtractSurface", "Text", "Tube")}
    modules["paraview.simple"].__dict__.update(
        proxies, Box=Box, WarpByVector=WarpByVector, PVDReader=Reader,
        LinearExtrusion=LinearExtrusion, Calculator=Calculator,
        XMLUnstructuredGridReader=GridReader, Render=None, SaveScreenshot=None,
        ColorBy=lambda shown, field: None, CreateView=lambda kind: Proxy(),
        Show=lambda source, view: Proxy(),
        GetColorTransferFunction=lambda name: Table(),
        GetScalarBar=lambda table, view: Proxy())
