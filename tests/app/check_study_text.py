#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""study.txt, the table of study.md and the lines of log.txt, recomputed from study.csv.

A table for the runs of a set that differ in the refined entry alone: of the last entry
among step size, tolerance and cells with several numbers, and rates log2(e/e')/log2(N/N')
against N = cells or 1/step size; else the runs are counted. Words of a failed run are
the same in both files, in study.csv on one line. The cheapest run has the least time of those
whose largest error of u(1) is at most Study/Target error.
"""
import itertools
import math
import re
import sys

import numpy

from run_files import Run

REFINABLE = ("Time/Step size", "Time/Tolerance", "Mesh/Cells")
ERRORS = [prefix + name for name in ("displacement_end", "velocity_end",
                                     "contact_force", "temperature_end")
          for prefix in ("", "final ")]


def number(text):
    try:
        return float(text)
    except ValueError:
        return math.nan


def plan_of(text):
    """By set: its entries and the values of each run, the last one varies fastest."""
    for part in text.split(";;"):
        names, values = zip(*(entry.split("=", 1) for entry in part.split(";")))
        choices = [[value.strip() for value in several.split("|")] for several in values]
        yield [name.strip() for name in names], choices, list(itertools.product(*choices))


def rate(error, before, size, size_before):
    """As deal.II prints it; exact results have infinite ones."""
    if error == 0 or before == 0:
        return "inf" if before > 0 else "nan" if error == 0 else "-inf"
    return f"{math.log2(before / error) / math.log2(size / size_before):.2f}"


def table_of(study, runs, sizes, key):
    """The words of a table, line by line."""
    has_errors = not numpy.isnan(study["error_temperature_end"][runs]).all()
    lines = [" ".join([key, "dofs steps solves", *ERRORS * has_errors]).split()]
    for n, i in enumerate(runs):
        words = [f"{sizes[n]:.4f}" if key != "run" else f"{n}"] + [f"{study[name][i]:.0f}"
                                       for name in ("dofs", "steps", "solves")]
        for name in ERRORS * has_errors:
            column = study[re.sub("(final |)", lambda m: m[0].replace(" ", "_") + "error_",
                                  name, count=1)]
            words.append(f"{column[i]:.2e}")
            if key != "run":
                words.append("-" if n == 0 else rate(column[i], column[runs[n - 1]],
                                                     sizes[n], sizes[n - 1]))
        lines.append(words)
    return lines


def text_of(study, settings, messages):
    """The words of study.txt, line by line; messages: of failed runs, by number."""
    lines, first = [], 0
    for names, choices, values in plan_of(settings["Study/Vary"]):
        refined = [name for name, several in zip(names, choices)
                   if name in REFINABLE and len(set(several)) > 1
                   and not any(math.isnan(number(value)) for value in several)]
        order = [name for name in study.names if name in refined]
        refined = order[-1] if order else None
        groups = {}
        for i, chosen in enumerate(values, first):
            name = ", ".join(f"{entry} = {value}" for entry, value in zip(names, chosen)
                             if entry != refined)
            groups.setdefault(name, []).append(i)
        first += len(values)
        for name in sorted(groups):
            lines.append((name or "scene of the file").split())
            done = [i for i in groups[name] if i not in messages]
            for i in groups[name]:
                if i in messages:
                    lines += [line.split() for line in messages[i].splitlines()]
            sizes = [number(study[refined][i]) for i in done] if refined else range(len(done))
            key = refined or "run"
            if refined and not refined.startswith("Mesh/"):
                key, sizes = "1/" + refined, [1 / size for size in sizes]
            if done:
                lines += table_of(study, done, sizes, key)
            lines.append([])
    return lines


def log_lines(study, settings):
    """What log.txt says of the study; times and errors with six digits."""
    is_done = [status == "done" for status in study["status"]]
    yield f"{settings['Title']} study"
    yield f"study {len(study)} runs, {is_done.count(False)} failed"
    runs = [", ".join(map(" = ".join, zip(names, chosen)))
            for names, _, all_chosen in plan_of(settings["Study/Vary"]) for chosen in all_chosen]
    for i, status in enumerate(study["status"]):
        if not is_done[i]:
            yield f"run {i}: {runs[i]}: {' '.join(status.split())}"
    target = number(settings.get("Study/Target error", "0"))
    if not target > 0:
        return
    good = [i for i in range(len(study))
            if is_done[i] and study["error_displacement_end"][i] <= target]
    best = min(good, key=lambda i: study["loop_seconds"][i])
    entries = ", ".join(f"{name} = {study[name][best]}" for name in study.names
                        if "/" in name)
    yield (f"cheapest The cheapest run with an error of displacement_end of at most "
           f"{target:g} has {entries}: error {study['error_displacement_end'][best]:g}, "
           f"{study['solves'][best]:.0f} solves, {study['loop_seconds'][best]:g} s.")


def wrong_cells(run):
    """Of study.md: runs by their files, numbers with six digits, else the words."""
    lines = (run.directory / "study.md").read_text().splitlines()
    head, _, *rows = [[" ".join(word.split()) for word in line.split("|")[1:-1]]
                      for line in lines if line.startswith("|")]
    for i, row in enumerate(rows):
        has_files = (run.directory / f"run-{i}").exists()
        yield from [row[0]] if row[0] != (f"[{i}](run-{i}/)" if has_files else f"{i}") else []
        for name, word in zip(head[1:], row[1:]):
            value = run.study[name][i]
            if word != (" ".join(value.split()) if isinstance(value, str) else f"{value:.6g}"):
                yield f"{name}: {word}"
    if len(rows) != len(run.study) or len(head) < 10:
        yield "rows"


def main():
    run = Run(sys.argv[1])
    study, text = run.study, (run.directory / "study.txt").read_text()
    # a message goes on in lines that begin with blanks
    said = re.findall(r"^failed: .*\n(?:  .*\n)*", text, re.MULTILINE)
    failed = [i for i, status in enumerate(study["status"]) if status != "done"]
    messages = dict(zip(failed, said))
    same = len(said) == len(failed) and all(
        " ".join(study["status"][i].split()) == " ".join(messages[i].split())
        for i in failed)
    rows = (run.directory / "study.csv").read_text().splitlines()
    print("failed runs", len(failed), "with the same words in both files:", same,
          "; a line for each run:", len(rows) == 3 + len(study))

    found = [line.split() for line in text.splitlines()]
    expected = text_of(study, run.settings, messages)
    wrong = [f"{' '.join(a)!r} instead of {' '.join(b)!r}" for a, b in zip(found, expected)
             if [word.replace("-0.00", "0.00") for word in a] !=
             [word.replace("-0.00", "0.00") for word in b]]
    if len(found) != len(expected):
        wrong.append(f"{len(found)} lines instead of {len(expected)}")
    print("study.txt:", "; ".join(wrong) or "as study.csv")

    n = len(study)
    tenths = [k for k in range(1, n + 1) if 10 * k // n != 10 * (k - 1) // n]
    found = re.findall(r"^  run (\d+)/(\d+)  \d+:\d\d left$", run.log, re.MULTILINE)
    is_right = found == [(str(k), str(n)) for k in tenths]
    if n < 10:  # perhaps on two ranks, and two runs have ended since the last look
        is_right = found[-1:] == [(str(n), str(n))] and len(found) == len(set(found))
    print("log.txt, lines at tenths of the runs:", is_right)

    said = " ".join(["", *run.log.split(), ""])
    print("log.txt, study.md:", "; ".join([
        f"no {words!r}" for words in log_lines(study, run.settings) if f" {words} " not in said] +
        list(wrong_cells(run))) or "as study.csv")


main()
