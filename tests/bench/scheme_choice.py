#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: scheme_choice.py PROGRAM [-v]

Work and precision of `Time/Scheme = automatic`, with automatic cells and degree, beside
its two schemes, `sdirk4` and `box`, on rods from viscous to elastic that meet soft and hard
stops. The error is that of the peak force; the work is the number of solves times the
unknowns, of `box` twice that, as one of its steps takes twice the processor time of a stage
of as many unknowns (110 and 50 ns for each, with viscosity and without). Of a scheme the
cheapest of several meshes and tolerances counts that is at least as accurate, and whose
refinements are: a run on a coarse mesh may be right by luck. Printed are, for each scene and tolerance, what automatic takes, its error and work,
and its work over that of either scheme; at the end the largest ratio to the better one; with
-v all runs. Minutes.

The truth is that of the scheme whose two finest runs, graded towards the obstacle for
`sdirk4`, differ less; where an error is not ten times that difference nothing is compared.
"""
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

VISCOSITIES = ("1", "0.1", "0.03", "0.01", "0.001", "0.0001", "0")
COMPLIANCES = ("0.05", "0.005")
CHOICES = "Time/Tolerance = 1e-3 | 1e-4 | 1e-5 | 1e-6"
BOX = 2  # processor time of a solve over that of a stage
OTHERS = {
    "sdirk4": f"Mesh/Cells = 8 | 16 | 32 | 64 ; Mesh/Degree = 4 | 8 ; {CHOICES}",
    "box": "Mesh/Cells = 40 | 64 | 100 | 160 | 256 | 400 | 640 | 1000 | 1600"}
FINEST = {"sdirk4": ("Mesh/Cells = 48 | 64", "Mesh/Degree=10", "Mesh/Grading=5",
                     "Time/Tolerance=1e-8"),
          "box": ("Mesh/Cells = 3200 | 6400",)}


def study(program, directory, scene, vary, *overrides):
    """Peak, work and words of each run that is done"""
    options = [word for entry in (*scene, *overrides, f"Study/Vary={vary}")
               for word in ("--set", entry)]
    subprocess.run([program, "--quiet", "--output", directory / "out", *options,
                    directory / "empty.prm"], capture_output=True, check=False)
    with open(directory / "out" / "study.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(row for row in file if row[0] != "#"))
    names = [part.split("=")[0].strip() for part in vary.split(";")]
    return [(float(row["max_contact_force"]), float(row["solves"]) * float(row["dofs"]),
             " ".join(row[name] for name in names), int(row["dofs"]))
            for row in rows if row["status"] == "done"]


def truth_of(program, directory, scene):
    """Peak, how far it may be wrong, and the scheme"""
    found = []
    for scheme, (vary, *overrides) in FINEST.items():
        runs = study(program, directory, scene, vary, f"Time/Scheme={scheme}", *overrides)
        if len(runs) == 2:
            found.append((abs(runs[1][0] - runs[0][0]), runs[1][0], scheme))
    doubt, truth, scheme = min(found)
    return truth, doubt, scheme


def refines(words, other):
    """Whether a run has the degree of another, as many cells and as small a tolerance"""
    cells, *rest = map(float, words.split())
    other_cells, *other_rest = map(float, other.split())
    return cells >= other_cells and rest[:1] == other_rest[:1] and rest[1:] <= other_rest[1:]


def cheapest(runs, truth, error):
    """Work of the cheapest run that is as accurate with all that refine it, NaN: there is none"""
    wrong = [words for peak, _, words, _ in runs if abs(peak - truth) > error]
    return min((work for _, work, words, _ in runs
                if not any(refines(other, words) for other in wrong)), default=math.nan)


def compare(program, directory, compliance, viscosity, is_verbose):
    """Ratios to the better scheme that are known"""
    scene = ("Model/Fields=displacement", f"Model/Viscosity={viscosity}",
             "Initial values/Velocity=x", "Contact/Gap=0.05", "Time/End time=3",
             f"Contact/Compliance={compliance}")
    truth, doubt, best = truth_of(program, directory, scene)
    print(f"compliance {compliance}, viscosity {viscosity}: peak {truth:.8g} "
          f"({doubt / truth:.1g}, {best})", flush=True)
    others = {name: study(program, directory, scene, vary, f"Time/Scheme={name}")
              for name, vary in OTHERS.items()}
    others["box"] = [(peak, BOX * work, *rest) for peak, work, *rest in others["box"]]
    for name, runs in others.items() if is_verbose else ():
        for peak, work, words, *_ in runs:
            print(f"    {name} {words}: {abs(peak / truth - 1):.1e}, {work:.2g}")
    ratios = []
    for peak, work, words, dofs in study(program, directory, scene, CHOICES):
        # box has one unknown a cell, and solves once a step of a cell
        is_box = work == 3 * (dofs - 1) * dofs
        work *= BOX if is_box else 1
        error = abs(peak - truth)
        all_of = {name: work / cheapest(runs, truth, error) for name, runs in others.items()}
        is_known = error > 10 * doubt
        if is_known:
            ratios.append(max((r for r in all_of.values() if not math.isnan(r)), default=0))
        print(f"  {words}: {'box' if is_box else 'sdirk4'}, {dofs} unknowns, error "
              f"{error / truth:.1e}, work {work:.2g}: " +
              ", ".join(f"{r:.2g} of {name}" for name, r in all_of.items()) +
              ("" if is_known else ", not to be compared"), flush=True)
    return ratios


def main():
    program = Path(sys.argv[1]).resolve()
    ratios = []
    with tempfile.TemporaryDirectory() as name:
        directory = Path(name)
        (directory / "empty.prm").write_text("# defaults\n", encoding="utf-8")
        for compliance in COMPLIANCES:
            for viscosity in VISCOSITIES:
                ratios += compare(program, directory, compliance, viscosity, "-v" in sys.argv)
    print(f"{len(ratios)} runs compared, {sum(r <= 2 for r in ratios)} with at most twice the work "
          f"of the better scheme, at most {max(ratios):.2g} times")


if __name__ == "__main__":
    main()
