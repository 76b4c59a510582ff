#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ends a run where its load jumps, and resumes it with a later end time.

usage: check_resume_at_jump.py DIR

DIR holds the run that was made to the later end time at once, in which contact
begins at the jump.
"""
import csv
import json
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
from program import run, settings  # noqa: E402

COLUMNS = ("time", "displacement_end", "contact_force", "energy", "work",
           "numerical_dissipation")


def table(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(row for row in file if row[0] != "#"))


def show(what, directory):
    last = table(directory / "contact.csv")[-1]
    events = [f"{event['kind']} at {float(event['time']):g}, velocity {event['velocity']}"
              for event in table(directory / "events.csv")]
    print(f"{what}:", *(f"{float(last[name]):.9g}" for name in COLUMNS),
          *(events or ["no contact"]))


def contents(directory):
    return [(directory / name).read_bytes()
            for name in ("contact.csv", "events.csv", "steps.csv")]


def stop_and_resume(scene, traction):
    overrides = [f"Boundary/right/Traction={traction}"]
    with tempfile.TemporaryDirectory() as name:
        directory = Path(name) / "run"
        start = [scene, "--quiet", "--output", directory]
        status = [run(*start, *settings([*overrides, "Time/End time=0.75"]))[0]]
        show(f"{traction}, to the jump", directory)
        resume = [*start, "--resume", *settings(overrides)]
        status.append(run(*resume)[0])
        show("from there", directory)
        before = contents(directory)
        status.append(run(*resume)[0])
        print("once more: the same", int(contents(directory) == before), "status",
              *status)


def from_the_start(scene):
    """The load jumps behind t = 0, which a run to T = 0 cannot see."""
    overrides = ["Boundary/right/Traction=if(t > 0, 0.5, 0)"]
    with tempfile.TemporaryDirectory() as name:
        directory = Path(name) / "run"
        options = [scene, "--quiet", "--output", directory, *settings(overrides)]
        status = [run(*options, *settings(["Time/End time=0"]))[0],
                  run(*options, "--resume")[0]]
        show(f"stopped at t = 0, from there: status {status}", directory)


def two_jumps(scene):
    """One at T, another one a rounding error behind it."""
    traction = "Boundary/right/Traction=if(t > 0.75, 0.4, 0.1) + if(t >= 0.75, 0.4, 0)"
    with tempfile.TemporaryDirectory() as name:
        directory = Path(name) / "run"
        status = run(scene, "--quiet", "--output", directory,
                     *settings([traction, "Time/End time=0.75"]))[0]
        show(f"two jumps, to the first one: status {status}", directory)


# jumps at 1/4 and 3/4; what the first one has left to the solver must not change the second
STRIP = ["Dimension=2", "Mesh/Cells=8", "Mesh/Cells across=2", "Mesh/Degree=2", "Output/Period=0.25",
         "Solver/Linear solver=iterative", "Contact/Condition=power law", "Contact/Gap=0.1+y", "Time/Step size=0.125",
         "Time/Break points=0.25; 0.75", "Boundary/right/Traction=0.3*if(t>0.25, 1, 0) + 0.2*if(t>0.75, 1, 0)"]


def in_two_parts(what, scene, overrides):
    """The files of a run that ends half-way and goes on are those of one that does not."""
    results = []
    with tempfile.TemporaryDirectory() as name:
        for ends in ([1], [0.5, 1]):
            directory = Path(name) / f"run-{len(ends)}"
            for i, end in enumerate(ends):
                status = run(scene, "--quiet", "--output", directory, *["--resume"] * (i > 0),
                             *settings([*overrides, f"Time/End time={end}"]))[0]
            summary = json.loads((directory / "summary.json").read_text())
            results.append([summary["linear_iterations"], summary["steps"], *(
                (directory / file).read_bytes() for file in ("contact.csv", "events.csv", "poincare.csv"))])
    print(f"{what} that ends half-way: status {status}, the same {int(results[0] == results[1])}")


reference = Path(sys.argv[1])
show("at once", reference)
for TRACTION in ("if(t <= 0.75, 0.1, 0.5)", "if(t < 0.75, 0.1, 0.5)"):
    stop_and_resume(reference / "used.prm", TRACTION)
from_the_start(reference / "used.prm")
two_jumps(reference / "used.prm")
in_two_parts("a strip", reference / "used.prm", STRIP)
