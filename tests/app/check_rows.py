#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The published rows of bodies by their files: tables of contacts, events, fields, SI units.

hopkinson-bar: rho c A V/2 for 2 L/c at the striker, until its wave is back; the specimen has Z2 =
sqrt(70/210 2700/7850) Z: the first force it passes on is the incident one times 4 Z Z2/(Z + Z2)^2; later forces
approach the incident one, at both faces alike.
horn: the mode of its head; the stress is E u_x of it, whatever the section.
bolt: the preload of its head, at every row; hot-bar: the force of its head, int theta K/int K/E by the integrals over theta there; its end rests, and the screen shows 0.
cradle, drop-weight, bouncing-ball: tests/verification/rows.cc; here impulses and events by name.
rattling-rods: the pressure swings about 1 with growing amplitude, up to where k is cut.
In fields the bodies stand side by side, and nothing is drawn between them.
"""
import csv
import math
import re
import sys
from pathlib import Path

import meshio
import numpy

sys.dont_write_bytecode = True
from run_files import Run  # noqa: E402

directory = Path(sys.argv[1])
run = Run(sys.argv[1])
title = run.settings["Title"]
faults = []


def check(name, found, expected, bound):
    if not abs(found - expected) <= bound:
        faults.append(f"{name} {found}, expected {expected}")


def table(name):
    with open(directory / "contacts" / f"{name}.csv") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {key: numpy.array([float(row[key]) for row in rows]) for key in rows[0]}


with open(directory / "events.csv") as file:
    events = list(csv.DictReader(line for line in file if not line.startswith("#")))
first = {}
for event in events:
    first.setdefault(event["contact"], event)

if title.startswith("Split"):
    c, Z = math.sqrt(2.1e11 / 7850), math.sqrt(2.1e11 * 7850) * 314.159e-6
    incident, duration = Z * 10 / 2, 2e6 * 0.3 / c
    striker, front, back = (table(name) for name in (
        "striker-incident", "incident-specimen", "specimen-transmission"))
    pressed = (striker["time"] > 2) & (striker["time"] < duration - 2)
    check("incident force", abs(striker["contact_force"] / incident - 1)[pressed].max(), 0, 1e-6)
    check("duration", float(events[[e["kind"] for e in events].index("end")]["time"]), duration, 1)  # of steps of 0.4
    check("arrival at the specimen", float(first["incident-specimen"]["time"]), 1e6 / c, 0.5)
    ratio = math.sqrt(70 / 210 * 2700 / 7850)
    arrives = 1e6 / c + 1e4 / c
    soon = (back["time"] > arrives + 0.7) & (back["time"] < arrives + 2.5)
    check("first transmitted", abs(back["contact_force"][soon] / incident - 4 * ratio / (1 + ratio)**2).max(), 0, 1e-2)
    late = (back["time"] > 1e6 / c + 60) & (back["time"] < 1e6 / c + duration - 10)
    check("equilibrium", abs(front["contact_force"] - back["contact_force"])[late].max(), 0, 0.01 * incident)
    check("transmitted", back["contact_force"][late].mean(), incident, 0.01 * incident)
    print("force in", run.summary["units"]["max_contact_force"], end="; ")
elif title.startswith("Newton"):
    for i, name in enumerate(("a-b", "b-c", "c-d")):
        check(f"impulse of {name}", table(name)["contact_impulse"][-1], 0.5, 1e-12)
        check(f"begin of {name}", float(first[name]["time"]), 0.5 * i, 1e-12)
    # a wave passes a rod twice while its contact is closed, and the next contact closes meanwhile
    ended = {event["contact"]: float(event["duration"]) for event in events if event["kind"] == "end"}
    check("contacts that ended", len(ended), 3, 0)
    for name, found in ended.items():
        check(f"duration of {name}", found, 1, 1e-9)
    # a and b rest behind their contact, which is the first; c rests and d flies behind the last
    check("restitution", run.summary["restitution"], 0, 1e-9)
    # b and c have moved by the time 1/2 in which they had velocity 1, the others are where
    # their contacts leave them
    points = meshio.read(sorted(directory.glob("fields/fields-*.vtu"))[-1])
    x, u = points.points[:, 0], points.point_data["displacement"].reshape(len(points.points), -1)[:, 0]
    check("length of all", x.max(), 2, 1e-6)
    check("last one", u[x > 1.5 + 1e-6].max(), 1.5, 1e-9)
    print(f"{len(points.cells_dict['line'])} lines of {4 * 160}", end="; ")
elif title.startswith("Drop"):
    check("impulse", run.summary["contact_impulse"], 1.687620, 1e-5)
    check("duration", run.summary["contact_duration"], 3 + math.exp(-2) / 2, 1e-5)
    check("peak", run.summary["max_contact_force"], 2 + math.exp(-2), 0.01)
elif title.startswith("Ultrasonic"):
    k, beta = math.pi / 0.13, math.log(3) / 0.13
    omega = math.sqrt(114e9 / 4430 * (k**2 + beta**2))
    with open(directory / "probes.csv") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    swing = numpy.array([math.cos(omega * 1e-6 * float(row["time"])) for row in rows])
    for i, x in enumerate((0, 0.065, 0.13)):
        u, slope = (1e-6 * math.exp(beta * x) * value for value in (
            math.cos(k * x) - beta / k * math.sin(k * x), -(beta**2 / k + k) * math.sin(k * x)))
        for name, size, scale in (("displacement", u, 3e-6), ("stress", 114e9 * slope, 5.4e6)):
            found = numpy.array([float(row[f"{name}_{i + 1}"]) for row in rows])
            check(f"{name} at {x} m", abs(found - size * swing).max() / scale, 0, 0.005)
elif title == "Hot bar":
    kappa, gamma, hot = 6e-4, 4e-4, 300
    heat = hot**2 / 2 - kappa * hot**3 / 3
    soft = kappa / gamma * hot + (kappa / gamma - 1) * math.log(1 - gamma * hot) / gamma
    last = table("bar-obstacle")
    check("force", last["contact_force"][-1] / (21e6 * 12e-6 * heat / soft), 1, 1e-6)
    stress = meshio.read(sorted(directory.glob("fields/fields-*.vtu"))[-1]).point_data["stress"]
    # its ends rest, but for rounding, which the screen does not show
    lines = re.findall(r"u\(right end\) = ([^,g]*?),? +(?:gap = (.*?) +f|theta)", run.log)
    wrong = [line for line in lines if set(line) - {"0 m", ""}]
    if len(lines) < 8 or wrong:
        faults.append(f"screen {lines}")
    check("stress", abs(1e-4 * stress / last["contact_force"][-1] + 1).max(), 0, 1e-5)  # the same everywhere
elif title.startswith("Bolt"):
    plates = table("upper-lower")
    lost = 12e-6 * 0.04 * 100 / (1 / 304.5e6 + 1 / 2100e6) * (1 - numpy.exp(-plates["time"] / 10))
    check("preload", abs(plates["contact_force"] - 20e3 + lost).max(), 0, 1e-6)
elif title.startswith("Bouncing"):
    check("bounces", float(first["ball-obstacle"]["velocity"]), 2, 1e-12)
    check("restitution", run.summary["restitution"], 0, 1e-3)
    last = [event for event in events if event["kind"] == "begin"][-1]
    check("rest", float(last["time"]), 3, 1e-9)
    check("table", table("ball-obstacle")["gap"].min(), 0, 1e-15)
else:
    pressure = table("slow-fast")["contact_force"]
    time = table("slow-fast")["time"]
    early = abs(pressure - 1)[(time > 1) & (time < 6)].max()
    late = abs(pressure - 1)[time > 20].max()
    print("grows" if late > 20 * early else f"from {early} to {late}", end="; ")
print("; ".join(faults) or "as the closed form")
