#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_module.py THERMOCONTACT SOURCE_DIRECTORY

The module for Python. A quasi-static rod at rest has the force and the end of (M3.1):
with the defaults theta_A = 20, theta_obs = 0, k = 1, a = 0.017, the drop is c = 10, the
free expansion G = a (theta_A - c/2), and p = (G - g)/(1 + epsilon). Tables, events,
summary, snapshots and progress of that run; a study and its kept run; two ranks; a
run without checkpoints; the two errors, with the message of the program; units of a rod
in SI units; the same study as a DataFrame; pictures; periods.

The fit: with fixed steps the rod at rest is linear in 1/(1 + epsilon), so that the force F
of a run at epsilon = 0.5 with noise of a standard deviation s is fitted by
F r with r = 1.5/(1 + epsilon): r = sum(data F)/sum(F F), the error of epsilon
s/sqrt(sum(F F)) (1 + epsilon)^2/1.5; from the times when contact is closed.
"""
import math
import os
import sys
import tempfile
import unittest.mock
import warnings
from pathlib import Path

program, source = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
try:
    import matplotlib  # noqa: F401
    import meshio  # noqa: F401
    import numpy
    import pandas  # noqa: F401
    import scipy  # noqa: F401
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)
os.environ |= {"THERMOCONTACT": str(source / "tests/app/program.py"),
               "THERMOCONTACT_PROGRAM": str(program)}
sys.path.insert(0, str(source / "python"))
import thermocontact

n_failed = 0
SCENE = {"Model/Inertia": 0, "Model/Viscosity": 0, "Contact/Gap": 0.1,
         "Contact/Compliance": 0.5, "Initial values/Temperature": "0*x",
         "Boundary/left/Temperature": 20, "Time/End time": 10,
         "Boundary/right/Heat exchange": 1, "Boundary/right/Surroundings": 0,
         "Model/Coupling": 0.017}
DROP = 10.0
FORCE = (0.017 * (20 - DROP / 2) - 0.1) / 1.5


def check(name, good, message=""):
    global n_failed
    n_failed += not good
    print(f"{'passed' if good else 'FAILED'}: {name}  {message}".rstrip())


def raised(kind, function):
    try:
        function()
    except kind as error:
        return error
    return None


def check_run(folder):
    told = []
    run = thermocontact.run({**SCENE, "Output/Fields interval": 5,
                             "Output/Probes": "0.5; 1"}, output=folder / "a run",
                            progress=lambda part, line: told.append(part))
    contact = run.contact
    check("force at rest", math.isclose(contact["contact_force"][-1], FORCE,
                                        rel_tol=1e-6), contact["contact_force"][-1])
    check("temperature at rest", math.isclose(contact["temperature_end"][-1], 20 - DROP,
                                              rel_tol=1e-6))
    check("tables", contact.n_rows == len(contact["time"]) == run.summary["steps"] + 1
          and isinstance(contact["time"], numpy.ndarray) and
          run.events["kind"][0] == "begin" and
          run.summary["first_contact_time"] == run.events["time"][0] and
          run.steps.n_rows == run.summary["steps"] + run.summary["rejected_steps"] and
          run.probes.n_rows == contact.n_rows)
    check("snapshots", [round(time, 3) for time, _ in run.snapshots][0] == 0 and
          run.snapshots[-1][0] == 10 and all(file.exists() for _, file in run.snapshots))
    check("progress", told == sorted(told) and told[-1] == 1, told)
    check("an unknown column", "no column 'force'" in str(
        raised(KeyError, lambda: contact["force"])))
    top = run.fields().point_data["displacement"][:, 0].max()
    check("fields", math.isclose(top, contact["displacement_end"][-1], rel_tol=1e-5))
    check("pandas", list(contact.to_pandas()["time"]) == list(contact["time"]))
    again = thermocontact.read(folder / "a run")
    check("read", numpy.array_equal(again.contact["time"], contact["time"]))
    with open(folder / "a run/contact.csv", "a") as file:
        file.write(",".join(["9"] * len(contact)))  # its last number may go on
    check("a row that is being written", thermocontact.read(folder / "a run").contact.n_rows == contact.n_rows)
    third = thermocontact.run({**SCENE, "Time/End time": 1 / 3})
    end = third.contact["time"][-1]
    check("all digits of an entry", math.isclose(end, 1 / 3, rel_tol=1e-11), end)


def check_row(folder):
    """Two equal rods side by side, b = 1, of which one flies with 1: force 1/2 for the time 1 (d'Alembert)."""
    run = thermocontact.run({
        "Model/Fields": "displacement", "Model/Viscosity": 0, "Bodies/a/Length": 0.5, "Bodies/a/Velocity": 1,
        "Bodies/b/Length": 0.5, "Contact/Condition": "rigid", "Contact/Gap": 0, "Boundary/left/Support": "free",
        "Boundary/right/Support": "free", "Time/End time": 1.5}, output=folder / "row")
    check("contacts", list(run.contacts) == ["a-b"] and run.contacts["a-b"].n_rows == run.contact.n_rows and
          math.isclose(run.contacts["a-b"]["contact_impulse"][-1], 0.5, rel_tol=1e-9))
    check("no contacts", thermocontact.read(folder / "a run").contacts == {})


def check_study(folder):
    study = thermocontact.run({**SCENE, "Time/End time": 5, "Study/Keep files": True,
                               "Study/Vary": "Contact/Compliance = 0.5 | 1"},
                              output=folder / "study")
    table = study.table
    check("study", list(table["Contact/Compliance"]) == [0.5, 1] and
          list(table["status"]) == ["done", "done"] and
          numpy.allclose(table["max_contact_force"] * (1 + table["Contact/Compliance"]),
                         1.5 * FORCE, rtol=1e-5), table["max_contact_force"])
    check("a kept run", study.run(1).summary["max_contact_force"] ==
          table["max_contact_force"][1])
    error = raised(thermocontact.InputError, lambda: thermocontact.run(
        base=folder / "a run/used.prm", output=folder / "a run", resume=True))
    check("nothing to resume", error and "checkpoint" in str(error), error)


def result_and_warnings(function):
    """The result of a function, and its RunWarnings."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = function()
    return result, [str(one.message) for one in caught
                    if one.category is thermocontact.RunWarning]


def check_warnings(folder):
    """A break point behind the end is warned of, one before it is not."""
    text = "Time/Break points = {} is beyond Time/End time = 1 and has no effect"
    scene = {**SCENE, "Time/End time": 1, "Initial values/Temperature": "theta_A", "Contact/Gap": 1}
    run, told = result_and_warnings(lambda: thermocontact.run({**scene, "Time/Break points": 3}))
    check("a warning", told == run.warnings == [text.format(3)], told)
    scene["Study/Vary"] = "Time/Break points = 0.5 | 3 | 4 | 3"
    study, told = result_and_warnings(lambda: thermocontact.run(scene, output=folder / "warned"))
    check("warnings of a study", told == [text.format(3), text.format(4)] and
          study.warnings == {text.format(3): [1, 3], text.format(4): [2]} and
          list(study.table["warnings"]) == [0, 1, 1, 1], study.warnings)
    path = folder / "warned/study.csv"  # of a study that has not ended
    path.write_text("".join(line for line in path.read_text().splitlines(True) if not line.startswith("1,")))
    found = thermocontact.read(folder / "warned").warnings
    check("numbers of runs", found == {text.format(3): [3], text.format(4): [2]}, found)


def check_ranks(folder):
    """A study on two ranks, and what is said there of a scene that cannot be run."""
    scene = {**SCENE, "Time/End time": 1, "Study/Vary": "Contact/Compliance = 0.5 | 1",
             "Study/Keep files": numpy.bool_(False)}
    one = thermocontact.run(scene, output=folder / "one").table
    two = thermocontact.run(scene, output=folder / "two", ranks=2).table
    check("two ranks", numpy.array_equal(one["max_contact_force"],
                                         two["max_contact_force"]))
    messages = [str(raised(thermocontact.InputError, lambda n=n: thermocontact.run(
        {"Contact/Complianse": 1}, ranks=n))) for n in (1, 2)]
    check("the same message", messages[0] == messages[1], messages[1])
    error = raised(thermocontact.ComputationError, lambda: thermocontact.run(
        program="/bin/false", ranks=2))
    check("what mpirun says", "exit" in str(error), error)


def check_errors(folder):
    error = raised(thermocontact.InputError,
                   lambda: thermocontact.run({"Contact/Complianse": 1}))
    check("input error", error and "did you mean Contact/Compliance?" in str(error), error)
    error = raised(thermocontact.InputError, lambda: thermocontact.run({"Contact/Condition": "thermocontact: x"}))
    check("all of a message", str(error).startswith(
        "command line: Contact/Condition = thermocontact: x\n"), error)
    error = raised(thermocontact.InputError, lambda: thermocontact.run({"Mesh/Cells": []}))
    check("no value", error and "[] is no number" in str(error), error)
    error = raised(thermocontact.ComputationError, lambda: thermocontact.run(
        {"Time/Step size": 0.01, "Time/Scheme": "backward euler",
         "Solver/Step solver": "fixed point", "Contact/Compliance": 1e-6},
        output=folder / "failed"))
    check("computation error", error and "did not converge" in str(error) and
          error.run.contact.n_rows > 1, error)
    error = raised(thermocontact.Error, lambda: thermocontact.read(folder / "nothing"))
    check("no results", error and "not an output directory" in str(error), error)


def check_units():
    """A rod in SI units: a column has its unit, an entry may have one."""
    with tempfile.TemporaryDirectory() as scratch:
        contact = thermocontact.run({"Contact/Stiffness": "0.1 GN/m", "Time/End time": "2 h"},
                                    base=source / "prm/units/steel-rod.prm",
                                    output=scratch).contact
        lines = (Path(scratch) / "contact.csv").read_text(encoding="utf-8").splitlines()
    names = next(line for line in lines if not line.startswith("#")).split(",")
    units = next(line for line in lines if "units:" in line).partition("units:")[2]
    check("all units", {name: contact.units.get(name, "") for name in names} == dict(
        zip(names, units.strip().split(","))), units)
    check("units of a table", contact.units["time"] == "h" and "step" not in contact.units
          and contact.units["temperature_end"] == "\u00b0C" and contact.units["energy"] == "J",
          contact.units)
    check("2 h", math.isclose(contact["time"][-1], 2, rel_tol=1e-12), contact["time"][-1])
    check("20 degrees", math.isclose(contact["temperature_end"][0], 20, rel_tol=1e-12))
    check("no units", not thermocontact.run({"Time/End time": 0.01}).contact.units)


def check_frame(folder):
    """A study of two entries that go together: two runs; a base that beats, its periods."""
    with unittest.mock.patch.dict(sys.modules, {"pandas": None}):  # as if it were not installed
        error = raised(thermocontact.Error, lambda: thermocontact.study(
            {"Contact/Compliance": [0.5]}, entries={**SCENE, "Time/End time": 0.1}))
        check("a package to be installed", "apt install python3-pandas" in str(error), error)
    frame = thermocontact.study(
        {("Contact/Compliance", "Contact/Gap"): [(0.5, 0.1), (1, 0.05)]},
        entries={**SCENE, "Time/End time": 5}, processes=1)
    forces = [(0.017 * (20 - DROP / 2) - gap) / (1 + epsilon)
              for epsilon, gap in ((0.5, 0.1), (1, 0.05))]
    check("a study as a frame", frame.shape[0] == 2 and numpy.allclose(
        frame["max_contact_force"], forces, rtol=1e-5), list(frame["max_contact_force"]))
    check("no units of a frame", frame.attrs["units"] == {}, frame.attrs)
    frame = thermocontact.study({"Contact/Gap": ["0.4 mm", "0.5 mm"]},
                                base=source / "prm/units/steel-rod.prm",
                                entries={"Time/End time": "1 h"}, processes=1)
    units = frame.attrs["units"]
    check("units of a frame", list(frame["Contact/Gap"]) == [4e-4, 5e-4] and "dofs" not in units and [
        units.get(name) for name in ("Contact/Gap", "max_contact_force", "first_contact_time",
                                     "final_temperature_end")] == ["m", "N", "h", "°C"], units)


def check_periods(folder):
    run = thermocontact.run({"Time/End time": 1, "Output/Period": 0.25, "Output/Boundaries": True},
                            output=folder / "periods")
    # heat at once, of a fixed temperature, is what the body has and what the obstacle gets
    check("boundaries", numpy.allclose(run.boundaries["time"], run.contact["time"]) and
          run.boundaries["heat_left"][-1] > 0 > run.boundaries["heat_right"][-1], run.boundaries["heat_left"])
    check("periods", numpy.allclose(run.poincare["time"], [0, 0.25, 0.5, 0.75, 1]),
          run.poincare["time"])
    pictures = run.plot("contact", dpi=50)
    check("a picture", [path.name for path in pictures] == ["contact.png"] and
          pictures[0].stat().st_size > 1000, pictures)
    error = raised(thermocontact.Error, lambda: run.plot("contakt"))
    check("no such picture", "contakt" in str(error), error)


def check_fit():
    hidden = {name: None for name in sys.modules if name.partition(".")[0] == "scipy"}
    with unittest.mock.patch.dict(sys.modules, hidden):  # as if it were not installed
        error = raised(thermocontact.Error, lambda: thermocontact.fit(
            {"Contact/Compliance": 1}, {"contact_force": ([0, 1], [0, 1])}))
        check("a package to be installed", "apt install python3-scipy" in str(error), error)
    scene = {**SCENE, "Contact/Gap": -0.1, "Time/End time": 1, "Time/Step size": 0.01,
             "Output/Fields interval": 0}
    contact = thermocontact.run(scene).contact
    times, exact = contact["time"], contact["contact_force"]
    times, exact = times[10:], exact[10:]
    deviation = 0.01 * exact.max()
    data = exact + deviation * numpy.random.default_rng(1).normal(size=len(times))
    ratio = data @ exact / (exact @ exact)
    compliance, slope = 1.5 / ratio - 1, 1.5 / ratio**2
    error = slope * deviation / math.sqrt(exact @ exact)
    chi_square = ((data - ratio * exact)**2).sum() / deviation**2
    found = thermocontact.fit({"Contact/Compliance": 0.6},
                              {"contact_force": (times, data, deviation)}, entries=scene)
    check("a fit", math.isclose(found.values["Contact/Compliance"], compliance,
                                rel_tol=1e-5), found)
    check("its error", math.isclose(found.errors["Contact/Compliance"], error,
                                    rel_tol=1e-3), error)
    check("its chi^2", math.isclose(found.chi_square, chi_square, rel_tol=1e-5) and
          found.degrees_of_freedom == len(times) - 1, chi_square)
    # without deviations the residuals are theirs, of as many numbers but one
    blind = thermocontact.fit({"Contact/Compliance": 0.6}, {"contact_force": (times, data)}, entries=scene)
    check("its error from the residuals", math.isclose(
        blind.errors["Contact/Compliance"], error * math.sqrt(chi_square / (len(times) - 1)), rel_tol=1e-3), blind)
    # d F r/d log(epsilon) = -F r epsilon/(1 + epsilon)
    check("its sensitivities", numpy.allclose(
        found.sensitivities["Contact/Compliance"],
        -exact * ratio * compliance / (1 + compliance), rtol=1e-3))
    error = raised(thermocontact.Error, lambda: thermocontact.fit(
        {"Contact/Compliance": 0}, {"contact_force": (times, data)}))
    check("no guess", "positive first guesses" in str(error), error)
    error = raised(thermocontact.Error, lambda: thermocontact.fit(
        {"Contact/Compliance": "wide"}, {"contact_force": (times, data)}))
    check("no number", "could not convert" in str(error), error)
    error = raised(thermocontact.Error, lambda: thermocontact.fit(
        {"Contact/Compliance": 1}, {"contact_force": (60 * times, data)}, entries=scene))
    check("times behind the end", "the run has 0 to 1" in str(error), error)
    # the force at rest falls with the gap, and the guess is the value
    rod = Path(__file__).resolve().parents[2] / "prm/units/thermal-switch.prm"
    force = thermocontact.run(base=rod).contact
    found = thermocontact.fit({"Contact/Gap": "40 um"}, base=rod, measured={
        "contact_force": (force["time"][-3:], force["contact_force"][-3:])})
    check("a guess with a unit", math.isclose(found.values["Contact/Gap"], 40, rel_tol=1e-6) and
          "residuals of" in str(found), found)


with tempfile.TemporaryDirectory() as scratch:
    check_run(Path(scratch))
    check_row(Path(scratch))
    check_study(Path(scratch))
    check_warnings(Path(scratch))
    check_ranks(Path(scratch))
    check_errors(Path(scratch))
    check_frame(Path(scratch))
    check_periods(Path(scratch))
check_fit()
check_units()
sys.exit(1 if n_failed else 0)
