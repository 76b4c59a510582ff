#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recomputes all columns of study.csv from the files that its runs kept.

Varied entries: used.prm of the run, and all combinations of Study/Vary. Counts: summary.json of the run. Errors:
the largest and the last difference of its contact.csv from that of the run that is the
reference's twin (its entries are those of Study/Reference), both with fixed steps whose
ends are ends of steps of the reference. Then each column is falsified, as in
falsify.py; not noticed are wall times times 1.001 or in another order.
"""
import itertools
import math
import re
import sys

import numpy

from falsify import Checks, report
from properties import Scene, top_of_cubics
from run_files import Run, differences

QUANTITIES = ("displacement_end", "velocity_end", "contact_force", "temperature_end",
              "energy")
KEY_RESULTS = ("first_contact_time", "max_contact_force", "max_penetration",
               "contact_impulse", "final_displacement_end", "final_temperature_end",
               "contact_begins", "contact_duration", "restitution",
               "reached_state_of_rest", "final_contact_force")
EXEMPT = {(f"study.csv/{name}", way) for name in ("loop_seconds", "loop_seconds_median")
          for way in ("times 1.001", "one row late", "one row early")}

check = Checks()
kept = {}


def runs_of(study):
    """The kept runs, None for one that failed."""
    if not kept:
        for i in range(len(study.study)):
            directory = study.directory / f"run-{i}"
            kept[i] = (Run(directory) if (directory / "contact.csv").exists() else None)
    return kept


def reference_of(study):
    """The run with the entries of Study/Reference, or None"""
    entries = dict(re.findall(r"([^;=]+?) *= *([^;]*?) *(?:;|$) *",
                              study.settings.get("Study/Reference", "none")))
    for run in runs_of(study).values():
        if entries and run and all(run.settings[name] == value
                                   for name, value in entries.items()):
            return run
    return None


def combinations(settings):
    """The entries of all runs: sets after ;;, the last entry of a set varies fastest."""
    plan = []
    for text in settings["Study/Vary"].split(";;"):
        pairs = [part.split("=", 1) for part in text.split(";")]
        choices = [[value.strip() for value in values.split("|")] for _, values in pairs]
        plan += [settings | {name.strip(): value for (name, _), value in
                             zip(pairs, values)} for values in itertools.product(*choices)]
    return plan


def column(study, name, value, bound=0.0):
    """The fault of a column against a function of the kept runs; failed ones have NaN."""
    expected = [math.nan if run is None else value(run) for run in runs_of(study).values()]
    fault = differences(study.study[name], expected, bound)
    yield fault and f"{name}: {fault}"


@check("study.csv/run", "study.csv/status", "study.csv/*")
def check_runs(study):
    """Numbers from zero; entries as used; failed runs left no rows and a reason."""
    table, runs = study.study, runs_of(study)
    yield differences(table["run"], range(len(table)), 0)
    plan = combinations(study.settings)
    varied = {name.strip() for name in re.findall(r"([^;=]+)=", study.settings["Study/Vary"])}
    if varied != {name for name in table.names if "/" in name}:
        yield "not the columns of Study/Vary"
    for name in table.names:
        if "/" in name:
            if table[name] != [entries[name] for entries in plan]:
                yield f"{name} is not as in Study/Vary"
            for i, run in runs.items():
                if run and table[name][i] != run.settings[name]:
                    yield f"{name} of run {i}"
    for i, run in runs.items():
        is_done = run is not None and run.contact["time"][-1] == run.settings.number(
            "Time/End time")
        expected = "done" if is_done else tuple(
            f"failed: {name} = {table[name][i]}" for name in varied)
        if not table["status"][i].startswith(expected):
            yield f"status of run {i}"


@check(*(f"study.csv/{name}" for name in ("dofs", "steps", "rejected_steps",
                                          "factorizations", "solves")))
def check_counts(study):
    """Those of the runs; of a failed run zeros"""
    for name, value in (
            ("dofs", lambda run: 2 * (int(run.settings["Mesh/Cells"]) * int(
                run.settings["Mesh/Degree"]) + 1)),
            ("steps", lambda run: len(run.contact) - 1),
            ("rejected_steps", lambda run: sum(run.steps["accepted"] == 0)
             if run.has_table("steps") else 0),
            ("factorizations", lambda run: run.summary["factorizations"]),
            ("solves", lambda run: run.summary["solves"])):
        expected = [0 if run is None else value(run) for run in runs_of(study).values()]
        fault = differences(study.study[name], expected, 0)
        yield fault and f"{name}: {fault}"


def errors(run, reference, quantity):
    """Absolute differences at the ends of the steps, which the reference has, too."""
    there = reference.contact["time"]
    rows = abs(there[:, None] - run.contact["time"]).argmin(axis=0)
    assert numpy.allclose(there[rows], run.contact["time"], rtol=0, atol=1e-12)
    return abs(run.contact[quantity] - reference.contact[quantity][rows])[1:]


@check(*(f"study.csv/{prefix}error_{name}" for name in QUANTITIES
         for prefix in ("", "final_")))
def check_errors(study):
    """Largest and last difference, bound 1e-9 of the largest of all runs"""
    reference, t = reference_of(study), study.study
    for name in QUANTITIES:
        if reference is None:
            yield from column(study, "error_" + name, lambda run: math.nan)
            yield from column(study, "final_error_" + name, lambda run: math.nan)
            continue
        yield from column(study, "error_" + name,
                          lambda run: max(errors(run, reference, name)), 1e-9)
        yield from column(study, "final_error_" + name,
                          lambda run: errors(run, reference, name)[-1], 1e-9)
        if (t["error_" + name] < t["final_error_" + name]).any():
            yield f"{name}: the largest error is less than the last one"


@check("study.csv/error_first_contact_time")
def check_first_contact(study):
    """The difference of the first times of events.csv"""
    reference = reference_of(study)
    yield from column(study, "error_first_contact_time",
                      lambda run: abs(first_contact(run) - first_contact(reference))
                      if reference else math.nan, 1e-9)


def first_contact(run):
    return run.events["time"][0] if len(run.events) else math.nan


@check("study.csv/loop_seconds", "study.csv/loop_seconds_median")
def check_times(study):
    """The least and the median time: equal for one repetition"""
    least, median = study.study["loop_seconds"], study.study["loop_seconds_median"]
    done = numpy.array([run is not None for run in runs_of(study).values()])
    if not (numpy.isnan(least) == ~done).all() or not (numpy.isnan(median) == ~done).all():
        yield "a time of a failed run, or none of another"
    if (least[done] <= 0).any() or (median[done] < least[done]).any():
        yield "not the least of positive times"
    if study.settings.number("Study/Repetitions") == 1:
        yield differences(median, least, 0)


@check(*(f"study.csv/{name}" for name in KEY_RESULTS))
def check_key_results(study):
    """Maxima and last values of contact.csv, which has a row for each step"""
    for name, value in zip(KEY_RESULTS, (
            first_contact, lambda run: largest(run, "contact_force"),
            lambda run: largest(run, "penetration"),
            lambda run: run.contact["contact_impulse"][-1],
            lambda run: run.contact["displacement_end"][-1],
            lambda run: run.contact["temperature_end"][-1],
            lambda run: run.events["kind"].count("begin") if len(run.events) else 0,
            duration, restitution, state_of_rest,
            lambda run: run.contact["contact_force"][-1])):
        yield from column(study, name, value, 1e-9)


@check("study.csv/warnings", "study.csv/warning_texts")
def check_warnings(study):
    """Those of summary.json of the runs"""
    told = [run.summary["warnings"] if run else [] for run in runs_of(study).values()]
    yield differences(study.study["warnings"], [len(texts) for texts in told], 0)
    if list(study.study["warning_texts"]) != [" | ".join(texts) for texts in told]:
        yield "other warnings"


def largest(run, name):
    """At the ends of steps, and between them where rates are known; linear laws"""
    rows = max(run.contact[name])
    return max(rows, top_of_cubics(run.contact, name, 1)) if Scene(
        run).has_rates_of_force else rows


def duration(run):
    """From begins to ends of contact, or to the end of the run"""
    signs = {"begin": -1, "end": 1}
    times = [signs[kind] * time for kind, time in zip(run.events["kind"],
                                                      run.events["time"])] if len(
                                                          run.events) else []
    return sum(times) + run.contact["in_contact"][-1] * run.contact["time"][-1]


def restitution(run):
    """The velocity of the last release over that of the first impact, positive"""
    events = list(zip(run.events["kind"], run.events["velocity"])) if len(
        run.events) else []
    impact = next((v for kind, v in events if kind == "begin"), math.nan)
    release = next((v for kind, v in events[::-1] if kind == "end"), math.nan)
    return -release / impact if impact > 0 else math.nan


def state_of_rest(run):
    """1 if the end has come to (M3.1): its temperature but for 1e-3 of the outer
    difference, its displacement but for 1e-3 of itself or the gap; else none"""
    s = run.settings
    inner, outer, k = (s.number("Boundary/" + name) for name in (
        "left/Temperature", "right/Surroundings", "right/Heat exchange"))
    drop = k / (1 + k) * (inner - outer)
    g, epsilon = s.number("Contact/Gap"), s.number("Contact/Compliance")
    free = s.number("Model/Coupling") * (inner - drop / 2)
    rest = free - max(0, (free - g) / (1 + epsilon))
    end = {name: run.contact[name][-1] for name in ("temperature_end", "displacement_end")}
    is_there = abs(end["temperature_end"] - inner + drop) <= 1e-3 * abs(inner - outer) and \
        abs(end["displacement_end"] - rest) <= 1e-3 * max(g, abs(rest))
    return 1.0 if is_there else math.nan


def named_faults(study):
    """The last errors in place of the largest, quantity by quantity"""
    if reference_of(study):
        for name in QUANTITIES:
            other = study.copy()
            other.study.columns["error_" + name] = study.study["final_error_" + name]
            yield f"maximum of {name} at T", other


study_run = Run(sys.argv[1])
done_runs = [run for run in runs_of(study_run).values() if run]
print(f"runs {len(study_run.study)}, done {len(done_runs)}, with contact "
      f"{sum(len(run.events) > 0 for run in done_runs)}, rejected steps "
      f"{any(study_run.study['rejected_steps'] > 0)}")
report(check, study_run, EXEMPT, named_faults,
       "1e-9")
