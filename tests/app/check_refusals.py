#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes that no run can have, each beside the nearest one that can be."""
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from program import run, settings  # noqa: E402
from refused_bodies import SCENES as BODY_SCENES  # noqa: E402
from refused_contact import SCENES as CONTACT_SCENES  # noqa: E402
from refused_rows import SCENES as ROW_SCENES  # noqa: E402
from refused_scenes import check_all, unmet_refusals  # noqa: E402

PLANE = ("Dimension=2", "Mesh/Width=1")
BLOCK = ("Dimension=3", "Mesh/Degree=2")
NARROW = ("Dimension=2", "Mesh/Width=0.3")
FIXED = ("Time/Step size=0.01",)
EULER = FIXED + ("Time/Scheme=backward euler",)
CONSERVING = FIXED + ("Time/Scheme=energy conserving",)
QUASI_STATIC = ("Model/Inertia=0",)
FREE = ("Boundary/left/Support=free",)
ITERATION = EULER + ("Solver/Step solver=fixed point",)
MASSLESS = ("Contact/Massless nodes=on",)
STUDY = ("Study/Vary=Mesh/Cells = 4 | 8",)
# 100 x 100 x 11 runs are too many, 100 x 2 are not
HUNDRED = " | ".join(f"0.{n}" for n in range(100, 200))
MANY = f"Study/Vary=Contact/Compliance = {HUNDRED} ; Contact/Gap = "
RIGID = ("Contact/Condition=rigid",)
ITERATIVE = PLANE + ("Solver/Linear solver=iterative",)
POWER = ("Contact/Condition=power law",)
LOSS = ("Boundary/sides/Heat exchange=2",)
EXCHANGE = ("Boundary/right/Heat exchange=1+gap",)
BOX = FIXED + ("Time/Scheme=box",)
WAVES = ("Mesh/Degree=1", "Model/Viscosity=0")

SCALES = tuple(f"Scales/{name}=2" for name in (
    "Length", "Time", "Stress", "Area", "Temperature", "Reference temperature"))

