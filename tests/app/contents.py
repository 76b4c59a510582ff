# SPDX-License-Identifier: LGPL-2.1-or-later
"""What two runs have to have in common, for the scripts check_*.py."""
import json


def contents(directory):
    """All that a run computes, by file, and by key of summary.json; without wall times,
    memory, and what tells of the way to the end (log, checkpoints, used.prm)."""
    files = {str(path.relative_to(directory)): path.read_bytes()
             for path in sorted(directory.rglob("*")) if path.is_file() and
             path.name not in ("log.txt", "used.prm") and
             not path.name.startswith("checkpoint")}
    summary = json.loads(files.pop("summary.json"))
    for key, value in summary.items():
        if not key.endswith("_seconds") and not key.startswith("peak_memory_mb"):
            files[f"summary.json: {key}"] = value
    if "steps.csv" in files:  # its last column is wall time
        files["steps.csv"] = [line.rpartition(b",")[0]
                              for line in files["steps.csv"].splitlines()]
    return files


def different(expected, directory):
    """Names of what is not the same in a directory as in expected, the contents() of
    another."""
    found = contents(directory)
    return sorted(name for name in expected.keys() | found.keys()
                  if expected.get(name) != found.get(name))
