# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds for the files of every scene: columns and keys from each other, from the
entries and from the snapshots.

Ties that hold to rounding have the bound EXACT; what is read from snapshots, which are in
single precision, SINGLE; sums over steps in place of integrals, ROUGH. Fixed steps of 0.01
lose less than LOSS of the energy (measured: 4e-4), controlled ones 0.3 tolerances (0.1).
"""
import math
import re

import numpy

from falsify import Checks
from polynomials import equidistant, lobatto
from run_files import differences, due, nearly, with_first_contact

EXACT, SINGLE, ROUGH, LOSS = 1e-10, 2e-5, 0.1, 1e-3
TIMES = ("set_up_seconds", "loop_seconds", "step_seconds", "factorization_seconds",
         "solve_seconds", "contact_seconds", "output_seconds", "wall_seconds")
check = Checks()


def column(*names):
    return check(*(f"contact.csv/{name}" for name in names))


def key(*names):
    return check(*(f"summary.json/{name}" for name in names))


#: the entries of loads, by the words of the screen
LOADS = {"Sources/Heat source": "heat source", "Sources/Body force": "body force",
         "Boundary/right/Traction": "end traction", "Boundary/right/Heat flux": "end heat flux"}


def top_of_cubics(c, name, power):
    """Largest value of the cubics of (D9.2) within steps in contact; power of the law for the
    force, whose rate is that of the penetration times power f/s."""
    top, times, values = 0., c["time"], abs(c[name])
    rates = c["velocity_end"] * [
        power * value / depth if depth > 0 else 0. for value, depth in zip(values, c["penetration"])]
    for i in range(len(times) - 1):
        h, (f, g), (a, b) = times[i + 1] - times[i], values[i:i + 2], rates[i:i + 2]
        if f > 0 and g > 0 and a > 0 > b and h > 0:
            cubic = numpy.polynomial.Polynomial([
                f, h * a, 3 * (g - f) - h * (2 * a + b), 2 * (f - g) + h * (a + b)])
            top = max([top, *(cubic(x.real) for x in cubic.deriv().roots()
                              if abs(x.imag) < 1e-12 and 0 <= x.real <= 1)])
    return float(top)


class Scene:
    """What the entries of a run say, named as in doc/model.md."""

    def __init__(self, run):
        s = self.settings = run.settings
        self.is_rod = s["Dimension"] == "1"
        self.has_heat, self.moves = s.has("temperature"), s.has("displacement")
        self.condition = s.get("Contact/Condition", "none") if self.moves else "none"
        self.has_obstacle = self.condition != "none"
        self.b, self.zeta = s.number("Model/Inertia"), s.number("Model/Viscosity")
        self.a = s.number("Model/Coupling") if self.has_heat and self.moves else 0.
        self.epsilon = s.number("Contact/Compliance")
        self.m = s.number("Contact/Exponent") if self.condition == "power law" else 1.
        self.c, self.d = s.number("Contact/Damping"), s.number("Contact/Dashpot")
        self.is_damped = self.c > 0 or self.d > 0
        self.drive = s["Boundary/left/Temperature"] if self.has_heat else "0"
        rear = s.get("Contact/Rear gap", "none")
        self.rear_gap = math.inf if rear == "none" else float(rear)
        self.is_euler = s["Time/Scheme"] == "backward euler"
        self.is_wide = s["Title"].startswith("Wide")
        self.conserves = s["Time/Scheme"] == "energy conserving"
        self.has_cells = s["Time/Scheme"] == "box"
        self.has_rates_of_force = (
            self.is_rod and not self.is_euler and not self.conserves and
            not self.has_cells and
            self.condition not in ("rigid", "none") and not self.is_damped and
            self.rear_gap == math.inf)
        self.is_driven = any(s.get(path, "0") != "0" for path in LOADS) or \
            s.get("Boundary/left/Displacement", "0") != "0" or "t" in self.drive or \
            "t" in s.get("Contact/Gap", "0") or "t" in s.get(
                "Boundary/right/Surroundings", "0")
        k = s.get("Boundary/right/Heat exchange", "0")
        self.has_states = "pressure" in k or "gap" in k
        self.works = self.is_driven or self.has_states or self.a and s[
            "Model/Thermoelastic heating"] == "false"

    def rest_of_end(self, k):
        """theta(1) of a rod at rest with the heat exchange k there: a line, or with a
        lateral one m that of theta'' = m (theta - theta_inf), q^2 = m."""
        s = self.settings
        inner, outer = float(self.drive), s.number("Boundary/right/Surroundings")
        q = max(1e-6, math.sqrt(s.number("Boundary/sides/Heat exchange")))
        around = s.number("Boundary/sides/Surroundings")
        return around + (q * (inner - around) + k * (outer - around) * math.sinh(q)) / (
            q * math.cosh(q) + k * math.sinh(q))

    def at_end(self, entry, times, **columns):
        """An expression at the contact end; columns: other variables of it."""
        return self.settings.expression(entry)(numpy.ones(len(times)), times, **columns)


def scene_of(run):
    if "scene" not in run.__dict__:
        run.scene = Scene(run)
    return run.scene


WIDE = ("times", "contact_law", "heat_flux", "lateral", "audit", "face", "nodes", "results",
        "names", "counts", "poincare", "costs")


def faults_of_wide(run):
    """Of the checks that hold in all ranges of doc/stability.md; events in turn."""
    for _, function in check.checks:
        if function.__name__.removeprefix("check_") in WIDE:
            yield from (f"{function.__name__}: {fault}" for fault in function(run) if fault)
    if run.events["kind"] != (["begin", "end"] * len(run.events))[:len(run.events)]:
        yield "not begin and end in turn"
    for name, values in run.contact.columns.items():
        if numpy.isinf(values).any() or numpy.isnan(values[2:]).any() and not (
                numpy.isnan(values).all()):
            yield f"{name} is not finite"


def compare(run, expected, bound=0.):
    """Faults of the keys that do not have the expected values."""
    for name, value in expected.items():
        found = run.summary[name]
        same = (nearly(found, value, bound) if isinstance(value, float) else
                found == value and isinstance(found, type(value)))
        if not same:
            yield f"{name} is {found} instead of {value}"


@column("step", "time", "step_size")
def check_times(run):
    """A row for each step, whose sizes lead from row to row to T."""
    c = run.contact
    yield differences(c["step"], numpy.arange(len(c)), 0)
    yield differences(numpy.diff(c["time"], prepend=0.), c["step_size"], EXACT, 1.)
    if c["time"][-1] != run.settings.number("Time/End time"):
        yield "the last row is not at the end time"


@column("displacement_end", "displacement_mid", "velocity_end", "gap", "penetration",
        "contact_force", "in_contact", "stress_end")
def check_contact_law(run):
    """The law at the nearer stop in each row of a rod; signs, in a body."""
    c, scene = run.contact, scene_of(run)
    if not scene.moves:
        for name in ("displacement_end", "displacement_mid", "velocity_end", "stress_end",
                     "gap", "penetration", "contact_force"):
            yield differences(c[name], numpy.full(len(c), math.nan), 0)
        yield differences(c["in_contact"], 0 * c["time"], 0)
        return
    p, traction = c["contact_force"], scene.at_end("Boundary/right/Traction", c["time"])
    spring, dashpot, mass = (run.settings.number(f"Boundary/right/{what}") for what in (
        "Spring", "Dashpot", "Mass"))
    carried = spring * c["displacement_end"] + (dashpot * c["velocity_end"] if dashpot else 0)
    yield differences(c["stress_end"], traction - p - carried if mass == 0 else
                      numpy.full(len(c), math.nan), EXACT, max(
                          1., abs(p).max(), abs(traction).max(), abs(carried).max()))
    if not scene.has_obstacle:
        yield differences(p, 0 * p, 0)
        return
    if scene.condition != "rigid":
        # a large tolerance leaves a bit of pressure where contact begins and ends
        yield differences(c["penetration"], numpy.maximum(0, -c["gap"]), 1e-3, 1.)
    elif (c["gap"] < -1e-9 * max(1., abs(c["displacement_end"]).max())).any() and (
            not scene.is_wide or scene.is_rod):  # of a body to the tolerance of events
        yield "penetration of a rigid obstacle"
    if not scene.is_rod:
        if scene.rear_gap == math.inf and (p < 0).any():
            yield "a negative force"
        return
    if (c["in_contact"] < (p != 0)).any() or (scene.d > 0 or scene.c == 0) and (
            c["in_contact"] != (p != 0)).any():
        yield "in_contact"
    s_gap = run.settings["Contact/Gap"]
    g, u = scene.at_end("Contact/Gap", c["time"]), c["displacement_end"]
    size = max(1., abs(u).max())
    yield differences(c["gap"], numpy.minimum(g - u, scene.rear_gap + u), EXACT, size)
    side = numpy.where(g - u < scene.rear_gap + u, 1., -1.)
    if (side * p < 0).any():
        yield "a force from the other stop"
    if scene.condition == "rigid":
        yield differences(p * c["gap"], 0 * p, EXACT, max(1., abs(p).max()) * size)
    elif not scene.is_damped:
        yield differences(p, side * (c["penetration"] / scene.epsilon)**scene.m, 1e-9)
    elif not scene.is_wide or "t" not in s_gap:  # at t = 0 the law is without it
        rate = scene.at_end("Contact/Gap", c["time"] + 1e-6) - g
        v = c["velocity_end"] - numpy.where(side > 0, rate * 1e6, 0.)
        spring = side * (numpy.maximum(0, -c["gap"]) / scene.epsilon)**scene.m
        push = side * spring * numpy.maximum(0, 1 + scene.c * side * v) + scene.d * side * v
        # where contact begins, the dashpot pushes or not
        begins = (scene.d > 0) & (abs(c["gap"]) < 1e-6)
        yield differences(p[1:], numpy.where(begins & (p == 0) | (c["gap"] > 1e-6), 0., side * numpy.maximum(
            0, push))[1:], 1e-5, max(1., abs(p).max()))
        if scene.is_euler and not scene.is_wide and "t" not in s_gap:
            taken = numpy.cumsum(c["step_size"] * (p - spring) * v)
            yield differences(c["contact_dissipation"], taken, 1e-5, max(1., abs(taken).max()))


@column("heat_flux_end", "temperature_end", "temperature_mean")
def check_heat_flux(run):
    """k (theta_end - theta_obs), where theta_obs jumps with the value behind."""
    c, scene, s = run.contact, scene_of(run), run.settings
    if not scene.has_heat:
        for name in ("temperature_end", "temperature_mean", "heat_flux_end"):
            yield differences(c[name], numpy.full(len(c), math.nan), 0)
        return
    before, behind = (scene.at_end("Boundary/right/Surroundings", time) for time in (
        c["time"], c["time"] + 1e-10 * c["time"][-1]))
    k = s["Boundary/right/Heat exchange"]
    if "pressure" in k and not scene.is_rod:
        return
    k = scene.at_end("Boundary/right/Heat exchange", c["time"], gap=numpy.maximum(
        0, numpy.nan_to_num(c["gap"])), pressure=abs(numpy.nan_to_num(c["contact_force"])))
    before, behind = (k * (c["temperature_end"] - obstacle) for obstacle in (before, behind))
    flux = c["heat_flux_end"]
    yield differences(flux, numpy.where(abs(flux - behind) < abs(flux - before), behind,
                                        before), 1e-8)


@column("lateral_heat_flux", "lateral_dissipation")
def check_lateral(run):
    """m (mean theta - theta_inf); a part of the dissipation"""
    c, s = run.contact, run.settings
    if "lateral_heat_flux" not in c.names:
        return
    m, outside = (s.number("Boundary/" + name) for name in (
        "sides/Heat exchange", "sides/Surroundings"))
    expected = m * (c["temperature_mean"] - outside)  # in a body that of the faces
    if scene_of(run).is_rod or not scene_of(run).is_wide:
        yield differences(c["lateral_heat_flux"], expected,
                          1e-9 if scene_of(run).is_rod else ROUGH)
    part = numpy.diff(c["lateral_dissipation"])
    rounding = 1e-12 * max(1., c["dissipation"].max())
    if scene_of(run).is_euler and ((part < 0).any() or (
            part > numpy.diff(c["dissipation"]) + rounding).any()) or \
            c["lateral_dissipation"][0] != 0:
        yield "not a part of the dissipation"


def layer_of_start(run):
    """Between what the first step loses where theta_A - theta_0 = d at x = 0, (C4.5): half the
    smallest square of the norm of a temperature that is d there, of one cell d^2 h/(p+1)^2;
    if it is to be zero at the other vertex d^2 h/(p(p+2)). The lumped mass has its weight."""
    s, scene = run.settings, scene_of(run)
    if not scene.has_heat or s["Initial values/Temperature"] != "theta_A*x^2":
        return ()
    n, p = int(s["Mesh/Cells"]), int(s["Mesh/Degree"])
    grading = s.number("Mesh/Grading", 1)
    h = grading / sum(grading**(i / max(1, n - 1)) for i in range(n))
    half = float(re.match(r"-?[\d.]+", scene.drive)[0])**2 * h / 2
    if s.get("Mesh/Mass matrix") == "lumped":
        return half / (p * (p + 1)), half / (p * (p + 1))
    return half / (p + 1)**2, half / (p * (p + 2))


@column("energy", "work", "dissipation", "numerical_dissipation", "contact_dissipation",
        "algebraic")
def check_audit(run):
    """(D4.1) in each row; what cannot fall; no work where nothing does any."""
    c, scene = run.contact, scene_of(run)
    zero = 0 * c["time"]
    taken = c["contact_dissipation"] if "contact_dissipation" in c.names else zero
    left = c["algebraic"] if "algebraic" in c.names else zero
    sums = c["energy"] + c["dissipation"] + c["numerical_dissipation"] + taken - \
        c["work"] - left
    scale = abs(c["energy"]).max() + c["dissipation"].max()
    theta = numpy.nanmax(abs(c["temperature_end"]), initial=0)  # cancels in the energy
    scale = max(scale, abs(c["work"]).max(), theta**2)
    yield differences(sums, numpy.full(len(c), c["energy"][0]), EXACT,
                      10 * scale if scene.is_wide else scale)
    for name, values in (("dissipation", c["dissipation"]), ("contact_dissipation", taken)):
        if scene.is_euler and (numpy.diff(values) < -1e-13 * scale).any() or values[0] != 0:
            yield f"{name} falls, or does not begin at 0"
    if scene.is_euler and not scene.works and (numpy.diff(c["energy"]) > 1e-12 * scale).any():
        yield "energy of backward Euler grows"
    lost = c["numerical_dissipation"].copy()
    if not scene.is_euler and (bounds := layer_of_start(run)):
        # the fixed first step of the box, L-stable in heat, takes of the layer itself, too
        most = 2e-2 * scale if run.settings["Time/Scheme"] == "box" else 1e-3 * scale
        if not bounds[0] - 1e-3 * scale <= lost[1] <= bounds[1] + most:
            yield f"the layer of the start takes {lost[1]}, not {bounds}"
        lost[1:] -= lost[1]
    tolerance = run.settings.get("Time/Tolerance", "automatic")
    has_jumps = any("if(" in value for value in run.settings.values())
    if scene.has_cells:
        # heat that is not resolved, and contact; the velocity of a viscous rod, (C6.12)
        gained = -numpy.diff(c["numerical_dissipation"]) - numpy.diff(c["dissipation"]) / 8
        if (gained > 1e-12 * scale).any():
            yield f"the scheme gives {max(gained)}"
    elif not scene.is_euler and not (scene.is_wide and (has_jumps or tolerance == "automatic")):
        # what the scheme leaves, but for impacts
        losses = numpy.diff(lost)
        for time in run.events["time"] if scene.condition == "rigid" and scene.b > 0 else ():
            row = int(numpy.argmin(abs(c["time"] - time)))
            losses[max(0, row - 1):row + 1] = 0
        yield differences(numpy.cumsum(losses), 0 * losses, LOSS if tolerance == "automatic" else
                          0.3 * float(tolerance), scale + 1e-12)
    if scene.conserves and not (scene.works and scene.is_wide):
        yield differences(lost, zero, 1e-5, scale)
    if scene.is_euler and (scene.condition in ("none", "normal compliance")) and \
            not scene.works and (numpy.diff(c["numerical_dissipation"]) < -EXACT * scale).any():
        yield "numerical dissipation of backward Euler falls"
    if not scene.works:
        yield differences(c["work"], zero, 0)


@column("displacement_end", "velocity_end", "contact_impulse", "contact_force")
def check_rates(run):
    """Differences of u(1) are those of its velocity, of the impulse those of the force: of
    backward Euler exactly, else by the rule of trapezoids, where no impact makes it jump:
    exactly the impulse of a rod that conserves energy, in contact at both ends of a step; of
    one end at most half as much, of none nothing."""
    c, scene = run.contact, scene_of(run)
    if not scene.moves:
        return
    dt, is_step = c["step_size"][1:], c["time"][1:] > 0.02
    for values, rate in (("displacement_end", "velocity_end"),
                         ("contact_impulse", "contact_force")):
        found, ends = numpy.diff(c[values]), c[rate][1:] * dt
        if scene.conserves and scene.is_rod and values == "contact_impulse":
            mean = (ends + c[rate][:-1] * dt) / 2
            n_ends = (c[rate][1:] != 0) * 1 + (c[rate][:-1] != 0)
            yield differences(found[n_ends == 2], mean[n_ends == 2], EXACT)
            if (found * mean < 0).any() or (abs(found) > abs(mean))[n_ends < 2].any():
                yield "impulse of a step that begins or ends contact"
        if scene.condition == "rigid" and values == "contact_impulse":
            continue
        if scene.is_euler:
            yield differences(found[1:], ends[1:], 1e-9, abs(ends).max() + 1e-3)
        else:
            error = (found - (ends + c[rate][:-1] * dt) / 2)[is_step]
            if scene.condition != "rigid" and numpy.linalg.norm(error) > ROUGH * numpy.linalg.norm(found) + 1e-6:
                yield f"{values}: not the integral of {rate}"


@check(*(f"probes.csv/{field}_{i}" for i in (1, 2) for field in (
    "temperature", "displacement", "velocity", "stress")), "probes.csv/time",
       "contact.csv/displacement_mid", "contact.csv/temperature_end",
       "contact.csv/displacement_end", "contact.csv/velocity_end")
def check_probes(run):
    """The middle and the end of a rod are those of contact.csv, and of the snapshots, which
    are at the multiples of their interval and at the first contact and have vectors of 3
    components."""
    c, q = run.contact, run.probes
    interval = run.settings.number("Output/Fields interval")
    yield differences([time for time, _ in run.snapshots()], c["time"][with_first_contact(
        due(c["time"], interval, c["time"][-1]), c, run.events)], EXACT, 1.)
    for _, mesh in run.snapshots():
        for field, values in mesh.point_data.items():
            n = {"temperature": 1, "stress": 1 if scene_of(run).is_rod else 9}.get(field, 3)
            if values.size != n * len(mesh.points):
                yield f"components of {field}"
    yield differences(q["time"], c["time"], 0)
    pairs = [("displacement_1", "displacement_mid")] + ([
        (f"{name}_2", f"{name}_end") for name in ("temperature", "displacement", "velocity")]
        if scene_of(run).is_rod else [])
    for one, two in pairs:
        fault = differences(q[one], c[two], EXACT, 1.)
        yield fault and f"{one}: {fault}"
    for i in (1, 2):
        for field in ("temperature", "displacement", "velocity", "stress"):
            is_there = run.settings.has("temperature" if field == "temperature" else
                                        "displacement")
            if numpy.isnan(q[f"{field}_{i}"][1:]).any() == is_there:
                yield f"{field}_{i}: not a number"
    for time, mesh in run.snapshots():
        row, = numpy.flatnonzero(abs(c["time"] - time) < 1e-12)[:1]
        points = mesh.points[:, :3].copy()
        for i, place in enumerate(run.probe_positions(), 1):
            place = numpy.pad(numpy.array(place), (0, 3 - len(place)))
            distance = numpy.linalg.norm(points - place, axis=1)
            if distance.min() > 1e-6:
                continue
            at = numpy.flatnonzero(distance < 1e-6)
            for field, values in mesh.point_data.items():
                x = values.reshape(len(points), -1)[at, 0]
                found, scale = q[f"{field}_{i}"][row], abs(values).max() + 1e-3
                if not (x.min() - SINGLE * scale <= found <= x.max() + SINGLE * scale) and \
                        not (math.isnan(found) and field == "velocity"):
                    yield f"{field}_{i} at {time:g} is {found}, not {x}"


def extremes(x, values):
    """Places, and the smallest and the largest value at each: stresses have two."""
    places, index = numpy.unique(numpy.round(x, 5), return_inverse=True)
    return places, *(function.reduceat(values[numpy.argsort(index, kind="stable")],
                                       numpy.unique(numpy.sort(index), return_index=True)[1])
                     for function in (numpy.minimum, numpy.maximum))


@column("displacement_end", "velocity_end", "temperature_end")
def check_space_time(run):
    """A rod's file over x and t: rows at its interval, the end, the snapshots."""
    mesh, c = run.space_time(), run.contact
    interval = run.settings.number("Output/Space-time interval")
    if (mesh is None) != (interval == 0):
        yield "no space-time.vtu, or one that is not wanted"
    if mesh is None or not scene_of(run).is_rod:
        return
    x, t = mesh.points[:, 0], mesh.points[:, 1]
    times = c["time"][due(c["time"], interval, c["time"][-1])]
    yield differences(numpy.unique(t), times, SINGLE, 1.)
    for field, values in mesh.point_data.items():
        values = values.reshape(len(t), -1)[:, 0].astype(float)
        for time in times if field != "stress" else ():
            found = values[(abs(t - time) < 1e-6) & (x > 1 - 1e-6)]
            yield differences(found[:1], c[f"{field}_end"][c["time"] == time], SINGLE,
                              1e-3 + numpy.nanmax(abs(values)))
        for time, snapshot in run.snapshots():
            if abs(times - time).min() < 1e-12:
                there = snapshot.point_data[field].reshape(len(snapshot.points), -1)[:, 0]
                now = abs(t - time) < 1e-6
                for one, two in zip(extremes(x[now], values[now]),
                                    extremes(snapshot.points[:, 0], there.astype(float))):
                    fault = differences(one, two, SINGLE, 1e-3 + numpy.nanmax(abs(values)))
                    yield fault and f"{field} over time at {time:g}: {fault}"


