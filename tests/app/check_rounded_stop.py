#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""prm/units/hertzian-stop.prm in the units of its files, from its SI values.

In each row: force = s d^m (1 + C v), s in N/m^m, C in s/m, at the penetration d and the
velocity v; stress = -force/A; heat flux h (theta - theta_obs) of the end.
The base moves by w(t) = B (1 - cos(2 pi f t)). Until its wave has come back from the base,
d'Alembert's end is at 2 w(t - L/c), so that it meets the stop at the gap g at
t = L/c + arccos(1 - g/(2 B))/(2 pi f). Waves are adiabatic:
c^2 = (1 + a^2) E/rho, a^2 = E alpha^2 theta/(rho C). To a thousandth: error control.
"""
import math
import sys

import numpy

sys.dont_write_bytecode = True
from run_files import Run  # noqa: E402

L, A, RHO, E, ALPHA, C = 0.2, 1e-4, 7850.0, 2.1e11, 12e-6, 440.0
KELVIN, OBSTACLE, EXCHANGE = 293.15, 20.0, 50.0
GAP, STIFFNESS, EXPONENT, DAMPING = 5e-6, 1.54e10, 1.5, 0.15
BASE, PER_MS = 2e-5, 2.0

run = Run(sys.argv[1])
contact, faults = run.contact, []


def check(name, found, expected, bound):
    if not numpy.abs(found - expected).max() <= bound:
        faults.append(f"{name} off by {numpy.abs(found - expected).max()}")


force, displacement = contact["contact_force"], contact["displacement_end"]
inside = numpy.maximum(displacement - GAP, 0)
check("penetration", contact["penetration"], inside, 1e-15)
by_law = STIFFNESS * inside**EXPONENT * (1 + DAMPING * contact["velocity_end"])
check("force", force, by_law, 1e-9 * by_law.max())
check("stress", contact["stress_end"], -force / A, 1e-9 * by_law.max() / A)
warmth = contact["temperature_end"] - OBSTACLE  # of numbers around 20
check("heat flux", contact["heat_flux_end"], EXCHANGE * warmth, 1e-11)
if not (by_law.max() > 100 and warmth.max() > 1e-3):
    faults.append("no contact, or no heat")
print("force, stress and heat:", "; ".join(faults) or "as by hand")

c = math.sqrt((1 + E * ALPHA**2 * KELVIN / (RHO * C)) * E / RHO)
met = 1e3 * L / c + math.acos(1 - GAP / (2 * BASE)) / (2 * math.pi * PER_MS)
begin = run.events["time"][0]
print("first contact:", "as d'Alembert's" if abs(begin / met - 1) < 1e-3 else
      f"{begin}, expected {met}")
