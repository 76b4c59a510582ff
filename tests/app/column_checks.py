# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of contact.csv, events.csv and steps.csv of a rod.

Each column is compared with rod_replay.py (bound 1e-7 of its largest value; 1e-10 is
measured) and with the other columns and files that it is tied to.
"""
import math

import numpy

from falsify import Checks
from rod_model import Rod, has_paper_start
from rod_replay import Replay, locates_events, sides_of
from run_files import differences, due

BOUND = 1e-7   # of the replay
EXACT = 1e-11  # of ties that hold to rounding
REPLAYED = ("step", "time", "step_size", "displacement_end", "displacement_mid",
            "velocity_end", "stress_end", "gap", "penetration", "contact_force",
            "contact_impulse", "temperature_end", "heat_flux_end", "energy", "dissipation",
            "numerical_dissipation", "in_contact", "iterations", "work",
            "temperature_mean")

check = Checks()
rods = {}
replays = {}


def rod_of(run):
    """The matrices, once for all runs with the same entries."""
    key = repr(sorted(run.settings.items()))
    if key not in rods:
        rods[key] = Rod(run.settings)
    return rods[key]


def replay_of(run):
    """The replay, once for all runs with the same entries, attempts and events."""
    key = [repr(sorted(run.settings.items()))]
    if run.has_table("steps"):
        key += [run.steps[name].tobytes() for name in ("time", "step_size", "accepted")]
        key += [run.events["time"].tobytes(), *run.events["kind"]]
    key = tuple(key)
    if key not in replays:
        replays[key] = Replay(run)
    return replays[key]


def rows_of(run):
    """True for the steps that have a row in contact.csv"""
    s = run.settings
    if run.has_table("steps"):
        ends = (run.steps["time"] + run.steps["step_size"])[run.steps["accepted"] == 1]
        ends = numpy.concatenate([[0], ends])
    else:
        ends = numpy.array([row["time"] for row in replay_of(run).rows])
    return due(ends, s.number("Output/Contact interval"), s.number("Time/End time") - 1e-12)


def increments(values):
    return numpy.diff(values, prepend=0.0)


# --- contact.csv: ties between columns, first because they are cheap --------------------

@check("contact.csv/step", "contact.csv/time", "contact.csv/step_size")
def check_times(run):
    """The sizes of the steps lead from row to row."""
    c, steps = run.contact, numpy.flatnonzero(rows_of(run))
    yield differences(c["step"], steps, 0)
    follows = numpy.diff(steps, prepend=-1) == 1
    yield differences(increments(c["time"])[follows], c["step_size"][follows], EXACT)
    if c["time"][-1] != run.settings.number("Time/End time"):
        yield "the last row is not at the end time"


@check("contact.csv/displacement_end", "contact.csv/gap", "contact.csv/penetration",
       "contact.csv/contact_force", "contact.csv/in_contact", "contact.csv/stress_end")
def check_contact_law(run):
    """(M.4) or (M.5) in each row; the end stress is the traction less the pressure."""
    c, rod = run.contact, rod_of(run)
    if not rod.moves:
        for name in ("displacement_end", "gap", "penetration", "contact_force"):
            yield differences(c[name], numpy.full(len(c), math.nan), 0)
        return
    p = c["contact_force"]
    yield differences(c["in_contact"], p != 0, 0)
    traction = numpy.array([rod.at_end("End traction", t) for t in c["time"]])
    yield differences(c["stress_end"], traction - p, EXACT)
    yield differences(c["penetration"], rod.epsilon * abs(p), EXACT)
    if not rod.has_obstacle:
        yield differences(p, 0 * p, 0)
        return
    yield differences(c["gap"], [rod.gap(u) for u in c["displacement_end"]], EXACT)
    if rod.g_2 < math.inf and (p * c["displacement_end"] < 0).any():
        yield "pressure of the other stop"
    if rod.g_2 == math.inf and (p < 0).any() or rod.is_rigid and (c["gap"] < -1e-12).any():
        yield "a negative pressure or gap"
    if rod.is_rigid and (abs(c["gap"]) > 1e-12)[p > 0].any():
        yield "pressure on an open gap"
    if rod.epsilon:
        yield differences(c["penetration"], numpy.maximum(0, -c["gap"]), 1e-8)


@check("contact.csv/heat_flux_end", "contact.csv/temperature_end")
def check_heat_flux(run):
    """k (theta_end - theta_obs) in each row"""
    c, rod = run.contact, rod_of(run)
    yield differences(c["heat_flux_end"], rod.k * (c["temperature_end"] - rod.theta_obs)
                      if rod.has_heat else numpy.full(len(c), math.nan), EXACT)


@check("contact.csv/lateral_heat_flux", "contact.csv/lateral_dissipation",
       "contact.csv/temperature_mean")
def check_lateral(run):
    """m (mean theta - theta_inf) in each row; (M.105) by the rod in numpy"""
    c, rod = run.contact, rod_of(run)
    if not rod.m:
        return
    yield differences(c["lateral_heat_flux"],
                      rod.m * (c["temperature_mean"] - rod.theta_inf), EXACT)
    expected = numpy.array([row["lateral_dissipation"] for row in replay_of(run).rows])
    yield differences(c["lateral_dissipation"], expected[rows_of(run)], BOUND)


@check("contact.csv/energy", "contact.csv/work", "contact.csv/dissipation",
       "contact.csv/numerical_dissipation")
def check_audit(run):
    """(M.22) in each row; signs; no work without sources, with the motion heating."""
    c, rod = run.contact, rod_of(run)
    sums = c["energy"] + c["dissipation"] + c["numerical_dissipation"] - c["work"]
    yield differences(sums, numpy.full(len(c), c["energy"][0]), 1e-10)
    scale = abs(c["energy"]).max()
    if (numpy.diff(c["dissipation"]) < -EXACT * scale).any():
        yield "dissipation falls"
    if rod.heats and not any(rod.sources.values()):
        yield differences(c["work"], 0 * c["work"], 0)
    if run.settings["Time/Scheme"] == "backward euler":
        lost = numpy.diff(c["numerical_dissipation"])[int(has_paper_start(run.settings)):]
        if (lost < -EXACT * scale).any():
            yield "numerical dissipation of backward Euler falls"


@check("contact.csv/contact_impulse", "contact.csv/contact_force")
def check_impulse(run):
    """The force of backward Euler times its steps; impacts; the momentum of the rod."""
    c, replay = run.contact, replay_of(run)
    if not replay.rod.moves:
        return
    rod, jumps = replay.rod, increments(c["contact_impulse"])
    if (jumps < 0).any() and rod.g_2 == math.inf:
        yield "the impulse falls"
    if run.settings["Time/Scheme"] == "backward euler":
        yield differences(jumps, c["contact_force"] * c["step_size"], EXACT)
    if rod.is_rigid and replay.locates and not rod.is_massless and rod.b > 0:
        mass = rod.effective_mass()[0]
        for time, kind, velocity in zip(run.events["time"], run.events["kind"],
                                        run.events["velocity"]):
            if kind == "begin" and time > 0:
                row = numpy.argmin(abs(c["time"] - time))
                yield differences([jumps[row]], [mass * velocity], 1e-6)
    if rod.b > 0 and len(c) == len(replay.rows) and not replay.has_prescribed_step \
            and not any(replay.rod.sources.values()):
        # fixed end and obstacle take what the rod loses
        momentum = numpy.array([rod.b * rod.M_u.sum(axis=0) @ state.v
                                for state in replay.states])
        fixed_end = numpy.array([row["fixed_end_impulse"] for row in replay.rows])
        yield differences(c["contact_impulse"], momentum[0] - momentum + fixed_end, BOUND)


@check("contact.csv/temperature_end", "contact.csv/displacement_end",
       "contact.csv/contact_force", "contact.csv/energy")
def check_rest(run):
    """The last row of a quasi-static rod at t > 5 is (M.10): transients are e^-20."""
    c, rod = run.contact, rod_of(run)
    if rod.b > 0 or c["time"][-1] < 5 or any(rod.sources.values()):
        return
    drop = rod.k / (rod.k + 1) * (rod.theta_A - rod.theta_obs)
    G = rod.a * (rod.theta_A - drop / 2)
    p = max(0, G - rod.g) / (1 + rod.epsilon)
    square = rod.theta_A**2 - rod.theta_A * drop + drop**2 / 3
    for name, value in (("displacement_end", G - p), ("contact_force", p),
                        ("temperature_end", rod.theta_A - drop),
                        ("temperature_mean", rod.theta_A - drop / 2),
                        ("heat_flux_end", drop),  # k (1 - c) = c
                        ("energy", -rod.a**2 * square / 2 + (1 + rod.epsilon) * p**2 / 2)):
        yield differences(c[name][-1:], [value], 1e-7)
    if (numpy.diff(c["contact_force"]) < -1e-12).any():
        yield "the force does not grow"


@check(*(f"contact.csv/{name}" for name in REPLAYED))
def check_replay(run):
    """All columns as the rod in numpy has them."""
    replay, is_row = replay_of(run), rows_of(run)
    for name in REPLAYED:
        expected = numpy.array([row[name] for row in replay.rows])[is_row]
        fault = differences(run.contact[name], expected,
                            0 if name in ("step", "in_contact", "iterations") else BOUND)
        yield fault and f"{name}: {fault}"


# --- poincare.csv: rows of contact.csv ---------------------------------------------------

@check(*(f"poincare.csv/{name}" for name in (
    *REPLAYED, "lateral_heat_flux", "lateral_dissipation")))
def check_poincare(run):
    """The rows at the multiples of the period, all of them; of each step there is a row."""
    if not run.has_table("poincare"):
        return
    period, c = run.settings.number("Output/Period"), run.contact
    if run.poincare.names != c.names:
        yield "other columns than contact.csv"
    times = period * numpy.arange(math.floor(c["time"][-1] / period + 1e-9) + 1)
    yield differences(run.poincare["time"], times, EXACT)
    rows = [int(numpy.argmin(abs(c["time"] - time))) for time in times]
    for name in c.names:
        fault = differences(run.poincare[name], c[name][rows], 0)
        yield fault and f"poincare.csv/{name}: {fault}"


# --- events.csv -------------------------------------------------------------------------

@check("events.csv/duration")
def check_durations(run):
    """From the begin, in the row above, to the end."""
    yield from faults_of_durations(run.events)


def faults_of_durations(e):
    time = numpy.array(e["time"])
    expected = numpy.where([kind == "end" for kind in e["kind"]],
                           numpy.diff(time, prepend=numpy.nan), numpy.nan)
    yield differences(e["duration"], expected, EXACT)



@check("events.csv/time", "events.csv/kind", "events.csv/velocity")
def check_events(run):
    """Contact begins and ends in turn, where in_contact changes."""
    e = run.events
    kinds = ["begin", "end"] * len(e)
    if e["kind"] != kinds[:len(e)]:
        yield "not begin and end in turn"
    if locates_events(run.settings) and rod_of(run).has_obstacle:
        yield from located_events(run)
        return
    rows = replay_of(run).rows  # of every step
    c = {name: numpy.array([row[name] for row in rows]) for name in
         ("time", "in_contact", "gap", "velocity_end")}
    yield from interpolated_events(e, c)


def located_events(run):
    """Steps end at events; the velocity is that before the contact node is stopped."""
    e, s = run.events, run.steps
    ends = numpy.concatenate([[0], (s["time"] + s["step_size"])[s["accepted"] == 1]])
    steps = [int(numpy.argmin(abs(ends - time))) for time in e["time"]]
    if any(abs(ends[step] - time) > 1e-5 for step, time in zip(steps, e["time"])):
        yield "no step ends at an event"
        return
    replay = replay_of(run)
    rows = replay.rows
    touches = [i for i, row in enumerate(rows) if row["in_contact"]]
    if touches and (not steps or touches[0] < steps[0]):
        yield "contact without an event"
    # of an elastic obstacle at the event, which is beside the step end by what the
    # locator leaves; else at the step end
    velocities = []
    for event, time, step in zip(e["velocity"], e["time"], steps):
        at_end, size = replay.velocities[step], ends[step] - ends[max(step - 1, 0)]
        change = at_end - rows[max(step - 1, 0)]["velocity_end"]
        at_event = at_end + (change / size * (time - ends[step]) if size else 0.)
        velocities.append(min(at_end, at_event, key=lambda value: abs(value - event)))
    yield differences(e["velocity"], velocities, BOUND)
    if not replay.rod.is_rigid:  # the zero of the gap, to first order
        zeros = [rows[step]["time"] + side * rows[step]["gap"] / velocity if step else 0.0
                 for step, velocity, side in zip(steps, e["velocity"], sides_of(e))]
        yield differences(e["time"], zeros, BOUND)


def interpolated_events(e, c):
    """The zero of the gap between the steps, linear; the velocity of the open one."""
    times, velocities = [], []
    for row in numpy.flatnonzero(increments(c["in_contact"])):
        begins, old = bool(c["in_contact"][row]), max(row - 1, 0)
        gap0, gap1 = c["gap"][old], c["gap"][row]
        part = min(max(gap0 / (gap0 - gap1), 0), 1) if gap0 != gap1 else 1.0
        times.append(c["time"][old] + part * (c["time"][row] - c["time"][old]))
        velocities.append(c["velocity_end"][old if begins else row])
    yield differences(e["time"], times, BOUND)
    yield differences(e["velocity"], velocities, BOUND)


# --- steps.csv --------------------------------------------------------------------------

@check("steps.csv/time", "steps.csv/step_size", "steps.csv/accepted")
def check_chain(run):
    """Attempts start where the last accepted one ended; the rows of contact.csv."""
    if not run.has_table("steps"):
        if locates_events(run.settings):
            yield "no steps.csv"
        return
    s, c = run.steps, run.contact
    accepted = s["accepted"] == 1
    yield differences(s["accepted"], accepted, 0)
    is_row = rows_of(run)
    yield differences(s["step_size"][accepted][is_row[1:]], c["step_size"][1:], 0)
    ends = (s["time"] + s["step_size"])[accepted]
    yield differences(c["time"][1:], ends[is_row[1:]], EXACT)
    starts = numpy.concatenate([[0], ends])[numpy.cumsum(accepted) - accepted]
    yield differences(s["time"], starts, EXACT)
    if len(s) != run.summary["steps"] + run.summary["rejected_steps"]:
        yield "rows are not steps + rejected_steps"
    if sum(accepted) != run.summary["steps"]:
        yield "accepted rows are not steps"
    if (s["step_size"][~accepted] <= s["step_size"][numpy.flatnonzero(~accepted) + 1]).any():
        yield "a step is rejected and not made smaller"


@check("steps.csv/error", "steps.csv/reason")
def check_errors(run):
    """The embedded error over the tolerance; above 1 (0.2 after an event): rejected."""
    if not run.has_table("steps"):
        return
    s, errors = run.steps, numpy.array(replay_of(run).errors)
    # at an event the last digit of the pressure decides whether the contact node counts: 1e-6
    if not numpy.allclose(s["error"], errors, rtol=2e-5, atol=2e-6, equal_nan=True):
        yield "not the error that the replay has"
    modes, allowed = replay_of(run).modes, 1.0
    for i, (error, accepted, reason) in enumerate(zip(s["error"], s["accepted"],
                                                      s["reason"])):
        if i > 0 and modes[i] != modes[i - 1]:
            allowed = 0.2
        if (reason == "tolerance") != (error > allowed):
            yield f"row {i}: {reason} with error {error:g} of {allowed:g}"
        allowed = 1.0 if accepted else allowed


@check("steps.csv/reason", "steps.csv/accepted")
def check_reasons(run):
    """Where the steps end that are said to end at events, outputs, T."""
    if not run.has_table("steps"):
        return
    s, end_time = run.steps, run.settings.number("Time/End time")
    intervals = [run.settings.number(f"Output/{name} interval") for name in
                 ("Fields", "Contact", "Space-time")
                 if run.settings["Output/Land on output times"] == "true"]
    intervals.append(run.settings.number("Output/Period"))
    ends = s["time"] + s["step_size"]
    events = run.events["time"]

    def on_output(time):
        return any(interval and abs(math.remainder(time, interval)) < 1e-9
                   for interval in intervals)

    for i, reason in enumerate(s["reason"]):
        is_known = reason in (("ok", "load", "event", "output", "end") if s["accepted"][i] else
                              ("tolerance", "contact", "failed"))
        near_event = any(abs(ends[i] - events) < 1e-4)
        is_end = abs(ends[i] - end_time) < 1e-9
        if not is_known or reason == "end" and not is_end or reason == "event" and \
                not near_event or reason == "output" and (is_end or
                                                          not on_output(ends[i])):
            yield f"row {i}, reason {reason}"
        if reason == "ok" and (is_end or not is_own_size(s, i, run.settings)):
            yield f"row {i}, reason ok: at T, or not a size of the step control"
        if reason == "contact" and s["reason"][i + 1] not in ("event", "contact"):
            yield f"row {i}: no step to the event follows"
    for time in events[events > 0]:
        row = numpy.argmin(numpy.where(s["accepted"] == 1, abs(ends - time), numpy.inf))
        if s["reason"][row] != "event":
            yield f"no step aims at the event at {time:g}"


def is_own_size(s, i, settings):
    """True for a power of 2^(1/4), (M.31), or the end of a fixed step."""
    if settings["Time/Step size"] == "automatic":
        number = 4 * math.log2(s["step_size"][i])
    else:
        number = (s["time"][i] + s["step_size"][i]) / settings.number("Time/Step size")
    return abs(number - round(number)) < 1e-9


@check("steps.csv/wall_seconds")
def check_wall_seconds(run):
    """Their sum is that of the summary."""
    if not run.has_table("steps"):
        return
    wall = run.steps["wall_seconds"]
    if (wall <= 0).any():
        yield "not positive"
    yield differences([wall.sum()], [run.summary["step_seconds"]], 1e-4)
