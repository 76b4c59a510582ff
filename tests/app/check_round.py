#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recomputes the stress of a round rod, from the displacements in its snapshots.

usage: check_round.py DIR

Rows x, r and around the axis: C (e(u) + zeta e(v)) with the strain u_r/r around the axis,
its limit u_r,r on it, and lambda and mu of (M1.6). Far from the ends s_xx = t, no other
stress, and without viscosity e_xx = t/E, E = 2 mu (1 + nu), e_rr = -nu e_xx. Probes: the polynomials
of the snapshots. Snapshots are in single precision: bound 1e-4 of t. Then the
stress is falsified, without the strain around the axis and as in a plane.
Cells are Lagrange cells of VTK: corners around, then the points on the edges.
"""
import sys

import numpy

from run_files import Run
from strip_fields import Snapshot

BOUND = 1e-4


def strain_of(state, has_circumference=True, field="displacement"):
    """e(u), or e(v) for the velocity, at the points of the cells, 3 x 3"""
    plane, r = state.strain(field), radius_of(state)
    strain = numpy.zeros((*plane.shape[:-2], 3, 3))
    strain[..., :2, :2] = plane
    if has_circumference:
        on_axis = r < 1e-6
        strain[..., 2, 2] = numpy.where(
            on_axis, plane[..., 1, 1],
            state.fields[field][..., 1] / numpy.where(on_axis, 1, r))
    return strain


def radius_of(state):
    s = state.element.nodes[None, :, None]
    r = state.corner[:, 1, None, None] + s * state.size[:, 1, None, None]
    return r + 0 * state.fields["displacement"][..., 0]


def stress_of(strain, nu):
    trace = numpy.trace(strain, axis1=-2, axis2=-1)[..., None, None]
    return nu / (1 - nu) * trace * numpy.eye(3) + (1 - 2 * nu) / (1 - nu) * strain


def stress_in(run, state, has_circumference=True):
    nu, zeta = (run.settings.number(f"Model/{name}") for name in ("Poisson ratio", "Viscosity"))
    return stress_of(strain_of(state, has_circumference) + zeta * strain_of(
        state, has_circumference, "velocity"), nu)


def faults_of(run, states, stresses):
    nu = run.settings.number("Model/Poisson ratio")
    is_elastic = run.settings.number("Model/Viscosity") == 0
    traction = run.settings.expression("Boundary/right/Traction")
    young = (1 - 2 * nu) / (1 - nu) * (1 + nu)
    for state, stress in zip(states, stresses):
        t, strain = traction(1.0, state.time), strain_of(state)
        if abs(stress - stress_in(run, state)).max() > BOUND * t:
            yield f"stress at t = {state.time}"
        middle = abs(state.corner[:, 0] + state.size[:, 0] / 2 - 0.5) < 0.1
        for found, diagonal in ((stress, (t, 0, 0)),
                                (strain, numpy.array([1, -nu, -nu]) * t / young))[:1 + is_elastic]:
            if abs(found[middle] - numpy.diag(diagonal)).max() > BOUND * t / young:
                yield f"the middle at t = {state.time}"


def faults_of_probes(run, states):
    for i, place in enumerate(run.probe_positions(), 1):
        for field in ("displacement", "stress"):
            found = run.probes[f"{field}_{i}"]
            expected = numpy.array([state.value_at(field, *place) for state in states])
            if abs(found - expected).max() > BOUND * abs(expected).max():
                yield f"{field} at {place}"


def faults_of_cells(run):
    p = int(run.settings["Mesh/Degree"])
    s = numpy.arange(1, p) / p
    outline = [*[(0, 0), (1, 0), (1, 1), (0, 1)], *[(t, 0) for t in s], *[(1, t) for t in s],
               *[(t, 1) for t in s], *[(0, t) for t in s]]
    for _, mesh in run.snapshots():
        for places in mesh.points[mesh.cells[0].data][..., :2]:
            low, high = places.min(axis=0), places.max(axis=0)
            found = (places - low) / (high - low)
            if found.shape[0] != (p + 1)**2 or abs(found[:4 * p] - outline).max() > 1e-5:
                yield f"Lagrange cell at {low}"


def main():
    run = Run(sys.argv[1])
    states = [Snapshot(time, mesh, int(run.settings["Mesh/Degree"]))
              for time, mesh in run.snapshots()]
    stresses = [state.fields["stress"] for state in states]
    faults = [*faults_of(run, states, stresses), *faults_of_probes(run, states),
              *faults_of_cells(run)]
    plane = [numpy.array(stress) for stress in stresses]
    for stress in plane:
        stress[..., 2, 2] = 0
    missed = [name for name, other in (
        ("no strain around the axis",
         [stress_in(run, state, False) for state in states]),
        ("no stress around the axis", plane)) if not any(faults_of(run, states, other))]
    print(f"{len(states)} snapshots, {len(run.probe_positions())} probes:",
          faults or "as recomputed;", "falsified:", missed or "noticed")


main()