@column("energy", "dissipation", "temperature_mean")
def check_snapshots(run):
    """Mean temperature, energy (M2.2), and of backward Euler the dissipation (D4.2), by the
    polynomials of a rod's snapshots. Box has velocities of cells, of which a node where contact
    begins, with a jump, is the mean."""
    c, scene, s = run.contact, scene_of(run), run.settings
    if not scene.is_rod or not run.snapshots():
        return
    k, theta_obs = s.get("Boundary/right/Heat exchange", "0"), s.get(
        "Boundary/right/Surroundings", "0")
    is_steady = not s.number("Boundary/sides/Heat exchange") and not (
        re.search("[a-z]", scene.drive + k + theta_obs))
    e = equidistant(int(s["Mesh/Degree"]))
    B, G = e.values(e.points), e.derivatives(e.points)
    energies, rates, rows = [], [], []
    for time, mesh in run.snapshots():
        x = mesh.points[:, 0].reshape(-1, e.n).astype(float)
        h = (x[:, -1] - x[:, 0])[:, None]
        ratio = s.number("Mesh/Grading", 1)**(-1 / (len(h) - 1))  # of neighbours, all the same
        yield differences((h[1:] / h[:-1])[:, 0], numpy.full(len(h) - 1, ratio), SINGLE)
        fields = {name: values.reshape(len(mesh.points), -1)[:, 0].reshape(-1, e.n).astype(
            float) for name, values in mesh.point_data.items()}

        def integral(values):
            return float(((values @ e.weights)[:, None] * h).sum())
        row = int(numpy.argmin(abs(c["time"] - time)))
        if scene.has_cells and len(run.events["time"]) and abs(
                time - run.events["time"][0]) <= c["step_size"][row]:
            continue
        rows.append(row)
        energy, rate = 0., 0.
        if scene.has_heat:
            theta = fields["temperature"]
            if abs(integral(theta @ B.T) - c["temperature_mean"][row]) > SINGLE * (
                    abs(theta).max()):
                yield f"temperature_mean in row {row}"
            if not is_steady:
                continue
            k_s, inner, outer = float(k), float(scene.drive), float(theta_obs)
            drop = k_s / (k_s + 1) * (inner - outer)
            away = theta @ B.T - inner + drop * (x[:, :1] + h * e.points)
            energy += integral(away**2) / 2
            rate += integral((theta @ G.T / h + drop)**2) + k_s * (
                theta[-1, -1] - inner + drop)**2
        if scene.moves:
            strain = fields["displacement"] @ G.T / h
            energy += integral(strain**2) / 2 + scene.b / 2 * integral(
                (fields["velocity"] @ B.T)**2)
            if scene.has_heat:
                energy -= scene.a * integral(
                    (inner - drop * (x[:, :1] + h * e.points)) * strain)
            rate += scene.zeta * integral((fields["velocity"] @ G.T / h)**2)
            if scene.has_obstacle and scene.condition != "rigid":
                energy += scene.epsilon / (scene.m + 1) * (
                    max(0., -c["gap"][row]) / scene.epsilon)**(scene.m + 1)
        energies.append(energy)
        rates.append(rate)
    has_masses = "massless contact nodes" not in run.summary["terms"]
    if energies and has_masses and not (scene.b == 0 and math.isnan(c["velocity_end"][0])):
        # velocities of cells are means at nodes
        yield differences(c["energy"][rows], energies, 2e-3 if scene.has_cells else 1e-4,
                          max(map(abs, energies)) + 1e-6)
        if scene.is_euler and len(rows) == len(c) and scene.condition != "rigid":
            expected = numpy.cumsum(numpy.array(rates) * c["step_size"]) - rates[0] * \
                c["step_size"][0]
            yield differences(c["dissipation"], expected, 1e-3)


