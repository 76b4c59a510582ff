# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes drawn at random over the ranges of doc/stability.md: all laws, drives, schemes and
bodies, half of the values where the scene moves and half anywhere in their range."""
import random


class WideScene(dict):
    """The overrides of the default scene by their entries."""

    def __init__(self, seed):
        super().__init__(Title=f"Wide scene {seed}")
        self.r = random.Random(f"wide {seed}")
        self.is_plane = self.happens(0.2)
        fields = self.pick("temperature and displacement", "temperature and displacement",
                           "temperature and displacement", "displacement", "temperature")
        self["Model/Fields"] = fields
        self.heat, self.moves = "temperature" in fields, "displacement" in fields
        self.draw_mesh()
        self.draw_times()
        if self.moves:
            self.draw_motion()
            self.draw_obstacle()
        if self.heat:
            self.draw_heat()
        one_node = self["Mesh/Cells"] == self["Mesh/Degree"] == 1
        if self.get("Model/Inertia") and not one_node and self.happens(0.2) and (
                self["Model/Viscosity"] or "Contact/Damping" not in self) and (
                "Contact/Dashpot" not in self):
            self["Contact/Massless nodes"] = "on"
        if seed % 5 == 2 and self.get("Model/Inertia") and not self.is_plane:
            self.take_box()
        self.r = random.Random(f"ends {seed}")
        if self.get("Model/Inertia") and self.happens(0.3):
            self.draw_ends()

    def draw_ends(self):
        """What a scheme can have; the body's own mass is b."""
        conserves, is_box = (self.get("Time/Scheme") == name for name in (
            "energy conserving", "box"))
        if self.happens(0.7):
            self["Boundary/left/Support"] = "free"
            self.pop("Boundary/left/Displacement", None)
        if self.is_plane:
            return
        b = self["Model/Inertia"]
        sizes = {"Spring": 1., "Dashpot": b**0.5, "Mass": b}
        for end in ("left", "right"):
            for what, size in sizes.items():
                is_there = "Boundary/left/Support" in self if end == "left" else not is_box
                if what != "Spring" and end == "right":
                    is_there &= not conserves and self.get("Contact/Massless nodes") != "on"
                if is_there and not (is_box and what == "Mass") and self.happens(0.3):
                    self[f"Boundary/{end}/{what}"] = float(
                        f"{size * self.number(1e-2, 10, 1e-6, 1e6):.3g}")

    def take_box(self):
        """Waves pass a cell in a step: as many cells as make steps about as long."""
        wave = self["Model/Inertia"]**0.5
        n = min(400, max(1, round(15 * wave / self.duration)))
        for entry in ("Mesh/Grading", "Contact/Massless nodes", "Time/Tolerance"):
            self.pop(entry, None)
        self |= {"Time/Scheme": "box", "Mesh/Degree": 1, "Mesh/Cells": n,
                 "Time/Step size": repr(wave / n), "Time/End time": repr(20 * wave / n)}

    def happens(self, probability):
        return self.r.random() < probability

    def pick(self, *choices):
        return self.r.choice(choices)

    def number(self, low, high, lowest=None, highest=None):
        """Log-uniform, half of them between the extremes where there are some."""
        if lowest is not None and self.happens(0.5):
            low, high = lowest, highest
        return float(f"{low * (high / low)**self.r.random():.3g}")

    def signed(self, *limits):
        return self.pick(-1, 1) * self.number(*limits)

    def amplitude(self):
        return self.signed(0.1, 100, 1e-6, 1e6)

    def frequency(self):
        return self.number(0.5 / self.duration, 50 / self.duration)

    def moment(self):
        return float(f"{self.duration * self.r.random():.3g}")

    def drive(self, value, change):
        """A function of time around a value, with jumps or without."""
        w, at, width = self.frequency(), self.moment(), self.duration * self.number(1e-3, 0.3)
        return self.pick(
            f"{value}+({change})*sin({w}*t)", f"if(t<{at},{value},{change})",
            f"if(t<{at},{value},if(t<{at}+{width},{change},{value}))",
            f"{value}+({change})*exp(-((t-{at})/{width})^2)",
            f"{value}+({change})*min(t/{width},1)")

    def draw_mesh(self):
        r = self.r
        self["Mesh/Cells"], self["Mesh/Degree"] = r.randint(1, 20), r.randint(1, 6)
        if self.is_plane:
            self |= {"Dimension": 2, "Mesh/Cells": r.randint(2, 4), "Mesh/Degree": r.randint(1, 3),
                     "Mesh/Cells across": r.randint(1, 2), "Mesh/Width": self.number(0.05, 1)}
            if self.moves:
                self["Model/Poisson ratio"] = self.pick(0.49, round(r.uniform(-0.5, 0.45), 2))
                self["Boundary/sides/Support"] = self.pick("free", "rollers")
        elif self.happens(0.3):
            self["Mesh/Grading"] = self.number(1e-4, 1e4)

    def draw_times(self):
        scheme = self.pick("backward euler", "sdirk2", "sdirk3", "sdirk4", "controlled",
                           "energy conserving")
        one_node = self["Mesh/Cells"] == self["Mesh/Degree"] == 1
        if scheme == "energy conserving" and (not self.moves or one_node):
            scheme = "sdirk2"
        self.scheme = scheme
        if scheme == "controlled":
            self.duration = self.number(1e-4, 10)
            self["Time/Tolerance"] = self.number(1e-5, 1e-3)
        else:
            step = self.number(1e-3, 1, 1e-6, 10)
            self.duration = float(f"{step * self.r.uniform(5, 25):.3g}")
            self |= {"Time/Scheme": scheme, "Time/Step size": step}
            if scheme == "backward euler" and self.moves:
                self["Time/Start"] = "consistent"
        self["Time/End time"] = self.duration

    def draw_motion(self):
        conserves = self.scheme == "energy conserving"
        b = 0 if self.happens(0.1) and not conserves else self.number(0.01, 10, 1e-9, 1e8)
        self["Model/Inertia"] = b
        self["Model/Viscosity"] = 0 if self.happens(0.2 if b else 0.5) else self.number(1e-3, 1, 1e-9, 1e6)
        if self.heat:
            self["Model/Coupling"] = self.signed(1e-3, 1, 1e-12, 1e3)
            self["Model/Thermoelastic heating"] = self.pick("true", "true", "true", "false")
        self.v = self.signed(0.1, 100, 1e-6, 1e6) if b else 0.
        if b:
            self["Initial values/Velocity"] = f"{self.v}" + self.pick("*x", "*x^2", "*sin(9*x)")
        self.u = 0.
        if self.happens(0.4):
            self.u = self.signed(1e-3, 1, 1e-9, 1e3)
            self["Initial values/Displacement"] = f"{self.u}" + self.pick("*x", "*x^3")
        if self.happens(0.2):
            self[self.pick("Sources/Body force", "Boundary/right/Traction")] = self.drive(
                0, self.amplitude())
        if self.happens(0.2) and not conserves:
            size, w, at = self.signed(1e-3, 1, 1e-9, 1e3), self.frequency(), self.moment()
            self["Boundary/left/Displacement"] = f"{size}*" + self.pick(
                f"sin({w}*t)^2", f"max(0,t-{at})", f"t^2*exp(-{w}*t)")

    def draw_obstacle(self):
        condition = self.pick("normal compliance", "normal compliance", "power law", "rigid")
        conserves = self.scheme == "energy conserving"
        if condition == "power law" and conserves:
            condition = "normal compliance"
        self["Contact/Condition"] = condition
        # where the end comes to within the run, or anywhere, or at the end
        gap = self.pick(abs(self.v) * self.duration * self.number(1e-3, 1),
                        self.number(1e-3, 1, 1e-9, 1e6), 0.)
        gap = max(0., self.u) * 1.01 + float(f"{gap:.3g}")
        if condition != "rigid":
            self["Contact/Compliance"] = self.number(1e-3, 1, 1e-9, 1e12)
            if self.happens(0.2):
                gap = -min(gap, 1.)
            if condition == "power law":
                self["Contact/Compliance"] = self.number(1e-2, 1)
                self["Contact/Exponent"] = self.pick(1.5, 2, 3)
            if not conserves and self.happens(0.3):
                damping = self.number(0.01, 10, 1e-6, 1e6)
                can_have_dashpot = self.get("Model/Inertia") or self["Model/Viscosity"]
                self[random.Random(damping).choice(("Contact/Damping", "Contact/Dashpot"))
                     if can_have_dashpot else "Contact/Damping"] = damping
        self["Contact/Gap"] = gap
        size = self.signed(1e-3, 1)
        if self.happens(0.3):
            rear = float(f"{max(self.number(1e-3, 1), -1.1 * gap, -1.1 * self.u):.3g}")
            self["Contact/Rear gap"] = rear
            # stops that do not meet
            size = float(f"{self.pick(1, -1) * 0.5 * (gap + rear) / max(1., self.duration):.3g}")
        if self.happens(0.3):
            w, at = self.frequency(), self.moment()
            self["Contact/Gap"] = f"{gap}+({size})*" + self.pick(
                f"sin({w}*t)^2", f"max(0,t-{at})", f"abs(sin({w}*t))")

    def draw_heat(self):
        hot = self.amplitude()
        self["Boundary/left/Temperature"] = hot if self.happens(0.7) else self.drive(
            hot, self.amplitude())
        self["Initial values/Temperature"] = self.pick(
            "theta_A", "theta_A*(1-x)", f"theta_A+({self.amplitude()})*sin(4*x)")
        k, g = self.number(0.1, 100, 1e-9, 1e9), self.number(1e-4, 1)
        self["Boundary/right/Heat exchange"] = self.pick(0, k, k)
        if self.moves and self.scheme != "energy conserving" and self.happens(0.3):
            self["Boundary/right/Heat exchange"] = self.pick(
                f"{k}*{g}/({g}+gap)+{k}*pressure", f"if(pressure>0,{k},1)")
        elif self["Boundary/right/Heat exchange"] and self.happens(0.5):
            self["Boundary/right/Surroundings"] = self.pick(
                self.amplitude(), self.drive(0, self.amplitude()))
        if self.happens(0.3):
            self["Boundary/sides/Heat exchange"] = self.number(0.1, 100, 1e-6, 1e6)
            self["Boundary/sides/Surroundings"] = self.amplitude()
        if self.happens(0.1):
            self[self.pick("Sources/Heat source", "Boundary/right/Heat flux")] = self.drive(
                0, self.amplitude())
