#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a damped obstacle does, from the other columns: backward Euler, one node or
nodes that move alike."""
import sys

import numpy

from run_files import Run, differences

BOUND = 1e-11
run = Run(sys.argv[1])
t = run.contact
c = float(run.settings["Contact/Damping"])
balance = t["energy"][0] + t["work"] - t["dissipation"] - t["numerical_dissipation"]
if c == 0:
    print("contact_dissipation:", "contact_dissipation" in t.names)
    sys.exit()

depth = numpy.maximum(0, -t["gap"])
spring = (depth / float(run.settings["Contact/Compliance"])) ** float(
    run.settings["Contact/Exponent"])
force = spring * numpy.maximum(0, 1 + c * t["velocity_end"])
taken = numpy.cumsum(t["step_size"] * (force - spring) * t["velocity_end"])
for name, values in (("penetration", depth), ("in_contact", depth > 0),
                     ("contact_force", force), ("contact_dissipation", taken),
                     ("energy", balance - t["contact_dissipation"])):
    print(f"{name}:", differences(t[name], values, BOUND) or "as it should")
print("left behind:", any((depth > 0) & (force == 0)))
print("in the log:", "taken by the obstacle" in run.log,
      "damped contact" in run.log)
