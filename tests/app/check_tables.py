#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The last displacement of the end x = 0, and the warnings."""
import json
import sys
from pathlib import Path

from run_files import Table

directory = Path(sys.argv[1])
probes = Table(directory / "probes.csv")
print(f"end at {probes['displacement_1'][-1] * 1e6:.9g} um")
print("\n".join(json.loads((directory / "summary.json").read_text())["warnings"]) or "no warnings")
