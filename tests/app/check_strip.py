#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recomputes what a strip reports, from the displacements in its snapshots.

Every step has a snapshot. Stress: all components from the gradients of displacement and
velocity in each cell, with lambda and mu of (M1.6). Probes and space-time file: the
polynomials of the snapshots. contact.csv: values at the contact nodes, integrals (M2.2),
(D4.2), (D4.4) of backward Euler; with free sides and a traction alone, half of Clapeyron's work, and a
state of uniaxial stress in the middle, exp(-4.2 x 4) away from the ends.
Snapshots are in single precision: bound 2e-5 of the largest value, 1e-4 for stresses.
Then each column is falsified, as in falsify.py; not noticed is the number of iterations
of the active set, whose value is only known to be a count.
"""
import copy
import math
import sys

import numpy

from falsify import Checks, is_count, report
from run_files import Run, differences
from strip_fields import Snapshot, stress_of
from strip_keys import check_summary

SINGLE = 2e-5
FIELDS = ("temperature", "displacement", "velocity", "stress")
EXEMPT = {("contact.csv/iterations", way) for way in
          ("one row late", "one row early", "zero in the last row")} | {
              ("events.csv/velocity", "times 1.001"),
              # a thousandth of 1e-11 of the energy is rounding
              ("contact.csv/algebraic", "times 1.001")}
check = Checks()


class Strip(Run):
    """A run with its snapshots and the numbers that all checks need."""

    def __init__(self, directory):
        super().__init__(directory)
        s = self.settings
        self.degree, self.width = int(s["Mesh/Degree"]), s.number("Mesh/Width")
        self.states = [Snapshot(time, mesh, self.degree)
                       for time, mesh in self.snapshots()]
        self.nu, self.zeta = s.number("Model/Poisson ratio"), s.number("Model/Viscosity")
        self.has_heat, self.b = s.has("temperature"), s.number("Model/Inertia")
        self.is_static = self.b == self.zeta == 0
        self.a = s.number("Model/Coupling") if self.has_heat else 0.0
        self.epsilon, self.g = s.number("Contact/Compliance"), s.number("Contact/Gap")
        self.has_obstacle = s["Contact/Condition"] != "none"
        self.theta_A = s.number("Boundary/left/Temperature")
        self.theta_obs = s.number("Boundary/right/Surroundings")
        self.k = s.number("Boundary/right/Heat exchange")
        self.drop = self.k / (self.k + 1) * (self.theta_A - self.theta_obs)
        self.on_rollers = s["Boundary/sides/Support"] == "rollers"
        self.traction = s.expression("Boundary/right/Traction")
        self.sums = None

    def tractions(self):
        return numpy.array([self.traction(1.0, state.time) for state in self.states])


def expected_stress(strip, state):
    """C(e(u) + zeta e(v)) - a theta I at all points"""
    strain = state.strain("displacement")
    if strip.zeta:
        strain = strain + strip.zeta * state.strain("velocity")
    stress = stress_of(strain, strip.nu)
    if strip.has_heat:
        stress = stress - strip.a * state.fields["temperature"][..., None] * numpy.eye(2)
    return stress


@check()
def check_stress(strip):
    """All components in all snapshots"""
    found = [state.fields["stress"][..., :2, :2] for state in strip.states]
    expected = [expected_stress(strip, state) for state in strip.states]
    found, expected = numpy.array(found), numpy.array(expected)
    for i, j in ((0, 0), (0, 1), (1, 0), (1, 1)):
        if abs(found - expected)[..., i, j].max() > 1e-4 * abs(expected).max():
            yield f"component {i}{j} of the stress"
    for state, plane in zip(strip.states, expected):
        heat = strip.a * state.fields["temperature"][..., 0] if strip.has_heat else 0.0
        across = strip.nu * (plane[..., 0, 0] + plane[..., 1, 1] + 2 * heat) - heat
        stress = state.fields["stress"]
        if abs(stress[..., 2, 2] - across).max() > 1e-4 * abs(expected).max() or \
                stress[..., 2, :2].any() or stress[..., :2, 2].any():
            yield "stress across the plane: no strain there"


@check()
def check_uniaxial(strip):
    """Free sides, traction alone: in the middle s_xx = t, and no other stress."""
    if strip.has_heat or strip.on_rollers or strip.b or strip.has_obstacle:
        return
    lame = strip.nu / (1 - strip.nu)
    for state, t in zip(strip.states, strip.tractions()):
        middle = abs(state.corner[:, 0] + state.size[:, 0] / 2 - 0.5) < 0.1
        stress = state.fields["stress"][middle]
        strain = state.strain("displacement")[middle]
        for found, value in ((stress[..., 0, 0], t), (stress[..., 1, 1], 0),
                             (stress[..., 0, 1], 0),
                             (strain[..., 0, 0], t / (1 - lame**2)),
                             (strain[..., 1, 1], -lame * t / (1 - lame**2))):
            if abs(found - value).max() > 1e-4 * t:
                yield f"the middle at t = {state.time}"


@check("contact.csv/step", "contact.csv/time", "contact.csv/step_size",
       "contact.csv/iterations")
def check_times(strip):
    """Fixed steps, each with a snapshot; iterations are counts."""
    c, size = strip.contact, strip.settings.number("Time/Step size")
    yield differences(c["step"], numpy.arange(len(c)), 0)
    yield differences(c["time"], size * c["step"], 1e-12)
    yield differences(c["step_size"], numpy.where(c["step"] > 0, size, 0), 1e-9)
    yield differences(c["time"], [state.time for state in strip.states], 1e-12)
    if not all(is_count(value) and value >= 0 for value in c["iterations"]) or \
            any(c["iterations"][c["in_contact"] == 1][1:] == 0):
        yield "iterations"


def means(strip, name):
    """Mean values over the contact end in the snapshots"""
    return [values @ weights for values, weights in
            (state.at_contact_nodes(name) for state in strip.states)]


def pressures(strip, state):
    u, weights = state.at_contact_nodes("displacement")
    if not strip.has_obstacle:
        return 0 * u, weights
    return numpy.maximum(u - strip.g, 0) / strip.epsilon, weights


@check("contact.csv/displacement_end", "contact.csv/displacement_mid",
       "contact.csv/velocity_end", "contact.csv/gap", "contact.csv/penetration",
       "contact.csv/contact_force", "contact.csv/stress_end", "contact.csv/in_contact",
       "contact.csv/contact_impulse")
def check_end(strip):
    """Means over the contact nodes, extremes, (M1.4), the sum of force times step"""
    c = strip.contact
    yield differences(c["displacement_end"], means(strip, "displacement"), SINGLE)
    velocity = numpy.array(means(strip, "velocity"))
    if strip.is_static:
        velocity[0] = math.nan
    yield differences(c["velocity_end"], velocity, SINGLE)
    yield differences(c["displacement_mid"], [
        state.value_at("displacement", 0.5, strip.width / 2) for state in strip.states],
        SINGLE)
    largest = numpy.array([max(state.at_contact_nodes("displacement")[0])
                           for state in strip.states])
    scale = SINGLE * abs(largest).max()
    if strip.has_obstacle != (~numpy.isnan(c["gap"])).all() or \
            strip.has_obstacle and (abs(c["gap"] - strip.g + largest) > scale).any():
        yield "gap"
    force = numpy.array([p @ w for p, w in (pressures(strip, s) for s in strip.states)])
    bound = scale / strip.epsilon if strip.has_obstacle else 1e-14
    if (abs(c["contact_force"] - force) > bound).any():
        yield "contact_force"
    yield differences(c["penetration"], numpy.maximum(0, -numpy.nan_to_num(c["gap"])), 1e-9)
    yield differences(c["in_contact"], c["contact_force"] > 0, 0)
    yield differences(c["stress_end"], strip.tractions() - c["contact_force"], 1e-11)
    steps = numpy.diff(c["contact_impulse"])
    yield differences(steps, (c["contact_force"] * c["step_size"])[1:], 1e-9)
    yield differences(c["contact_impulse"][:1], [0], 0)


@check("contact.csv/contact_area", "contact.csv/max_pressure", "contact.csv/min_gap",
       "contact.csv/moment_y", "contact.csv/moment_z")
def check_face(strip):
    """Sums over the contact nodes; y from the axis, and there is no z"""
    c = strip.contact
    bound = SINGLE * abs(c["displacement_end"]).max() / strip.epsilon if \
        strip.has_obstacle else 1e-14
    rows = []
    for state in strip.states:
        p, weights = pressures(strip, state)
        y = state.contact_node_heights() - strip.width / 2
        rows.append((p.max(), weights @ (p * y), weights @ (p > bound),
                     weights @ (p > -bound) if p.any() else 0))
    largest, moment, surely, perhaps = numpy.array(rows).T
    if (abs(c["max_pressure"] - largest) > bound).any():
        yield "max_pressure"
    if (abs(c["moment_y"] - moment) > bound * strip.width).any():
        yield "moment_y"
    if (c["contact_area"] < surely - 1e-9).any() or \
            (c["contact_area"] > perhaps + 1e-9).any() or \
            (c["contact_area"][c["in_contact"] == 0] != 0).any() or \
            (c["contact_area"][c["in_contact"] == 1] == 0).any():
        yield "contact_area"
    yield differences(c["min_gap"], c["gap"], 0)
    yield differences(c["moment_z"], 0 * c["moment_z"], 0)


@check("contact.csv/temperature_end", "contact.csv/temperature_mean",
       "contact.csv/heat_flux_end")
def check_heat(strip):
    """Means over the end and the body, k (theta_end - theta_obs)"""
    c = strip.contact
    if not strip.has_heat:
        for name in ("temperature_end", "temperature_mean", "heat_flux_end"):
            yield differences(c[name], numpy.full(len(c), math.nan), 0)
        return
    yield differences(c["temperature_end"], means(strip, "temperature"), SINGLE)
    mean = [state.integral(theta, 0 * theta + 1) / strip.width for state in strip.states
            for theta in [state.fields["temperature"][..., 0]]]
    yield differences(c["temperature_mean"], mean, SINGLE)
    yield differences(c["heat_flux_end"], strip.k * (c["temperature_end"] -
                                                     strip.theta_obs), 1e-11)


def steady(strip, state):
    """theta_s at the points"""
    s = state.element.nodes[None, None, :]
    x = state.corner[:, 0, None, None] + s * state.size[:, 0, None, None]
    return strip.theta_A - strip.drop * x + 0 * state.fields["displacement"][..., 0]


def elastic_form(strip, state, name):
    """(C e(w), e(w)), per unit area"""
    strain = state.strain(name)
    stress = stress_of(strain, strip.nu)
    return sum(state.integral(stress[..., i, j], strain[..., i, j])
               for i in range(2) for j in range(2)) / strip.width


def energy_and_rate(strip, state):
    """(M2.2), and the dissipation (D4.2) per time"""
    v = state.fields["velocity"]
    p, weights = pressures(strip, state)
    energy = (strip.b * sum(state.integral(v[..., i], v[..., i]) for i in range(2)) /
              strip.width + elastic_form(strip, state, "displacement") +
              strip.epsilon * weights @ p**2) / 2
    rate = strip.zeta * elastic_form(strip, state, "velocity")
    if strip.has_heat:
        theta_s = steady(strip, state)
        theta = state.fields["temperature"][..., 0] - theta_s
        divergence = numpy.trace(state.gradient("displacement"), axis1=-2, axis2=-1)
        energy += (state.integral(theta, theta) / 2 -
                   strip.a * state.integral(theta_s, divergence)) / strip.width
        gradient = state.gradient("temperature")[..., 0, :].copy()
        gradient[..., 0] += strip.drop
        rate += sum(state.integral(gradient[..., i], gradient[..., i])
                    for i in range(2)) / strip.width
        end, weights = state.at_contact_nodes("temperature")
        rate += strip.k * weights @ (end - strip.theta_A + strip.drop)**2
    return energy, rate


@check("contact.csv/energy", "contact.csv/dissipation", "contact.csv/work",
       "contact.csv/numerical_dissipation", "contact.csv/algebraic")
def check_energy(strip):
    """Integrals of the snapshots; the audit (D4.1), with what a solver leaves (D8.5), which
    is there if it iterates"""
    c, is_euler = strip.contact, strip.settings["Time/Scheme"] == "backward euler"
    if strip.sums is None:
        strip.sums = numpy.array([energy_and_rate(strip, s) for s in strip.states]).T
    energy, rates = strip.sums
    yield differences(c["energy"], energy, 1e-4)
    audit = c["energy"] + c["dissipation"] + c["numerical_dissipation"] - c["work"]
    is_iterative = strip.settings.get("Solver/Linear solver") == "iterative"
    if ("algebraic" in c.names) != is_iterative:
        yield "algebraic is or is not there"
    elif is_iterative:
        # it is much larger than rounding, and closes the audit to rounding
        audit = audit - c["algebraic"]
        largest = abs(c["algebraic"]).max()
        if not 1e-13 * c["energy"][0] < largest < 1e-6 * c["energy"][0]:
            yield f"algebraic {largest}"
    yield differences(audit, numpy.full(len(c), c["energy"][0]),
                      1e-13 if is_iterative else 1e-10)
    if is_euler:
        yield differences(c["dissipation"], numpy.cumsum(rates * c["step_size"]), 1e-4)
        power = strip.tractions() * c["velocity_end"] * c["step_size"]
        yield differences(c["work"], numpy.cumsum(power), 1e-9)
        if (numpy.diff(c["numerical_dissipation"]) < -1e-12).any():
            yield "numerical dissipation falls"
    elif strip.is_static and not strip.has_heat:
        yield differences(c["energy"], strip.tractions() * c["displacement_end"] / 2, 1e-9)
        # u is proportional to t: W = t u / 2, to the order of the scheme, here exactly
        yield differences(c["work"], c["energy"] - c["energy"][0], 1e-9)
        yield differences(c["dissipation"], 0 * c["dissipation"], 0)


@check("probes.csv/time", *(f"probes.csv/{field}_{i}" for field in FIELDS
                            for i in range(1, 4)))
def check_probes(strip):
    """The polynomials of the snapshots, within cells"""
    yield differences(strip.probes["time"], strip.contact["time"], 0)
    for i, place in enumerate(strip.probe_positions(), 1):
        for field in FIELDS:
            found = strip.probes[f"{field}_{i}"]
            if field == "temperature" and not strip.has_heat:
                yield differences(found, numpy.full(len(found), math.nan), 0)
                continue
            expected = numpy.array([state.value_at(field, *place)
                                    for state in strip.states])
            scale = max(numpy.nanmax(abs(state.fields[field])) for state in strip.states)
            if field == "velocity" and strip.is_static:
                expected[0] = math.nan
            yield differences(found / scale, expected / scale, SINGLE, 1.0)


@check()
def check_space_time(strip):
    """The snapshots on the axis, at the same times"""
    mesh = strip.space_time()
    times = [state.time for state in strip.states]
    yield differences(numpy.unique(mesh.points[:, 1]), times, 1e-6)
    x = mesh.points[:, 0].astype(float)
    for block in mesh.cells:  # to the middle of the cell that a point belongs to
        x[block.data] += 1e-4 * (x[block.data].mean(axis=1)[:, None] - x[block.data])
    for field in FIELDS[0 if strip.has_heat else 1:]:
        found = mesh.point_data[field].reshape(len(x), -1)[:, 0]
        worst = 0.0
        for i in range(0, len(x), 7):
            state = strip.states[numpy.argmin(abs(times - mesh.points[i, 1]))]
            worst = max(worst, abs(found[i] - state.value_at(field, x[i], strip.width / 2)))
        if worst > 5e-4 * max(abs(state.fields[field]).max() for state in strip.states):
            yield field


@check("events.csv/duration")
def check_durations(strip):
    """From the begin, in the row above, to the end"""
    e = strip.events
    expected = numpy.where([kind == "end" for kind in e["kind"]],
                           numpy.diff(e["time"], prepend=math.nan), math.nan)
    yield differences(e["duration"], expected, 1e-9)


@check("events.csv/time", "events.csv/kind", "events.csv/velocity")
def check_events(strip):
    """Where the gap is zero between the rows; the velocity of the foremost node before"""
    c, e = strip.contact, strip.events
    rows = numpy.flatnonzero(numpy.diff(c["in_contact"], prepend=0))
    if e["kind"] != ["begin", "end"][:len(rows)] or len(rows) > 2:
        yield "kinds"
        return
    for row, kind, time, velocity in zip(rows, e["kind"], e["time"], e["velocity"]):
        part = c["gap"][row - 1] / (c["gap"][row - 1] - c["gap"][row])
        yield differences([time], [c["time"][row - 1] + part * c["step_size"][row]], 1e-9)
        state = strip.states[row - 1 if kind == "begin" else row]
        foremost = numpy.argmax(state.at_contact_nodes("displacement")[0])
        yield differences([velocity], [state.at_contact_nodes("velocity")[0][foremost]],
                          1e-3)


def named_faults(strip):
    """Stress in the snapshots with another lambda(nu), or that of the plane alone"""
    plane = strip.copy()
    plane.states = []
    for state in strip.states:
        flat = copy.copy(state)
        flat.fields = dict(state.fields)
        flat.fields["stress"] = state.fields["stress"].copy()
        flat.fields["stress"][..., 2, 2] = 0
        plane.states.append(flat)
    yield "VTU stress of the plane", plane
    for name, wrong in (("lambda = nu", strip.nu), ("no lambda", 0.0)):
        other = strip.copy()
        other.states = []
        for state in strip.states:
            false = copy.copy(state)
            trace = numpy.trace(expected_stress(strip, state), axis1=-2, axis2=-1)
            trace = trace / (1 + strip.nu / (1 - strip.nu))  # of the strain, if a = 0
            false.fields = dict(state.fields)
            stress = state.fields["stress"].copy()
            for i in range(2):
                stress[..., i, i] += (wrong - strip.nu / (1 - strip.nu)) * trace
            false.fields["stress"] = stress
            other.states.append(false)
        yield f"VTU stress with {name}", other


run = Strip(sys.argv[1])
print("keys", check_summary(run) or "as recomputed")
run.summary = None  # the others are those of a rod
report(check, run, EXEMPT, named_faults,
       "2e-5, stress and energy 1e-4")
