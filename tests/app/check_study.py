#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts of a study by hand."""
import csv
import os
import sys

STAGES = {"backward euler": 1, "sdirk2": 2, "sdirk3": 3, "sdirk4": 5}
END_TIME = 0.3

with open(os.path.join(sys.argv[1], "study.csv"), newline="") as file:
    rows = list(csv.DictReader(line for line in file if line[0] != "#"))


def as_planned(row):
    """Status and counts of one run."""
    scheme, step = row["Time/Scheme"], row["Time/Step size"]
    if step == "automatic":
        if scheme not in ("sdirk3", "sdirk4"):
            return row["status"].startswith("failed: Time/Step size")
        return (row["status"] == "done" and int(row["solves"]) ==
                STAGES[scheme] * (int(row["steps"]) + int(row["rejected_steps"])))
    steps = round(END_TIME / float(step))
    # sdirk4 takes a step within which the node closes again, by the three stages
    # of sdirk3, of another length: contact begins at most twice
    again, rest = divmod(int(row["solves"]) - STAGES[scheme] * steps, 3)
    return (row["status"] == "done" and int(row["steps"]) == steps
            and int(row["rejected_steps"]) == 0 and rest == 0
            and 0 <= again <= (2 if scheme == "sdirk4" else 0)
            and int(row["factorizations"]) ==
            1 + (scheme == "backward euler") + (again > 0))


print("rows", len(rows), "as planned", sum(map(as_planned, rows)),
      "failed", sum(row["status"] != "done" for row in rows))

print("varied:", *(row["Time/Step size"] for row in rows[:16:4]),
      *(row["Contact/Gap"] for row in rows[:4]))
