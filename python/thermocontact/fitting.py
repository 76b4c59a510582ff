# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries of a scene from a measurement."""

from concurrent.futures import ThreadPoolExecutor
import os

import numpy

from .errors import Error
from .optional import optional_module
from .program import run_silently, issue_warnings
from .table import Table


class Fit:
    """What fit() has found.

    values, errors: dicts, an entry and its standard error.
    covariance, correlation: arrays, in the order of values.
    chi_square: the sum of the squared residuals over the standard deviations;
        chi_square / degrees_of_freedom is near 1 if the scene explains the measurement.
        Without deviations the sum of the squared residuals.
    sensitivities: a Table: for each measured number the column it is in, its time, and
        what an entry changes it by, d column / d log(entry).
    run: the Run at these values. n_runs: how many there were.
    """

    def __init__(self, values, covariance, chi_square, data, sensitivities, best, n_runs):
        self.values = values
        self.covariance = covariance
        deviations = numpy.sqrt(numpy.diag(covariance))
        self.errors = dict(zip(values, deviations))
        self.correlation = covariance / numpy.outer(deviations, deviations)
        self.chi_square = chi_square
        self.degrees_of_freedom = len(data.values) - len(values)
        self.has_deviations = data.has_deviations
        self.sensitivities = sensitivities
        self.run = best
        self.n_runs = n_runs

    def __str__(self):
        width = max(map(len, self.values))
        lines = [f"{name:{width}}  {value:.6g} +- {self.errors[name]:.2g}"
                 for name, value in self.values.items()]
        names = list(self.values)
        for i in range(len(names)):
            lines += [f"correlation of {names[j]} and {names[i]}: "
                      f"{self.correlation[i, j]:.3f}" for j in range(i)]
        quality = (f"chi^2/dof {self.chi_square:.6g}/{self.degrees_of_freedom}"
                   if self.has_deviations else "residuals of a standard deviation of "
                   f"{(self.chi_square / self.degrees_of_freedom) ** 0.5:.3g}")
        return "\n".join([*lines, f"{quality}, {self.n_runs} runs"])


class _Measurement:
    """All measured numbers, one after the other."""

    def __init__(self, measured):
        self.columns, times, values, deviations = [], [], [], []
        for column, numbers in measured.items():
            time, value, *deviation = (numpy.asarray(n, float) for n in numbers)
            if time.ndim != 1 or time.shape != value.shape or len(deviation) > 1:
                raise Error(f"measured[{column!r}]: times and values of the same length, "
                            "and perhaps a standard deviation, are wanted")
            self.columns += [column] * len(time)
            times.append(time)
            values.append(value)
            deviations.append(numpy.broadcast_to(
                deviation[0] if deviation else numpy.nan, time.shape))
        self.parts = list(zip(measured, times))
        self.times = numpy.concatenate(times)
        self.values = numpy.concatenate(values)
        deviations = numpy.concatenate(deviations)
        self.has_deviations = bool(numpy.all(deviations > 0))
        if not self.has_deviations and not numpy.all(numpy.isnan(deviations)):
            raise Error("a standard deviation is positive, and given for all columns or "
                        "none")
        self.deviations = deviations if self.has_deviations else numpy.ones_like(deviations)

    def model(self, contact):
        """The same numbers from the table of a run."""
        pchip = optional_module("scipy.interpolate", "python3-scipy").PchipInterpolator
        time = contact["time"]
        for column, at in self.parts:
            if len(at) > 0 and not (time[0] <= at.min() and at.max() <= time[-1] * (1 + 1e-12)):
                raise Error(f"measured[{column!r}]: times from {at.min():g} to {at.max():g}, and "
                            f"the run has {time[0]:g} to {time[-1]:g}: another Time/End time, or "
                            "times in the unit of contact.csv")
        last = numpy.append(time[1:] > time[:-1], True)  # of the rows of a time
        return numpy.concatenate([
            pchip(time[last], contact[column][last])(numpy.clip(at, time[0], time[-1]))
            for column, at in self.parts])


def fit(unknowns, measured, base=None, entries=None, step=0.01, processes=None,
        **options):
    """Finds entries with which a scene meets a measurement: least squares by
    scipy.optimize.least_squares, over the logarithms of the entries.

    unknowns: a dict {"Section/Entry": a positive first guess}, a number or a text with
        the unit in which it is found, "5e6 N/m".
    measured: a dict {column of contact.csv: (times, values) or (times, values, standard
        deviation)}, in the units of the files. Without deviations the errors follow from
        the residuals.
    base, entries: the scene, as of run().
    step: relative change of an entry for central differences.
    processes: runs at once; None: as many as there are processors.
    options: of least_squares, such as xtol or max_nfev.
    """
    least_squares = optional_module("scipy.optimize", "python3-scipy").least_squares
    names = list(unknowns)
    texts = [str(unknowns[name]).strip().partition(" ") for name in names]
    units = [unit.strip() for _, _, unit in texts]
    try:
        guess = numpy.array([float(number) for number, _, _ in texts])
    except ValueError as fault:
        raise Error(f"unknowns: {fault}: numbers are wanted, perhaps with a unit behind a "
                    "blank, '5e6 N/m'") from None
    if not names or not numpy.all(guess > 0):
        raise Error("unknowns: positive first guesses are wanted, and at least one")
    data = _Measurement(measured)
    if len(data.values) <= len(names):
        raise Error(f"{len(data.values)} measured numbers for {len(names)} unknowns: more "
                    "are wanted")
    known = {}

    def run_at(x):
        scene = {**(entries or {}),
                 **{name: f"{value!r} {unit}".strip() for name, value, unit in
                    zip(names, map(float, guess * numpy.exp(x)), units)}}
        scene.setdefault("Output/Fields interval", 0)
        return run_silently(scene, base=base)

    def model(x):
        key = tuple(x)
        if key not in known:
            known[key] = data.model(run_at(x).contact)
        return known[key]

    def residuals(x):
        return (model(x) - data.values) / data.deviations

    with ThreadPoolExecutor(processes or os.cpu_count()) as pool:
        def slopes(x):
            """d model / d x, by column."""
            changes = step * numpy.eye(len(names))
            models = list(pool.map(model, [*(x + changes), *(x - changes)]))
            half = len(names)
            return numpy.column_stack([(models[i] - models[half + i]) / (2 * step)
                                       for i in range(half)])

        found = least_squares(
            residuals, numpy.zeros(len(names)),
            jac=lambda x: slopes(x) / data.deviations[:, None],
            **{"xtol": 1e-6, "ftol": 1e-8, "x_scale": "jac", **options})
        sensitivities = slopes(found.x)
    if not found.success:
        raise Error(f"the fit has not converged: {found.message}")
    chi_square = float(found.fun @ found.fun)
    weighted = sensitivities / data.deviations[:, None]
    normal = weighted.T @ weighted
    if numpy.linalg.cond(normal) > 1e14:
        raise Error("the measurement does not tell the entries apart: " + ", ".join(names))
    values = guess * numpy.exp(found.x)
    scale = 1 if data.has_deviations else chi_square / (len(data.values) - len(names))
    covariance = scale * numpy.linalg.inv(normal) * numpy.outer(values, values)
    table = Table({"column": numpy.array(data.columns), "time": data.times,
                   **dict(zip(names, sensitivities.T))})
    best = run_at(found.x)
    issue_warnings(best)
    return Fit(dict(zip(names, map(float, values))), covariance, chi_square, data, table,
               best, len(known) + 1)
