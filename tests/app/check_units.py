# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks scenes from --units against the same rods computed in SI units.

The coefficients come from formulas that name no scale:
  a^2 = E alpha^2 theta_ref/(rho c), b = (kappa/(rho c L))^2 rho/E,
  zeta = eta kappa/(rho c L^2 E), k = h L/kappa, epsilon = (E A/L)/stiffness,
  g = gap/L, a theta_A = alpha (theta_A - theta_ref), T = t kappa/(rho c L^2).
If the sides cannot move, E stands for lambda + 2 mu, and alpha for
(3 lambda + 2 mu) alpha/(lambda + 2 mu), with Lame's constants.
At rest the rod is a bar with the temperature theta_A - c (theta_A - theta_obs) x/L,
c = k/(k + 1), in series with a spring: with the free expansion
G = alpha L ((theta_A - theta_ref) - c (theta_A - theta_obs)/2),
  force = (G - gap)/(L/(E A) + 1/stiffness), displacement = G - force L/(E A),
  heat flux = h (theta(L) - theta_obs).
"""
import csv
import math
import re
import sys

RODS = {
    "Steel rod, 1 m": dict(
        file="steel.prm", L=1.0, A=1e-4, rho=7850.0, E=2.1e11, eta=5e3, alpha=12e-6,
        kappa=53.3, c=440.0, ref=293.15, fixed=393.15, obstacle=293.15,
        gap=5e-4, stiffness=1e8, h=50.0, t=129600.0),
    "Polysilicon beam, 200 um": dict(
        file="silicon.prm", L=200e-6, A=20e-12, rho=2330.0, E=169e9, eta=0.25,
        alpha=2.6e-6, kappa=30.0, c=705.0, ref=300.0, fixed=600.0, obstacle=300.0,
        gap=0.1e-6, stiffness=1e4, h=1e5, t=0.01),
}
RODS["Steel rod, confined"] = {**RODS["Steel rod, 1 m"], "file": "confined.prm",
                               "nu": 0.3}

results = sys.argv[1]
rows = [line for line in open(f"{results}/contact.csv") if not line.startswith("#")]
last = {k: float(v) for k, v in list(csv.DictReader(rows))[-1].items()}
used = open(f"{results}/used.prm").read()
is_si = "set SI = true" in used
title = re.search(r"set Title = (.*)", used).group(1)
rod = RODS[title]
scene = open(rod["file"]).read()
L, A, rho, E, c = (rod[name] for name in ("L", "A", "rho", "E", "c"))
alpha, kappa, h = rod["alpha"], rod["kappa"], rod["h"]
if "nu" in rod:
    lamda = E * rod["nu"] / ((1 + rod["nu"]) * (1 - 2 * rod["nu"]))
    mu = E / (2 * (1 + rod["nu"]))
    alpha *= (3 * lamda + 2 * mu) / (lamda + 2 * mu)
    E = lamda + 2 * mu
faults = []


def compare(what, value, expected, tolerance):
    if not abs(value - expected) <= tolerance * abs(expected):
        faults.append(f"{what}: {value}, expected {expected}")


def coefficient(pattern):
    return float(re.search(pattern + r" (\S+?),?(\s|$)", scene).group(1))


def factor(name):
    """By which a column is to be multiplied, unless it is in SI units."""
    if is_si:
        return 1
    return float(re.search(rf"# +{re.escape(name)} +(\S+)", scene).group(1))


k = h * L / kappa
a = math.sqrt(E * alpha**2 * rod["ref"] / (rho * c))
diffusivity = kappa / (rho * c)
for pattern, expected in {
    "set Coupling =": a,
    "# b =": (diffusivity / L) ** 2 * rho / E,
    "# zeta =": rod["eta"] * diffusivity / (L**2 * E),
    "set Heat exchange =": k,
    "set Compliance =": E * A / L / rod["stiffness"],
    "set Gap =": rod["gap"] / L,
    "set Fixed end temperature =": alpha * (rod["fixed"] - rod["ref"]) / a,
    "set End time =": rod["t"] * diffusivity / L**2,
}.items():
    compare(pattern, coefficient(pattern), expected, 1e-11)

ratio = k / (k + 1)
heating = rod["fixed"] - rod["obstacle"]
expansion = alpha * L * (rod["fixed"] - rod["ref"] - ratio * heating / 2)
force = (expansion - rod["gap"]) / (L / (E * A) + 1 / rod["stiffness"])
end = rod["obstacle"] + heating * (1 - ratio)
# The program's accuracy here is that of rounding: the rod is at rest.
for column, name, expected in [
    ("contact_force", "contact_force", force),
    ("stress_end", "stress_end", -force / A),
    ("displacement_end", "displacement_*, gap, penetration",
     expansion - force * L / (E * A)),
    ("penetration", "displacement_*, gap, penetration", force / rod["stiffness"]),
    ("heat_flux_end", "heat_flux_end", h * (end - rod["obstacle"])),
]:
    compare(column, last[column] * factor(name), expected, 1e-8)
temperature = last["temperature_end"] * factor(
    f"temperature_*, then add {rod['ref']:g}") + (0 if is_si else rod["ref"])
compare("temperature_end", temperature, end, 1e-8)
print(f"{title}, {'SI' if is_si else 'factors'}: {'; '.join(faults) or 'coefficients, force, displacements and heat as in SI'}")
