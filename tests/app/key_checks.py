# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of the keys of summary.json of a rod, against the tables, the log and formulas."""
import math
import re

import numpy

import rod_forecast
from column_checks import check, increments, replay_of, rod_of, rows_of
from rod_replay import sides_of
from run_files import differences, nearly

TIMES = ("set_up_seconds", "loop_seconds", "step_seconds", "factorization_seconds",
         "solve_seconds", "contact_seconds", "output_seconds", "wall_seconds")


def key(*names):
    return check(*(f"summary.json/{name}" for name in names))


def compare(run, expected, bound=0.0):
    """Faults of the keys that do not have the expected values."""
    for name, value in expected.items():
        found = run.summary[name]
        same = (nearly(found, value, bound) if isinstance(value, float) else
                found == value and isinstance(found, type(value)))
        if not same:
            yield f"{name} is {found} instead of {value}"


@key("title", "status", "version", "dimension", "ranks", "fields", "scheme")
def check_names(run):
    """Entries of the file, and the heads of the tables and of the log."""
    s = run.settings
    version = run.contact.comments[1].split(",")[0].removeprefix("thermocontact ")
    fields = [name for name in ("temperature", "displacement") if s.has(name)]
    yield from compare(run, {
        "title": s["Title"], "status": "done", "version": version,
        "dimension": int(s["Dimension"]), "fields": fields, "scheme": s["Time/Scheme"],
        "ranks": int(re.search(r"ranks: (\d+)", run.log)[1])})
    for table in run.tables.values():
        if table.comments[0] != s["Title"] or version not in table.comments[1]:
            yield "the head of a table"


@key("terms")
def check_terms(run):
    """The terms that the entries leave in the equations."""
    rod, s = rod_of(run), run.settings
    is_lumped = s.get("Mesh/Mass matrix") == "lumped"
    terms = {
        "heat conduction": rod.has_heat, "heat exchange": rod.has_heat and rod.k > 0,
        "lateral heat exchange": rod.has_heat and rod.m > 0,
        "inertia": rod.moves and rod.b > 0, "elasticity": rod.moves,
        "viscosity": rod.moves and rod.zeta > 0, "thermal stress": rod.a != 0,
        "thermoelastic heating": rod.a != 0 and rod.heats,
        "rigid contact": rod.is_rigid, "normal compliance": rod.epsilon > 0,
        "two stops": rod.g_2 < math.inf, "massless contact nodes": rod.is_massless,
        "lumped mass": is_lumped and (rod.has_heat or rod.b > 0),
        "heat source": rod.sources["Heat source"], "body force": rod.sources["Body force"],
        "end traction": rod.sources["End traction"],
        "end heat flux": rod.sources["End heat flux"]}
    yield from compare(run, {"terms": [name for name, is_there in terms.items()
                                       if is_there]})


@key("dofs", "factorized_unknowns")
def check_sizes(run):
    """A field has cells x degree + 1 unknowns; both at once if they are coupled both ways."""
    replay = replay_of(run)
    rod = replay.rod
    n = rod.cells * rod.degree + 1
    is_coupled = rod.a != 0 and rod.heats and not replay.is_iterated
    fields = rod.has_heat + rod.moves
    yield from compare(run, {"dofs": n * fields,
                             "factorized_unknowns": n * (fields if is_coupled else 1)})


@key("steps", "rejected_steps", "factorizations", "responses", "solves")
def check_counts(run):
    """Counts of the replay, and of the rows of steps.csv."""
    replay = replay_of(run)
    rejected = int(sum(run.steps["accepted"] == 0)) if run.has_table("steps") else 0
    yield from compare(run, {"steps": len(replay.rows) - 1, "rejected_steps": rejected,
                             **replay.counters})
    stages = len(replay.scheme[0])
    if not replay.is_iterated:
        attempts = run.summary["steps"] + rejected - replay.has_prescribed_step
        yield from compare(run, {"solves": stages * attempts + (
            replay.has_prescribed_step and replay.rod.has_heat)})


@key("linear_solver", "linear_iterations", "max_linear_iterations",
     "active_set_iterations")
def check_linear_solver(run):
    """Factors alone: along the rod where one process has all of it and nobody asks for
    sparse ones or for the iteration of the paper; nothing is said of iterations."""
    is_along_rod = (run.summary["ranks"] == 1 and
                    run.settings.get("Solver/Linear solver", "automatic") == "automatic" and
                    run.settings.get("Solver/Step solver", "monolithic") == "monolithic")
    refused = ["direct"] * any("blocks of the stage matrix grow" in warning
                               for warning in run.summary["warnings"])
    yield from compare(run, {"linear_solver": ", ".join(["block tridiagonal", *refused])
                             if is_along_rod else "direct",
                             "linear_iterations": 0,
                             "max_linear_iterations": 0, "active_set_iterations": 0})
    if "Krylov" in run.log:
        yield "the log speaks of iterations"


