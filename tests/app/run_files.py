# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of an output directory, as the checks of columns and keys read them."""
import copy
import csv
import json
import math
import re
import xml.etree.ElementTree as xml
from pathlib import Path

import numpy

FUNCTIONS = {"abs": numpy.abs, "if_": numpy.where, "min": numpy.minimum, "max": numpy.maximum} | {
    name: getattr(numpy, name) for name in ("sin", "cos", "exp", "sqrt", "tanh", "pi")}
TEXT_COLUMNS = ("kind", "reason", "status", "side", "contact", "warning_texts")


class Table:
    """Columns of a CSV file, numbers as arrays, text as lists; its comments."""

    def __init__(self, path):
        lines = path.read_text(encoding="utf-8").splitlines()
        self.comments = [line[2:] for line in lines if line.startswith("# ")]
        rows = list(csv.reader(line for line in lines if not line.startswith("#")))
        self.names = rows[0]
        self.columns = {}
        for name, values in zip(self.names, zip(*rows[1:]) if rows[1:] else
                                [()] * len(rows[0])):
            is_text = name in TEXT_COLUMNS or "/" in name
            self.columns[name] = (list(values) if is_text else
                                  numpy.array([float(value) for value in values]))

    def __getitem__(self, name):
        return self.columns[name]

    def __len__(self):
        return len(self.columns[self.names[0]])

    def copy(self):
        """A table whose columns can be replaced."""
        other = copy.copy(self)
        other.names, other.columns = list(self.names), dict(self.columns)
        return other

    def keep(self, mask):
        """Leaves out the rows for which mask is false."""
        for name, values in self.columns.items():
            self.columns[name] = (values[mask] if isinstance(values, numpy.ndarray) else
                                  [value for value, kept in zip(values, mask) if kept])


def read_mesh(path):
    """A file of VTK; half a second of loading for those that read one."""
    import meshio
    return meshio.read(path)


def compiled(expression):
    """An expression of an entry as one of Python."""
    return compile(expression.replace("^", "**").replace("if(", "if_("), expression, "eval")


class Settings(dict):
    """The entries of a file used.prm as "Section/Entry"; others are absent, and remarks
    behind values."""

    def __init__(self, path):
        super().__init__()
        section = ""
        for line in path.read_text(encoding="utf-8").splitlines():
            if match := re.match(r"subsection (.*)", line):
                section = match[1] + "/"
            elif line == "end":
                section = ""
            elif match := re.match(r" *set (.*?) *=\s*(.*)", line):
                self[section + match[1]] = match[2].split(" # ")[0].strip()

    def has_error_control(self):
        """Steps follow a tolerance; those of the scheme box are automatic, too."""
        return self["Time/Step size"] == "automatic" and self["Time/Scheme"] != "box"

    def step_size(self):
        """One that is fixed."""
        return (self.number("Time/Step size") if self["Time/Step size"] != "automatic" else
                self.number("Model/Inertia")**0.5 / self.number("Mesh/Cells") /
                2**self.number("Mesh/Refinements"))

    def number(self, name, default=0.0):
        """A number; default if the scene has no such entry."""
        return float(self.get(name, default))

    def expression(self, name):
        """A function of numpy arrays x and a number t."""
        code = compiled(self.get(name, "0"))
        theta_A = eval(compiled(self.get("Boundary/left/Temperature", "0")),
                       FUNCTIONS | {"t": 0.0})

        def value(x, t=0.0, **names):
            return eval(code, FUNCTIONS | names | {
                "x": x, "t": t, "theta_A": theta_A}) + 0.0 * x
        return value

    def has(self, field):
        return field in self["Model/Fields"]


