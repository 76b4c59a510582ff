# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of several dimensions with a material or a mass that no run can have, as check_refusals.py has them: the entry
at fault, what the scenes share, what is refused, its accepted neighbours."""
PLATE = ("Dimension=2", "Bodies/a/Kind=rod")
RAM = PLATE + ("Bodies/b/Kind=mass",)
SDIRK = ("Time/Scheme=sdirk4",)
EULER = ("Time/Scheme=backward euler", "Time/Step size=0.01")
LAYERS = ("Dimension=2", "Bodies/a/Stiffness=if(y<0.05,1,if(x<0.5,2,3))")
VALUES = (("Temperature", "1"), ("Displacement", "0.1"), ("Velocity", "1"))

SCENES = [
    ("Bodies/c", RAM, "Bodies/c/Kind=mass", ("Bodies/c/Kind=mass", "Dimension=1")),
    ("Bodies/b", PLATE + ("Bodies/b/Kind=rod",), "Dimension=2", "Dimension=1"),
    ("Bodies/a/Kind", ("Dimension=2",), "Bodies/a/Kind=mass", "Bodies/a/Kind=rod"),
    ("Contacts/a b", RAM, "Contacts/a b/Gap=0.1", "Contact/Gap=0.1"),
    *[(f"Bodies/a/{entry}", PLATE, f"Bodies/a/{entry}={value}", f"Bodies/a/{entry}={allowed}")
      for entry, value, allowed in (("Length", "0.5", "1"), ("Cells", "4", "automatic"), ("Section", "2", "1"),
                                    ("Section", "1+x", "1"))],
    *[(f"Bodies/a/{entry}", PLATE, f"Bodies/a/{entry}={value}", f"Bodies/a/{entry}=0") for entry, value in VALUES],
    ("Bodies/a/Stiffness", PLATE + ("Model/Fields=displacement",), "Bodies/a/Stiffness=1+theta",
     "Bodies/a/Stiffness=1+y"),
    ("Contact/Massless nodes", PLATE + ("Bodies/a/Stiffness=1+theta/100",), "Contact/Massless nodes=on",
     "Contact/Massless nodes=off"),
    ("Bodies/a/Poisson ratio", PLATE, "Bodies/a/Poisson ratio=5*y", "Bodies/a/Poisson ratio=4*y"),
    ("Bodies/a/Poisson ratio", PLATE, "Bodies/a/Poisson ratio=-1", "Bodies/a/Poisson ratio=-0.9"),
    ("Bodies/a/Poisson ratio", PLATE, "Bodies/a/Poisson ratio=0.1+theta", "Bodies/a/Poisson ratio=0.1+x/10"),
    ("Bodies/a/Stiffness", PLATE, "Bodies/a/Stiffness=y-0.05", "Bodies/a/Stiffness=y+0.05"),
    ("Bodies/a/Density", PLATE, "Bodies/a/Density=1/x", "Bodies/a/Density=1/(x+1)"),
    ("Bodies/a/Density", PLATE, "Bodies/a/Density=1/(x-0.4)^2", "Bodies/a/Density=1/(x+1)^2"),
    # cells that end at jumps
    ("Mesh/Cells", LAYERS, "Mesh/Cells=1", "Mesh/Cells=2"),
    ("Mesh/Cells across", LAYERS, "Mesh/Cells across=1", "Mesh/Cells across=2"),
    ("Mesh/Grading", LAYERS, "Mesh/Grading=2", "Mesh/Grading=1", ("Mesh/Grading=2", "Bodies/a/Stiffness=1+x")),
    ("Mesh/Grading across", LAYERS, "Mesh/Grading across=2", "Mesh/Grading across=1"),
    ("Solver/Linear solver", PLATE, "Solver/Linear solver=iterative", "Solver/Linear solver=direct"),
    # the mass
    ("Bodies/b/Velocity", RAM, "Bodies/b/Velocity=x", "Bodies/b/Velocity=-1"),
    ("Bodies/b/Displacement", RAM, "Bodies/b/Displacement=0.1", "Bodies/b/Displacement=0"),
    ("Bodies/b/Heat capacity", RAM, "Bodies/b/Heat capacity=1+x", "Bodies/b/Heat capacity=2"),
    ("Bodies/b/Temperature", RAM, "Bodies/b/Temperature=x", "Bodies/b/Temperature=1"),
    ("Boundary/right/Heat exchange", RAM, "Boundary/right/Heat exchange=1+theta", "Boundary/right/Heat exchange=1+gap"),
    ("Model/Inertia", RAM, "Model/Inertia=0", "Model/Inertia=0.1"),
    ("Model/Fields", RAM, "Model/Fields=temperature", "Model/Fields=displacement"),
    ("Boundary/right/Support", RAM, "Boundary/right/Support=free", "Boundary/right/Support=contact"),
    ("Contact/Condition", RAM, "Contact/Condition=rigid", "Contact/Condition=normal compliance"),
    ("Contact/Rear gap", RAM, "Contact/Rear gap=0.1", "Contact/Rear gap=none"),
    ("Contact/Gap", RAM, "Contact/Gap=0.1+0.01*t", "Contact/Gap=0.1+y"),
    ("Contact/Massless nodes", RAM, "Contact/Massless nodes=on", "Contact/Massless nodes=off"),
    ("Solver/Step solver", RAM + EULER, "Solver/Step solver=fixed point", "Solver/Step solver=monolithic"),
    ("Time/Start", RAM + EULER, "Time/Start=paper", "Time/Start=consistent"),
    ("Time/Scheme", RAM + ("Time/Step size=0.01",), "Time/Scheme=energy conserving", "Time/Scheme=backward euler"),
    ("Boundary/right/Mass", RAM, "Boundary/right/Mass=1", "Boundary/right/Mass=0"),
    *[(f"Boundary/right/{entry}", PLATE, f"Boundary/right/{entry}=1", f"Boundary/right/{entry}=0",
       (f"Boundary/right/{entry}=1", "Bodies/b/Kind=mass")) for entry in ("Spring", "Dashpot")],
]
