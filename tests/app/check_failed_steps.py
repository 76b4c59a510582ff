#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""steps.csv of a run that fails at the smallest size of its steps, 1e-3, alone or as the
second one of a study."""
import sys
from pathlib import Path

from run_files import Run

directory = Path(sys.argv[1])
kept = directory / "run-1"
run = Run(kept if kept.exists() else directory)
steps, times = run.steps, run.contact["time"]
accepted = steps["accepted"] == 1
last = {name: steps[name][-1] for name in steps.names}
print("failed", run.summary["status"].startswith("failed"), "; attempts accepted:",
      "as rows of contact.csv" if sum(accepted) == len(times) - 1 == run.summary["steps"]
      else f"{sum(accepted)}, rows {len(times)}")
print("last attempt: accepted", last["accepted"] == 1, ", reason", last["reason"],
      ", from the last row", last["time"] == times[-1], ", of the smallest size",
      abs(last["step_size"] - 1e-3) < 1e-15, ", ends after 0.2005",
      last["time"] + last["step_size"] > 0.2005)
