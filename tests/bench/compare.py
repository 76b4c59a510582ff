#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a step costs beside programs that can do nothing else.

Runs the paper's experiment 1 by thermocontact, by a plain C program (rod.c), by
numpy with SciPy's band solver (rod_scipy.py), and, as far as they are installed, by
FreeFEM (rod_freefem.edp; Debian: freefem++ libfreefem++) and DOLFINx
(rod_dolfinx.py; python3-dolfinx), in turn, so that a machine whose speed drifts
does so for all of them, and writes the tables of doc/performance.md: microseconds
per step or solve, median and range of the runs, and the median of the ratios to
rod.c run by run. All must agree in the last u(1). The load of the machine at the
begin and the end is in the first line.

  compare.py THERMOCONTACT [RUNS] [PAGE]

Not a test: times are not asserted. Takes a minute.
"""
import importlib.util
import json
import os
import platform
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
PRM = HERE.parent.parent / "prm"
# plugins of FreeFEM, where Debian has them; one thread for all
ENVIRONMENT = {"FF_LOADPATH": "/usr/lib/freefem++", **os.environ,
               "OMP_NUM_THREADS": "1"}
BEGIN, END = "<!-- measured -->\n", "<!-- end of what was measured -->\n"


def printed(command):
    """Microseconds per step and u(1) of rod.c and the others that write as it."""
    line = subprocess.run(command, check=True, capture_output=True, text=True,
                          env=ENVIRONMENT).stdout
    found = re.search(r"us_per_step=(\S+) u_end=(\S+)", line)
    return float(found[1]), float(found[2])


def summary(program, directory, scene, per, *overrides):
    """Microseconds of the time loop per step or solve, and u(1)."""
    options = [option for text in ("Output/Fields interval=0", *overrides)
               for option in ("--set", text)]
    subprocess.run([program, scene, "--quiet", "--output", directory, *options],
                   check=True)
    s = json.loads((directory / "summary.json").read_text(encoding="utf-8"))
    return 1e6 * s["loop_seconds"] / s[per], s["final_displacement_end"]


def series(cases, runs):
    """Times of each case, in turn; the first round is not counted."""
    times = {name: [] for name in cases}
    ends = {}
    for run in range(runs + 1):
        for name, measure in cases.items():
            microseconds, ends[name] = measure()
            if run > 0:
                times[name].append(microseconds)
    return times, ends


def table(title, cases, runs, floor, has_same_scheme):
    times, ends = series(cases, runs)
    lines = [f"| {title} | median, µs | range | beside `rod.c` |", "|---|---|---|---|"]
    for name, values in times.items():
        ratio = statistics.median(a / b for a, b in zip(values, times[floor]))
        lines.append(f"| {name} | {statistics.median(values):.3g} | {min(values):.3g} to "
                     f"{max(values):.3g} | {ratio:.2f} |")
    if has_same_scheme:
        reference = ends[floor]
        for name, end in ends.items():
            # rounding of 25 000 cells: a few 1e-9
            if abs(end - reference) > 1e-7 * abs(reference):
                sys.exit(f"{name}: u(1) = {end!r}, rod.c has {reference!r}")
    return "\n".join(lines) + "\n"


def installed():
    """Commands of the finite element programs that are there."""
    commands = {}
    if shutil.which("FreeFem++"):
        commands["FreeFEM"] = ["FreeFem++", "-nw", "-v", "0", HERE / "rod_freefem.edp"]
    if importlib.util.find_spec("dolfinx"):
        commands["DOLFINx"] = [sys.executable, HERE / "rod_dolfinx.py"]
    return commands


def processor():
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def main():
    program = Path(sys.argv[1]).resolve()
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 7
    with tempfile.TemporaryDirectory() as name:
        scratch = Path(name)
        c = scratch / "rod"
        subprocess.run(["cc", "-O2", "-o", c, HERE / "rod.c", "-lm"], check=True)
        (scratch / "default.prm").write_text("# all defaults\n", encoding="utf-8")
        scene = PRM / "paper" / "experiment-1.prm"
        row = scratch / "rows.csv"
        others = {"numpy and SciPy": [sys.executable, HERE / "rod_scipy.py"],
                  **installed()}
        load = os.getloadavg()[0]
        fine = ("Mesh/Cells=25000", "Time/End time=0.2", "Output/Contact interval=1")
        exact = ("Mesh/Cells=4", "Mesh/Degree=6", "Time/Tolerance=5e-6",
                 "Time/Scheme=sdirk4", "Time/Start=automatic", "Time/Step size=automatic")

        def whole(*overrides):
            directory = scratch / "whole"
            microseconds, end = summary(program, directory, scene, "steps", *overrides)
            s = json.loads((directory / "summary.json").read_text(encoding="utf-8"))
            return microseconds * s["steps"], end

        def whole_c():
            microseconds, end = printed([c, "250", "10000", "0.001", row])
            return 1e4 * microseconds, end

        def of_others(*arguments):
            return {name: lambda command=command: printed([*command, *arguments])
                    for name, command in others.items()}

        tables = [
            table("a step, 250 cells, a row for each", {
                "`rod.c`": lambda: printed([c, "250", "10000", "0.001", row]),
                "thermocontact": lambda: summary(program, scratch / "paper", scene, "steps"),
                **of_others("250", "10000", "0.001", row),
            }, runs, "`rod.c`", True),
            table("a step, 25 000 cells, no rows", {
                "`rod.c`": lambda: printed([c, "25000", "200", "0.001", "-"]),
                "thermocontact": lambda: summary(program, scratch / "fine", scene, "steps",
                                                 *fine),
                **of_others("25000", "200", "0.001", "-"),
            }, runs, "`rod.c`", True),
            table("a solve of the default scene, 8 cells of degree 4, all included", {
                "`rod.c`, a step of 250 cells": lambda: printed(
                    [c, "250", "10000", "0.001", row]),
                "thermocontact": lambda: summary(
                    program, scratch / "default", scratch / "default.prm", "solves"),
            }, runs, "`rod.c`, a step of 250 cells", False),
            table("the whole time loop", {
                "`rod.c`, 250 cells, 10 000 steps: u(1) to 2e-3": whole_c,
                "thermocontact, 4 cells of degree 6, tolerance 5e-6: to 1e-6":
                    lambda: whole(*exact),
            }, runs, "`rod.c`, 250 cells, 10 000 steps: u(1) to 2e-3", False),
        ]
    text = (f"{processor()}, {time.strftime('%Y-%m-%d')}, {runs} runs in turn; "
            f"processes that wanted one of the {os.cpu_count()} processors: "
            f"{load:.1f} at the begin, {os.getloadavg()[0]:.1f} at the end.\n\n" +
            "\n".join(tables))
    if len(sys.argv) > 3:
        page = Path(sys.argv[3])
        before, rest = page.read_text(encoding="utf-8").split(BEGIN)
        page.write_text(before + BEGIN + "\n" + text + "\n" + END + rest.split(END)[1],
                        encoding="utf-8")
    else:
        print(text)


main()
