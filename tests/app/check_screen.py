#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the used.prm of an output directory again and looks at the screen.

--quiet, as the driver's run, of which it prints what it says, here nothing: log.txt has the
tenths. Redirected: what log.txt has, with a line for each tenth of the run. A pseudo terminal:
lines that are rewritten in place, within its width, each erased by what follows, no line per
tenth, with the force in contact and else the gap, as in contact.csv; log.txt as before; none on
a terminal that does not tell its width, as that of mpirun, which may lead to a file. A run that
fails: its reason on standard output and standard error, on a terminal once; in log.txt always.
"""
import csv
import fcntl
import json
import os
import pty
import re
import struct
import subprocess
import sys
import termios
from pathlib import Path

directory = Path(sys.argv[1])
fails = ["--set", "Solver/Step solver=fixed point", "--set", "Time/Step size=0.03"]


def command(*options):
    return [os.environ["THERMOCONTACT"], *options, directory / "used.prm"]


def log():
    return (directory / "log.txt").read_text(encoding="utf-8")


def on_terminal(arguments, columns):
    """Everything that a terminal of this width gets."""
    main, terminal = pty.openpty()
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    with subprocess.Popen(arguments, stdout=terminal, stderr=terminal) as process:
        os.close(terminal)
        received = b""
        while True:
            try:
                part = os.read(main, 4096)
            except OSError:
                break
            if not part:
                break
            received += part
        process.wait()
    return received.decode().replace("\r\n", "\n")


def tenths(text):
    return [int(percent) for percent in re.findall(r"^ +(\d+) %   t = ", text, re.MULTILINE)]


SHOWN = {"force": "contact_force", "gap": "gap", "u(1)": "displacement_end",
         "theta(1)": "temperature_end"}


def as_tabled(lines, directory, names=("force", "gap")):
    """Whether the quantity of each live line, one of these names, is that of its row of
    contact.csv, and steps per second times the seconds left are the steps left, but for those
    of a second."""
    with open(directory / "contact.csv", encoding="utf-8") as file:
        rows = {f"{float(row['time']):g}": row for row in
                csv.DictReader(line for line in file if not line.startswith("#"))}
    for line in lines:
        time, name, value, speed, minutes, seconds = re.search(
            r" t (\S+) .* (force|gap|u\(1\)|theta\(1\)) +(\S+) +(\S+) steps/s +(\d+):(\d+) left", line).groups()
        left = 60 * int(minutes) + int(seconds)
        steps = 1e4 - 1e3 * float(time)
        if abs(float(speed) * left - steps) > 0.25 * steps + float(speed):
            return line
        row = rows[time]
        if (name == "force") != (row.get("in_contact") == "1") or name not in names or value != (
                f"{float(row[SHOWN[name]]):g}"):
            return f"{line!r}, {row}"
    return len(lines) > 0


all_tenths = list(range(10, 101, 10))
print("--quiet: tenths in log.txt", tenths(log()) == all_tenths)

plain = subprocess.run(command(), capture_output=True, check=True).stdout.decode()
print("redirected: as log.txt", plain == log(), ", tenths", tenths(plain) == all_tenths,
      ", plain text", "\r" not in plain and "\033" not in plain)

columns = 60
screen = on_terminal(command(), columns)
live = re.findall(r"\r( +\d+ %[^\r\n\033]*)\033\[K", screen)
wide = re.findall(r"\r( +\d+ %[^\r\n\033]*)\033\[K", on_terminal(command(), 200))
kept = re.sub(r"\r[^\r\n\033]*\033\[K", "", screen)
print("terminal: live lines", len(live) > 0 and len(wide) > 0, ", force and gap",
      as_tabled(wide, directory), ", within its width",
      all(len(line) < columns for line in live), ", erased",
      "\r" not in kept and "\033" not in kept and tenths(kept) == [],
      ", tenths in log.txt", tenths(log()) == all_tenths,
      ", live lines in log.txt", "\r" in log() or "steps/s" in log(),
      ", the rest as in log.txt",
      kept.splitlines()[:8] == log().splitlines()[:8])

for name, entry in (("u(1)", "Contact/Condition"), ("theta(1)", "Model/Fields")):
    scene = directory / "other.prm"
    scene.write_text(f"set {entry} = {'none' if name == 'u(1)' else 'temperature'}\n" + "".join(
        f"set {entry} = {value}\n" for entry, value in (
            ("Mesh/Cells", 2500), ("Mesh/Degree", 1), ("Time/Scheme", "backward euler"),
            ("Time/Step size", 1e-3), ("Time/End time", 10), ("Output/Fields interval", 0))))
    wide = re.findall(r"\r( +\d+ %[^\r\n\033]*)\033\[K", on_terminal([
        os.environ["THERMOCONTACT"], "--output", directory / "other", scene], 200))
    print(f"terminal, {name}:", as_tabled(wide, directory / "other", (name,)), end=", ")
    summary = json.loads((directory / "other/summary.json").read_text(encoding="utf-8"))
    print("largest force", summary["max_contact_force"])

screen = on_terminal(command(), 0)
print("terminal without width: as log.txt", screen == log())

failed = subprocess.run(command(*fails), capture_output=True, check=False)
reason = "the fixed point iteration did not converge"
screen = on_terminal(command(*fails), columns)
print("failed, redirected:", failed.returncode, failed.stdout.decode().count(reason),
      failed.stderr.decode().count(reason), "; on a terminal:", screen.count(reason),
      "; in log.txt:", log().count(reason))