@check(*(f"poincare.csv/{name}" for name in (
    "step", "time", "step_size", "displacement_end", "displacement_mid", "velocity_end",
    "stress_end", "gap", "penetration", "contact_force", "contact_impulse",
    "temperature_end", "heat_flux_end", "energy", "dissipation", "numerical_dissipation",
    "in_contact", "iterations", "work", "temperature_mean", "lateral_heat_flux",
    "lateral_dissipation", "contact_dissipation", "contact_area", "max_pressure", "min_gap",
    "moment_y", "moment_z")))
def check_poincare(run):
    """The rows at the multiples of the period, all of them."""
    if not run.has_table("poincare"):
        return
    period, c = run.settings.number("Output/Period"), run.contact
    if run.poincare.names != c.names:
        yield "other columns than contact.csv"
    times = period * numpy.arange(math.floor(c["time"][-1] / period + 1e-9) + 1)
    yield differences(run.poincare["time"], times, 1e-9, 1.)
    rows = [int(numpy.argmin(abs(c["time"] - time))) for time in times]
    for name in c.names:
        fault = differences(run.poincare[name], c[name][rows], 0)
        yield fault and f"poincare.csv/{name}: {fault}"


@column("contact_area", "max_pressure", "min_gap", "moment_y", "moment_z", "iterations")
def check_face(run):
    """Of a body: areas and pressures that can make the force; counts."""
    c, s = run.contact, run.settings
    counts = c["iterations"]
    if (counts < 0).any() or (counts != numpy.round(counts)).any():
        yield "iterations"
    if "contact_area" not in c.names:
        return
    force, area, largest = abs(c["contact_force"]), c["contact_area"], c["max_pressure"]
    width = s.number("Mesh/Width")
    if not scene_of(run).moves:
        for name in ("contact_area", "max_pressure", "min_gap", "moment_y", "moment_z"):
            yield differences(c[name], 0 * counts, 0)
        return
    yield differences(c["min_gap"], c["gap"], 0)
    if (area < 0).any() or (area > 1 + 1e-12).any() or ((area > 0) > (
            c["in_contact"] == 1)).any():
        yield "contact_area"
    if (force > abs(largest) * area * (1 + 1e-9) + 1e-14).any() or \
            (abs(largest) > 0)[area == 0].any():
        yield "max_pressure"
    if not any(re.search(r"\by\b", value) for value in s.values()):
        for name in ("moment_y", "moment_z"):  # symmetric data
            yield differences(c[name], 0 * counts, 1e-7, width * max(1e-3, force.max()))
    for name in ("moment_y", "moment_z"):
        if (abs(c[name]) > width / 2 * force * (1 + 1e-9) + 1e-14).any() and \
                scene_of(run).rear_gap == math.inf:
            yield name


