# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: faults.py PROJECT PROGRAM

What the faults of tests/mutations replace is in the sources, each exactly once,
and those of a source, which are built together, do not overlap, so that the campaign scripts/mutate can be run at any time.
"""
import sys
from pathlib import Path

project = Path(sys.argv[1])
sys.path.insert(0, str(project / "tests/mutations"))
import faults as lists  # noqa: E402

faults = lists.read_lists(project / "tests/mutations")
wrong = []
for fault in faults:
    try:
        lists.apply([fault], (project / fault.file).read_text())
    except (lists.BadList, OSError) as error:
        wrong.append(str(error))
for path in [] if wrong else sorted({fault.file for fault in faults
                                     if not fault.is_script}):
    try:
        lists.apply([fault for fault in faults if fault.file == path],
                    (project / path).read_text())
    except lists.BadList as error:
        wrong.append(str(error))
print(f"{len(faults)} faults")
print("\n".join(wrong))
sys.exit(1 if wrong or len(faults) < 120 else 0)
