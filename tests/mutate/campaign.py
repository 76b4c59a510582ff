# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws faults, builds them, runs tests with them: see scripts/mutate."""
import collections
import concurrent.futures
import contextlib
import functools
import hashlib
import json
import math
import os
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import tempfile
import threading
from pathlib import Path

from clang import cindex

from operators import Fault, Source

ENCODING = "latin-1"  # a character to a byte: libclang counts bytes
LEFT_OUT = {".git", "build", "results", "__pycache__"}
# They read texts of the project, which the faults change, not the program.
READERS = re.compile(r"(app|unit|verification)/build$|documents/(links|paths|rooms|site)$")
LINES_OF_FILE = 8  # that are drawn at once, since reading a file takes seconds
# A process with a fault may write and allocate without end.
LARGEST_FILE, LARGEST_MEMORY = 2**30, 6 * 2**30  # bytes
SWITCH_HEADER = Path("include/fault_switch.h")  # of the copy
SWITCH = """#pragma once
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <unistd.h>
namespace ThermoContactFaults
{
  inline const char *const word   = std::getenv("THERMOCONTACT_FAULT");
  inline const int         chosen = word != nullptr ? std::atoi(word) : -1;
  inline bool              is_known[10000];

  inline void
  note(const int number)
  {
    is_known[number] = true;
    if (const char *const path = std::getenv("THERMOCONTACT_REACHED"))
      {
        const int  file = open(path, O_WRONLY | O_APPEND | O_CREAT, 0666);
        const auto line = std::to_string(number) + '\\n';
        if (write(file, line.data(), line.size()) < 0 || close(file) < 0)
          std::abort();
      }
  }

  inline bool
  is_on(const int number)
  {
    if (!is_known[number])
      note(number);
    return number == chosen;
  }
} // namespace ThermoContactFaults
"""


class Failure(Exception):
    """What ends a campaign, in words."""


def copy_project(top, copy, texts):
    """texts: of files that differ from the project's. Files that are the same stay
    as they are, so that only what has changed is built."""
    wanted = {SWITCH_HEADER}
    write(copy / SWITCH_HEADER, SWITCH.encode())
    for directory, folders, names in os.walk(top):
        folders[:] = sorted(set(folders) - LEFT_OUT)
        for name in names:
            path = Path(directory) / name
            place = path.relative_to(top)
            wanted.add(place)
            write(copy / place, texts[place.as_posix()].encode(ENCODING)
                  if place.as_posix() in texts else path.read_bytes())
            shutil.copymode(path, copy / place)
    for path in sorted(copy.rglob("*")):
        if path.is_file() and path.relative_to(copy) not in wanted:
            path.unlink()


def write(path, content):
    if not path.exists() or path.read_bytes() != content:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def run_quietly(log, *words):
    with open(log, "w") as file:
        if subprocess.run(words, stdout=file, stderr=file).returncode != 0:
            lines = Path(log).read_text(errors="replace").splitlines()
            errors = [line for line in lines if "error" in line.lower()]
            raise Failure("\n".join((errors or lines)[-20:]) +
                          f"\nbuilding failed; its log: {log}")


class Parser:
    """Reads sources of the copy with the flags of its build."""

    def __init__(self, copy, tree):
        command = next(entry["command"] for entry in json.loads(
            (tree / "compile_commands.json").read_text())
            if "thermocontact_library" in entry["command"])
        self.flags = [word for word in shlex.split(command)
                      if re.match(r"-(D|std)", word)]
        for option, path in re.findall(r"(-I|-isystem) ?(\S+)", command):
            self.flags += [option, path]
        self.copy, self.index = copy, cindex.Index.create(excludeDecls=True)
        unit = self.index.parse(
            str(copy / "source/precompiled.h"), ["-x", "c++-header", *self.flags],
            options=cindex.TranslationUnit.PARSE_INCOMPLETE)
        unit.save(str(tree / "precompiled.pch"))
        self.flags += ["-include-pch", str(tree / "precompiled.pch")]

    def parse(self, name, text):
        path = str(self.copy / name)
        return self.index.parse(path, ["-x", "c++", *self.flags], [(path, text)])

    @functools.lru_cache(None)
    def source(self, name):
        source = Source(name, (self.copy / name).read_text(ENCODING))
        unit = self.index.parse(str(self.copy / name),
                                ["-x", "c++", *self.flags])
        for cursor in unit.cursor.get_children():
            if cursor.location.file and cursor.location.file.name.endswith(name):
                source.visit(cursor)
        return source

    def errors(self, name, text):
        """Lines that do not compile."""
        return {problem.location.line for problem in self.parse(
            name, text.encode(ENCODING).decode("utf-8")).diagnostics
            if problem.severity >= cindex.Diagnostic.Error}


