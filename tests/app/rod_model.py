# SPDX-License-Identifier: LGPL-2.1-or-later
"""The equations of doc/model.md for a rod in numpy: matrices, loads, energies, stages.

An implementation of its own of sections 2, 4, 5, 6, 8 with dense matrices, by which the
checks recompute what the program reports. Elements of any degree on the Gauss-Lobatto
nodes; contact nodes with or without mass (M.36); not the scheme `energy conserving`.
"""
import math

import numpy
from numpy.polynomial import legendre


def lobatto_nodes(degree):
    """Zeros of (1 - s^2) P'_degree, on [0, 1]."""
    inner = legendre.legroots(legendre.legder([0] * degree + [1]))
    return numpy.concatenate([[0], (1 + numpy.sort(inner)) / 2, [1]])


class Element:
    """Lagrange polynomials on nodes of [0, 1]."""

    def __init__(self, nodes):
        self.nodes = numpy.asarray(nodes)
        self.n = len(nodes)
        vandermonde = legendre.legvander(2 * self.nodes - 1, self.n - 1)
        self.coefficients = numpy.linalg.inv(vandermonde)
        points, weights = legendre.leggauss(self.n + 20)
        self.points, self.weights = (points + 1) / 2, weights / 2
        self.integrals = self.weights @ self.values(self.points)

    def values(self, s):
        return legendre.legvander(2 * numpy.asarray(s) - 1, self.n - 1) @ self.coefficients

    def derivatives(self, s, order=1):
        c = legendre.legder(self.coefficients, order) * 2**order
        return legendre.legvander(2 * numpy.asarray(s) - 1, len(c) - 1) @ c


class State:
    """Nodal values, contact pressure and time."""

    def __init__(self, theta, u, v, p=0.0, t=0.0):
        self.theta, self.u, self.v, self.p, self.t = theta, u, v, p, t

    def copy(self):
        return State(self.theta.copy(), self.u.copy(), self.v.copy(), self.p, self.t)