# entry at fault, what the scenes share, what is refused, its accepted neighbours
SCENES = [
    # more memory than twice the 3 GiB that check() leaves: factors of eight step sizes
    # for 5.7e4 unknowns, 8 x 92 n^1.54 bytes = 15 GB; 700 bytes for each of 2.6e7
    ("Solver/Linear solver", BLOCK + ("Mesh/Cells=24", "Mesh/Cells across=8"),
     "Solver/Linear solver=direct", "Solver/Linear solver=iterative",
     ("Solver/Linear solver=direct", "Mesh/Cells=4", "Mesh/Cells across=2")),
    ("Mesh/Cells", BLOCK + ("Solver/Linear solver=iterative", "Mesh/Cells across=16"),
     "Mesh/Cells=3000", "Mesh/Cells=4"),
    *[(entry, BLOCK + ("Mesh/Cells across=8", "Solver/Linear solver=direct") + shared,
       changed + "24", changed + "3") for entry, shared, changed in (
           ("Study/Vary", (), "Study/Vary=Mesh/Cells = 4 | "),
           ("Study/Reference", ("Study/Vary=Mesh/Cells = 2 | 4",),
            "Study/Reference=Mesh/Cells = "))],
    # runs that are too large by themselves, beside a reference that is larger
    ("Study/Vary", BLOCK + ("Mesh/Cells across=8", "Solver/Linear solver=direct"),
     ("Study/Vary=Mesh/Cells = 4 | 24", "Study/Reference=Mesh/Cells = 28"),
     ("Study/Vary=Mesh/Cells = 2 | 3", "Study/Reference=Mesh/Cells = 4")),
    ("Model/Poisson ratio", PLANE, "Model/Poisson ratio=-1",
     "Model/Poisson ratio=-0.999"),
    ("Model/Poisson ratio", PLANE, "Model/Poisson ratio=0.5",
     "Model/Poisson ratio=0.4999"),
    ("Contact/Compliance", (), "Contact/Compliance=0",
     "Contact/Compliance=1e-13"),
    # power laws: their exponents, and what needs a linear one
    ("Contact/Exponent", POWER, "Contact/Exponent=0.999", "Contact/Exponent=1",
     "Contact/Exponent=10"),
    ("Contact/Compliance", POWER, "Contact/Compliance=0", "Contact/Compliance=1e-13"),
    *[(entry, scene, POWER[0], "Contact/Condition=normal compliance",
       POWER + ("Contact/Exponent=1",)) for entry, scene in (
           ("Time/Scheme", CONSERVING), ("Solver/Step solver", ITERATION))],
    # damping: its sign, and what needs an obstacle that stores all
    ("Contact/Damping", (), "Contact/Damping=-1e-9", "Contact/Damping=0",
     "Contact/Damping=1e3"),
    *[("Contact/Damping", scene + condition, "Contact/Damping=1e-3", "Contact/Damping=0")
      for condition in ((), ("Contact/Condition=power law", "Contact/Exponent=1"))
      for scene in (CONSERVING, ITERATION)],
    ("Contact/Damping", ("Contact/Massless nodes=on", "Contact/Damping=0.5"),
     "Model/Viscosity=0", "Model/Viscosity=1e-3",
     ("Model/Viscosity=0", "Contact/Damping=0"),
     ("Model/Viscosity=0", "Contact/Massless nodes=automatic")),
    ("Contact/Dashpot", (), "Contact/Dashpot=-1e-9", "Contact/Dashpot=0",
     "Contact/Dashpot=1e3"),
    *[("Contact/Dashpot", scene + condition, "Contact/Dashpot=1e-3", "Contact/Dashpot=0")
      for condition in ((), ("Contact/Condition=power law", "Contact/Exponent=1"))
      for scene in (CONSERVING, ITERATION)],
    ("Contact/Dashpot", ("Contact/Dashpot=0.5",),
     "Contact/Massless nodes=on", "Contact/Massless nodes=automatic",
     ("Contact/Massless nodes=on", "Contact/Dashpot=0"),
     ("Contact/Massless nodes=on", "Contact/Dashpot=0", "Contact/Damping=0.5")),
    ("Contact/Dashpot", ("Model/Inertia=0", "Model/Viscosity=0"),
     "Contact/Dashpot=0.5", "Contact/Dashpot=0", "Contact/Damping=0.5",
     ("Contact/Dashpot=0.5", "Model/Viscosity=0.1"),
     ("Contact/Dashpot=0.5", "Model/Inertia=1")),
    # a rear stop with numbers of its own
    ("Contact/Rear compliance", ("Contact/Rear gap=0.1",), "Contact/Rear compliance=0",
     "Contact/Rear compliance=1e-13", "Contact/Rear compliance=as in front"),
    ("Contact/Rear exponent", POWER + ("Contact/Rear gap=0.1",), "Contact/Rear exponent=0.999",
     "Contact/Rear exponent=1", "Contact/Rear exponent=10"),
    *[("Contact/Rear compliance", scene + ("Contact/Rear gap=0.1",),
       "Contact/Rear compliance=0.1", "Contact/Rear compliance=as in front")
      for scene in (CONSERVING, ITERATION)],
    ("Contact/Rear dashpot", ("Contact/Rear gap=0.1", "Contact/Rear dashpot=0.5"),
     "Contact/Massless nodes=on", "Contact/Massless nodes=automatic",
     ("Contact/Massless nodes=on", "Contact/Rear dashpot=as in front")),
    ("Contact/Rear stiffness", ("Contact/Rear gap=0.1",), "Contact/Rear stiffness=1e8", "Contact/Rear compliance=0.1"),
    # an obstacle whose temperature varies
    ("Boundary/right/Surroundings", (), "Boundary/right/Surroundings=5*sin(t",
     "Boundary/right/Surroundings=5*sin(t)", "Boundary/right/Surroundings=-5"),
    ("Boundary/right/Surroundings", (), "Boundary/right/Surroundings=y*t",
     ("Boundary/right/Surroundings=y*t", "Dimension=2", "Mesh/Cells=1")),
    # heat that is lost along the rod
    ("Boundary/sides/Heat exchange", (), "Boundary/sides/Heat exchange=-1e-3",
     "Boundary/sides/Heat exchange=0", "Boundary/sides/Heat exchange=1e-3"),
    ("Boundary/sides/Surroundings", LOSS, "Boundary/sides/Surroundings=sin(t)",
     "Boundary/sides/Surroundings=-300"),
    ("Output/Period", (), "Output/Period=-1", "Output/Period=0", "Output/Period=0.3"),
    # a fixed end that is heated or moved
    ("Boundary/left/Temperature", (), "Boundary/left/Temperature=5*sin(t",
     "Boundary/left/Temperature=5*sin(t)", "Boundary/left/Temperature=-5"),
    ("Boundary/left/Temperature", (), "Boundary/left/Temperature=x*t",
     "Boundary/left/Temperature=2*t"),
    ("Boundary/left/Displacement", (), "Boundary/left/Displacement=0.1*cos(t)",
     "Boundary/left/Displacement=0.1*cos(t)-0.1"),
    ("Boundary/left/Displacement", (), "Boundary/left/Displacement=1",
     "Boundary/left/Displacement=0"),
    # not zero at the start, by the size that the motion has up to the end time; behind
    # it, it is so large that 1e-9 would be its rounding
    ("Boundary/left/Displacement", ("Time/End time=1",),
     "Boundary/left/Displacement=1e-9+if(t>1,1e9*(t-1),0.1*t)",
     "Boundary/left/Displacement=if(t>1,1e9*(t-1),0.1*t)"),
    ("Boundary/left/Displacement", ("Time/End time=1",),
     "Boundary/left/Displacement=if(t<0.5,0,1)",
     "Boundary/left/Displacement=if(t<0.5,0,t-0.5)"),
    ("Boundary/left/Displacement", FIXED + ("Time/End time=1",),
     "Boundary/left/Displacement=if(t<0.5,0,1)",
     "Boundary/left/Displacement=if(t<0.5,0,t-0.5)"),
    # a pulse of T/2.6e5 between times of a file in SI units
    ("Boundary/left/Displacement", FIXED + ("Time/End time=1",),
     "Boundary/left/Displacement="
     "if((2592120*t)>777000.3,if((2592120*t)<777010.3,1,0),0)",
     "Boundary/left/Displacement="
     "if((2592120*t)>777000.3,if((2592120*t)<777010.3,0,0),0)"),
    # the same where milliseconds, quotients and differences stand beside the factor
    *[("Boundary/left/Displacement", FIXED + ("Time/End time=1",),
       f"Boundary/left/Displacement={first}*{second}*1e-9",
       f"Boundary/left/Displacement={first}*{second}*0") for first, second in (
           ("if((2592120*t)*1000>777000300,1,0)", "if((2592120*t)*1000-777010300<0,1,0)"),
           ("max(0,sign((t*2592120)/60-12950.005))", "max(0,sign(12950.1716-t*43202))"))],
    # the same beside 210 zeros of t + n before the start
    *[("Boundary/left/Displacement", FIXED + ("Time/End time=1",),
       *(f"Boundary/left/Displacement={zeros}+if(t>0.30000031,if(t<0.30000052,"
         f"{height},0),0)" for height in (1, 0)))
      for zeros in ("+".join(f"0*max(0,t+{n})" for n in range(1, 211)),)],
    ("Boundary/left/Displacement", (), "Boundary/left/Displacement=0.01*sqrt(t)",
     "Boundary/left/Displacement=0.01*t^1.5",
     ("Boundary/left/Displacement=0.01*sin(2*pi*3140*t)", "Time/End time=3600")),
    ("Boundary/left/Displacement", (),
     "Boundary/left/Displacement=0.01*if(t>0,t*log(t),0)",
     "Boundary/left/Displacement=0.01*if(t>0,t^2*log(t),0)"),
    ("Boundary/left/Displacement", ("Time/End time=2",),
     "Boundary/left/Displacement=t/(t-1.1)",
     "Boundary/left/Displacement=t/(t+1.1)"),
    ("Boundary/left/Displacement", CONSERVING, "Boundary/left/Displacement=t^2",
     ("Boundary/left/Displacement=t^2", "Time/Scheme=sdirk2"),
     "Boundary/left/Temperature=t^2"),
    ("Boundary/left/Displacement", EULER + ("Time/Start=paper",),
     "Boundary/left/Displacement=t^2",
     ("Boundary/left/Displacement=t^2", "Time/Start=automatic"),
     "Boundary/left/Temperature=t^2"),
    # units of results
    ("Scales/Time", (), "Scales/Length=2", SCALES),
    ("Scales/Temperature", (), SCALES[:-2], SCALES[:-2] + ("Model/Fields=displacement",)),
    ("Scales/Area", SCALES, "Scales/Area=0", "Scales/Area=1e-9"),
    # times of steps
    ("Time/Break points", (), "Time/Break points=0.5;-1", "Time/Break points=0.5;1"),
    ("Time/Break points", (), "Time/Break points=0.5,1", "Time/Break points=0.5",
     "Time/Break points= 0 ; 0.5 "),
    # (1 + dimension) x nodes of two fields, at most 1e9. The nearest ones that
    # are allowed would not fit into the memory of a test.
    ("Mesh/Cells", ("Mesh/Degree=25", "Mesh/Refinements=1"),
     "Mesh/Cells=10000000", "Mesh/Cells=10"),  # 2 (5e8 + 1)
    ("Mesh/Cells", PLANE + ("Mesh/Degree=1", "Mesh/Cells across=333"),
     "Mesh/Cells=1000000", "Mesh/Cells=10"),  # 3 x 1000001 x 334
    ("Mesh/Cells", ("Dimension=3", "Mesh/Degree=1", "Mesh/Cells=62"),
     "Mesh/Cells across=2000", "Mesh/Cells across=2"),  # 4 x 63 x 2001^2
    # a mass that moves to other nodes needs one
    ("Mesh/Cells", MASSLESS + ("Mesh/Degree=1",), "Mesh/Cells=1",
     "Mesh/Cells=2"),
    ("Mesh/Cells", MASSLESS + ("Mesh/Cells=1",), "Mesh/Degree=1",
     "Mesh/Degree=2", ("Mesh/Degree=1", "Mesh/Refinements=1"),
     ("Mesh/Degree=1", "Contact/Massless nodes=off"),
     ("Mesh/Degree=1", "Contact/Massless nodes=automatic")),
    ("Mesh/Cells", CONSERVING + ("Mesh/Degree=1",), "Mesh/Cells=1",
     "Mesh/Cells=2", ("Mesh/Cells=1", "Contact/Condition=none"),
     ("Mesh/Cells=1", "Time/Scheme=sdirk2")),

    # a round rod has points without weight; a body needs a support; the shape
    # of an obstacle has a y, and is finite at the contact nodes
    ("Mesh/Mass matrix", ("Dimension=2", "Mesh/Geometry=axisymmetric"),
     "Mesh/Mass matrix=lumped", "Mesh/Mass matrix=consistent",
     ("Mesh/Mass matrix=lumped", "Mesh/Geometry=plane strain")),
    # without dispersion: for waves in a rod of equal linear cells
    ("Time/Scheme", BOX + WAVES, "Dimension=2", "Dimension=1",
     ("Dimension=2", "Time/Scheme=energy conserving")),
    ("Time/Scheme", BOX + ("Mesh/Degree=1",), "Model/Fields=temperature",
     "Model/Fields=displacement"),
    ("Time/Scheme", BOX + WAVES, "Model/Inertia=0", "Model/Inertia=1e-6"),
    ("Time/Scheme", BOX + ("Model/Viscosity=0",), "Mesh/Degree=2", "Mesh/Degree=1",
     ("Mesh/Degree=2", "Time/Scheme=energy conserving")),
    ("Time/Scheme", BOX + WAVES, "Mesh/Grading=1.001", "Mesh/Grading=1"),
    ("Time/Scheme", BOX + WAVES, "Contact/Massless nodes=on",
     "Contact/Massless nodes=automatic", "Contact/Massless nodes=off"),
    ("Time/Scheme", BOX + WAVES, "Mesh/Mass matrix=lumped",
     "Mesh/Mass matrix=consistent", ("Mesh/Mass matrix=lumped", "Time/Scheme=sdirk4")),
    ("Time/Step size", WAVES + ("Time/Scheme=energy conserving",), "Time/Step size=automatic",
     "Time/Step size=0.01"),
    ("Time/Locate contact events", BOX + WAVES, "Time/Locate contact events=true",
     "Time/Locate contact events=false", POWER, "Contact/Damping=1",
     "Model/Viscosity=0.1", "Boundary/left/Displacement=t^2", EXCHANGE),
    ("Sources/Body force", PLANE + QUASI_STATIC + (
        "Boundary/sides/Support=free", "Boundary/left/Support=sliding"),
     "Sources/Body force=0; 0.1", "Sources/Body force=0.1; 0",
     ("Sources/Body force=0; 0.1", "Boundary/left/Support=clamped"),
     ("Sources/Body force=0; 0.1", "Boundary/sides/Support=rollers"),
     ("Sources/Body force=0; 0.1", "Boundary/sides/Support=symmetric"),
     ("Sources/Body force=0; 0.1", "Mesh/Geometry=axisymmetric"),
     ("Sources/Body force=0; 0.1", "Model/Inertia=1e-3")),
    ("Boundary/left/Spring", FREE + PLANE, "Boundary/left/Spring=1", "Boundary/left/Spring=0"),
    ("Boundary/right/Mass", QUASI_STATIC, "Boundary/right/Mass=1", "Boundary/right/Mass=0",
     ("Boundary/right/Mass=1", "Model/Inertia=1e-3")),
    ("Boundary/left/Dashpot", QUASI_STATIC + FREE + (
        "Model/Viscosity=0", "Boundary/left/Spring=1"),
     "Boundary/left/Dashpot=1", "Boundary/left/Dashpot=0",
     ("Boundary/left/Dashpot=1", "Model/Viscosity=0.1")),
    ("Boundary/right/Spring", ITERATION, "Boundary/right/Spring=1", "Boundary/right/Spring=0"),
    *[("Time/Scheme", BOX + WAVES, f"Boundary/right/{what}=1",
       f"Boundary/right/{what}=0", (f"Boundary/right/{what}=1", "Time/Scheme=sdirk4"))
      for what in ("Spring", "Dashpot", "Mass")],
    ("Time/Scheme", BOX + WAVES + FREE, "Boundary/left/Mass=1", "Boundary/left/Mass=0",
     "Boundary/left/Spring=1", "Boundary/left/Dashpot=1"),
    *[("Contact/Massless nodes", (f"Boundary/right/{what}=1",), "Contact/Massless nodes=on",
       "Contact/Massless nodes=off", "Contact/Massless nodes=automatic")
      for what in ("Mass", "Dashpot")],
    *[(f"Boundary/right/{what}", CONSERVING, f"Boundary/right/{what}=1",
       f"Boundary/right/{what}=0", "Boundary/right/Spring=1",
       (f"Boundary/right/{what}=1", "Contact/Condition=none"),
       FREE + (f"Boundary/left/{what}=1",)) for what in ("Mass", "Dashpot")],
    # a spring of the same size
    ("Boundary/right/Mass", CONSERVING + ("Boundary/right/Spring=1",), "Boundary/right/Mass=1",
     "Boundary/right/Mass=0"),
    ("Boundary/left/Support", QUASI_STATIC, *FREE, "Boundary/left/Support=clamped",
     FREE + ("Boundary/left/Dashpot=1",), FREE + ("Boundary/right/Dashpot=1",)),
    ("Boundary/left/Support", QUASI_STATIC + PLANE, *FREE, "Boundary/left/Support=clamped"),
    ("Boundary/left/Support", QUASI_STATIC + ("Model/Viscosity=0",), *FREE,
     "Boundary/left/Support=clamped",
     FREE + ("Boundary/left/Spring=1",), FREE + ("Boundary/right/Spring=1",)),
    ("Boundary/left/Support", ITERATION, *FREE, "Boundary/left/Support=clamped"),
    ("Boundary/sides/Heat exchange", PLANE + ("Boundary/sides/Support=symmetric",),
     "Boundary/sides/Heat exchange=2", "Boundary/sides/Heat exchange=0",
     ("Boundary/sides/Heat exchange=2", "Boundary/sides/Support=free")),
    ("Mesh/Grading across", PLANE, "Mesh/Grading across=0",
     "Mesh/Grading across=1e-3"),
    ("Contact/Gap", (), "Contact/Gap=0.1+y", "Contact/Gap=0.1+0.1",
     ("Contact/Gap=0.1+y", "Dimension=2", "Mesh/Cells=1")),
    ("Contact/Gap", PLANE, "Contact/Gap=0.1+radius", "Contact/Gap=0.1+y"),
    ("Contact/Gap", PLANE, "Contact/Gap=0.1/(y-1)", "Contact/Gap=0.1/(1.1-y)"),
    # an infinite velocity in the middle of the end
    ("Contact/Gap", PLANE, "Contact/Gap=1.1+sqrt(t)*(y-1)", "Contact/Gap=1.1+t*(y-1)"),
    # or in a thirty-second at its edge
    *[("Contact/Gap", ("Dimension=3", "Mesh/Width=1", "Mesh/Cells=1"),
       f"Contact/Gap=1+if({place},sqrt(t),t)", f"Contact/Gap=1+if({place},2*t,t)")
      for place in ("y<0.04", "y>0.96", "z<0.04", "z>0.96")],
    ("Contact/Gap", ("Dimension=3", "Mesh/Width=1", "Mesh/Cells=1"),
     "Contact/Gap=0.1/(z-1)", "Contact/Gap=0.1/(1.1-z)"),
    ("Contact/Gap", PLANE + RIGID, "Contact/Gap=y-0.5", "Contact/Gap=abs(y-0.5)",
     ("Contact/Gap=y-0.5", "Contact/Condition=normal compliance")),

    # steps
    ("Time/Step size", ("Time/Scheme=backward euler",), "Time/Step size=automatic",
     "Time/Step size=0.01", "Time/Scheme=sdirk4"),
    ("Time/Step size", ("Time/Scheme=energy conserving",),
     "Time/Step size=automatic", "Time/Step size=0.01", "Time/Scheme=sdirk4"),
    ("Time/Step size", (), "Time/Step size=0", "Time/Step size=1e-6"),
    ("Time/Step size", ("Time/Step size=1e-3", "Output/Fields interval=0"),
     "Time/End time=1000001", "Time/End time=1000"),
    ("Time/First step size", (), "Time/First step size=0",
     "Time/First step size=1e-9"),
    ("Time/First step size", ("Time/Minimum step size=1e-4",),
     "Time/First step size=0.99999e-4", "Time/First step size=1e-4",
     "Time/First step size=automatic"),
    ("Time/Maximum step size", (), "Time/Maximum step size=0",
     "Time/Maximum step size=1e-3"),
    ("Time/Maximum step size", ("Time/Minimum step size=1e-4",),
     "Time/Maximum step size=0.99999e-4", "Time/Maximum step size=1e-4"),

    # scheme and start
    ("Time/Start", FIXED + ("Time/Start=paper",), "Time/Scheme=sdirk4",
     "Time/Scheme=backward euler"),
    ("Time/Start", EULER + QUASI_STATIC, "Time/Start=paper",
     "Time/Start=automatic", ("Time/Start=paper", "Model/Inertia=1e-3")),
    ("Time/Start", EULER + ("Time/Start=paper",), "Contact/Massless nodes=on",
     "Contact/Massless nodes=off", "Contact/Massless nodes=automatic"),
    ("Time/Scheme", CONSERVING + QUASI_STATIC, "Model/Inertia=0",
     "Model/Inertia=1e-6", "Time/Scheme=sdirk4"),
    ("Contact/Massless nodes", CONSERVING, "Contact/Massless nodes=off",
     "Contact/Massless nodes=on", "Contact/Massless nodes=automatic",
     ("Contact/Massless nodes=off", "Time/Scheme=sdirk4")),
    ("Time/Locate contact events", CONSERVING, "Time/Locate contact events=true",
     "Time/Locate contact events=false",
     ("Time/Locate contact events=true", "Time/Scheme=sdirk4")),

    # the iteration of the paper
    ("Solver/Step solver", FIXED + ("Solver/Step solver=fixed point",),
     "Time/Scheme=sdirk4", "Time/Scheme=backward euler"),
    ("Solver/Step solver", ITERATION, "Contact/Condition=rigid",
     "Contact/Condition=normal compliance"),
    ("Solver/Step solver", ITERATION, "Model/Inertia=0",
     "Model/Inertia=1e-3"),
    ("Solver/Step solver", ITERATION, "Model/Fields=displacement",
     "Model/Fields=temperature and displacement"),
    ("Time/Locate contact events", ITERATION, "Time/Locate contact events=true",
     "Time/Locate contact events=false",
     ("Time/Locate contact events=true", "Solver/Step solver=monolithic")),

    # the iterative solver: no matrix is there that others could use
    ("Solver/Linear solver", ("Solver/Linear solver=iterative",), "Dimension=1",
     "Dimension=2", ("Dimension=3", "Mesh/Cells=2", "Mesh/Cells across=2"),
     PLANE + CONSERVING, PLANE + ITERATION, PLANE + EULER + ("Time/Start=paper",),
     PLANE + FIXED + POWER + LOSS + EXCHANGE + ("Contact/Damping=0.5",),
     PLANE + FIXED + RIGID + ("Contact/Massless nodes=off",),
     ("Dimension=1", "Solver/Linear solver=automatic"),
     ("Dimension=1", "Solver/Linear solver=direct")),
    ("Solver/Linear tolerance", ITERATIVE, "Solver/Linear tolerance=0",
     "Solver/Linear tolerance=1e-12", "Solver/Linear tolerance=automatic"),
    ("Solver/Linear tolerance", ITERATIVE, "Solver/Linear tolerance=9.9e-15",
     "Solver/Linear tolerance=1e-14"),
    ("Solver/Linear tolerance", ITERATIVE, "Solver/Linear tolerance=0.01",
     "Solver/Linear tolerance=0.0099"),
    ("Solver/Linear tolerance", ITERATIVE, "Solver/Linear tolerance=-1e-9",
     "Solver/Linear tolerance=1e-9"),

    # heat exchange by an expression: not negative and finite for gaps up to 1 or that
    # of the undeformed body, and pressures up to 1; of a body that meets an obstacle
    ("Boundary/right/Heat exchange", (), "Boundary/right/Heat exchange=-1",
     "Boundary/right/Heat exchange=0"),
    ("Boundary/right/Heat exchange", (), "Boundary/right/Heat exchange=1-1.001*gap",
     "Boundary/right/Heat exchange=1-gap"),
    ("Boundary/right/Heat exchange", ("Boundary/right/Heat exchange=2-gap",),
     "Contact/Gap=2.001", "Contact/Gap=2"),
    ("Boundary/right/Heat exchange", (), "Boundary/right/Heat exchange=1-1.001*pressure",
     "Boundary/right/Heat exchange=1-pressure"),
    # at both temperatures, theta_A = 10 of the fixed end and that of the obstacle
    *[("Boundary/right/Heat exchange", ("Initial values/Temperature=10", "Boundary/left/Temperature=10", "Boundary/right/Surroundings=20"),
       f"Boundary/right/Heat exchange={refused}", f"Boundary/right/Heat exchange={accepted}")
      for refused, accepted in (("theta-11", "theta-9"), ("19-theta", "21-theta"))],
    ("Boundary/right/Heat exchange", (), "Boundary/right/Heat exchange=1/gap",
     "Boundary/right/Heat exchange=1/(1e-6+gap)"),
    ("Boundary/right/Heat exchange", (), "Boundary/right/Heat exchange=1/(pressure-0.5)^2",
     "Boundary/right/Heat exchange=1/(1+pressure)"),
    ("Boundary/right/Heat exchange", (), "Boundary/right/Heat exchange=gap*x",
     "Boundary/right/Heat exchange=gap*pi"),
    ("Boundary/right/Heat exchange", (), "Boundary/right/Heat exchange=gap; pressure",
     "Boundary/right/Heat exchange=gap + pressure"),
    ("Boundary/right/Heat exchange", EXCHANGE, "Contact/Condition=none",
     "Contact/Condition=rigid"),
    ("Boundary/right/Heat exchange", EXCHANGE, "Model/Fields=temperature",
     ("Model/Fields=temperature", "Boundary/right/Heat exchange=2")),
    ("Boundary/right/Heat exchange", FIXED + EXCHANGE, "Time/Scheme=energy conserving",
     "Time/Scheme=sdirk2"),
    ("Time/Start", EULER + EXCHANGE, "Time/Start=paper", "Time/Start=automatic",
     ("Time/Start=paper", "Boundary/right/Heat exchange=1")),
    ("Solver/Step solver", ITERATION, EXCHANGE[0], "Boundary/right/Heat exchange=1+1"),

    # probes: in the body, edges included
    ("Output/Probes", (), "Output/Probes=1.0000001", "Output/Probes=1"),
    ("Output/Probes", (), "Output/Probes=-1e-9", "Output/Probes=0"),
    ("Output/Probes", (), "Output/Probes=0.5, 0", "Output/Probes=0.5; 0"),
    ("Output/Probes", PLANE, "Output/Probes=0.5", "Output/Probes=0.5, 0"),
    ("Output/Probes", NARROW, "Output/Probes=0.5, 0.3000001",
     "Output/Probes=0.5, 0.3", "Output/Probes=1, 0.3"),
    ("Output/Probes", NARROW, "Output/Probes=0.5, -1e-9",
     "Output/Probes=0.5, 0"),
    ("Output/Probes", (), "Output/Probes=0.5 m", "Output/Probes=0.5"),
    ("Output/Probes", (), "Output/Probes=0.5;", "Output/Probes=0.5"),

    # expressions
    ("Sources/Heat source", (), "Sources/Heat source=", "Sources/Heat source=0"),
    ("Sources/Heat source", (), "Sources/Heat source=0,5",
     "Sources/Heat source=0.5", "Sources/Heat source=max(0,5)"),
    ("Sources/Heat source", (), "Sources/Heat source=if(x=0.5, 1, 0)",
     "Sources/Heat source=if(x==0.5, 1, 0)", "Sources/Heat source=if(x<=0.5, 1, 0)"),
    ("Sources/Heat source", (), "Sources/Heat source=rand()",
     "Sources/Heat source=rint(3)"),
    ("Sources/Heat source", (), "Sources/Heat source=1/x",
     "Sources/Heat source=1/(x+1e-9)"),
    ("Sources/Heat source", (), "Sources/Heat source=1/t",
     "Sources/Heat source=1/(t+1e-9)"),
    ("Sources/Heat source", (), "Sources/Heat source=x*y", "Sources/Heat source=x*t"),
    ("Initial values/Velocity", (), "Initial values/Velocity=x*t",
     "Initial values/Velocity=x*pi"),
    ("Initial values/Velocity", (), "Initial values/Velocity=x; x",
     "Initial values/Velocity=x"),
    ("Initial values/Velocity", PLANE, "Initial values/Velocity=x; 0; 0",
     "Initial values/Velocity=x", "Initial values/Velocity=x; 0"),

    # studies
    ("Output/Error bars", STUDY, "Output/Error bars=true", "Output/Error bars=false"),
    ("Study/Vary", (), "Study/Vary=Time/Tolerance 1e-4",
     "Study/Vary=Time/Tolerance = 1e-4"),
    ("Study/Vary", (), "Study/Vary=Mesh/Cells = 4; Mesh/Cells = 8",
     "Study/Vary=Mesh/Cells = 4 | 8"),
    ("Study/Vary", (), MANY + HUNDRED + " ; Mesh/Degree = " + " | ".join(
        map(str, range(2, 13))), MANY + "0.1 | 0.2"),
    ("Study/Vary", (), "Study/Vary=Time/Scheme = sdirk4 | sdirk2 | backward "
     "euler ; Contact/Gap = 0.1 | 0.2", "Study/Vary=Time/Scheme = sdirk4"),
    ("Study/Target error", STUDY + ("Study/Target error=1e-3",),
     "Study/Reference=none", "Study/Reference=Time/Tolerance = 1e-9"),
    ("Study/Reference", STUDY, "Study/Reference=Mesh/Cells = 8 | 16",
     "Study/Reference=Mesh/Cells = 8"),
    ("Study/Reference", STUDY, "Study/Reference=Mesh/Cells = 8; Mesh/Cells = 16",
     "Study/Reference=Mesh/Cells = 8"),
    ("Study/Reference", STUDY, "Study/Reference=Mesh/Width = 2",
     ("Study/Reference=Mesh/Width = 2", "Dimension=2")),
    ("Study/Reference", STUDY, "Study/Reference=Time/End time = 9.99",
     "Study/Reference=Time/End time = 10"),

    # initial values: fixed at x = 0, not in a rigid obstacle
    ("Initial values/Velocity", (), "Initial values/Velocity=1e-3+x",
     "Initial values/Velocity=x"),
    ("Initial values/Displacement", (), "Initial values/Displacement=1e-3-x",
     "Initial values/Displacement=-x"),
    ("Contact/Gap", RIGID, "Initial values/Displacement=0.1001*x",
     "Initial values/Displacement=0.0999*x", "Initial values/Displacement=0.1*x",
     ("Initial values/Displacement=0.1001*x",
      "Contact/Condition=normal compliance")),
    ("Contact/Gap", EULER + RIGID, "Initial values/Velocity=10.01*x",
     "Initial values/Velocity=9.99*x",
     ("Initial values/Velocity=10.01*x", "Time/Start=consistent")),
    ("Initial values", FIXED, "Initial values/Velocity=1e200*x",
     "Initial values/Velocity=1e100*x"),
]


