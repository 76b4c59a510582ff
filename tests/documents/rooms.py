# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: rooms.py PROJECT [PROGRAM]
#
# The order of the rooms stands once, in the table of doc/architecture.md: a
# file may include what is in its own room and in the rooms above it. Fails on
# an include that goes down the table, on a folder that the table does not name
# and the reverse, and on a header of another room whose path is not spelled
# out. Rooms are compiled together, so a function in an anonymous namespace has a
# name that no other one has: an overload that a file did not mean would be called.
# Begins with a test of itself, on a tree with a wrong include.

import pathlib
import re
import sys
import tempfile

TOP = "(top)"


def read_order(page):
    """The rooms, from the top of the table to its end."""
    section = re.search(r"^## Rooms$(.*?)(?=^## |\Z)", page, re.M | re.S)
    rows = re.findall(r"^\| `([a-z]+)` \|", section[1] if section else "", re.M)
    return rows + [TOP]


def room_of(path, root):
    parts = path.relative_to(root).parts
    return parts[0] if len(parts) > 1 else TOP


def faults_of(project):
    faults = []
    order = read_order((project / "doc/architecture.md").read_text())
    if len(order) < 3:
        return ["doc/architecture.md: no table of rooms"]
    headers = project / "include/thermocontact"
    sources = project / "source"
    folders = {p.name for root in (headers, sources) for p in root.iterdir()
               if p.is_dir()}
    for name in sorted(folders.symmetric_difference(order[:-1])):
        faults.append(f"{name}: " + ("a folder that the table of "
                      "doc/architecture.md does not name" if name in folders
                      else "a room of the table without a folder"))
    n_arrows = 0
    for root in (headers, sources):
        for path in sorted(root.rglob("*.[ch]*")):
            here = room_of(path, root)
            for name in re.findall(r'^#include "(.*)"', path.read_text(), re.M):
                faults.append(f'{path.relative_to(project)}: "{name}", say '
                              "<thermocontact/room/file.h>")
            for name in re.findall(r"^#include <thermocontact/(.*)>",
                                   path.read_text(), re.M):
                n_arrows += 1
                if not (headers / name).is_file():
                    faults.append(f"{path.relative_to(project)}: no {name}")
                    continue
                there = room_of(headers / name, headers)
                if (here in order and there in order and
                        order.index(there) > order.index(here)):
                    faults.append(
                        f"{path.relative_to(project)} includes {name}: "
                        f"the room {here} must not know {there}, which is "
                        "below it in doc/architecture.md")
    places = {}
    for path in sorted(sources.rglob("*.cc")):
        for body in re.findall(r"^  namespace\n  \{$(.*?)^  \} // namespace",
                               path.read_text(), re.M | re.S):
            for name in re.findall(r"^    (\w+)\(", body, re.M):
                places.setdefault(name, set()).add(str(path.relative_to(project)))
    if not places:
        faults.append("no function in an anonymous namespace was found")
    faults += [f"{name}(): in {', '.join(sorted(files))}; say what is different"
               for name, files in places.items() if len(files) > 1]
    if n_arrows == 0:
        faults.append("no include was found")
    return faults


def check_self():
    """A tree with one include that goes down, one with a function twice, and one
    without a fault."""
    function = "namespace A\n{\n  namespace\n  {\n    int\n    %s()\n  } // namespace\n}\n"
    for include, name, n_faults in (("low/a.h", "f", 1), ("high/b.h", "f", 0),
                                    ("high/b.h", "g", 1)):
        with tempfile.TemporaryDirectory() as folder:
            project = pathlib.Path(folder)
            for name, text in (
                    ("doc/architecture.md",
                     "## Rooms\n| `high` | x |\n| `low` | x |\n"),
                    ("include/thermocontact/low/a.h", ""),
                    ("include/thermocontact/high/b.h", ""),
                    ("source/low/a.cc",
                     "#include <thermocontact/low/a.h>\n" + function % "g"),
                    ("source/high/b.cc",
                     f"#include <thermocontact/{include}>\n" + function % name)):
                (project / name).parent.mkdir(parents=True, exist_ok=True)
                (project / name).write_text(text)
            if len(faults_of(project)) != n_faults:
                return [f"rooms.py: {include} in room high, {name}(), is not "
                        f"judged right: {faults_of(project)}"]
    return []


faults = check_self() + faults_of(pathlib.Path(sys.argv[1]))
for fault in faults:
    print(fault)
sys.exit(1 if faults else 0)
