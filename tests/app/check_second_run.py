#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a scene again into the directory of a run, or of a study, that is done.

usage: check_second_run.py DIR
"""
import csv
import sys
from pathlib import Path

from contents import contents, different
from program import run, settings

directory = Path(sys.argv[1])
used = directory / "used.prm"
if (directory / "study.csv").exists():
    status, _, message = run("--quiet", used)
    with open(directory / "study.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(row for row in file if row[0] != "#"))
    print("the study again: status", status, message, *(row["status"] for row in rows))
    Path("rows.csv").write_text("t, F\n0, 1\n2, 2\n")
    Path("scene.prm").write_text(used.read_text())
    status = [run("--quiet", "--output", "first", *settings(
        ["Study/Vary=", "Study/Keep files=false", "Boundary/right/Traction=table(rows.csv, t)"]),
        "scene.prm")[0]]
    Path("rows.csv").unlink()
    status.append(run("--quiet", "--output", "again", "first/used.prm")[0])
    print("with a table, and again without its file: status", *status,
          *different(contents(Path("first")), Path("again")))
(directory / "mine.csv").touch()
scene = Path("scene.prm")
scene.write_text(used.read_text())
status, _, message = run(
    "--quiet", "--output", directory, *settings(
        ["Output/Fields interval=0", "Output/Space-time interval=0",
         "Output/Checkpoint interval=0", "Output/Period=0", "Output/Probes=",
         "Study/Vary=", "Study/Keep files=false"]), scene)
scene.unlink()
print("a small run: status", status, message,
      *sorted(str(path.relative_to(directory)) for path in directory.rglob("*")))
