# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs thermocontact from Python and reads what it writes.

    import thermocontact
    run = thermocontact.run({"Contact/Compliance": 0.1},
                            base="prm/paper/experiment-1.prm")
    run.contact["contact_force"].max(), run.summary["first_contact_time"]

Entries are named "Section/Entry" as in doc/parameters.md; values are numbers, truths
or texts. A study is a run with "Study/Vary". numpy is needed; pandas, scipy and meshio
are used where they are asked for. Numbers are those of the files: in SI units if the scene
has section Rod, whose entries may have units ("Contact/Gap": "30 um"), or Scales, and
table.units tells them; else nondimensional. study() runs many scenes, fit() finds entries
from a measurement (scipy). What the program warns of is a RunWarning, and in run.warnings.
"""

from .errors import ComputationError, Error, InputError, RunWarning
from .fitting import Fit, fit
from .program import find_program, run, study
from .results import Run, Study, read
from .table import Table, read_table

__all__ = ["ComputationError", "Error", "Fit", "InputError", "Run", "RunWarning", "Study", "Table",
           "find_program", "fit", "read", "read_table", "run", "study"]