def weights_of_face(settings):
    """Of the nodes sorted by y, then by z: integrals of their polynomials."""
    degree, cells = int(settings["Mesh/Degree"]), int(settings["Mesh/Cells across"])
    weights = numpy.zeros(cells * degree + 1)
    for first in range(0, cells * degree, degree):
        weights[first:first + degree + 1] += lobatto(degree).integrals / cells
    return weights if settings["Dimension"] == "2" else numpy.outer(weights, weights).ravel()


@column("max_pressure", "min_gap", "contact_force", "contact_area")
def check_nodes(run):
    """The law at each node of a body's face, in the snapshots of it, whose temperature is
    that of the body; means by the weights of the nodes."""
    c, scene = run.contact, scene_of(run)
    if len(run.snapshots("contact.pvd")) != (len(run.snapshots()) if not scene.is_rod and
                                             scene.has_obstacle else 0):
        yield "not as many contact faces as snapshots"
    for (time, face), (_, body) in zip(run.snapshots("contact.pvd"), run.snapshots()):
        row = int(numpy.argmin(abs(c["time"] - time)))
        places, nodes = numpy.unique(numpy.round(face.points, 6), axis=0, return_index=True)
        weights = weights_of_face(run.settings)
        at_nodes = {name: values.ravel()[nodes].astype(float)
                    for name, values in face.point_data.items()}
        if len(places) != len(weights) or abs(places[:, 0] - 1).max() > 1e-6:
            yield f"{len(places)} nodes of the face"
        closed = at_nodes["contact_pressure"] != 0
        if (at_nodes["in_contact"] != closed).any():
            yield "in_contact of the face"
        for name, values in (("contact_force", at_nodes["contact_pressure"]),
                             ("contact_area", closed)):
            yield differences([c[name][row]], [weights @ values], SINGLE,
                              1e-3 + abs(at_nodes["contact_pressure"]).max())
        if scene.has_heat:
            away = numpy.linalg.norm(places[:, None] - body.points[None], axis=2)
            both = away.min(axis=1) < 1e-6
            there = body.point_data["temperature"].ravel()[away[both].argmin(axis=1)]
            yield differences(at_nodes["temperature"][both], there, SINGLE, 1.)
        p, gap = (face.point_data[name].ravel().astype(float) for name in (
            "contact_pressure", "gap"))
        for name, value in (("max_pressure", abs(p).max()), ("min_gap", gap.min())):
            fault = differences([c[name][row]], [value], SINGLE, 1e-3 + abs(value))
            yield fault and f"{name} at {time:g}: {fault}"
        if scene.condition == "rigid":
            yield differences(p * gap, 0 * p, SINGLE, 1. + abs(p).max())
        elif not scene.is_damped:
            yield differences(abs(p), (numpy.maximum(0, -gap) / scene.epsilon)**scene.m,
                              1e-3, abs(p).max() + 1e-3)
        if scene.rear_gap == math.inf and (p < 0).any():
            yield "a node that is pulled"


