#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work, impulse and energy of the energy-conserving scheme, from other columns."""
import sys

import numpy

from run_files import Run, differences

TRACTION = 0.3
run = Run(sys.argv[1])
t = run.contact
has_heat = run.settings.has("temperature")

held = (t["contact_force"][1:] > 0) & (t["contact_force"][:-1] > 0)
impulse = (0.02 * (t["contact_force"][1:] + t["contact_force"][:-1]) / 2)[held]
print("impulse of", "many" if sum(held) >= 5 else sum(held), "steps in contact:",
      differences(numpy.diff(t["contact_impulse"])[held], impulse, 1e-9) or "mean force")

balance = t["energy"][0] + t["work"] - t["dissipation"] - t["numerical_dissipation"]
print("energy:", differences(t["energy"], balance, 1e-12) or "balances")
if not has_heat:
    same = (t["contact_force"][1:] > 0) == (t["contact_force"][:-1] > 0)
    lost = abs(numpy.diff(t["numerical_dissipation"]))[same].max() / t["energy"].max()
    print("lost to the scheme between changes of contact:",
          "nothing" if lost < 1e-11 else lost)
    work = TRACTION * (t["displacement_end"] - t["displacement_end"][0])
    print("work:", differences(t["work"], work, 1e-11) or "of the traction")
