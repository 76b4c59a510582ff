#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Free ends, masses and dashpots against closed forms.

free-bar: Z = sqrt(E rho) A, m = rho A L, c = sqrt(E/rho): force Z V from G/V on for 2 L/c,
impulse 2 m V to that of the steps with touch and release, velocities of the events V and
-V, restitution 1.

tip-mass: u(L) = U sin(q) cos(q c t/L), q tan q = m/M. The q of the file has 7 digits, so
that the second mode has 1e-7 of U; the tolerance of a step is 1e-5 of the largest
displacement, and 20 of them are allowed.

absorbing-end (V = b = 1): force 1 for 0.5 < t < 1, impulse 1/2, at rest from t = 2 on.
"""
import math
import sys

import numpy

sys.dont_write_bytecode = True
from run_files import Run  # noqa: E402

L, A, RHO, E = 1.0, 1e-4, 7850.0, 2.1e11
c, mass, impedance = math.sqrt(E / RHO), RHO * A * L, math.sqrt(E * RHO) * A
run = Run(sys.argv[1])
contact, title = run.contact, run.settings["Title"]
faults = []


def check(name, found, expected, bound):
    if not abs(found - expected) <= bound:
        faults.append(f"{name} {found}, expected {expected}")


if title.startswith("Free bar"):
    start, end, step = 100., 100. + 2e6 * L / c, run.contact["step_size"][2]
    times, force = contact["time"], contact["contact_force"]
    inside = (times > start + 2 * step) & (times < end - 2 * step)
    check("force", abs(force - impedance)[inside].max(), 0, 1e-9 * impedance)
    check("force before and after", force[(times < start - 2 * step) |
                                          (times > end + 2 * step)].max(), 0, 0)
    check("impulse", run.summary["contact_impulse"], 2 * mass, 2 * impedance * step * 1e-6)
    for i, (time, velocity) in enumerate(((start, 1.), (end, -1.))):
        check("time", run.events["time"][i], time, 1e-6)
        check("velocity", run.events["velocity"][i], velocity, 1e-9)
    check("restitution", run.summary["restitution"], 1, 1e-9)
    print("free bar:", run.summary["units"]["contact_impulse"], end="; ")
elif title.startswith("Bar with a mass"):
    q = 1.076874
    for _ in range(50):
        q -= (q * math.tan(q) - 2) / (math.tan(q) + q / math.cos(q)**2)
    exact = 1e-4 * math.sin(q) * numpy.cos(1e-3 * q * c / L * contact["time"])
    check("displacement", abs(contact["displacement_end"] - exact).max(), 0, 20 * 1e-5 * 1e-4)
    print("mass on the end", end="; ")
else:
    times, force = contact["time"], contact["contact_force"]
    step = contact["step_size"][2]
    pressed = (times > 0.5 + 2 * step) & (times < 1 - 2 * step)
    check("force", abs(force - 1)[pressed].max(), 0, 1e-9)
    check("force later", abs(force)[times > 1 + 2 * step].max(), 0, 1e-9)
    check("impulse", run.summary["contact_impulse"], 0.5, 1e-9)
    late = times > 2 + 2 * step
    check("rest", abs(contact["velocity_end"])[late].max(), 0, 1e-9)
    check("energy", contact["energy"][late].max(), 0, 1e-12)
    print("absorbing end", end="; ")
print("; ".join(faults) or "as the closed form")
