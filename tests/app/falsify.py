# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of the columns and keys of a run, and the test that they can fail.

A check is a generator of faults; the names of the columns and keys that it knows are
registered with it ("contact.csv/gap", "summary.json/steps"). A column or key that no
check knows is a fault. Then each column and key is falsified, one way at a time (see
falsify_table, falsify_key), and the checks have to find a fault.
"""
import math

import numpy

ROUNDING = 1e-10  # smaller numbers are falsified by adding to them alone
UNKNOWN = "has no check: add one beside its neighbours in tests/app"


class Checks:
    """A list of checks and the names that they know."""

    def __init__(self):
        self.checks = []
        self.known = {}

    def __call__(self, *names):
        def register(function):
            self.checks.append((set(names), function))
            for name in names:
                self.known.setdefault(name, []).append(function.__name__)
            return function
        return register

    def faults(self, run, first=""):
        """Faults of a run, those of the checks that know the name first at first."""
        yield from self.unknown(run)
        for names, function in sorted(self.checks, key=lambda c: first not in c[0]):
            try:
                yield from (f"{function.__name__}: {fault}" for fault in function(run)
                            if fault)
            except (KeyError, IndexError, ValueError, TypeError, AttributeError,
                    AssertionError, numpy.linalg.LinAlgError) as error:
                yield f"{function.__name__}: {type(error).__name__} {error}"

    def unknown(self, run):
        for name in names_of(run):
            if name not in self.known and not (
                    "/" in name.partition("/")[2] and "study.csv/*" in self.known):
                yield f"{name} {UNKNOWN}"


def names_of(run):
    names = [f"{file}/{column}" for file, table in run.tables.items()
             for column in table.names]
    return names + [f"summary.json/{key}" for key in run.summary or {}]


def falsify_numbers(values):
    """Ways to falsify a column of numbers."""
    if not (abs(values) > 1e-3 * ROUNDING).any():
        yield ("zero instead of nan", 0 * numpy.ones_like(values)) if numpy.isnan(
            values).any() else ("1e-3 instead of zero", values + 1e-3)
        return
    yield "times 1.001", values * 1.001
    yield "with the other sign", -values
    yield "one row late", numpy.concatenate([values[:1], values[:-1]])
    yield "one row early", numpy.concatenate([values[1:], values[-1:]])
    if len(values) > 1 and abs(values[-1]) > ROUNDING * numpy.nansum(abs(values)):
        yield "zero in the last row", numpy.concatenate([values[:-1], [0.0]])
    if numpy.isnan(values).any():
        yield "zero instead of nan", numpy.nan_to_num(values)


def falsify_texts(values):
    """Ways to falsify a column of words."""
    yield "one row late", values[:1] + values[:-1]
    words = sorted(set(values)) + ["another"]
    for i, word in enumerate(words[:-1]):
        other = words[(i + 1) % len(words)]
        yield f"{other} for {word}", [other if v == word else v for v in values]


def falsify_table(run, file):
    """Copies of a run with one fault in a table, and what it is."""
    table = run.tables[file]
    for column in table.names:
        values = table[column]
        is_text = isinstance(values, list)
        for way, false in (falsify_texts if is_text else falsify_numbers)(values):
            if is_text and false == values or not is_text and numpy.array_equal(
                    false, values, equal_nan=True):
                continue
            other = run.copy()
            other.tables[file].columns[column] = false
            yield f"{file}/{column}", way, other
        other = run.copy()
        del other.tables[file].columns[column]
        other.tables[file].names.remove(column)
        yield f"{file}/{column}", "missing", other
    for row in sorted({0, len(table) // 2, len(table) - 1} if len(table) else ()):
        other = run.copy()
        other.tables[file].keep(numpy.arange(len(table)) != row)
        yield f"{file}/{table.names[0]}", f"without row {row}", other
    other = run.copy()
    other.tables[file].names.append("new")
    yield f"{file}/new", "a new column", other


def falsify_value(value):
    """Ways to falsify the value of a key."""
    if isinstance(value, bool):
        yield "the opposite", not value
    elif isinstance(value, str):
        yield "another word", value + "x"
    elif isinstance(value, list):
        yield "one more", value + ["another"]
        if value:
            yield "one less", value[:-1]
    elif value is None:
        yield "0.5 instead of null", 0.5
    else:
        yield "null", None
        yield "+ 1", value + 1
        if isinstance(value, float) and abs(value) > ROUNDING:
            yield "times 1.001", value * 1.001
            yield "with the other sign", -value


def falsify_keys(run):
    """Copies of a run with one fault in summary.json, and what it is."""
    for key, value in (run.summary or {}).items():
        for way, false in falsify_value(value):
            other = run.copy()
            other.summary[key] = false
            yield f"summary.json/{key}", way, other
        other = run.copy()
        del other.summary[key]
        yield f"summary.json/{key}", "missing", other
    if run.summary:
        other = run.copy()
        other.summary["new"] = 0
        yield "summary.json/new", "a new key", other


def falsified(run):
    """Copies of a run with one fault each, and what it is."""
    yield from falsify_keys(run)
    for file in run.tables:
        yield from falsify_table(run, file)


def test_noticing(checks, run, exempt, named_faults=()):
    """Counts of falsifications that were noticed, and names of those that were not.

    exempt: (name, way) pairs that no check can notice. named_faults: pairs of a name
    and a copy of the run with that fault.
    """
    noticed, missed = 0, []
    for name, way, other in [*falsified(run), *(
            ("", name, other) for name, other in named_faults)]:
        if next(checks.faults(other, name), None):
            noticed += 1
        elif (name, way) not in exempt:
            missed.append(f"{name} {way}")
    return noticed, missed


def report(checks, run, exempt, name_faults, bound):
    """The verdict line of a run; name_faults(run) yields its named faults."""
    faults = list(checks.faults(run))
    if faults:
        for fault in faults[:10]:
            print(fault)
        return
    named_faults = list(name_faults(run))
    named = [name for name, _ in named_faults]
    noticed, missed = test_noticing(checks, run, exempt, named_faults)
    print(f"columns and keys as recomputed, to {bound}; falsified one at a time"
          f"{', with ' + ', '.join(named) if named else ''}: "
          f"{'all noticed' if noticed and not missed else f'{missed} not noticed'}")


def is_count(value):
    return isinstance(value, (int, float)) and math.isfinite(value) and value == int(value)
