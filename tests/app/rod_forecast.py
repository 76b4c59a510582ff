# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known of a rod before a run, section 14 of doc/model.md, in closed form."""
import math


def root(function, low, high):
    """A zero by bisection of logarithms or of numbers"""
    rises = function(high) > function(low)
    for _ in range(200):
        middle = math.sqrt(low * high) if low > 0 else (low + high) / 2
        low, high = (low, middle) if (function(middle) > 0) == rises else (middle, high)
    return (low + high) / 2


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
