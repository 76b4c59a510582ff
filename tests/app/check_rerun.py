#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the used.prm of an output directory again; all files must be the same.

log.txt and summary.json hold times and are left out.
"""
import os
import subprocess
import sys
from pathlib import Path


def contents(directory):
    return {path.name: path.read_bytes()
            for path in directory.rglob("*")
            if path.is_file() and path.name not in ("log.txt", "summary.json")}


directory = Path(sys.argv[1])
before = contents(directory)
subprocess.run([os.environ["THERMOCONTACT"], "--quiet", directory / "used.prm"],
               check=True)
after = contents(directory)
print(f"files {len(before)}, the same after running used.prm again "
      f"{int(before == after)}")
