#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: elastic_events.py PROGRAM [DEGREES [TOLERANCES [CELLS]]]

Times of impacts against d'Alembert's. An elastic rod (zeta = 0, no heat) that starts
with 20 x (x - 1)^2 strikes a rigid obstacle: 8 cells of degrees 8 to 24, five gaps,
tolerances 1e-4 to 1e-9, to T = 3.3. The exact times are the begin t_1, the end 1 and the
begin t_2 of contacts.

Each run is compared with d'Alembert's solution and with the run of the same mesh that has
a tenth of the smallest tolerance, so that what time steps do is told apart from what the
mesh does. Two tables: the first begin, and all three, by the event of the run that is
nearest and of the same kind; the largest error of the gaps in units of the tolerance, that
of the same mesh behind the stroke. Then how many runs warn of their mesh. 20 minutes.
"""
import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path

GAPS = ("0.05", "0.0837", "0.1137", "0.15", "0.2")
NAMES = ("first begin", "first end", "second begin")


def inverse(function, value):
    """Where a function that rises from 0 to 1 has a value."""
    low, high = 0., 1.
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if function(middle) < value else (low, middle)
    return low


def exact_times(gap):
    """Begin, end and begin of contact."""
    first = inverse(lambda t: 20 * t**3 * (1 / 3 - t / 4), gap)
    second = inverse(lambda s: 20 * s**2 * (0.5 - 2 * s / 3 + s**2 / 4), 2 * gap)
    return first, 1., 3 + second


def run(program, directory, cells, degree, gap, tolerance):
    """Its begins, its ends, whether it warns of its mesh."""
    entries = ("Model/Fields=displacement", "Model/Viscosity=0", "Contact/Condition=rigid",
               f"Contact/Gap={gap}", f"Mesh/Cells={cells}", f"Mesh/Degree={degree}",
               f"Time/Tolerance={tolerance}", "Time/End time=3.3", "Output/Fields interval=0")
    scene = directory / "scene.prm"
    scene.write_text("# all entries by --set\n", encoding="utf-8")
    done = subprocess.run(
        [program, scene, "--quiet", "--output", directory / "out",
         *(word for entry in entries for word in ("--set", entry))],
        check=False, capture_output=True, text=True,
        env={**os.environ, "OMPI_MCA_btl": "self"})
    if done.returncode:
        sys.exit(f"degree {degree}, gap {gap}, tolerance {tolerance}: {done.stderr}")
    with open(directory / "out" / "events.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(row for row in file if row[0] != "#"))
    log = (directory / "out" / "log.txt").read_text(encoding="utf-8")
    return ([float(row["time"]) for row in rows if row["kind"] == "begin"],
            [float(row["time"]) for row in rows if row["kind"] == "end"],
            "the mesh leaves out" in log)


def errors(found, times):
    """Of the three events, by the nearest of the same kind."""
    begins, ends, _ = found
    return [min((abs(t - time) for t in of_kind), default=float("inf"))
            for time, of_kind in zip(times, (begins, ends, begins))]


def nearest(found, times):
    """The events of a run that stand for the three."""
    begins, ends, _ = found
    return [min(of_kind, key=lambda t, time=time: abs(t - time), default=float("inf"))
            for time, of_kind in zip(times, (begins, ends, begins))]


def main():
    program = Path(sys.argv[1]).resolve()
    degrees = sys.argv[2].split() if len(sys.argv) > 2 else "8 12 16 20 24".split()
    tolerances = (sys.argv[3] if len(sys.argv) > 3 else
                  "1e-4 1e-5 1e-6 1e-7 1e-8 1e-9").split()
    cells = sys.argv[4] if len(sys.argv) > 4 else "8"
    lines = {name: [f"| {name} | " + " | ".join(tolerances) + " |",
                    "|---|" + "---|" * len(tolerances)] for name in NAMES}
    warned = n_runs = 0
    with tempfile.TemporaryDirectory() as name:
        directory = Path(name)
        for degree in degrees:
            of_exact = {(event, tolerance): 0. for event in NAMES for tolerance in tolerances}
            of_mesh = dict(of_exact)
            for gap in GAPS:
                times = exact_times(float(gap))
                best = nearest(run(program, directory, cells, degree, gap,
                                   float(tolerances[-1]) / 10), times)
                for tolerance in tolerances:
                    found = run(program, directory, cells, degree, gap, tolerance)
                    warned += found[2]
                    n_runs += 1
                    for event, a, b in zip(NAMES, errors(found, times), errors(found, best)):
                        key = event, tolerance
                        of_exact[key] = max(of_exact[key], a / float(tolerance))
                        of_mesh[key] = max(of_mesh[key], b / float(tolerance))
            for event in NAMES:
                row = " | ".join(f"{of_exact[event, t]:.2g} / {of_mesh[event, t]:.2g}"
                                 for t in tolerances)
                lines[event].append(f"| degree {degree} | {row} |")
                print(event, lines[event][-1], flush=True)
    for table in lines.values():
        print("\n".join(table), end="\n\n")
    print(f"{n_runs} runs, {warned} with a warning of the mesh")


if __name__ == "__main__":
    main()