def apply(text, faults):
    """The text with faults, by their numbers; they do not overlap."""
    edits = [(begin, end, new, number) for number, fault in faults.items()
             for begin, end, new in fault.edits]
    for begin, end, new, number in sorted(edits, reverse=True):
        new = new.replace("FAULT", f"ThermoContactFaults::is_on({number})")
        text = text[:begin] + new + text[end:]
    return f"#include <{SWITCH_HEADER.name}>\n{text}" if edits else text


def equivalents(path):
    """File and expression, or how it begins, of faults that no test can notice."""
    lines = [line.split(" | ") for line in path.read_text().splitlines()
             if line and not line.startswith("#")]
    return {(words[0].strip(), words[1].strip()) for words in lines}


def draw(parser, top, copy, options):
    chance = random.Random(options.seed)
    names = sorted(path.relative_to(copy).as_posix() for pattern in (
        [pattern for room in options.rooms for pattern in (
            f"source/{room}/*.cc", f"include/thermocontact/{room}/*.h")] or
        ["source/**/*.cc", "include/thermocontact/*/*.h"])
        for path in copy.glob(pattern))
    if not names:
        raise Failure(f"no rooms {options.rooms}")
    lines = [(copy / name).read_bytes().count(b"\n") for name in names]
    explained = equivalents(top / "tests/mutate/equivalent.txt")
    faults = {}
    for _ in range(20 * options.n):
        if len(faults) >= options.n:
            break
        name = chance.choices(names, lines)[0]
        source = parser.source(name)
        drawn = {}
        for line in chance.choices(range(1, lines[names.index(name)] + 1),
                                   k=LINES_OF_FILE):
            of_line = [fault for fault in source.faults.values() if fault.line == line]
            if of_line:
                kind = chance.choice(sorted({fault.kind for fault in of_line}))
                fault = chance.choice([one for one in of_line if one.kind == kind])
                if not any(fault.file == file and fault.was.startswith(expression)
                           for file, expression in explained) and not any(
                        fault.file == other.file and fault.begin <= other.end and
                        other.begin <= fault.end
                        for other in [*faults.values(), *drawn.values()]):
                    drawn[len(faults) + len(drawn)] = fault
        for number in refused(parser, source, drawn):
            del drawn[number]
        for fault in drawn.values():
            print(f"  {len(faults)}: {words(fault)}", flush=True)
            faults[len(faults)] = fault
    return faults


def refused(parser, source, faults):
    """Those that do not compile, by the lines of the messages."""
    wrong = parser.errors(source.name, apply(source.text, faults)) if faults else ()
    return at_lines(wrong, faults)


def at_lines(lines, faults):
    """Those of one file at the lines of messages, or all if there is none there."""
    of_lines = {number for number, fault in faults.items() if any(
        fault.line <= line - 1 <= fault.line + fault.was.count(" ") // 4 + 2
        for line in lines)}  # below the line that switches faults on
    return of_lines or (set(faults) if lines else set())


def with_faults(texts, faults):
    """The texts of the files that have faults, with them."""
    return {name: apply(texts[name], {number: fault for number, fault in
                                      faults.items() if fault.file == name})
            for name in {fault.file for fault in faults.values()}}


def build(copy, tree, texts, journal, jobs, targets):
    """All faults at once; those that the compiler refuses, though libclang does
    not, are left out."""
    while True:
        for name, text in {**texts, **with_faults(texts, journal.faults)}.items():
            write(copy / name, text.encode(ENCODING))
        try:
            run_quietly(tree / "build.log", "make", f"-j{jobs}", "-C", tree, *targets)
            return
        except Failure:
            lines = collections.defaultdict(set)
            for name, line in re.findall(rf"{re.escape(str(copy))}/(\S+?):(\d+):\d+: error",
                                         (tree / "build.log").read_text(errors="replace")):
                lines[name].add(int(line))
            refused = set().union(*(at_lines(wrong, {
                number: fault for number, fault in journal.faults.items()
                if fault.file == name}) for name, wrong in lines.items()))
            if not refused:
                raise
            for number in refused:
                print(f"  {number}: does not compile", flush=True)
                journal.write("refused", number)


