#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: mutate.py SOURCE_DIRECTORY [--named] [--jobs J] [--only REGEX] [N [SEED]]

See scripts/mutate. faults.py reads the lists, copies.py puts the faults into the
project, suite.py runs tests, results.py keeps what has been found.
"""
import argparse
import random
import re
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True
import copies
import faults as lists
from results import Results, say


def arguments():
    parser = argparse.ArgumentParser(prog="scripts/mutate")
    parser.add_argument("top", type=Path)
    parser.add_argument("n", type=int, nargs="?")
    parser.add_argument("seed", type=int, nargs="?", default=1)
    parser.add_argument("--only", type=re.compile, default="")
    parser.add_argument("--named", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    options.top = options.top.resolve()
    return options


def choose(faults, options):
    chosen = [fault for fault in faults
              if re.search(options.only, f"{fault.room}/{fault.name}")]
    if options.n is not None:
        chosen = random.Random(options.seed).sample(
            chosen, min(options.n, len(chosen)))
    return chosen


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


def try_fault(fault, copy, tests, results):
    """Runs tests until one fails, each only after it has passed without."""
    first, others = order_of(fault, tests, results.named_only)
    with tempfile.TemporaryDirectory(prefix="mutate-") as scratch:
        environment, replaced = {"THERMOCONTACT_FAULT": fault.name}, ("", "")
        if fault.is_script:
            environment = {}
            replaced = str(copy), str(copies.link_copy(copy, scratch, fault))
        start = time.time()
        for test in [*first, *others]:
            if not test.passes_with(environment, replaced):
                break
        else:
            test = None
    results.add(fault, test.name if test else "", test in first,
                time.time() - start)


def main():
    options = arguments()
    work = options.top / "build/mutate"
    copy, tree = work / "source", work / "release"
    faults = lists.read_lists(options.top / "tests/mutations")
    digest = copies.copy_project(options.top, copy, faults)
    tests = copies.configure(copy, tree)
    chosen = choose(faults, options)
    needed = {test.name: test for fault in chosen for tests_of in
              order_of(fault, tests, options.named) for test in tests_of}
    say(f"building {tree}: {len(needed)} tests")
    copies.build(tree, needed, options.jobs)
    results = Results(work / "results.jsonl", digest, options.named)
    unknown = results.unknown(chosen)
    say(f"{len(chosen)} faults of {len(faults)}, {len(unknown)} to be tried; "
        f"results: {results.path}")
    with ThreadPoolExecutor(options.jobs) as pool:
        tries = [pool.submit(try_fault, fault, copy, tests, results)
                 for fault in unknown]
        try:
            for each in tries:
                each.result()
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    sys.exit(results.summarise(chosen))


if __name__ == "__main__":
    try:
        main()
    except (lists.BadList, RuntimeError) as error:
        sys.exit(f"scripts/mutate: {error}")
