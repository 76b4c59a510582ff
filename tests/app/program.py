#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the program, for the scripts check_*.py; called itself, one in its place."""
import json
import os
import re
import socket
import sys
from pathlib import Path


def status_of(arguments, screen, message, **limits):
    """The exit status of a run, or minus the signal that ended it (forks.cc)."""
    with socket.socket(socket.AF_UNIX) as forks:
        forks.connect(os.environ["THERMOCONTACT_FORKS"])
        forks.sendall(json.dumps({
            "arguments": [str(argument) for argument in arguments], "directory": os.getcwd(),
            "stdout": str(screen), "stderr": str(message), **limits}).encode() + b"\n")
        return int(forks.makefile().readline())


def run(*arguments, memory=None, file_size=None, seconds=None):
    """Exit status, what the program said on the screen, and its message.

    memory, file_size: limits in bytes; seconds: of the processor.
    """
    with (open(os.memfd_create("screen"), encoding="utf-8") as screen,
          open(os.memfd_create("message"), encoding="utf-8") as message):
        status = status_of(arguments, *(f"/proc/{os.getpid()}/fd/{file.fileno()}" for file in (
            screen, message)), memory=memory, file_size=file_size, seconds=seconds)
        words = message.read().partition("thermocontact: ")[2]
        return status, screen.read(), re.sub(r"^command line: ", "", words)


def for_all(function, arguments):
    """The results of function in the order of arguments, on all processors."""
    from concurrent.futures import ThreadPoolExecutor
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(function, arguments))


def settings(overrides):
    """Options --set of overrides like "Time/End time=1"."""
    return [word for override in overrides for word in ("--set", override)]


def start(words, ignored=()):
    """Starts a command in a session of its own. Signals end it but for those that are ignored,
    whatever is ignored here, as by nohup."""
    import signal
    import subprocess

    def set_signals():
        for one in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM):
            signal.signal(one, signal.SIG_IGN if one in ignored else signal.SIG_DFL)
    return subprocess.Popen(words, stderr=subprocess.PIPE, text=True, start_new_session=True,
                            preexec_fn=set_signals)


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


def is_running(number):
    """Whether there is a process of that number, and has not ended. Its first thread may have, with
    others that still hold files and locks."""
    try:
        words = Path(f"/proc/{number}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return False
    state, n_threads = words[0], int(words[17])
    return state not in "ZX" or n_threads > 1


def kill(process):
    """Kills what start() has started, ranks in groups of their own too, which write on while mpirun
    is gone already; back when all have ended."""
    import contextlib
    import signal
    import time
    ranks = started_by(process)
    os.killpg(process.pid, signal.SIGKILL)
    for rank in ranks:
        with contextlib.suppress(ProcessLookupError):
            os.kill(rank, signal.SIGKILL)
    while any(map(is_running, ranks)):
        time.sleep(0.005)


def main():
    """On ranks the program itself, which a script names in the environment."""
    if "OMPI_COMM_WORLD_SIZE" in os.environ:
        os.execv(os.environ["THERMOCONTACT_PROGRAM"], ["thermocontact", *sys.argv[1:]])
    status = status_of(sys.argv[1:], *(f"/proc/{os.getpid()}/fd/{i}" for i in (1, 2)))
    sys.exit(status if status >= 0 else 128 - status)


if __name__ == "__main__":
    main()
