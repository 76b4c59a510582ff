# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes of two stops, and of obstacles that move, that no run can have, as check_refusals.py has them: the entry at
fault, what the scenes share, what is refused, its accepted neighbours."""

FIXED = ("Time/Step size=0.01",)
EULER = FIXED + ("Time/Scheme=backward euler",)
REAR = "Contact/Rear gap"
GAP = "Contact/Gap"
STOP = (REAR + "=0.2",)
RIGID = ("Contact/Condition=rigid",)

SCENES = [
    (REAR, (), REAR + "=-0.1", REAR + "=0.1", REAR + "=0", REAR + "=none"),
    # the stops overlap; a preload by one of them does not
    (REAR, STOP, "Contact/Gap=-0.2", "Contact/Gap=-0.1999"),
    (REAR, STOP + ("Dimension=2", "Mesh/Cells=1"), GAP + "=y-0.3", GAP + "=y-0.19",
     (GAP + "=y-0.3", REAR + "=none")),
    # rigid stops: where the end starts, and where the paper's first step leaves it
    (REAR, STOP + RIGID, "Initial values/Displacement=-0.2001*x",
     "Initial values/Displacement=-0.1999*x", "Initial values/Displacement=-0.2*x",
     ("Initial values/Displacement=-0.2001*x", "Contact/Condition=power law"),
     ("Initial values/Displacement=-0.2001*x", REAR + "=none")),
    (REAR, STOP + RIGID + EULER, "Initial values/Velocity=-20.01*x",
     "Initial values/Velocity=-19.99*x",
     ("Initial values/Velocity=-20.01*x", "Time/Start=consistent")),
    # an obstacle that moves: not by jumps, with a velocity, and finite
    (GAP, (), GAP + "=0.1*sin(t", GAP + "=0.1*sin(t)"),
    (GAP, (), GAP + "=0.1+y*t", GAP + "=0.1+t",
     (GAP + "=0.1+y*t", "Dimension=2", "Mesh/Cells=1")),
    (GAP, ("Dimension=2", "Mesh/Cells=1"), GAP + "=0.1+z*t", GAP + "=0.1+y*t"),
    (GAP, ("Time/End time=1",), GAP + "=if(t<0.5,0.1,0.2)",
     GAP + "=if(t<0.5,0.1,t-0.4)", (GAP + "=if(t<0.5,0.1,0.2)", "Time/End time=0.4"),
     GAP + "=2.27e4+0.00204*sin(0.00136*t)^2"),  # moves from number to number
    (GAP, ("Time/End time=1", "Dimension=2", "Mesh/Cells=1"), GAP + "=if(t<0.5,y,y+1)",
     GAP + "=if(t<0.5,y,y+t-0.5)"),
    (GAP, ("Time/End time=2",), GAP + "=0.1+t/(t-1.1)", GAP + "=0.1+t/(t+1.1)"),
    (GAP, (), GAP + "=0.1*t/0", GAP + "=0.1*t/1"),
    (GAP, (), GAP + "=0.1+0.1*sqrt(t)", GAP + "=0.1+0.1*t^1.5"),
    # a velocity without a limit at one side of the end alone, or but in its middle
    (GAP, ("Dimension=2", "Mesh/Cells=1"), GAP + "=0.1+if(y>0.09,0.1*sqrt(t),t)",
     GAP + "=0.1+if(y>0.09,0.1*t^1.5,t)"),
    (GAP, ("Dimension=2", "Mesh/Cells=1"), GAP + "=0.1+sqrt(t)*(y-0.05)",
     GAP + "=0.1+t^1.5*(y-0.05)"),
    (GAP, (), GAP + "=0.1+t*rand_seed(1)", GAP + "=0.1+t*0.5"),
    (GAP, EULER + ("Time/Start=paper",), GAP + "=0.1+t", GAP + "=0.1",
     (GAP + "=0.1+t", "Time/Start=automatic")),
    (GAP, RIGID, GAP + "=t-0.001", GAP + "=t",
     (GAP + "=t-0.001", "Contact/Condition=normal compliance")),
]
