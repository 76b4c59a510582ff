#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: error_bars.py PROGRAM PROJECT [SEED]

Error bars against errors: 60 runs with `Output/Error bars`, ten scenes with six
tolerances each and degrees 2 to 8, or with SEED twelve rods drawn at random with five
accuracies each, beside runs with tolerance 1e-10 and degree 12. These are compared with
degree 14, which tells how far they can be trusted, and those of experiment 1 with the
independent code of tests/reference. Minutes.

A bar is the sum of the one in time and the one in space. Of a run the largest error
counts, and the largest bar, each relative to the key result it is of; besides, how often
each key result by itself is within the bounds. Left out are results that have no error
to compare with: the reference is not known to a tenth of it, as the peak force on a rigid
obstacle, which has no limit.
"""
import csv
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "reference"))
import exact_in_time  # noqa: E402

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


def log_uniform(generator, low, high):
    return f"{10 ** generator.uniform(low, high):.4g}"


def draw_scene(generator):
    """Entries of a rod at random"""
    entries = {"Model/Inertia": log_uniform(generator, -1.5, 0.5),
               "Model/Viscosity": log_uniform(generator, -2, 0.3),
               "Contact/Gap": f"{generator.uniform(0.02, 0.2):.3g}",
               "Time/End time": f"{generator.uniform(1, 4):.3g}"}
    if generator.random() < 0.2:
        entries.update({"Model/Fields": "displacement",
                        "Initial values/Velocity": f"{generator.uniform(0.3, 2):.3g}*x"})
    else:
        entries.update({
            "Model/Coupling": log_uniform(generator, -2, -0.5),
            "Boundary/right/Heat exchange": log_uniform(generator, -1, 1),
            "Boundary/left/Temperature": f"{generator.uniform(2, 12):.3g}",
            "Initial values/Velocity": f"{generator.uniform(0, 25):.3g}*x*(x-1)^2"})
    law = generator.random()
    if law < 0.1:
        entries["Contact/Condition"] = "rigid"
    else:
        entries["Contact/Compliance"] = log_uniform(generator, -2.5, 0)
        if law < 0.35:
            entries.update({"Contact/Condition": "power law",
                            "Contact/Exponent": f"{generator.uniform(1.2, 2.5):.3g}"})
    return entries


def random_cases(directory, seed):
    """Name, file, its overrides, and (tolerance, degree) of its runs; 12 scenes of 5"""
    generator = random.Random(seed)
    file = directory / "defaults.prm"
    file.write_text("# defaults\n", encoding="utf-8")
    for number in range(12):
        entries = draw_scene(generator)
        yield (f"scene {number}", file, [f"{key}={value}" for key, value in entries.items()],
               [(log_uniform(generator, -7, -2), generator.randint(2, 8)) for _ in range(5)])


def known_cases(directory, program, project):
    """The same of ten scenes of the project, of 6"""
    (directory / "thrown.prm").write_text(THROWN, encoding="utf-8")
    scenes = [*(project / f"prm/paper/experiment-{i}.prm" for i in range(1, 6)),
              *(project / f"prm/examples/{name}.prm" for name in (
                  "rigid-obstacle", "hertzian-stop", "thermal-switch")),
              project / "prm/units/steel-rod.prm", directory / "thrown.prm"]
    for number, scene in enumerate(scenes):
        yield scene.stem, scene, [], [(tolerance, 2 + (3 * number + 2 * i) % 7)
                                      for i, tolerance in enumerate(TOLERANCES)]


def top(rows, name, power):
    """Largest value of the cubics through values and rates of the steps in contact"""
    largest = max(float(row[name]) for row in rows)
    times, depths, speeds = ([float(row[key]) for row in rows]
                             for key in ("time", "penetration", "velocity_end"))
    values = [float(row[name]) for row in rows]
    for i in range(len(rows) - 1):
        if min(depths[i:i + 2]) > 0 and speeds[i] > 0 > speeds[i + 1]:
            a, b = ((times[i + 1] - times[i]) * power * values[j] / depths[j] * speeds[j]
                    for j in (i, i + 1))
            c = 3 * (values[i + 1] - values[i]) - 2 * a - b
            d = 2 * (values[i] - values[i + 1]) + a + b
            x = a / (math.sqrt(c * c - 3 * a * d) - c)
            largest = max(largest, values[i] + x * (a + x * (c + x * d)))
    return largest


def results(summary, rows, power):
    """Key results, NaN for what there is not; with a power of the law peaks between
    step ends, too"""
    values = {key: math.nan if summary[key] is None else summary[key] for key in KEYS}
    for key, column in PEAKS.items() if power else ():
        if not math.isnan(values[key]):
            values[key] = top(rows, column, power if column == "contact_force" else 1)
    return values


def power_of(scene, overrides):
    """Exponent of the contact law"""
    words = scene.read_text(encoding="utf-8") + "\n".join(overrides)
    found = re.search(r"Exponent *= *(\S+)", words)
    return float(found[1]) if found else 1


def check_reference(values, rows):
    """Against the independent code: u(1) and theta(1) at the end"""
    time = float(rows[-1]["time"])
    exact = exact_in_time.solve(end_time=time).evaluate([time])
    print("independent code, experiment 1:", ", ".join(
        f"{key} differs by {abs(values[key] - exact[name][0]):.1e}"
        for key, name in (("final_displacement_end", "u_end"),
                          ("final_temperature_end", "theta_end"))))


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


def compare_scene(number, case, directory, program):
    """Pairs of each of its runs, which it prints"""
    name, scene, entries, accuracies = case
    power = power_of(scene, entries)
    reference, other = (run(program, scene, directory / "out", *entries,
                            "Time/Tolerance=1e-10", f"Mesh/Degree={degree}")
                        for degree in (12, 14))
    reference_rows = reference[1]
    reference, other = (results(*each, power) for each in (reference, other))
    if number == 0 and not entries:
        check_reference(reference, reference_rows)
    for tolerance, degree in accuracies:
        summary, rows = run(program, scene, directory / "out", *entries,
                            "Output/Error bars=true", f"Time/Tolerance={tolerance}",
                            f"Mesh/Degree={degree}")
        pairs = compare(summary, results(summary, rows, None), reference, other)
        words = f"{name:18} {tolerance:>9} degree {degree}"
        if pairs:
            error, bar = (max(pair[j] for pair in pairs.values()) for j in (0, 1))
            print(f"{words}   error {error:.1e}, bar {bar:.1e}, bars over errors "
                  + " ".join(f"{b / e:.2g}" for e, b in pairs.values()), flush=True)
        else:
            print(words, "  nothing to compare with")
        yield pairs


def main(program, project, seed=None):
    program, project = Path(program).resolve(), Path(project).resolve()
    directory = Path(tempfile.mkdtemp())
    cases = random_cases(directory, int(seed)) if seed else \
        known_cases(directory, program, project)
    runs = [pairs for number, case in enumerate(cases)
            for pairs in compare_scene(number, case, directory, program)]
    by_run = [[max(pair[j] for pair in pairs.values()) for j in (0, 1)]
              for pairs in runs if pairs]
    print(f"{len(by_run)} runs, {len(runs) - len(by_run)} without a result to compare")
    print("largest error <= 3 largest bars:", sum(e <= 3 * b for e, b in by_run),
          "; bar <= 30 errors:", sum(b <= 30 * e for e, b in by_run))
    for key in KEYS:
        group = [pairs[key] for pairs in runs if key in pairs]
        print(f"{key:24} of {len(group)}: error <= 3 bars {sum(e <= 3 * b for e, b in group)}"
              f", bars <= 30 errors {sum(b <= 30 * e for e, b in group)}")


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