@key("contact_begins", "first_contact_time")
def check_contacts(run):
    """Those of events.csv"""
    begins = [time for time, kind in zip(run.events["time"], run.events["kind"])
              if kind == "begin"]
    yield from compare(run, {"contact_begins": len(begins),
                             "first_contact_time": float(begins[0]) if begins else None})


@key("contact_duration", "restitution", "contact_impulse")
def check_contact(run):
    """Sums over the events; the last release over the first impact; the last row"""
    begins, ends = (run.events["time"][numpy.array(run.events["kind"]) == kind]
                    if len(run.events) else numpy.array([]) for kind in ("begin", "end"))
    open_end = [run.contact["time"][-1]] * int(run.contact["in_contact"][-1])
    towards = run.events["velocity"] * sides_of(run.events)  # the stop
    velocities = dict(zip(run.events["kind"][::-1], towards[::-1]))
    last = dict(zip(run.events["kind"], towards))
    impact, release = velocities.get("begin", math.nan), last.get("end", math.nan)
    ratio = -release / impact if impact > 0 else math.nan
    yield from compare(run, {"restitution": None if math.isnan(ratio) else float(ratio)},
                       1e-12)
    yield from compare(run, {
        "contact_duration": float(sum([*ends, *open_end]) - sum(begins)),
        "contact_impulse": float(run.contact["contact_impulse"][-1])}, 1e-9)



@check("events.csv/side")
def check_sides(run):
    """Of two stops alone; by the side of the middle on which the end is."""
    if ("side" in run.events.names) != (rod_of(run).g_2 < math.inf):
        yield "the column"
    times = [row["time"] for row in replay_of(run).rows]
    end = [row["displacement_end"] for row in replay_of(run).rows]
    sides = [1 if u > (rod_of(run).g - rod_of(run).g_2) / 2 else -1
             for u in numpy.interp(run.events["time"], times, end)]
    if len(run.events) and sides != sides_of(run.events):
        yield f"{run.events['side']}"


@key("max_penetration", "max_contact_force", "max_energy_increase")
def check_maxima(run):
    """The largest values of the columns, which have a row for every step."""
    replay, c = replay_of(run), run.contact
    if not rows_of(run).all():
        c = {name: numpy.array([row[name] for row in replay.rows])
             for name in ("penetration", "contact_force", "energy", "work")}
    first = 1 + replay.has_prescribed_step
    created = numpy.diff(c["energy"]) - numpy.diff(c["work"])
    yield from compare(run, {"max_penetration": float(max(c["penetration"])),
                             "max_contact_force": float(max(abs(c["contact_force"])))}, 1e-7)
    expected, found = max(0.0, *created[first - 1:]), run.summary["max_energy_increase"]
    if abs(found - expected) > 1e-12 * abs(c["energy"]).max() + 1e-7 * expected:
        yield f"max_energy_increase is {found} instead of {expected}"


@key("final_time", "final_displacement_end", "final_energy", "final_contact_force",
     "final_temperature_end", "final_in_contact")
def check_last_row(run):
    """The last row of contact.csv"""
    c = run.contact
    yield from compare(run, {"final_time": float(c["time"][-1]),
                             "final_in_contact": bool(c["in_contact"][-1])})
    for name in ("displacement_end", "energy", "contact_force", "temperature_end"):
        yield from compare(run, {f"final_{name}": float(c[name][-1])}, 1e-12)


@key("predicted_displacement_end", "predicted_contact_force", "predicted_temperature_end",
     "predicted_in_contact", "predicted_remark", "difference_displacement_end",
     "difference_contact_force", "difference_temperature_end")
def check_rest(run):
    """(M.10), and how far the last row is from it"""
    u, p, theta, in_contact, remark = rod_forecast.rest(rod_of(run))
    yield from compare(run, {"predicted_in_contact": in_contact,
                             "predicted_remark": remark})
    for name, value in (("displacement_end", u), ("contact_force", p),
                        ("temperature_end", theta)):
        yield from compare(run, {f"predicted_{name}":
                                 None if value is None else float(value)}, 1e-12)
        difference = run.summary["difference_" + name]
        if value is None and difference is not None:
            yield f"difference_{name} is {difference} instead of null"
        if value is not None:
            yield differences([difference], [run.contact[name][-1] - value], 1e-10)


