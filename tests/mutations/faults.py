# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lists of faults, and how one is put into a text.

A list has entries such as

  [peak_force_one_step_late]
  file     source/simulation/run_history.cc
  find     std::max(max_contact_force, record.contact_force)
  fault    std::max(max_contact_force, old_force)
  tests    app/columns app/study

find: what stands there, once in the file; white space counts as one blank.
fault: the expression that stands there instead if the fault is switched on; the one
in 'find' is put in brackets, and so must be one: not b - c of a - b - c.
replace: instead of fault, the whole text; FAULT is whether the fault is switched
on, FIND what stood there. Scripts are not built: both replace the text.
tests: regular expressions of the names of tests that should notice.
equivalent: why no test can notice.
survives: why no test notices.
A line that begins with a blank goes on with the one before.
"""
import re
from dataclasses import dataclass, field
from pathlib import Path

KEYS = {"file", "find", "fault", "replace", "tests", "equivalent", "survives"}


class BadList(Exception):
    """A fault of a list, to be mended there."""


@dataclass
class Fault:
    name: str
    room: str
    entries: dict = field(default_factory=dict)

    @property
    def file(self):
        return self.entries["file"]

    @property
    def is_script(self):
        return self.file.startswith("scripts/")

    @property
    def reason(self):
        """Why it survives; empty if that is not explained."""
        return self.entries.get("equivalent") or self.entries.get("survives", "")

    def place(self, text):
        """Begin and end of what it replaces."""
        words = self.entries["find"].split()
        found = list(re.finditer(r"\s+".join(map(re.escape, words)), text))
        if len(found) != 1:
            raise BadList(f"{self.room}.txt: {self.name}: 'find' occurs "
                          f"{len(found)} times in {self.file}, not once")
        return found[0].span()

    def replacement(self, found):
        """What stands there with the fault."""
        fault, whole = self.entries.get("fault"), self.entries.get("replace")
        if self.is_script:
            return fault if whole is None else whole.replace("FIND", found)
        switch = f'THERMOCONTACT_FAULT("{self.name}")'
        if whole is None:
            return f"({switch} ? ({fault}) : ({found}))"
        return re.sub(r"\bFAULT\b|\bFIND\b", lambda match: {
            "FAULT": switch, "FIND": found}[match[0]], whole)


def read_list(path):
    faults, last = [], None
    for n, line in enumerate(path.read_text().splitlines(), 1):
        if line.startswith("["):
            faults.append(Fault(line.strip("[] "), path.stem))
        elif line.startswith(" ") and last and faults:
            faults[-1].entries[last] += "\n" + line.strip()
        elif line.strip() and not line.startswith("#"):
            last, _, value = line.partition(" ")
            if last not in KEYS or not faults:
                raise BadList(f"{path.name}:{n}: no such key: {last}")
            faults[-1].entries[last] = value.strip()
    return faults


def read_lists(folder):
    faults = [fault for path in sorted(Path(folder).glob("*.txt"))
              for fault in read_list(path)]
    for fault in faults:
        keys = set(fault.entries)
        if not {"file", "find", "tests"} <= keys or \
                len({"fault", "replace"} & keys) != 1:
            raise BadList(f"{fault.room}.txt: {fault.name}: needs file, find, "
                          "tests, and fault or replace")
        if "fault" in keys and not fault.is_script and any(
                fault.entries[key].endswith((",", ":", ";", "?"))
                for key in ("find", "fault")):
            raise BadList(f"{fault.room}.txt: {fault.name}: 'find' and 'fault' "
                          "are to be expressions, in which brackets can be put")
        if sum(other.name == fault.name for other in faults) > 1:
            raise BadList(f"two faults are called {fault.name}")
    return faults


def apply(faults, text):
    """The text with all these faults, each of which replaces its own place."""
    places = sorted(((*fault.place(text), fault) for fault in faults),
                    key=lambda place: place[:2])
    for (_, end, first), (begin, _, second) in zip(places, places[1:]):
        if begin < end:
            raise BadList(f"{first.name} and {second.name} replace the same")
    for begin, end, fault in reversed(places):
        text = text[:begin] + fault.replacement(text[begin:end]) + text[end:]
    return text
