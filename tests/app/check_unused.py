#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries without effect in a scene are refused; in its neighbour, where they
have one, they are accepted."""
import re
import sys

sys.dont_write_bytecode = True
from refused_scenes import (  # noqa: E402
    check_all, closing, source_files, without_comments)

# A value of each entry that is not its default.
VALUES = {
    "Model/Inertia": "2", "Model/Viscosity": "0.3", "Model/Coupling": "0.1",
    "Model/Thermoelastic heating": "false", "Model/Poisson ratio": "0.3",
    "Boundary/left/Temperature": "5", "Boundary/right/Heat exchange": "2",
    "Boundary/right/Surroundings": "1", "Boundary/sides/Support": "free",
    "Boundary/sides/Heat exchange": "2", "Boundary/sides/Surroundings": "1",
    "Boundary/left/Displacement": "0.1*t",
    **{f"Boundary/{end}/{what}": "0.1" for end in ("left", "right")
       for what in ("Traction", "Spring", "Dashpot", "Mass", "Heat flux")},
    "Boundary/left/Heat exchange": "2", "Boundary/left/Surroundings": "1",
    "Boundary/right/Support": "free", "Boundary/right/Temperature": "1",
    "Contacts/a b/Gap": "0.2", "Contacts/a b/Heat exchange": "2",
    **{f"Bodies/a/{name}": "2" for name in (
        "Length", "Cells", "Section", "Stiffness", "Density", "Viscosity", "Coupling", "Conductivity", "Mass",
        "Heat capacity")},
    "Bodies/a/Poisson ratio": "0.3",
    "Bodies/a/Temperature": "1", "Bodies/a/Displacement": "0.01*x", "Bodies/a/Velocity": "1",
    "Contacts/b a/Gap": "0.2", "Contacts/b a/Heat exchange": "2", "Contacts/b a/Condition": "power law",
    "Mesh/Cells": "20", "Mesh/Refinements": "1",
    "Contact/Condition": "rigid", "Contact/Compliance": "0.02", "Contact/Exponent": "2",
    "Contact/Damping": "0.5", "Contact/Dashpot": "0.5", "Contact/Stiffness": "1e8", "Rod/Lateral sides": "confined",
    "Rod/Poisson ratio": "0.3",
    "Contact/Rear compliance": "2", "Contact/Rear exponent": "2",
    "Contact/Rear damping": "2", "Contact/Rear dashpot": "2", "Contact/Rear stiffness": "1e8",
    **{f"Contacts/{pair}/{name}": "2" for pair in ("a b", "b a")
       for name in ("Compliance", "Exponent", "Damping", "Dashpot", "Stiffness")},
    "Contact/Gap": "0.2", "Contact/Rear gap": "0.3", "Contact/Massless nodes": "on",
    "Initial values/Temperature": "1", "Initial values/Displacement": "0.01*x",
    "Initial values/Velocity": "x", "Sources/Heat source": "1",
    "Sources/Body force": "1",
    "Mesh/Mass matrix": "lumped",
    "Mesh/Width": "2", "Mesh/Cells across": "2", "Mesh/Grading across": "2",
    "Mesh/Geometry": "axisymmetric", "Boundary/left/Support": "sliding",
    "Time/Start": "consistent",
    "Time/Tolerance": "1e-4", "Time/First step size": "1e-3",
    "Time/Minimum step size": "1e-6", "Time/Maximum step size": "0.1",
    "Time/Locate contact events": "true", "Solver/Fixed point tolerance": "1e-9",
    "Solver/Fixed point iterations": "50", "Solver/Linear tolerance": "1e-8",
    "Output/Land on output times": "true", "Output/Fields cells": "Lagrange",
    "Output/SI": "false", "Scales/Time unit": "ms", "Scales/Temperature unit": "C",
    "Study/Reference": "Time/Tolerance = 1e-9", "Study/Repetitions": "2",
    "Study/Target error": "1e-3", "Study/Keep files": "true",
}

QUIET = ("Output/Fields interval=0",)
STEPS = "Time/Step size=0.01"
STUDY = ("Study/Vary=Mesh/Cells = 4 | 8", "Study/Reference=Time/Tolerance = 1e-9")
PLANE = "Dimension=2"
SCALES = tuple(f"Scales/{name}=2" for name in (
    "Length", "Time", "Stress", "Area", "Temperature", "Reference temperature"))
HOT_ROD = tuple(f"Rod/{entry}" for entry in (
    "Length=1", "Cross-section area=1e-4", "Density=7850", "Young's modulus=2.1e11",
    "Linear expansion=1e-5", "Conductivity=50", "Heat capacity=450",
    "Reference temperature=293")) + (
        "Boundary/left/Temperature=300", "Boundary/right/Heat exchange=9", "Time/End time=1")
ROD = HOT_ROD + ("Contact/Gap=1e-4",)
STIFF = ROD + ("Contact/Stiffness=1e8",)
MECHANICAL = """Model/Inertia; Model/Viscosity; Model/Coupling;
     Model/Thermoelastic heating; Model/Poisson ratio;
     Boundary/sides/Support; Boundary/left/Support;
     Boundary/left/Displacement; Contact/Gap;
     Contact/Massless nodes; Initial values/Displacement; Initial values/Velocity;
     Sources/Body force; Boundary/right/Traction; Time/Start;
     Time/Locate contact events"""
THERMAL = """Model/Coupling; Model/Thermoelastic heating;
     Boundary/left/Temperature; Boundary/right/Heat exchange;
     Boundary/right/Surroundings; Initial values/Temperature;
     Sources/Heat source; Boundary/right/Heat flux"""

FREE = ("Boundary/left/Support=free",)
CLAMPED = ("Boundary/right/Support=clamped",)
HEATED = ("Boundary/right/Temperature=1",)
ROW = FREE + ("Bodies/b/Length=1",)
OF_RODS = "; ".join(f"Bodies/a/{name}" for name in (
    "Length", "Cells", "Section", "Stiffness", "Density", "Viscosity", "Coupling", "Conductivity"))
TWO = ROW + ("Bodies/a/Length=1",)
BONDED = ("Bodies/b/Length=1", "Contacts/b a/Condition=bonded")
ON_LEFT = "; ".join(f"Boundary/left/{what}" for what in ("Traction", "Spring", "Dashpot", "Mass"))
ON_RIGHT = "; ".join(f"Boundary/right/{what}" for what in ("Spring", "Dashpot", "Mass"))
HEAT_ON_LEFT = "; ".join(
    f"Boundary/left/{what}" for what in ("Heat exchange", "Surroundings", "Heat flux"))

# reason, entries, the scenes without effect, neighbours where all have one
SCENES = [
    ("Dimension = 1", """Model/Poisson ratio; Boundary/sides/Support;
     Boundary/left/Support; Mesh/Width; Mesh/Cells across;
     Mesh/Grading across""", (), (PLANE,), ("Dimension=3", "Mesh/Cells=1")),
    ("Dimension = 1", "Mesh/Geometry", (), (PLANE,)),
    ("Boundary/left/Support = clamped", ON_LEFT, (), FREE),
    ("Boundary/left/Support = free", "Boundary/left/Displacement", FREE, ()),
    ("Boundary/right/Support = clamped", ON_RIGHT + ";Boundary/right/Traction", CLAMPED, ()),
    ("Boundary/right/Support = free", "Contact/Gap; Contact/Massless nodes; Time/Locate contact events",
     ("Boundary/right/Support=free",), ()),
    ("Boundary/right/Support = free", "Contact/Rear gap", ("Boundary/right/Support=free",), ()),
    ("Boundary/right/Temperature = 1", "Boundary/right/Surroundings; Boundary/right/Heat flux; "
     "Boundary/right/Heat exchange", HEATED, ()),
    ("Model/Fields = temperature", "Boundary/right/Support", ("Model/Fields=temperature",), ()),
    ("Model/Fields = displacement", "Boundary/right/Temperature", ("Model/Fields=displacement",), ()),
    ("Contacts/a b/Condition = bonded", "Contacts/a b/Gap; Contacts/a b/Heat exchange; Contacts/a b/Compliance; "
     "Contacts/a b/Damping; Contacts/a b/Dashpot",
     ROW[:1] + ("Bodies/a/Length=1", "Bodies/b/Length=1", "Contacts/a b/Condition=bonded"),
     ROW[:1] + ("Bodies/a/Length=1", "Bodies/b/Length=1")),
    ("Bodies = a row, which has them", "Initial values/Temperature; Initial values/Displacement; Initial values/Velocity",
     ROW, ()),
    ("Bodies/a/Kind = mass", OF_RODS, ROW + ("Bodies/a/Kind=mass",), ROW),
    ("Dimension = 1", "Bodies/a/Poisson ratio", ROW, (PLANE,)),
    ("Model/Fields = temperature", "Bodies/a/Poisson ratio", (PLANE, "Model/Fields=temperature"), (PLANE,)),
    ("Bodies/a/Kind = mass", "Bodies/a/Poisson ratio", (PLANE, "Bodies/b/Kind=rod", "Bodies/a/Kind=mass"), (PLANE,)),
    ("Bodies/a/Kind = mass", "Boundary/right/Surroundings", (PLANE, "Bodies/b/Kind=rod", "Bodies/a/Kind=mass"),
     (PLANE, "Bodies/b/Kind=rod")),
    ("Bodies/a/Kind = rod", "Bodies/a/Mass", ROW + ("Bodies/a/Kind=rod",), ROW + ("Bodies/a/Kind=mass",)),
    ("Bodies/NAME/Cells = a number for each rod", "Mesh/Cells; Mesh/Refinements", ROW + ("Bodies/b/Cells=4",), ROW),
    ("Model/Fields = temperature", "; ".join(f"Bodies/a/{name}" for name in (
        "Stiffness", "Density", "Viscosity", "Coupling", "Displacement", "Velocity")),
     ROW[1:] + ("Model/Fields=temperature",), ROW),
    ("Model/Fields = temperature", "Contacts/b a/Compliance; Contacts/b a/Damping; Contacts/b a/Dashpot",
     TWO[1:] + ("Model/Fields=temperature",), TWO),
    ("Contact/Condition = rigid", "Contacts/b a/Compliance; Contacts/b a/Damping; Contacts/b a/Dashpot",
     TWO + ("Contact/Condition=rigid",), TWO),
    ("Contact/Condition = normal compliance", "Contacts/b a/Exponent", TWO, TWO + ("Contact/Condition=power law",)),
    ("Contacts/b a/Condition = rigid", "Contacts/b a/Compliance; Contacts/b a/Damping; Contacts/b a/Dashpot",
     TWO + ("Contacts/b a/Condition=rigid",), TWO + ("Contact/Condition=rigid", "Contacts/b a/Condition=power law")),
    ("Contact/Condition = rigid", "Contact/Compliance", TWO + ("Contact/Condition=rigid",),
     TWO + ("Contact/Condition=rigid", "Contacts/b a/Condition=power law")),
    ("Model/Fields = temperature", "Contacts/b a/Condition", TWO[1:] + ("Model/Fields=temperature",), TWO),
    ("each of Contacts = a Condition of its own", "Contact/Condition",
     TWO + ("Boundary/right/Support=free", "Contacts/b a/Condition=normal compliance"),
     TWO + ("Contacts/b a/Condition=normal compliance",)),
    ("Boundary/right/Support = free", "Contact/Rear gap", TWO + ("Boundary/right/Support=free",), TWO),
    ("each of Contacts = a number of its own", "Contact/Compliance",
     TWO + ("Boundary/right/Support=free", "Contacts/b a/Compliance=0.5"), TWO + ("Contacts/b a/Compliance=0.5",),
     TWO + ("Boundary/right/Support=free",),
     TWO + ("Boundary/right/Support=free", "Contacts/b a/Compliance=0.5", "Bodies/c/Length=1")),
    ("each of Contacts = a number of its own", "Contact/Gap",
     TWO + ("Boundary/right/Support=free", "Contacts/b a/Gap=0.1"), TWO + ("Contacts/b a/Gap=0.1",),
     TWO + ("Boundary/right/Support=free",),
     TWO + ("Boundary/right/Support=free", "Contacts/b a/Gap=0.1", "Bodies/c/Length=1")),
    ("Model/Fields = temperature", "Contacts/b a/Gap", TWO[1:] + ("Model/Fields=temperature",), TWO),
    ("Model/Fields = displacement", "Contacts/b a/Heat exchange", TWO + ("Model/Fields=displacement",), TWO),
    ("Model/Fields = temperature", "Bodies/a/Mass", ROW[1:] + ("Model/Fields=temperature", "Bodies/a/Kind=mass"),
     ROW + ("Bodies/a/Kind=mass",)),
    ("Model/Fields = displacement", "; ".join(f"Bodies/a/{name}" for name in (
        "Coupling", "Conductivity", "Heat capacity", "Temperature")),
     ROW + ("Model/Fields=displacement",), ROW),
    ("Model/Viscosity = 0", "Bodies/a/Viscosity", ROW + ("Model/Viscosity=0",), ROW),
    ("Model/Coupling = 0", "Bodies/a/Coupling", ROW + ("Model/Coupling=0",), ROW),
    ("Model/Inertia = 0", "Bodies/a/Velocity; Bodies/a/Density", BONDED + ("Model/Inertia=0",), ROW),
    ("Model/Inertia = 0", "Bodies/a/Density", BONDED + ("Model/Inertia=0",),
     BONDED + ("Model/Inertia=0", "Sources/Body force=1")),
    ("Model/Inertia = 0 and Viscosity = 0", "Bodies/a/Displacement", BONDED + ("Model/Inertia=0", "Model/Viscosity=0"),
     BONDED + ("Model/Inertia=0",)),
    ("Boundary/left/Temperature = 10", HEAT_ON_LEFT, (), ("Boundary/left/Temperature=none",)),
    ("Model/Fields = temperature", ON_LEFT + ";" + ON_RIGHT, ("Model/Fields=temperature",), FREE),
    ("Model/Fields = displacement", HEAT_ON_LEFT, ("Model/Fields=displacement",),
     ("Boundary/left/Temperature=none",)),
    ("Dimension = 3", "Mesh/Geometry", ("Dimension=3", "Mesh/Cells=1"),
     (PLANE,)),
    ("Contact/Condition = rigid", "Contact/Compliance",
     ("Contact/Condition=rigid",), ("Contact/Condition=normal compliance",)),
    ("Contact/Condition = rigid", "Contact/Stiffness",
     ROD + ("Contact/Condition=rigid",), ROD),
    ("Model/Fields = temperature", "Contact/Stiffness",
     HOT_ROD + ("Model/Fields=temperature",), ROD),
    ("Dimension = 2", "Rod/Lateral sides",
     STIFF + ("Rod/Poisson ratio=0.3", "Mesh/Width=0.1", PLANE), STIFF + ("Rod/Poisson ratio=0.3",)),
    ("Rod/Lateral sides = free", "Rod/Poisson ratio", STIFF, STIFF + ("Rod/Lateral sides=confined",),
     STIFF + ("Mesh/Width=0.1", PLANE)),
    # section Rod decides on what other files have a coefficient for
    ("Rod/Small terms = dropped", "Initial values/Velocity; Initial values/Displacement; Contact/Massless nodes",
     STIFF + ("Rod/Small terms=dropped",), STIFF + ("Rod/Small terms=kept",)),
    ("Rod/Linear expansion = 0", "Model/Thermoelastic heating", STIFF + ("Rod/Linear expansion=0",), STIFF),
    # a stiffness under its own name
    ("each of Contacts = a number of its own", "Contact/Stiffness; Contact/Gap",
     HOT_ROD + TWO + ("Boundary/right/Support=free", "Contacts/b a/Gap=1e-4", "Contacts/b a/Stiffness=1e8"),
     HOT_ROD + TWO + ("Contacts/b a/Gap=1e-4", "Contacts/b a/Stiffness=1e8"),
     HOT_ROD + TWO + ("Boundary/right/Support=free",)),
    ("Contact/Condition = none", "Contact/Compliance",
     ("Contact/Condition=none",), ("Contact/Condition=normal compliance",)),
    ("Contact/Condition = normal compliance", "Contact/Exponent", (),
     ("Contact/Condition=power law",)),
    ("Contact/Condition = rigid", "Contact/Damping", ("Contact/Condition=rigid",),
     ("Contact/Condition=normal compliance",), ("Contact/Condition=power law",)),
    ("Contact/Rear gap = none", "Contact/Rear compliance", (), ("Contact/Rear gap=0.1",)),
    ("Contact/Condition = rigid", "Contact/Rear compliance",
     ("Contact/Condition=rigid", "Contact/Rear gap=0.1"), ("Contact/Rear gap=0.1",)),
    ("Contact/Condition = normal compliance", "Contact/Rear exponent",
     ("Contact/Rear gap=0.1",), ("Contact/Rear gap=0.1", "Contact/Condition=power law")),
    ("Contact/Condition = none", "Contact/Damping", ("Contact/Condition=none",),
     ("Contact/Condition=power law",)),
    ("Contact/Condition = rigid", "Contact/Dashpot", ("Contact/Condition=rigid",),
     ("Contact/Condition=normal compliance",), ("Contact/Condition=power law",)),
    ("Contact/Condition = none", "Contact/Dashpot", ("Contact/Condition=none",),
     ("Contact/Condition=power law",)),
    ("Contact/Condition = none",
     "Contact/Gap; Contact/Massless nodes; Time/Locate contact events",
     ("Contact/Condition=none",), ("Contact/Condition=normal compliance",),
     ("Contact/Condition=rigid",)),
    ("Contact/Condition = none", "Contact/Rear gap", ("Contact/Condition=none",),
     ("Contact/Condition=power law",)),
    ("Model/Fields = temperature", "Contact/Rear gap",
     ("Model/Fields=temperature",), ()),
    ("Boundary/right/Heat exchange = 0", "Boundary/right/Surroundings",
     ("Boundary/right/Heat exchange=0",), ("Boundary/right/Heat exchange=1e-9",)),
    ("Boundary/sides/Heat exchange = 0", "Boundary/sides/Surroundings", (),
     ("Boundary/sides/Heat exchange=1e-9",)),
    ("Time/Step size = a number", """Time/Tolerance; Time/First step size; Time/Minimum step size;
     Time/Maximum step size""", (STEPS,),
     ("Time/Step size=automatic",)),
    ("Output/Contact interval = 0 and no other interval is set",
     "Output/Land on output times", QUIET, QUIET + ("Output/Contact interval=1",),
     ("Output/Fields interval=1",), QUIET + ("Output/Space-time interval=1",)),
    ("Output/Fields interval = 0", "Output/Fields cells", QUIET + (PLANE,),
     ("Output/Fields interval=1", PLANE)),
    ("Dimension = 1", "Output/Fields cells", (), (PLANE, "Output/Fields interval=1")),
    ("Study/Vary = (empty)", """Study/Reference; Study/Repetitions; Study/Target error;
     Study/Keep files""", (), STUDY),
    ("Scales/Length = none", "Output/SI; Scales/Time unit; Scales/Temperature unit", (),
     SCALES),
    ("Solver/Step solver = monolithic",
     "Solver/Fixed point tolerance; Solver/Fixed point iterations", (),
     ("Solver/Step solver=fixed point", "Time/Scheme=backward euler", STEPS)),
    ("Solver/Linear solver = direct", "Solver/Linear tolerance", (),
     (PLANE, "Solver/Linear solver=iterative"),
     # 193 x 385 nodes with three unknowns, above every limit
     (PLANE, "Mesh/Cells=48", "Mesh/Cells across=96")),
    ("Solver/Step solver = fixed point", "Solver/Linear tolerance",
     (PLANE, "Solver/Linear solver=iterative", "Solver/Step solver=fixed point",
      "Time/Scheme=backward euler", STEPS),
     (PLANE, "Solver/Linear solver=iterative")),
    ("Solver/Linear solver = direct", "Solver/Linear tolerance",
     (PLANE, "Solver/Linear solver=direct"),
     (PLANE, "Solver/Linear solver=iterative")),
    ("Model/Fields = temperature", MECHANICAL,
     ("Model/Fields=temperature", PLANE), (PLANE,)),
    ("Model/Fields = temperature", "Contact/Compliance",
     ("Model/Fields=temperature",), ()),
    ("Model/Fields = temperature", "Contact/Exponent",
     ("Model/Fields=temperature",), ("Contact/Condition=power law",)),
    ("Model/Fields = temperature", "Contact/Damping",
     ("Model/Fields=temperature",), ()),
    ("Model/Fields = temperature", "Contact/Dashpot",
     ("Model/Fields=temperature",), ()),
    ("Model/Fields = temperature", "Contact/Condition",
     ("Model/Fields=temperature",), ()),
    ("Model/Fields = temperature", "Study/Target error",
     ("Model/Fields=temperature",), STUDY),
    ("Model/Fields = displacement", THERMAL, ("Model/Fields=displacement",), ()),
    ("Model/Fields = displacement", "Boundary/sides/Heat exchange; "
     "Boundary/sides/Surroundings", ("Model/Fields=displacement",),
     ("Boundary/sides/Heat exchange=1e-9",)),
    ("Model/Coupling = 0", "Model/Thermoelastic heating", ("Model/Coupling=0",),
     ("Model/Coupling=-1e-9",)),
    ("Model/Inertia = 0", "Mesh/Mass matrix",
     ("Model/Fields=displacement", "Model/Inertia=0"),
     ("Model/Fields=displacement",), ("Model/Inertia=0",),
     ("Model/Fields=temperature",)),
    ("Model/Inertia = 0", "Initial values/Velocity; Contact/Massless nodes",
     ("Model/Inertia=0",), ("Model/Inertia=1e-6",)),
    ("Model/Inertia = 0 and Viscosity = 0", "Initial values/Displacement",
     ("Model/Inertia=0", "Model/Viscosity=0"), ("Model/Inertia=0",),
     ("Model/Viscosity=0",)),
]


def entries(text):
    return [" ".join(entry.split()) for entry in text.split(";")]


def setting(path):
    return f"{path}={VALUES[path]}"


def as_stated(path, reason, answer):
    """One of several reasons may be named."""
    status, message = answer
    return status == 2 and message.startswith(
        f"{path} = {VALUES[path]} has no effect, since {reason}\n  remedy:  remove the "
        f"entry or change {reason.partition(' = ')[0]}\n")


def uncovered():
    """Lists of entries in the sources, add_if(condition, {...}, reason), more
    often there than above."""
    in_sources = [path for file in source_files()
                  for text in [without_comments(file)]
                  for call in re.finditer(r"\badd_if\(", text)
                  for entry_list in re.findall(
                      r"\{([^}]*)\}", text[call.end() - 1:
                                           closing(text, call.end() - 1)])
                  for path in re.findall(r'"([^"]*)"', entry_list)]
    here = [path for _, words, *_ in SCENES for path in entries(words)]
    return sorted({path for path in in_sources
                   if in_sources.count(path) > here.count(path)}), in_sources


def main():
    refused = [(path, reason, without + (setting(path),))
               for reason, words, without, *_ in SCENES
               for path in entries(words)]
    accepted = [neighbour + tuple(setting(path) for path in entries(words))
                for _, words, _, *neighbours in SCENES
                for neighbour in neighbours]
    answers = check_all([scene for *_, scene in refused] + accepted)
    faults = [f"{' '.join(scene)}: {answers[scene]}"
              for path, reason, scene in refused
              if not as_stated(path, reason, answers[scene])]
    faults += [f"{' '.join(scene)}: {answers[scene]}, to be accepted"
               for scene in accepted if answers[scene][0] != 0]
    print("without effect: refused, with effect: accepted:",
          "; ".join(faults) or "all")
    missing, in_sources = uncovered()
    print("entries in the sources that no scene here has:",
          "; ".join(missing) or ("none" if in_sources else "nothing found"))


main()
