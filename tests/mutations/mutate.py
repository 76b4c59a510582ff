#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: mutate.py SOURCE_DIRECTORY [--named] [--only REGEX] [N [SEED]]

See scripts/mutate. faults.py reads the lists, suite.py runs tests.
"""
import argparse
import hashlib
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True
import faults as lists
import suite

LEFT_OUT = {".git", "build", "results", "__pycache__"}
# All sources read this first; a header of its own before it would undo it.
FIRST_HEADER = Path("source/precompiled.h")
SWITCH = b'#include "../tests/mutations/fault_switch.h"\n'
N_JOBS = 2


def say(text):
    print(text, flush=True)


def arguments():
    parser = argparse.ArgumentParser(prog="scripts/mutate")
    parser.add_argument("top", type=Path)
    parser.add_argument("n", type=int, nargs="?")
    parser.add_argument("seed", type=int, nargs="?", default=1)
    parser.add_argument("--only", type=re.compile, default="")
    parser.add_argument("--named", action="store_true")
    options = parser.parse_args()
    options.top = options.top.resolve()
    return options


def copy_project(top, copy, faults):
    """The project with all faults of its sources; files that are the same stay
    as they are, so that only what has changed is built."""
    by_file = {}
    for fault in faults:
        by_file.setdefault(fault.file, []).append(fault)
    digest, wanted = hashlib.sha256(), set()
    for directory, folders, names in os.walk(top):
        folders[:] = sorted(set(folders) - LEFT_OUT)
        for name in sorted(names):
            path = Path(directory) / name
            place = path.relative_to(top)
            wanted.add(place)
            content = path.read_bytes()
            mutated = by_file.pop(str(place), [])
            if mutated and mutated[0].is_script:
                for fault in mutated:  # each alone, when its turn comes
                    lists.apply([fault], content.decode())
            elif mutated:
                content = lists.apply(mutated, content.decode()).encode()
            if place == FIRST_HEADER:
                content += SWITCH
            digest.update(str(place).encode() + content)
            target = copy / place
            target.parent.mkdir(parents=True, exist_ok=True)
            if not target.exists() or target.read_bytes() != content:
                target.write_bytes(content)
                shutil.copymode(path, target)
    for path in sorted(copy.rglob("*")):
        if path.is_file() and path.relative_to(copy) not in wanted:
            path.unlink()
    if by_file:
        raise lists.BadList(f"no such file: {', '.join(by_file)}")
    return digest.hexdigest()


def run_quietly(log, *words):
    with open(log, "w") as file:
        if subprocess.run(words, stdout=file, stderr=file).returncode != 0:
            lines = Path(log).read_text(errors="replace").splitlines()
            errors = [line for line in lines if "error" in line.lower()]
            sys.exit("\n".join((errors or lines)[-20:]) +
                     f"\nscripts/mutate: building failed; its log: {log}")


def build(copy, tree):
    """Release, unit tests too."""
    say(f"building {tree}")
    tree.mkdir(exist_ok=True)
    run_quietly(tree / "cmake.log", "cmake", "-S", copy, "-B", tree,
                "-DCMAKE_BUILD_TYPE=Release", "-DTHERMOCONTACT_UNIT_TESTS=ON")
    tests = suite.tests_of(tree)
    run_quietly(tree / "build.log", "make", "-C", tree, f"-j{N_JOBS}",
                "thermocontact", "thermocontact_test_driver",
                *suite.targets_of(tests))
    return tests


def check_all_pass(tests, tree, digest, pool):
    """Without a fault; not again for the same copy."""
    stamp = tree / "passed.json"
    known = json.loads(stamp.read_text()) if stamp.exists() else {}
    for name, seconds in known.get("seconds", {}).items():
        if name in tests:
            tests[name].seconds = seconds
    if known.get("digest") == digest:
        return
    say(f"{len(tests)} tests without a fault")
    failed = suite.run_all(tests, pool, say)
    if failed:
        sys.exit("scripts/mutate: fail without a fault: " + ", ".join(failed))
    stamp.write_text(json.dumps({"digest": digest, "seconds": {
        name: test.seconds for name, test in tests.items()}}))


def link_copy(copy, scratch, fault):
    """The project with a fault in a script; the rest is links."""
    project = Path(scratch) / "project"
    project.mkdir()
    for path in copy.iterdir():
        if path.name != "scripts":
            (project / path.name).symlink_to(path)
    shutil.copytree(copy / "scripts", project / "scripts")
    path = project / fault.file
    path.write_text(lists.apply([fault], path.read_text()))
    return project


def order_of(fault, tests, named_only):
    """The tests that the fault names, then the others, the shortest first."""
    named = [re.compile(word) for word in fault.entries["tests"].split()]
    first = [test for test in tests.values()
             if any(word.match(test.name) for word in named)]
    if not first:
        raise lists.BadList(f"{fault.name}: no test is called "
                            f"{fault.entries['tests']}")
    # a fault of a script concerns the tests that know the scripts
    others = [test for test in tests.values() if test not in first and (
        not fault.is_script or test.name.startswith(("pictures", "documents")))]
    return first, [] if named_only else sorted(
        others, key=lambda test: test.seconds)


def try_fault(fault, copy, tests, named_only):
    """The name of the first test that fails, and whether the fault names it."""
    first, others = order_of(fault, tests, named_only)
    with tempfile.TemporaryDirectory(prefix="mutate-") as scratch:
        environment, replaced = {"THERMOCONTACT_FAULT": fault.name}, ("", "")
        if fault.is_script:
            environment = {}
            replaced = str(copy), str(link_copy(copy, scratch, fault))
        start = time.time()
        for test in [*first, *others]:
            passed, _ = test.run(environment, replaced)
            if not passed:
                break
        else:
            test = None
        return {"name": fault.name, "room": fault.room, "reason": fault.reason,
                "equivalent": "equivalent" in fault.entries,
                "noticed": test.name if test else "",
                "as_named": test in first, "seconds": time.time() - start}


def report_result(result):
    if result["noticed"]:
        say(f"noticed   {result['name']}  by {result['noticed']}" + (
            "" if result["as_named"] else ", which it does not name") + (
            ", though the list explains it away" if result["reason"] else ""))
    else:
        say(f"SURVIVES  {result['name']}  " + (
            ("no difference: " if result["equivalent"] else "") +
            (" ".join(result["reason"].split()) or "not explained")))
    return result


def summarise(results):
    say(f"\n{'room':12} faults  noticed  no difference  explained  survive")
    rows = [(room, [r for r in results if r["room"] == room])
            for room in sorted({r["room"] for r in results})]
    for room, some in [*rows, ("all", results)]:
        left = [r for r in some if not r["noticed"]]
        equivalent = sum(r["equivalent"] for r in left)
        explained = sum(bool(r["reason"]) for r in left) - equivalent
        say(f"{room:12} {len(some):6} {len(some) - len(left):8} "
            f"{equivalent:14} {explained:10} "
            f"{len(left) - equivalent - explained:8}")
    return any(not r["noticed"] and not r["reason"] for r in results)


def main():
    options = arguments()
    work = options.top / "build/mutate"
    faults = lists.read_lists(options.top / "tests/mutations")
    digest = copy_project(options.top, work / "source", faults)
    tests = build(work / "source", work / "release")
    chosen = [fault for fault in faults if re.search(options.only, fault.name)]
    if options.n is not None:
        chosen = random.Random(options.seed).sample(
            chosen, min(options.n, len(chosen)))
    for fault in chosen:
        order_of(fault, tests, True)  # a list that is wrong fails at once
    with ThreadPoolExecutor(N_JOBS) as pool:
        check_all_pass(tests, work / "release", digest, pool)
        say(f"{len(chosen)} faults of {len(faults)}")
        results = list(pool.map(lambda fault: report_result(try_fault(
            fault, work / "source", tests, options.named)), chosen))
    (work / "results.json").write_text(json.dumps(results, indent=1))
    sys.exit(summarise(results))


if __name__ == "__main__":
    try:
        main()
    except lists.BadList as error:
        sys.exit(f"scripts/mutate: {error}")
