# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls the program."""

import functools
import os
import re
import shutil
import subprocess
import tempfile
import warnings
from pathlib import Path

import numpy

from .errors import ComputationError, Error, InputError, RunWarning
from .results import read


def find_program():
    """The program: $THERMOCONTACT, that of the build beside this module, or in PATH."""
    build = Path(__file__).resolve().parents[2] / "build/release/thermocontact"
    candidates = [os.environ.get("THERMOCONTACT"), build, shutil.which("thermocontact")]
    for candidate in candidates:
        if candidate and os.access(candidate, os.X_OK):
            return str(candidate)
    raise Error("thermocontact is not built: call scripts/build Release, or set the "
                "environment variable THERMOCONTACT to the program")


def _word(value):
    """A value as a parameter file has it."""
    if isinstance(value, (bool, numpy.bool_)):
        return "true" if value else "false"
    if isinstance(value, str):
        return value
    try:
        return repr(float(value)) if int(value) != value else str(int(value))
    except (TypeError, ValueError, OverflowError):
        raise InputError(f"{value!r} is no number, truth or text") from None


def command_of(program, entries):
    """The program with options for entries, a dict {"Section/Entry": value}."""
    command = [program]
    for path, value in (entries or {}).items():
        command += ["--set", f"{path}={_word(value)}"]
    return command


def _report(line, progress):
    """Calls progress with the part that is done, from a line of the screen."""
    percent = re.match(r" +(\d+) %  ", line)
    runs = re.match(r"  run +(\d+)/(\d+)  ", line)
    if percent:
        progress(int(percent[1]) / 100, line.strip())
    elif runs:
        progress(int(runs[1]) / int(runs[2]), line.strip())


def _temporary_result(directory, temporary):
    try:
        return read(directory, temporary)
    except Error:
        return None


def _message_in(text):
    """What the program says, without what mpirun says behind it; all of the text if
    the program has said nothing."""
    message = text.partition("thermocontact: ")[2]
    return re.split(r"\n-{20,}\n", message)[0].strip() or text.strip()


def issue_warnings(result):
    """Each warning of a run or a study once, as a RunWarning of the caller's caller."""
    for text in result.warnings:
        warnings.warn(text, RunWarning, stacklevel=3)


def run_silently(entries=None, base=None, output=None, progress=None, resume=False, ranks=1,
                 program=None):
    """Runs a scene or a study and returns its Run or Study.

    entries: a dict {"Section/Entry": value} that overrides the base.
    base: a parameter file; None: the defaults, which are the paper's experiment 1.
    output: the directory of the files; None: a temporary one, removed with the result.
    progress: called with the part that is done, 0 to 1, and a line of text.
    resume: go on with the run or study in output.
    ranks: processes that mpirun starts, for studies and bodies.
    Raises InputError or ComputationError with the program's message. What the program
    warns of is a RunWarning, and in the attribute warnings of what is returned.
    """
    temporary = None if output else tempfile.TemporaryDirectory(prefix="thermocontact-")
    with tempfile.TemporaryDirectory() as scratch:
        if base is None:
            base = Path(scratch) / "scene.prm"
            base.write_text("# defaults\n", encoding="utf-8")
        directory = Path(output) if output else Path(temporary.name) / "run"
        command = [*command_of(program or find_program(), entries), "--output",
                   str(directory), *["--resume"] * bool(resume), str(base)]
        if ranks > 1:
            as_root = ["--allow-run-as-root"] * (os.geteuid() == 0)
            command = ["mpirun", *as_root, "--oversubscribe", "-n", str(ranks), *command]
        with tempfile.TemporaryFile("w+") as messages:
            # ranks that share processors leave them while they wait
            environment = {"OMPI_MCA_mpi_yield_when_idle": "1", **os.environ}
            with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=messages,
                                  text=True, env=environment) as process:
                for line in process.stdout:
                    if progress:
                        _report(line, progress)
            messages.seek(0)
            message = _message_in(messages.read())
    if process.returncode == 2:
        raise InputError(message)
    if process.returncode != 0:
        raise ComputationError(message or f"exit status {process.returncode}",
                               _temporary_result(directory, temporary))
    return read(directory, temporary)


@functools.wraps(run_silently, assigned=["__doc__"])
def run(*arguments, **options):
    result = run_silently(*arguments, **options)
    issue_warnings(result)
    return result


def study(vary, base=None, entries=None, processes=None, output=None, **options):
    """Runs a scene for all combinations of values: a pandas.DataFrame with a row for
    each run, in the units of the files (attrs["units"]).

    vary: a dict {"Section/Entry": values}; several entries that go together are a tuple,
        {("A/B", "C/D"): [(b1, d1), (b2, d2)]}. Values may be a text, "0.6 .. 2.6 (61)".
    processes: that share the runs; None: as many as there are processors.
    base, entries, output, options: as of run().
    """
    axes = []
    for paths, values in vary.items():
        if isinstance(paths, str):
            paths, values = (paths,), values if isinstance(values, str) else [
                (value,) for value in values]
        if isinstance(values, str):
            axes.append(f"{paths[0]} = {values}")
            continue
        axes.append(" , ".join(f"{path} = " + " | ".join(map(_word, column))
                               for path, column in zip(paths, zip(*values))))
    result = run_silently({**(entries or {}), "Study/Vary": " ; ".join(axes)}, base, output,
                 ranks=processes or os.cpu_count() or 1, **options)
    issue_warnings(result)
    return result.table.to_pandas()
