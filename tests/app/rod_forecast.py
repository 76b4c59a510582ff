# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known of a rod before a run, section 14 of doc/model.md, in numpy."""
import math

import numpy
from numpy.polynomial.legendre import leggauss

N_MODES = 200


def root(function, low, high):
    """A zero by bisection of logarithms or of numbers"""
    rises = function(high) > function(low)
    for _ in range(200):
        middle = math.sqrt(low * high) if low > 0 else (low + high) / 2
        low, high = (low, middle) if (function(middle) > 0) == rises else (middle, high)
    return (low + high) / 2


class FreeMotion:
    """(M.44): the end of a rod that has not met the obstacle"""

    def __init__(self, rod, settings):
        points, weights = leggauss(20)
        cells = numpy.linspace(0, 1, 201)
        h = cells[1] - cells[0]
        x = (cells[:-1, None] + h * (points + 1) / 2).ravel()
        w = numpy.tile(h * weights / 2, 200)
        zero = 0 * x
        theta, u, v = (settings.expression("Initial values/" + name)(x)
                       if name != "Temperature" or rod.has_heat else zero
                       for name in ("Temperature", "Displacement", "Velocity"))
        n = numpy.arange(N_MODES)
        k = (n + 0.5) * math.pi
        sines, cosines = numpy.sin(numpy.outer(k, x)), numpy.cos(numpy.outer(k, x))
        displacement = 2 * (sines @ (w * u) - rod.a / k * (cosines @ (w * theta)))
        velocity = 2 * sines @ (w * v)
        damping = rod.zeta * k**2 / (2 * rod.b)
        s = numpy.sqrt((damping**2 - k**2 / rod.b).astype(complex))
        self.rates = numpy.array([-damping - s, -damping + s])
        second = (velocity - self.rates[0] * displacement) / (2 * s)
        self.amplitudes = (-1.0)**n * numpy.array([displacement - second, second])
        self.expansion = rod.a * (w @ theta)
        u_end = settings.expression("Initial values/Displacement")(numpy.ones(1))[0]
        self.offset = u_end - self.amplitudes.sum().real

    def __call__(self, t):
        return self.offset + (self.amplitudes * numpy.exp(self.rates * t)).sum().real

    def velocity(self, t):
        return (self.rates * self.amplitudes * numpy.exp(self.rates * t)).sum().real


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


def first_impact(rod, settings):
    """Time and penetration (M.46) of the first impact; None where unknown"""
    if not rod.has_obstacle or rod.b == 0 or any(rod.sources.values()) or (
            rod.g_2 < math.inf):
        return None, None
    motion = FreeMotion(rod, settings)
    horizon = min(settings.number("Time/End time"), 4 * (math.sqrt(rod.b) + rod.zeta))
    times = numpy.linspace(0, horizon, 501)
    reached = [i for i, t in enumerate(times) if motion(t) >= rod.g]
    if not reached or reached[0] == 0:
        return None, None
    i = reached[0]
    time = root(lambda t: motion(t) - rod.g, times[i - 1], times[i])
    taus = horizon * numpy.logspace(-6, 0, 2001)
    beyond = numpy.array([motion(time + tau) for tau in taus]) - rod.g
    heat = abs(rod.a * profile_at_rest(rod)[1] - motion.expansion) * (
        1 - math.exp(-(math.pi**2 / 4 + rod.m) * time)) if rod.a else 0.0
    if motion.velocity(time) <= 0 or max(0, beyond.max()) <= 2 * heat:
        return None, None
    if rod.is_rigid:
        return time, None
    shares = [rod.epsilon / (rod.epsilon + response(rod, tau)) for tau in taus]
    return time, 1.5 * (shares * beyond).max()


def n_steps(rod, settings):
    """Steps: a count for fixed ones, the fit of doc/accuracy.md for others"""
    T = settings.number("Time/End time")
    if settings["Time/Step size"] != "automatic":
        n = math.ceil(T / settings.number("Time/Step size") - 1e-9)
    elif any(rod.sources.values()):
        return None
    else:
        n = (3.4 * rod.has_heat + 2 * rod.moves) * min(1, math.sqrt(T))
        if rod.moves and rod.b > 0:
            wave = math.sqrt(rod.b)
            runs = min(T, rod.b / rod.zeta if rod.zeta else T) / wave
            n += (1.2 if rod.has_obstacle else 0.6) * runs * (
                1 + (0.05 * wave / (rod.zeta + 3e-4 * wave))**0.4)
        n = math.ceil(n * settings.number("Time/Tolerance")**-0.25)
    if settings["Output/Land on output times"] == "true":
        for name in ("Contact", "Fields", "Space-time"):
            if interval := settings.number(f"Output/{name} interval"):
                n += T / interval
    if period := settings.number("Output/Period"):
        n += T / period
    return n
