#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error bars against repeats that are made one by one, and against errors."""
import csv
import json
import math
import re
import shutil
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from program import for_all, run, settings  # noqa: E402

SCENE = Path(__file__).with_name("error_bars.prm")
KEYS = ("first_contact_time", "max_contact_force", "max_penetration", "contact_impulse",
        "final_displacement_end", "final_temperature_end", "contact_duration", "restitution")
PEAKS = {"max_contact_force": "contact_force", "max_penetration": "penetration"}
MOTION = ("Model/Fields=displacement", "Model/Viscosity=0", "Contact/Condition=rigid",
          "Initial values/Velocity=x", "Time/Scheme=energy conserving")

# what holds steps below what a tolerance asks for, by its factor in the repeats
LIMITS = {n: (f"Time/First step size={n * 1e-4}", "Output/Land on output times=true",
              f"Output/Fields interval={n * 0.06}", f"Output/Space-time interval={n * 0.07}")
          for n in (1, 2, 4)}

# overrides; repeats in time with their weights by (D9.3), in space from fine to coarse,
# and the rate that is trusted at most, (D9.4)
CASES = [
    (("Time/Tolerance=1e-4", "Mesh/Degree=5", *LIMITS[1]),
     [(("Time/Tolerance=1e-3", *LIMITS[2]), 0.5), (("Time/Tolerance=1e-2", *LIMITS[4]), 0.05)],
     [("Mesh/Degree=4",), ("Mesh/Degree=3",)], 0.03),
    # a hundred times the tolerance is not allowed
    (("Time/Tolerance=2e-3", "Mesh/Degree=3", "Contact/Condition=power law",
      "Contact/Exponent=1.5"),
     [(("Time/Tolerance=2e-4",), 1.5), (("Time/Tolerance=0.02",), 0.5)],
     [("Mesh/Cells=4",), ("Mesh/Cells=2",)], 1 / 16),
    # nor is ten times
    (("Time/Tolerance=0.02", "Mesh/Degree=1", "Mesh/Cells=3", "Mesh/Refinements=1"),
     [(("Time/Tolerance=2e-3",), 1.5)],
     [("Mesh/Refinements=0",), ("Mesh/Refinements=0", "Mesh/Cells=2")], 1 / 4),
    (("Time/Scheme=backward euler", "Time/Step size=0.01", "Mesh/Degree=2", "Mesh/Cells=10"),
     [(("Time/Step size=0.02",), 1), (("Time/Step size=0.04",), 1 / 3)],
     [("Mesh/Cells=5",), ("Mesh/Cells=3",)], 1 / 8),
    # fewer than eight steps
    (("Time/Scheme=backward euler", "Time/Step size=0.15", "Mesh/Degree=2"),
     [(("Time/Step size=0.075",), 2)], [("Mesh/Cells=4",), ("Mesh/Cells=2",)], 1 / 8),
    (("Dimension=2", "Mesh/Cells=4", "Mesh/Cells across=2", "Mesh/Degree=1",
      "Time/Step size=0.02", "Time/Scheme=sdirk2"),
     [(("Time/Step size=0.04",), 1), (("Time/Step size=0.08",), 1 / 3)],
     [("Mesh/Cells=2", "Mesh/Cells across=1"), ("Mesh/Cells=1", "Mesh/Cells across=1")],
     1 / 2),
    # steps and cells together; the automatic step is the passage of a cell
    (MOTION + ("Time/Scheme=box", "Mesh/Cells=40"), [], [("Mesh/Cells=20",), ("Mesh/Cells=10",)],
     None),
    (("Model/Fields=displacement", "Model/Viscosity=0", "Initial values/Velocity=x",
      "Mesh/Cells=44", "Contact/Compliance=0.3", "Time/Scheme=box"), [],
     [("Mesh/Cells=22",), ("Mesh/Cells=11",)], None),
    # a hard obstacle, and waves that each mesh has exactly
    (("Model/Fields=displacement", "Model/Viscosity=0", "Initial values/Velocity=if(x>0.5,1,0)",
      "Mesh/Cells=40", "Contact/Compliance=1e-3", "Time/Scheme=box"), [],
     [("Mesh/Cells=20",), ("Mesh/Cells=10",)], None),
    # pressed on the obstacle from rest, where the velocity of the first contact is that of a
    # step: errors of restitutions that are longer than their range
    (("Model/Fields=displacement", "Model/Viscosity=0", "Initial values/Velocity=0", "Contact/Gap=0",
      "Boundary/right/Traction=sin(8*t)", "Contact/Condition=rigid", "Mesh/Cells=24",
      "Time/Scheme=box"), [], [("Mesh/Cells=12",), ("Mesh/Cells=6",)], None),
    # the rate of the penetration is the velocity relative to the obstacle
    (("Time/Tolerance=1e-3", "Mesh/Degree=5", "Contact/Gap=0.1+0.3*t"),
     [(("Time/Tolerance=1e-2",), 0.5), (("Time/Tolerance=0.1",), 0.05)],
     [("Mesh/Degree=4",), ("Mesh/Degree=3",)], 0.03),
    (("Time/Tolerance=1e-3", "Mesh/Degree=5", "Contact/Condition=rigid"),
     [(("Time/Tolerance=1e-2",), 0.5), (("Time/Tolerance=0.1",), 0.05)],
     [("Mesh/Degree=4",), ("Mesh/Degree=3",)], 0.03),
    # contact nodes without mass
    (("Time/Tolerance=1e-3", "Mesh/Degree=5", "Contact/Compliance=1e-8"),
     [(("Time/Tolerance=1e-2",), 0.5), (("Time/Tolerance=0.1",), 0.05)],
     [("Mesh/Cells=4",), ("Mesh/Cells=2",)], 1 / 2),
]

