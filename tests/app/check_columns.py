#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recomputes all columns and keys of a run of a rod, and falsifies each in turn.

column_checks.py, field_checks.py and key_checks.py say from what; falsify.py says how each column and
key is falsified, and each falsification has to be noticed. Not noticed are:
wall times of steps in another order, of which the sum is known; the sign or size of
wall times below the rounding of the log; the forecast of the first impact, which is a coarse one,
times 1.001.
"""
import sys

import numpy

import key_checks
from column_checks import check, replay_of
from falsify import report
from field_checks import falsified_fields, field_faults
from run_files import Run

WALL = "steps.csv/wall_seconds"
SMALL = {("summary.json/" + name, way) for name in key_checks.TIMES
         for way in ("times 1.001",)}
COARSE = {("summary.json/predicted_first_" + name, "times 1.001")
          for name in ("contact_time", "penetration")}
EXEMPT = SMALL | COARSE | {(WALL, "one row late"), (WALL, "one row early")}


def named_faults(run):
    """Faults that are to be noticed where a scene has what they are about."""
    rod, force = replay_of(run).rod, run.contact["contact_force"]
    if rod.is_rigid and len(run.events) and not rod.is_massless and replay_of(run).locates:
        other = run.copy()
        row = numpy.argmin(abs(run.contact["time"] - run.events["time"][0]))
        impulse = other.contact["contact_impulse"]
        impulse[row:] -= impulse[row] - impulse[row - 1]
        yield "impulse of the impact not booked", other
    if force[-1] == max(force) > max(force[:-1]):
        other = run.copy()
        other.summary["max_contact_force"] = max(force[:-1])
        yield "peak force one step late", other
    if run.has_table("steps") and "tolerance" in run.steps["reason"]:
        other = run.copy()
        other.steps.keep(numpy.array([r != "tolerance" for r in run.steps["reason"]]))
        yield "no rows 'tolerance'", other
    if rod.has_heat and rod.theta_obs:
        other = run.copy()
        other.contact["heat_flux_end"][:] = rod.k * (
            run.contact["temperature_end"] + rod.theta_obs)
        yield "heat flux with the other sign of theta_obs", other


def check_fields(run):
    """Snapshots and space-time file; then each field falsified"""
    if not run.snapshots():
        return
    faults = [fault for fault in field_faults(run) if fault]
    missed = [name for name, other in falsified_fields(run) if not any(field_faults(other))]
    print(f"{'snapshots' if run.space_time() is None else 'snapshots, space-time file'}: "
          f"{faults or 'as recomputed, to 1e-5'}; falsified: "
          f"{f'{missed} not noticed' if missed else 'all noticed'}")


run = Run(sys.argv[1])
report(check, run, EXEMPT, named_faults,
       "1e-7")
check_fields(run)
