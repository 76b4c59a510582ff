#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact with p = ([s]_+ / eps)^m [1 + c s_t]_+, s = u - g, integrated by SciPy.

creep, static   zeta u' + u + p = 2 sin 3 t, u(0) = 0, eps = 0.3, g = 0.1, for zeta = 1/2
                and 0: one cell of degree 1 without inertia. Static with damping is an
                equation for the rate in contact; it starts 1e-5 after the touch on the
                tangent of the solution, whose error dies out like a power of the time.
impact          u'' / 2 + u + p = 0, u(0) = 0, u'(0) = 1, eps = g = 0.1: one cell with
                lumped mass, thrown at the obstacle.
experiment-1,   the rod of the paper with 16 linear elements, consistent mass, in the
experiment-5    nodal values of theta, u, v: assembled here, Radau's method.
coarse-1,       the same with 4 linear elements, whose fastest mode is slow enough for
coarse-5        orders of convergence: u(1) at t = 0.8, method DOP853, tolerance 1e-13.

Contact begins and ends at the events of solve_ivp, and each part starts anew there.
Relative tolerance 1e-13, for the rods 1e-11; with ten times that the numbers move by
less than 1e-12 and 2e-10.

Usage: damped_contact.py > damped-contact.csv      (a minute; needs python3-scipy)
Columns: case, m, c, quantity, time, value; quantities without a time have time 0.
"""
import csv
import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

LAWS = [(m, c) for m in (1.0, 1.5, 3.0) for c in (0.0, 0.1)]


def pressure(s, v, eps, m, c):
    return (max(s, 0.0) / eps) ** m * max(0.0, 1.0 + c * v)


def in_parts(rate, state, end, gap_of, times, method, rtol, jac=None):
    """Values at times and the times of contact, of a system that is smooth in between."""
    t, rows, events = 0.0, [], []
    is_closed = False
    while t < end:
        def touch(time, y):
            return gap_of(y)
        touch.terminal, touch.direction = True, (1.0 if is_closed else -1.0)
        wanted = [x for x in times if t < x <= end]
        options = {"jac": lambda time, y: jac(y, is_closed)} if jac else {}
        part = solve_ivp(lambda time, y: rate(time, y, is_closed), (t, end), state,
                         method=method, rtol=rtol, atol=1e-3 * rtol, t_eval=wanted or None,
                         events=touch, **options)
        if wanted:
            rows += list(zip(part.t, np.transpose(part.y)))
        if part.status != 1:
            break
        t, state = part.t_events[0][0], part.y_events[0][0]
        events.append((t, state))
        is_closed = not is_closed
    return rows, events


def creep(m, c, zeta=0.5, eps=0.3, g=0.1):
    def rate(t, y, is_closed):
        u = y[0]
        load = 2.0 * np.sin(3.0 * t) - u
        spring = (max(u - g, 0.0) / eps) ** m if is_closed else 0.0
        fast = (load - spring) / (zeta + c * spring)
        return [fast if 1.0 + c * fast > 0.0 else load / zeta]
    rows, _ = in_parts(rate, [0.0], 1.6, lambda y: g - y[0], TIMES, "DOP853", 1e-13)
    return [(t, y[0]) for t, y in rows]


def static(m, c, eps=0.3, g=0.1):
    def load(t):
        return 2.0 * np.sin(3.0 * t)
    times = [t for t in TIMES if t < 1.0]
    if c == 0.0:
        return [(t, brentq(lambda u, x=load(t): u + pressure(u - g, 0.0, eps, m, 0.0) - x,
                           0.0, 2.0, xtol=1e-15)) for t in times]
    touch, delay = np.arcsin(0.5 * g) / 3.0, 1e-5
    speed = 6.0 * np.cos(3.0 * touch)
    if m == 1.0:  # alpha (1 + c alpha) / eps = speed - alpha
        k = 1.0 + eps
        speed = 2.0 * eps * speed / (k + np.sqrt(k * k + 4.0 * c * eps * speed))

    def rate(t, y):
        spring = (y[0] / eps) ** m
        return [(load(t) - g - y[0] - spring) / (c * spring)]

    def jac(t, y):
        spring, slope = (y[0] / eps) ** m, m * (y[0] / eps) ** m / y[0]
        return [[(-1.0 - (load(t) - g - y[0]) * slope / spring) / (c * spring)]]
    part = solve_ivp(rate, (touch + delay, max(times)), [speed * delay], method="Radau",
                     rtol=1e-13, atol=1e-16, t_eval=times, jac=jac)
    return [(t, g + s) for t, s in zip(part.t, part.y[0])]


def impact(m, c, eps=0.1, g=0.1):
    def rate(t, y, is_closed):
        p = pressure(y[0] - g, y[1], eps, m, c) if is_closed else 0.0
        return [y[1], -2.0 * (y[0] + p)]
    _, events = in_parts(rate, [0.0, 1.0], 2.0, lambda y: g - y[0], [], "DOP853", 1e-13)
    (begin, at_begin), (end, at_end) = events[:2]
    return [("begin", begin), ("end", end), ("impact", at_begin[1]), ("rebound", at_end[1])]


class Rod:
    """M theta' + K theta + a D v = r, b M v' + S u + zeta S v - a D^T theta + p e = r."""

    def __init__(self, eps, m, c, n=16):
        self.a, self.b, self.zeta, k, theta_a = 0.017, 1.0, 0.2, 1.0, 10.0
        self.eps, self.m, self.c, self.g, self.n = eps, m, c, 0.1, n
        h = 1.0 / n
        mass, stiffness, coupling = (np.zeros((n + 1, n + 1)) for _ in range(3))
        for i in range(n):
            at = np.ix_((i, i + 1), (i, i + 1))
            mass[at] += h / 6.0 * np.array([[2.0, 1.0], [1.0, 2.0]])
            stiffness[at] += 1.0 / h * np.array([[1.0, -1.0], [-1.0, 1.0]])
            coupling[at] += 0.5 * np.array([[-1.0, 1.0], [-1.0, 1.0]])
        heat = stiffness.copy()
        heat[n, n] += k
        inner = slice(1, n + 1)
        inverse = np.linalg.inv(mass[inner, inner])
        s, d = stiffness[inner, inner], coupling[inner, inner]
        zero = np.zeros((n, n))
        self.matrix = np.block([
            [-inverse @ heat[inner, inner], zero, -self.a * inverse @ d],
            [zero, zero, np.eye(n)],
            [self.a / self.b * inverse @ coupling[inner, inner].T,
             -inverse @ s / self.b, -self.zeta / self.b * inverse @ s]])
        # theta_A at the first node, which does not change
        self.constant = np.concatenate([
            -inverse @ heat[inner, 0] * theta_a, np.zeros(n),
            self.a / self.b * inverse @ coupling[0, inner] * theta_a])
        self.push = np.concatenate([np.zeros(2 * n), inverse[:, -1] / self.b])
        x = np.arange(1, n + 1) * h
        self.start = np.concatenate([
            theta_a * (np.cos(2.0 * np.pi * x) - np.sin(0.5 * np.pi * x)), np.zeros(n),
            20.0 * x * (x - 1.0) ** 2])

    def pressure(self, y):
        return pressure(y[2 * self.n - 1] - self.g, y[-1], self.eps, self.m, self.c)

    def rate(self, _, y, is_closed):
        result = self.matrix @ y + self.constant
        return result - self.pressure(y) * self.push if is_closed else result

    def jac(self, y, is_closed):
        s, v = y[2 * self.n - 1] - self.g, y[-1]
        if not is_closed or s <= 0.0 or 1.0 + self.c * v <= 0.0:
            return self.matrix
        result = self.matrix.copy()
        spring = (s / self.eps) ** self.m
        result[:, 2 * self.n - 1] -= self.push * self.m * spring / s * (1.0 + self.c * v)
        result[:, -1] -= self.push * spring * self.c
        return result


def rod(eps, m, c, n=16, method="Radau", rtol=1e-11):
    system = Rod(eps, m, c, n)
    end = 2 * system.n - 1
    rows, events = in_parts(system.rate, system.start, 1.2,
                            lambda y: system.g - y[end], [0.2, 0.8], method, rtol,
                            system.jac if method == "Radau" else None)
    result = [(f"event{i}", 0.0, t) for i, (t, _) in enumerate(events)]
    for t, y in rows:
        result += [("displacement", t, y[end]), ("velocity", t, y[-1]),
                   ("force", t, system.pressure(y))]
    return result


TIMES = [0.8, 1.6]


def main():
    table = csv.writer(sys.stdout, lineterminator="\n")
    table.writerow(["case", "m", "c", "quantity", "time", "value"])

    def add(case, m, c, quantity, time, value):
        table.writerow([case, m, c, quantity, f"{time:.17g}", f"{value:.17g}"])
    for m, c in LAWS:
        for case, rows in (("creep", creep(m, c)), ("static", static(m, c))):
            for t, u in rows:
                add(case, m, c, "displacement", t, u)
        for quantity, value in impact(m, 5.0 * c):
            add("impact", m, 5.0 * c, quantity, 0.0, value)
    for number, eps, m, c in ((1, 0.01, 1.0, 0.3), (1, 0.01, 1.5, 0.3), (5, 1.0, 1.5, 0.3)):
        for quantity, t, value in rod(eps, m, c):
            add(f"experiment-{number}", m, c, quantity, t, value)
        for quantity, t, value in rod(eps, m, c, 4, "DOP853", 1e-13):
            if quantity == "displacement" and abs(t - 0.8) < 1e-12:
                add(f"coarse-{number}", m, c, quantity, t, value)


if __name__ == "__main__":
    main()
