#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares the files of each run of a study with those of the same scene run alone.

usage: check_study_alone.py DIR

summary.json and steps.csv are compared without times and memory, and used.prm without
the directory and what makes a study.
"""
import csv
import json
import sys
import tempfile
from pathlib import Path

from program import for_all, run, settings
from run_files import Settings


def without_costs(value):
    """What is left of a summary without times and memory."""
    if isinstance(value, dict):
        return {key: without_costs(item) for key, item in value.items()
                if "seconds" not in key and "memory" not in key}
    return value


def contents(directory):
    """The files by name, as far as they are the same whenever a scene runs."""
    files = {}
    for path in directory.rglob("*"):
        name = str(path.relative_to(directory))
        if name == "summary.json":
            files[name] = without_costs(json.loads(path.read_text()))
        elif name == "steps.csv":
            files[name] = [{key: value for key, value in row.items()
                            if "seconds" not in key} for row in csv.DictReader(
                                line for line in path.open() if line[0] != "#")]
        elif name == "used.prm":
            files[name] = {entry: value for entry, value in Settings(path).items()
                           if entry != "Output/Directory" and "Study/" not in entry}
        elif path.is_file() and name != "log.txt":
            files[name] = path.read_bytes()
    return files


study = Path(sys.argv[1])
rows = list(csv.DictReader(line for line in (study / "study.csv").open()
                           if line[0] != "#"))
scene = Settings(study / "used.prm")


def compare(row):
    """Words on a run."""
    with tempfile.TemporaryDirectory() as name:
        alone = Path(name) / "alone"
        status, _, message = run(
            *settings(f"{path}={row[path]}" for path in scene
                      if row.get(path, scene[path]) != scene[path]),
            *settings(("Study/Vary=", "Study/Keep files=false")),
            "--output", alone, study / "used.prm")
        here = study / f"run-{row['run']}"
        if status != 0:
            return "refused" if row["status"].startswith("failed") else message
        if row["status"] != "done":
            return row["status"]
        mine, its = contents(here), contents(alone)
        return ("the same" if mine == its and "contact.csv" in mine else "different: " +
                ", ".join(sorted(key for key in mine.keys() | its.keys()
                                 if mine.get(key) != its.get(key))))


words = for_all(compare, rows)
for word in sorted(set(words)):
    print(words.count(word), "runs:", word)