# What --check says of scenes, and does not say of their neighbours: the first step is that of
# the paper where nothing forbids it; a contact has a law of its own; a body of which all depends on x
# alone is a rod.
SAID = [
    (", start of the paper", EULER,
     ("Boundary/right/Traction=1", "Contact/Massless nodes=off", "Time/Start=paper"),
     ("Contact/Massless nodes=on", "Contact/Gap=0.1+t", "Boundary/left/Displacement=t^2",
      "Model/Inertia=0", EXCHANGE[0], "Time/Scheme=sdirk2", "Time/Start=consistent")),
    (", a b elastic obstacle, epsilon = 0.5", ("Bodies/a/Length=1", "Bodies/b/Length=1"),
     ("Contacts/a b/Compliance=0.5",), ("Contacts/a b/Gap=0.5", "Contact/Compliance=0.5")),
    ("Dimension = 1 has the same solution", BLOCK + ("Mesh/Cells=1",),
     ("Initial values/Velocity=x", "Sources/Body force=x; 0; 0", "Sources/Heat source=x*t"),
     ("Initial values/Velocity=x*y", "Initial values/Displacement=x*z", "Sources/Heat source=z",
      "Initial values/Temperature=10-x*y", "Initial values/Velocity=x; 0; x", "Contact/Gap=1+y",
      "Sources/Body force=0; 1; 0", "Boundary/sides/Support=free", LOSS[0])),
]


