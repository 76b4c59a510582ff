#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: impacts.py PROGRAM [SEED [N]]

Key results of random impacts of a rod, with all settings of the numerics at their
defaults, and their error bars, beside runs of the scheme without dispersion on many cells:
elastic, weakly and strongly viscous rods, hard and soft obstacles, one stop or two. A bar
is the sum of the one in time and the one in space. Printed are, for each key result, how
many errors are within one and within three bars, how many bars are not known, the largest
relative error; and each error beyond three bars. Minutes.

The fine runs are made with three numbers of CELLS, as two may agree by luck: times of release
fall on other parts of a step. Their largest difference is what the truth may be wrong by;
where the peak force differs by more than a tenth of itself, it has no limit, and a bar that
is a number is a fault.
"""
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

KEYS = ("first_contact_time", "max_contact_force", "max_penetration", "contact_impulse",
        "final_displacement_end")
CELLS = (3200, 2240, 1600)


def log_uniform(generator, low, high):
    return 10 ** generator.uniform(math.log10(low), math.log10(high))


def draw_scene(generator):
    """Entries of a scene, and its kind in words"""
    inertia = log_uniform(generator, 0.03, 3)
    kind = generator.choice(("elastic", "weakly viscous", "strongly viscous"))
    viscosity = {"elastic": 0, "weakly viscous": log_uniform(generator, 1e-5, 1e-2),
                 "strongly viscous": log_uniform(generator, 1e-2, 1)}[kind] * math.sqrt(inertia)
    velocity = log_uniform(generator, 0.01, 1)
    gap = generator.choice((0, generator.uniform(0, 0.5))) * velocity
    entries = {"Model/Fields": "displacement", "Model/Inertia": f"{inertia:.4g}",
               "Model/Viscosity": f"{viscosity:.4g}",
               "Time/End time": f"{generator.uniform(2, 6) * math.sqrt(inertia):.4g}"}
    if generator.random() < 0.5:
        entries.update({"Initial values/Velocity": f"{velocity:.4g}*x",
                        "Contact/Gap": f"{gap:.4g}"})
    else:
        entries.update({"Initial values/Velocity": "0",
                        "Contact/Gap": f"{gap:.4g}-{velocity:.4g}*t"})
    law = generator.choice(("rigid", "normal compliance", "power law"))
    entries["Contact/Condition"] = law
    if law != "rigid":
        entries["Contact/Compliance"] = f"{log_uniform(generator, 1e-4, 1):.4g}"
    if law == "power law":
        entries["Contact/Exponent"] = f"{generator.uniform(1.2, 2.5):.3g}"
    if "t" not in entries["Contact/Gap"] and generator.random() < 0.4:
        entries["Contact/Rear gap"] = f"{generator.uniform(0.05, 0.5) * velocity:.4g}"
    return entries, f"{kind}, {law}"


def run(program, directory, entries):
    """summary.json, or None with the message"""
    options = [word for path, value in entries.items() for word in ("--set", f"{path}={value}")]
    done = subprocess.run([program, "--quiet", "--output", directory, *options,
                           directory.parent / "empty.prm"], capture_output=True, text=True,
                          check=False)
    if done.returncode:
        return None, done.stderr
    return json.loads((directory / "summary.json").read_text()), ""


def number(value):
    return math.nan if value is None else value


def main():
    program = sys.argv[1]
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    n_scenes = int(sys.argv[3]) if len(sys.argv) > 3 else 60
    generator = random.Random(seed)
    counts = {key: [0, 0, 0, 0, 0.0] for key in KEYS}
    n_good = n_divergent = n_false = 0
    with tempfile.TemporaryDirectory() as name:
        directory = Path(name)
        (directory / "empty.prm").write_text("# defaults\n", encoding="utf-8")
        for scene in range(n_scenes):
            entries, kind = draw_scene(generator)
            base = {**entries, "Output/Fields interval": "0", "Output/Contact interval": "1e9"}
            summary, message = run(program, directory / "default",
                                   {**base, "Output/Error bars": "true"})
            fine = [run(program, directory / "fine",
                        {**base, "Time/Scheme": "box", "Mesh/Cells": cells})[0]
                    for cells in CELLS]
            if summary is None or None in fine:
                print(f"scene {scene} ({kind}) FAILS: {entries}\n  {message}", flush=True)
                continue
            is_good = True
            words = []
            for key in KEYS:
                value, truth, *others = (number(each[key]) for each in (summary, *fine))
                bar = number(summary[f"{key}_time_error"])
                space = number(summary[f"{key}_space_error"])
                bar = space if math.isnan(bar) else bar + (0 if math.isnan(space) else space)
                error, doubt = abs(value - truth), max(abs(truth - other) for other in others)
                if math.isnan(value) and math.isnan(truth):
                    continue
                if key == "max_contact_force" and doubt > 0.1 * abs(truth):
                    n_divergent += 1
                    if not math.isnan(bar):
                        n_false += 1
                        words.append(f"{key} has no limit, and a bar {bar:.2g}")
                    continue
                count = counts[key]
                if math.isnan(bar):
                    count[3] += math.isfinite(value)
                    continue
                count[0] += 1
                relative = error / abs(truth) if truth else error
                count[4] = max(count[4], relative)
                count[1] += error <= bar + doubt
                if error <= 3 * bar + doubt or error <= 1e-10 * abs(truth):
                    count[2] += 1
                    continue
                is_good = False
                words.append(f"{key} {value:.6g} for {truth:.6g} ({doubt:.1g}), bar {bar:.2g}: "
                             f"{error / bar if bar else math.inf:.1f} bars")
            n_good += is_good
            if words:
                print(f"scene {scene} ({kind}): " + "; ".join(words) +
                      "\n  " + " ; ".join(f"{k}={v}" for k, v in entries.items()), flush=True)
    print(f"{n_good} of {n_scenes} scenes within 3 bars; {n_divergent} peaks without limit, "
          f"{n_false} of them with a bar")
    for key, (n, one, three, unknown, largest) in counts.items():
        print(f"  {key}: {n} bars, within one {one}, within three {three}, unknown {unknown}, "
              f"largest relative error {largest:.2g}")


if __name__ == "__main__":
    main()
