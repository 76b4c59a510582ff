# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps of a rod in numpy: what contact.csv, steps.csv and the counters are to say.

Sections 7 to 11 of doc/model.md, from used.prm alone for fixed steps. For
error-controlled steps the sizes of the attempts are those of steps.csv, and contact
changes where events.csv says; everything else is computed.
"""
import math
from collections import OrderedDict

import numpy

from rod_model import Rod, State, has_paper_start

S2 = 1 - math.sqrt(0.5)
S3 = 0.43586652150845899942
TABLEAUS = {  # rows of a, embedded weights; doc/model.md section 10
    "backward euler": ([[1.0]], None),
    "sdirk2": ([[S2], [1 - S2, S2]], None),
    "sdirk3": ([[S3], [(1 - S3) / 2, S3],
                [-(6 * S3**2 - 16 * S3 + 1) / 4, (6 * S3**2 - 20 * S3 + 5) / 4, S3]], None),
    "sdirk4": ([[1 / 4], [1 / 2, 1 / 4], [17 / 50, -1 / 25, 1 / 4],
                [371 / 1360, -137 / 2720, 15 / 544, 1 / 4],
                [25 / 24, -49 / 48, 125 / 16, -85 / 12, 1 / 4]],
               [59 / 48, -17 / 96, 225 / 32, -85 / 12, 0.0]),
}
ROUNDING = 1e-9  # of times, in parts of the end time


def locates_events(settings):
    """True if steps end at contact events: by default those of a tolerance."""
    choice = settings.get("Time/Locate contact events", "automatic")
    return (settings["Time/Step size"] == "automatic" if choice == "automatic" else
            choice == "true")


def sides_of(events):
    """1 at the front stop, -1 at the rear one; of one stop there is no column."""
    return [-1 if side == "rear" else 1 for side in (
        events["side"] if "side" in events.names else ["front"] * len(events))]


class Step:
    """A step: the new state and what is booked."""

    def __init__(self, state):
        self.state = state
        self.work = self.dissipation = self.impulse = self.lost = 0.0
        self.lateral = 0.0  # part of the dissipation
        self.iterations = 0
        self.error = None
        self.fixed_end_impulse = 0.0


class Replay:
    """A run of the rod: rows, states, errors of the attempts, counters."""

    def __init__(self, run):
        self.settings, self.rod = run.settings, Rod(run.settings)
        self.rows, self.states, self.errors, self.modes = [], [], [], []
        self.probes = {}  # histories at places, for the checks
        self.velocities = []  # of the end, before an impact
        self.has_prescribed_step = has_paper_start(self.settings)
        self.counters = {"factorizations": 0, "responses": 0, "solves": 0}
        self.cache = OrderedDict()
        self.scheme = TABLEAUS[self.settings["Time/Scheme"]]
        self.is_iterated = self.settings.get("Solver/Step solver") == "fixed point"
        self.end_time = self.settings.number("Time/End time")
        self.locates = locates_events(self.settings)
        self.mode = "open" if self.locates and self.rod.has_obstacle else "unilateral"
        self.changes = {}  # of the mode, by row
        self.side = 1  # of the stop that is touched or was
        if self.mode == "open":
            accepted = run.steps["accepted"] == 1
            ends = numpy.concatenate([[0], (run.steps["time"] +
                                            run.steps["step_size"])[accepted]])
            self.changes = {numpy.argmin(abs(ends - time)):
                            ("closed" if kind == "begin" else "open", side)
                            for time, kind, side in zip(
                                run.events["time"], run.events["kind"], sides_of(run.events))}
        with numpy.errstate(all="ignore"):  # falsified steps may have size zero
            self.take_steps(run)

    def take_steps(self, run):
        self.start()
        if run.has_table("steps"):
            for start, size, accepted in zip(run.steps["time"], run.steps["step_size"],
                                             run.steps["accepted"]):
                self.attempt(start, size, accepted == 1)
        else:
            self.fixed_steps(self.settings.number("Time/Step size"))

    def fixed_steps(self, size):
        n = max(1, math.ceil(self.end_time / size - 1e-9))
        for i in range(n):
            end = self.end_time if i == n - 1 else (i + 1) * size
            rest = end - i * size
            length = size if abs(rest - size) < 1e-6 * size else rest
            self.accept(self.step(end, length), length)

    def start(self):
        self.state = self.rod.initial_state(self.settings)
        self.terms = self.rod.energy_terms(self.state)
        self.max_thermal = self.terms[0]
        self.max_mechanical = max(self.terms[1:3])
        self.sums = dict.fromkeys(("work", "dissipation", "numerical_dissipation",
                                   "lateral_dissipation", "contact_impulse", "fixed_end_impulse"), 0.0)
        self.mode, self.side = self.changes.get(0, (self.mode, self.side))
        if self.rod.moves and self.rod.b == 0:  # (M.34), (M.35): a system of its own
            self.counters["factorizations"] += 1
            self.counters["responses"] += self.rod.has_obstacle
        self.velocities.append(self.state.v[-1])
        self.record(0.0, 0)


    def attempt(self, start, size, is_accepted):
        """An attempt of an error-controlled step; states the error it has."""
        assert abs(start - self.state.t) < ROUNDING * self.end_time, \
            f"steps.csv: an attempt from t = {start:g}, the state is of {self.state.t:g}"
        end = self.state.t + size
        if abs(end - self.end_time) < ROUNDING * self.end_time:
            end = self.end_time
        step = self.step(end, size)
        self.errors.append(self.relative_error(step))
        self.modes.append(self.mode)
        if is_accepted:
            self.accept(step, size)

    def relative_error(self, step):
        """(M.30) over the tolerance"""
        if step.error is None or self.settings["Time/Step size"] != "automatic":
            return math.nan
        terms = self.rod.energy_terms(step.state)
        thermal = max(self.max_thermal, terms[0])
        mechanical = max(self.max_mechanical, *terms[1:3])
        parts = [(step.error[0], thermal), (sum(step.error[1:4]), mechanical)]
        return (math.sqrt(sum(part / whole for part, whole in parts if part > 0)) /
                self.settings.number("Time/Tolerance"))

    def step(self, end, size):
        if not self.rows[1:] and self.has_prescribed_step:
            return self.prescribed_step(end, size)
        rod, (a, embedded) = self.rod, self.scheme
        tau = a[0][0] * size
        result = Step(None)
        rates = []
        for i, row in enumerate(a):
            known = self.state.copy()
            for weight, (theta_rate, u_rate, v_rate) in zip(row[:i], rates):
                known.theta += size * weight * theta_rate
                known.u += size * weight * u_rate
                known.v += size * weight * v_rate
            known.t = end if i == len(a) - 1 else self.state.t + sum(row) * size
            theta_rate, u_rate, p, iterations = self.stage(known, tau)
            v_rate = (u_rate - known.v) / tau
            rates.append((theta_rate, u_rate, v_rate))
            state = State(known.theta + tau * theta_rate, known.u + tau * u_rate,
                          u_rate, p, known.t)
            result.iterations += iterations
            self.book(state, v_rate, a[-1][i] * size, result)
        result.state = state
        result.lost = (rod.numerical_dissipation(self.state, state) if len(a) == 1 else
                       sum(self.terms) - sum(rod.energy_terms(state)) + result.work -
                       result.dissipation)
        if embedded:
            result.error = self.error_terms(size, rates, embedded, state.p)
        return result

    def error_terms(self, size, rates, embedded, p):
        """Half the squared norms of (M.29)."""
        weights = size * (numpy.array(self.scheme[0][-1]) - embedded)
        e = State(*(sum(w * rate[i] for w, rate in zip(weights, rates))
                    for i in range(3)))
        rod = self.rod
        on_obstacle = e.u[-1]**2 / (2 * rod.epsilon) if p * self.side > 0 and rod.epsilon \
            else 0.0
        return [e.theta @ rod.M @ e.theta / 2, rod.b * e.v @ rod.M_u @ e.v / 2,
                e.u @ rod.S @ e.u / 2, on_obstacle]

    def book(self, state, v_rate, weight, result):
        """Adds a stage to the sums (M.28)."""
        rod = self.rod
        result.dissipation += weight * rod.dissipation_rate(state)
        result.lateral += weight * rod.lateral_dissipation_rate(state)
        result.work += weight * rod.work_rate(state)
        result.impulse += weight * state.p
        if rod.moves:
            f = rod.loads(state.t)[1]
            result.fixed_end_impulse += weight * (
                rod.b * rod.M_u @ v_rate + rod.S @ (state.u + rod.zeta * state.v) -
                rod.a * rod.D.T @ state.theta - f)[0]

    def factorize(self, tau):
        """Counts factorisations as a memory of the last 64 needs them."""
        if tau not in self.cache:
            is_coupled = self.rod.a != 0 and self.rod.heats and not self.is_iterated
            both = self.rod.has_heat and self.rod.moves
            self.counters["factorizations"] += 2 if both and not is_coupled else 1
            self.cache[tau] = False
        self.cache.move_to_end(tau)
        while len(self.cache) > 64:
            self.cache.popitem(last=False)

    def stage(self, known, tau):
        """Rates, pressure and iterations of a stage, (M.14) to (M.17)."""
        self.factorize(tau)
        if self.is_iterated:
            return self.iterate(known, tau)
        rod = self.rod
        rates = rod.rates(known, tau, known.t)
        self.counters["solves"] += 1
        u_free = known.u[-1] + tau * rates[-1]
        if not rod.has_obstacle or self.mode == "open" or (
                self.mode == "unilateral" and rod.gap(u_free) >= 0):
            return *rod.split(rates), 0.0, 0
        response = rod.solver(tau)[1]
        chi = tau * response[-1]
        if not self.cache[tau]:
            self.cache[tau] = True
            self.counters["responses"] += 1
        front = rod.gap(u_free) == rod.g - u_free if self.mode == "unilateral" else (
            self.side > 0)
        p = (u_free - rod.g if front else u_free + rod.g_2) / (rod.epsilon + chi)
        return *rod.split(rates - p * response), p, int(self.mode == "unilateral")

    def iterate(self, known, tau):
        """The paper's iteration (M.19)."""
        rod, s = self.rod, self.settings
        q, f = rod.loads(known.t)
        heat = q + rod.outer_heat - rod.K_B @ known.theta
        momentum = rod.b * rod.M_u @ known.v + tau * (
            f - rod.S @ known.u + rod.a * rod.D.T @ known.theta)
        heat_matrix = (rod.M + tau * rod.K_B)[1:, 1:]
        momentum_matrix = (rod.b * rod.M_u + tau * (rod.zeta + tau) * rod.S)[1:, 1:]
        v, theta_rate = numpy.zeros(rod.n), numpy.zeros(rod.n)
        reach = abs(known.u).max() + tau * abs(known.v).max()
        for iteration in range(1, 101):
            p = rod.pressure(known.u[-1] + tau * v[-1], 0.0)
            theta_rate[1:] = numpy.linalg.solve(heat_matrix, (heat - rod.a * rod.D @ v)[1:])
            rhs = momentum + tau**2 * rod.a * rod.D.T @ theta_rate
            rhs[-1] -= tau * p
            last, v = v, numpy.zeros(rod.n)
            v[1:] = numpy.linalg.solve(momentum_matrix, rhs[1:])
            self.counters["solves"] += 1
            change = tau * abs(v - last).max()
            if change <= s.number("Solver/Fixed point tolerance") * max(
                    reach or abs(rod.g), tau * abs(v).max()):
                break
        p = rod.pressure(known.u[-1] + tau * v[-1], 0.0)
        return theta_rate, v, p, iteration

    def prescribed_step(self, end, size):
        """(M.26)"""
        rod, old = self.rod, self.state
        heat = (rod.loads(end)[0] + rod.outer_heat - rod.K_B @ old.theta -
                rod.a * rod.heats * rod.D @ old.v)
        rate = numpy.zeros(rod.n)
        if rod.has_heat:
            rate[1:] = numpy.linalg.solve((rod.M + size * rod.K_B)[1:, 1:], heat[1:])
            self.counters["factorizations"] += 1
            self.counters["solves"] += 1
        state = State(old.theta + size * rate, old.u + size * old.v, old.v.copy(), 0.0, end)
        if rod.epsilon:
            state.p = rod.pressure(state.u[-1], 0.0)
        result = Step(state)
        self.book(state, 0 * old.v, size, result)
        result.lost = (sum(self.terms) - sum(rod.energy_terms(state)) + result.work -
                       result.dissipation)
        return result

    def impact(self, step):
        """(M.33), with the node put on the obstacle"""
        if not self.rod.is_massless:
            mass, column = self.rod.effective_mass()
            impulse = mass * step.state.v[-1]
            step.state.v -= impulse * column
            step.impulse += impulse
            step.fixed_end_impulse -= impulse * self.rod.b * self.rod.M_u[0] @ column
            if not self.cache.get("impact"):
                self.cache["impact"] = True
                self.counters["factorizations"] += 1
                self.counters["responses"] += 1
        step.state.u[-1] = self.rod.g if self.side > 0 else -self.rod.g_2

    def accept(self, step, size):
        """Takes the step, with what happens at its end if contact changes there."""
        rod = self.rod
        self.state = step.state
        self.velocities.append(self.state.v[-1])
        change, self.side = self.changes.get(len(self.rows), (None, self.side))
        before = sum(rod.energy_terms(self.state))
        if change == "closed" and rod.is_rigid:
            self.impact(step)
        elif change == "closed":
            self.state.p = rod.pressure(self.state.u[-1], 0.0)
        if self.state.p * self.side < 0 and (self.locates or rod.g_2 == math.inf):
            self.state.p = 0.0
        step.lost += before - sum(rod.energy_terms(self.state))
        self.mode = change or self.mode
        for name, value in (("work", step.work), ("dissipation", step.dissipation),
                            ("numerical_dissipation", step.lost),
                            ("lateral_dissipation", step.lateral),
                            ("contact_impulse", step.impulse),
                            ("fixed_end_impulse", step.fixed_end_impulse)):
            self.sums[name] += value
        self.record(size, step.iterations)
        self.terms = rod.energy_terms(self.state)
        self.max_thermal = max(self.max_thermal, self.terms[0])
        self.max_mechanical = max(self.max_mechanical, *self.terms[1:3])

    def record(self, size, iterations):
        """A row of contact.csv"""
        rod, state, nan = self.rod, self.state, math.nan
        row = {"step": len(self.rows), "time": state.t, "step_size": size,
               "iterations": iterations, "energy": sum(rod.energy_terms(state)),
               "in_contact": int(state.p != 0), **self.sums}
        if rod.moves:
            has_velocity = rod.b > 0 or rod.zeta > 0 or state.t > 0
            traction = rod.at_end("End traction", state.t)
            row |= {"displacement_end": state.u[-1],
                    "displacement_mid": rod.values_at(0.5, state.u)[0],
                    "velocity_end": state.v[-1] if has_velocity else nan,
                    "stress_end": traction - state.p, "contact_force": state.p,
                    "penetration": rod.epsilon * abs(state.p),
                    "gap": rod.gap(state.u[-1]) if rod.has_obstacle else nan}
        else:
            row |= dict.fromkeys(("displacement_end", "displacement_mid", "velocity_end",
                                  "stress_end", "contact_force", "penetration", "gap",
                                  "contact_impulse"), nan)
        mass = rod.M @ numpy.ones(rod.n)
        row |= {"temperature_end": state.theta[-1] if rod.has_heat else nan,
                "temperature_mean": mass @ state.theta / mass.sum() if rod.has_heat
                else nan,
                "heat_flux_end": rod.k * (state.theta[-1] - rod.theta_obs)
                if rod.has_heat else nan}
        self.rows.append(row)
        self.states.append(state.copy())
