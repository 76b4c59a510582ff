#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kills a study again and again, goes on with --resume, and compares.

usage: check_study_resume.py DIR

DIR holds a finished study. Kills come at random moments of its first rows, on one and
on two ranks; then the same after SIGTERM, with a row that was cut off, with another scene,
another study and tables of others, which are refused, with a table that is shorter when
it is written anew, with rows that vanish, and with a file that may not grow. All
columns but times have to be those of DIR, and so do study.txt and study.md. THERMOCONTACT_KILLS is the
number of kills, 2 unless it is set.
"""
import csv
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True
import program  # noqa: E402

PROGRAM = os.environ["THERMOCONTACT"]
N_KILLS = int(os.environ.get("THERMOCONTACT_KILLS", "2"))
MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2"]
reference = Path(sys.argv[1])


def rows_of(directory):
    """The rows of study.csv, without times; what is not a whole row has no end."""
    try:
        with open(directory / "study.csv", newline="", encoding="utf-8") as file:
            lines = [line for line in file if line[0] != "#" and line.endswith("\n")]
    except FileNotFoundError:
        return []
    return [{key: value for key, value in row.items() if "seconds" not in key}
            for row in csv.DictReader(lines)]


def contents(directory):
    return [rows_of(directory), (directory / "study.txt").read_text(),
            (directory / "study.md").read_text()]


def words(directory, *options):
    if (directory / "used.prm").exists():
        options += ("--resume",)
    return "--quiet", "--output", str(directory), *options, str(reference / "used.prm")


def start(directory, ranks=1):
    return program.start([*(MPIRUN if ranks == 2 else []), PROGRAM, *words(directory)])


def finish(directory, *options, **limits):
    status = program.status_of(words(directory, *options), "/dev/null", "said", **limits)
    message = Path("said").read_text()
    return status, message[message.find("thermocontact: "):]


def wait_for_rows(process, directory, n):
    while len(rows_of(directory)) < n and process.poll() is None:
        time.sleep(0.01)


def compare(directory):
    return "the same" if contents(directory) == contents(reference) else "different"


def kill_again_and_again(directory):
    """Kills until there have been enough; a study that is done begins anew."""
    n_kills, n_lost = 0, 0
    for i in range(5 * N_KILLS):
        if n_kills == N_KILLS:
            break
        before = len(rows_of(directory))
        if before > len(rows_of(reference)) - 4:
            shutil.rmtree(directory)
            before = 0
        process = start(directory, ranks=1 + i % 2)
        wait_for_rows(process, directory, before + 1)
        time.sleep(random.uniform(0, 0.1))
        if process.poll() is None:
            program.kill(process)
            n_kills += 1
        process.communicate()
        n_lost += len(rows_of(directory)) <= before
    process = start(directory, ranks=2)
    process.communicate()
    print(f"killed {n_kills} times, {n_lost} times without a new row, resumed: status "
          f"{process.returncode},", compare(directory))


def terminate(directory):
    process = start(directory)
    wait_for_rows(process, directory, 1)
    process.send_signal(signal.SIGHUP)
    message = process.communicate()[1]
    n_rows = len(rows_of(directory))
    print("SIGHUP: status", process.returncode, "said",
          int(f"SIGHUP: {n_rows} of {len(rows_of(reference))} runs" in message))
    command = message.partition("resume:  ")[2].strip()
    status = subprocess.run(command + " --quiet", shell=True, check=False).returncode
    print(f"resumed by its command: status {status},", compare(directory))


def cut_off(directory):
    """Half of the last row, as on a full disk; rows in another order."""
    path = directory / "study.csv"
    lines = path.read_text().splitlines(keepends=True)
    lines[3:] = lines[:2:-1]
    path.write_text("".join(lines)[:-40])
    status, _ = finish(directory)
    print(f"a row cut off: status {status},", compare(directory))


def shorten(directory):
    """The table becomes shorter when it is written anew: a title goes, and a row whose
    middle was never written, with the next one on its line."""
    path = directory / "study.csv"
    lines = path.read_text().splitlines(keepends=True)
    path.write_text("# a title of many words\n" * 20 + "".join(lines[:-3]))
    before = directory / "before.csv"
    before.hardlink_to(path)  # the old table, if the new one takes its place
    status, _ = finish(directory)
    print(f"title and rows gone: status {status},", compare(directory), "in another file",
          "a title" in before.read_text())
    lines[-5] = lines[-5][:30]
    path.write_text("".join(lines))
    status, _ = finish(directory)
    print(f"a row broken in the middle: status {status},", compare(directory))


def lose_rows(directory):
    """Rows vanish while the study runs, as where ranks append to a file of another
    machine: those that follow stand before the place that was read to."""
    process = start(directory)
    wait_for_rows(process, directory, 3)
    with open(directory / "study.csv", "r+", encoding="utf-8") as file:
        lines = file.readlines()
        file.truncate(sum(len(line) for line in lines if line[0] == "#" or "status" in line))
    message = process.communicate()[1]
    print("rows lost: status", process.returncode, "said",
          int("runs that have ended are not there" in message))
    status, _ = finish(directory)
    print(f"resumed: status {status},", compare(directory))


def keep_files(directory):
    """Files from now on: study.md links to those runs that have some."""
    path = directory / "study.csv"
    path.write_text("".join(path.read_text().splitlines(keepends=True)[:-2]))
    status, _ = finish(directory, "--set", "Study/Keep files=true")
    text = (directory / "study.md").read_text()
    linked = [int(run) for run in re.findall(r"\(run-(\d+)/\)", text)]
    there = sorted(int(folder.name[4:]) for folder in directory.glob("run-*"))
    print(f"files of the last runs alone: status {status}, links {len(linked)}, to what is "
          f"there {int(linked == there)}")
    for folder in directory.glob("run-*"):
        shutil.rmtree(folder)


def refuse(directory):
    before = (directory / "study.csv").read_bytes()
    for option in ("Model/Viscosity=0.5", "Study/Vary=Contact/Gap=0.1|0.2",
                   "Study/Reference=Time/Tolerance=1e-6", "Study/Repetitions=2"):
        status, message = finish(directory, "--set", option)
        print(f"{option}: status {status}, unharmed",
              int((directory / "study.csv").read_bytes() == before))
        print("\n".join(message.splitlines()[:2]))
        status, checked = finish(directory, "--check", "--set", option)
        print(f"the same of --check: {int(status == 2 and checked == message)}")
    for change, what in ((lambda text: text.replace("run,", "runs,", 1), "columns"),
                         (lambda text: text.replace("\n3,1,", "\n3,2,"), "entries"),
                         (lambda text: text.replace("\n3,1,", "\n20,1,"), "numbers")):
        (directory / "study.csv").write_text(change(before.decode()))
        status, message = finish(directory)
        print(f"study.csv with other {what}: status {status}")
        print(message.strip())
    (directory / "study.csv").write_bytes(before)
    (directory / "used.prm").unlink()
    status, message = finish(directory, "--resume")
    print(f"no used.prm: status {status}")
    print(message.strip())


def let_no_file_grow(directory):
    limit = (reference / "study.csv").stat().st_size - 600
    status, message = finish(directory, file_size=limit)
    print("files may not grow: status", status, "named",
          int("study.csv: cannot be written" in message))
    status, _ = finish(directory)
    print(f"resumed: status {status},", compare(directory))


for name in ("killed", "termi nated", "limited", "lost"):
    shutil.rmtree(name, ignore_errors=True)
kill_again_and_again(Path("killed"))
terminate(Path("termi nated"))
cut_off(Path("termi nated"))
shorten(Path("termi nated"))
keep_files(Path("termi nated"))
lose_rows(Path("lost"))
refuse(Path("termi nated"))
let_no_file_grow(Path("limited"))