# What happens before the first contact does not depend on the obstacle: experiment 1 by the
# independent code of tests/reference. Of obstacles so hard that contact nodes have no mass
# before them, too, which moves it by 1e-4 to 1e-6.
FIRST_CONTACT = 0.1849692017564
HARD = [(1e-5, 16, 4)] + [(1e-8, cells, degree) for cells in (8, 12) for degree in range(3, 9)]


def results(number, overrides, has_bars):
    """Summary, and the key results with peaks between step ends"""
    directory = Path(f"bars-{number}-" + re.sub(r"\W+", "-", "".join(overrides[-4:])))
    status, _, message = run("--output", directory, SCENE, *settings(overrides),
                             "--set", f"Output/Error bars={'true' if has_bars else 'false'}")
    if status != 0:
        raise RuntimeError(message)
    summary = json.loads((directory / "summary.json").read_text())
    with open(directory / "contact.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(row for row in file if row[0] != "#"))
    if has_bars:
        check_screen(summary, (directory / "log.txt").read_text(encoding="utf-8"))
    shutil.rmtree(directory)
    values = {key: math.nan if summary[key] is None else summary[key] for key in KEYS}
    summary |= {f"{key} beside": change_beside([float(row[column]) for row in rows])
                for key, column in PEAKS.items()}
    for key, column in PEAKS.items():
        of_rows = (lambda rows, _: max(row[1] for row in rows)) if summary[
            "scheme"] == "box" else peak
        values[key] = (top if has_rates(overrides) else of_rows)(
            [[float(row[name]) for name in ("time", column, "penetration")] +
             [float(row["velocity_end"]) - gap_rate(overrides)]
             for row in rows], exponent(overrides))
    return summary, values


def check_screen(summary, log):
    """Bars of a value, in time and in space or of both together, to two digits."""
    is_joined = summary["scheme"] == "box"
    kinds = ("space",) if is_joined else ("time", "space")
    head = "+- in time and space together" if is_joined else "+- in time, +- in space"
    if not re.search(rf"^  errors +by [2-4] repeats: value, {re.escape(head)}; few errors are beyond 3 of these$", log, re.M):
        raise RuntimeError("log.txt: no repeats")
    for key in KEYS:
        bars = [summary[f"{key}_{kind}_error"] for kind in kinds]
        words = re.search(rf"^ +{key} +\S+ +" + r" +".join([r"\+- (\S+)"] * len(bars)) + "$",
                          log, re.M)
        if summary[key] is not None and not (words and all(
                word == "unknown" if bar is None else abs(float(word) - bar) <= 0.051 * bar
                for word, bar in zip(words.groups(), bars))):
            raise RuntimeError(f"log.txt: {words and words[0]}, not {bars}")


def has_rates(overrides):
    """A rod, an obstacle that yields, and a scheme that knows the velocity to its order"""
    return not any(word in entry for entry in overrides for word in (
        "Dimension=2", "backward euler", "energy conserving", "rigid", "Scheme=box"))


def gap_rate(overrides):
    """g' of a moving obstacle"""
    return 0.3 if "Contact/Gap=0.1+0.3*t" in overrides else 0.0


def has_limit(key, overrides):
    """The force of a viscous rod behind an impact on a rigid stop is that of a jump of the
    velocity, V (b zeta/(pi t))^(1/2); the compliance 0.01 gives way within the 0.02837 of
    (D7.3), in which viscosity reaches (0.2 0.02837)^(1/2) = 0.0753 far. Of an elastic rod
    it has one without dispersion alone. So has the penetration, on which it depends."""
    given = dict(entry.split("=", 1) for entry in overrides)
    nodes = (int(given.get("Mesh/Cells", 8)) * 2 ** int(given.get("Mesh/Refinements", 0)) *
             int(given.get("Mesh/Degree", 4)))
    condition = given.get("Contact/Condition", "normal compliance")
    if key not in PEAKS:
        return True
    if given.get("Model/Viscosity") == "0":
        return given["Time/Scheme"] == "box"
    if "Contact/Compliance" in given:  # a hard one
        return False
    return condition == "power law" or (condition != "rigid" and 1 / nodes <= 0.0753)


def exponent(overrides):
    """Of the power law, by which the force follows from the penetration"""
    return next((float(entry.partition("=")[2]) for entry in overrides
                 if entry.startswith("Contact/Exponent=")), 1)


def top(rows, power):
    """(D9.2): the largest value of the cubics of the steps in contact, f ~ s^power"""
    largest = max(row[1] for row in rows)
    for (t0, f0, s0, v0), (t1, f1, s1, v1) in zip(rows, rows[1:]):
        if s0 > 0 and s1 > 0 and v0 > 0 > v1:
            # what is asked for is the penetration, or a power of it
            m = 1 if f0 == s0 else power
            a, b = ((t1 - t0) * m * f / s * v for f, s, v in ((f0, s0, v0), (f1, s1, v1)))
            c, d = 3 * (f1 - f0) - 2 * a - b, 2 * (f0 - f1) + a + b
            root = (c * c - 3 * a * d) ** 0.5  # of a + 2 c x + 3 d x^2, where it falls
            x = a / (root - c)
            largest = max(largest, f0 + x * (a + x * (c + x * d)))
    return largest


def peak(rows, _):
    """(D9.2): the vertex of the parabola through the largest value and its neighbours"""
    i = max(range(len(rows)), key=lambda j: rows[j][1])
    if not 0 < i < len(rows) - 1:
        return rows[i][1]
    (t0, f0), (t1, f1), (t2, f2) = (row[:2] for row in rows[i - 1:i + 2])
    rise, fall = (f1 - f0) / (t1 - t0), (f2 - f1) / (t2 - t1)
    curvature = (fall - rise) / (t2 - t0)
    slope = rise + curvature * (t1 - t0)
    return f1 - slope ** 2 / (4 * curvature) if curvature < 0 else f1


def signed_difference(a, b):
    return 0.0 if math.isnan(a) and math.isnan(b) else b - a


def difference(a, b):
    return abs(signed_difference(a, b))


def time_bars(summary, values, in_time, weights):
    """(D9.3)"""
    bars = {}
    for key in KEYS:
        time = [weight * difference(values[key], repeat[key])
                for weight, repeat in zip(weights, in_time)]
        if key in PEAKS and summary[key] is not None and time:
            time.append(values[key] - summary[key])
        bars[key] = max(time, default=math.nan)
    return bars


def space_bars(values, in_space, time, smallest):
    """(D9.4)"""
    first, second = ({key: signed_difference(values[key], repeat[key]) for key in KEYS}
                     for repeat in in_space)
    near = {key: abs(first[key]) for key in KEYS}
    coarser = {key: abs(second[key] - first[key]) for key in KEYS}
    rates = {key: max(near[key] / coarser[key], smallest) if coarser[key] > near[key] else 1
             for key in KEYS}
    largest = max((rates[key] for key in KEYS
                   if near[key] > 2 * time[key] and second[key] != 0), default=0)
    bars = {}
    for key in KEYS:
        rate = max(rates[key], math.sqrt(rates[key] * largest))
        bars[key] = min(2, rate / (1 - rate) if rate < 1 else 2) * near[key]
    return bars


def change_beside(values):
    """The least change from step to step of four before the largest value, or behind it"""
    largest = max(range(len(values)), key=lambda i: (values[i], i))
    changes = [0]
    for side in (1, -1):
        least, i = math.inf, largest
        while abs(i - largest) < 4 and 0 <= i + side < len(values) and values[i + side] > 0:
            least, i = min(least, abs(values[i] - values[i + side])), i + side
        changes.append(0 if math.isinf(least) else least)
    return max(changes)


def of_steps(summary, overrides):
    """2.5 times the change of a peak in a step beside it; a step for each release, times the
    force, of a rigid obstacle; of a hard one the time in which it gives way, its compliance; a
    step for times of a contact that begins later than t = 0 without a gap. Steps pass a
    cell, b = 1."""
    peaks = {key: 2.5 * summary[f"{key} beside"] for key in PEAKS}
    given = dict(entry.split("=", 1) for entry in overrides)
    step, compliance = 1 / int(given["Mesh/Cells"]), float(given.get("Contact/Compliance", 0))
    is_hard = 0 < 2 * compliance < step
    late = step if given.get("Contact/Gap") == "0" and summary["first_contact_time"] > 0 else 0
    peaks |= {"first_contact_time": late, "contact_duration": late}
    if given.get("Contact/Condition") != "rigid" and not is_hard:
        return peaks
    n = summary["contact_begins"] - (summary["final_contact_force"] > 0)
    time = n * (compliance if is_hard else step)
    moved = time * summary["max_contact_force"]
    return peaks | {"contact_duration": late + time, "contact_impulse": moved,
                    "final_displacement_end": moved if is_hard else 0,
                    "restitution": math.inf if is_hard else 0}


def joined_bars(summary, values, in_space, steps):
    """(D9.5)"""
    bars = {}
    for key in KEYS:
        near, far = (difference(values[key], repeat[key]) for repeat in in_space)
        bars[key] = max(near, far / 3, steps.get(key, 0))
        if summary[key] is not None:
            bars[key] = max(bars[key], values[key] - summary[key], 1e-9 * abs(summary[key]))
    return bars


def check_case(case):
    number, (overrides, in_time, in_space, smallest) = case
    summary, values = results(number, overrides, True)
    repeats = [results(number, overrides + entries, False)[1]
               for entries in [entries for entries, _ in in_time] + in_space]
    time = time_bars(summary, values, repeats[:len(in_time)],
                     [weight for _, weight in in_time])
    space = (joined_bars(summary, values, repeats, of_steps(summary, overrides))
             if smallest is None else
             space_bars(values, repeats[len(in_time):], time, smallest))
    faults = []
    longest = max([bar for bar in (time["restitution"], space["restitution"]) if not math.isnan(bar)], default=0)
    if summary["restitution"] is not None and longest > max(1, abs(summary["restitution"])):
        time["restitution"] = space["restitution"] = math.nan
    for key in KEYS:
        for kind, bar in (("time", time[key]), ("space", space[key])):
            found = summary[f"{key}_{kind}_error"]
            is_known = (summary[key] is not None and not math.isnan(bar)
                        and has_limit(key, overrides))
            if (found is not None) != is_known:
                faults.append(f"{key}_{kind}_error is {found}, expected {bar}")
            # repeats are bit for bit these runs; tables have 13 digits
            elif is_known and abs(found - bar) > 1e-6 * bar + 1e-11 * abs(summary[key]):
                faults.append(f"{key}_{kind}_error is {found}, expected {bar}")
    return faults and f"{' '.join(overrides)}: {'; '.join(faults)}"


def check_errors(number):
    """True errors of a case of experiment 1 within three bars"""
    overrides = CASES[number][0]
    exact = results(number, ("Time/Tolerance=1e-9", "Mesh/Degree=10"), False)[1]
    summary = results(number, overrides, True)[0]
    return "; ".join(
        f"{key} is {summary[key]} of {exact[key]}" for key in KEYS
        if has_limit(key, overrides) and abs(summary[key] - exact[key]) > 3 * (
            summary[f"{key}_time_error"] + summary[f"{key}_space_error"]))


def check_first_contact(case):
    """Its error within three bars, at the softest of the obstacles within one"""
    compliance, cells, degree = case
    summary = results(0, (f"Contact/Compliance={compliance}", f"Mesh/Cells={cells}",
                          f"Mesh/Degree={degree}", "Time/End time=0.3"), True)[0]
    bar = sum(summary[f"first_contact_time_{kind}_error"] for kind in ("time", "space"))
    error = abs(summary["first_contact_time"] - FIRST_CONTACT)
    return error > (1 if case == HARD[0] else 3) * bar and f"{case}: {error} of {bar}"


def check_failure():
    """In steps beyond 0.0284 the paper's iteration fails at the first contact, t = 0.183."""
    directory = Path("fails")
    run("--output", directory, SCENE, *settings((
        "Time/Scheme=backward euler", "Solver/Step solver=fixed point", "Time/Step size=0.02")))
    summary = json.loads((directory / "summary.json").read_text())
    shutil.rmtree(directory)
    yield from (line for line in summary["warnings"] if line.startswith("error bars"))
    yield sum(summary[f"{key}_time_error"] is None for key in KEYS)
    yield sum(summary[f"{key}_space_error"] is None for key in KEYS)


def main():
    faults = list(filter(None, for_all(check_case, enumerate(CASES))))
    print("error bars:", "; ".join(faults) or "those of the repeats")
    print("errors:", check_errors(0) or "within three bars")
    print("hard obstacles:", "; ".join(filter(None, for_all(check_first_contact, HARD)))
          or "the first contact is within its bars")
    print(*check_failure(), sep="; ")


main()
