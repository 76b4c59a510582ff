# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polynomials on the nodes of a cell, for those who read snapshots and contact faces."""
import functools

import numpy
from numpy.polynomial import legendre


@functools.cache
def equidistant(degree):
    """Those of a snapshot."""
    return Element(numpy.linspace(0, 1, degree + 1))


@functools.cache
def lobatto(degree):
    """Those of the mesh: zeros of (1 - s^2) P'_degree, on [0, 1]."""
    inner = legendre.legroots(legendre.legder([0] * degree + [1]))
    return Element(numpy.concatenate([[0], (1 + numpy.sort(inner)) / 2, [1]]))


class Element:
    """Lagrange polynomials on nodes of [0, 1]; points and weights of Gauss."""

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

    def derivatives(self, s):
        c = 2 * legendre.legder(self.coefficients)
        return legendre.legvander(2 * numpy.asarray(s) - 1, len(c) - 1) @ c
