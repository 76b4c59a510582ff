#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random rows of rods and masses with heat, viscosity and elastic contacts: an independent program.

The matrices of linear elements are assembled here, and scipy's Radau method integrates (M10.1), (M10.2). Contacts have p = [s]_+/eps and q = k (theta_L - theta_R)
with a number k or k(gap, pressure). Coefficients may depend on the temperature, (M10.8): what they add is integrated here with two points of Gauss in a cell.
"""
import random

import numpy
from scipy.integrate import solve_ivp

LAWS = {"exp({0}*theta)": lambda s, theta: numpy.exp(s * theta),
        "(1 + {0}*theta/(1 + theta^2))": lambda s, theta: 1 + s * theta / (1 + theta**2)}
OF_TEMPERATURE = ("stiffness", "viscosity", "coupling", "conductivity", "capacity")
CONSTANT, OF_CONTACT = "constant", "if(pressure > 0, {0} + {1}*pressure, {0}/(1 + {2}*gap))"


class Scene:
    def __init__(self, seed, has_laws=False):
        draw = random.Random(seed)
        number = lambda low, high: round(draw.uniform(low, high), 3)  # noqa: E731
        n = draw.randint(2, 4)
        self.left_free = draw.random() < 0.5
        self.right = draw.choice(("contact", "free"))
        self.bodies = []
        for i in range(n):
            kind = "mass" if draw.random() < 0.3 and (i > 0 or self.left_free) else "rod"
            if i == n - 1 and all(body["kind"] == "mass" for body in self.bodies):
                kind = "rod"
            moves = (i > 0 or self.left_free) and draw.random() < 0.6
            self.bodies.append(dict(
                name="abcd"[i], kind=kind, length=number(0.3, 1), cells=draw.randint(3, 6),
                section=number(0.5, 2), stiffness=number(0.5, 2), density=number(0.5, 2), viscosity=number(0.5, 2),
                coupling=number(-1, 2), conductivity=number(0.5, 3), capacity=number(0.5, 2), mass=number(0.2, 1.5),
                temperature=(number(-1, 2), 0. if kind == "mass" else number(-1, 1)),
                velocity=number(-0.6, 0.6) if moves else 0.))
        self.bonded = [a["kind"] == b["kind"] == "rod" and draw.random() < 0.2
                       for a, b in zip(self.bodies, self.bodies[1:])]
        for a, b, bonded in zip(self.bodies, self.bodies[1:], self.bonded):
            if bonded:  # one displacement, one temperature, one velocity
                b["velocity"] = a["velocity"]
                b["temperature"] = (round(a["temperature"][0] + a["length"] * a["temperature"][1], 12),
                                    b["temperature"][1])
        self.clamped_moves_not()
        self.gaps = [number(0, 0.08) if draw.random() < 0.7 else 0. for _ in range(n)]
        self.inertia, self.viscosity, self.coupling = number(0.3, 1.5), number(0.01, 0.1), number(0.05, 0.4)
        self.compliance = number(0.03, 0.2)
        self.exchange = (number(0.5, 3), number(1, 5), number(2, 20))
        self.exchange_kind = draw.choice((CONSTANT, OF_CONTACT)) if self.right == "contact" else CONSTANT
        self.left_temperature = number(0, 2) if draw.random() < 0.5 and self.bodies[0]["kind"] == "rod" else None
        self.left_exchange, self.left_surroundings = number(0.2, 2), number(-1, 1)
        if self.left_temperature is None and self.bodies[0]["kind"] == "mass":
            self.left_exchange = 0.
        self.lateral, self.ambient = draw.choice((0., number(0.2, 2))), number(-1, 1)
        self.obstacle = number(-1, 1)
        self.force, self.source = draw.choice((0., number(-0.5, 0.5))), draw.choice((0., number(-1, 1)))
        self.times = [0.5, 1., 1.5, 2.]
        draw = random.Random(seed + 1_000_000)
        for body in self.bodies:
            body["laws"] = {name: (draw.choice(list(LAWS)), number(-0.4, 0.4)) for name in OF_TEMPERATURE
                            if has_laws and body["kind"] == "rod" and draw.random() < 0.6}

    def clamped_moves_not(self):
        """A clamped end has no velocity, nor what is bonded to it."""
        if self.left_free:
            return
        for i in range(len(self.bodies)):
            if i > 0 and not self.bonded[i - 1]:
                return
            self.bodies[i]["velocity"] = 0.

    def overrides(self):
        kind = self.exchange_kind
        entries = [
            f"Model/Inertia={self.inertia}", f"Model/Viscosity={self.viscosity}", f"Model/Coupling={self.coupling}",
            "Contact/Condition=normal compliance", f"Contact/Compliance={self.compliance}",
            "Contact/Massless nodes=off", "Mesh/Degree=1", "Time/Scheme=sdirk4", "Time/Tolerance=1e-6",
            f"Time/End time={self.times[-1]}", f"Boundary/left/Support={'free' if self.left_free else 'clamped'}",
            f"Boundary/right/Support={self.right}", f"Boundary/right/Surroundings={self.obstacle}",
            "Boundary/right/Heat exchange=" + (
                str(self.exchange[0]) if kind == CONSTANT else kind.format(*self.exchange)),
            f"Sources/Body force={self.force}", f"Sources/Heat source={self.source}"]
        if self.right == "contact":
            entries.append(f"Contact/Gap={self.gaps[-1]}")
        if self.left_temperature is None:
            entries += ["Boundary/left/Temperature=none", f"Boundary/left/Heat exchange={self.left_exchange}"]
            if self.left_exchange:
                entries.append(f"Boundary/left/Surroundings={self.left_surroundings}")
        else:
            entries.append(f"Boundary/left/Temperature={self.left_temperature}")
        if self.lateral:
            entries += [f"Boundary/sides/Heat exchange={self.lateral}", f"Boundary/sides/Surroundings={self.ambient}"]
        for body in self.bodies:
            path = f"Bodies/{body['name']}/"
            c0, c1 = body["temperature"]

            def of_theta(name):
                law, factor = body["laws"].get(name, ("1", 0.))
                return f"{body[name]}" + (f"*{law.format(factor)}" if name in body["laws"] else "")
            entries += [path + f"Velocity={body['velocity']}", path + f"Temperature={c0!r}+{c1}*x",
                        path + f"Heat capacity={of_theta('capacity')}"]
            if body["kind"] == "mass":
                entries += [path + "Kind=mass", path + f"Mass={body['mass']}"]
            else:
                entries += [path + f"{entry}={of_theta(entry.lower())}" for entry in (
                    "Length", "Cells", "Section", "Stiffness", "Density", "Viscosity", "Coupling", "Conductivity")]
        for a, b, gap, bonded in zip(self.bodies, self.bodies[1:], self.gaps, self.bonded):
            entries.append(f"Contacts/{a['name']} {b['name']}/" + ("Condition=bonded" if bonded else f"Gap={gap}"))
        return entries

    def contacts(self):
        """The names of the tables."""
        pairs = [f"{a['name']}-{b['name']}" for a, b, bonded in zip(self.bodies, self.bodies[1:], self.bonded)
                 if not bonded]
        return pairs + ([f"{self.bodies[-1]['name']}-obstacle"] if self.right == "contact" else [])


class Row:
    """The matrices of a scene."""

    def __init__(self, scene):
        self.scene = scene
        b, zeta, a = scene.inertia, scene.viscosity, scene.coupling
        ends, n, places = [], 0, []
        for i, body in enumerate(scene.bodies):
            first = n - 1 if i > 0 and scene.bonded[i - 1] else n
            n = first + (1 if body["kind"] == "mass" else body["cells"] + 1)
            ends.append((first, n - 1))
            places.append(numpy.linspace(0, body["length"] if body["kind"] == "rod" else 0, n - first))
        self.n = n
        self.laws = []  # (cells, size, body) of rods whose coefficients depend on the temperature
        names = ("heat_mass", "conduction", "lateral", "divergence", "mass", "stiffness", "damping", "stress")
        for name in names:
            setattr(self, name, numpy.zeros((n, n)))
        self.force, self.heat = numpy.zeros(n), numpy.zeros(n)
        self.theta, self.v = numpy.zeros(n), numpy.zeros(n)
        for body, (first, last), x in zip(scene.bodies, ends, places):
            self.theta[first:last + 1] = body["temperature"][0] + body["temperature"][1] * x
            self.v[first:last + 1] = body["velocity"]
            if body["kind"] == "mass":
                self.mass[first, first] += body["mass"]
                self.heat_mass[first, first] += body["capacity"]
                self.force[first] += body["mass"] / b * scene.force
                continue
            h = body["length"] / body["cells"]
            section = body["section"]
            if body["laws"]:
                self.laws.append((numpy.arange(first, last), h, body))
            local_mass = section * h / 6 * numpy.array([[2., 1.], [1., 2.]])
            local_stiffness = section / h * numpy.array([[1., -1.], [-1., 1.]])
            local_divergence = section / 2 * numpy.array([[-1., 1.], [-1., 1.]])  # (phi_i, phi_j')
            for cell in range(first, last):
                at = numpy.ix_((cell, cell + 1), (cell, cell + 1))
                self.heat_mass[at] += body["capacity"] * local_mass
                self.conduction[at] += body["conductivity"] * local_stiffness
                self.lateral[at] += scene.lateral * local_mass
                self.divergence[at] += a * body["coupling"] * local_divergence
                self.mass[at] += b * body["density"] * local_mass
                self.stiffness[at] += body["stiffness"] * local_stiffness
                self.damping[at] += zeta * body["viscosity"] * body["stiffness"] * local_stiffness
                self.force[cell:cell + 2] += body["density"] * scene.force * section * h / 2
                self.heat[cell:cell + 2] += scene.source * section * h / 2
        # (left node, right node, or -1 for the obstacle, gap)
        self.pairs = [(ends[i][1], ends[i + 1][0], scene.gaps[i])
                      for i in range(len(ends) - 1) if not scene.bonded[i]]
        if scene.right == "contact":
            self.pairs.append((n - 1, -1, scene.gaps[-1]))
        self.free_end = scene.right == "free"
        fixed_theta = scene.left_temperature is not None
        self.free_u = numpy.arange(n) >= (0 if scene.left_free else 1)
        self.free_theta = numpy.arange(n) >= (1 if fixed_theta else 0)
        if fixed_theta:
            # heat that comes in before any flows
            jump = scene.left_temperature - self.theta[0]
            free = self.free_theta
            self.theta[free] -= numpy.linalg.solve(
                self.heat_mass[numpy.ix_(free, free)], self.heat_mass[free, 0] * jump)
            self.theta[0] = scene.left_temperature
        self.heat_inverse = numpy.linalg.inv(self.heat_mass[numpy.ix_(self.free_theta, self.free_theta)])
        self.mass_inverse = numpy.linalg.inv(self.mass[numpy.ix_(self.free_u, self.free_u)])

    def contacts(self, theta, u):
        """Force and heat flux of each contact."""
        result = []
        for left, right, gap in self.pairs:
            s = u[left] - (u[right] if right >= 0 else 0.) - gap
            p = max(s, 0.) / self.scene.compliance
            base, slope, decay = self.scene.exchange
            k = base
            if self.scene.exchange_kind != CONSTANT:
                k = base + slope * p if p > 0 else base / (1 + decay * max(-s, 0.))
            result.append((p, k * (theta[left] - (theta[right] if right >= 0 else self.scene.obstacle))))
        return result

    def add_laws(self, theta, u, v, heat, force, heat_mass):
        """What the laws add to heat, force and the matrix of heat capacity beyond the coefficients at theta = 0."""
        scene = self.scene
        for cells, h, body in self.laws:
            slope = lambda values: (values[cells + 1] - values[cells]) / h  # noqa: E731
            for place in (0.5 - 12**-0.5, 0.5 + 12**-0.5):
                shapes = ((0, 1 - place, -1 / h), (1, place, 1 / h))
                at = sum(value * theta[cells + i] for i, value, _ in shapes)

                def over_zero(*names):
                    factor = 1.
                    for name in names:
                        if name in body["laws"]:
                            law, s = body["laws"][name]
                            factor = factor * LAWS[law](s, at)
                    weight = body["section"] * h / 2
                    for name in names:
                        weight *= body[name]
                    return weight * (factor - 1)
                coupling = scene.coupling * over_zero("coupling")
                stress = (over_zero("stiffness") * slope(u) - coupling * at
                          + scene.viscosity * over_zero("stiffness", "viscosity") * slope(v))
                flux = over_zero("conductivity") * slope(theta)
                for i, value, derivative in shapes:
                    numpy.add.at(force, cells + i, -stress * derivative)
                    numpy.add.at(heat, cells + i, -flux * derivative - coupling * slope(v) * value)
                    for j, other, _ in shapes:
                        numpy.add.at(heat_mass, (cells + i, cells + j), over_zero("capacity") * value * other)

    def rates(self, _, state):
        n, scene = self.n, self.scene
        theta, u, v = state[:n], state[n:2 * n], state[2 * n:3 * n]
        force = self.force - self.stiffness @ u - self.damping @ v + self.divergence.T @ theta
        outer = self.heat + self.lateral @ (scene.ambient - theta)
        if scene.left_temperature is None:
            outer[0] += scene.left_exchange * (scene.left_surroundings - theta[0])
        contacts = self.contacts(theta, u)
        for (left, right, _), (p, q) in zip(self.pairs, contacts):
            force[left] -= p
            outer[left] -= q
            if right >= 0:
                force[right] += p
                outer[right] += q
        if self.free_end:
            outer[-1] -= scene.exchange[0] * (theta[-1] - scene.obstacle)
        heat = outer - self.conduction @ theta - self.divergence @ v
        theta_rate, v_rate = numpy.zeros(n), numpy.zeros(n)
        if self.laws:
            heat_mass = self.heat_mass.copy()
            self.add_laws(theta, u, v, heat, force, heat_mass)
            free = self.free_theta
            theta_rate[free] = numpy.linalg.solve(heat_mass[numpy.ix_(free, free)], heat[free])
        else:
            theta_rate[self.free_theta] = self.heat_inverse @ heat[self.free_theta]
        v_rate[self.free_u] = self.mass_inverse @ force[self.free_u]
        return numpy.concatenate([theta_rate, v, v_rate])

    def energy(self, theta, u, v):
        """(M2.2), relative to the temperature of the fixed end or of what surrounds it."""
        scene = self.scene
        reference = (scene.left_temperature if scene.left_temperature is not None else
                     scene.left_surroundings if scene.left_exchange else 0.)
        excess = theta - reference
        energy = (excess @ self.heat_mass @ excess + v @ self.mass @ v + u @ self.stiffness @ u) / 2
        energy -= reference * numpy.sum(self.divergence @ u)
        for left, right, gap in self.pairs:
            s = u[left] - (u[right] if right >= 0 else 0.) - gap
            energy += max(s, 0.) ** 2 / (2 * self.scene.compliance)
        return energy


def solve(scene, tolerance=1e-9):
    """Quantities at the times of the scene, and how large each gets up to the end: temperature and displacement of the
    right end, energy, then force and heat flux of each contact, which are as large as those of any contact."""
    row = Row(scene)
    n = row.n
    dense = numpy.linspace(0, scene.times[-1], 401)
    run = solve_ivp(row.rates, (0, scene.times[-1]), numpy.concatenate([row.theta, numpy.zeros(n), row.v]),
                    method="Radau", t_eval=dense, rtol=tolerance, atol=1e-3 * tolerance)
    assert run.success, run.message
    table = []
    for y in run.y.T:
        theta, u, v = y[:n], y[n:2 * n], y[2 * n:]
        values = [theta[-1], u[-1], row.energy(theta, u, v)]
        for force, flux in row.contacts(theta, u):
            values += [force, flux]
        table.append(values)
    table = numpy.array(table)
    scale = abs(table).max(axis=0)
    for kind in (3, 4):
        scale[kind::2] = scale[kind::2].max(initial=0.)
    return table[[round(400 * time / scene.times[-1]) for time in scene.times]], scale