def sides_of(events):
    """1 of the front stop, -1 of the rear one."""
    return numpy.array([-1. if side == "rear" else 1. for side in events["side"]]
                       if "side" in events.names else numpy.ones(len(events)))


@check("events.csv/time", "events.csv/kind", "events.csv/velocity", "events.csv/duration",
       "events.csv/side")
def check_events(run):
    """Begin and end in turn, where in_contact changes; durations; velocities of the rows
    beside, towards the stop at a begin."""
    c, e, scene = run.contact, run.events, scene_of(run)
    if e["kind"] != (["begin", "end"] * len(e))[:len(e)]:
        yield "not begin and end in turn"
    if not len(e):
        return
    if "side" in e.names and not set(e["side"]) <= {"front", "rear"}:
        yield f"{e['side']}"
    is_end = numpy.array([kind == "end" for kind in e["kind"]])
    yield differences(e["duration"], numpy.where(is_end, numpy.diff(
        e["time"], prepend=numpy.nan), numpy.nan), EXACT, 1.)
    if not scene.is_rod or scene.b == 0:
        return
    side, v = sides_of(e), e["velocity"]
    g = scene.at_end("Contact/Gap", e["time"])
    rate = numpy.where(
        side > 0, (scene.at_end("Contact/Gap", e["time"] + 1e-6) - g) * 1e6, 0.)
    u = numpy.interp(e["time"], c["time"], c["displacement_end"])
    place = numpy.where(side > 0, g, -scene.rear_gap)
    if (abs(u - place) > 2e-3)[~is_end | (scene.d == 0)].any():
        yield f"events where u(1) is {u}, not {place}"
    if ((side * v < -1e-3) & ~is_end & (e["time"] > 0)).any():
        yield "contact begins by moving away"
    for time, velocity, offset in zip(e["time"], v, rate):
        row = int(numpy.argmin(abs(c["time"] - time)))
        near = c["velocity_end"][max(row - 2, 0):row + 3] - offset
        slack = 0.02 + numpy.ptp(near) / 2
        if time > 0 and not near.min() - slack <= velocity <= near.max() + slack:
            yield f"velocity {velocity} at {time}"


