# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes of two stops that no run can have, as check_refusals.py has them: the entry at
fault, what the scenes share, what is refused, its accepted neighbours."""

FIXED = ("Time/Step size=0.01",)
EULER = FIXED + ("Time/Scheme=backward euler",)
REAR = "Contact/Rear gap"
STOP = (REAR + "=0.2",)
RIGID = ("Contact/Condition=rigid",)

SCENES = [
    (REAR, (), REAR + "=0", REAR + "=1e-9", REAR + "=none"),
    (REAR, (), REAR + "=-0.1", REAR + "=0.1"),
    # the stops overlap; a preload by one of them does not
    (REAR, STOP, "Contact/Gap=-0.2", "Contact/Gap=-0.1999"),
    (REAR, STOP, ("Dimension=2", "Mesh/Cells=1"), "Dimension=1",
     ("Dimension=2", "Mesh/Cells=1", REAR + "=none")),
    # rigid stops: where the end starts, and where the paper's first step leaves it
    (REAR, STOP + RIGID, "Initial values/Displacement=-0.2001*x",
     "Initial values/Displacement=-0.1999*x", "Initial values/Displacement=-0.2*x",
     ("Initial values/Displacement=-0.2001*x", "Contact/Condition=power law"),
     ("Initial values/Displacement=-0.2001*x", REAR + "=none")),
    (REAR, STOP + RIGID + EULER, "Initial values/Velocity=-20.01*x",
     "Initial values/Velocity=-19.99*x",
     ("Initial values/Velocity=-20.01*x", "Time/Start=consistent")),
    (REAR, STOP, "Model/Inertia=0", "Model/Inertia=1e-6",
     ("Model/Inertia=0", REAR + "=none")),
    (REAR, FIXED, STOP + ("Time/Scheme=energy conserving",), STOP + ("Time/Scheme=sdirk2",),
     "Time/Scheme=energy conserving"),
    (REAR, STOP, "Contact/Massless nodes=on", "Contact/Massless nodes=off",
     ("Contact/Massless nodes=automatic", "Model/Viscosity=0")),
    (REAR, EULER, STOP + ("Solver/Step solver=fixed point",), STOP,
     "Solver/Step solver=fixed point"),
    (REAR, STOP, "Boundary/Heat exchange=1+gap", "Boundary/Heat exchange=2",
     ("Boundary/Heat exchange=1+gap", REAR + "=none")),
]
