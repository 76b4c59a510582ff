#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: pvbatch check_paraview.py DIR paraview, or python3 ... DIR meshio

Reads the snapshots and the space-time file of an output directory as ParaView
or meshio does, and compares them with contact.csv to 1e-6, since the files are
in single precision: at each time of a snapshot that contact.csv has exactly, u
at x = 1/2 on the axis, and the means of theta, u and v over the end x = 1. The
points of a snapshot are equidistant within a cell, so that the Newton-Cotes
formula of the degree is exact for them. In the space-time file, which holds the
axis, the end is compared for dim = 1 only. Nothing is rendered.
"""
import csv
import re
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import numpy

END = {"displacement": "displacement_end", "velocity": "velocity_end",
       "temperature": "temperature_end"}


def data_of(reader):
    """Points, and arrays by name, of what a reader of ParaView holds."""
    from paraview import servermanager
    from vtkmodules.util.numpy_support import vtk_to_numpy
    grid = servermanager.Fetch(reader)
    arrays = grid.GetPointData()
    return vtk_to_numpy(grid.GetPoints().GetData()), {
        arrays.GetArrayName(i): vtk_to_numpy(arrays.GetArray(i))
        for i in range(arrays.GetNumberOfArrays())}


def read_paraview(path):
    from paraview import simple
    reader = simple.XMLUnstructuredGridReader(FileName=[str(path)])
    reader.UpdatePipeline()
    return data_of(reader)


def series_paraview(path):
    """Time and data of each snapshot."""
    from paraview import simple
    reader = simple.PVDReader(FileName=str(path))
    times = reader.TimestepValues
    for time in [times] if isinstance(times, float) else times:
        reader.UpdatePipeline(time)
        yield time, data_of(reader)


def read_meshio(path):
    import meshio
    mesh = meshio.read(path)
    return mesh.points, mesh.point_data


def series_meshio(path):
    for entry in xml.parse(path).findall(".//DataSet"):
        yield (float(entry.get("timestep")),
               read_meshio(path.parent / entry.get("file")))


def read_records(directory):
    with open(directory / "contact.csv", encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return {float(row["time"]): row for row in rows}


def weights(places, degree):
    """Of the mean, at the sorted points of a line with cells of a degree."""
    n_cells = (len(places) - 1) // degree
    assert n_cells * degree + 1 == len(places)
    powers = numpy.arange(degree + 1)
    nodes = numpy.linspace(0, 1, degree + 1)
    cell = numpy.linalg.solve(nodes[None, :] ** powers[:, None],
                              1 / (powers + 1))
    result = numpy.zeros(len(places))
    for i in range(n_cells):
        result[i * degree:(i + 1) * degree + 1] += cell / n_cells
    return dict(zip(places, result))


def end_means(points, arrays, degree):
    """Means over the points with x = 1; a vector's axial component."""
    end = numpy.flatnonzero(abs(points[:, 0] - 1) < 1e-6)
    rounded = numpy.round(points[end].astype(float), 6)
    _, first = numpy.unique(rounded, axis=0, return_index=True)
    factors = [weights(numpy.unique(rounded[:, d]), degree)
               if len(numpy.unique(rounded[:, d])) > 1 else None for d in (1, 2)]
    means = {}
    for name, values in arrays.items():
        values = values[:, 0] if values.ndim > 1 else values
        means[name] = sum(
            float(values[end[i]])
            * (factors[0][rounded[i, 1]] if factors[0] else 1)
            * (factors[1][rounded[i, 2]] if factors[1] else 1) for i in first)
    return means


def on_axis(points, values, x, more=None):
    """The value at x in the middle of the section, or None without a point."""
    place = numpy.array([x, *(points[:, 1:].max(axis=0) / 2)]) \
        if more is None else numpy.array([x, more, 0])
    distances = numpy.linalg.norm(points - place, axis=1)
    i = distances.argmin()
    if distances[i] > 1e-6 * max(1, abs(place).max()):
        return None
    return float(values[i, 0] if values.ndim > 1 else values[i])


def defect(value, record, column):
    expected = float(record[column])
    error = abs(value - expected) / max(1, abs(expected))
    return error if error == error else float("inf")


def check_snapshots(directory, series, records, degree):
    worst, n_times, n_found = 0., 0, 0
    for time, (points, arrays) in series(directory / "fields.pvd"):
        n_times += 1
        if time not in records:
            continue
        n_found += 1
        means = end_means(points, arrays, degree)
        errors = [defect(means[name], records[time], column)
                  for name, column in END.items() if name in means]
        middle = on_axis(points, arrays["displacement"], 0.5)
        if middle is not None:
            errors.append(defect(middle, records[time], "displacement_mid"))
        worst = max(worst, *errors)
    print(f"snapshots {n_times}, times found {n_found}, worst {worst:.1e}")
    return n_found > 1 and worst < 1e-6


def check_space_time(path, read, records, dim):
    points, arrays = read(path)
    worst, n_found = 0., 0
    times = {float(numpy.float32(t)): float(t) for t in points[:, 1]}
    by_time = {float(numpy.float32(time)): row for time, row in records.items()}
    for key in sorted(set(times) & set(by_time)):
        time, record = times[key], by_time[key]
        n_found += 1
        errors = [defect(on_axis(points, arrays[name], 1., time), record, column)
                  for name, column in END.items() if dim == 1 and name in arrays]
        middle = on_axis(points, arrays["displacement"], 0.5, time)
        if middle is not None:
            errors.append(defect(middle, record, "displacement_mid"))
        worst = max([worst, *errors])
    print(f"space-time: times {len(times)}, found {n_found}, worst {worst:.1e}")
    return n_found > 1 and worst < 1e-6


def main():
    directory, reader = Path(sys.argv[1]), sys.argv[2]
    used = (directory / "used.prm").read_text()
    degree, dim = (
        int(match[1]) if match else default for match, default in (
            (re.search(r"set Degree += (\d+)", used), 4),
            (re.search(r"set Dimension += (\d+)", used), 1)))
    records = read_records(directory)
    series = series_paraview if reader == "paraview" else series_meshio
    read = read_paraview if reader == "paraview" else read_meshio
    good = check_snapshots(directory, series, records, degree)
    if (directory / "space-time.vtu").exists():
        good &= check_space_time(directory / "space-time.vtu", read, records,
                                 dim)
    print(f"{reader}: {'passed' if good else 'FAILED'}", flush=True)


main()