@check("steps.csv/time", "steps.csv/step_size", "steps.csv/accepted", "steps.csv/error",
       "steps.csv/reason", "steps.csv/wall_seconds")
def check_attempts(run):
    """Attempts start where the last accepted one ended, at the rows of contact.csv."""
    if not run.has_table("steps"):
        return
    a, c, e = run.steps, run.contact, run.events
    accepted = a["accepted"] == 1
    yield differences(a["accepted"], accepted, 0)
    yield differences(a["step_size"][accepted], c["step_size"][1:], 0)
    starts = numpy.concatenate([[0], c["time"][1:]])[numpy.cumsum(accepted) - accepted]
    yield differences(a["time"], starts, EXACT, 1.)
    if (a["wall_seconds"] <= 0).any():
        yield "wall_seconds"
    yield differences([a["wall_seconds"].sum()], [run.summary["step_seconds"]], 1e-4)
    ends, T = a["time"] + a["step_size"], run.settings.number("Time/End time")
    period = run.settings.number("Output/Period")
    for i, (reason, error) in enumerate(zip(a["reason"], a["error"])):
        is_known = reason in (("ok", "load", "event", "output", "end") if accepted[i] else
                              ("tolerance", "contact", "failed"))
        good = {"end": abs(ends[i] - T) < 1e-9, "tolerance": error > 0.2,
                "ok": error <= 1 and abs(ends[i] - T) > 1e-9,
                "event": not scene_of(run).is_rod or (  # of a body that of any node
                    len(e) and abs(ends[i] - e["time"]).min() < 0.02),
                "output": period and abs(math.remainder(ends[i], period)) < 1e-9,
                "contact": i + 1 < len(a) and a["step_size"][i + 1] < a["step_size"][i] * 1.0001
                }.get(reason, True)
        at_event = scene_of(run).is_rod and len(e) and accepted[i] and abs(
            ends[i] - e["time"]).min() < 1e-12
        if at_event and reason == "ok":
            yield f"row {i}: an event, {reason}"
        if not is_known or not good or reason != "failed" and not error >= 0 and \
                not math.isnan(error):
            yield f"row {i}: {reason}, error {error}"


@key("title", "status", "version", "dimension", "ranks", "fields", "scheme", "terms",
     "warnings")
def check_names(run):
    """Entries of the file, heads of the tables, lines of the log; terms that act."""
    s, scene, terms = run.settings, scene_of(run), run.summary["terms"]
    version = run.contact.comments[1].split(",")[0].removeprefix("thermocontact ")
    yield from compare(run, {
        "title": s["Title"], "status": "done", "version": version,
        "dimension": int(s["Dimension"]), "scheme": s["Time/Scheme"],
        "fields": [name for name in ("temperature", "displacement") if s.has(name)],
        "ranks": int(re.search(r"ranks: (\d+)", run.log)[1]),
        "warnings": re.findall(r"^  warning:  (.*)$", run.log, re.MULTILINE)})
    for table in run.tables.values():
        if table.comments[0] != s["Title"] or version not in table.comments[1]:
            yield "the head of a table"
    exchange, outer = s.get("Boundary/right/Heat exchange", "0"), s.get("Boundary/right/Surroundings", "0")
    gap, has_inertia = s.get("Contact/Gap", "0"), scene.moves and scene.b > 0
    acts = [name for path, name in LOADS.items() if s.get(path, "0") != "0"]
    expected = [name for name, is_there in {
        "heat conduction": scene.has_heat,
        "heat exchange": scene.has_states or float(exchange) > 0,
        "lateral heat exchange": s.number("Boundary/sides/Heat exchange") > 0,
        "inertia": has_inertia, "elasticity": scene.moves,
        "free end on the left": scene.moves and s.get("Boundary/left/Support") == "free",
        **{f"{what.lower()} on the {end}": s.number(f"Boundary/{end}/{what}") > 0
           for end in ("left", "right") for what in ("Spring", "Dashpot", "Mass")},
        "viscosity": scene.moves and scene.zeta > 0, "thermal stress": scene.a != 0,
        "thermoelastic heating": scene.a and s["Model/Thermoelastic heating"] == "true",
        "rigid contact": scene.condition == "rigid",
        scene.condition: scene.condition not in ("rigid", "none"),
        "damped contact": scene.has_obstacle and scene.is_damped,
        "two stops": scene.has_obstacle and scene.rear_gap < math.inf,
        "massless contact nodes": "massless contact nodes" in terms,
        "lumped mass": s.get("Mesh/Mass matrix") == "lumped" and (scene.has_heat or has_inertia),
        "mass in the middles of cells": s["Time/Scheme"] == "box",
        **dict.fromkeys(acts, True),
        "varying temperature of the obstacle": "t" in outer and not scene.has_states,
        "varying temperature of the fixed end": "t" in scene.drive,
        "moving fixed end": s.get("Boundary/left/Displacement", "0") != "0",
        "moving obstacle": scene.has_obstacle and "t" in gap}.items() if is_there]
    if terms != expected:
        yield f"terms {terms}, not {expected}"
    if scene.has_obstacle and s.get("Contact/Massless nodes") == "automatic" and s[
            "Time/Scheme"] != "box" and ", start of the paper" not in run.log:
        n, degree = int(s["Mesh/Cells"]), int(s["Mesh/Degree"])
        ratio = s.number("Mesh/Grading", 1)**(1 / max(1, n - 1))
        spacing = 1 / sum(ratio**i for i in range(n)) / degree
        w = spacing / (degree + 1)
        critical = (2 * w * math.sqrt(1 + w / scene.epsilon)
                    if scene.condition == "normal compliance" else spacing)
        carries = s.number("Boundary/right/Mass") + s.number("Boundary/right/Dashpot") > 0
        if ("massless contact nodes" in terms) != (
                scene.b > 0 and not scene.is_damped and not carries and n * degree > 1 and (
                scene.conserves or not scene.is_rod and scene.condition == "rigid" or
                scene.zeta < critical * math.sqrt(scene.b))):
            yield "massless contact nodes"
    words = re.search(r"^  terms +(.*(?:\n {12,}\S.*)*)", run.log, re.MULTILINE)
    if words and ", ".join(terms) != re.sub(r"\s+", " ", words[1]):
        yield f"terms of the log: {words[1]}"


