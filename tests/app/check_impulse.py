#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The impulse of a run alone, as check_columns.py checks it."""
import sys

from column_checks import check_impulse
from run_files import Run

faults = [fault for fault in check_impulse(Run(sys.argv[1])) if fault]
print("impulse:", "; ".join(faults) or "as recomputed")
