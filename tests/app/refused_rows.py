# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of bodies that no run can have, as check_refusals.py has them: the entry at fault, what the scenes share, what
is refused, its accepted neighbours."""


def rods(*names):
    """Rods of length 1/2."""
    return tuple(f"Bodies/{name}/Length=0.5" for name in names)


def mass(name):
    return (f"Bodies/{name}/Kind=mass",)


FREE = ("Boundary/left/Support=free",)
RIGID = ("Contact/Condition=rigid",)
POWER = ("Contact/Condition=power law",)
NONE = ("Contact/Condition=none",)
ALONE = ("Boundary/right/Support=free",)
HELD = ("Boundary/right/Support=clamped",)
STATIC = ("Model/Inertia=0",)
FIXED = ("Time/Step size=0.01",)
TWO = rods("a", "b")
SDIRK = ("Time/Scheme=sdirk4",)
MOVING = ("Model/Fields=displacement",)
CONDITION = "Contacts/a b/Condition"
RESTITUTION = "Contact/Restitution"
# of steel, which vibrates in 0.2 ms; the coefficients follow from section Rod
STEEL = MOVING + ("Rod/Length=1", "Rod/Cross-section area=1e-4", "Rod/Density=7850", "Rod/Young's modulus=2.1e11",
                  "Contact/Gap=1e-4", "Contact/Stiffness=1e8", "Time/End time=1e-3")
TERMS = "Rod/Small terms"
QUIET = STEEL + (TERMS + "=dropped",)
BALLS = MOVING + FREE + mass("a") + mass("b") + ALONE

SCENES = [
    ("Mesh/Grading", TWO + SDIRK, "Mesh/Grading=2", "Mesh/Grading=1"),
    ("Solver/Step solver", TWO + FIXED + ("Time/Scheme=backward euler",), "Solver/Step solver=fixed point",
     "Solver/Step solver=monolithic"),
    ("Time/Scheme", TWO + FIXED, "Time/Scheme=energy conserving", "Time/Scheme=backward euler"),
    ("Time/Start", TWO + FIXED + ("Time/Scheme=backward euler",), "Time/Start=paper", "Time/Start=consistent"),
    ("Contact/Massless nodes", TWO + SDIRK, "Contact/Massless nodes=on", "Contact/Massless nodes=off"),
    # two stops at the right end
    ("Contact/Rear gap", TWO, "Contact/Rear gap=-0.1", "Contact/Rear gap=0"),
    ("Contact/Rear gap", TWO + RIGID + ("Contact/Rear gap=0.1", "Contacts/a b/Gap=1"), "Bodies/b/Displacement=-0.2",
     "Bodies/b/Displacement=-0.1"),
    ("Contacts", TWO + RIGID + ("Contact/Rear gap=0.1",), "Bodies/b/Displacement=0.2", "Bodies/b/Displacement=0.1"),
    ("Contact/Gap", TWO + ALONE + (CONDITION + "=bonded",), "Contact/Gap=0.1+0.01*t", "Contact/Gap=0.1",
     ("Contact/Gap=0.1+0.01*t", "Boundary/right/Support=contact")),
    ("Contacts/a b/Gap", TWO, "Contact/Gap=0.1+0.01*t", ("Contact/Gap=0.1+0.01*t", "Contacts/a b/Gap=0.1")),
    # an end where nothing is met
    ("Boundary/right/Heat exchange", TWO + ALONE, "Boundary/right/Heat exchange=1+t", "Boundary/right/Heat exchange=1",
     ("Boundary/right/Heat exchange=1+t", "Boundary/right/Temperature=1")),
    # two temperatures
    ("Boundary/right/Heat exchange", TWO, "Boundary/right/Heat exchange=1+theta", "Boundary/right/Heat exchange=1+gap",
     "Boundary/right/Heat exchange=1+t"),
    # an overlap of rigid bodies
    ("Contacts", TWO + RIGID, "Contacts/a b/Gap=-0.02", "Contacts/a b/Gap=0.02"),
    # two contacts of rigid bodies with inertia; one is located
    ("Time/Scheme", TWO + RIGID, "Time/Scheme=sdirk4", "Time/Scheme=box", SDIRK + ALONE,
     SDIRK + ("Contact/Condition=normal compliance",)),
    # a rigid contact beside another one; alone it is located
    ("Time/Scheme", TWO + (CONDITION + "=rigid",), "Time/Scheme=sdirk4", "Time/Scheme=box", SDIRK + ALONE),
    ("Time/Scheme", TWO + RIGID + (CONDITION + "=power law",), "Time/Scheme=sdirk4", "Time/Scheme=box",
     SDIRK + ("Contact/Condition=normal compliance",)),
    (CONDITION, TWO + STATIC + ("Boundary/right/Spring=1", "Contact/Damping=0.5"), CONDITION + "=rigid",
     CONDITION + "=power law", (CONDITION + "=rigid", "Contact/Damping=0"),
     (CONDITION + "=rigid", "Model/Inertia=1", "Boundary/right/Spring=0")),
    (CONDITION, TWO + NONE, CONDITION + "=power law", CONDITION + "=contact",
     (CONDITION + "=power law", "Contact/Condition=rigid")),
    (CONDITION, TWO, CONDITION + "=none", CONDITION + "=rigid"),
    # what stands at the end of a row
    ("Boundary/left/Support", MOVING + mass("a") + rods("b"), "Boundary/left/Support=clamped",
     "Boundary/left/Support=free"),
    ("Boundary/left/Traction", MOVING + FREE + mass("a") + rods("b"), "Boundary/left/Traction=1",
     "Boundary/left/Traction=0"),
    *[(f"Boundary/left/{entry}", MOVING + FREE + mass("a") + rods("b") + SDIRK + ALONE, f"Boundary/left/{entry}=1",
       f"Boundary/left/{entry}=0", (f"Boundary/left/{entry}=1", "Bodies/a/Kind=rod"))
      for entry in ("Spring", "Dashpot", "Mass")],
    ("Boundary/right/Mass", MOVING + rods("a") + mass("b") + SDIRK + ALONE, "Boundary/right/Mass=1",
     "Boundary/right/Mass=0"),
    ("Boundary/left/Temperature", FREE + mass("a") + rods("b"), "Boundary/left/Temperature=5",
     "Boundary/left/Temperature=none"),
    *[(f"Boundary/left/{entry}", FREE + mass("a") + rods("b") + ("Boundary/left/Temperature=none",),
       f"Boundary/left/{entry}=1", f"Boundary/left/{entry}=0") for entry in ("Heat exchange", "Heat flux")],
    ("Boundary/right/Support", MOVING + rods("a") + mass("b"), "Boundary/right/Support=clamped",
     "Boundary/right/Support=free"),
    ("Boundary/right/Temperature", rods("a") + mass("b") + ALONE, "Boundary/right/Temperature=1",
     "Boundary/right/Temperature=none"),
    ("Output/Probes", TWO + ("Contact/Gap=0.25",), "Output/Probes=0.6", "Output/Probes=0.8", "Output/Probes=1.25"),
    ("Bodies/a/Kind", STATIC + rods("b") + ("Contacts/b a/Gap=0",) + ALONE, "Bodies/a/Kind=mass",
     ("Bodies/a/Kind=mass", "Model/Inertia=1")),
    # held by nothing
    ("Model/Inertia", TWO + ALONE, "Model/Inertia=0", "Model/Inertia=0.1", STATIC + HELD,
     STATIC + (CONDITION + "=bonded",)),
    ("Model/Inertia", rods("a", "b", "c") + HELD, "Model/Inertia=0", "Model/Inertia=0.1",
     STATIC + (CONDITION + "=bonded",)),
    (TERMS, STEEL + TWO + ALONE, TERMS + "=dropped", TERMS + "=kept", (TERMS + "=dropped",) + HELD,
     (TERMS + "=dropped", CONDITION + "=bonded")),
    (TERMS, STEEL + rods("a", "b", "c") + HELD, TERMS + "=dropped", TERMS + "=kept",
     (TERMS + "=dropped", CONDITION + "=bonded")),
    # in SI units the remedy is one of section Rod
    ("Bodies/a/Kind", QUIET + rods("b") + ALONE, "Bodies/a/Kind=mass", ("Bodies/a/Kind=mass", TERMS + "=kept")),
    *[(entry, QUIET, f"{entry}={value}", f"{entry}={allowed}", (f"{entry}={value}", TERMS + "=kept"))
      for entry, value, allowed in (
          ("Boundary/left/Support", "free", "clamped"), ("Boundary/right/Mass", "1", "0"),
          ("Boundary/right/Dashpot", "1", "0"), ("Contact/Dashpot", "1", "0"))],
    ("Contact/Damping", STEEL + ("Contact/Massless nodes=on",), "Contact/Damping=1", "Contact/Damping=0",
     ("Contact/Damping=1", "Rod/Viscosity=1e5"), ("Contact/Damping=1", "Contact/Massless nodes=automatic")),
    (TERMS, STEEL + ("Dimension=2", "Rod/Poisson ratio=0.3", "Mesh/Width=0.1", "Bodies/a/Kind=rod") + mass("b"),
     TERMS + "=dropped", TERMS + "=kept"),
    # rigid masses that meet
    (RESTITUTION, BALLS + RIGID, RESTITUTION + "=none", RESTITUTION + "=0.5",
     (RESTITUTION + "=none", "Contact/Condition=normal compliance")),
    (RESTITUTION, BALLS + RIGID, RESTITUTION + "=1.1", RESTITUTION + "=1"),
    (RESTITUTION, MOVING + TWO + RIGID, RESTITUTION + "=0.5", RESTITUTION + "=none"),
    ("Bodies/b/Kind", BALLS + RIGID + mass("c") + (RESTITUTION + "=1",), "Bodies/b/Kind=mass",
     ("Bodies/b/Kind=rod", RESTITUTION + "=none"), CONDITION + "=power law"),
    (RESTITUTION, BALLS + (CONDITION + "=rigid",), RESTITUTION + "=none", RESTITUTION + "=0.5",
     (RESTITUTION + "=none", CONDITION + "=power law")),
    (RESTITUTION, BALLS + (CONDITION + "=power law",), RESTITUTION + "=0.5", RESTITUTION + "=none",
     (RESTITUTION + "=0.5", CONDITION + "=rigid")),
    ("Bodies/a b/Length", (), "Bodies/a b/Length=1", "Bodies/a_b/Length=1"),
    ("Contacts/a c", rods("a"), "Contacts/a c/Gap=0.1"),
    ("Contacts/a c", TWO, "Contacts/a c/Gap=0.1", "Contacts/a b/Gap=0.1"),
    ("Time/Scheme", BALLS + RIGID + (RESTITUTION + "=1",), "Time/Scheme=sdirk4", "Time/Scheme=box"),
    (CONDITION, FREE + TWO, (CONDITION + "=bonded", "Bodies/b/Kind=mass", "Bodies/b/Length=1"),
     CONDITION + "=bonded"),
    # coefficients of x
    ("Bodies/a/Section", TWO, "Bodies/a/Section=x", "Bodies/a/Section=0.01+x"),
    ("Bodies/a/Density", TWO, "Bodies/a/Density=1-3*x", "Bodies/a/Density=1-x", "Bodies/a/Viscosity=x",
     "Bodies/a/Coupling=1-3*x"),
    ("Bodies/a/Viscosity", TWO, "Bodies/a/Viscosity=x-0.2", "Bodies/a/Viscosity=x"),
    ("Bodies/a/Coupling", TWO, "Bodies/a/Coupling=sqrt(0.4-x)", "Bodies/a/Coupling=sqrt(0.6-x)"),
    # as many parts as jumps and kinks make, and one more
    ("Bodies/a/Cells", TWO + ("Bodies/a/Section=1+floor(20*x)",), "Bodies/a/Cells=1", "Bodies/a/Cells=10"),
    ("Bodies/a/Cells", TWO + SDIRK + ("Bodies/a/Section=1+abs(x-0.2)",), "Bodies/a/Cells=1", "Bodies/a/Cells=2"),
    ("Bodies/a/Stiffness", TWO, "Bodies/a/Stiffness=2+sin(1e9*x)", "Bodies/a/Stiffness=2+sin(x)"),
    # coefficients of the temperature
    ("Bodies/a/Stiffness", TWO + MOVING + SDIRK, "Bodies/a/Stiffness=2+theta", "Bodies/a/Stiffness=2+x"),
    ("Time/Scheme", TWO, ("Bodies/a/Coupling=2+theta", "Time/Scheme=box"),
     ("Bodies/a/Coupling=2+theta", "Contact/Condition=normal compliance")),
    ("Bodies/a/Section", TWO, "Bodies/a/Section=1+theta", "Bodies/a/Section=1+x"),
    ("Bodies/a/Conductivity", TWO + SDIRK, "Bodies/a/Conductivity=theta-1", "Bodies/a/Conductivity=2+theta/1e3"),
    ("Bodies/a/Cells", TWO + ("Bodies/a/Conductivity=if(x<0.2,1,2)",), "Bodies/a/Cells=1", "Bodies/a/Cells=2",
     "Bodies/a/Cells=automatic"),
    ("Bodies/b/Heat capacity", rods("a") + mass("b"), "Bodies/b/Heat capacity=1+x", "Bodies/b/Heat capacity=2",
     ("Bodies/b/Heat capacity=1+x", "Bodies/b/Kind=rod")),
    ("Contacts/a b/Heat exchange", TWO + ("Boundary/right/Heat exchange=1+gap",), "Contacts/a b/Heat exchange=2",
     "Contacts/a b/Heat exchange=none"),
    # contacts with laws of their own
    ("Contacts/a b/Compliance", TWO, "Contacts/a b/Compliance=0", "Contacts/a b/Compliance=1e-13",
     "Contacts/a b/Compliance=none"),
    ("Contacts/a b/Exponent", TWO + POWER, "Contacts/a b/Exponent=0.999", "Contacts/a b/Exponent=1"),
    ("Contacts/a b/Compliance", TWO + RIGID + (CONDITION + "=power law",), "Contacts/a b/Compliance=0",
     "Contacts/a b/Compliance=1e-13", "Contacts/a b/Compliance=none"),
    ("Contacts/a b/Dashpot", TWO + STATIC + HELD + ("Model/Viscosity=0",), "Contacts/a b/Dashpot=0.5",
     "Contacts/a b/Dashpot=0", ("Contacts/a b/Dashpot=0.5", "Model/Viscosity=0.1")),
    ("Contacts/a b/Stiffness", TWO, "Contacts/a b/Stiffness=1e8", "Contacts/a b/Compliance=0.1"),
    # ends that are held are of rods
    ("Dimension", HELD, "Dimension=2", "Dimension=1"),
    ("Dimension", ("Boundary/right/Temperature=1",), "Dimension=3", "Dimension=1"),
]
