#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the scene of an output directory again on other numbers of ranks.

usage: check_ranks.py DIR

DIR holds a finished run of one rank. A rod on two ranks; a body stopped at half of its end
time and resumed. What the runs of a study take of the memory together; which solver bodies have.
"""
import json
import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy

sys.dont_write_bytecode = True
import program  # noqa: E402
from contents import contents, different  # noqa: E402
from run_files import Run, Settings  # noqa: E402

PROGRAM = os.environ["THERMOCONTACT"]
BOUND = 1e-7
SAID = "on another number of ranks, {} instead of {}"


def run(ranks, directory, *options):
    """Exit status and screen."""
    if ranks == 1:
        return program.run("--output", directory, *options)[:2]
    process = subprocess.run(["mpirun", "--allow-run-as-root", "--oversubscribe", "-n",
                              str(ranks), PROGRAM, "--output", str(directory), *options],
                             capture_output=True, text=True, check=False)
    return process.returncode, process.stdout


def largest_difference(reference, directory):
    """Of all columns of contact.csv, relative to the largest value of each."""
    a, b = Run(reference).contact, Run(directory).contact
    worst = float(a.names != b.names or len(a) != len(b))
    for name in a.names if not worst else ():
        # counts may differ; what a solver leaves is of the size of its tolerance
        if name not in ("iterations", "algebraic"):
            scale = max(1.0, abs(a[name]).max())
            worst = max(worst, numpy.nan_to_num(abs(a[name] - b[name])).max() / scale)
    return worst


def snapshots_differ(reference, directory):
    """Fields and contact faces as sets of points with values, to single precision."""
    runs = Run(reference), Run(directory)
    worst = 0.0
    names = ["fields.pvd", "contact.pvd"]
    if (reference / "obstacle.pvd").exists():
        names.append("obstacle.pvd")
    for index in names:
        tables = []
        for r in runs:
            tables.append([numpy.column_stack([mesh.points] + [
                values.reshape(len(mesh.points), -1) for _, values in
                sorted(mesh.point_data.items())]) for _, mesh in r.snapshots(index)])
        if len(tables[0]) != len(tables[1]) or not tables[0]:
            return float("inf")
        for a, b in zip(*tables):
            scale = abs(a).max(axis=0) + 1e-3  # what is zero has rounding
            for table in (a, b):
                order = numpy.lexsort(numpy.round(table[:, :3], 5).T)
                table[:] = table[order]
            # points that several cells have are told apart by the stress alone: means
            _, of = numpy.unique(numpy.round(a[:, :3], 5), axis=0, return_inverse=True)
            means = [numpy.array([numpy.bincount(of.ravel(), column) / numpy.bincount(of.ravel())
                                  for column in table.T]) for table in (a, b)]
            worst = max(worst, (abs(means[0] - means[1]) / scale[:, None]).max())
    return worst


def check_obstacle(reference):
    """One that moves stands at the times of the fields where its formula says, whose names
    are those of Python; a mass has its displacement besides."""
    run = Run(reference)
    times = [time for time, _ in run.snapshots()]
    formula = Settings(reference / "used.prm")["Contact/Gap"]
    faults = [] if [time for time, _ in run.snapshots("obstacle.pvd")] == times else ["other times"]
    rows = run.contact
    for time, mesh in run.snapshots("obstacle.pvd"):
        moved = rows["obstacle_displacement"][abs(rows["time"] - time).argmin()] \
            if "obstacle_displacement" in rows.names else 0
        gaps = [moved + eval(formula, {"sin": math.sin, "t": time, "y": y}) for y in mesh.points[:, 1]]
        expected = numpy.column_stack([gaps, 0 * mesh.points[:, 1:]])
        worst = max(abs(mesh.point_data["gap"] - gaps).max(),
                    abs(mesh.point_data["displacement"] - expected).max())
        # numbers of single precision
        faults += [f"t = {time}: by {worst}"] if worst > max(2.**-27, 2.**-24 * max(map(abs, gaps))) or len(gaps) < 2 else []
    print("obstacle at the times of the fields:", "; ".join(faults) or "as its formula")


def check_rod(reference, prm):
    directory = Path("two")
    status, screen = run(2, directory, prm)
    print(f"rod on two ranks: status {status}, said",
          f"{int('of 2 one computes' in screen)},", "files that differ:",
          ", ".join(different(contents(reference), directory)) or "none")
    shutil.rmtree(directory)


def check_memory_of_study():
    """Strips of degree 2 with fixed steps, the middle one the largest: 170 MB, 1.5 kB and
    330 n^1.22 bytes of factors each (doc/bodies.md), two of them on two ranks at a time."""
    entries = ("Dimension=2", "Solver/Linear solver=direct", "Mesh/Degree=2",
               "Mesh/Cells across=50", "Time/Step size=0.1", "Mesh/Refinements=0",
               "Study/Vary=Mesh/Cells = 100 | 200 | 4")
    Path("study.prm").write_text("# a study\n", encoding="utf-8")
    nodes = [(2 * n + 1) * 101 for n in (100, 200, 4)]
    expected = sorted(0.17 + (1500 * 3 * n + 330 * (3 * n)**1.22) / 1e9 for n in nodes)
    for ranks in (1, 2):
        _, screen = run(ranks, Path("not-made"), "--check", "study.prm",
                        *(word for entry in entries for word in ("--set", entry)))
        line = next((line for line in screen.splitlines() if "memory" in line), "")
        told = [float(number) for number in re.findall(r"([\d.]+) GB", line)][:-1]
        true = [expected[-1], expected[-1] + expected[-2]][:ranks]
        print(f"memory of a study on {ranks}:", len(told) == ranks and
              "run 1: Mesh/Cells = 200" in line and
              all(abs(a / b - 1) < 0.06 for a, b in zip(told, true)) or line)
    # blocks, with all that grows with the degree; with factors (doc/performance.md)
    for solver, cells, across, p in (("iterative", 4, 2, 16), ("direct", 12, 4, 2)):
        n = 4 * (p * cells + 1) * (p * across + 1)**2
        of_degree = 384 * (p + 1)**3 * ((p + 3)**2 + (p + 1)**2) + 100 * across**2 * p * (p + 1)**4
        true = 0.17 + 1e-9 * (600 * n + of_degree if solver == "iterative" else
                              4000 * n + 92 * n**1.54)
        _, screen = run(1, Path("not-made"), "--check", "study.prm", *program.settings((
            "Dimension=3", f"Mesh/Cells={cells}", f"Mesh/Cells across={across}", f"Mesh/Degree={p}",
            f"Solver/Linear solver={solver}", "Contact/Massless nodes=on", "Time/Step size=0.1")))
        told = float(re.search(r"memory +about ([\d.]+) GB", screen)[1])
        print(f"memory of a block, {solver}:", abs(told / true - 1) < 0.03 or (told, true))
    # a rigid obstacle, and no inertia: factors of an equilibrium beside those of the stages
    for entry in ("Contact/Condition=rigid", "Model/Inertia=0", "Contact/Condition=power law"):
        n = 3 * 201 * 101
        true = 0.17 + 1e-9 * (1500 * n + 330 * n**1.22 * (1 if "law" in entry else 2))
        _, screen = run(1, Path("not-made"), "--check", "study.prm", *program.settings((
            "Dimension=2", "Mesh/Cells=100", "Mesh/Cells across=50", "Mesh/Degree=2",
            "Solver/Linear solver=direct", "Time/Step size=0.1", entry)))
        told = float(re.search(r"memory +about ([\d.]+) GB", screen)[1])
        print(f"memory with {entry}:", abs(told / true - 1) < 0.06 or (told, true))
    seconds = []  # of a block by the iterative solver: a hundred times as many steps
    for end in (1, 100):
        _, screen = run(1, Path("not-made"), "--check", "study.prm", *program.settings((
            "Dimension=3", "Mesh/Cells=20", "Mesh/Cells across=10", "Time/Step size=0.01",
            "Solver/Linear solver=iterative", f"Time/End time={end}")))
        time = re.search(r"processor time: about ([\d:]+)", screen)[1].split(":")
        seconds.append(sum(int(part) * 60**i for i, part in enumerate(reversed(time))))
    print("time of a hundred times as many steps:", 50 < seconds[1] / seconds[0] < 150 or seconds)
    # squares of degree 1: iterations beyond 13000 unknowns, whatever the steps (doc/bodies.md)
    solvers = []
    first = next(n for n in range(999) if 2 * (n + 1)**2 > 13000)
    for step in (0.1, "automatic"):
        solvers += [re.search(r"solver +(\w+)", run(1, Path("not-made"), "--check", "study.prm", *program.settings((
            "Dimension=2", "Mesh/Width=1", "Mesh/Degree=1", "Model/Fields=displacement", f"Mesh/Cells={n}",
            "Mesh/Cells across=0", f"Time/Step size={step}")))[1])[1] for n in (first - 1, first)]
    print("solvers:", *solvers)
    os.remove("study.prm")


def check_memory_of_rest():
    """log.txt of a study and of its rest names the largest of the runs that are made: run 1
    of all, run 0 where the row of that is lost."""
    entries = ("Dimension=2", "Mesh/Cells across=2", "Mesh/Refinements=0", "Time/End time=0.02",
               "Time/Step size=0.01", "Study/Vary=Mesh/Cells = 4 | 8 | 2")
    Path("study.prm").write_text("# a study\n", encoding="utf-8")
    directory = Path("study")
    words = ["study.prm", *(word for entry in entries for word in ("--set", entry))]
    run(1, directory, *words)
    rows = directory / "study.csv"
    rows.write_text("".join(row for row in rows.read_text().splitlines(keepends=True)
                            if not row.startswith("0,")))
    run(1, directory, "--resume", *words)
    _, screen = run(1, directory, "--resume", "--check", *words)
    named = re.findall(r"^  memory .* for (run \d)", (directory / "log.txt").read_text(), re.M)
    print("memory of a study and of its rest:", ", ".join(named) + ";",
          "of a study that is done:", "memory" in screen)
    os.remove("study.prm")
    shutil.rmtree(directory)


def check_resumed(reference, prm, half, first, then):
    """Half of the time on some ranks, which half holds with its status, the rest on others."""
    directory = Path("resumed")
    shutil.copytree(half[0], directory)
    status = [half[1]]
    end, screen = run(then, directory, "--resume", prm)
    status.append(end)
    warnings = json.loads((directory / "summary.json").read_text())["warnings"]
    said = SAID.format(then, first)
    is_said = [said in text for text in (screen, (directory / "log.txt").read_text(),
                                         " ".join(warnings))]
    if first == then:
        files = different(contents(reference), directory) if first == 1 else []
        what = "files that differ: " + (", ".join(files) or "none")
    else:
        what = "agrees to 1e-7" if largest_difference(reference, directory) < BOUND else \
            f"differs by {largest_difference(reference, directory)}"
        worst = snapshots_differ(reference, directory)
        what += ", snapshots to 1e-5" if worst < 1e-5 else f", snapshots by {worst}"
    if first == 1 or first != then:
        print(f"{first} to {then}: status {status}, said {[int(word) for word in is_said]},",
              what)
    if first != then or first == 1:
        shutil.rmtree(directory)
        return
    # two ranks all the way
    status, _ = run(2, Path("whole"), prm)
    print(f"2 to 2 and 2: status {status}, files that differ:",
          ", ".join(different(contents(Path("whole")), directory)) or "none")
    shutil.rmtree(directory)
    shutil.rmtree("whole")


def check_pieces():
    """A piece of a snapshot has 50000 points at most, of cells of three, each cut in two; one
    of space-time.vtu ends with the interval that brings it to 50000 quadrilaterals."""
    directory = Path("pieces")
    Path("rod.prm").write_text("# a rod\n", encoding="utf-8")
    run(1, directory, "rod.prm", *program.settings((
        "Model/Fields=temperature", "Mesh/Cells=17000", "Mesh/Degree=2", "Time/End time=0.03",
        "Time/Scheme=backward euler", "Time/Step size=0.01", "Output/Fields interval=0.03",
        "Output/Space-time interval=0.01")))
    for name in ("fields/fields-00001.vtu", "space-time.vtu"):
        print(f"cells of the pieces of {name}:", *re.findall(
            rb'NumberOfCells="(\d+)"', (directory / name).read_bytes()))
    shutil.rmtree(directory)
    os.remove("rod.prm")


def main():
    reference = Path(sys.argv[1])
    shutil.copy(reference / "used.prm", "scene.prm")
    if json.loads((reference / "summary.json").read_text())["dimension"] == 1:
        check_rod(reference, "scene.prm")
        check_memory_of_study()
        check_memory_of_rest()
        check_pieces()
    else:
        if (reference / "obstacle.pvd").exists():
            check_obstacle(reference)
        pairs = [(2, 1)] if "power law" in Path("scene.prm").read_text() else [(2, 2), (2, 1)]
        pairs += [(1, 1), (1, 3)] if (reference / "obstacle.pvd").exists() else []
        halves = {}
        for ranks in {first for first, _ in pairs}:
            directory = Path(f"half-{ranks}")
            halves[ranks] = directory, run(ranks, directory, "scene.prm",
                                           "--set", "Time/End time=0.1")[0]
        for first, then in pairs:
            check_resumed(reference, "scene.prm", halves[first], first, then)
        for directory, _ in halves.values():
            shutil.rmtree(directory)
    os.remove("scene.prm")


main()
