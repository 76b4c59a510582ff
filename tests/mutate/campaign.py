# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws faults, builds them, runs tests with them: see scripts/mutate."""
import contextlib
import json
import math
import os
import random
import re
import shlex
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path

from clang import cindex

from operators import Source

ENCODING = "latin-1"  # a character to a byte: libclang counts bytes
LEFT_OUT = {".git", "build", "results", "__pycache__"}
# They read texts of the project, which the faults change, not the program.
READERS = re.compile(r"(app|unit|verification)/build$|documents/(links|paths|rooms|site)$")
LONGEST = 1800  # seconds
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


def copy_project(top, copy):
    """Files that are the same stay as they are, so that only what has changed is
    built."""
    wanted = {SWITCH_HEADER}
    write(copy / SWITCH_HEADER, SWITCH.encode())
    for directory, folders, names in os.walk(top):
        folders[:] = sorted(set(folders) - LEFT_OUT)
        for name in names:
            path = Path(directory) / name
            place = path.relative_to(top)
            wanted.add(place)
            write(copy / place, path.read_bytes())
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

    def source(self, name):
        source = Source(name, (self.copy / name).read_text(ENCODING))
        unit = self.index.parse(str(self.copy / name),
                                ["-x", "c++", *self.flags])
        for cursor in unit.cursor.get_children():
            if cursor.location.file and cursor.location.file.name.endswith(name):
                source.visit(cursor)
        return source

    def compiles(self, source, fault):
        text = apply(source.text, {0: fault}).encode(ENCODING).decode("utf-8")
        return not any(problem.severity >= cindex.Diagnostic.Error for problem in
                       self.parse(source.name, text).diagnostics)


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
    names = sorted(path.relative_to(copy).as_posix() for room in options.rooms or ["*"]
                   for pattern in (f"source/{room}/*.cc",
                                   f"include/thermocontact/{room}/*.h")
                   for path in copy.glob(pattern))
    if not names:
        raise Failure(f"no rooms {options.rooms}")
    lines = [(copy / name).read_bytes().count(b"\n") for name in names]
    explained = equivalents(top / "tests/mutate/equivalent.txt")
    sources, faults = {}, {}
    for _ in range(50 * options.n):
        if len(faults) == options.n:
            break
        name = chance.choices(names, lines)[0]
        if name not in sources:
            sources[name] = parser.source(name)
        source = sources[name]
        if not source.faults:
            continue
        kind = chance.choice(sorted({kind for kind, _ in source.faults}))
        fault = chance.choice([fault for fault in source.faults.values()
                               if fault.kind == kind])
        if not any(fault.file == file and fault.was.startswith(expression)
                   for file, expression in explained) and not any(
                fault.file == other.file and fault.begin <= other.end and
                other.begin <= fault.end for other in faults.values()) and \
                parser.compiles(source, fault):
            faults[len(faults)] = fault
            print(f"  {len(faults) - 1}: {words(fault)}", flush=True)
    return sources, faults


def build(copy, tree, sources, faults, targets):
    """All faults at once; those that the compiler refuses, though libclang does
    not, are left out."""
    while True:
        for name, source in sources.items():
            write(copy / name, apply(source.text, {
                number: fault for number, fault in faults.items()
                if fault.file == name}).encode(ENCODING))
        try:
            run_quietly(tree / "build.log", "make", "-C", tree, *targets)
            return
        except Failure:
            places = re.findall(r"((?:source|include)/\S+?):\d+:\d+: error",
                                (tree / "build.log").read_text(errors="replace"))
            refused = [number for number, fault in faults.items()
                       if fault.file in places]
            if not refused:
                raise
            for number in refused:
                print(f"  {number}: does not compile", flush=True)
                del faults[number]


def words(fault):
    return f"{fault.file}:{fault.line}: {fault.kind}: {fault.was[:100]}"


