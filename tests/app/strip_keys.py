# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keys of summary.json of a strip that differ from those of a rod (check_strip.py)."""
import json
import re
import tempfile
from pathlib import Path

from program import run, settings


def check_summary(strip):
    """Keys that differ from those of a rod"""
    s, entries = strip.summary, strip.settings
    along = int(entries["Mesh/Cells"]) * strip.degree + 1
    across = int(entries["Mesh/Cells across"]) * strip.degree + 1
    remark = ("no closed form with sources" if entries["Boundary/right/Traction"] != "0" else
              "no closed form with free lateral faces" if not strip.on_rollers else "")
    c = strip.contact
    expected = {"dimension": 2, "dofs": along * across * (2 + strip.has_heat),
                "predicted_first_contact_time": None, "predicted_steps": float(len(c) - 1),
                "predicted_critical_step_size": None, "predicted_remark": remark,
                "max_contact_force": max(c["contact_force"]),
                "max_penetration": max(c["penetration"])}
    faults = [f"{key} is {s[key]}" for key, value in expected.items() if s[key] != value]
    return faults + check_linear_solver(strip) + check_memory(strip)


def check_memory(strip):
    """Of all ranks: a scene takes more on two than it took on one, in the run before; each
    has its share."""
    memory, ranks = (strip.summary[name] for name in ("peak_memory_mb",
                                                      "peak_memory_mb_per_rank"))
    before = Path("memory_on_one_rank")
    if len(ranks) != strip.summary["ranks"] or abs(sum(ranks) - memory) > 1e-9 * memory:
        return [f"memory {memory} MB, of the ranks {ranks}"]
    if len(ranks) == 1:
        before.write_text(str(memory))
    elif memory < 1.5 * float(before.read_text()):
        return [f"peak memory {memory} MB, on one rank {before.read_text()}"]
    return []


def most_of_two_steps(strip):
    """Largest number of iterations of a run that is ended after two steps"""
    if strip.summary["ranks"] > 1:
        return 0
    with tempfile.TemporaryDirectory() as directory:
        run("--quiet", "--output", directory, *settings(
            ["Time/End time=0.04", "Output/Fields interval=0"]),
            strip.directory / "used.prm")
        summary = json.loads((Path(directory) / "summary.json").read_text())
    return summary["max_linear_iterations"]


def check_linear_solver(strip):
    """A direct solver iterates nothing. An iterative one solves one system for each set
    of contact nodes, and that of the last set again, to the end: between one iteration
    and the largest number for each, which is not less than that of the first two steps;
    backward Euler has one stage in a step, whose sets are in the rows. The same in the
    log."""
    s, entries = strip.summary, strip.settings
    counts = [s[key] for key in ("linear_iterations", "max_linear_iterations",
                                 "active_set_iterations")]
    log = [int(number) for match in re.findall(
        r"^  linear +(\d+) Krylov iterations, at most (\d+) for a system; (\d+) sets",
        strip.log, re.MULTILINE) for number in match]
    if entries.get("Solver/Linear solver", "automatic") != "iterative":
        return [] if (s["linear_solver"], counts, log) == ("direct", [0, 0, 0], []) else [
            f"linear solver {s['linear_solver']} {counts}, log {log}"]
    sets = int(sum(strip.contact["iterations"]))
    systems = sets + s["solves"]
    is_right = (s["linear_solver"] == "iterative" and log == counts and
                counts[2] == sets and counts[1] >= most_of_two_steps(strip) and
                max(systems, counts[1]) <= counts[0] <= systems * counts[1])
    return [] if is_right else [f"linear solver {s['linear_solver']} {counts}, log {log}, "
                                f"{systems} systems, {sets} sets"]
