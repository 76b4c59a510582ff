#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts the scenes of tests/verification/energy_decay.cc that have contact.

An independent dense code for (3.1)-(3.2) of the paper: P1, 32 cells, values as
unknowns, contact by trying both branches. Needs python3-numpy; run by hand.
"""
import numpy as np

n, theta_a, k, g = 32, 10.0, 1.0, 0.1
h = 1 / n
x = np.linspace(0, 1, n + 1)
mass = np.zeros((n + 1, n + 1))
stiff = np.zeros((n + 1, n + 1))
coupling = np.zeros((n + 1, n + 1))  # (eta_i, eta_j')
for i in range(n):
    s = slice(i, i + 2)
    mass[s, s] += h / 6 * np.array([[2, 1], [1, 2]])
    stiff[s, s] += np.array([[1, -1], [-1, 1]]) / h
    coupling[s, s] += np.array([[-1, 1], [-1, 1]]) / 2
free = slice(1, n + 1)
M, K, C = (m[free, free] for m in (mass, stiff, coupling))
c = k / (k + 1)
shift = theta_a * (c * x - 1)  # theta_hat = theta + shift
z = (coupling.T @ shift)[free]
B = np.zeros((n, n))
B[-1, -1] = k


def has_contact(dt, eps, zeta, a):
    theta = (theta_a * (np.cos(2 * np.pi * x) - np.sin(np.pi * x / 2))
             + shift)[free]
    u_old = np.zeros(n)
    u = dt * (20 * x * (x - 1) ** 2)[free]
    heat = M + dt * (K + B)
    theta = np.linalg.solve(heat, M @ theta - a * C @ (u - u_old))
    contact = u[-1] > g
    E = np.zeros((n, n))
    E[-1, -1] = dt ** 2 / eps
    momentum = M + (dt ** 2 + dt * zeta) * K
    open_ = np.linalg.inv(
        np.block([[heat, a * C], [-dt ** 2 * a * C.T, momentum]]))
    closed = np.linalg.inv(
        np.block([[heat, a * C], [-dt ** 2 * a * C.T, momentum + E]]))
    for _ in range(2, 51):
        rhs = np.concatenate([
            M @ theta + a * C @ u,
            2 * M @ u - M @ u_old + dt * zeta * K @ u - dt ** 2 * a * z])
        new = open_ @ rhs
        if new[-1] > g:
            rhs[-1] += dt ** 2 / eps * g
            new = closed @ rhs
            contact = True
        theta, u_old, u = new[:n], u, new[n:]
    return contact


for dt in (1e-4, 1e-2, 1.0, 100.0):
    counts = [sum(has_contact(dt, eps, zeta, a)
                  for eps in (1e-8, 0.01, 1e3)
                  for zeta in (0.0, 0.2, 100.0)
                  for a in coefficients)
              for coefficients in ((0.0,), (0.017, 3.0))]
    print(f"dt = {dt:g}: {counts[0]} of 9 with a = 0, "
          f"{counts[1]} of 18 with a > 0")