class Run:
    """A run: settings, tables by name, summary, log."""

    def __init__(self, directory):
        self.directory = Path(directory)
        self.settings = Settings(self.directory / "used.prm")
        self.tables = {path.name: Table(path)
                       for path in sorted(self.directory.glob("*.csv"))}
        self.read_snapshots, self.read_space_time = {}, None
        self.summary = None
        if (self.directory / "summary.json").exists():
            self.summary = json.loads(
                (self.directory / "summary.json").read_text(encoding="utf-8"))
        log = self.directory / "log.txt"
        self.log = log.read_text(encoding="utf-8") if log.exists() else ""

    def copy(self):
        """A run whose columns and keys can be replaced."""
        other = copy.copy(self)
        other.tables = {name: table.copy() for name, table in self.tables.items()}
        other.summary = dict(self.summary) if self.summary else self.summary
        return other

    def __getattr__(self, name):
        """run.contact, run.events, ...: the tables."""
        tables = self.__dict__.get("tables", {})
        if name + ".csv" in tables:
            return tables[name + ".csv"]
        raise AttributeError(name)

    def has_table(self, name):
        return name + ".csv" in self.tables

    def probe_positions(self):
        """Coordinates of the probes, from the comments of probes.csv."""
        return [tuple(float(number) for number in re.findall(r"= ([^,]*)", comment))
                for comment in self.probes.comments if comment.startswith("probe ")]

    def snapshots(self, name="fields.pvd"):
        """Time and mesh of each snapshot of an index. Its file has the same time, to the six
        digits of TIME, and its number, which readers of meshes leave out; but for obstacles."""
        if name not in self.read_snapshots:
            index = self.directory / name
            self.read_snapshots[name] = []
            for number, entry in enumerate(xml.parse(index).findall(".//DataSet")
                                           if index.exists() else []):
                path, time = self.directory / entry.get("file"), float(entry.get("timestep"))
                told = dict(re.findall(r'Name="(TIME|CYCLE)"[^>]*>\s*([^<\s]+)',
                                       path.read_text(encoding="latin1")))
                is_right = int(told.get("CYCLE", 0)) == number and math.isclose(
                    float(told.get("TIME", 0)), time, rel_tol=1e-5)
                if not is_right and name != "obstacle.pvd":
                    raise ValueError(f"{path}: {told}, and in {name} number {number} at {time}")
                self.read_snapshots[name].append((time, read_mesh(path)))
        return self.read_snapshots[name]

    def space_time(self):
        """The mesh of the space-time file, or None"""
        path = self.directory / "space-time.vtu"
        if self.read_space_time is None and path.exists():
            self.read_space_time = read_mesh(path)
        return self.read_space_time


def due(times, interval, end_time):
    """True at the first of the times at or after each multiple, and at the end."""
    if interval == 0:
        return numpy.ones(len(times), bool)
    counts = numpy.floor(numpy.asarray(times) / interval + 1e-9)
    is_due = numpy.diff(counts, prepend=-1) > 0
    return is_due | (numpy.asarray(times) >= end_time)


def with_first_contact(is_due, contact, events):
    """The same, with the row of the first contact: the first one in contact, or, of a contact
    that is over at its end, the row at or after the event; the end of a step may miss it, by
    less than a hundredth of the next step."""
    is_shown, times = numpy.array(is_due), contact["time"]
    if len(events["time"]):
        row = int(numpy.searchsorted(times, events["time"][0]))
        row = min(row, len(times) - 1)
        row -= row > 0 and events["time"][0] - times[row - 1] < 0.01 * (times[row] - times[row - 1])
        is_shown[min([row, *numpy.flatnonzero(contact["in_contact"])[:1]])] = True
    return is_shown


def differences(found, expected, bound, scale=None):
    """Where numbers differ by more than bound times scale, the largest expected one."""
    found, expected = numpy.asarray(found, float), numpy.asarray(expected, float)
    if found.shape != expected.shape:
        return f"{len(found)} values instead of {len(expected)}"
    if not numpy.array_equal(numpy.isnan(found), numpy.isnan(expected)):
        return "not a number elsewhere than expected"
    finite = ~numpy.isnan(expected)
    if not finite.any():
        return ""
    found, expected = found[finite], expected[finite]
    scale = scale or numpy.abs(expected).max()
    error = numpy.abs(found - expected)
    worst = numpy.argmax(numpy.where(numpy.isnan(error), numpy.inf, error))
    if error[worst] <= bound * scale + 1e-14:
        return ""
    return (f"value {worst} is {found[worst]:.10g} instead of {expected[worst]:.10g}, "
            f"bound {bound:g} of {scale:g}")


def nearly(found, expected, bound):
    """True for equal numbers, to bound in parts of the expected one; null for NaN."""
    if found is None or expected is None or math.isnan(expected):
        return found is None and (expected is None or math.isnan(expected))
    return abs(found - expected) <= bound * abs(expected) + 1e-14