@key("title", "dofs")
def check_head(run):
    """The first lines of log.txt: the entries, the mesh that they make, the gap at the nodes;
    first the version in used.prm."""
    s, scene, dim = run.settings, scene_of(run), int(run.settings["Dimension"])
    cells, degree, width = (s.number("Mesh/" + name) for name in (
        "Cells", "Degree", "Width"))
    across, gap = s.number("Mesh/Cells across"), s.get("Contact/Gap", "0")
    lines = {"body": f"{cells * across**(dim - 1):g} cells of degree {degree:g}",
             "time": f"T = {s.number('Time/End time'):g}"}
    if dim > 1:
        lines["body"] += f", sides 1 : {across / cells / width:g}, lateral faces: "
        lines |= {"memory": "about 0.1",  # 0.17 GB of the process itself, and a bit
                  "set up": f" s, factorised at once: {run.summary['factorized_unknowns']}"}
    if not s.has_error_control():
        size, end = s.step_size(), s.number("Time/End time")
        lines["time"] = (f"dt = {size:g}, {math.ceil(end / size * (1 - 1e-6)):g} steps, " +
                         lines["time"])
    if scene.moves:
        lines["model"] = f"b = {scene.b:g}, zeta = {scene.zeta:g}"
    if scene.has_heat:
        outer = s.get("Boundary/right/Surroundings", "0")
        lines["heat"] = f"theta_obs = {outer if 't' in outer else f'{float(outer):g}'}"
    if scene.has_obstacle:
        front = re.sub("[ty].*", "", gap) if re.search("[ty]", gap) else f"{float(gap):g}"
        lines["contact"] = f"g = {front}"
    if scene.has_obstacle and "y" in gap:
        y = numpy.linspace(0, width, int(across * degree) + 1)
        ends = 0.05 + 0.5 * (y - 0.03)**2
        lines["gap"] = f"{ends.min():.6g} to {ends.max():.6g} at the contact nodes"
    for title, words in lines.items():
        if not re.search(rf"^  {title} +.*{re.escape(words)}", run.log, re.MULTILINE):
            yield f"{title}: not {words}"
    if scene.has_obstacle and scene.condition != "rigid" and not re.search(
            rf"^  contact +.*epsilon = {scene.epsilon:g},", run.log, re.MULTILINE):
        yield f"contact: not epsilon = {scene.epsilon:g}"
    is_fast = s.has_error_control() and any(
        re.search(r"(sin|cos)\(\d\*t", value) for value in s.values())
    if is_fast != (" steps end at 0 jumps and 0 kinks, and are at most " in run.log):
        yield "loads"
    unknowns = re.search(r"^  unknowns (.*)$", run.log, re.MULTILINE)[1]
    if sum(map(int, re.findall(r"\d+", unknowns))) != run.summary["dofs"]:
        yield f"unknowns: {unknowns}"
    version = run.contact.comments[1].split(",")[0]
    if not (run.directory / "used.prm").read_text().startswith(f"# {version}: every entry"):
        yield "the head of used.prm"


@key("dofs", "factorized_unknowns", "steps", "rejected_steps", "solves", "factorizations",
     "responses", "linear_solver", "linear_iterations", "max_linear_iterations",
     "active_set_iterations")
def check_counts(run):
    """Nodes and components; rows; a solve for each stage of each attempt."""
    s, scene, m = run.settings, scene_of(run), run.summary
    dim, degree = int(s["Dimension"]), int(s["Mesh/Degree"])
    nodes = int(s["Mesh/Cells"]) * degree + 1
    if dim > 1:
        nodes *= (int(s["Mesh/Cells across"]) * degree + 1)**(dim - 1)
    sizes = [nodes] * scene.has_heat + [dim * nodes] * scene.moves
    heats = scene.a and s["Model/Thermoelastic heating"] == "true"
    rejected = int((run.steps["accepted"] == 0).sum()) if run.has_table("steps") else 0
    stages = {"backward euler": 1, "sdirk2": 2, "sdirk3": 3, "sdirk4": 5, "energy conserving": 1, "box": 1}[s["Time/Scheme"]]
    attempts = len(run.contact) - 1 + rejected
    yield from compare(run, {
        "dofs": sum(sizes), "factorized_unknowns": sum(sizes) + nodes * scene.has_heat if s[
            "Time/Scheme"] == "box" else sum(sizes) if heats else max(sizes),
        "steps": len(run.contact) - 1, "rejected_steps": rejected, "linear_iterations": 0,
        "linear_solver": "direct" if dim > 1 else "block tridiagonal, direct" if (
            scene.is_wide and "," in m["linear_solver"]) else "block tridiagonal",
        "max_linear_iterations": 0, "active_set_iterations": 0})
    if not attempts <= m["solves"] <= 2 * stages * attempts + 1:
        yield f"{m['solves']} solves of {attempts} attempts"
    per_length = 1 if heats and not scene.has_cells else 2  # of each field, or viscous
    if not 1 <= m["factorizations"] <= per_length * m["solves"] + 4 or m["responses"] < 0 or (
            m["responses"] > 0 and not scene.has_obstacle and dim == 1):
        yield f"{m['factorizations']} factorisations, {m['responses']} responses"


@key("contact_begins", "first_contact_time", "contact_duration", "restitution",
     "contact_impulse", "max_penetration", "max_contact_force", "max_energy_increase",
     "final_time", "final_displacement_end", "final_energy", "final_contact_force",
     "final_temperature_end", "final_in_contact")
