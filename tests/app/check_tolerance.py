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

What accuracy costs: experiment 1 on 4 cells of degree 5, 42 unknowns with the fixed end, in
solves of stages. Tolerance 4e-6: u(1) and the times of contact to 1e-6; measured 9.7e-7, of
which nearly all is space, 6.8e-7, 1555 solves. Tolerance 1.5e-2: not worse than the paper's
scheme with h = 1/250, dt = 0.001, which takes 10000 solves and errs by 2.0e-3 in u(1) and
6.1e-2 in the force; measured 2.3e-4, 9.7e-3, 295 solves.
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
# tolerance, bounds of errors and of solves
COSTS = ((4e-6, {"displacement_end": 1e-6, "times of contact": 1e-6}, 1800),
         (1.5e-2, {"displacement_end": 2e-3, "contact_force": 6e-2}, 400))
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


def errors(tolerance, bounds, most, directory):
    """What is too large of a run on few cells."""
    run("--quiet", "--output", directory, *settings((
        f"Time/Tolerance={tolerance}", "Mesh/Cells=4", "Mesh/Degree=5", "Mesh/Grading=1")),
        DIRECTORY / "used.prm")
    result, solution = Run(directory), EXACT["1"]
    exact = solution.evaluate(list(result.contact["time"]))
    found = {name: abs(result.contact[name] - exact[of]).max()
             for name, of in COLUMNS.items()}
    found["times of contact"] = max(abs(result.events["time"] - [
        time for time, *_ in solution.events]))
    too_large = {name: found[name] for name, bound in bounds.items() if found[name] > bound}
    return too_large | ({"solves": result.summary["solves"]}
                        if result.summary["solves"] > most else {})


with tempfile.TemporaryDirectory() as parent:
    for tolerance, bounds, most in COSTS:
        print(f"tolerance {tolerance:g} on few cells, too large:", errors(
            tolerance, bounds, most, Path(parent, f"few-{tolerance:g}")) or "nothing")
    cases = [(number, tolerance, Path(parent)) for number in EXPERIMENTS
             for tolerance in TOLERANCES]
    ratios = for_all(ratio, cases)
for (number, tolerance, _), value in zip(cases, ratios):
    is_good = 1 / 30 < value < 30
    print(f"experiment {number}, {tolerance:g}: error / tolerance",
          "within 1/30 to 30" if is_good else f"{value:.3g}")
