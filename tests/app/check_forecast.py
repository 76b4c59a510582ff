#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares what was known before a run with its result.

The state of rest, of runs to t = 50 and longer: final u(1), theta(1) and contact force within
1e-6 of it. The first impact, if there was one: its time within 5 per cent, the largest penetration of the first contact within 30
(an experiment with steps of 0.028 is off by 24, the elastic impact on the default mesh by 21); of an elastic rod thrown with
u_1 = x also against its closed form. Steps, rows and snapshots: equal for fixed steps but for a snapshot of the first contact,
with the bytes of these files within a factor of two; steps within a factor of two for error-controlled ones.
"""
import csv
import json
import math
import re
import sys
from pathlib import Path

from check_log import tell
from run_files import Run, Settings, due, with_first_contact


def rows_of(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def verdict(condition, value):
    return "yes" if condition else f"no, {value}"


def bytes_of(words):
    """A number with its unit"""
    number, unit = words.split()
    return float(number) * 1000 ** ["B", "kB", "MB", "GB"].index(unit)


directory = Path(sys.argv[1])
tell(Run(directory), end="; ")
summary = json.loads((directory / "summary.json").read_text(encoding="utf-8"))
rows = rows_of(directory / "contact.csv")
events = rows_of(directory / "events.csv")

if summary["predicted_in_contact"] is None:
    print("rest:", summary["predicted_remark"], end="; ")
elif summary["final_time"] < 50:
    print("rest: not yet" + (", " if summary["predicted_remark"] else "") +
          summary["predicted_remark"], end="; ")
else:
    differences = [abs(summary[name]) for name in
                   ("difference_displacement_end", "difference_temperature_end",
                    "difference_contact_force") if summary[name] is not None]
    same = summary["predicted_in_contact"] == summary["final_in_contact"]
    print("rest:", "in contact" if summary["predicted_in_contact"] else "open",
          "as the run", same, "; within 1e-6:",
          verdict(max(differences) < 1e-6, differences), end="; ")

time, penetration = (summary["predicted_first_contact_time"],
                     summary["predicted_first_penetration"])
begin = next((float(event["time"]) for event in events if event["kind"] == "begin"), None)
if time is None:
    print("impact: no forecast", end="; ")
elif begin is None:
    print("impact: none yet", end="; ")
else:
    end = next((float(event["time"]) for event in events if event["kind"] == "end"), 1e99)
    peak = max(float(row["penetration"]) for row in rows if float(row["time"]) <= end)
    print("impact: time within 5 per cent:",
          verdict(abs(time - begin) < 0.05 * begin, (time, begin)), end="")
    if penetration is not None:
        print("; penetration within 30 per cent:",
              verdict(abs(penetration - peak) < 0.3 * peak, (penetration, peak)), end="")
    print(end="; ")

entries = Settings(directory / "used.prm")
if entries["Mesh/Cells"] == "16":
    print("mesh of the forecast: time and penetration:", verdict(
        abs(time / begin - 1) < 1e-12 and abs(penetration / peak - 1) < 0.02,
        (time / begin - 1, penetration / peak - 1)), end="; ")
if entries["Model/Fields"] == "displacement" and entries.get("Initial values/Velocity") == "x":
    # b = 1: the end moves with 1 - t, and eps p' + p = 1 - t from then on when it arrives
    gap, epsilon = (entries.number("Contact/" + name) for name in ("Gap", "Compliance"))
    arrival = 1 - math.sqrt(1 - 2 * gap)
    top = 1 - arrival - epsilon * math.log((1 - arrival + epsilon) / epsilon)
    print("closed form: time to 0.1 per cent:", verdict(abs(time / arrival - 1) < 1e-3, time),
          "; penetration to 1 per cent:", verdict(abs(penetration / (epsilon * top) - 1) < 0.01,
                                                 penetration), end="; ")

steps, predicted = summary["steps"], summary["predicted_steps"]
log = (directory / "log.txt").read_text(encoding="utf-8")
expected = re.search(r"^  expected  (.*)$", log, re.MULTILINE)
if summary["status"] != "done":
    print("steps: not all")
elif expected[1].startswith("perhaps"):
    # with sources: rougher
    print("steps within a factor of 4:",
          verdict(0.25 < predicted / steps < 4, (predicted, steps)))
elif expected[1].startswith("at least"):
    # a node that bounces takes any number more
    print("steps at least half as many:", verdict(predicted / steps < 2, (predicted, steps)))
elif expected[1].startswith("about"):
    print("steps within a factor of 2:",
          verdict(0.5 < predicted / steps < 2, (predicted, steps)))
else:
    snapshots = list(directory.glob("fields/fields-*.vtu"))
    counts = [int(n) for n in re.findall(r"(\d+) (?:steps|rows|snapshots)", expected[1])]
    run = Run(directory)
    is_due = due(run.contact["time"], run.settings.number("Output/Fields interval"),
                 run.contact["time"][-1])
    n_more = int(sum(with_first_contact(is_due, run.contact, run.events)) - sum(is_due))
    print("steps, rows, snapshots:", verdict(counts == [steps, len(rows)] + [
        len(snapshots) - n_more] * bool(snapshots), counts), end="")
    sizes = zip(re.findall(r"about (\S+ \w+)", expected[1]),
                [[directory / "contact.csv"], snapshots])
    ratios = [bytes_of(words) / sum(file.stat().st_size for file in files)
              for words, files in sizes]
    print("; bytes:", verdict(all(0.5 < ratio < 2 for ratio in ratios), ratios))
