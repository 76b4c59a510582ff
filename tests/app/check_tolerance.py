#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_tolerance.py DIR

Runs the scene of a directory with four tolerances, as three experiments of the paper, and
compares contact.csv with the solution that is exact in time.

The error is the largest of those of u(1), u_t(1), theta(1) and the contact force over
all step ends t >= 0.01, relative to the largest value of each over these times, and lies
between tolerance / 30 and 30 tolerances. With 128 modes in place of 96, u_t(1) within
1e-3 of an impact is exact to 1e-10 of its maximum, too: 192 modes change no ratio by more
than 0.05.
"""
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parents[1] / "reference"))
import exact_in_time  # noqa: E402
from program import for_all, run, settings  # noqa: E402
from run_files import Run  # noqa: E402

EXPERIMENTS = {"1": {}, "2": {"Model/Viscosity": 1}, "5": {"Contact/Compliance": 1}}
TOLERANCES = (1e-3, 1e-5, 1e-7, 1e-9)
COLUMNS = {"displacement_end": "u_end", "velocity_end": "v_end",
           "temperature_end": "theta_end", "contact_force": "force"}
DIRECTORY = Path(sys.argv[1])


def ratio(case):
    """Of the error to the tolerance."""
    number, tolerance, parent = case
    directory = parent / f"{number}-{tolerance:g}"
    entries = EXPERIMENTS[number]
    run("--quiet", "--output", directory, *settings(
        f"{name}={value}" for name, value in (entries | {
            "Time/Tolerance": tolerance}).items()), DIRECTORY / "used.prm")
    result = Run(directory)
    rows = result.contact["time"] >= 0.01
    s = result.settings
    scene = exact_in_time.Parameters(zeta=s.number("Model/Viscosity"),
                                     eps=s.number("Contact/Compliance"),
                                     g=s.number("Contact/Gap"))
    exact = exact_in_time.solve(scene, s.number("Time/End time"), 128).evaluate(
        list(result.contact["time"][rows]))
    return max(abs(result.contact[name][rows] - exact[of]).max() / abs(exact[of]).max()
               for name, of in COLUMNS.items()) / tolerance


with tempfile.TemporaryDirectory() as parent:
    cases = [(number, tolerance, Path(parent)) for number in EXPERIMENTS
             for tolerance in TOLERANCES]
    ratios = for_all(ratio, cases)
for (number, tolerance, _), value in zip(cases, ratios):
    is_good = 1 / 30 < value < 30
    print(f"experiment {number}, {tolerance:g}: error / tolerance",
          "within 1/30 to 30" if is_good else f"{value:.3g}")
