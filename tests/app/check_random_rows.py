#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random rows of rods, layers and masses against tests/reference/random_rows.py, an independent program.

usage: check_random_rows.py DIR [SEED [NUMBER]]

Impulses of all contacts and the displacement of the right end at the end of the run, to 5e-3 of the largest impulse (of
the momentum scale 1): both are of first order in their steps where contacts begin and end within them.
"""
import csv
import shutil
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "reference"))
from random_rows import Scene, solve  # noqa: E402
from program import for_all, run, settings  # noqa: E402

first, number = (int(word) for word in (sys.argv[2:] + ["1", "24"][len(sys.argv) - 2:])[:2])
BOUND = 5e-3


def compare(seed):
    scene = Scene(seed)
    if not scene.moves:
        return seed, 0., ""
    directory = Path(f"row-{seed}")
    status, _, message = run("--quiet", "--output", directory, "rows.prm", *settings(scene.overrides()), seconds=100)
    if status != 0:
        return seed, float("inf"), message.splitlines()[0] if message else f"status {status}"

    def last(name):
        with open(directory / name) as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))[-1]
    impulses, displacement = solve(scene)
    found = [float(last(f"contacts/{name}.csv")["contact_impulse"]) for name in scene.contacts()]
    end = float(last("contact.csv")["displacement_end"])
    shutil.rmtree(directory)
    scale = max([1.] + impulses)
    errors = [abs(a - b) / scale for a, b in zip(found + [end], impulses + [displacement])]
    return seed, max(errors), " ".join(f"{a:.4f}/{b:.4f}" for a, b in zip(found + [end], impulses + [displacement]))


def main():
    Path("rows.prm").write_text("# rows\nsubsection Output\nset Fields interval = 0\nset Contact interval = 0.1\nend\n")
    results = for_all(compare, range(first, first + number))
    bad = [f"{seed}: {error:.1e} {words}" for seed, error, words in results if not error <= BOUND]
    print(f"{number} random rows:", "; ".join(bad) or f"all within {BOUND}")
    if len(sys.argv) > 3:
        print("largest", sorted((error for _, error, _ in results), reverse=True)[:8])


main()
