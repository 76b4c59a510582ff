# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rod in SI units: its scene, and the factors that turn results back."""

import fnmatch
import re
import subprocess
from pathlib import Path

from .errors import ComputationError, Error, InputError
from .program import command_of, find_program

_FACTOR = re.compile(r"# +(?P<names>[a-z_*][a-z_*, ]*?)(, then add (?P<offset>\S+))?"
                     r" {2,}(?P<factor>[-+.\deE]+) +(?P<unit>.*)")


# factor and offset of the units that tables of results may have
_SI = {**dict.fromkeys(["m", "m/s", "Pa", "N", "N s", "N m", "J", "W/m^2", "s", "K"],
                       (1, 0)),
       "us": (1e-6, 0), "ms": (1e-3, 0), "min": (60, 0), "h": (3600, 0), "\u00b0C": (1, 273.15)}


class Units:
    """What `thermocontact --units FILE` prints.

    scene: the parameter file, a text; run(base=units.write(path)) runs it.
    """

    def __init__(self, scene):
        self.scene = scene
        table = scene.partition("# Columns of contact.csv in SI units")[2]
        self._factors = []
        for line in table.partition("\n\n")[0].splitlines():
            if match := _FACTOR.match(line):
                for name in match["names"].split(", "):
                    self._factors.append((name, float(match["factor"]), match["unit"],
                                          float(match["offset"] or 0)))

    def _find(self, column):
        for name, factor, unit, offset in self._factors:
            if fnmatch.fnmatchcase(column, name):
                return factor, unit, offset
        raise Error(f"{column} has no unit: it is a number, or not in contact.csv")

    def unit(self, column):
        """Such as "N" of contact_force."""
        return self._find(column)[1]

    def factor(self, column):
        """SI units in one unit of the scene, without what is added to a temperature."""
        return self._find(column)[0]

    def in_si(self, table, column):
        """A column of contact.csv in SI units; times in seconds, temperatures in kelvin,
        whatever the units of the table are."""
        factor, _, offset = self._find(column)
        unit = getattr(table, "units", {}).get(column)
        if unit:
            factor, offset = _SI[unit]
        return factor * table[column] + offset

    def write(self, path):
        """Writes the scene and returns the path."""
        path = Path(path)
        path.write_text(self.scene, encoding="utf-8")
        return path


def read_units(base, entries=None, program=None):
    """The Units of a file with a rod in SI units; entries are those of doc/units.md.

    Raises InputError or ComputationError with the program's message.
    """
    command = command_of(program or find_program(), entries)
    result = subprocess.run([*command, "--units", str(base)], capture_output=True,
                            text=True, check=False)
    message = result.stderr.partition("thermocontact: ")[2].strip()
    if result.returncode == 2:
        raise InputError(message)
    if result.returncode != 0:
        raise ComputationError(message or f"exit status {result.returncode}")
    return Units(result.stdout)
