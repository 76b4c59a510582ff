# SPDX-License-Identifier: LGPL-2.1-or-later
"""Output directories: of a run, and of a study."""

import json
import shutil
import subprocess
import sys
import xml.etree.ElementTree
from functools import cached_property
from pathlib import Path

from .errors import Error
from .optional import optional_module
from .table import read_table


def _plot_script():
    """scripts/plot of the sources, or of an installation."""
    script = Path(__file__).resolve().parents[2] / "scripts/plot"
    installed = shutil.which("thermocontact-plot")
    if script.exists() or installed:
        return str(script if script.exists() else installed)
    raise Error("scripts/plot is not beside the module and thermocontact-plot is not in "
                "PATH: install the program, or use the module of its sources")


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

    def plot(self, figure=None, output=None, **options):
        """Pictures by scripts/plot, a list of their paths.

        figure: the name of one picture; None: all that can be drawn.
        output: a file or a directory; None: the directory of the run or study.
        options: of scripts/plot, end_time=1 for --end-time 1.
        """
        command = [sys.executable, _plot_script(), str(self.directory)]
        for name, value in {"figure": figure, "output": output, **options}.items():
            if value is not None:
                command += [f"--{name.replace('_', '-')}", str(value)]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            raise Error(done.stderr.strip())
        return [Path(line[len("wrote "):]) for line in done.stdout.splitlines()
                if line.startswith("wrote ")]


class Run(_Directory):
    """What one run wrote; a table that the scene does not have is an Error.

    contact, events, steps, probes, boundaries, poincare: Tables; the last one has a row for
    each Output/Period. contacts: a dict of Tables, one for each contact of a row of bodies.
    """

    contact = cached_property(lambda self: read_table(self.directory / "contact.csv"))
    events = cached_property(lambda self: read_table(self.directory / "events.csv"))
    steps = cached_property(lambda self: read_table(self.directory / "steps.csv"))
    probes = cached_property(lambda self: read_table(self.directory / "probes.csv"))
    boundaries = cached_property(lambda self: read_table(self.directory / "boundaries.csv"))
    poincare = cached_property(lambda self: read_table(self.directory / "poincare.csv"))

    @cached_property
    def contacts(self):
        """contacts/*.csv of a row of bodies: a dict {"LEFT-RIGHT": Table}, empty without a row."""
        return {file.stem: read_table(file) for file in sorted((self.directory / "contacts").glob("*.csv"))}

    @cached_property
    def summary(self):
        """summary.json: a dict; None stands for what there is not."""
        return json.loads((self.directory / "summary.json").read_text(encoding="utf-8"))

    @property
    def warnings(self):
        """What the program warned of: a list of texts."""
        return self.summary["warnings"]

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

    def _mesh(self, name, i):
        meshio = optional_module("meshio", "python3-meshio")
        files = self._collection(name)
        if not files:
            raise Error(f"{self.directory}: no {name}; set Output/Fields interval")
        return meshio.read(files[i][1])

    def fields(self, i=-1):
        """Snapshot number i as a meshio.Mesh: points, point_data by name."""
        return self._mesh("fields.pvd", i)

    def contact_face(self, i=-1):
        """The contact face of a body in 2-D or 3-D at snapshot number i: a meshio.Mesh
        with pressure and gap."""
        return self._mesh("contact.pvd", i)


class Study(_Directory):
    """What a study wrote.

    table: study.csv, a Table with a row for each run that has ended.
    """

    table = cached_property(lambda self: read_table(self.directory / "study.csv"))

    @property
    def warnings(self):
        """What the program warned of: a dict {text: [numbers of the runs]}."""
        runs = {}
        for number, texts in zip(self.table["run"], self.table["warning_texts"]):
            for text in filter(None, str(texts).split(" | ")):
                runs.setdefault(text, []).append(int(number))
        return runs

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