def overrides(settings):
    return (settings,) if isinstance(settings, str) else settings


REMEDY = re.compile(r"remedy:  ((?:[A-Z]\w*/[A-Z][\w ]*|Dimension)) = (.+?)(?:[:,;\n]| or | for |$)", re.M)
TOO_LARGE = ("Time/Maximum step size=1e-9",)


def begins_with(message, entry):
    """The entry as in "Mesh/Cells = 8" or "Contact/Gap: ...", not as in
    "Mesh/Cells across = 8", perhaps behind the file that it stands in."""
    return re.match(rf"(\S+\.prm:\d+: )?{re.escape(entry)}( = |:)", message)


def has_value(message, scene, entry):
    """Numbers and words are told as they were given, and not as what is allowed."""
    given = next((o.partition("=")[2] for o in reversed(scene) if o.startswith(entry + "=")), "")
    told = re.match(rf"{re.escape(entry)} = (.*)$", message, re.MULTILINE)
    if not told or re.fullmatch("[a-z ]+", given):
        return not told or told[1].startswith(given) and f"allowed: {told[1]}," not in message
    numbers = [re.fullmatch(r"[-+]?[.\d]+(e-?\d+)?", text) for text in (given, told[1])]
    return not all(numbers) or float(numbers[0][0]) == float(numbers[1][0])


