# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: parameters.py PROJECT PROGRAM

doc/parameters.md is what the program says of its parameters, and each entry
is in it once.
"""
import difflib
import subprocess
import sys
from pathlib import Path

project, program = map(Path, sys.argv[1:])


def output(*options):
    return subprocess.run([program, *options], check=True, text=True,
                          stdout=subprocess.PIPE).stdout


page = project / "doc/parameters.md"
expected = output("--print-parameters=markdown")
n_entries = sum(line.strip().startswith("set ")
                for line in output("--print-parameters").splitlines())
n_rows = expected.count("\n| `")
print(f"{n_entries} entries, {n_rows} rows")
difference = list(difflib.unified_diff(
    page.read_text().splitlines(), expected.splitlines(), "doc/parameters.md",
    "the program", lineterm="", n=0))
if difference:
    print("\n".join(difference))
    print("remedy:  scripts/run --print-parameters=markdown > doc/parameters.md")
sys.exit(1 if difference or n_entries != n_rows or n_rows == 0 else 0)
