# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: output.py PROJECT PROGRAM

doc/output.md is in the program, and is all of its output: each name in the files of some
scenes has a text there, and each text a name in them. A '*' in a name of the
page stands for what the scene chooses. The recipes of the page read the tables of a scene.
"""
import difflib
import fnmatch
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

project, program = map(Path, sys.argv[1:])
sys.path.append(str(project / "tests/app"))
import program as runs  # noqa: E402

SHORT = {"Time/End time": "0.02", "Time/Step size": "0.01", "Mesh/Cells": "3",
         "Mesh/Degree": "1"}
BODY = {**SHORT, "Dimension": "2", "Mesh/Cells across": "2", "Contact/Gap": "-0.01",
        "Initial values/Displacement": "-0.02*x"}
SCENES = {
    "rod": {**SHORT, "Time/Step size": "automatic", "Output/Probes": "0.5; 1",
            "Output/Space-time interval": "0.01", "Time/End time": "0.2",
            "Output/Error bars": "true"},
    "cooling": {**SHORT, "Boundary/sides/Heat exchange": "1", "Output/Period": "0.01", "Output/Boundaries": "true"},
    "heat": {**SHORT, "Model/Fields": "temperature"},
    "motion": {**SHORT, "Model/Fields": "displacement", "Contact/Condition": "none"},
    "switch": {**SHORT, "Boundary/right/Heat exchange": "1+gap"},
    "damped": {**SHORT, "Contact/Dashpot": "0.5", "Contact/Rear gap": "0.5",
               "Contact/Rear dashpot": "0"},
    "conserving": {**SHORT, "Time/Scheme": "energy conserving"},
    "slow": {**SHORT, "Model/Inertia": "0", "Model/Viscosity": "0",
             "Initial values/Temperature": "theta_A"},
    "strip": {**BODY, "Boundary/sides/Support": "free"},
    "iterative": {**BODY, "Boundary/sides/Support": "free",
                  "Solver/Linear solver": "iterative"},
    "shaped": {**BODY, "Contact/Gap": "0.02+y^2", "Initial values/Displacement": "0"},
    "block": {**BODY, "Dimension": "3", "Contact/Gap": "0.02",
              "Initial values/Displacement": "0"},
    "ram": {**BODY, "Bodies/a/Kind": "rod", "Bodies/b/Kind": "mass", "Time/Scheme": "sdirk2", "Time/Start": "automatic",
            "Initial values/Displacement": "0"},
    "row": {**SHORT, "Time/Step size": "automatic", "Time/Scheme": "box", "Contact/Gap": "0", "Bodies/a/Length": "1",
            "Bodies/b/Length": "1", "Bodies/a/Velocity": "1", "Boundary/left/Support": "free"},
    "units": {**SHORT, **{f"Scales/{name}": "2" for name in (
        "Length", "Time", "Stress", "Area", "Temperature", "Reference temperature")}},
    "study": {**SHORT, "Study/Vary": "Contact/Gap = 0.1 | 0.2",
              "Study/Reference": "Mesh/Degree = 2"},
}
IN_PIECES = re.compile(r'<(?:P)?DataArray [^>]*Name="([^"]+)"')
OF_GRIDS = {"connectivity", "offsets", "types", "Points"}


def tables_of(page):
    """By file, the names and texts of its table."""
    tables = {}
    for part in page.split("\n## ")[1:]:
        rows = re.findall(r"^\| `([^`]+)` \| ([^|]*) \| (.+) \|$", part, re.M)
        tables[part.partition("\n")[0]] = {name: text for name, _, text in rows}
    return tables


def names_in(path):
    if path.suffix == ".csv":
        lines = path.read_text(encoding="utf-8").splitlines()
        return next(line for line in lines if line[0] != "#").split(",")
    if path.suffix == ".json":
        return list(json.loads(path.read_text(encoding="utf-8")))
    text = path.read_bytes().decode("latin1")
    return [name for name in IN_PIECES.findall(text) if name not in OF_GRIDS]


def run(name, entries, directory):
    scene = directory / f"{name}.prm"
    scene.write_text("# " + name + "\n", encoding="utf-8")
    status, _, message = runs.run(
        "--quiet", "--output", directory / name, scene,
        *runs.settings(f"{path}={value}" for path, value in entries.items()))
    return [] if status == 0 else [f"{name}: {message.strip()}"]


def read_by_recipes(page, directory):
    """Faults of the recipes, with each table in the place of contact.csv; without the
    libraries that are not there."""
    for code in re.findall(r"```python\n(.*?)```", page, re.S):
        for path in directory.glob("*.csv"):
            found = {}
            try:
                exec(code.replace("contact.csv", str(path)), found)
            except ImportError:
                continue
            table = found["table"]
            names = getattr(table.dtype, "names", None) if hasattr(table, "dtype") else (
                list(table.columns))
            if list(names) != names_in(path):
                yield f"{path.name}: {code.split()[1]} reads {names}"


page = subprocess.run([program, "--print-output"], check=True, text=True,
                      stdout=subprocess.PIPE).stdout
faults = list(difflib.unified_diff(
    (project / "doc/output.md").read_text(encoding="utf-8").splitlines(),
    page.splitlines(), "doc/output.md", "the program", lineterm="", n=0))
if faults:
    faults.append("remedy:  build the program anew")
tables = tables_of(page)
used = {file: set() for file in tables}
unknown_files = set()
with tempfile.TemporaryDirectory() as scratch:
    for name, entries in SCENES.items():
        faults += run(name, entries, Path(scratch))
        for path in sorted((Path(scratch) / name).rglob("*")):
            # an obstacle that moves has the file of one that rests, for each snapshot
            relative = re.sub(r"fields/obstacle-\d+", "obstacle", str(path.relative_to(Path(scratch) / name)))
            file = next((f for f in tables if fnmatch.fnmatch(relative, f)), None)
            if file is None:
                if path.suffix in (".csv", ".json", ".vtu"):
                    unknown_files.add(relative)
                continue
            for found in names_in(path):
                term = next((t for t in (found, *tables[file])
                             if t in tables[file] and fnmatch.fnmatch(found, t)), None)
                if term is None:
                    faults.append(f"{name}: {relative}: {found} has no text")
                else:
                    used[file].add(term)
    faults += read_by_recipes(page, Path(scratch) / "rod")
faults += [f"{file} has no table" for file in unknown_files]
faults += [f"{file}: {name} never occurs" for file, table in tables.items()
           for name in table if name not in used[file]]
n = sum(map(len, tables.values()))
print(f"{len(SCENES)} scenes, {len(tables)} files, {n} names")
print("\n".join(faults))
sys.exit(1 if faults or n == 0 else 0)
