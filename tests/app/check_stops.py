#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stops a run after chosen steps and resumes it each time.

usage: check_stops.py DIR

DIR holds a finished run of one process that wrote all steps, and so many probes
that probes.csv is its largest file by far. A limit on the size of files, within
a row of probes.csv, ends the run there; its checkpoints are of each step. What
it computes in the end must be what stands in DIR, byte for byte, with the lines of
log.txt on the result; wall times and memory are left out, and used.prm, which names the
directory.
"""
import csv
import json
import os
import re
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
from contents import contents, different  # noqa: E402
from program import run, settings  # noqa: E402

EACH_STEP = settings(["Output/Checkpoint interval=1e-9"])
AT_THE_END = settings(["Output/Checkpoint interval=3600"])
# where writing a file to the end costs nothing
FAST = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None


def row_ends(path):
    """Offsets behind the rows of the initial state and of each step."""
    ends, offset, is_head = [], 0, True
    for line in path.read_bytes().splitlines(keepends=True):
        offset += len(line)
        if not line.startswith(b"#"):
            if not is_head:
                ends.append(offset)
            is_head = False
    return ends


def table(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(row for row in file if row[0] != "#"))


def chosen_steps(reference, n_steps):
    """After which the run is to be stopped."""
    rows = table(reference / "contact.csv")
    times = [float(row["time"]) for row in rows]
    peak = max(range(len(rows)), key=lambda i: abs(float(rows[i]["contact_force"])))
    chosen = {5, round(0.6 * n_steps), n_steps - 2, peak - 1, peak}
    events = table(reference / "events.csv")
    for event in [*events[:2], *events[-2:]]:
        chosen |= {next((step for step, time in enumerate(times)
                         if time >= float(event["time"]) * (1 - 1e-12)), 0)}
    summary = json.loads((reference / "summary.json").read_text())
    for warning in re.findall(r"\bstep (\d+),", " ".join(summary["warnings"])):
        chosen |= {int(warning) - 1, int(warning)}
    if (reference / "steps.csv").exists():
        step, before_rejections, jumps = 0, [], []
        for attempt in table(reference / "steps.csv"):
            step += attempt["accepted"] == "1"
            jumps += [step] * (attempt["reason"] == "load")
            if attempt["accepted"] == "0" and step > 5:
                before_rejections.append(step)
        for step in before_rejections[:1] + before_rejections[-1:]:
            chosen |= {step, step + 1}
        chosen |= {*jumps[:1], *jumps[-1:]}
    return sorted(step for step in chosen if 5 <= step < n_steps - 1)


def result(directory):
    """The numbers in the last lines of log.txt on contact, the final state, the state of
    rest, and energy but for what rounding leaves of it."""
    log = (directory / "log.txt").read_text(encoding="utf-8")
    lines = [re.findall(rf"^  {title} .*?(?:; defect|$)", log, re.M)[-1:] for title in (
        "contact", "final", "steady", "energy")]
    return [float(word) for line in lines for word in re.findall(
        r"-?\d+\.?\d*(?:e-?\d+)?(?!\d*\))", " ".join(line))]


def newest_step(directory):
    with open(directory / "checkpoint.bin", "rb") as file:
        file.readline()
        file.readline()
        return json.loads(file.readline())["step"]


def main():
    reference = Path(sys.argv[1])
    expected = contents(reference)
    ends = row_ends(reference / "probes.csv")
    steps = chosen_steps(reference, len(ends) - 1)
    faults = []
    with tempfile.TemporaryDirectory(dir=FAST) as parent:
        directory = Path(parent) / "stopped"
        resume = []
        for step in steps:
            status, _, message = run(
                "--quiet", "--output", directory, *resume, *EACH_STEP,
                reference / "used.prm",
                file_size=(ends[step] + ends[step + 1]) // 2)
            if status != 1 or newest_step(directory) != step:
                faults.append(f"stop after step {step}: status {status}, "
                              f"{message}")
            resume = ["--resume"]
        for what in ("resumed", "resumed when it was done"):
            status, _, message = run("--quiet", "--output", directory, *resume,
                                     *AT_THE_END, reference / "used.prm")
            faults += [f"{what}: {name}" for name in different(expected, directory)]
            found, wanted = result(directory), result(reference)
            if what == "resumed" and (len(found) != len(wanted) or any(
                    abs(a - b) > 1e-12 * max(map(abs, wanted)) for a, b in zip(found, wanted))):
                faults.append(f"log.txt: {found}, not {wanted}")
            if status != 0:
                faults.append(f"{what}: {message}")
        log = (directory / "log.txt").read_text(encoding="utf-8")
        times = [float(row["time"]) for row in table(reference / "probes.csv")]
        said = re.findall(r"^  resumed +at t = (\S+), step (\d+)$", log, re.M)
        if said != [(f"{times[step]:.6g}", str(step)) for step in [*steps, len(times) - 1]]:
            faults.append(f"log.txt: resumed at {said}")
    print("stopped several times, resumed, and resumed when it was done:"
          if len(steps) > 2 else f"stopped after steps {steps} only:",
          ", ".join(sorted(faults)) or "the same")


main()