def words(fault):
    return f"{fault.file}:{fault.line}: {fault.kind}: {fault.was[:100]}"


class Test:
    """A test, run by its own commands in a directory of its own: the harness
    would not run one again whose program is the same."""

    def __init__(self, name, commands, skipped):
        self.name, self.commands, self.skipped = name, commands, skipped

    def run(self, cost=None, **environment):
        """Whether it fails, and its processor time in seconds. cost: what it takes
        without a fault; with one it may take five times as long. Its children end
        with it."""
        used = 0
        with tempfile.TemporaryDirectory(prefix="mutate-") as scratch:
            for command in self.commands:
                process = subprocess.Popen(
                    command, cwd=scratch, env={**os.environ, **environment},
                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                    stdin=subprocess.DEVNULL, start_new_session=True,
                    preexec_fn=lambda: set_limits(cost))
                # of the clock, for what waits without end: others may be at work
                timer = threading.Timer(300 + 50 * (cost or 60), kill, [process.pid])
                timer.start()
                _, status, usage = os.wait4(process.pid, 0)
                timer.cancel()
                process.returncode = os.waitstatus_to_exitcode(status)
                kill(process.pid)
                used += usage.ru_utime + usage.ru_stime
                if process.returncode != 0:
                    return process.returncode != self.skipped, used
        return False, used


def kill(group):
    with contextlib.suppress(ProcessLookupError):
        os.killpg(group, signal.SIGKILL)


def set_limits(cost):
    resource.setrlimit(resource.RLIMIT_FSIZE, (LARGEST_FILE,) * 2)
    resource.setrlimit(resource.RLIMIT_AS, (LARGEST_MEMORY,) * 2)
    if cost is not None:
        resource.setrlimit(resource.RLIMIT_CPU, (int(5 + 5 * cost),) * 2)


def tests_of(tree, costs, regex):
    """The tests of a build tree but those that read texts, the cheapest first."""
    commands, tests = {}, []
    for path in sorted((tree / "tests").rglob("build.make")):
        for script, stage, name, rest in re.findall(
                r"sh (\S+/run_test\.sh) (run|diff) (\S+) (.*)", path.read_text()):
            commands.setdefault(name, {})[stage] = [
                "sh", script, stage, name, *shlex.split(rest)]
    listed = json.loads(subprocess.run(
        ["ctest", "--show-only=json-v1"], cwd=tree, check=True,
        capture_output=True, text=True).stdout)["tests"]
    for test in listed:
        name, stages = test["name"], commands.get(test["name"])
        if READERS.match(name) or not re.search(regex, name):
            continue
        tests.append(Test(name, [test["command"]] if stages is None else [
            stages["run"],
            ["perl", "-pi", str(Path(stages["run"][1]).with_name("normalize.pl")),
             "output"], stages["diff"]],
            next((p["value"] for p in test["properties"]
                  if p["name"] == "SKIP_RETURN_CODE"), None)))
    return sorted(tests, key=lambda test: (costs.get(test.name, 0), test.name))


class Journal:
    """What a campaign has found, line by line, so that one that was stopped goes
    on: its faults, the faults that each test reaches, who noticed what."""

    def __init__(self, path, campaign):
        self.path, self.faults = path, {}
        self.reached, self.costs, self.tried = {}, {}, {}
        lines = path.read_text().splitlines() if path.exists() else []
        if not lines or json.loads(lines[0]) != campaign:
            path.write_text(json.dumps(campaign) + "\n")
        for line in lines[1:] if lines and json.loads(lines[0]) == campaign else []:
            self.take(json.loads(line))

    def take(self, entry):
        kind, *values = entry
        if kind == "fault":
            number, fault = values
            self.faults[number] = Fault(*fault[:-1], tuple(map(tuple, fault[-1])))
        elif kind == "refused":
            del self.faults[values[0]]
        elif kind == "test":
            name, self.costs[name], self.reached[name] = *values[:2], set(values[2])
        else:
            number, name, is_noticed = values
            self.tried[number, name] = is_noticed

    def write(self, *entry):
        self.take(json.loads(json.dumps(entry)))
        with open(self.path, "a") as file:
            file.write(json.dumps(entry) + "\n")

    def noticed(self):
        """By the number of a fault: the first test that notices it."""
        return {number: name for (number, name), is_noticed in
                reversed(self.tried.items()) if is_noticed}


