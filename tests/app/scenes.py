# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes drawn at random over what doc/laws.md says goes together."""
import random


def draw(seed):
    """The overrides of the default scene, as --set takes them, by their entries."""
    r = random.Random(seed)
    s = {"Title": f"Scene {seed}", "Time/End time": r.choice(["1", "1.5"])}
    dim = r.choice([1] * 7 + [2, 2, 3])
    s["Dimension"] = str(dim)
    s |= {"Mesh/Cells": r.choice("35"), "Mesh/Degree": r.choice("24")} if dim == 1 else {
        "Mesh/Cells": "3", "Mesh/Cells across": "2", "Mesh/Degree": "2" if dim == 2 else "1"}
    fields = r.choice(["temperature and displacement"] * 5 + ["displacement"] * 3 +
                      ["temperature"])
    s["Model/Fields"] = fields
    heat, moves = "temperature" in fields, "displacement" in fields
    steps = r.choice(["automatic"] * 3 + ["backward euler"] * 2 + ["sdirk2", "sdirk4"])
    if steps == "automatic":
        s["Time/Tolerance"] = r.choice(["1e-3", "1e-5"])
        if r.random() < 0.3:
            s["Output/Period"] = "0.25"
    else:
        s |= {"Time/Scheme": steps, "Time/Step size": "0.01", "Time/Start": "consistent"}
    s["Output/Fields interval"] = "0.01" if steps == "backward euler" else "0.25"
    if dim > 1 and moves:
        s |= {"Model/Poisson ratio": "0.3",
              "Boundary/sides/Support": r.choice(["free", "rollers"])}
    middle = ", 0.05" * (dim - 1)
    s["Output/Probes"] = f"0.5{middle}; 1{middle}"
    if heat:
        draw_heat(r, s)
    if moves:
        draw_motion(r, s, heat)
    if dim == 1 and r.random() < 0.3:
        s["Output/Space-time interval"] = "0.25"
    if dim > 1 and seed % 2 == 0 and s.get("Contact/Condition", "none") != "none":
        s["Contact/Rear gap"] = "0.01"
    if dim == 1 and "Contact/Rear gap" in s:
        if "Model/Coupling" in s:
            s |= {"Model/Coupling": "0.001", "Boundary/right/Heat exchange": "3/(1+20*gap)",
                  "Boundary/right/Surroundings": "4"}
        if seed % 4 in (0, 3) and s["Model/Inertia"] != "0":
            s["Initial values/Velocity"] = "-x"
    if dim == 1 and moves and seed % 4 == 1 and s["Model/Inertia"] != "0":
        draw_box(s)
        return s
    if dim == 1 and seed % 5 == 0:  # few: probes in the middle are no points of snapshots then
        s["Mesh/Grading"] = "4"
    return s


def draw_box(s):
    """The scheme without dispersion takes whatever a rod with inertia has."""
    for entry in ("Time/Tolerance", "Output/Period"):
        s.pop(entry, None)
    s |= {"Time/Scheme": "box", "Mesh/Degree": "1", "Mesh/Cells": "100",
          "Model/Inertia": "1", "Time/Step size": "0.01", "Time/Start": "consistent"}


def draw_heat(r, s):
    s["Initial values/Temperature"] = r.choice(["theta_A*(1-x)", "theta_A*x^2", "theta_A"])
    s["Boundary/left/Temperature"] = r.choice(["10", "5", "-8", "10*cos(t)"])
    s["Boundary/right/Heat exchange"] = r.choice(["1", "0", "3", "3", "1+20*pressure"])
    if s["Boundary/right/Heat exchange"] in ("1", "3"):
        s["Boundary/right/Surroundings"] = r.choice(["0", "4", "1.23456789012+2*t"])
    if r.random() < 0.3:
        s |= {"Boundary/sides/Heat exchange": "2", "Boundary/sides/Surroundings": "-3"}
        if "t" in s["Boundary/left/Temperature"] and "Time/Scheme" in s:
            s["Time/Scheme"] = "backward euler"
    if r.random() < 0.2:
        s["Sources/Heat source"] = "20*x*t"
    if r.random() < 0.2:
        s["Boundary/right/Heat flux"] = "3+t^2"


def draw_motion(r, s, heat):
    s["Model/Inertia"] = r.choice(["1", "1", "1", "0.3", "0"])
    s["Model/Viscosity"] = r.choice(["0.2", "0.2", "0.4", "0.02"])
    if heat:
        s["Model/Coupling"] = r.choice(["0.017", "0.3", "-0.1"])
        s["Model/Thermoelastic heating"] = r.choice(["true", "true", "false"])
    s["Initial values/Displacement"] = r.choice(["0", "0.02*x"])
    if s["Model/Inertia"] != "0":
        s["Initial values/Velocity"] = r.choice(["0", "x", "x", "0.5*x*(2-x)"])
    s["Contact/Condition"] = r.choice(["normal compliance"] * 3 + [
        "power law", "rigid", "none"])
    if s["Contact/Condition"] != "none":
        s["Contact/Gap"] = r.choice(["0.05", "0.1", "0.1", "0.08+0.02*cos(4*t)"])
        if s["Contact/Condition"] != "rigid":
            s["Contact/Compliance"] = r.choice(["0.1", "0.03", "1"])
            if (drawn := r.random()) < 0.3:
                s["Contact/Damping" if drawn < 0.2 else "Contact/Dashpot"] = "0.5"
        if s["Contact/Condition"] == "power law":
            s["Contact/Exponent"] = "1.5"
        if r.random() < 0.3:
            s["Contact/Rear gap"] = "0.01"
    if r.random() < 0.3:
        s["Boundary/right/Traction"] = r.choice(["0.3*sin(3*t)", "0.2-0.5*t"])
    if r.random() < 0.2:
        s["Sources/Body force"] = "0.5*x*cos(2*t)"
    if r.random() < 0.2:
        s["Boundary/left/Displacement"] = "0.03*(1-cos(5*t))"
    if not heat and s["Model/Inertia"] != "0" and s.get("Time/Scheme", "").startswith(
            "sdirk") and s["Contact/Condition"] in ("normal compliance", "rigid") and not {
                "Contact/Damping", "Contact/Dashpot", "Boundary/left/Displacement"} & set(s):
        s |= {"Time/Scheme": "energy conserving", "Initial values/Velocity": "x"}
    if s["Dimension"] != "1" and s.get("Contact/Gap") == "0.1" and "Contact/Rear gap" not in s:
        s["Contact/Gap"] = "0.05+0.5*(y-0.03)^2"
