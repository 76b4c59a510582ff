#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The impact of prm/units/steel-impact.prm, in its files, against its closed form.

A rod that is held at x = 0 and has the velocity V x/L at first: u = F(ct + x) - F(ct - x).
What arrives at the end is V (1 - ct/L), up to t = 2 L/c, so that the end is at
V t - V c t^2/(2 L), reaches the gap g at t_0 = (1 - r) L/c, r^2 = 1 - 2 g c/(V L), with the
velocity v = V r, and presses with rho c A V (1 - ct/L): at first rho c v A, at last, at
t = L/c, nothing. The impulse is rho A V L r^2/2. Nothing flows away in a fifth of a
millisecond, and waves are adiabatic: c^2 = (1 + a^2) E/rho, a^2 = E alpha^2 theta/(rho C).
A step is L/c/2000: the force is off by less than 0.1 per cent of the first one, times by
two steps.
"""
import math
import sys

sys.dont_write_bytecode = True
from run_files import Run  # noqa: E402

L, A, RHO, E, ALPHA, C = 1.0, 1e-4, 7850.0, 2.1e11, 12e-6, 440.0
KELVIN, V, GAP = 293.15, 1.0, 1e-5

si = Run(sys.argv[1])
contact, events = si.contact, si.events
faults = []


def check(name, found, expected, bound):
    if not abs(found - expected) <= bound:
        faults.append(f"{name} {found}, expected {expected}")


c = math.sqrt((1 + E * ALPHA**2 * KELVIN / (RHO * C)) * E / RHO)
r = math.sqrt(1 - 2 * GAP * c / (V * L))
start, end, first = 1e3 * (1 - r) * L / c, 1e3 * L / c, RHO * c * V * r * A
step = 1e3 * L / c / 2000
times, force = contact["time"], contact["contact_force"]
arriving = RHO * c * A * V * (1 - times / end)
inside = (times > start + 2 * step) & (times < end - 2 * step)
check("force", abs(force - arriving)[inside].max(), 0, 1e-3 * first)
check("peak force", si.summary["max_contact_force"], first, 1e-3 * first)
check("force before and after", force[(times < start - 2 * step) |
                                      (times > end + 2 * step)].max(), 0, 0)
check("velocity", events["velocity"][0], V * r, 1e-3 * V)
check("begin", events["time"][0], start, 2 * step)
check("end", events["time"][1], end, 2 * step)
check("duration", events["duration"][1], end - start, 2 * step)
check("impulse", si.summary["contact_impulse"], RHO * A * V * L * r * r / 2,
      1e-3 * RHO * A * V * L * r * r / 2)
units = si.summary["units"]
print("units:", units["first_contact_time"], units["max_contact_force"])
print("force, times and impulse:", "; ".join(faults) or "as d'Alembert's")
