#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's experiment 1 in DOLFINx with PETSc's LU.

As rod.c, which has the equations: linear cells of one size, backward Euler with
the exact contact pressure, one row of CSV for each step. The forms are those of
the model; the matrices are assembled once, the stage matrix is factorised once,
and a step is products, a back-substitution and updates of PETSc's vectors.

  rod_dolfinx.py CELLS STEPS STEP_SIZE FILE|-
"""
import sys
import time

import numpy as np
import ufl
from dolfinx import fem, mesh
from dolfinx.fem import petsc
from mpi4py import MPI
from petsc4py import PETSc

A, EPS, K, ZETA, GAP, THETA_A = 0.017, 0.01, 1.0, 0.2, 0.1, 10.0


def solver(matrix):
    ksp = PETSc.KSP().create(matrix.comm)
    ksp.setOperators(matrix)
    ksp.setType("preonly")
    ksp.getPC().setType("lu")
    ksp.setUp()
    return ksp.solve


def matrices(domain, space):
    """M, S, D and the boundary mass of x = 1, without constraints."""
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    end = mesh.locate_entities_boundary(domain, 0, lambda x: np.isclose(x[0], 1))
    tags = mesh.meshtags(domain, 0, end, np.full(len(end), 1, np.int32))
    ds = ufl.Measure("ds", domain=domain, subdomain_data=tags)
    forms = (u * v * ufl.dx, u.dx(0) * v.dx(0) * ufl.dx, u.dx(0) * v * ufl.dx,
             u * v * ds(1))
    result = [petsc.assemble_matrix(fem.form(form)) for form in forms]
    for matrix in result:
        matrix.assemble()
    return result


def stage_matrix(m, s, d, b, tau, fixed):
    """That of (w', v), with the identity in the rows of the fixed end."""
    dt = PETSc.Mat().createTranspose(d).convert("aij")
    heat = m + tau * (s + K * b)
    momentum = m + (tau**2 + tau * ZETA) * s
    nest = PETSc.Mat().createNest([[heat, A * d], [-tau**2 * A * dt, momentum]])
    whole = nest.convert("aij")
    whole.zeroRows([fixed, fixed + m.size[0]])
    return whole, heat, dt


def main():
    n, n_steps, tau, name = (int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3]),
                             sys.argv[4])
    domain = mesh.create_unit_interval(MPI.COMM_SELF, n)
    space = fem.FunctionSpace(domain, ("CG", 1))
    x = space.tabulate_dof_coordinates()[:, 0]
    fixed, end, middle = (int(np.argmin(np.abs(x - place))) for place in (0, 1, 0.5))
    m, s, d, b = matrices(domain, space)
    whole, heat, dt = stage_matrix(m, s, d, b, tau, fixed)
    solve = solver(whole)
    conduction = s + K * b

    def vector(values):
        return PETSc.Vec().createWithArray(np.array(values, float), comm=MPI.COMM_SELF)

    size = n + 1
    theta = vector(THETA_A * (np.cos(2 * np.pi * x) - np.sin(np.pi * x / 2)))
    v = vector(20 * x * (x - 1)**2)
    u = vector(np.zeros(size))
    right, rates, response = (vector(np.zeros(2 * size)) for _ in range(3))
    # parts of the vectors of both fields, without copies
    part = [[PETSc.Vec().createWithArray(a.array[:size], comm=MPI.COMM_SELF),
             PETSc.Vec().createWithArray(a.array[size:], comm=MPI.COMM_SELF)]
            for a in (right, rates)]
    heat_load, momentum_load = part[0]
    theta_rate, velocity = part[1]
    scratch = vector(np.zeros(size))
    right.array[size + end] = tau
    solve(right, response)
    chi = tau * response.array[size + end]
    file = None if name == "-" else open(name, "w", encoding="utf-8")

    start = time.perf_counter()
    for step in range(1, n_steps + 1):
        if step == 1:  # u moves with its velocity, then heat alone
            u.axpy(tau, v)
            conduction.mult(theta, heat_load)
            d.mult(v, scratch)
            heat_load.axpy(A, scratch)
            heat_load.scale(-1)
            heat_load.array[fixed] = 0
            heat.zeroRows([fixed])
            solver(heat)(heat_load, theta_rate)
            theta.axpy(tau, theta_rate)
            p = max(0, u.array_r[end] - GAP) / EPS
        else:
            conduction.mult(theta, heat_load)
            heat_load.scale(-1)
            m.mult(v, momentum_load)
            s.mult(u, scratch)
            momentum_load.axpy(-tau, scratch)
            dt.mult(theta, scratch)
            momentum_load.axpy(tau * A, scratch)
            loads = right.array
            loads[fixed] = loads[size + fixed] = 0
            solve(right, rates)
            p = max(0, u.array_r[end] + tau * rates.array_r[size + end] - GAP) / (
                EPS + chi)
            if p > 0:
                rates.axpy(-p, response)
            theta.axpy(tau, theta_rate)
            velocity.copy(v)
            u.axpy(tau, v)
        if file:
            values = u.array_r
            file.write(f"{step * tau:.6g},{values[end]:.14g},{values[middle]:.14g},"
                       f"{v.array_r[end]:.14g},{-p:.14g}\n")
    loop = time.perf_counter() - start
    print(f"loop_s={loop:.6f} us_per_step={1e6 * loop / n_steps:.4f} "
          f"u_end={u.array_r[end]:.15g}")


main()
