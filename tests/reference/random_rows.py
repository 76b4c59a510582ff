#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random rows of elastic rods and masses with rigid contacts, by characteristics: an independent program.

In a rod with impedance Z, R = v + p/Z goes to the right and L = v - p/Z to the left, each by one place in a step; places
of all rods are passed in the same time. At a free end p = 0, at a clamped one v = 0. Two rods in contact have one v and
one p,
    p = (R_A - L_B)/(1/Z_A + 1/Z_B),
as long as that is not negative; layers likewise, with any sign. A mass has m v' = Z_A (R_A - v) - Z_B (v - L_B) from those
that touch it, by the trapezoidal rule. A gap that would close in a step closes at its end. Of first order in the step.
Contact begins and ends with its pressure, in the middle of a step. With steps twice as long its times differ by their
error, since that is of first order.
"""
import math
import random

import numpy


class Body:
    def __init__(self, name, kind, velocity, places=0, passage=0., section=1., stiffness=1., density=1., mass=1.):
        self.name, self.kind, self.velocity, self.passage = name, kind, velocity, passage
        self.section, self.stiffness, self.density, self.mass = section, stiffness, density, mass
        self.length = passage * math.sqrt(stiffness / density)
        self.impedance = section * math.sqrt(stiffness * density)
        self.n = places

    def entries(self):
        section = f"Bodies/{self.name}/"
        if self.kind == "mass":
            return [section + "Kind=mass", f"{section}Mass={self.mass}", f"{section}Velocity={self.velocity}"]
        return [f"{section}Length={self.length!r}", f"{section}Section={self.section}",
                f"{section}Stiffness={self.stiffness}", f"{section}Density={self.density}",
                f"{section}Velocity={self.velocity}"]


class Scene:
    """Bodies, the gap of each pair (None: bonded), what is on the left and on the right, the gap to an obstacle."""

    def __init__(self, seed):
        draw = random.Random(seed)
        n = draw.randint(2, 5)
        kinds = ["rod"] * n
        for i in range(1, n - 1):
            if kinds[i - 1] == "rod" and draw.random() < 0.25:
                kinds[i] = "mass"
        self.bodies = []
        for i, kind in enumerate(kinds):
            self.bodies.append(Body(
                "abcde"[i], kind, 0., passage=0.1 * draw.randint(3, 12), section=draw.choice((1., 0.5, 2., 3.)),
                stiffness=draw.choice((1., 1., 0.25)), density=draw.choice((1., 1., 4.)),
                mass=round(draw.uniform(0.3, 3), 3)))
        self.left = draw.choice(("free", "clamped"))
        self.right = draw.choice(("free", "contact", "clamped"))
        self.gaps = []
        for first, second in zip(self.bodies, self.bodies[1:]):
            bonded = first.kind == second.kind == "rod" and draw.random() < 0.2
            self.gaps.append(None if bonded else draw.choice((0., 0., round(draw.uniform(0.02, 0.3), 3))))
        self.obstacle_gap = round(draw.uniform(0.02, 0.3), 3)
        # one part flies
        parts, part = [], [self.bodies[0]]
        for gap, body in zip(self.gaps, self.bodies[1:]):
            if gap is None:
                part.append(body)
            else:
                parts.append(part)
                part = [body]
        parts.append(part)
        movable = [p for i, p in enumerate(parts) if not (
            (i == 0 and self.left == "clamped") or (i == len(parts) - 1 and self.right == "clamped"))]
        for p in movable[:2]:
            velocity = draw.choice((1., 0.7, -1., 0.4))
            for body in p:
                body.velocity = velocity
        self.moves = bool(movable)
        self.end_time = 4.

    def overrides(self):
        entries = ["Model/Fields=displacement", "Model/Viscosity=0", "Contact/Condition=rigid",
                   f"Time/End time={self.end_time}", f"Boundary/left/Support={self.left}",
                   f"Boundary/right/Support={self.right}"]
        if self.right == "contact":
            entries.append(f"Contact/Gap={self.obstacle_gap}")
        for body in self.bodies:
            entries += body.entries()
        for gap, first, second in zip(self.gaps, self.bodies, self.bodies[1:]):
            pair = f"Contacts/{first.name} {second.name}/"
            entries.append(pair + ("Condition=bonded" if gap is None else f"Gap={gap}"))
        return entries

    def contacts(self):
        names = [f"{a.name}-{b.name}" for gap, a, b in zip(self.gaps, self.bodies, self.bodies[1:]) if gap is not None]
        return names + ([f"{self.bodies[-1].name}-obstacle"] if self.right == "contact" else [])


NO_PRESSURE = 1e-9  # rounding, of velocities and impedances of order 1


def without_short_ones(times, shortest):
    """Begins and ends in turn, without two that are closer to each other."""
    kept = []
    for time in times:
        if kept and time - kept[-1] < shortest:
            kept.pop()
        else:
            kept.append(time)
    return kept


def solve(scene, places_per_tenth=200):
    """Impulses of the contacts, displacement of the right end, and for each contact the times where it begins and ends
    in turn."""
    step = 0.1 / places_per_tenth
    bodies = scene.bodies
    n = len(bodies)
    right, left = [None] * n, [None] * n  # R, L at the places of a rod, both ends among them
    for i, body in enumerate(bodies):
        if body.kind == "rod":
            count = round(body.passage / step) + 1
            right[i], left[i] = (numpy.full(count, body.velocity) for _ in range(2))
    speed = [body.velocity for body in bodies]  # of masses
    gaps = [0. if gap is None else gap for gap in scene.gaps] + [scene.obstacle_gap]
    impulses = [0.] * n
    displacement = 0.
    changes = [[] for _ in range(n)]
    clamped = scene.left == "clamped"

    def note(contact, pressure, time):
        if (pressure > NO_PRESSURE) != len(changes[contact]) % 2:
            changes[contact].append(time)

    for number in range(round(scene.end_time / step)):
        middle = (number + 0.5) * step
        for i, body in enumerate(bodies):
            if body.kind == "rod":
                right[i][1:] = right[i][:-1].copy()
                left[i][:-1] = left[i][1:].copy()
        # the left end, and each interface from what arrives; None: a mass, whose v is found below
        if bodies[0].kind == "rod":
            right[0][0] = -left[0][0] if clamped else left[0][0]
        forces = [[0., 0.] for _ in range(n)]  # on a mass: Z R and Z of what touches it
        velocities = [None] * n  # of the right end of body i
        pending = []
        for i in range(n):
            last = i == n - 1
            a, b = bodies[i], None if last else bodies[i + 1]
            if last and scene.right != "contact":
                if a.kind == "rod":
                    left[i][-1] = -right[i][-1] if scene.right == "clamped" else right[i][-1]
                    velocities[i] = 0. if scene.right == "clamped" else right[i][-1]
                continue
            if a.kind == "rod" and (last or b.kind == "rod"):
                ra, za = right[i][-1], a.impedance
                lb, yb = (0., 0.) if last else (left[i + 1][0], 1. / b.impedance)
                p = (ra - lb) / (1. / za + yb)
                if not last and scene.gaps[i] is None:
                    pass  # a layer carries any stress
                else:
                    opened = gaps[i] - step * (ra - lb)
                    if gaps[i] > 0. and opened > 0. or p <= 0.:
                        gaps[i] = max(opened, 0.)
                        p = 0.
                    else:
                        p *= min(1., (step * (ra - lb) - gaps[i]) / (step * (ra - lb))) if ra > lb else 1.
                        gaps[i] = 0.
                impulses[i] += step * p
                note(i, p, middle)
                left[i][-1] = ra - 2. * p / za
                if not last:
                    right[i + 1][0] = lb + 2. * p * yb
                velocities[i] = ra - p / za
            elif b is not None and b.kind == "mass":
                pending.append(i + 1)
        for i in pending:  # between two rods, or a rod and nothing
            body, v = bodies[i], speed[i]
            za, ra = bodies[i - 1].impedance, right[i - 1][-1]
            on_right = i + 1 < n
            zb, lb = (bodies[i + 1].impedance, left[i + 1][0]) if on_right else (0., 0.)
            best = None
            for touch_a in (True, False):
                for touch_b in ((True, False) if on_right else (False,)):
                    if touch_a and gaps[i - 1] > 0. and gaps[i - 1] - step * (ra - v) > 0.:
                        continue
                    if touch_b and gaps[i] > 0. and gaps[i] - step * (v - lb) > 0.:
                        continue
                    force = za * ra * touch_a + zb * lb * touch_b
                    damping = za * touch_a + zb * touch_b
                    new = ((body.mass - 0.5 * step * damping) * v + step * force) / (body.mass + 0.5 * step * damping)
                    mean = 0.5 * (v + new)
                    pa, pb = za * (ra - mean) * touch_a, zb * (mean - lb) * touch_b
                    if pa >= 0. and pb >= 0. and (touch_a or gaps[i - 1] - step * (ra - mean) > -1e-12) and (
                            touch_b or not on_right or gaps[i] - step * (mean - lb) > -1e-12):
                        best = new, mean, pa, pb, touch_a, touch_b
                        break
                if best:
                    break
            if best is None:
                mean, pa, pb, new, touch_a, touch_b = v, 0., 0., v, False, False
            else:
                new, mean, pa, pb, touch_a, touch_b = best
            speed[i] = new
            va = mean if touch_a else ra
            gaps[i - 1] = 0. if touch_a else max(0., gaps[i - 1] - step * (ra - mean))
            impulses[i - 1] += step * pa
            note(i - 1, pa, middle)
            left[i - 1][-1] = ra - 2. * pa / za
            velocities[i - 1] = va
            if on_right:
                gaps[i] = 0. if touch_b else max(0., gaps[i] - step * (mean - lb))
                impulses[i] += step * pb
                note(i, pb, middle)
                right[i + 1][0] = lb + 2. * pb / zb
            velocities[i] = mean
        displacement += step * velocities[n - 1]
    named = [i for i in range(n) if (scene.gaps[i] is not None if i < n - 1 else scene.right == "contact")]
    return [impulses[i] for i in named], displacement, [changes[i] for i in named]
