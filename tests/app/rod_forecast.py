# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known of a rod before a run, section 14 of doc/model.md, in numpy."""
import math

import numpy
from scipy.linalg import solve_banded


def root(function, low, high):
    """A zero by bisection of logarithms or of numbers"""
    rises = function(high) > function(low)
    for _ in range(200):
        middle = math.sqrt(low * high) if low > 0 else (low + high) / 2
        low, high = (low, middle) if (function(middle) > 0) == rises else (middle, high)
    return (low + high) / 2


def half_of_cells(smallest):
    """Cells of half a rod, from its end on, (M.44)"""
    cells = [smallest]
    while sum(cells) < 0.5:
        cells.append(min(1.2 * cells[-1], 1 / 64))
    return 0.5 / sum(cells) * numpy.array(cells)


class CoarseRod:
    """The rod of (M.44) in steps of (M.46): banded systems of (theta, v) at the nodes"""

    GAMMA = 1 - math.sqrt(0.5)

    def __init__(self, rod, settings):
        self.rod = rod
        finest = 1e-3
        if not rod.is_rigid:
            finest = min(max(rod.epsilon / 4, 1e-6), 1e-3)
        h = numpy.concatenate([half_of_cells(1e-3), half_of_cells(finest)[::-1]])
        x = numpy.concatenate([[0], numpy.cumsum(h)[:-1], [1]])
        self.state = numpy.array([
            settings.expression("Initial values/" + name)(x)
            if name != "Temperature" or rod.has_heat else 0 * x
            for name in ("Temperature", "Displacement", "Velocity")])
        self.state[:, 0] = rod.theta_A if rod.has_heat else 0, 0, 0
        n = len(x)
        self.mass, self.stiffness, self.gradient = (
            numpy.zeros((n, n)) for _ in range(3))
        for i in range(n - 1):
            cell = numpy.ix_([i, i + 1], [i, i + 1])
            self.mass[cell] += h[i] / 6 * numpy.array([[2, 1], [1, 2]])
            self.stiffness[cell] += numpy.array([[1, -1], [-1, 1]]) / h[i]
            self.gradient[cell] += numpy.array([[-0.5, 0.5], [-0.5, 0.5]])
        self.tau = None

    def factorize(self, tau):
        """The matrix of a stage without the node at x = 0, as bands"""
        rod, n = self.rod, len(self.mass) - 1
        full = numpy.zeros((2 * n, 2 * n))
        heat = self.mass * (1 / tau + rod.m) + self.stiffness
        heat[-1, -1] += rod.k
        moving = rod.b * self.mass / tau + (rod.zeta + tau) * self.stiffness
        full[1::2, 1::2] = moving[1:, 1:]
        full[0::2, 0::2] = heat[1:, 1:] if rod.has_heat else numpy.eye(n)
        if rod.has_heat:
            full[0::2, 1::2] = rod.a * rod.heats * self.gradient[1:, 1:]
            full[1::2, 0::2] = -rod.a * self.gradient.T[1:, 1:]
        self.bands = numpy.array([
            numpy.pad(numpy.diagonal(full, d), (max(d, 0), max(-d, 0)))
            for d in range(3, -4, -1)])
        self.tau = tau
        unit = numpy.zeros(2 * n)
        unit[-1] = -1
        self.response = solve_banded((3, 3), self.bands, unit)
        self.chi = -tau * self.response[-1]

    def stage(self, state, in_contact):
        """State and pressure at the end of a stage"""
        rod, tau = self.rod, self.tau
        theta, u, v = state
        values = numpy.zeros(2 * len(u) - 2)
        values[1::2] = (rod.b / tau * self.mass @ v - self.stiffness @ u)[1:]
        if rod.has_heat:
            at_fixed_end = 0 * theta
            at_fixed_end[0] = theta[0]
            heat = self.mass @ (theta / tau) - self.mass @ at_fixed_end / tau
            heat -= self.stiffness @ at_fixed_end
            heat += rod.m * (rod.theta_inf * self.mass.sum(1) - self.mass @ at_fixed_end)
            heat[-1] += rod.k * rod.theta_obs
            values[0::2] = heat[1:]
            values[1::2] += rod.a * (self.gradient.T @ at_fixed_end)[1:]
        values = solve_banded((3, 3), self.bands, values)
        pressure = 0.0
        if in_contact:
            pressure = rod.pressure(u[-1] + tau * values[-1], self.chi)
            values += pressure * self.response
        end = state.copy()
        end[2, 1:] = values[1::2]
        end[1] += tau * end[2]
        if rod.has_heat:
            end[0, 1:] = values[0::2]
        return end, pressure

    def step(self, state, dt, in_contact):
        """The two stages of a step"""
        if self.tau != self.GAMMA * dt:
            self.factorize(self.GAMMA * dt)
        middle, _ = self.stage(state, in_contact)
        return self.stage(state + (1 - self.GAMMA) / self.GAMMA * (middle - state),
                          in_contact)


def response(rod, tau):
    """chi of (M.20)"""
    length = math.sqrt(tau * (tau + rod.zeta) / rod.b)
    return tau**1.5 * math.tanh(1 / length) / math.sqrt(rod.b * (tau + rod.zeta))


