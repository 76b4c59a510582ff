# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of probes.csv, the snapshots and the space-time file of a rod."""
import copy
import math

import numpy

from column_checks import BOUND, check, replay_of, rows_of
from run_files import differences, due

FIELDS = ("temperature", "displacement", "velocity", "stress")


@check("probes.csv/time", *(f"probes.csv/{field}_{i}" for field in FIELDS
                            for i in range(1, 5)))
def check_probes(run):
    """The fields of the replay, in the rows of contact.csv"""
    if not run.has_table("probes"):
        return
    replay = replay_of(run)
    rod, at = replay.rod, [x for x, in run.probe_positions()]
    yield differences(run.probes["time"], run.contact["time"], 0)
    for field in FIELDS:
        if (field, *at) not in replay.probes:
            replay.probes[field, *at] = numpy.array(
                [field_of(rod, state, field, at) for state in replay.states])
        values = replay.probes[field, *at][rows_of(run)]
        for i in range(len(at)):
            fault = differences(run.probes[f"{field}_{i + 1}"], values[:, i], BOUND)
            yield fault and f"{field}_{i + 1}: {fault}"


def field_of(rod, state, field, x):
    """Values of a field at places; NaN if the scene has it not."""
    if not (rod.has_heat if field == "temperature" else rod.moves):
        return numpy.full(len(x), math.nan)
    if field == "stress":
        return rod.stress_at(x, state)
    return rod.values_at(x, {"temperature": state.theta, "displacement": state.u,
                             "velocity": state.v}[field])


def field_faults(run):
    """Snapshots and space-time file against the replay, single precision."""
    replay = replay_of(run)
    times = numpy.array([row["time"] for row in replay.rows])
    meshes = [(mesh, numpy.full(len(mesh.points), time)) for time, mesh in run.snapshots()]
    space_time = run.space_time()
    if space_time is not None:
        meshes.append((space_time, space_time.points[:, 1]))
    for name in ("Fields", "Space-time"):
        interval = run.settings.number(f"Output/{name} interval")
        found = ([time for time, _ in run.snapshots()] if name == "Fields" else
                 numpy.unique(space_time.points[:, 1]) if space_time is not None else [])
        if interval:
            yield differences(found, times[due(times, interval, replay.end_time)], 1e-6)
    for field in FIELDS:
        parts = [compared_values(replay, mesh, times, at, field) for mesh, at in meshes]
        has_field = replay.rod.has_heat if field == "temperature" else replay.rod.moves
        if any(part is None for part in parts) == has_field:
            yield f"{field} is or is not there"
        elif has_field:
            fault = differences(*numpy.concatenate(parts, axis=1), 1e-5)
            yield fault and f"{field}: {fault}"


def falsified_fields(run):
    """Copies of a run with one field of its snapshots or space-time file times 1.001."""
    meshes = [mesh for _, mesh in run.snapshots()]
    for name, values in (meshes[-1].point_data if meshes else {}).items():
        if numpy.any(values):
            other = run.copy()
            other.read_snapshots = copy.deepcopy(run.read_snapshots)
            for _, mesh in other.read_snapshots:
                mesh.point_data[name] *= 1.001
            yield f"{name} of the snapshots", other
            if run.space_time() is not None:
                other = run.copy()
                other.read_space_time = copy.deepcopy(run.read_space_time)
                other.read_space_time.point_data[name] *= 1.001
                yield f"{name} of the space-time file", other
    if meshes:
        other = run.copy()
        times = [time for time, _ in run.snapshots()]
        other.read_snapshots = list(zip(times[:1] + times[:-1], meshes))
        yield "times one snapshot late", other


def compared_values(replay, mesh, times, at, field):
    """Found and expected values at the points of a mesh; None without the field."""
    if field not in mesh.point_data:
        return None
    rows = numpy.abs(times[:, None] - at).argmin(axis=0)
    x = mesh.points[:, 0].astype(float)
    # The points of a cell are its own: a little to its middle. In a snapshot they follow
    # each other; meshio keeps the connectivity of the last rank alone.
    is_snapshot = mesh.cells[0].type == "line"
    cells = ([numpy.arange(len(x)).reshape(-1, replay.rod.degree + 1)] if is_snapshot
             else [block.data for block in mesh.cells])
    for points in cells:
        x[points] += 1e-6 * (x[points].mean(axis=1)[:, None] - x[points])
    expected = numpy.zeros(len(x))
    for row in numpy.unique(rows):
        here = rows == row
        expected[here] = field_of(replay.rod, replay.states[row], field, x[here])
    return mesh.point_data[field].reshape(len(x), -1)[:, 0].astype(float), expected
