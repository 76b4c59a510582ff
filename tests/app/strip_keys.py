# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keys of summary.json that differ from those of a rod, for check_strip.py.

Expected are the number of unknowns of the mesh, what a forecast of a body can and cannot
say, maxima over the rows of contact.csv, and counts of the linear solver within the
bounds that its algorithm sets.
"""
import re


def summary_faults(strip):
    """Keys that differ from those of a rod"""
    s, settings = strip.summary, strip.settings
    along = int(settings["Mesh/Cells"]) * strip.degree + 1
    across = int(settings["Mesh/Cells across"]) * strip.degree + 1
    remark = ("no closed form with sources" if settings["Sources/End traction"] != "0" else
              "no closed form with free lateral faces" if not strip.on_rollers else "")
    c = strip.contact
    expected = {"dimension": 2, "dofs": along * across * (2 + strip.has_heat),
                "predicted_first_contact_time": None, "predicted_steps": float(len(c) - 1),
                "predicted_critical_step_size": None, "predicted_remark": remark,
                "max_contact_force": max(c["contact_force"]),
                "max_penetration": max(c["penetration"])}
    faults = [f"{key} is {s[key]}" for key, value in expected.items() if s[key] != value]
    return faults + linear_solver_faults(strip)


def linear_solver_faults(strip):
    """A direct solver iterates nothing. An iterative one solves one system for each set
    of contact nodes, and that of the last set again, to the end: between one iteration
    and the largest number for each; backward Euler has one stage in a step, whose sets
    are in the rows. The same in the log."""
    s, settings = strip.summary, strip.settings
    counts = [s[key] for key in ("linear_iterations", "max_linear_iterations",
                                 "active_set_iterations")]
    log = [int(number) for match in re.findall(
        r"^  linear +(\d+) Krylov iterations, at most (\d+) for a system; (\d+) sets",
        strip.log, re.MULTILINE) for number in match]
    if settings.get("Solver/Linear solver", "automatic") != "iterative":
        return [] if (s["linear_solver"], counts, log) == ("direct", [0, 0, 0], []) else [
            f"linear solver {s['linear_solver']} {counts}, log {log}"]
    sets = int(sum(strip.contact["iterations"]))
    systems = sets + s["solves"]
    is_right = (s["linear_solver"] == "iterative" and log == counts and
                counts[2] == sets and
                max(systems, counts[1]) <= counts[0] <= systems * counts[1])
    return [] if is_right else [f"linear solver {s['linear_solver']} {counts}, log {log}, "
                                f"{systems} systems, {sets} sets"]
