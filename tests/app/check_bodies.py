#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The published bodies with layers, by their snapshots in SI units.

bimetal: a wide strip, plane strain: layer i has E_i/(1 - nu^2) and strains by (1 + nu) alpha_i
dT without stress. The strain e + k y of a section has no force and no moment: two linear
equations, k = 1.36461/m. The tip is k L^2/2 off, the stress along the strip that of its layer
in the middle, ten widths from the ends.
hammer: a mass on the springs of block and cap in series, by its head; the waves of the block
move the force by 0.3 %.
pucks: masses alone, that exchange velocities, by their head; peaks of rows, times to 1e-5 of T.
"""
import csv
import sys
from pathlib import Path

import numpy

sys.dont_write_bytecode = True
from run_files import Run  # noqa: E402

run = Run(sys.argv[1])
faults = []


def check(name, found, expected, bound):
    if not abs(found - expected) <= bound:
        faults.append(f"{name} {found}, expected {expected}")


def table(name):
    with open(Path(sys.argv[1]) / name, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


if run.settings["Title"].startswith("Bimetal"):
    time, mesh = run.snapshots()[-1]
    place = numpy.concatenate([mesh.points[block.data] for block in mesh.cells])
    fields = {name: numpy.concatenate([values[block.data] for block in mesh.cells])
              for name, values in mesh.point_data.items()}
    names = {name.split(" ")[0]: name for name in fields}
    x, y = place[..., 0], place[..., 1]
    thickness, length = y.max(), x.max()
    interface, warmer, nu = 0.6 * thickness, 100, 0.3
    layers = ((0, interface, 100e9, 19e-6), (interface, thickness, 210e9, 12e-6))
    matrix, right = numpy.zeros((2, 2)), numpy.zeros(2)
    for begin, end, young, alpha in layers:
        for i in range(2):
            right[i] += young * (1 + nu) * alpha * warmer * (end**(i + 1) - begin**(i + 1)) / (i + 1)
            for j in range(2):
                matrix[i, j] += young * (end**(i + j + 1) - begin**(i + j + 1)) / (i + j + 1)
    strain, curvature = numpy.linalg.solve(matrix, right)
    check("curvature", -curvature, 1.36461, 1e-5)
    lifted = fields[names["displacement"]][..., 1]
    tip = lifted[x > length * 0.999999]
    check("tip", tip.mean() / (-curvature * length**2 / 2), 1, 5e-3)
    stress = fields[names["stress"]][..., 0]
    middle = abs(x - length / 2) < 1e-6 * length
    for cell in range(len(x)):
        young, alpha = layers[0 if y[cell].mean() < interface else 1][2:]
        wanted = young / (1 - nu**2) * (strain + curvature * y[cell] - (1 + nu) * alpha * warmer)
        for found, expected, counts in zip(stress[cell], wanted, middle[cell]):
            if counts:
                check("stress", found, expected, 1e4)
    if not middle.any():
        faults.append("no node in the middle")
elif run.settings["Title"].startswith("Pucks"):
    soft, hard = (numpy.pi * (0.17 / k)**0.5 for k in (1e6, 2e7))  # s
    events = table("events.csv")
    begins = (0.1, 0.3 + hard / 2, 0.5 + soft)
    if len(events) != 6:
        faults.append(f"{len(events)} events")
    for i, (begin, taken) in enumerate(zip(begins, (hard, soft, hard))):
        check("begin", float(events[2 * i]["time"]), 1e3 * begin, 2e-3)  # ms
        check("duration", float(events[2 * i + 1]["duration"]), 1e3 * taken, 1e-4)
        check("velocity", float(events[2 * i]["velocity"]), 5, 1e-4)
    rest, shot = (max(float(row["contact_force"]) for row in table(f"contacts/{name}.csv"))
                  for name in ("rest-obstacle", "shot-rest"))
    check("force at the boards", rest, 5 * (0.17 * 1e6)**0.5, 4)
    check("force of the pucks", shot, 5 * (0.17 * 5e6)**0.5, 4)
    if "strain" in run.log or "doubt" in run.log:
        faults.append("masses have strains")
else:
    rows, events = table("contact.csv"), table("events.csv")
    check("peak", max(float(row["contact_force"]) for row in rows), 4461.5, 20)
    check("duration", float(events[1]["duration"]), 0.70415, 3e-4)  # ms
    check("impulse", float(rows[-1]["contact_impulse"]), 2, 5e-3)
    # the hammer has what the contact gave it, and flies on
    check("momentum", 0.5 * (float(rows[-1]["obstacle_velocity"]) + 2),
          float(rows[-1]["contact_impulse"]), 1e-9)
    # ParaView shows the obstacle where it is
    time, mesh = run.snapshots("obstacle.pvd")[-1]
    check("obstacle", mesh.point_data["displacement"][:, 0].mean(),
          float(rows[-1]["obstacle_displacement"]), 1e-7)
    check("its gap", mesh.point_data["gap"].mean(), float(rows[-1]["obstacle_displacement"]), 1e-7)
    if "  mass      hammer of 0.5 kg, velocity -2 m/s\n" not in run.log:
        faults.append("the hammer is not in the log")
for fault in faults[:5]:
    print(fault)
print(f"{run.settings['Title']}:", "as derived" if not faults else f"{len(faults)} faults")
