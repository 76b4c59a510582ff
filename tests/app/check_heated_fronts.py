# SPDX-License-Identifier: LGPL-2.1-or-later
"""The largest force is rho c v A with the speed of adiabatic waves, within its bar."""
import sys

sys.dont_write_bytecode = True
from run_files import Run  # noqa: E402

run = Run(sys.argv[1])
stiffness = 12e-6**2 * 210e9 * 293.15 / (7850 * 440)
force = 1e-4 * (7850 * 210e9 * (1 + stiffness))**0.5
bar, found = run.summary["max_contact_force_space_error"], run.summary["max_contact_force"]
print(f"{force:.2f} N:", "within the bar" if abs(found - force) <= bar else f"{found} +- {bar}",
      "of less than a percent" if bar < 0.01 * force else "of more than ten percent" if bar > 0.1 * force else f"of {bar}")
