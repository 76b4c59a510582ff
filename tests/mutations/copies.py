# SPDX-License-Identifier: LGPL-2.1-or-later
"""The project with its faults: a copy that holds all of the program's, which is
built once; for a fault of a script another, in which only the scripts are new.
"""
import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import faults as lists
import suite

LEFT_OUT = {".git", "build", "results", "__pycache__"}
# What no test's result depends on.
LISTS = ("tests/mutations/", "tests/README.md")
# All sources read this first; a header of its own before it would undo it.
FIRST_HEADER = Path("source/precompiled.h")
SWITCH = b'#include "../tests/mutations/fault_switch.h"\n'


def copy_project(top, copy, faults):
    """The project with all faults of its sources; files that are the same stay
    as they are, so that only what has changed is built. Returns what tells the
    project from what it has been at another time."""
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
            if not str(place).startswith(LISTS):
                digest.update(str(place).encode() + content)
            mutated = by_file.pop(str(place), [])
            if mutated and mutated[0].is_script:
                for fault in mutated:  # each alone, when its turn comes
                    lists.apply([fault], content.decode())
            elif mutated:
                content = lists.apply(mutated, content.decode()).encode()
            if place == FIRST_HEADER:
                content += SWITCH
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


def configure(copy, tree):
    """The tests of a Release build, unit tests too; nothing is built."""
    tree.mkdir(exist_ok=True)
    run_quietly(tree / "cmake.log", "cmake", "-S", copy, "-B", tree,
                "-DCMAKE_BUILD_TYPE=Release", "-DTHERMOCONTACT_UNIT_TESTS=ON")
    return suite.tests_of(tree)


def build(tree, tests, n_jobs):
    """The program and what these tests need besides."""
    run_quietly(tree / "build.log", "make", "-C", tree, f"-j{n_jobs}",
                "thermocontact", "thermocontact_test_driver",
                *suite.targets_of(tests))


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
