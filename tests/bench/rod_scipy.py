#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's experiment 1 in numpy with SciPy's band solver (LAPACK).

As rod.c, which has the equations: linear cells of one size, backward Euler with
the exact contact pressure, one row of CSV for each step. The matrix is
factorised once; unknowns are two to a node, so that its band is three wide.

  rod_scipy.py CELLS STEPS STEP_SIZE FILE|-
"""
import sys
import time

import numpy as np
from scipy.linalg import lapack, solve_banded

A, EPS, K, ZETA, GAP, THETA_A = 0.017, 0.01, 1.0, 0.2, 0.1, 10.0


def band_factors(n, h, tau):
    """LU of the stage matrix, (w', v) interleaved; nodes 1 .. n."""
    m, s, q = h / 6, 1 / h, tau**2 + tau * ZETA
    ab = np.zeros((10, 2 * n))  # row 6 + i - j holds entry (i, j)
    factor = np.full(n, 2.0)
    factor[-1] = 1
    ab[6, 0::2] = factor * (2 * m + tau * s)
    ab[6, 1::2] = factor * (2 * m + q * s)
    ab[6, -2] += tau * K
    for first, off in ((0, m - tau * s), (1, m - q * s)):
        ab[4, 2 + first::2] = off
        ab[8, first:2 * n - 2:2] = off
    d, t = A / 2, A / 2 * tau**2
    ab[3, 3::2] = d      # heat i, v of i + 1
    ab[7, 1:-2:2] = -d   # heat i + 1, v of i
    ab[5, 2::2] = t      # momentum i, w' of i + 1
    ab[9, 0:-2:2] = -t
    ab[5, -1] = d
    ab[7, -2] = -t
    lu, pivots, info = lapack.dgbtrf(ab, 3, 3)
    if info:
        sys.exit("singular")
    return lambda b: lapack.dgbtrs(lu, 3, 3, b, pivots)[0]


def stiff(x, h):
    """S x at nodes 1 .. n of values at 0 .. n."""
    jump = np.diff(x) / h
    jump[:-1] -= jump[1:]
    return jump


def load(w, u, v, h, tau):
    b = np.empty(2 * (len(w) - 1))
    b[0::2] = -stiff(w, h)
    b[-2] -= K * (w[-1] + THETA_A)
    b[1::2] = -tau * stiff(u, h)
    b[1:-2:2] += h / 6 * (v[:-2] + 4 * v[1:-1] + v[2:]) + tau * A / 2 * (w[:-2] - w[2:])
    b[-1] += h / 6 * (v[-2] + 2 * v[-1]) + tau * A * ((w[-2] + w[-1]) / 2 + THETA_A)
    return b


def first_step(w, u, v, h, tau):
    """u moves with its velocity, then heat alone."""
    n = len(w) - 1
    ab = np.empty((3, n))
    ab[0] = ab[2] = h / 6 - tau / h
    ab[1] = 2 * (h / 3 + tau / h)
    ab[1, -1] = h / 3 + tau / h + tau * K
    b = -stiff(w, h)
    b[-1] -= K * (w[-1] + THETA_A) + A / 2 * (v[-1] - v[-2])
    b[:-1] -= A / 2 * (v[2:] - v[:-2])
    w[1:] += tau * solve_banded((1, 1), ab, b)
    u += tau * v


def main():
    n, n_steps, tau, name = (int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3]),
                             sys.argv[4])
    h = 1 / n
    x = np.linspace(0, 1, n + 1)
    w = THETA_A * (np.cos(2 * np.pi * x) - np.sin(np.pi * x / 2)) - THETA_A
    v = 20 * x * (x - 1)**2
    u = np.zeros(n + 1)
    solve = band_factors(n, h, tau)
    unit = np.zeros(2 * n)
    unit[-1] = tau
    response = solve(unit)
    chi = tau * response[-1]
    file = None if name == "-" else open(name, "w", encoding="utf-8")

    start = time.perf_counter()
    for step in range(1, n_steps + 1):
        if step == 1:
            first_step(w, u, v, h, tau)
            p = max(0, u[-1] - GAP) / EPS
        else:
            rates = solve(load(w, u, v, h, tau))
            p = max(0, u[-1] + tau * rates[-1] - GAP) / (EPS + chi)
            if p > 0:
                rates -= p * response
            w[1:] += tau * rates[0::2]
            v[1:] = rates[1::2]
            u += tau * v
        if file:
            file.write(f"{step * tau:.6g},{u[-1]:.14g},{u[n // 2]:.14g},{v[-1]:.14g},"
                       f"{-p:.14g}\n")
    loop = time.perf_counter() - start
    print(f"loop_s={loop:.6f} us_per_step={1e6 * loop / n_steps:.4f} u_end={u[-1]:.15g}")


main()
