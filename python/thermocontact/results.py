# SPDX-License-Identifier: LGPL-2.1-or-later
"""Output directories: of a run, and of a study."""

import json
import xml.etree.ElementTree
from functools import cached_property
from pathlib import Path

from .errors import Error
from .table import read_table


class _Directory:
    """Files of an output directory, read when they are first asked for.

    directory: a pathlib.Path. A temporary one lasts as long as this object.
    """

    def __init__(self, directory, temporary=None):
        self.directory = Path(directory)
        self._temporary = temporary

    def __repr__(self):
        return f"<{type(self).__name__.lower()} in {self.directory}>"

    @cached_property
    def used(self):
        """used.prm: all entries as the program used them, as a text."""
        return (self.directory / "used.prm").read_text(encoding="utf-8")

    @cached_property
    def log(self):
        """What the screen showed."""
        return (self.directory / "log.txt").read_text(encoding="utf-8")


class Run(_Directory):
    """What one run wrote; a table that the scene does not have is an Error.

    contact, events, steps, probes: Tables.
    """

    contact = cached_property(lambda self: read_table(self.directory / "contact.csv"))
    events = cached_property(lambda self: read_table(self.directory / "events.csv"))
    steps = cached_property(lambda self: read_table(self.directory / "steps.csv"))
    probes = cached_property(lambda self: read_table(self.directory / "probes.csv"))

    @cached_property
    def summary(self):
        """summary.json: a dict; None stands for what there is not."""
        return json.loads((self.directory / "summary.json").read_text(encoding="utf-8"))

    @cached_property
    def snapshots(self):
        """Times and files of the fields, in order: a list of (float, Path)."""
        return self._collection("fields.pvd")

    def _collection(self, name):
        path = self.directory / name
        if not path.exists():
            return []
        root = xml.etree.ElementTree.parse(path).getroot()
        return [(float(entry.get("timestep")), self.directory / entry.get("file"))
                for entry in root.iter("DataSet")]

    def fields(self, i=-1):
        """Snapshot number i as a meshio.Mesh: points, point_data by name."""
        import meshio
        if not self.snapshots:
            raise Error(f"{self.directory}: no snapshots; set Output/Fields interval")
        return meshio.read(self.snapshots[i][1])


class Study(_Directory):
    """What a study wrote.

    table: study.csv, a Table with a row for each run that has ended.
    """

    table = cached_property(lambda self: read_table(self.directory / "study.csv"))

    def run(self, number):
        """The files of a run, with Study/Keep files = true."""
        return read(self.directory / f"run-{number}")


def read(directory, temporary=None):
    """The Run or the Study in an output directory."""
    directory = Path(directory)
    if (directory / "study.csv").exists():
        return Study(directory, temporary)
    if (directory / "contact.csv").exists():
        return Run(directory, temporary)
    raise Error(f"{directory}: no contact.csv and no study.csv: not an output directory")
