#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of study.txt: their first words."""
import sys
from pathlib import Path

for line in (Path(sys.argv[1]) / "study.txt").read_text().splitlines():
    if line:
        print(" ".join(line.split()[:4 if "dofs" in line or line[0] != " " else 1]))