def check_results(run):
    """From events.csv and the rows: counts, sums, largest and last values."""
    s, scene = run.settings, scene_of(run)
    c, e, m = run.contact, run.events, run.summary
    is_begin = numpy.array([kind == "begin" for kind in e["kind"]], bool)
    begins, ends = (e["time"][mask] if len(e) else e["time"] for mask in (
        is_begin, ~is_begin))
    is_open = [c["time"][-1]] * (len(begins) - len(ends))
    yield from compare(run, {
        "contact_begins": len(begins), "final_in_contact": bool(c["in_contact"][-1]),
        "first_contact_time": float(begins[0]) if len(begins) else None})
    towards = e["velocity"] * sides_of(e)
    impact, release = (towards[mask] if len(e) else [] for mask in (is_begin, ~is_begin))
    known = [v for v in impact if not math.isnan(v)]  # what lies there at t = 0 has none
    ratio = -release[-1] / known[0] if len(release) and known and known[0] > 0 else math.nan
    created = numpy.diff(c["energy"]) - numpy.diff(c["work"])
    last = {f"final_{name}": float(c[name][-1]) for name in (
        "time", "displacement_end", "energy", "contact_force", "temperature_end")}
    yield from compare(run, {
        "contact_duration": float(sum([*ends, *is_open]) - sum(begins)),
        "restitution": float(ratio),
        "contact_impulse": float(c["contact_impulse"][-1]), **last}, 1e-9)
    yield differences([m["max_energy_increase"]], [max(0., float(max(created)))], 1e-13,
                      1e4 * max(0., *created) + abs(c["energy"]).max())
    rows = {"max_contact_force": float(max(abs(c["contact_force"]))),
            "max_penetration": float(max(c["penetration"]))}
    if not scene.has_rates_of_force:
        yield from compare(run, rows, 1e-9)
        return
    tops = {"max_contact_force": top_of_cubics(c, "contact_force", scene.m),
            "max_penetration": top_of_cubics(c, "penetration", 1)}
    if "t" in s.get("Contact/Gap", "0"):  # its velocity is in no table
        if any(m[name] < value * (1 - 1e-9) for name, value in rows.items()):
            yield "largest values below those of the rows"
        return
    yield from compare(run, {name: max(rows[name], tops[name]) for name in rows}, 1e-9)


@key("predicted_displacement_end", "predicted_contact_force", "predicted_temperature_end",
     "predicted_in_contact", "predicted_remark", "difference_displacement_end",
     "difference_contact_force", "difference_temperature_end",
     "predicted_first_contact_time", "predicted_first_penetration",
     "predicted_critical_step_size", "predicted_steps")
def check_forecast(run):
    """How far the last row is from rest, which is that of the law and the heat exchange;
    the first contact and the steps of the run itself."""
    m, c, scene, s = run.summary, run.contact, scene_of(run), run.settings
    for name in ("displacement_end", "contact_force", "temperature_end"):
        rest, found = m[f"predicted_{name}"], m[f"difference_{name}"]
        expected = math.nan if rest is None else float(c[name][-1] - rest)
        if not (nearly(found, expected, 1e-9) or rest is not None and found is not None and
                abs(found - expected) < 1e-12):
            yield f"difference_{name} is {found} instead of {expected}"
    u, p, theta = (m[f"predicted_{name}"] for name in (
        "displacement_end", "contact_force", "temperature_end"))
    if (u is None and p is None and theta is None) != bool(m["predicted_remark"]) and (
            m["predicted_remark"] or scene.moves):
        yield f"remark {m['predicted_remark']!r}"
    if p is None and (m["predicted_in_contact"] is None) != bool(m["predicted_remark"]):
        yield "predicted_in_contact"
    if p is not None and (m["predicted_in_contact"] != (p != 0) or (
            scene.is_rod and scene.condition == "normal compliance" and abs(
                p - max(0, u - s.number("Contact/Gap")) / scene.epsilon + max(
                    0, -u - scene.rear_gap) / scene.epsilon) > 1e-9)):
        yield f"predicted_contact_force {p}"
    if theta is not None and not scene.has_states:
        yield differences([theta], [scene.rest_of_end(s.number("Boundary/right/Heat exchange"))],
                          EXACT)
    time, first = m["predicted_first_contact_time"], m["first_contact_time"]
    if time is not None and first is not None and abs(time - first) > 0.05 * first + 0.02:
        yield f"predicted_first_contact_time {time}, found {first}"
    deep = m["predicted_first_penetration"]
    if deep is not None and (time is None or deep < 0 or len(run.events) > 1 and
                             deep > 3 * m["max_penetration"] + 0.02):
        yield f"predicted_first_penetration {deep}"
    steps = m["predicted_steps"]
    is_at_rest = not abs(c["energy"]).max() > 0
    if steps is not None and not is_at_rest and not 0.1 < steps / m["steps"] < 10:
        yield f"predicted_steps {steps}"
    size = m["predicted_critical_step_size"]
    if size is not None and not 1e-6 < size < 10:
        yield f"predicted_critical_step_size {size}"


@key("states_of_rest", "reached_state_of_rest")
def check_states(run):
    """Each is at rest with its own heat exchange; the one that the end has come to."""
    m, scene, s = run.summary, scene_of(run), run.settings
    k, states = s.get("Boundary/right/Heat exchange", "0"), m.get("states_of_rest")
    if scene.has_states != (states is not None) or states == [] and scene.is_rod and \
            not scene.is_driven:
        yield "states_of_rest"
    for state in states or []:
        theta, p = state["temperature_end"], state["contact_force"]
        if not scene.is_driven:
            u = state["displacement_end"] or 0.
            rate = eval(k, {"pressure": abs(p or 0.), "gap": max(0., min(
                s.number("Contact/Gap") - u, scene.rear_gap + u))})
            yield differences([theta], [scene.rest_of_end(rate)], 1e-7)
    if states is not None:
        reached = m["reached_state_of_rest"]
        near = [i for i, state in enumerate(states, 1) if abs(
            state["temperature_end"] - m["final_temperature_end"]) < 1e-3 * abs(
                state["temperature_end"])]
        if reached is not None and reached not in near:
            yield f"reached {reached}"


@key(*TIMES, "peak_memory_mb", "peak_memory_mb_per_rank")
def check_costs(run):
    """Parts of the whole; megabytes of each rank and their sum."""
    m = run.summary
    if not all(isinstance(m[name], float) and m[name] >= 0 for name in TIMES):
        yield "not a time"
        return
    parts = m["set_up_seconds"] + m["loop_seconds"] + m["output_seconds"]
    if not -0.01 < m["wall_seconds"] - parts < 0.5 or m["step_seconds"] > \
            m["loop_seconds"] or m["solve_seconds"] + m["contact_seconds"] > \
            m["step_seconds"] or m["factorization_seconds"] > m["solve_seconds"]:
        yield "a part is longer than the whole"
    ranks = m["peak_memory_mb_per_rank"]
    if len(ranks) != m["ranks"] or not all(10 < part < 2000 for part in ranks) or \
            not nearly(m["peak_memory_mb"], float(sum(ranks)), 1e-12):
        yield "not megabytes of each rank, and their sum"
