#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: error_bars.py PROGRAM PROJECT

Error bars against errors: 60 runs with `Output/Error bars`, ten scenes with six
tolerances each and degrees 2 to 8, beside runs with tolerance 1e-10 and degree 12. These
are compared with degree 14, which tells how far they can be trusted, and those of
experiment 1 with the independent code of tests/reference. A minute or two.

A bar is the sum of the one in time and the one in space. Of a run the largest error
counts, and the largest bar, each relative to the key result it is of; besides, how often
each key result by itself is within the bounds. Left out are results that have no error
to compare with: the reference is not known to a tenth of it, as the peak force on a rigid
obstacle, which has no limit.
"""
import csv
import itertools
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

KEYS = ("first_contact_time", "max_contact_force", "max_penetration", "contact_impulse",
        "final_displacement_end", "final_temperature_end")
PEAKS = {"max_contact_force": "contact_force", "max_penetration": "penetration"}
STEPS = ("Time/Scheme=sdirk4", "Time/Start=automatic", "Time/Step size=automatic",
         "Mesh/Cells=8", "Mesh/Refinements=0", "Mesh/Grading=1",
         "Output/Fields interval=0")
TOLERANCES = ("1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7")
THROWN = """
subsection Model
  set Fields    = displacement
  set Inertia   = 8.90143681834e-18
  set Viscosity = 3.67413902446e-13
end
subsection Contact
  set Compliance = 0.21
  set Gap        = 0.0005
end
subsection Initial values
  set Velocity = 10/1.54313839027e-05*x   # 10 m/s at the end
end
subsection Time
  set End time = 2e-8
end
"""


def run(program, scene, directory, *overrides):
    """Its summary and contact.csv"""
    options = [word for entry in STEPS + overrides for word in ("--set", entry)]
    subprocess.run([program, "--quiet", "--output", directory, *options, scene], check=True,
                   env={**os.environ, "OMPI_MCA_btl": "self"})
    with open(directory / "contact.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(row for row in file if row[0] != "#"))
    return json.loads((directory / "summary.json").read_text()), rows


def peak(rows, name):
    """Vertex of the parabola through the largest value and its neighbours"""
    t, f = ([float(row[key]) for row in rows] for key in ("time", name))
    i = f.index(max(f))
    if not 0 < i < len(f) - 1:
        return f[i]
    rise, fall = ((f[j + 1] - f[j]) / (t[j + 1] - t[j]) for j in (i - 1, i))
    curvature = (fall - rise) / (t[i + 1] - t[i - 1])
    if not curvature < 0:
        return f[i]
    return f[i] - (rise + curvature * (t[i] - t[i - 1])) ** 2 / (4 * curvature)


def results(summary, rows, is_smooth):
    """Key results, NaN for what there is not; smooth: peaks between step ends, too"""
    values = {key: math.nan if summary[key] is None else summary[key] for key in KEYS}
    if is_smooth:
        for key, column in PEAKS.items():
            if not math.isnan(values[key]):
                values[key] = peak(rows, column)
    return values


def check_reference(values, rows, project):
    """Against the independent code: u(1) and theta(1) at the end, the peak force"""
    with open(project / "tests/reference/experiment-1-exact-every-0.001.csv",
              encoding="utf-8") as file:
        exact = list(csv.DictReader(row for row in file if row[0] != "#"))
    names = list(exact[0])
    print("independent code, experiment 1:", ", ".join(
        f"{key} differs by {abs(values[key] - float(exact[-1][name])):.1e}"
        for key, name in (("final_displacement_end", "u_end"),
                          ("final_temperature_end", "theta_end")) if name in names),
          f"from t = {exact[-1]['t']} to t = {rows[-1]['time']}")


def compare(summary, values, reference, other):
    """Pairs of error and bar, by key result"""
    pairs = {}
    for key in KEYS:
        exact = reference[key]
        error = abs(values[key] - exact)
        bars = [summary[f"{key}_{kind}_error"] for kind in ("time", "space")]
        if math.isnan(error) or exact == 0 or None in bars:
            continue
        trusted = max(10 * abs(other[key] - exact), 1e-11 * abs(exact))
        if error > trusted:
            pairs[key] = (error / abs(exact), sum(bars) / abs(exact))
    return pairs


def main(program, project):
    program, project = Path(program).resolve(), Path(project).resolve()
    directory = Path(tempfile.mkdtemp())
    (directory / "thrown.prm").write_text(THROWN, encoding="utf-8")
    steel = subprocess.run([program, "--units", project / "prm/units/steel-rod.prm"],
                           check=True, capture_output=True, text=True).stdout
    (directory / "steel.prm").write_text(steel, encoding="utf-8")
    scenes = [*(project / f"prm/paper/experiment-{i}.prm" for i in range(1, 6)),
              *(project / f"prm/examples/{name}.prm" for name in (
                  "rigid-obstacle", "hertzian-stop", "thermal-switch")),
              directory / "steel.prm", directory / "thrown.prm"]
    all_pairs, by_run, missed = [], [], 0
    for number, scene in enumerate(scenes):
        reference, other = (
            results(*run(program, scene, directory / "out", "Time/Tolerance=1e-10",
                         f"Mesh/Degree={degree}"), True) for degree in (12, 14))
        if number == 0:
            check_reference(reference, run(program, scene, directory / "out",
                                           "Time/Tolerance=1e-10", "Mesh/Degree=12")[1],
                            project)
        for i, tolerance in enumerate(TOLERANCES):
            degree = 2 + (3 * number + 2 * i) % 7
            summary, rows = run(program, scene, directory / "out", "Output/Error bars=true",
                                f"Time/Tolerance={tolerance}", f"Mesh/Degree={degree}")
            pairs = compare(summary, results(summary, rows, False), reference, other)
            name = f"{scene.stem:18} {tolerance} degree {degree}"
            if not pairs:
                missed += 1
                print(name, "  nothing to compare with")
                continue
            error, bar = (max(pair[j] for pair in pairs.values()) for j in (0, 1))
            by_run.append((error, bar))
            all_pairs += [(key, *pair) for key, pair in pairs.items()]
            print(f"{name}   error {error:.1e}, bar {bar:.1e}, bars over errors "
                  + " ".join(f"{b / e:.2g}" for e, b in pairs.values()))
    count = len(by_run)
    print(f"{count} runs, {missed} without a result to compare")
    print("largest error <= 3 largest bars:", sum(e <= 3 * b for e, b in by_run),
          "; bar <= 30 errors:", sum(b <= 30 * e for e, b in by_run))
    for key, group in itertools.groupby(sorted(all_pairs), lambda pair: pair[0]):
        group = list(group)
        print(f"{key:24} of {len(group)}: error <= 3 bars {sum(e <= 3 * b for _, e, b in group)}"
              f", bars <= 30 errors {sum(b <= 30 * e for _, e, b in group)}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
