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

# the entry, and its name there
EXPERIMENTS = {"1": ("Model/Viscosity", "zeta", 0.2), "2": ("Model/Viscosity", "zeta", 1.),
               "5": ("Contact/Compliance", "eps", 1.)}
TOLERANCES = (1e-3, 1e-5, 1e-7, 1e-9)
COLUMNS = {"displacement_end": "u_end", "velocity_end": "v_end",
           "temperature_end": "theta_end", "contact_force": "force"}
DIRECTORY = Path(sys.argv[1])
END_TIME = 10.
EXACT = {number: exact_in_time.solve(exact_in_time.Parameters(**{name: value}), END_TIME, 128)
         for number, (_, name, value) in EXPERIMENTS.items()}


def ratio(case):
    """Of the error to the tolerance."""
    number, tolerance, parent = case
    directory = parent / f"{number}-{tolerance:g}"
    entry, _, value = EXPERIMENTS[number]
    run("--quiet", "--output", directory, *settings(
        [f"{entry}={value}", f"Time/Tolerance={tolerance}", f"Time/End time={END_TIME}"]),
        DIRECTORY / "used.prm")
    result = Run(directory)
    rows = result.contact["time"] >= 0.01
    exact = EXACT[number].evaluate(list(result.contact["time"][rows]))
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
