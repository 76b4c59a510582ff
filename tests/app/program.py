# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the program, for the scripts check_*.py."""
import atexit
import json
import os
import re
import subprocess
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

_OF_THREAD = threading.local()


def _forks():
    """The process that runs the program for this thread (forks.cc)."""
    if not hasattr(_OF_THREAD, "forks"):
        _OF_THREAD.forks = subprocess.Popen(
            [os.environ["THERMOCONTACT_FORKS"]], stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, text=True)
        atexit.register(_OF_THREAD.forks.communicate)  # its time is part of a test's
    return _OF_THREAD.forks


def run(*arguments, memory=None, file_size=None, seconds=None):
    """Exit status, what the program said on the screen, and its message.

    memory, file_size: limits in bytes; seconds: of the processor.
    """
    # single processes of Open MPI that run at the same time disturb each other
    # in a common directory
    with tempfile.TemporaryDirectory() as directory:
        screen, message = Path(directory, "stdout"), Path(directory, "stderr")
        forks = _forks()
        print(json.dumps({
            "arguments": [str(argument) for argument in arguments],
            "environment": {"OMPI_MCA_ess_singleton_isolated": "1",
                            "OMPI_MCA_btl": "self",
                            "OMPI_MCA_orte_tmpdir_base": directory},
            "stdout": str(screen), "stderr": str(message),
            "memory": memory, "file_size": file_size, "seconds": seconds}),
            file=forks.stdin, flush=True)
        status = int(forks.stdout.readline())
        words = message.read_text().partition("thermocontact: ")[2]
        return status, screen.read_text(), re.sub(r"^command line: ", "", words)


def for_all(function, arguments):
    """The results of function in the order of arguments, on all processors."""
    # a process waits for half of its time, for its set-up of MPI
    with ThreadPoolExecutor(2 * os.cpu_count()) as pool:
        return list(pool.map(function, arguments))


def settings(overrides):
    """Options --set of overrides like "Time/End time=1"."""
    return [word for override in overrides for word in ("--set", override)]


def started_by(process):
    """The numbers of the processes that a process has started: the ranks of mpirun."""
    children = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            # state and parent follow the name, which may hold anything
            parent = path.read_text().rpartition(")")[2].split()[1]
        except OSError:
            continue
        if int(parent) == process.pid:
            children.append(int(path.parent.name))
    return children
