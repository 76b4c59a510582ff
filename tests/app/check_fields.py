#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares the snapshots of an output directory with its contact.csv.

For each time of fields.pvd: the row of contact.csv with exactly that time, and
in the VTU file u, v and theta at x = 1 and u at x = 1/2 (on the axis) equal to
it in single precision, 1e-6. A third reader of the files: python3-meshio.
"""
import csv
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import meshio
import numpy

directory = Path(sys.argv[1])
with open(directory / "contact.csv", encoding="utf-8") as file:
    rows = csv.DictReader(line for line in file if not line.startswith("#"))
    records = {float(row["time"]): row for row in rows}
snapshots = xml.parse(directory / "fields.pvd").findall(".//DataSet")

worst, n_times = 0.0, 0
for snapshot in snapshots:
    record = records.get(float(snapshot.get("timestep")))
    if record is None:
        continue
    n_times += 1
    mesh = meshio.read(directory / snapshot.get("file"))
    middle = mesh.points[:, 1:].max(axis=0) / 2
    for x, array, column in ((1, "displacement", "displacement_end"),
                             (1, "velocity", "velocity_end"),
                             (1, "temperature", "temperature_end"),
                             (0.5, "displacement", "displacement_mid")):
        place = numpy.array([x, *middle])
        point = numpy.argmin(numpy.linalg.norm(mesh.points - place, axis=1))
        assert numpy.allclose(mesh.points[point], place, atol=1e-6)
        value = mesh.point_data[array][point]
        value = value[0] if value.ndim else value
        expected = float(record[column])
        error = abs(value - expected) / max(1, abs(expected))
        worst = max(worst, error if error == error else float("inf"))
print(f"snapshots {len(snapshots)}, times found in contact.csv {n_times}, "
      f"values equal to 1e-6 {int(worst < 1e-6)}, components of displacement "
      f"{mesh.point_data['displacement'].shape[1]}, of stress "
      f"{mesh.point_data['stress'][0].size}")
