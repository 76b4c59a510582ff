#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_properties.py DIR [N [SEED]]

Runs N scenes that scenes.py draws by SEED, SEED + 1, ... and checks what properties.py
says of each. Then each column and key of each run is falsified in turn, as falsify.py
says, until the way is noticed: every one has to be in at least one of the scenes. Scenes
that the program refuses are counted. DIR is not read.
"""
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
from check_log import faults_of_log  # noqa: E402
from falsify import falsified  # noqa: E402
from program import for_all, run, settings  # noqa: E402
from properties import TIMES, check  # noqa: E402
from run_files import Run  # noqa: E402
from scenes import draw  # noqa: E402

# Wall times and counts are known to be such; what a small factor changes is not known of
# forecasts, which are compared with the run itself.
LOOSE = {f"summary.json/{name}" for name in (
    *TIMES, "predicted_steps", "predicted_critical_step_size", "predicted_first_contact_time",
    "predicted_first_penetration", "predicted_displacement_end", "solves", "responses",
    "factorizations")} | {
        "contact.csv/iterations", "steps.csv/wall_seconds", "steps.csv/error",
        "contact.csv/moment_z", "contact.csv/moment_y", "contact.csv/max_pressure",
        "contact.csv/contact_area", "contact.csv/lateral_dissipation", "events.csv/velocity"}
N = int(sys.argv[2]) if len(sys.argv) > 2 else 60
FIRST = int(sys.argv[3]) if len(sys.argv) > 3 else 1


tried, noticed = set(), set()  # falsifications, in all scenes


def try_scene(seed, directory):
    """Words on a scene."""
    overrides = draw(seed)
    status, _, message = run("--quiet", "--output", directory, *settings(
        f"{name}={value}" for name, value in overrides.items()), directory.parent / "x.prm")
    if status != 0:
        return ("refused" if status == 2 else f"status {status}"), message
    result = Run(directory)
    faults = [*check.faults(result), *faults_of_log(result)]
    if faults:
        return "faults", "; ".join(faults[:3])
    for name, way, other in falsified(result):
        way = "without a row" if way.startswith("without row") else way
        if name not in LOOSE and (name, way) not in noticed:
            tried.add((name, way))
            if next(check.faults(other, name), None):
                noticed.add((name, way))
    return "done", ""


with tempfile.TemporaryDirectory() as parent:
    Path(parent, "x.prm").write_text("# defaults\n")
    results = dict(zip(range(FIRST, FIRST + N), for_all(
        lambda seed: try_scene(seed, Path(parent, f"scene-{seed}")),
        range(FIRST, FIRST + N))))
for seed, (word, message) in results.items():
    if word not in ("done", "refused"):
        print(f"scene {seed}: {word}: {message}",
              *(f"{name}={value}" for name, value in draw(seed).items()), sep="\n  ")
words = [word for word, _ in results.values()]
print(f"scenes {N}, at most a quarter refused {words.count('refused') <= N // 4}")
missed = sorted(f"{name} {way}" for name, way in tried - noticed)
print("columns and keys falsified one at a time, not noticed:", ", ".join(missed) or "none")
