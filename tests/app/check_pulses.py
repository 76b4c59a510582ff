#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_pulses.py DIRECTORY [all]

Loads that are short: seven kinds of pulses, ramps and kinks around t = 0.37 T, T = 5, of
widths w T, w = 1e-1 ... 1e-9, error-controlled. Nobody names where they are; each run is
compared with one whose Time/Break points stand at the corners of the pulse, or in it; so
are two loads of different widths together. At 41 common times the end's displacement, velocity and temperature, and the force, differ by
less than 30 tolerances of their largest values. The height is such that the pulse matters
at any width, since its area is given: left
out it changes one of these by more than 100 tolerances. Seven of the 63 by default, all
of them by the word "all".
"""
import os
import sys
from pathlib import Path

import numpy

sys.dont_write_bytecode = True
from program import for_all, run, settings  # noqa: E402

T, CENTRE, TOLERANCE = 5.0, 1.85, 1e-5
COLUMNS = ("displacement_end", "velocity_end", "temperature_end", "contact_force")
SCENE = [f"Time/End time={T}", "Output/Fields interval=0", f"Output/Contact interval={T / 40}",
         "Output/Land on output times=true", f"Time/Tolerance={TOLERANCE}"]


def box(w):
    return f"if(t>{CENTRE!r},if(t<{CENTRE + w!r},1,0),0)", [CENTRE, CENTRE + w]


def inner_box(w):
    pulse, corners = box(w)
    return f"if(x<0.5,{pulse},0)", corners  # in the half at the fixed end alone


def bell(w):
    return (f"exp(-((t-{CENTRE!r})/{w / 2!r})^2)",
            [CENTRE + w * part for part in (-2, -1, -0.5, 0, 0.5, 1, 2)])


def ramp(w):
    return f"max(0,min(1,(t-{CENTRE!r})/{w!r}))", [CENTRE, CENTRE + w]


def hat(w):
    return (f"max(0,1-abs(t-{CENTRE + w / 2!r})/{w / 2!r})",
            [CENTRE, CENTRE + w / 2, CENTRE + w])


KINDS = {  # entry, expression without the pulse, shape, height
    "traction": ("Boundary/right/Traction", "0", bell, lambda w: 0.2 / w),
    "body force": ("Sources/Body force", "0", hat, lambda w: 0.4 / w),
    "heat source": ("Sources/Heat source", "0", inner_box, lambda w: 20 / w),
    "heat flux": ("Boundary/right/Heat flux", "0", bell, lambda w: 5 / w),
    "end": ("Boundary/left/Displacement", "0", ramp, lambda w: 0.05),
    "gap": ("Contact/Gap", "0.1", ramp, lambda w: -0.05),
    "temperature": ("Boundary/left/Temperature", "10", box, lambda w: 0.5 / w)}


def columns_of(name, overrides):
    status, _, message = run(*settings([*SCENE, *overrides]), "--output", name, "scene.prm")
    if status != 0:
        raise RuntimeError(f"{name}: {message}")
    lines = [line for line in Path(name, "contact.csv").read_text().splitlines()
             if not line.startswith("#")]
    rows = numpy.array([line.split(",") for line in lines[1:]], dtype=float)
    return {column: rows[:, lines[0].split(",").index(column)] for column in COLUMNS}


def difference(a, b):
    """The largest one, in tolerances of the largest value of a column."""
    if any(len(a[column]) != len(b[column]) for column in COLUMNS):
        return numpy.inf
    return max(abs(a[column] - b[column]).max() / max(abs(b[column]).max(), 1e-300)
               for column in COLUMNS) / TOLERANCE


def check(case):
    """case: kinds of pulses and their exponents."""
    loads, rests, points, words = [], [], [], []
    for kind, exponent in case:
        entry, rest, shape, height = KINDS[kind]
        width = T * 10.0**-exponent
        pulse, corners = shape(width)
        loads.append(f"{entry}={rest}+{height(width)!r}*{pulse}")
        rests.append(f"{entry}={rest}")
        points += [repr(t) for t in corners if 0 < t < T]
        words.append(f"{kind}, width 1e-{exponent} T")
    words = " and ".join(words)
    name = "pulse-" + "".join(letter if letter.isalnum() else "-" for letter in words)
    try:
        found = columns_of(name, loads)
        named = columns_of(name + "-named", [*loads, "Time/Break points=" + "; ".join(points)])
        without = [columns_of(name + f"-without-{i}", [*loads[:i], rests[i], *loads[i + 1:]])
                   for i in range(len(case))]
    except RuntimeError as error:
        return [str(error)], 0.0
    error, effect = difference(found, named), min(difference(w, named) for w in without)
    faults = []
    if not error < 30:
        faults.append(f"{words}: {error:.3g} tolerances from a run with break points")
    if not effect > 100:
        faults.append(f"{words}: changes only {effect:.3g} tolerances")
    return faults, error


os.chdir(sys.argv[1])
Path("scene.prm").write_text("# defaults\n", encoding="utf-8")
cases = [[(kind, exponent)] for kind in KINDS for exponent in range(1, 10)]
if "all" not in sys.argv:
    cases = [[(kind, 3 + i)] for i, kind in enumerate(KINDS)]
cases += [[("traction", i), ("heat flux", j)] for i, j in ((2, 4), (4, 2))]
results = for_all(check, cases)
faults = [fault for result, _ in results for fault in result]
worst = max(error for _, error in results)
print(*faults, sep="\n", end="\n" if faults else "")
print(f"{len(cases) - len(faults)} of {len(cases)} pulses seen" if faults else
      "every pulse is seen")
if "all" in sys.argv:
    print(f"{len(cases)} pulses, largest difference {worst:.3g} tolerances")
