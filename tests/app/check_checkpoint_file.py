#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes the checkpoints of a finished run, and goes on with it.

usage: check_checkpoint_file.py DIR

A checkpoint is a line with its format, a line of JSON with size and CRC-32 of
each part that follows, and the parts: archives of Boost, in which a text is its
length, 8 bytes, and its letters.
"""
import json
import re
import shutil
import struct
import sys
import zlib
from pathlib import Path

sys.dont_write_bytecode = True
from program import run, settings  # noqa: E402


def text(word):
    return struct.pack("<Q", len(word)) + word.encode()


def replace(path, old, new):
    """In one of the parts, once; with the checksum of the result."""
    form, header, rest = path.read_bytes().split(b"\n", 2)
    header = json.loads(header)
    assert rest.count(old) == 1, (old, rest.count(old))
    parts = []
    for part in header["parts"]:
        data, rest = rest[:part["size"]], rest[part["size"]:]
        data = data.replace(old, new)
        part.update(size=len(data), checksum=zlib.crc32(data))
        parts.append(data)
    path.write_bytes(b"\n".join([form, json.dumps(header).encode(),
                                 b"".join(parts)]))


def damage(path):
    data = bytearray(path.read_bytes())
    data[-20] ^= 1
    path.write_bytes(data)


def resume(reference, what, change, *overrides):
    """Goes on with a copy of the run whose newest and previous checkpoint were
    given to change()."""
    directory = Path("changed")
    shutil.copytree(reference, directory)
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
        version = json.loads(file.readline())["version"]
    resume(reference, "untouched", lambda newest, previous: None)
    resume(reference, "another version", lambda newest, previous: replace(
        newest, text(version), text("0.0.5-older")))
    resume(reference, "damaged", lambda newest, previous: damage(newest))
    resume(reference, "all damaged", lambda newest, previous: (
        damage(newest), damage(previous)))
    resume(reference, "another format", lambda newest, previous:
           newest.write_bytes(newest.read_bytes()[1:]))
    resume(reference, "an entry unknown then", lambda newest, previous: replace(
        newest, text("Mesh/Grading"), text("Mesh/" + "Gradinf")))
    resume(reference, "numbers of another mesh", lambda newest, previous: replace(
        newest, text("Mesh/Cells") + text("8"), text("Mesh/Cells") + text("9")),
        "Mesh/Cells=9")


main()
