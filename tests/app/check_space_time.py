#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares probes.csv and space-time.vtu with contact.csv and the snapshots.

probes.csv has the times of contact.csv; its u, v, theta at x = 1 and its u at
x = 1/2 equal those of contact.csv, to the last digit for a rod; for a strip,
whose contact.csv has means over the end, to 1e-10.
space-time.vtu: its second coordinates are times of contact.csv; u, v, theta at
x = 1 equal contact.csv in single precision, 1e-6; at the times of fields.pvd
all fields on the axis equal those of the snapshot: at each x the smallest and
the largest value, since the stress has two between cells.
"""
import csv
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import meshio
import numpy

FIELDS = ("temperature", "displacement", "velocity", "stress")
directory = Path(sys.argv[1])


def read_table(name):
    lines = (directory / name).read_text(encoding="utf-8").splitlines()
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return ([line for line in lines if line.startswith("# probe")],
            [{key: float(value) for key, value in row.items()} for row in rows])


def check_probes(records):
    comments, rows = read_table("probes.csv")
    pairs = [("time", "time")]
    for i, comment in enumerate(comments, 1):
        x = float(comment.split("x =")[1].split(",")[0])
        if x == 1:
            pairs += [(f"{name}_{i}", f"{name}_end") for name in FIELDS[:3]]
        if x == 0.5:
            pairs += [(f"displacement_{i}", "displacement_mid")]
    bound = 1e-10 if any("y =" in comment for comment in comments) else 0
    equal = [numpy.allclose([row[mine] for row in rows],
                            [record[other] for record in records],
                            rtol=bound, atol=bound, equal_nan=True)
             for mine, other in pairs if len(rows) == len(records)]
    print(f"probes {len(comments)}, columns compared with contact.csv "
          f"{len(pairs)}, equal {sum(equal)}")


def read_fields(path):
    """Coordinates, names of the fields there are, and their axial values."""
    mesh = meshio.read(path)
    names = [name for name in FIELDS if name in mesh.point_data]
    columns = [mesh.point_data[name].reshape(len(mesh.points), -1)[:, 0]
               for name in names]
    return mesh.points, names, numpy.array(columns, dtype=float).T


def extremes(x, values):
    """Places, and at each the smallest and largest value of each field."""
    x = numpy.round(x, 5)
    return {place: numpy.array([values[x == place].min(axis=0),
                                values[x == place].max(axis=0)])
            for place in numpy.unique(x)}


def error_of(values, expected):
    if not numpy.array_equal(numpy.isnan(values), numpy.isnan(expected)):
        return numpy.inf
    error = numpy.abs(values - expected) / numpy.maximum(1, numpy.abs(expected))
    return numpy.nanmax(error)


def check_space_time(records):
    points, names, values = read_fields(directory / "space-time.vtu")
    x, t = points[:, 0], points[:, 1]
    times = numpy.unique(t)
    known = {numpy.float32(record["time"]): record for record in records}
    unknown = [time for time in times if time not in known]
    assert not unknown, f"times that contact.csv does not have: {unknown}"
    worst = 0.0
    for i in numpy.flatnonzero(x == 1):
        for k, name in enumerate(names[:3]):
            worst = max(worst, error_of(values[i, k],
                                        known[t[i]][name + "_end"]))
    snapshots = xml.parse(directory / "fields.pvd").findall(".//DataSet")
    for snapshot in snapshots:
        at, there, expected = read_fields(directory / snapshot.get("file"))
        assert there == names, "not the fields of the snapshot"
        middle = at[:, 1:].max(axis=0) / 2
        on_axis = numpy.all(abs(at[:, 1:] - middle) < 1e-6, axis=1)
        now = t == numpy.float32(snapshot.get("timestep"))
        here = extremes(x[now], values[now])
        expected = extremes(at[on_axis, 0], expected[on_axis])
        assert here.keys() == expected.keys(), "not the points of the snapshot"
        worst = max(worst, *(error_of(here[p], expected[p]) for p in here))
    print(f"columns {len(times)}, fields {len(names)}, compared with snapshots "
          f"{len(snapshots)}, values equal to 1e-6 {int(worst < 1e-6)}")


all_records = read_table("contact.csv")[1]
check_probes(all_records)
if (directory / "space-time.vtu").exists():
    check_space_time(all_records)
