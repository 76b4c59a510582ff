#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kills the run of an output directory again and again, goes on with --resume
each time, and compares with the uninterrupted run, byte by byte.

usage: check_resume.py DIR

DIR holds a finished run with checkpoints. Wall times and memory are left out,
and used.prm, which names the directory. Before, one run again, that ignores SIGHUP; then:
the same after SIGTERM, after a file that may not grow any more; SIGTERM in a repeat for error bars.
"""
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True
from contents import contents, different  # noqa: E402
import program  # noqa: E402

PROGRAM = os.environ["THERMOCONTACT"]
INTERVAL = 0.05  # of checkpoints in the scenes, in seconds


def compare(expected, directory):
    names = different(expected, directory)
    return "the same" if not names else f"{len(names)} files or keys differ, {names[0]}"


class Run:
    """One run in its own directory, on as many ranks as the reference."""

    def __init__(self, reference, directory):
        self.prm = reference / "used.prm"
        self.directory = directory
        ranks = json.loads((reference / "summary.json").read_text())["ranks"]
        self.launcher = [] if ranks == 1 else [
            "mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks)]

    def words(self, *options):
        resume = ["--resume"] * (self.directory / "checkpoint.bin").exists()
        return "--quiet", "--output", str(self.directory), *resume, *options, str(self.prm)

    def start(self, *options, ignored=()):
        return program.start([*self.launcher, PROGRAM, *self.words(*options)], ignored)

    def steps_of_checkpoints(self):
        """Runs it as nohup does, and hangs up again and again where it is one process; its
        status, the steps of the checkpoints that are seen, and its seconds."""
        begin, steps = time.time(), set()
        process = self.start(ignored=[signal.SIGHUP])
        while process.poll() is None:
            steps.add(self.step())
            if steps != {-1} and not self.launcher:
                process.send_signal(signal.SIGHUP)
            time.sleep(0.01)
        process.communicate()
        return process.returncode, steps, time.time() - begin

    def finish(self, *options, **limits):
        if self.launcher:
            process = self.start(*options)
            message = process.communicate()[1]
            return process.returncode, message
        status, _, message = program.run(*self.words(*options), **limits)
        return status, message

    def step(self):
        """Of the newest checkpoint, -1 if there is none."""
        try:
            with open(self.directory / "checkpoint.bin", "rb") as file:
                file.readline()
                file.readline()
                return json.loads(file.readline())["step"]
        except FileNotFoundError:
            return -1

    def kill(self, delay):
        """Kills the run some time after it has made its first step.

        Returns whether it was within its time loop.
        """
        begin = self.step()
        process = self.start()
        while self.step() <= begin and process.poll() is None:
            time.sleep(0.005)
        time.sleep(delay)
        was_running = process.poll() is None
        if was_running:
            program.kill(process)
        process.communicate()
        return was_running


def kill_again_and_again(reference, expected, seconds):
    run = Run(reference, Path("killed"))
    n_steps = json.loads((reference / "summary.json").read_text())["steps"]
    n_kills, enough = 0, 1 if run.launcher else 3
    for _ in range(5 * enough):
        if n_kills == enough:
            break
        if run.step() >= n_steps:  # it was done: from the start again
            while run.directory.exists():  # what its processes do not take away themselves
                shutil.rmtree(run.directory, ignore_errors=True)
        n_kills += run.kill(random.uniform(0, seconds / 10))
    status, message = run.finish()
    print(f"killed {n_kills} times within the time loop, resumed: status",
          f"{status},", compare(expected, run.directory) if status == 0 else message)


def terminate(reference, expected):
    run = Run(reference, Path("termi nated"))  # a path to be quoted
    for _ in range(10):  # unless it is done before
        shutil.rmtree(run.directory, ignore_errors=True)
        process = run.start()
        while run.step() < 1 and process.poll() is None:
            time.sleep(0.005)
        process.send_signal(signal.SIGTERM)
        message = process.communicate()[1]
        if process.returncode != 0:
            break
    attempts = run.directory / "steps.csv"
    rows = attempts.read_text().splitlines() if attempts.exists() else []
    summary = json.loads((run.directory / "summary.json").read_text())
    print("SIGTERM: status", process.returncode, "said",
          int("SIGTERM at t = " in message), "summary", summary["status"].split()[0], "command",
          int(f"--resume '{run.directory}/used.prm'" in message),
          "no attempt twice", int(len(rows) == len(set(rows))))
    command = message.partition("resume:  ")[2].strip()
    status = subprocess.run(command + " --quiet", shell=True).returncode
    print(f"resumed by it: status {status},", compare(expected, run.directory))


def let_no_file_grow(reference, expected):
    """As on a full disk: a row that does not fit is an error."""
    run = Run(reference, Path("limited"))
    limit = len(expected["contact.csv"]) // 2
    for interval in (0, INTERVAL):  # checkpoints would tell of the fault, too
        status, message = run.finish(
            "--set", f"Output/Checkpoint interval={interval}", file_size=limit)
        rows = (run.directory / "contact.csv").read_bytes()
        print("files may not grow: status", status, "named",
              int("limited/contact.csv: cannot be written" in message), "whole rows",
              int(rows.endswith(b"\n") and expected["contact.csv"].startswith(rows)))
    status, _ = run.finish()
    print(f"resumed: status {status},", compare(expected, run.directory))


def damage(reference, expected):
    """A checkpoint that is not whole is passed over for the previous one."""
    run = Run(reference, Path("killed"))
    newest = run.directory / "checkpoint.bin"
    data = bytearray(newest.read_bytes())
    data[len(data) // 2] ^= 1
    newest.write_bytes(data)
    status, _ = run.finish()
    print(f"damaged checkpoint: status {status},", compare(expected, run.directory), "warned",
          int("it is damaged" in (run.directory / "log.txt").read_text()))


def interrupt_repeats(reference):
    """A signal ends the repeats for error bars, which begin behind a summary."""
    run = Run(reference, Path("killed"))
    summary = run.directory / "summary.json"
    summary.unlink()
    process = run.start("--set", "Output/Error bars=true")
    while not summary.exists() and process.poll() is None:
        time.sleep(0.005)
    process.send_signal(signal.SIGTERM)
    message = process.communicate()[1]
    print("SIGTERM in a repeat: status", process.returncode, "said",
          int("SIGTERM at t = 5, " in message))


def main():
    reference = Path(sys.argv[1])
    expected = contents(reference)
    for directory in ("hung up", "killed", "termi nated", "limited"):
        shutil.rmtree(directory, ignore_errors=True)
    again = Run(reference, Path("hung up"))
    status, steps, seconds = again.steps_of_checkpoints()
    few = seconds / INTERVAL + 3  # none, the first, the last
    print(f"again{'' if again.launcher else ', hung up'}: status {status},", compare(expected, Path("hung up")), "checkpoints",
          "at their interval" if 1 < len(steps) <= few else f"{len(steps)} in {seconds} s")
    kill_again_and_again(reference, expected, seconds)
    # long enough, attempts of steps, and a table that is larger than all other files
    if "steps.csv" in expected and len(expected["contact.csv"]) > 200000:
        terminate(reference, expected)
        let_no_file_grow(reference, expected)
        damage(reference, expected)
        interrupt_repeats(reference)


main()