class Rod:
    """Coefficients and matrices of a scene, named as in doc/model.md."""

    def __init__(self, settings):
        s = settings
        assert s["Dimension"] == "1" and int(s["Mesh/Refinements"]) == 0
        self.has_heat, self.moves = s.has("temperature"), s.has("displacement")
        self.b, self.zeta = s.number("Model/Inertia"), s.number("Model/Viscosity")
        self.a = s.number("Model/Coupling") if self.has_heat and self.moves else 0.0
        self.heats = s.get("Model/Thermoelastic heating", "true") == "true"
        self.k = s.number("Boundary/Heat exchange")
        self.theta_A = s.number("Boundary/Fixed end temperature")
        self.theta_obs = s.number("Boundary/Obstacle temperature")
        self.m = s.number("Boundary/Lateral heat exchange")
        self.theta_inf = s.number("Boundary/Ambient temperature")
        condition = s.get("Contact/Condition", "none") if self.moves else "none"
        self.has_obstacle, self.is_rigid = condition != "none", condition == "rigid"
        self.epsilon = (s.number("Contact/Compliance")
                        if condition == "normal compliance" else 0.0)
        self.g = s.number("Contact/Gap")
        rear_gap = s.get("Contact/Rear gap", "none")  # infinite: no such stop
        self.g_2 = math.inf if rear_gap == "none" else float(rear_gap)
        self.cells, self.degree = int(s["Mesh/Cells"]), int(s["Mesh/Degree"])
        grading = s.number("Mesh/Grading", 1) ** (-1 / max(self.cells - 1, 1))
        sizes = grading ** numpy.arange(self.cells)
        self.sizes = sizes / sizes.sum()
        self.vertices = numpy.concatenate([[0], numpy.cumsum(self.sizes)])
        self.sources = {name: s.expression("Sources/" + name)
                        if s.get("Sources/" + name, "0") != "0" else None for name in
                        ("Heat source", "Body force", "End traction", "End heat flux")}
        self.is_massless = self.uses_massless_nodes(s)
        self.assemble(s.get("Mesh/Mass matrix") == "lumped")
        self.theta_s = numpy.full(self.n, self.theta_A)  # (M.104)
        self.theta_s[1:] += numpy.linalg.solve(
            self.K_B[1:, 1:], (self.outer_heat - self.K_B @ self.theta_s)[1:])
        self.solvers = {}

    def uses_massless_nodes(self, settings):
        choice = settings.get("Contact/Massless nodes", "off")
        if not self.has_obstacle or self.b == 0 or choice != "automatic":
            return self.has_obstacle and self.b > 0 and choice == "on"
        return (not has_paper_start(settings) and self.g_2 == math.inf and
                self.zeta < numpy.sqrt(self.b) * self.sizes[-1] / self.degree)

    def assemble(self, is_lumped):
        self.element = e = Element(lobatto_nodes(self.degree))
        n = self.n = self.cells * self.degree + 1
        self.x = numpy.zeros(n)
        self.M, self.K, self.L, self.D, self.M_u = (numpy.zeros((n, n))
                                                    for _ in range(5))
        B, G, w = e.values(e.points), e.derivatives(e.points), e.weights
        mass = numpy.diag(e.integrals) if is_lumped else B.T @ (w[:, None] * B)
        for cell, h in enumerate(self.sizes):
            at = self.nodes_of(cell)
            block = numpy.ix_(at, at)
            self.x[at] = self.vertices[cell] + h * e.nodes
            self.M[block] += h * mass
            self.K[block] += G.T @ (w[:, None] * G) / h
            self.L[block] += self.m * h * (B.T @ (w[:, None] * B))
            self.D[block] += B.T @ (w[:, None] * G)
            if self.is_massless and cell == self.cells - 1:
                inner = Element(e.nodes[:-1]).integrals
                self.M_u[block] += h * numpy.diag([*inner, 0])
            else:
                self.M_u[block] += h * mass
        self.S = self.K
        self.K_B = self.K + self.L
        self.K_B[-1, -1] += self.k
        self.outer_heat = self.theta_inf * self.L.sum(axis=1)
        self.outer_heat[-1] += self.k * self.theta_obs

    def nodes_of(self, cell):
        return numpy.arange(cell * self.degree, (cell + 1) * self.degree + 1)

    def integrate(self, function, t):
        """(function, eta_i)"""
        e, load = self.element, numpy.zeros(self.n)
        if function is None:
            return load
        for cell, h in enumerate(self.sizes):
            values = function(self.vertices[cell] + h * e.points, t)
            load[self.nodes_of(cell)] += h * (e.weights * values) @ e.values(e.points)
        return load

    def project(self, function):
        """P_E, (M.13): the values at the vertices, and inside the projection of w'."""
        e, result = self.element, function(self.x)
        if self.degree == 1:
            return result
        G = e.derivatives(e.points)[:, 1:-1]
        matrix = G.T @ (e.weights[:, None] * G)
        second = e.derivatives(e.points, 2)[:, 1:-1]
        slopes = e.derivatives([0.0, 1.0])[:, 1:-1]
        for cell, h in enumerate(self.sizes):
            at = self.nodes_of(cell)
            # the deviation from the interpolant, integrated by parts
            w = (function(self.vertices[cell] + h * e.points) -
                 e.values(e.points) @ result[at])
            ends = function(self.x[at[[0, -1]]]) - result[at[[0, -1]]]
            rhs = -(e.weights * w) @ second + ends[1] * slopes[1] - ends[0] * slopes[0]
            result[at[1:-1]] += numpy.linalg.solve(matrix, rhs)
        return result

    def loads(self, t):
        """Loads of the heat equation and of the momentum equation without contact."""
        q = self.integrate(self.sources["Heat source"], t)
        f = self.integrate(self.sources["Body force"], t)
        q[-1] += self.at_end("End heat flux", t)
        f[-1] += self.at_end("End traction", t)
        return q, f

    def at_end(self, source, t):
        """The value of a source at the contact end"""
        function = self.sources[source]
        return 0.0 if function is None else function(self.x[-1:], t)[0]

    def solver(self, tau):
        """Inverse of (M.15) for the rates of free nodes, and the response (M.16)."""
        if tau in self.solvers:
            return self.solvers[tau]
        free = slice(1, None)
        heating = self.a if self.heats else 0.0
        heat = self.M + tau * self.K_B if self.has_heat else numpy.eye(self.n)
        momentum = (self.b * self.M_u + tau * (self.zeta + tau) * self.S
                    if self.moves else numpy.eye(self.n))
        matrix = numpy.block([[heat[free, free], heating * self.D[free, free]],
                              [-tau**2 * self.a * self.D.T[free, free],
                               momentum[free, free]]])
        inverse = numpy.linalg.inv(matrix)
        unit = numpy.zeros(2 * self.n - 2)
        unit[-1] = tau
        response = inverse @ unit
        self.solvers[tau] = inverse, response
        return self.solvers[tau]

    def rates(self, known, tau, t):
        """(M.15) without contact: rates of temperature and displacement."""
        q, f = self.loads(t)
        heat = numpy.zeros(self.n)
        if self.has_heat:
            heat = q + self.outer_heat - self.K_B @ known.theta
        momentum = numpy.zeros(self.n)
        if self.moves:
            momentum = (self.b * self.M_u @ known.v - tau * self.S @ known.u +
                        tau * self.a * self.D.T @ known.theta + tau * f)
        return self.solver(tau)[0] @ numpy.concatenate([heat[1:], momentum[1:]])

    def split(self, rates):
        zero = numpy.zeros(1)
        return (numpy.concatenate([zero, rates[:self.n - 1]]),
                numpy.concatenate([zero, rates[self.n - 1:]]))

    def initial_state(self, settings):
        zero = numpy.zeros(self.n)
        field = {name: self.project(settings.expression("Initial values/" + name))
                 if self.moves or name == "Temperature" else zero
                 for name in ("Temperature", "Displacement", "Velocity")}
        theta = field["Temperature"] if self.has_heat else zero.copy()
        if self.has_heat:
            theta[0] = self.theta_A
        state = State(theta, field["Displacement"], field["Velocity"])
        if self.has_obstacle and not self.is_rigid:
            state.p = self.pressure(state.u[-1], 0.0)
        if self.moves and self.b == 0:
            self.balance(state)
        return state

    def balance(self, state):
        """The velocity (M.34) or, without viscosity, the equilibrium (M.35)."""
        S = self.S[1:, 1:]
        f = (self.loads(0.0)[1] + self.a * self.D.T @ state.theta)[1:]
        if self.zeta == 0:
            state.u[1:] = numpy.linalg.solve(S, f)
            # S^-1 e is the displacement x of a unit traction, 1 at the end
            state.p = self.pressure(state.u[-1], 1.0) if self.has_obstacle else 0.0
            state.u -= state.p * self.x
            state.v = numpy.zeros(self.n)
        else:
            f[-1] -= state.p
            state.v[1:] = numpy.linalg.solve(S, f - S @ state.u[1:]) / self.zeta

    def pressure(self, u_free, receptance):
        """(M.17), (M.108)"""
        return (max(0.0, u_free - self.g) - max(0.0, -u_free - self.g_2)) / (
            self.epsilon + receptance)

    def gap(self, u):
        """What is left to the nearer stop"""
        return min(self.g - u, self.g_2 + u)

    def energy_terms(self, state):
        """Thermal, kinetic, elastic, obstacle, coupling: (M.8)."""
        theta = state.theta - self.theta_s if self.has_heat else 0 * self.x
        return numpy.array([
            theta @ self.M @ theta / 2, self.b * state.v @ self.M_u @ state.v / 2,
            state.u @ self.S @ state.u / 2, self.epsilon * state.p**2 / 2,
            -self.a * self.theta_s @ self.D @ state.u])

    def dissipation_rate(self, state):
        """(M.23)"""
        theta = state.theta - self.theta_s if self.has_heat else 0 * self.x
        return theta @ self.K_B @ theta + self.zeta * state.v @ self.S @ state.v

    def lateral_dissipation_rate(self, state):
        """(M.105)"""
        theta = state.theta - self.theta_s if self.has_heat else 0 * self.x
        return theta @ self.L @ theta

    def work_rate(self, state):
        """(M.25), and with heating off the work of the thermal stress, section 12."""
        theta = state.theta - self.theta_s if self.has_heat else 0 * self.x
        q, f = self.loads(state.t)
        rate = f @ state.v + q @ theta
        return rate if self.heats else rate + self.a * theta @ self.D @ state.v

    def numerical_dissipation(self, old, new):
        """(M.24), of a backward Euler step"""
        theta, u, v = new.theta - old.theta, new.u - old.u, new.v - old.v
        contact = (new.p * ((self.g if new.p > 0 else -self.g_2) - old.u[-1])
                   if self.is_rigid and new.p else
                   new.p * u[-1] - self.epsilon * (new.p**2 - old.p**2) / 2)
        return (theta @ self.M @ theta + self.b * v @ self.M_u @ v +
                u @ self.S @ u) / 2 + (contact if self.has_obstacle else 0.0)

    def effective_mass(self):
        """1/(e^T (b M_u)^-1 e) of the contact node, and (b M_u)^-1 e."""
        unit = numpy.zeros(self.n - 1)
        unit[-1] = 1.0
        column = numpy.concatenate([[0], numpy.linalg.solve(self.b * self.M_u[1:, 1:],
                                                            unit)])
        return 1 / column[-1], column

    def values_at(self, x, nodal, derivative=False):
        """Values of a field at places; derivatives are means of both sides."""
        x = numpy.atleast_1d(x)
        total, count = numpy.zeros(len(x)), numpy.zeros(len(x))
        for cell, h in enumerate(self.sizes):
            s = (x - self.vertices[cell]) / h
            inside = (s > -1e-9) & (s < 1 + 1e-9)
            basis = (self.element.derivatives(s[inside]) / h if derivative else
                     self.element.values(s[inside]))
            total[inside] += basis @ nodal[self.nodes_of(cell)]
            count[inside] += 1
        return total / count

    def stress_at(self, x, state):
        """u_x + zeta v_x - a theta, the mean of both sides of a vertex"""
        return (self.values_at(x, state.u + self.zeta * state.v, True) -
                self.a * self.values_at(x, state.theta))


def has_paper_start(settings):
    """True if the first step is prescribed, section 9."""
    start = settings.get("Time/Start", "automatic")
    return (settings.has("displacement") and settings.number("Model/Inertia") > 0 and
            (start == "paper" or start == "automatic" and
             settings["Time/Scheme"] == "backward euler" and
             settings.get("Contact/Massless nodes") != "on"))