def critical_step_size(rod):
    """The root of rho = 1, (M.20); None if there is none"""
    if not rod.epsilon or rod.epsilon >= 1 or rod.b == 0:
        return None
    return root(lambda tau: response(rod, tau) - rod.epsilon, 1e-12, 1e12)


def profile_at_rest(rod):
    """theta(1) and the mean of theta at rest, (M.7) or (M.103)"""
    if not rod.m:
        drop = rod.k / (rod.k + 1) * (rod.theta_A - rod.theta_obs)
        return rod.theta_A - drop, rod.theta_A - drop / 2
    mu, inner = math.sqrt(rod.m), rod.theta_A - rod.theta_inf
    sinh, cosh = math.sinh(mu), math.cosh(mu)
    slope = (inner * (mu * sinh + rod.k * cosh) - rod.k * (
        rod.theta_obs - rod.theta_inf)) / (mu * cosh + rod.k * sinh)
    return (rod.theta_inf + inner * cosh - slope * sinh,
            rod.theta_inf + (inner * sinh - slope * (cosh - 1)) / mu)


def rest(rod):
    """Displacement, force, temperature, in contact at rest, and why not: (M.10)"""
    if any(rod.sources.values()):
        return None, None, None, None, "no closed form with sources"
    end, mean = profile_at_rest(rod)
    theta = end if rod.has_heat else None
    if not rod.moves:
        return None, None, theta, False, ""
    remark = ""
    if rod.b > 0 and rod.zeta == 0:
        if rod.a == 0 or not rod.heats:
            return (None, None, None, None,
                    "none: nothing damps the motion, which goes on for ever")
        remark = (f"damped by heat conduction alone, over times of the order of "
                  f"{2 * (rod.b + 0.4) / rod.a**2:.1g}")
    G = rod.a * mean
    in_contact = rod.has_obstacle and rod.gap(G) < 0
    p = rod.pressure(G, 1.0) if in_contact else 0.0
    return G - p, p, theta, in_contact, remark


def step_size(since, span):
    """The steps of (M.46)"""
    return min(max(0.05 * since, 1e-6 * span), span / 400)


def arrival(coarse, gap, span):
    """Time and state when the end reaches the obstacle, or None"""
    time, state = 0.0, coarse.state
    while time < span:
        dt = step_size(time, span)
        after, _ = coarse.step(state, dt, False)
        (s0, v0), (s1, v1) = ((s[1, -1] - gap, dt * s[2, -1]) for s in (state, after))
        if s1 >= 0:
            part = root(lambda s: s0 + s * (v0 + s * (
                3 * (s1 - s0) - 2 * v0 - v1 + s * (2 * (s0 - s1) + v0 + v1))), 0, 1)
            state, _ = coarse.step(state, part * dt, False)
            return time + part * dt, state
        time, state = time + dt, after
    return None, None


def first_impact(rod, settings):
    """Time and penetration (M.46) of the first impact; None where unknown"""
    if not rod.has_obstacle or rod.b == 0 or any(rod.sources.values()) or (
            rod.g_2 < math.inf):
        return None, None
    coarse = CoarseRod(rod, settings)
    T, waves = settings.number("Time/End time"), 4 * (math.sqrt(rod.b) + rod.zeta)
    if coarse.state[1, -1] >= rod.g:
        return None, None
    time, state = arrival(coarse, rod.g, min(T, waves))
    if time is None or state[2, -1] <= 0:
        return None, None
    if rod.is_rigid:
        return time, None
    span, since, pressures = min(T - time, waves), 0.0, [0.0]
    while since < span and (pressures[-1] > 0 or max(pressures) == 0):
        dt = step_size(since, span)
        state, pressure = coarse.step(state, dt, True)
        pressures.append(pressure)
        since += dt
    peak = max(pressures)
    return (time, rod.epsilon * peak) if peak > 0 else (None, None)


def n_steps(rod, settings):
    """Steps: a count for fixed ones, the fit of doc/accuracy.md for others"""
    T = settings.number("Time/End time")
    if settings["Time/Step size"] != "automatic":
        n = math.ceil(T / settings.number("Time/Step size") - 1e-9)
    elif any(rod.sources.values()):
        return None
    else:
        n = (3 * rod.has_heat + 1.7 * rod.moves) * min(1, math.sqrt(T))
        if rod.moves and rod.b > 0:
            wave = math.sqrt(rod.b)
            rate = rod.zeta / rod.b + 0.5 * rod.a**2 * rod.heats / (rod.b + 0.4)
            runs = min(T, 1 / rate if rate else T) / wave
            contact = 0.5 / (1 + 5 * rod.epsilon) if rod.has_obstacle else 0
            n += (0.55 + contact) * runs * (
                1 + (0.05 * wave / (rod.zeta + 3e-4 * wave))**0.4)
        n = math.ceil(n * settings.number("Time/Tolerance")**-0.25)
    if settings["Output/Land on output times"] == "true":
        for name in ("Contact", "Fields", "Space-time"):
            if interval := settings.number(f"Output/{name} interval"):
                n += T / interval
    if period := settings.number("Output/Period"):
        n += T / period
    return n
