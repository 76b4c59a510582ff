#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_wide.py DIR [N [SEED]]

Runs N scenes that wide_scenes.py draws over the ranges of doc/stability.md, for at most
8 MB of a file, and checks what holds in all of them (faults_of_wide of properties.py). A
scene may be refused, or stop with a message; at most one in twenty does. DIR is not read.
Exit status 1 if a scene fails.
"""
import shutil
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
from program import for_all, run, settings  # noqa: E402
from properties import faults_of_wide  # noqa: E402
from run_files import Run  # noqa: E402
from wide_scenes import WideScene  # noqa: E402

N = int(sys.argv[2]) if len(sys.argv) > 2 else 150
FIRST = int(sys.argv[3]) if len(sys.argv) > 3 else 1


def options(seed):
    return settings(f"{name}={value}" for name, value in WideScene(seed).items())


def try_scene(seed, parent):
    """"done", "ended" with a message, or faults."""
    directory = parent / str(seed)
    status, _, message = run("--quiet", "--output", directory, *options(seed),
                             parent / "x.prm", file_size=8_000_000)
    if status:
        word = "ended" if status < 3 and message else f"status {status}: {message}"
    else:
        word = "; ".join(list(faults_of_wide(Run(directory)))[:3]) or "done"
    shutil.rmtree(directory, ignore_errors=True)
    return word


with tempfile.TemporaryDirectory() as parent:
    Path(parent, "x.prm").write_text("# defaults\n")
    words = for_all(lambda seed: try_scene(seed, Path(parent)), range(FIRST, FIRST + N))
for seed, word in enumerate(words, FIRST):
    if word not in ("done", "ended"):
        print(f"scene {seed}: {word}\n  " + " ".join(
            o if o == "--set" else f"'{o}'" for o in options(seed)))
ended = words.count("ended")
print(f"{N} scenes, {'at most a twentieth' if ended <= N / 20 else ended} ended by a message, "
      f"{N - ended - words.count('done')} fail")
sys.exit(N > ended + words.count("done"))