def default_values():
    """Of the entries, by their paths."""
    page = run("--print-parameters=markdown")[1]
    section, values = "", {}
    for line in page.splitlines():
        if line.startswith("## "):
            section = "" if line == "## General" else line[3:] + "/"
        elif match := re.match(r"\| `([^`]+)` \| `([^`]*)` \|", line):
            values[section + match[1]] = match[2]
    return values


def has_reason(message, scene, defaults):
    """An entry that is the reason of a refusal is told as it was given, or with its default;
    None if the message names no such entry. Automatic values are the program's."""
    told = re.search(r", since ((?:[A-Z][\w ]*/)*[\w/' ]+) = (.*)$", message, re.MULTILINE)
    if not told:
        return None
    given = next((o.partition("=")[2] for o in reversed(scene) if o.startswith(told[1] + "=")),
                 defaults.get(told[1], "automatic"))
    if given in ("automatic", ""):
        return None
    number = re.compile(r"[-+]?[.\d]+(e[-+]?\d+)?(?![\w.])")
    if is_given := number.fullmatch(given):
        is_told = number.match(told[2])
        return is_told is not None and float(is_told[0]) == float(is_given[0])
    return re.match(re.escape(given) + r"(?!\w)", told[2].lstrip('"')) is not None


def main():
    asked, defaults = [], default_values()
    for entry, shared, refused, *accepted in SCENES + CONTACT_SCENES + BODY_SCENES + ROW_SCENES:
        asked.append((entry, shared + overrides(refused), 2))
        asked += [(entry, shared + overrides(neighbour), 0)
                  for neighbour in accepted]
    # 1e10 steps are terabytes: a refusal of the run, which names no entry first
    answers = check_all([scene for _, scene, _ in asked] + [TOO_LARGE])
    Path("defaults.prm").write_text("# defaults\n")
    forced = run("--check", *settings(TOO_LARGE), "defaults.prm", "--force")[0]
    if answers[TOO_LARGE][0] != 2 or forced != 0:
        print("a run of terabytes:", answers[TOO_LARGE], "forced", forced)
    faults = []
    for entry, scene, expected in asked:
        status, message = answers[scene]
        if status != expected or (expected == 2 and not (
                begins_with(message, entry) and has_value(message, scene, entry)
                and has_reason(message, scene, defaults) is not False)):
            faults.append(f"{' '.join(scene)}: status {status} {message[:90]!r},"
                          f" expected {expected} for {entry}")
    print("refused with the entry named and accepted beside it:",
          "; ".join(faults) or "all")
    n_reasons = sum(has_reason(answers[scene][1], scene, defaults) is True
                    for _, scene, expected in asked if expected == 2)
    print("with another entry as the reason, told as given: more than 80", n_reasons > 80,
          *([n_reasons] if n_reasons <= 80 else []))

    screens = [(words, change, change in these, run(
        "--check", *settings(shared + (change,)), "defaults.prm")[1])
        for words, shared, these, others in SAID for change in these + others]
    print("said where it is so:", [change for words, change, is_so, screen in screens
                                   if (words in screen) != is_so or not screen] or "all")

    # a value that a message recommends is no reason for the same message
    remedied = {}
    for scene, (status, message) in answers.items():
        if found := REMEDY.search(message):
            remedied[scene] = scene + (f"{found[1]}={found[2]}",)
    again = check_all(remedied.values())
    print("refused with the remedy, too:", "; ".join(
        f"{' '.join(scene)}: {answers[scene][1][:90]!r}" for scene, other in remedied.items()
        if again[other][0] != 0) or "none", "of about fifty" if len(remedied) > 40 else "of few")

    # other tests hold the messages about commands, files and rods in SI units
    messages = [message for status, message in answers.values() if status == 2]
    messages += [part for path in sorted(Path(__file__).parents[1].glob("*/*.output"))
                 for part in path.read_text().split("\n$ ")]
    print("refusals in the sources that no test meets:",
          "; ".join(unmet_refusals(messages)) or "none")


main()