def try_faults(faults, tests, journal, options):
    """All tests without a fault, then test after test with each fault that it reaches
    until one notices it."""
    lock = threading.Lock()
    busy = set()

    def measure(test):
        with tempfile.TemporaryDirectory(prefix="mutate-") as directory:
            path, numbers = f"{directory}/reached", set()
            os.mkfifo(path)  # a file would meet the limits that tests set
            reader = threading.Thread(target=lambda: numbers.update(map(int, open(path))))
            reader.start()
            with open(path, "w"):
                fails, cost = test.run(THERMOCONTACT_REACHED=path)
            reader.join()
        with lock:
            if fails:
                print(f"  {test.name} fails without a fault: left out", flush=True)
            else:
                journal.write("test", test.name, cost, sorted(numbers))

    def work(_):
        while True:
            with lock:
                number, test = next_trial(faults, tests, journal, busy, options.longest)
                if test is None:
                    return
                busy.add(number)
            fails, _ = test.run(journal.costs[test.name], THERMOCONTACT_FAULT=str(number))
            with lock:
                busy.remove(number)
                journal.write("tried", number, test.name, fails)
                if fails:
                    print(f"  {number}: {test.name}", flush=True)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(measure, [test for test in tests if test.name not in journal.reached]))
        list(pool.map(work, range(options.jobs)))


def next_trial(faults, tests, journal, busy, longest):
    """A fault that nothing has noticed, and the cheapest test that reaches one."""
    left = set(faults) - set(journal.noticed()) - busy
    for test in sorted(tests, key=lambda test: journal.costs.get(test.name, math.inf)):
        if journal.costs.get(test.name, math.inf) > longest:
            continue
        for number in sorted(left & journal.reached.get(test.name, set())):
            if (number, test.name) not in journal.tried:
                return number, test
    return None, None


def room(fault):
    """A folder of source or include, or the file of main()'s."""
    return Path(fault.file).parts[-2]


def interval(hits, n):
    """Wilson's, of a probability, 95 %."""
    z = 1.959964
    middle = (hits + z * z / 2) / (n + z * z)
    half = z / (n + z * z) * math.sqrt(hits * (n - hits) / n + z * z / 4)
    return max(0, middle - half), min(1, middle + half)


def run(top, options):
    """Exit status 1 if a fault survives."""
    os.nice(5)
    work = top / "build/mutate"
    copy, tree = work / "source", work / "release"
    tree.mkdir(parents=True, exist_ok=True)
    texts = {path.relative_to(top).as_posix(): path.read_text(ENCODING)
             for path in sorted([*top.glob("source/**/*.cc"),
                                 *top.glob("include/thermocontact/*/*.h")])}
    journal = Journal(work / "journal.txt", [
        options.n, options.seed, options.rooms,
        hashlib.sha1(repr(texts).encode()).hexdigest()])
    copy_project(top, copy, with_faults(texts, journal.faults))
    run_quietly(work / "cmake.log", "cmake", "-S", copy, "-B", tree,
                "-DCMAKE_BUILD_TYPE=Release", "-DTHERMOCONTACT_UNIT_TESTS=ON",
                "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    if not journal.faults:
        print(f"faults, drawn by {options.seed}:", flush=True)
        for number, fault in draw(Parser(copy, tree), top, copy, options).items():
            journal.write("fault", number, fault)
    build(copy, tree, texts, journal, options.jobs, [
        "thermocontact", "thermocontact_test_driver", "thermocontact_forks",
        "unit_tests", "verification_tests"])
    tests = tests_of(tree, journal.costs, options.tests)
    print(f"noticed by, of {len(tests)} tests:", flush=True)
    try_faults(journal.faults, tests, journal, options)
    return report(journal.faults, journal)


def report(faults, journal):
    """The survivors and the rates; exit status 1 if a fault survives."""
    noticed = journal.noticed()
    reached = set().union(*journal.reached.values())
    print("survivors:", *(f"  {number}: {words(fault)}" + (
        "" if number in reached else " (no test reaches it)")
        for number, fault in faults.items() if number not in noticed), sep="\n")
    rooms = collections.defaultdict(list)
    for number, fault in faults.items():
        rooms[room(fault)].append(number in noticed)
    for name, hits in [*sorted(rooms.items()), (
            "all", [number in noticed for number in faults])]:
        low, high = interval(sum(hits), len(hits))
        print(f"{name}: {sum(hits)} of {len(hits)} noticed, {100 * low:.0f} to "
              f"{100 * high:.0f} %")
    return 1 if set(faults) - set(noticed) else 0
