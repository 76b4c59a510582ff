#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_notebook.py THERMOCONTACT SOURCE_DIRECTORY

Runs the cells of doc/fit-of-a-stop.ipynb one after the other. The fit has to find the
stiffness of the obstacle that the measurement was made with, 1e8 N/m, within four times the
error that it states, which is to be below one percent; the page has to say so on its
last line. Exit status 77, "skipped", without scipy or
matplotlib.
"""
import contextlib
import io
import json
import os
import re
import sys
from pathlib import Path

program, source = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
try:
    import matplotlib  # noqa: F401
    import scipy.optimize  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

os.environ |= {"THERMOCONTACT": str(source / "tests/app/program.py"),
               "THERMOCONTACT_PROGRAM": str(program)}
os.chdir(source / "doc")
sys.path.insert(0, str(source / "python"))
cells = json.loads(Path("fit-of-a-stop.ipynb").read_text(encoding="utf-8"))["cells"]
names, said = {}, io.StringIO()
with contextlib.redirect_stdout(said):
    for number, cell in enumerate(cells):
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), f"cell {number}", "exec"), names)
line = said.getvalue().splitlines()[-1]
value, error = map(float, re.fullmatch(
    r"stiffness of the obstacle (\S+) N/m, plus or minus (\S+)", line).groups())
print(line)
good = abs(value - 1e8) <= 4 * error + 1e5 and error < 1e6  # four digits are printed
sys.exit(not good)
