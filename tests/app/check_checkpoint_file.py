#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes the checkpoints of a finished run, and goes on with it.

usage: check_checkpoint_file.py DIR

A checkpoint is a line with its format, one with the CRC-32 of the next, a line of
JSON with size and CRC-32 of each part that follows, and the parts.
"""
import json
import re
import shutil
import sys
import zlib
from pathlib import Path

sys.dont_write_bytecode = True
from program import run, settings  # noqa: E402


def replace(path, old, new):
    """In the line of JSON, once; with its checksum."""
    form, _, header, parts = path.read_bytes().split(b"\n", 3)
    assert header.count(old.encode()) == 1, (old, header.count(old.encode()))
    header = header.replace(old.encode(), new.encode())
    path.write_bytes(b"\n".join([form, str(zlib.crc32(header)).encode(), header, parts]))


def damage(path):
    data = bytearray(path.read_bytes())
    data[-20] ^= 1
    path.write_bytes(data)


def resume(reference, what, change, *overrides, times=1):
    """Goes on with a copy of the run whose newest and previous checkpoint were
    given to change()."""
    directory = Path("changed")
    shutil.copytree(reference, directory)
    for _ in range(times):
        change(directory / "checkpoint.bin", directory / "checkpoint.previous.bin")
        status, screen, message = run(
            "--resume", "--output", directory,
            *settings(["Time/End time=0.02", *overrides]), reference / "used.prm")
    _, _, log = (directory / "log.txt").read_text().rpartition("  resumed ")
    shutil.rmtree(directory)
    warnings = re.findall(r"^  warning:  (.*)", screen, re.MULTILINE)
    message = message.partition("\n  meaning:")[0].rpartition("used.prm, line ")[2]
    print(f"{what}: status {status}, warnings {len(warnings)}, in log.txt as on",
          f"the screen {all(warning in log for warning in warnings)}")
    for line in [*warnings, *message.strip().splitlines()]:
        print(" ", re.sub(r"^\d+: ", "", line.strip()))


def main():
    reference = Path(sys.argv[1])
    with open(reference / "checkpoint.bin", "rb") as file:
        file.readline()
        file.readline()
        version = json.loads(file.readline())["version"]
    resume(reference, "untouched", lambda newest, previous: None)
    resume(reference, "another version", lambda newest, previous: replace(
        newest, json.dumps(version), '"0.0.5-older"'))
    resume(reference, "other columns", lambda newest, previous: replace(
        newest, '"stress_end"', '"stress"'))
    # the previous one is whole the next time, too
    resume(reference, "damaged", lambda newest, previous: damage(newest), times=2)
    resume(reference, "all damaged", lambda newest, previous: (
        damage(newest), damage(previous)))
    resume(reference, "another format", lambda newest, previous:
           newest.write_bytes(newest.read_bytes()[1:]))
    resume(reference, "an entry unknown then", lambda newest, previous: replace(
        newest, '"Mesh/Grading"', '"Mesh-Grading"'))
    resume(reference, "numbers of another mesh", lambda newest, previous: replace(
        newest, '"Mesh/Cells":"8"', '"Mesh/Cells":"9"'),
        "Mesh/Cells=9")


main()
