# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tests of a build tree, run anew in scratch directories.

The harness would not run a test again whose program is the same: its own
commands are run, which the build tree holds, each test in a directory of its
own, so that several runs of a test do not meet.
"""
import json
import os
import re
import shlex
import signal
import subprocess
import tempfile
import threading
import time
from pathlib import Path

# They read texts of the project, which the faults change, not the program.
READERS = re.compile(r"documents/(links|paths|quotes|rooms)$")
LONGEST = 1800  # seconds
TOO_LONG = 124  # as timeout has it


class Test:
    """A test; what it does without a fault is asked once, before anything else."""

    def __init__(self, name, commands, skipped=None):
        self.name, self.commands, self.skipped = name, commands, skipped
        self.seconds = LONGEST / 10  # without a fault
        self.lock, self.is_measured = threading.Lock(), False

    def run(self, environment, replaced, limit):
        """Its exit status and what it says. replaced: a text of the commands and
        another; limit: seconds for each command."""
        with tempfile.TemporaryDirectory(prefix="mutate-") as scratch:
            for command in self.commands:
                words = [replaced[1] if word == replaced[0] else word
                         for word in command]
                status, text = run_group(words, scratch, environment, limit)
                if status == self.skipped:
                    return 0, "skipped"
                if status != 0:
                    return status, text
        return 0, ""

    def measure(self):
        """It has to pass without a fault; the time that it takes."""
        start = time.time()
        status, text = self.run({}, ("", ""), LONGEST)
        self.seconds = time.time() - start
        if status != 0:
            raise RuntimeError(f"{self.name} fails without a fault:\n"
                               f"{text[-2000:]}")

    def passes_with(self, environment, replaced):
        """With a fault. What takes ten times as long as without, measured again
        in case the machine has become slower, fails."""
        with self.lock:
            if not self.is_measured:
                self.measure()
                self.is_measured = True
        status, _ = self.run(environment, replaced, self.limit())
        if status == TOO_LONG:
            self.measure()
            status, _ = self.run(environment, replaced, self.limit())
        return status == 0

    def limit(self):
        return 30 + 10 * self.seconds


def run_group(words, directory, environment, limit):
    """Exit status and output of a command, whose children end with it."""
    with open(Path(directory) / "mutate.log", "w+", errors="replace") as log:
        process = subprocess.Popen(
            words, cwd=directory, env={**os.environ, **environment}, stdout=log,
            stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
            start_new_session=True)
        try:
            status = process.wait(timeout=limit)
        except subprocess.TimeoutExpired:
            status = TOO_LONG
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()
        log.seek(0)
        return status, log.read() + ("\ntoo long" if status == TOO_LONG else "")


def harness_commands(tree):
    """By the name of a test: its commands that run and compare."""
    found = {}
    for path in sorted((tree / "tests").rglob("build.make")):
        for line in path.read_text().splitlines():
            match = re.search(r"sh (\S+/run_test\.sh) (run|diff) (\S+) (.*)", line)
            if match:
                script, stage, name, rest = match.groups()
                found.setdefault(name, {})[stage] = [
                    "sh", script, stage, name, *shlex.split(rest)]
    return {name: [stages["run"],
                   ["perl", "-pi", str(Path(stages["run"][1]).with_name(
                       "normalize.pl")), "output"],
                   stages["diff"]] for name, stages in found.items()}


def tests_of(tree):
    """All tests of a build tree but those that read texts, by name."""
    listed = json.loads(subprocess.run(
        ["ctest", "--show-only=json-v1"], cwd=tree, check=True,
        capture_output=True, text=True).stdout)["tests"]
    commands, tests = harness_commands(tree), {}
    for test in listed:
        name = test["name"]
        properties = {p["name"]: p["value"] for p in test["properties"]}
        if not READERS.match(name):
            tests[name] = Test(name, commands.get(name) or [test["command"]],
                               properties.get("SKIP_RETURN_CODE"))
    return tests


def targets_of(tests):
    """What has to be built for the tests."""
    programs = {Path(word) for test in tests.values()
                for command in test.commands for word in command
                if re.search(r"/tests/\w+/(\w+)\.\w+/\1\.\w+$", word)}
    return sorted(f"{path.parent.parent.name}.{path.name}" for path in programs)