@key("predicted_first_contact_time", "predicted_first_penetration")
def check_first_impact(run):
    """The first contact of the run and its peak, within 10 and 30 per cent, if the rod has
    inertia and no sources and arrives within the time of (M.46)"""
    rod, begins = rod_of(run), run.events["time"][:1]
    waves = 4 * (math.sqrt(rod.b) + rod.zeta)
    is_known = (rod.has_obstacle and rod.b > 0 and not any(rod.sources.values())
                and rod.g_2 == math.inf and len(begins) and 0 < begins[0] < waves)
    time, penetration = (run.summary[f"predicted_first_{name}"]
                         for name in ("contact_time", "penetration"))
    if (time is None) == bool(is_known) or (penetration is None) != (
            not is_known or rod.is_rigid):
        yield "a first impact or none"
    if time is not None:
        yield differences([time], [begins[0]], 0.1)
    if penetration is not None:
        until = numpy.append(run.events["time"], math.inf)[1]
        peak = max(run.contact["penetration"][run.contact["time"] <= until])
        yield differences([penetration], [peak], 0.3)


@key("predicted_critical_step_size", "predicted_steps")
def check_forecast(run):
    """(M.20), the fit of doc/accuracy.md"""
    rod, s = rod_of(run), run.settings
    yield from compare(run, {
        "predicted_critical_step_size": rod_forecast.critical_step_size(rod)}, 1e-10)
    n = rod_forecast.n_steps(rod, s)
    yield from compare(run, {"predicted_steps": None if n is None else float(n)}, 1e-12)


@key("warnings")
def check_warnings(run):
    """Those of the log; of energy that a scheme of order 2 and more creates, and preload."""
    lines = re.findall(r"^  warning:  (.*)$", run.log, re.MULTILINE)
    yield from compare(run, {"warnings": lines})
    rod, replay = rod_of(run), replay_of(run)
    preload = any("(preload)" in line for line in run.summary["warnings"])
    if preload != (rod.has_obstacle and rod.g < 0):
        yield "the warning of a preload"
    step = step_of_created_energy(replay)
    warned = re.findall(r"step (\d+), t = .* created the energy", "\n".join(lines))
    if warned != ([str(step)] if step else []):
        yield f"the warning of created energy is to be of step {step}"


def step_of_created_energy(replay):
    """The first step after which fixed steps, not of backward Euler, have created 1e-3."""
    if replay.settings["Time/Step size"] == "automatic" or len(replay.scheme[0]) == 1 or \
            any(replay.rod.sources.values()) or not replay.rod.heats:
        return None
    smallest, scale = math.inf, 0.0
    for row, state in zip(replay.rows, replay.states):
        scale = max(scale, abs(replay.rod.energy_terms(state)).sum())
        smallest = min(smallest, row["energy"])
        if row["energy"] - smallest > 1e-3 * scale:
            return row["step"]
    return None


@key(*TIMES)
def check_wall_times(run):
    """Parts of the whole; the log, which prints milliseconds."""
    s = run.summary
    if not all(isinstance(s[name], float) and s[name] >= 0 for name in TIMES):
        yield "not a time"
        return
    parts = s["set_up_seconds"] + s["loop_seconds"] + s["output_seconds"]
    if abs(parts - s["wall_seconds"]) > 0.5:  # a loaded machine may stop in between
        yield "set-up, loop and output are not the whole"
    if s["step_seconds"] > s["loop_seconds"] or s["factorization_seconds"] > \
            s["solve_seconds"] or s["solve_seconds"] + s["contact_seconds"] > \
            s["step_seconds"]:
        yield "a part is longer than the whole"
    log = {name.strip(): float(seconds) for name, seconds in
           re.findall(r"^  (?:time)? +(\S.*?) +(\d+\.\d{3}) s ", run.log, re.MULTILINE)}
    expected = {
        "set-up": s["set_up_seconds"],
        "steps: factorisations": s["factorization_seconds"],
        "steps: solves": s["solve_seconds"] - s["factorization_seconds"],
        "steps: contact": s["contact_seconds"],
        "steps: energy, errors, rest":
            s["step_seconds"] - s["solve_seconds"] - s["contact_seconds"],
        "rows and screen": s["loop_seconds"] - s["step_seconds"],
        "fields and checkpoints": s["output_seconds"], "whole run": s["wall_seconds"]}
    for name, seconds in expected.items():
        if abs(log[name] - seconds) > 6e-4:
            yield f"{name}: {seconds} s, in the log {log[name]}"


@key("peak_memory_mb", "peak_memory_mb_per_rank")
def check_memory(run):
    """Between 10 MB and 2 GB on each rank; the sum"""
    ranks = run.summary["peak_memory_mb_per_rank"]
    if len(ranks) != run.summary["ranks"] or not all(10 < m < 2000 for m in ranks):
        yield "not megabytes of each rank"
    if not nearly(run.summary["peak_memory_mb"], float(sum(ranks)), 1e-12):
        yield "not the sum of the ranks"


@check("summary.json/max_contact_force", "contact.csv/contact_force")
def check_growing_force(run):
    """A force that never falls has its maximum in the last row."""
    force = run.contact["contact_force"]
    if (increments(force) >= 0).all() and not nearly(
            run.summary["max_contact_force"], float(force[-1]), 1e-12):
        yield "max_contact_force is not that of the last row"
