# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the program, for the scripts check_*.py."""
import os
import re
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor


def run(*arguments, memory=None, file_size=None):
    """Exit status, what the program said on the screen, and its message.

    memory, file_size: limits in bytes.
    """
    limits = [f"--{kind}={limit}" for kind, limit in
              (("as", memory), ("fsize", file_size)) if limit is not None]
    # single processes of Open MPI that run at the same time disturb each other
    # in a common directory
    with tempfile.TemporaryDirectory() as directory:
        environment = dict(os.environ, OMPI_MCA_ess_singleton_isolated="1",
                           OMPI_MCA_btl="self",
                           OMPI_MCA_orte_tmpdir_base=directory)
        process = subprocess.run(
            ["prlimit", *limits, os.environ["THERMOCONTACT"],
             *map(str, arguments)],
            capture_output=True, text=True, env=environment, check=False)
    message = process.stderr.partition("thermocontact: ")[2]
    return (process.returncode, process.stdout,
            re.sub(r"^command line: ", "", message))


def for_all(function, arguments):
    """The results of function in the order of arguments, on all processors."""
    # a process waits for half of its time, for its set-up of MPI
    with ThreadPoolExecutor(2 * os.cpu_count()) as pool:
        return list(pool.map(function, arguments))


def settings(overrides):
    """Options --set of overrides like "Time/End time=1"."""
    return [word for override in overrides for word in ("--set", override)]
