# SPDX-License-Identifier: LGPL-2.1-or-later
"""The snapshots of a strip as polynomials on its cells, and integrals of them.

A snapshot has (p + 1)^2 equidistant points for each cell, which hold a field of degree p.
"""
import numpy

from polynomials import equidistant, lobatto


class Snapshot:
    """Fields by cell, [cell, i_y, i_x], with components last; single precision."""

    def __init__(self, time, mesh, degree):
        self.time, q = time, degree + 1
        self.element = equidistant(degree)
        points = mesh.points.reshape(-1, q, q, mesh.points.shape[1]).astype(float)
        assert (numpy.diff(points[..., 0], axis=2) > 0).all(), "x is not the fastest"
        assert (numpy.diff(points[..., 1], axis=1) > 0).all(), "y is not the slowest"
        self.corner = points[:, 0, 0, :2]
        self.size = points[:, -1, -1, :2] - self.corner
        self.fields = {name: values.reshape(len(points), q, q, -1).astype(float)
                       for name, values in mesh.point_data.items()}
        if "stress" in self.fields:
            shape = self.fields["stress"].shape[:3]
            self.fields["stress"] = self.fields["stress"].reshape(*shape, 3, 3)
            for name in ("displacement", "velocity"):
                self.fields[name] = self.fields[name][..., :2]

    def gradient(self, name):
        """d(component)/d(x or y) at the points, [cell, i_y, i_x, component, direction]"""
        G = self.element.derivatives(self.element.nodes)
        values = self.fields[name]
        along = numpy.einsum("ij,cyjk->cyik", G, values)
        across = numpy.einsum("ij,cjxk->cixk", G, values)
        h = self.size[:, None, None, None]
        return numpy.stack([along / h[..., 0], across / h[..., 1]], axis=-1)

    def strain(self, name):
        gradient = self.gradient(name)
        return (gradient + gradient.swapaxes(-1, -2)) / 2

    def integral(self, f, g):
        """Integral over the body of the product of two arrays of values at the points"""
        e = self.element
        B = e.values(e.points)
        at_gauss = [numpy.einsum("iy,jx,cyx->cij", B, B, values) for values in (f, g)]
        cells = numpy.einsum("i,j,cij->c", e.weights, e.weights, at_gauss[0] * at_gauss[1])
        return cells @ self.size.prod(axis=1)

    def at_contact_nodes(self, name):
        """Values at the Gauss-Lobatto nodes of the end x = 1, and weights of sum 1"""
        at_end = numpy.flatnonzero(abs(self.corner[:, 0] + self.size[:, 0] - 1) < 1e-5)
        of_mesh = lobatto(self.element.n - 1)
        basis = self.element.values(of_mesh.nodes)
        values = [basis @ self.fields[name][cell, :, -1, 0] for cell in at_end]
        weights = [of_mesh.integrals * self.size[cell, 1] for cell in at_end]
        weights = numpy.concatenate(weights)
        return numpy.concatenate(values), weights / weights.sum()

    def contact_node_heights(self):
        """y of these nodes"""
        at_end = numpy.flatnonzero(abs(self.corner[:, 0] + self.size[:, 0] - 1) < 1e-5)
        nodes = lobatto(self.element.n - 1).nodes
        return numpy.concatenate([self.corner[cell, 1] + nodes * self.size[cell, 1]
                                  for cell in at_end])

    def value_at(self, name, x, y):
        """The axial component at a place, from a cell that it lies in"""
        place = numpy.array([x, y])
        s = (place - self.corner) / self.size
        cell = numpy.argmax(((s > -1e-5) & (s < 1 + 1e-5)).all(axis=1))
        values = self.fields[name][cell]
        values = values[..., 0, 0] if name == "stress" else values[..., 0]
        along, across = self.element.values(s[cell])
        return across @ values @ along


def stress_of(strain, nu):
    """(M1.6): lambda tr(e) I + 2 mu e"""
    trace = numpy.trace(strain, axis1=-2, axis2=-1)[..., None, None] * numpy.eye(2)
    return nu / (1 - nu) * trace + (1 - 2 * nu) / (1 - nu) * strain
