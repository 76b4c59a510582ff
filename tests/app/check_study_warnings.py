#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole texts of the warnings of a study: log.txt, study.md, study.csv and the files of
its runs. The screen shows what log.txt has (app/log)."""
import csv
import json
import sys
from pathlib import Path

FORCE = ("the largest force is that of the mesh: behind an impact on a rigid obstacle the force of a "
         "viscous body grows without limit as cells get smaller; remedy: the impulse, which has a "
         "limit, or Contact/Condition = normal compliance")
BREAK = "Time/Break points = {} is beyond Time/End time = 0.3 and has no effect"
OF_RUN = [[FORCE], [BREAK.format(3), FORCE], [BREAK.format(4), FORCE],
          [], [BREAK.format(3)], [BREAK.format(4)]]
LINES = [f"runs 0 to 2: {FORCE}",
         f"runs 1, 2, 4, 5: {BREAK.format(3)} (numbers of run 1)"]

directory = Path(sys.argv[1])
log = (directory / "log.txt").read_text().splitlines()
page = (directory / "study.md").read_text()
with open(directory / "study.csv", newline="", encoding="utf-8") as file:
    rows = list(csv.DictReader(line for line in file if line[0] != "#"))
summaries = [json.loads((directory / f"run-{i}/summary.json").read_text()) for i in range(6)]

for what, found, expected in (
        ("log.txt", [line[12:] for line in log if line.startswith("  warning:  ")], LINES),
        ("study.md", page.partition("\n## Warnings\n\n")[2].splitlines(),
         [f"* {line}" for line in LINES]),
        ("numbers", [int(row["warnings"]) for row in rows], [len(texts) for texts in OF_RUN]),
        ("texts", [row["warning_texts"] for row in rows], [" | ".join(texts) for texts in OF_RUN]),
        ("summary.json", [summary["warnings"] for summary in summaries], OF_RUN)):
    print(f"{what}:", "as expected" if found == expected else f"{found}, expected {expected}")
