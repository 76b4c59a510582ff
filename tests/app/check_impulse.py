#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_impulse.py DIR

The impact of a rod thrown at a rigid obstacle that it touches, u_1 = x: the end loses its
velocity 1 at once, and the rod the momentum m = 1/(e^T M_u^-1 e), the mass that moves with
the end, and the energy m/2. M_u is assembled here. The energy to 1e-6 (the step adds 1e-9),
the impulse to 1 % (0.2 %: the force of the first step).
"""
import sys

import numpy

from polynomials import Element, lobatto_nodes
from run_files import Run

run = Run(sys.argv[1])
cells, degree = (int(run.settings[f"Mesh/{name}"]) for name in ("Cells", "Degree"))
e = Element(lobatto_nodes(degree))
B = e.values(e.points)
mass = numpy.zeros((cells * degree + 1,) * 2)
for cell in range(cells):
    at = slice(cell * degree, (cell + 1) * degree + 1)
    mass[at, at] += B.T @ (e.weights[:, None] * B) / cells
moving = 1 / numpy.linalg.inv(mass[1:, 1:])[-1, -1]
c = run.contact
impulse = c["contact_impulse"][1] - c["contact_force"][1] * c["step_size"][1]
print("the impact at t = 0: impulse", "booked" if abs(impulse / moving - 1) < 0.01 else
      f"{impulse} instead of {moving}", "; energy", "booked" if abs(
          c["numerical_dissipation"][1] / moving - 0.5) < 1e-6 else
      f"{c['numerical_dissipation'][1]} instead of {moving / 2}")
