#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Resumes the run of an output directory with other parameters.

usage: check_resume_changes.py DIR

DIR holds a finished run with checkpoints and fixed steps that divide its end
time, so that the longer run passes through the same states.
"""
import csv
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

PROGRAM = os.environ["THERMOCONTACT"]


def start(directory, *options):
    return subprocess.Popen(
        [PROGRAM, "--quiet", "--output", str(directory), *options],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def run(directory, *options):
    process = subprocess.run(
        [PROGRAM, "--quiet", "--output", str(directory), *options],
        capture_output=True, text=True)
    message = process.stderr[process.stderr.find("thermocontact: "):]
    return process.returncode, message.replace(str(directory), "DIR")


def contents(directory):
    return {path: path.read_bytes() for path in directory.rglob("*")
            if path.is_file()}


def refuse(reference, what, *options):
    before = contents(reference)
    status, message = run(reference, "--resume", *options)
    print(f"{what}: status {status}, files untouched",
          int(contents(reference) == before))
    print(message.rstrip())


def numbers_not_refused(reference):
    """Numbers of used.prm that --resume lets change, each alone; end time and intervals
    may change."""
    accepted, section, n_refused = [], "", 0
    for line in (reference / "used.prm").read_text().splitlines():
        if match := re.match(r"subsection (.*)", line):
            section = match[1]
        elif match := re.match(r" *set (.*?) *= *(-?[\d.]+(?:e-?\d+)?)$", line):
            path, value = f"{section}/{match[1]}", float(match[2])
            if path in ("/Dimension", "Time/End time") or "interval" in path:
                continue
            other = f"{value + 1:.0f}" if value == int(value) else f"{1.01 * value!r}"
            status, message = run(reference, "scene.prm", "--resume", "--set",
                                  f"{path}={other}")
            n_refused += status == 2
            if status != 2 or f"{path} = {other}: the checkpoint has" not in message:
                accepted.append(f"{path}={other}: {status}, {message}")
    return ", ".join(accepted) or ("none" if n_refused >= 10 else f"{n_refused} asked")


def rows(directory):
    with open(directory / "contact.csv") as lines:
        return list(csv.reader(line for line in lines if line[0] != "#"))


def extend(reference, prm):
    """Another end time and other intervals: the steps are the same."""
    longer = Path("longer")
    status, _ = run(longer, prm, "--set", "Time/End time=1.5")
    resumed = Path("resumed")
    shutil.copytree(reference, resumed)
    again, _ = run(resumed, prm, "--resume", "--set", "Time/End time=1.5",
                   "--set", "Output/Fields interval=0.5",
                   "--set", "Output/Checkpoint interval=0")
    print("longer:", status, again, "rows", len(rows(resumed)) - 1, "the same",
          int(rows(longer) == rows(resumed)), "snapshots at",
          [line.split('"')[1] for line in
           (resumed / "fields.pvd").read_text().splitlines()
           if "timestep" in line])
    shutil.rmtree(longer)
    shutil.rmtree(resumed)


def lock(prm):
    """A second run in the directory of one that goes on is refused."""
    directory = Path("locked")
    first = start(directory, prm, "--set", "Time/Step size=1e-5")
    while not (directory / "contact.csv").exists() and first.poll() is None:
        time.sleep(0.01)
    status, message = run(directory, prm)
    print(f"second run: status {status}")
    print(message.rstrip())
    first.kill()
    first.communicate()
    status, message = run(directory, prm)
    print(f"after the first was killed: status {status}")
    shutil.rmtree(directory)


def main():
    reference = Path(sys.argv[1])
    prm = str(reference / "used.prm")
    shutil.copy(prm, "scene.prm")
    refuse(reference, "other viscosity", "scene.prm",
           "--set", "Model/Viscosity=0.3")
    refuse(reference, "same viscosity, written otherwise, end time too early",
           "scene.prm", "--set", "Model/Viscosity=2e-1",
           "--set", "Time/End time=0.5")
    refuse(reference, "study", "scene.prm",
           "--set", "Study/Vary=Mesh/Cells = 4 | 8")
    print("other numbers that are not refused:", numbers_not_refused(reference))
    status, message = run(Path("nowhere"), "scene.prm", "--resume")
    print(f"no checkpoint: status {status}, directory",
          int(Path("nowhere").exists()))
    print(message.rstrip())
    extend(reference, "scene.prm")
    lock("scene.prm")
    os.remove("scene.prm")


main()
