#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What log.txt says of the result, from summary.json and contact.csv, and of the first
impact and the limit of the paper's iteration, from summary.json and events.csv.

Numbers have six digits, differences from the state of rest two, the wall time of a step
three. Up to five contacts that have ended are listed by their durations. The defect of the energy is what the columns leave, but for rounding. The lines of
tenths are rows of contact.csv, as far as these are written.
"""
import math
import re
import sys

from run_files import Run, differences

NUMBER = r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?(?![\d%]*\()"  # not that of u(1)
SIX, THREE, TWO = 6e-6, 6e-3, 6e-2
ROUNDING = 1e-13  # of the end, of the strain that the force makes, and of a gap, of u(1), too
FEW = 5  # contacts whose durations are listed
SHOWN = {"u(1)": "displacement_end", "gap": "gap", "force": "contact_force",
         "theta(1)": "temperature_end"}


def numbers(text):
    return [float(word) for word in re.findall(NUMBER, re.sub(r"\w+\(1\)", "", text))]


def last_line(log, title):
    found = re.findall(rf"^  {title} +(.*)$", log, re.MULTILINE)
    return found[-1] if found else ""


def expected_lines(run):
    """Title, text before the numbers that are compared, numbers and their bounds."""
    s, last = run.summary, {name: run.contact[name][-1] for name in run.contact.names}
    if "displacement" in s["fields"] and run.settings["Contact/Condition"] != "none":
        first = [s["first_contact_time"]] if s["contact_begins"] else []
        ended = [d for d in run.events["duration"] if d == d]
        first += ended if len(ended) <= FEW else []
        if first and (len(ended) > 1 or s["final_in_contact"]):
            first.append(s["contact_duration"])
        yield "contact", "", [(value, SIX, 0) for value in (
            s["contact_begins"], *first, s["max_contact_force"], s["max_penetration"],
            last["contact_impulse"])]
    keys = [key for key in ("displacement_end", "temperature_end", "contact_force")
            if s["final_" + key] is not None]
    words = last_line(run.log, "final")
    if "force" not in words:
        keys = [key for key in keys if key != "contact_force"]
    resting = ROUNDING * abs(last.get("contact_force", 0))
    yield "final", "", [(last[key], SIX, resting * (key == "displacement_end")) for key in keys]
    if s["predicted_in_contact"] is not None:
        yield "steady", "; differs in ", [(s["difference_" + key], TWO, 1e-12)
                                          for key in keys]
    parts = [last[name] for name in (
        "energy", "dissipation", "contact_dissipation", "numerical_dissipation")
        if last.get(name) or name != "contact_dissipation"]
    first, shown = run.contact["energy"][0], parts.copy()
    if last.get("lateral_dissipation"):  # the part of the dissipation behind it
        shown.insert(2, last["lateral_dissipation"])
    left = last.get("algebraic", 0)  # by the iterative solver
    rounding = 1e-12 * max(abs(first), abs(last["work"]), abs(last["energy"]))
    defect = first + last["work"] + left - sum(parts)
    first_shown, work, *shown, left_shown, defect = (value if abs(value) > rounding else 0 for value in (
        first, last["work"], *shown, left, defect))
    yield "energy", "", [(value, SIX, 0) for value in (first_shown, work, *shown)] + [
        (left_shown, TWO, 0)] * int(left != 0) + [(defect, TWO,
                                          1e-11 * (abs(first) + abs(last["work"])))]
    yield "cost", "", [(s[key], 0, 0) for key in (
        "steps", "rejected_steps", "factorizations", "solves")] + [
        (1e6 * s["loop_seconds"] / s["steps"], THREE, 0)]


def faults_of_result(run):
    for title, begin, expected in expected_lines(run):
        found = numbers(last_line(run.log, title).partition(begin)[2] if begin else
                        last_line(run.log, title))
        if len(found) != len(expected) or any(
                abs(a - b) > relative * abs(b) + absolute + 1e-300
                for a, (b, relative, absolute) in zip(found, expected)):
            yield f"{title}: {found} instead of {[value for value, *_ in expected]}"
    words = last_line(run.log, "final").rpartition(", ")[2]
    if words in ("open", "in contact") and (words == "in contact") != run.summary[
            "final_in_contact"]:
        yield f"final: {words}"


def faults_of_energy(run):
    if not re.search(r"defect -?\d(\.\d)?(e-\d+)?$", last_line(run.log, "energy")):
        yield "a defect of more than two digits"


def faults_of_times(run):
    """The parts of the whole, to three digits, and their shares."""
    s = {key.removesuffix("_seconds"): value for key, value in run.summary.items()}
    expected = [max(0, seconds) for seconds in (
        s["set_up"], s["factorization"], s["solve"] - s["factorization"], s["contact"],
        s["step"] - s["solve"] - s["contact"], s["loop"] - s["step"], s["output"], s["wall"])]
    found = re.findall(r"^  (?:time|    )      \S.* (\S+) s +(\S+) %$", run.log, re.MULTILINE)
    if len(found) != len(expected) or any(
            abs(float(time) - seconds) > 6e-4 or abs(float(share) - 100 * seconds / s["wall"]) > 0.06
            for (time, share), seconds in zip(found, expected)):
        yield f"times: {found} instead of {expected}"


def faults_of_start(run):
    """That of the paper ends at u_0 + dt u_1."""
    c = run.contact
    if "displacement" in run.summary["fields"] and c["step"][1] == 1:
        u, end = c["displacement_end"][:2], c["step_size"][1] * c["velocity_end"][0]
        if (", start of the paper" in run.log) != (abs(u[1] - u[0] - end) < 1e-14):
            yield "not the start that it says"


def faults_of_work(run):
    """That of a constant traction alone, on the way of the end."""
    force, u = run.settings.get("Boundary/right/Traction", "0"), run.contact["displacement_end"]
    if re.fullmatch(r"-0\.\d", force):
        yield differences(run.contact["work"], float(force) * (u - u[0]), 1e-11)


def faults_of_tenths(run):
    times, compared = run.contact["time"], 0
    end_time = run.settings.number("Time/End time")
    lines = re.findall(r"^ +(\d+) %   t = (\S+) +(.*)$", run.log, re.MULTILINE)
    for percent, time, values in lines:
        share = 10 * float(time) / end_time  # of a time of six digits
        if int(percent) not in (10 * int(share - 1e-4), 10 * int(share + 1e-4)):
            yield f"t = {time} is not {percent} %"
        rows = [i for i, t in enumerate(times) if abs(t - float(time)) <= SIX * t]
        for name, value in re.findall(r"(\S+) = (\S+)", values) if rows else []:
            compared += 1
            exact, force, u = (run.contact[column][rows[0]] if column in run.contact.names else 0
                               for column in (SHOWN[name], "contact_force", "displacement_end"))
            scale = {"u(1)": abs(force), "gap": max(abs(force), abs(u))}.get(name, 0)
            if abs(float(value) - exact) > SIX * abs(exact) + ROUNDING * scale:
                yield f"t = {time}: {name} = {value} instead of {exact}"
    if not lines or lines[-1][0] != "100" or compared == 0:
        yield "no lines of tenths"


def time_scales(settings):
    """Diffusion over the rod, 1; a wave along it, sqrt(b); zeta of Kelvin and Voigt;
    contact, in which the impedance sqrt(b) of a wave or that of viscosity, sqrt(b zeta/tau),
    meets tau/epsilon."""
    b, zeta = settings.number("Model/Inertia"), settings.number("Model/Viscosity")
    epsilon = settings.number("Contact/Compliance")
    if settings.has("temperature"):
        yield "heat", 1
        if m := settings.number("Boundary/sides/Heat exchange"):
            yield "lateral", 1 / m
    if settings.has("displacement"):
        yield from ((name, value) for name, value in (
            ("wave", b**0.5), ("viscous", zeta),
            ("contact", max((epsilon**2 * b * zeta)**(1 / 3), epsilon * b**0.5)
             if settings["Contact/Condition"] == "normal compliance" and not
             settings.number("Contact/Damping") and not
             settings.number("Contact/Dashpot") else 0)) if value)


def faults_of_scales(run):
    found = re.findall(r"(\w+) ([\d.e+-]+)", last_line(run.log, "scales"))
    expected = list(time_scales(run.settings))
    if [name for name, _ in found] != [name for name, _ in expected] or any(
            abs(float(value) / exact - 1) > SIX
            for (_, value), (_, exact) in zip(found, expected)):
        yield f"scales: {found} instead of {expected}"


def faults_of_forecast(run):
    s = run.summary
    words = last_line(run.log, "impact")
    if words:
        time, velocity, *peak = numbers(words)
        if abs(time / s["predicted_first_contact_time"] - 1) > TWO:
            yield f"impact: {words}"
        if len(run.events) and not 0.7 < velocity / run.events["velocity"][0] < 1.4:
            yield f"impact: velocity {velocity}, in events.csv {run.events['velocity'][0]}"
        if s["predicted_first_penetration"] is not None and (
                abs(peak[0] / s["predicted_first_penetration"] - 1) > TWO or
                abs(peak[1]**(1 / run.settings.number("Contact/Exponent", 1)) *
                    run.settings.number("Contact/Compliance") / peak[0] - 1) > 2 * TWO):
            yield f"impact: {words}"
    elif s["predicted_first_contact_time"] is not None:
        yield "no impact"
    words, critical = last_line(run.log, "limit"), s["predicted_critical_step_size"]
    if (words != "") != (critical is not None):
        yield f"limit: {words}"
    elif words:
        step = run.settings["Time/Step size"]
        is_iteration = run.settings.get("Solver/Step solver") == "fixed point"
        if abs(numbers(words)[0] / critical - 1) > SIX or (", as the" in words) != (
                is_iteration and float(step) > critical):
            yield f"limit: {words}"


def expected_steps(run):
    """doc/accuracy.md, without what loads ask for; T/dt of fixed steps. The rate of time with
    which heat conduction damps is that of heating by the motion."""
    s = run.settings
    T, b, zeta, a = (s.number(name) for name in (
        "Time/End time", "Model/Inertia", "Model/Viscosity", "Model/Coupling"))
    heat, moves = s.has("temperature"), s.has("displacement")
    intervals = [s.number("Output/Period")] + [
        s.number(f"Output/{name} interval") for name in ("Fields", "Contact", "Space-time")
        if s.get("Output/Land on output times") == "true"]
    more = sum(T / interval for interval in intervals if interval)
    if not s.has_error_control():
        return more + math.ceil(T / s.step_size() * (1 - 1e-6)) + sum(
            0 < float(time) < T for time in s.get("Time/Break points", "").split(";") if time)
    order = {"sdirk3": 3, "sdirk4": 4, "energy conserving": 2}[s["Time/Scheme"]]
    tolerance, n, least = s.number("Time/Tolerance"), 0.38 * heat * math.log1p(min(10, T) / 3e-4) + 1.7 * moves * min(1, T**0.5), 0
    if moves and b:
        is_heated = heat and s.get("Model/Thermoelastic heating") == "true"
        damping = zeta / b + is_heated * a * a / (2 * b + 0.8)
        n_runs = min(T, 1 / damping if damping else math.inf) / b**0.5
        softness = s.number("Contact/Compliance") / s.number("Contact/Exponent", 1)
        contact = (s["Contact/Condition"] != "none") * 0.5 / (1 + 5 * softness)
        n += (0.55 + contact) * n_runs * (1 + (0.05 * b**0.5 / (zeta + 3e-4 * b**0.5))**0.4)
    elif moves and heat and not zeta:
        least = 4 * (min(1, T) / tolerance)**(1 / 3)
    return more + math.ceil(max(n / tolerance**(1 / order), least, T / s.number(
        "Time/Maximum step size")))


def faults_of_cost(run):
    """Steps; rows and snapshots at multiples of their intervals and at T; bytes of theirs as
    measured: 290 a row of a rod that is heated and moves, 32 a point of a body's snapshot."""
    s, m = run.settings, run.summary
    steps, dim, T = m["predicted_steps"], int(s["Dimension"]), s.number("Time/End time")
    words = last_line(run.log, "expected")
    is_counted = s["Model/Fields"] == "displacement" and s.get("Model/Viscosity") == "0" and \
        s.get("Contact/Condition") == "none"  # in the runs of a wave, not by a formula
    if not words.startswith("perhaps") and not is_counted and abs(steps - expected_steps(run)) > 1e-6:
        yield f"predicted_steps: {steps} instead of {expected_steps(run)}"

    def count(interval):
        return min(steps + 1, math.ceil(T / interval * (1 - 1e-9)) + 1)
    heat, moves = s.has("temperature"), s.has("displacement")
    contact, fields = (s.number(f"Output/{name} interval") for name in ("Contact", "Fields"))
    rows = count(contact) if contact else steps + 1
    expected = [steps, rows, rows * (290 if heat and moves else 250 if moves else 195)]
    if fields:
        n, degree = count(fields), s.number("Mesh/Degree")
        cells, across = (s.number(f"Mesh/{name}", 1) * 2**s.number("Mesh/Refinements")
                         for name in ("Cells", "Cells across"))
        points = cells * across**(dim - 1) * (degree + 1)**dim
        expected += [n, n * (900 + 500 * (heat + moves) + points * (
            (20 if moves else 10) if dim == 1 else 32 if moves else 16))]
        if dim > 1 and s.get("Contact/Condition", "none") != "none":
            expected += [n * (1900 + 8 * 2**(dim - 1) * (across * degree + 1)**(dim - 1))]
    found = [float(number) * {"k": 1e3, "M": 1e6, "G": 1e9}.get(unit[0], 1) for number, unit in
             re.findall(r"([\d.]+(?:e\+?\d+)?) (B\b|[kMG]B|steps|rows|snapshots)", words)]
    if len(found) != len(expected) or any(abs(a - b) > TWO * b for a, b in zip(found, expected)):
        yield f"expected: {words}, not {expected}"


def faults_of_log(run):
    looks = [faults_of_scales, faults_of_forecast, faults_of_cost, faults_of_start]
    if run.summary["status"] == "done":
        looks += [faults_of_result, faults_of_energy, faults_of_times, faults_of_tenths,
                  faults_of_work]
    return [fault for look in looks for fault in look(run) if fault]


def tell(run, **options):
    print("log.txt:", "; ".join(faults_of_log(run)) or "as summary.json and the tables", **options)


if __name__ == "__main__":
    tell(Run(sys.argv[1]))
