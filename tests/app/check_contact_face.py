#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares the contact faces of an output directory with its other files.

usage: check_contact_face.py DIR

For each time of contact.pvd, which are those of fields.pvd: max_pressure, min_gap
(contact.csv) are the largest pressure and the smallest gap of the face; contact_force and
contact_area are sums of the pressure and of in_contact with the weights of the nodes,
integrals of their Gauss-Lobatto polynomials, products of those along y and along z; the
temperature is that of the fields at the points that both have, the corners of the cells.
The places are those of the nodes, on x = 1. Single precision: 1e-6. And the forecast of
their size.
"""
import re
import sys
from pathlib import Path

import numpy

sys.dont_write_bytecode = True
from polynomials import Element, lobatto_nodes  # noqa: E402
from run_files import Run  # noqa: E402

BOUND = 1e-6


def nodes_and_weights(run):
    """Places along y, and the weights of the nodes there, of sum 1."""
    s = run.settings
    degree, cells = int(s["Mesh/Degree"]), int(s["Mesh/Cells across"])
    width = s.number("Mesh/Width")
    element = Element(lobatto_nodes(degree))
    places, weights = numpy.zeros(cells * degree + 1), numpy.zeros(cells * degree + 1)
    for cell in range(cells):
        here = slice(cell * degree, (cell + 1) * degree + 1)
        places[here] = (cell + element.nodes) * width / cells
        weights[here] += element.integrals / cells
    return places, weights


def check_face(run, time, face, body, row):
    """Faults of one snapshot."""
    points, y = face.points, nodes_and_weights(run)[0]
    n = len(y) ** (int(run.settings["Dimension"]) - 1)
    is_round = run.settings.get("Mesh/Geometry") == "axisymmetric"
    places = numpy.unique(numpy.round(points, 6), axis=0)
    if len(places) != n - is_round or abs(points[:, 0] - 1).max() > BOUND:
        yield f"{len(places)} nodes instead of {n}"
    if abs(numpy.unique(places[:, 1]) - y[is_round:]).max() > BOUND:
        yield "places along y"
    index = [numpy.argmin(numpy.linalg.norm(points - place, axis=1)) for place in places]
    value = {name: face.point_data[name].ravel().astype(float)[index]
             for name in face.point_data}
    names = {"contact_pressure", "gap", "in_contact"} | (
        {"temperature"} if run.has("temperature") else set())
    if set(value) != names:
        yield f"fields {sorted(value)}"
    pressure, is_closed = value["contact_pressure"], value["in_contact"]
    if not numpy.array_equal(is_closed, pressure > 0):
        yield "in_contact is not where there is pressure"
    expected = {"max_pressure": pressure.max(), "min_gap": value["gap"].min()}
    if not is_round:
        of_node = dict(zip(numpy.round(y, 6), nodes_and_weights(run)[1]))
        weight = numpy.prod([[of_node[numpy.round(c, 6)] for c in place[1:]
                              ][:int(run.settings["Dimension"]) - 1] for place in
                             numpy.round(places.astype(float), 6)], axis=1)
        expected |= {"contact_force": weight @ pressure, "contact_area": weight @ is_closed}
    for name, number in expected.items():
        if abs(number - row[name]) > BOUND * max(1, abs(row[name])):
            yield f"{name} {number} instead of {row[name]} at t = {time}"
    if "temperature" in names:
        distances = numpy.linalg.norm(points[:, None] - body.points[None], axis=2)
        both = distances.min(axis=1) < BOUND
        found = face.point_data["temperature"].ravel()[both]
        there = body.point_data["temperature"].ravel()[distances[both].argmin(axis=1)]
        if both.sum() < 2 or abs(found - there).max() > BOUND * max(1, abs(there).max()):
            yield f"temperature at t = {time}"


def check_forecast(run, n_files):
    """The size of the files, which the log says before the run, within a factor of 1.5."""
    match = re.search(r"; contact face: as many, about (\S+) (B|kB|MB)", run.log)
    if not n_files or not match:
        return [] if not n_files and not match else ["no forecast, or one of nothing"]
    size = sum(path.stat().st_size for path in run.directory.glob("fields/contact-*.vtu"))
    ratio = float(match[1]) * {"B": 1, "kB": 1e3, "MB": 1e6}[match[2]] / size
    return [] if 1 / 1.5 < ratio < 1.5 else [f"{match[0]}, found {size} bytes"]


class Faces(Run):
    """A run with the snapshots of its contact face."""

    def faces(self):
        return self.snapshots("contact.pvd")

    def has(self, field):
        return self.settings.has(field)


def main():
    run = Faces(sys.argv[1])
    faces, bodies, c = run.faces(), run.snapshots(), run.contact
    faults = []
    files = sorted(path.name for path in (run.directory / "fields").iterdir())
    expected = sorted(f"{name}-{i:05d}.vtu" for i in range(len(bodies))
                      for name in (["fields", "contact"] if faces else ["fields"]))
    if files != expected or len(bodies) != 6:
        faults.append(f"files {files}")
    if [time for time, _ in faces] != [time for time, _ in bodies] and faces:
        faults.append("times")
    for (time, face), (_, body) in zip(faces, bodies):
        i = int(numpy.argmin(abs(c["time"] - time)))
        row = {name: c[name][i] for name in c.names}
        faults += check_face(run, time, face, body, row)
    faults += check_forecast(run, len(faces))
    partial = [int(0 < area < 1) for area in c["contact_area"]]
    print("contact face:", "none" if not faces else
          f"{len(faces)} times, some of it closed {int(any(partial))},",
          faults[0] if faults else "as the other files say")
    if Path(run.directory / "contact.pvd").exists() != bool(faces):
        print("contact.pvd is or is not there")


main()
