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
import time
from pathlib import Path

# They read texts of the project, which the faults change, not the program.
READERS = re.compile(r"documents/(links|paths|quotes|rooms)$")
LONGEST = 900  # seconds


class Test:
    def __init__(self, name, commands, skipped=None):
        self.name, self.commands, self.skipped = name, commands, skipped
        self.seconds = LONGEST / 10

    def run(self, environment, replaced=("", "")):
        """Whether it passes, and what it says. replaced: a text of the commands
        and another; a test that takes ten times as long as usual fails."""
        with tempfile.TemporaryDirectory(prefix="mutate-") as scratch:
            for command in self.commands:
                words = [replaced[1] if word == replaced[0] else word
                         for word in command]
                status, text = run_group(words, scratch, environment,
                                         60 + 10 * self.seconds)
                if status == self.skipped:
                    return True, "skipped"
                if status != 0:
                    return False, text
        return True, ""


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
            status = 124
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()
        log.seek(0)
        return status, log.read() + ("\ntoo long" if status == 124 else "")


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


def run_all(tests, pool, report):
    """Runs all without a fault and takes their times; names of those that fail."""
    def timed(test):
        start = time.time()
        passed, text = test.run({})
        test.seconds = time.time() - start
        report(f"{'passed' if passed else 'FAILED'}  {test.seconds:6.1f} s  "
               f"{test.name}" + ("" if passed else "\n" + text[-2000:]))
        return passed
    # the longest ones first, as far as that is known
    order = sorted(tests.values(), key=lambda test: -test.seconds)
    return [test.name for test, passed in zip(order, pool.map(timed, order))
            if not passed]