class Test:
    """A test, run by its own commands in a directory of its own: the harness
    would not run one again whose program is the same."""

    def __init__(self, name, commands, skipped):
        self.name, self.commands, self.skipped = name, commands, skipped

    def fails(self, limit, **environment):
        """limit: seconds for each command, whose children end with it."""
        with tempfile.TemporaryDirectory(prefix="mutate-") as scratch:
            for command in self.commands:
                process = subprocess.Popen(
                    command, cwd=scratch, env={**os.environ, **environment},
                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                    stdin=subprocess.DEVNULL, start_new_session=True)
                with contextlib.suppress(subprocess.TimeoutExpired):
                    process.wait(limit)
                with contextlib.suppress(ProcessLookupError):
                    os.killpg(process.pid, signal.SIGKILL)
                status = process.wait()
                if status != 0:
                    return status != self.skipped
        return False


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


def targets_of(tests):
    """What has to be built for the tests."""
    programs = {match[1] or f"{match[2]}.{match[3]}" for test in tests
                for command in test.commands for word in command
                if (match := re.search(
                    r"/tests/(?:\w+/(\w+_tests)|(\w+)/(?:\w+)\.\w+/(\w+\.\w+))$", word))}
    return sorted(programs)


def try_faults(faults, tests, costs):
    """By the number of each fault: the test that notices it."""
    noticed = {}
    for test in tests:
        if len(noticed) == len(faults):
            break
        with tempfile.NamedTemporaryFile("r", prefix="mutate-") as reached:
            start = time.time()
            if test.fails(LONGEST, THERMOCONTACT_REACHED=reached.name):
                raise Failure(f"{test.name} fails without a fault")
            costs[test.name] = time.time() - start
            numbers = {int(line) for line in reached}
        for number in sorted(numbers - set(noticed)):
            if test.fails(30 + 10 * costs[test.name],
                          THERMOCONTACT_FAULT=str(number)):
                noticed[number] = test.name
                print(f"  {number}: {test.name}", flush=True)
    return noticed


def interval(hits, n):
    """Wilson's, of a probability, 95 %."""
    z = 1.959964
    middle = (hits + z * z / 2) / (n + z * z)
    half = z / (n + z * z) * math.sqrt(hits * (n - hits) / n + z * z / 4)
    return middle - half, middle + half


def run(top, options):
    """Exit status 1 if a fault survives."""
    subprocess.run([top / "scripts/install_packages", "numdiff", "perl",
                    "python3-clang", "python3-meshio", "python3-matplotlib"],
                   check=True)
    os.nice(10)
    work = top / "build/mutate"
    copy, tree = work / "source", work / "release"
    tree.mkdir(parents=True, exist_ok=True)
    copy_project(top, copy)
    run_quietly(work / "cmake.log", "cmake", "-S", copy, "-B", tree,
                "-DCMAKE_BUILD_TYPE=Release", "-DTHERMOCONTACT_UNIT_TESTS=ON",
                "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    file = work / "costs.json"
    costs = json.loads(file.read_text()) if file.exists() else {}
    tests = tests_of(tree, costs, options.tests)
    print(f"faults, drawn by {options.seed}:", flush=True)
    sources, faults = draw(Parser(copy, tree), top, copy, options)
    print(f"noticed by, of {len(tests)} tests, after building {tree}:", flush=True)
    build(copy, tree, sources, faults, ["thermocontact", "thermocontact_test_driver",
                                        *targets_of(tests)])
    try:
        noticed = try_faults(faults, tests, costs)
    finally:
        file.write_text(json.dumps(costs, indent=0))
    survivors = [fault for number, fault in faults.items()
                 if number not in noticed]
    print("survivors:", *map(words, survivors), sep="\n  ")
    low, high = interval(len(noticed), len(faults))
    print(f"{len(noticed)} of {len(faults)} noticed: "
          f"{100 * len(noticed) / len(faults):.0f} %, in an interval of "
          f"{100 * low:.0f} to {100 * high:.0f} %")
    return 1 if survivors else 0
