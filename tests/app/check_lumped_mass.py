#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heat and free vibrations of a rod with lumped mass, against its modes.

Cells of size 3/4 and 1/4, u = 0 at x = 0, nothing at x = 1. With the lumped mass
M = diag(sum of h w_i), w the Gauss-Lobatto weights in closed form, and the
stiffness K of Lagrange polynomials through the Gauss-Lobatto nodes, K q = l M q:
sums of modes decay like exp(-l t) and vibrate like cos(sqrt(l/b) t). The initial
values are polynomials in each cell, which the program represents exactly.
"""
import csv
import shutil
import sys
from math import sqrt
from pathlib import Path

import numpy as np
from numpy.polynomial import Polynomial
from scipy.linalg import eigh

sys.dont_write_bytecode = True
from program import for_all, run, settings  # noqa: E402

NODES = {  # of (0, 1), and their weights
    2: ([0, 1 / 2, 1], [1 / 6, 2 / 3, 1 / 6]),
    3: ([0, (1 - 1 / sqrt(5)) / 2, (1 + 1 / sqrt(5)) / 2, 1],
        [1 / 12, 5 / 12, 5 / 12, 1 / 12]),
    4: ([0, (1 - sqrt(3 / 7)) / 2, 1 / 2, (1 + sqrt(3 / 7)) / 2, 1],
        [1 / 20, 49 / 180, 16 / 45, 49 / 180, 1 / 20]),
}
CELLS = ((0.0, 0.75), (0.75, 1.0))
INERTIA = 2.0


def lagrange(nodes):
    return [Polynomial.fromroots(others) / Polynomial.fromroots(others)(node)
            for node in nodes
            for others in [[other for other in nodes if other != node]]]


def modes(degree):
    """Eigenvalues, and the modes at all nodes but x = 0, column by column."""
    nodes, weights = NODES[degree]
    slopes = [shape.deriv() for shape in lagrange(nodes)]
    local = np.array([[(a * b).integ()(1) for a in slopes] for b in slopes])
    n = degree * len(CELLS) + 1
    stiffness, mass = np.zeros((n, n)), np.zeros(n)
    for cell, (left, right) in enumerate(CELLS):
        own = slice(cell * degree, cell * degree + degree + 1)
        stiffness[own, own] += local / (right - left)
        mass[own] += np.array(weights) * (right - left)
    return eigh(stiffness[1:, 1:], np.diag(mass[1:]))


def expression(degree, values):
    """Of the piecewise polynomial with these values at the nodes but x = 0."""
    values = np.concatenate([[0], values])
    parts = []
    for cell, (left, right) in enumerate(CELLS):
        own = values[cell * degree:cell * degree + degree + 1]
        shape = sum(value * shape for value, shape in
                    zip(own, lagrange(NODES[degree][0])))
        shape = shape(Polynomial([-left, 1]) / (right - left))
        text = f"{shape.coef[-1]:.17g}"
        for coefficient in shape.coef[-2::-1]:
            text = f"({coefficient:.17g}+x*{text})"
        parts.append(text)
    return f"if(x<={CELLS[0][1]},{parts[0]},{parts[1]})"


def largest_error(case):
    """Of the end over time, relative to its first value; or why there is none."""
    fields, degree = case
    eigenvalues, vectors = modes(degree)
    # all modes, the lowest the largest, none zero at x = 1
    amounts = np.sign(vectors[-1]) / np.arange(1, len(eigenvalues) + 1)
    initial = expression(degree, vectors @ amounts)
    if fields == "temperature":
        scene = [f"Initial values/Temperature={initial}",
                 "Boundary/left/Temperature=0", "Boundary/right/Heat exchange=0"]
    else:
        scene = [f"Initial values/Displacement={initial}",
                 "Initial values/Velocity=0", "Contact/Condition=none",
                 "Model/Viscosity=0", f"Model/Inertia={INERTIA}"]
    directory = Path(f"{fields}-{degree}")
    status, _, message = run(
        "--quiet", "--output", directory, "defaults.prm", *settings([
            f"Model/Fields={fields}", f"Mesh/Degree={degree}", "Mesh/Cells=2",
            "Mesh/Grading=3", "Mesh/Mass matrix=lumped", "Time/Tolerance=1e-9",
            "Time/End time=0.5", "Output/Fields interval=0", *scene]))
    if status != 0:
        return message
    with open(directory / "contact.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(row for row in file if row[0] != "#"))
    shutil.rmtree(directory)
    t = np.array([[float(row["time"])] for row in rows])
    found = np.array([float(row[f"{fields}_end"]) for row in rows])
    factors = (np.exp(-eigenvalues * t) if fields == "temperature" else
               np.cos(np.sqrt(eigenvalues / INERTIA) * t))
    expected = factors @ (amounts * vectors[-1])
    assert len(t) > 10 and t[-1] == 0.5
    return float(max(abs(found - expected)) / expected[0])


def main():
    Path("defaults.prm").write_text("# defaults\n", encoding="utf-8")
    cases = [(fields, degree) for fields in ("temperature", "displacement")
             for degree in NODES]
    for (fields, degree), error in zip(cases, for_all(largest_error, cases)):
        # measured: at most 2e-10
        print(f"{fields}, degree {degree}:", "as its modes"
              if isinstance(error, float) and error < 1e-7 else
              f"off by {error}, allowed 1e-7")
    Path("defaults.prm").unlink()


main()
