#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solves the rod with normal compliance exactly in time, spectrally in space.

    theta_t - theta_xx = -a v_x,          theta(0) = theta_A, -theta_x(1) = k theta(1)
    b v_t - sigma_x = 0,  v = u_t,        u(0) = 0, sigma(1) = -p, p = [u(1) - g]_+ / eps
    sigma = u_x + zeta v_x - a theta
    theta_0 = theta_A (cos 2 pi x - sin(pi x / 2)), u_0 = 0, u_1 = 20 x (x - 1)^2

Space: Galerkin with phi_i(x) = integral of p_i from 0 to x, p_i the orthonormal
Legendre polynomials of (0, 1), for u, v and theta^ = theta - theta_s, theta_s =
theta_A (1 - c x), c = k / (k + 1). The stiffness matrix is the identity, only phi_0 is
not zero at x = 1 (phi_0(1) = 1, N = e_0 e_0^T), and D_ij = (phi_i, p_j) is known in
closed form, so that the mass matrix is M = L L^T = sum over j <= n of D_ij D_kj. The
H1 projection of w - w(0) has the coefficients (w', p_j). In one phase of contact

    M theta^' + (1 + k N) theta^ + a D v = 0,    u' = v,
    b M v' + (1 + s N) u + zeta v - a D^T theta^ = a (theta_s, p_i) + s g e_0,

s = 0 (open) or 1 / eps (closed), is linear with the steady state theta^ = v = 0.

Time: about the steady state y' = A y has the modes A w = lambda w, taken from the
inverse of A, which needs no inverse of M and finds slow modes to rounding:

    v = f_u,  theta^ = -(1 + k N)^-1 (M f_theta + a D f_u),
    u = (1 + s N)^-1 (a D^T theta^ - zeta f_u - b M f_v)     solves   A y = f,

in the variables y = (L^T theta^, u, sqrt(b) L^T v), in which half the square of the norm
is the energy and the matrix of the modes is well conditioned (Solution.condition).
A phase ends at the first zero of u(1) - g. Intervals are accepted as free of zeros
only if |u_tt(1)| <= sum |coefficient lambda^2| exp(Re lambda t) proves it, else
halved: no excursion is missed, however short.

With 96 modes (0.4 s per experiment) the times of contact of experiments 1, 2 and 5 are to
1e-13 those of another code, and so were u to 1e-13, v, the force and theta to 1e-12 for
t >= 0.01; 64 are enough but for v within 1e-3 of an impact (1e-9). Layers after an impact get thin
for small eps and zeta: check with more modes below eps = 1e-3 or zeta = 0.02. zeta = 0
(waves, no smoothing) is not for this code.

Usage: exact_in_time.py [MODES] compares with the times of contact of that code.
Needs python3-numpy.
"""
import sys
import time
from dataclasses import dataclass

import numpy as np
from numpy.polynomial.legendre import leggauss, legvander


@dataclass
class Parameters:
    """The defaults are experiment 1; 2: zeta = 1; 5: eps = 1."""
    a: float = 0.017
    b: float = 1.0
    zeta: float = 0.2
    k: float = 1.0
    eps: float = 0.01
    g: float = 0.1
    theta_A: float = 10.0


class Modes:
    """The modes of one phase: rates, states and the values they take."""

    def __init__(self, q, basis, closed):
        n, D, L = len(basis.L), basis.D, basis.L
        end = np.eye(n)[0]
        heat = 1 / (1 + q.k * end)
        spring = 1 / (1 + closed / q.eps * end)

        # The solution of A y = f, column by column of the scaled f.
        eye, zero = np.eye(n), np.zeros((n, n))
        f_u = np.hstack([zero, eye, zero])
        theta = -heat[:, None] * np.hstack([L, q.a * D, zero])
        u = spring[:, None] * (q.a * D.T @ theta - q.zeta * f_u
                               - np.hstack([zero, zero, np.sqrt(q.b) * L]))
        inverse = np.vstack([L.T @ theta, u, np.sqrt(q.b) * L.T @ f_u])
        values, W = np.linalg.eig(inverse)
        self.condition = np.linalg.cond(W)
        self.to_modes = np.linalg.inv(W)
        self.steady = np.zeros(3 * n)
        self.steady[n:2 * n] = spring * (basis.load + closed * q.g / q.eps * end)

        # Of two conjugate modes keep one, twice. Columns of output: u(1), v(1),
        # u_tt(1), theta^(1), u(1/2).
        self.keep = values.imag >= 0
        rate = 1 / values[self.keep]
        W = W[:, self.keep] * np.where(rate.imag == 0, 1, 2)
        self.rate, self.W = rate, W
        self.output = np.array([W[n], rate * W[n], rate ** 2 * W[n],
                                rate * (theta[0] @ W),
                                basis.middle @ W[n:2 * n]])
        self.steady_output = np.array(
            [self.steady[n], 0, 0, 0, basis.middle @ self.steady[n:2 * n]])


class Phase:
    """The exact solution from the time start, while contact does not change."""

    def __init__(self, modes, start, state):
        self.modes, self.start = modes, start
        self.factor = (modes.to_modes @ (state - modes.steady))[modes.keep]

    def exponentials(self, times):
        t = np.asarray(times) - self.start
        return self.factor[:, None] * np.exp(np.outer(self.modes.rate, t))

    def output(self, times):
        m = self.modes
        return m.steady_output[:, None] + (m.output @ self.exponentials(times)).real

    def state(self, times):
        m = self.modes
        return m.steady[:, None] + (m.W @ self.exponentials(times)).real

    def sample(self, t, g):
        """(t, u(1) - g, v(1), bound of |u_tt(1)| from t on)"""
        e = self.factor * np.exp(self.modes.rate * (t - self.start))
        u, v = (self.modes.output[:2] @ e).real
        return (t, u + self.modes.steady_output[0] - g, v,
                np.abs(self.modes.output[2] * e).sum())


def first_zero(sample, sign, left, right):
    """First zero in (left, right] of the gap, of this sign just after left."""
    (t0, f0, v0, bound), (t1, f1, v1, _) = left, right
    h = t1 - t0
    if sign * f1 > 0 and (min(sign * f0, sign * f1) > h * h / 8 * bound
                          or (sign * f0 >= 0 and 2 * sign * v0 > h * bound)):
        return None
    middle = 0.5 * (t0 + t1)
    if h < 1e-14 or middle in (t0, t1):
        return t1 if sign * f1 <= 0 else None
    between = sample(middle)
    zero = first_zero(sample, sign, left, between)
    return first_zero(sample, sign, between, right) if zero is None else zero


class Solution:
    """events: (time, 'begin' or 'end', v(1)); evaluate(times): values."""

    def __init__(self, q, end_time, n):
        self.q, self.end_time = q, end_time
        self.initialise(q, n)
        modes = [Modes(q, self, closed) for closed in (0, 1)]
        self.condition = max(m.condition for m in modes)
        self.phases, self.events = [], []
        t, closed, state = 0.0, int(q.g < 0), self.initial
        while t is not None:
            phase = Phase(modes[closed], t, state)
            self.phases.append(phase)
            left = phase.sample(t, q.g)
            if self.events:
                left = (t, 0.0) + left[2:]
            t = None
            while t is None and left[0] < end_time:
                right = phase.sample(min(left[0] + 1 / 64, end_time), q.g)
                t = first_zero(lambda s: phase.sample(s, q.g),
                               1 if closed else -1, left, right)
                left = right
            if t is not None:
                closed, state = 1 - closed, phase.state([t])[:, 0]
                self.events.append((t, 'begin' if closed else 'end',
                                    phase.sample(t, q.g)[2]))

    def initialise(self, q, n):
        i = np.arange(n)
        d = 0.5 / np.sqrt((2.0 * i + 1) * (2 * i + 3))
        D = (np.diag(d, 1) - np.diag(d, -1))[:n]
        D[0, 0] = 0.5
        self.D, self.L = D[:, :n], np.linalg.cholesky(D @ D.T)
        p = legvander(np.zeros(1), n)[0]
        self.middle = np.append(
            0.5, (p[2:] - p[:-2]) / (2 * np.sqrt(2.0 * i[1:] + 1)))
        c = q.k / (q.k + 1)
        self.theta_s_end = q.theta_A * (1 - c)
        self.load = np.zeros(n)
        self.load[:2] = q.a * q.theta_A * np.array([1 - c / 2, -c / np.sqrt(12)])

        x, weight = leggauss(n + 40)
        project = (legvander(x, n - 1) * np.sqrt(2.0 * i + 1)).T * (weight / 2)
        x = (x + 1) / 2
        theta = project @ (q.theta_A * (c - 2 * np.pi * np.sin(2 * np.pi * x)
                                        - np.pi / 2 * np.cos(np.pi * x / 2)))
        v = project @ (20 * (x - 1) * (3 * x - 1))
        self.initial = np.concatenate([self.L.T @ theta, np.zeros(n),
                                       np.sqrt(q.b) * self.L.T @ v])

    def evaluate(self, times, energy=False):
        """Arrays of u_end, v_end, force, theta_end, u_mid (and energy, slower)."""
        times = np.asarray(times, dtype=float)
        if times.size and (times.min() < 0 or times.max() > self.end_time):
            raise ValueError('time outside of the solution')
        out = np.empty((5, times.size))
        energies = np.empty(times.size)
        n = len(self.L)
        which = np.searchsorted([p.start for p in self.phases], times, 'right') - 1
        for number, phase in enumerate(self.phases):
            chosen = np.flatnonzero(which == number)
            for part in np.array_split(chosen, len(chosen) // 2000 + 1):
                out[:, part] = phase.output(times[part])
                if energy:
                    y = phase.state(times[part])
                    energies[part] = (0.5 * (y ** 2).sum(axis=0)
                                      - self.load @ y[n:2 * n])
        force = np.maximum(out[0] - self.q.g, 0) / self.q.eps
        values = dict(u_end=out[0], v_end=out[1], force=force,
                      theta_end=out[3] + self.theta_s_end, u_mid=out[4])
        if energy:
            values['energy'] = energies + 0.5 * self.q.eps * force ** 2
        return values


def solve(parameters=Parameters(), end_time=10.0, modes=96):
    """modes: the number of Legendre polynomials per field."""
    return Solution(parameters, end_time, modes)


KNOWN = {
    1: (Parameters(), 0.1849692017564, 0.8966775426167, 3.0398984502590,
        3.9353865611236, 5.7567026050974),
    2: (Parameters(zeta=1.0), 0.1109600618893, 0.3437562701916, 2.4657200610754),
    5: (Parameters(eps=1.0), 0.1849692017564, 1.5866634339812, 3.5976122863384,
        5.1701477319303, 7.0873159795352, 8.7407763169438)}


def main(modes=96):
    for number, (q, *known) in KNOWN.items():
        start = time.perf_counter()
        solution = solve(q, 10.0, modes)
        print(f'experiment {number}: {modes} modes, condition '
              f'{solution.condition:.0f}, {time.perf_counter() - start:.2f} s')
        print(f'  events    {len(solution.events)} of {len(known)}')
        for (t, kind, v), reference in zip(solution.events, known):
            print(f'    {kind:5s} {t:.13f}  {t - reference:+.1e}  v {v:+.10f}')


if __name__ == '__main__':
    main(*map(int, sys.argv[1:]))
