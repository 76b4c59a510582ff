# SPDX-License-Identifier: LGPL-2.1-or-later
"""The CSV tables of the program, which all have the same head."""

import csv
from collections.abc import Mapping
from pathlib import Path

import numpy

from .errors import Error
from .optional import optional_module


UNITS = "units:"


def as_array(words):
    """Numbers where all words are numbers ("nan" is one), else texts."""
    try:
        return numpy.array([float(word) for word in words])
    except ValueError:
        return numpy.array(words)


def _units_of(comments, names):
    """From the comment "units: ...", whose fields are those of a row."""
    line = next((c[len(UNITS):] for c in comments if c.startswith(UNITS)), None)
    if line is None:
        return {}
    units = next(csv.reader([line.strip(" ")]))
    return {name: unit for name, unit in zip(names, units) if unit}


class Table(Mapping):
    """Columns by name, one-dimensional arrays of the same length.

    comments: the lines with "#" above the names, the first one is the title.
    units: of the columns that have one, by name; empty if numbers are nondimensional.
    n_rows: the number of rows.
    """

    def __init__(self, columns, comments=()):
        self._columns = columns
        self.comments = list(comments)
        self.units = _units_of(self.comments, columns)
        self.n_rows = len(next(iter(columns.values()), ()))

    def __getitem__(self, name):
        try:
            return self._columns[name]
        except KeyError:
            raise KeyError(f"no column {name!r}; there are "
                           f"{', '.join(self._columns)}") from None

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        return len(self._columns)

    def __repr__(self):
        return f"<{self.n_rows} rows of {', '.join(self._columns)}>"

    def to_pandas(self):
        """The same as a pandas.DataFrame; attrs["units"] has the units."""
        frame = optional_module("pandas", "python3-pandas").DataFrame(dict(self))
        frame.attrs["units"] = dict(self.units)
        return frame


def read_table(path):
    """A CSV file as a Table; a last row that is not written to its end is left out."""
    path = Path(path)
    try:
        lines = path.read_text(encoding="utf-8").split("\n")[:-1]
    except OSError as error:
        raise Error(f"{path}: {error.strerror}") from error
    comments = [line[1:].strip() for line in lines if line.startswith("#")]
    rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    if not rows:
        raise Error(f"{path}: no line of names")
    names, rows = rows[0], [row for row in rows[1:] if len(row) == len(rows[0])]
    columns = zip(*rows) if rows else [()] * len(names)
    return Table({name: as_array(column) for name, column in zip(names, columns)},
                 comments)
