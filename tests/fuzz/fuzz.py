#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: fuzz.py MINUTES FIRST_NUMBER DIRECTORY
       fuzz.py --print NUMBER

Makes parameter files out of those in prm/: entries get values of scene_values.txt and
rod_values.txt or of other files, and about half of the files get faults. Each file has a
number from which --print makes it again. It is read by --check; one in eight of those that
are accepted takes its first steps, too, with all its files, of at most 200 kB, and its
used.prm is read, which has to stay the same.

A file must be accepted or refused with a short message in UTF-8, within 20 seconds.
Everything else is a finding, saved in DIRECTORY as finding-NUMBER.prm and .txt. How often
each entry was in a file that was accepted is in reach.txt there. Exit status 1 if there is
a finding.
"""
import collections
import random
import re
import shutil
import sys
import tempfile
import time
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "app"))
from program import for_all, run, settings  # noqa: E402

PRM = HERE.parents[1] / "prm"
ODD = ["nan", "inf", "-1", "0", "1e300", "1e-300", "1e400", "99999999999", "-0", "1,5", "=",
       "#", "\\", ";", "|", "(", ")", "..", "set", "end", "subsection", "é", "\t", "\x01", "''"]


def entries_of(text):
    """Values by "Section/Entry"; a file without sections has whole paths."""
    section, entries = "", {}
    for line in text.splitlines():
        if match := re.match(r" *subsection (.*)", line):
            section = match[1].strip() + "/"
        elif line.strip() == "end":
            section = ""
        elif match := re.match(r" *set (.*?) *= *([^#]*)", line):
            entries[section + match[1]] = match[2].strip()
    return entries


def with_entries(text, entries):
    """The file with values, each in a section of its own at the end, and not before:
    an entry that is set twice is refused."""
    lines, section, is_left_out, is_open = [], "", False, False
    for line in text.splitlines():
        goes_on = is_left_out and is_open
        if match := re.match(r" *subsection (.*)", line):
            section = match[1].strip() + "/"
        elif line.strip() == "end":
            section = ""
        match = re.match(r" *set (.*?) *=", line)
        is_left_out = goes_on or bool(match) and section + match[1] in entries
        is_open = line.rstrip().endswith("\\")
        if not is_left_out:
            lines.append(line)
    for path, value in entries.items():
        section, _, name = path.rpartition("/")
        lines += [f"subsection {section}", f"  set {name} = {value}", "end"] if section else [
            f"set {name} = {value}"]
    return "\n".join(lines) + "\n"


def listed(name):
    """The groups of entries of a list."""
    lines = [line for line in (HERE / name).read_text().splitlines() if line and line[0] != "#"]
    groups = [[entry.split("=", 1) for entry in line.split(" & ")] for line in lines]
    return [group for entries in groups for group in (
        [dict(entries)] if len(entries) > 1 else
        [{entries[0][0]: value} for value in entries[0][1].split(" // ")])]


class Mutations:
    """Files by number; the first ones of each 1e9 are those of prm/ as they are."""

    def __init__(self):
        self.files = [path.read_text() for path in sorted(PRM.rglob("*.prm"))]
        self.values = {False: listed("scene_values.txt"), True: listed("rod_values.txt")}
        for text in self.files:
            self.values["subsection Rod" in text] += [
                {path: value} for path, value in entries_of(text).items()]
        self.lines = [line for text in self.files for line in text.splitlines()]
        self.tokens = sorted(set(re.findall(r"[\w.]+", " ".join(self.lines)))) + ODD

    def is_valid(self, number):
        return number % 10**9 < len(self.files)

    def make(self, number):
        if self.is_valid(number):
            return self.files[number % 10**9]
        r = random.Random(number)
        text = r.choice(self.files)
        small = {"Mesh/Cells": "3", "Mesh/Degree": "2", "Mesh/Refinements": "0"}
        if "subsection Study" not in text:
            text = with_entries(text, small)
        for _ in range(r.choice([0, 1, 1, 2])):
            text = with_entries(text, r.choice(self.values["subsection Rod" in text]))
        for _ in range(r.choice([0, 0, 0, 1, 1, 2, 4])):
            text = self.with_fault(text, r)
        return text

    def with_fault(self, text, r):
        kind, lines = r.randrange(6), text.split("\n")
        at = r.randrange(len(lines))
        if kind == 0:
            lines.insert(at, r.choice(self.lines))
        elif kind == 1:
            del lines[at]
        elif kind == 2:
            lines[at] = lines[at][:r.randint(0, len(lines[at]))]
        elif kind == 3 and lines[at]:
            place = r.randrange(len(lines[at]))
            lines[at] = lines[at][:place] + r.choice(ODD + ["", chr(r.randint(32, 300))]) + (
                lines[at][place + 1:])
        else:  # a token gives way to another one
            tokens = list(re.finditer(r"[\w.]+", text))
            if tokens:
                begin, end = r.choice(tokens).span()
                return text[:begin] + r.choice(self.tokens) + text[end:]
        return "\n".join(lines)


def fault_of(status, message, allowed):
    """Why a status and its message are a finding, or nothing."""
    if status not in allowed:
        return f"status {status}"
    if status != 0 and not message.strip():
        return f"status {status} without a message"
    if len(message) > 3000 or re.search(r"[^\n -~\u00a0-\U0010ffff]", message):
        return "a long or unprintable message"
    return ""


def first_steps(file, directory):
    """What is wrong with the first steps and with used.prm."""
    out = directory / "out"
    small = settings(["Output/Checkpoint interval=3600"])
    status, _, message = run("--quiet", "--output", out, *small, file, file_size=200_000,
                             seconds=120)
    if fault := fault_of(status, message, (0, 1, 2)):
        return fault, message
    used = out / "used.prm"
    if used.exists() and "subsection Study" not in used.read_text():
        status, _, message = run("--check", used, seconds=20)
        if status != 0:
            return "used.prm is refused", message
    return "", ""


def read(number, mutations, steps=True):
    """Status, a finding or "", the message, the file."""
    text = mutations.make(number)
    with tempfile.TemporaryDirectory() as name:
        directory = Path(name)
        file = directory / "file.prm"
        file.write_text(text, encoding="utf-8")
        status, _, message = run("--check", "--output", directory / "not-made", file, seconds=20)
        finding = fault_of(status, message, (0,) if mutations.is_valid(number) else (0, 2))
        if not finding and len(list(directory.iterdir())) > 1:
            finding = "--check writes a file"
        if not finding and status == 0 and steps and number % 8 == 0:
            finding, message = first_steps(file, directory)
    return status, finding, message, text


def main():
    mutations = Mutations()
    if sys.argv[1] == "--print":
        print(mutations.make(int(sys.argv[2])))
        return 0
    end, number = time.time() + 60 * float(sys.argv[1]), int(sys.argv[2])
    directory = Path(sys.argv[3])
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    counts, reach = collections.Counter(), collections.Counter()
    while time.time() < end:
        for n, (status, finding, message, text) in enumerate(for_all(
                lambda n: read(n, mutations), range(number, number + 100)), number):
            counts["accepted" if status == 0 else "refused"] += 1
            if status == 0:
                reach.update(list(entries_of(text)))
            if finding:
                counts["findings"] += 1
                (directory / f"finding-{n}.prm").write_text(text, encoding="utf-8")
                (directory / f"finding-{n}.txt").write_text(f"{finding}\n{message}\n")
                print(f"finding {n}: {finding}")
        number += 100
        (directory / "reach.txt").write_text("".join(
            f"{times:8} {entry}\n" for entry, times in sorted(reach.items())))
        print(", ".join(f"{word} {times}" for word, times in sorted(counts.items())), flush=True)
    return 1 if counts["findings"] else 0


if __name__ == "__main__":
    sys.exit(main())
