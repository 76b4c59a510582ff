#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random rows of rods, layers and masses against tests/reference/random_rows.py, an independent program.

usage: check_random_rows.py DIR [SEED [NUMBER]]

Impulses of all contacts and the displacement of the right end at the end of the run, to 5e-3 of the largest impulse (of
the momentum scale 1): both are of first order in their steps where contacts begin and end within them.

Begins and ends of contacts are in the order of the independent program, but for those that are closer to each other
than the errors of its times, which it shows with steps twice as long. A contact, or a pause of it, that is as short as
few steps is none. From one on that is not longer than the errors of its ends, and at the end of the run, nothing is
said of a contact; the same from one on that is somewhat longer and that one of the programs alone has. Nothing at all
is said if the independent program finds another number of events with longer steps.
"""
import csv
import shutil
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "reference"))
from random_rows import Scene, solve, without_short_ones  # noqa: E402
from program import for_all, run, settings  # noqa: E402

first, number = (int(word) for word in (sys.argv[2:] + ["1", "24"][len(sys.argv) - 2:])[:2])
BOUND = 5e-3
PLACES = 200  # in a tenth
STEP = 0.1 / PLACES
SHORTEST = 10 * STEP
SHORT = 4 * SHORTEST  # one or two steps of the program
LATEST = 20 * STEP  # before the end of the run


def rows_of(path):
    with open(path) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


class Order:
    """The events of the contacts of a run, against those of the independent program with two steps."""

    def __init__(self, end, names, found, fine, coarse):
        self.events, self.faults, self.n_left_out = [], [], 0  # time of both, error of one
        for name, *all_times in zip(names, found, fine, coarse):
            here, there, rough = (without_short_ones(times, SHORTEST) for times in all_times)
            if len(there) != len(rough):
                self.n_left_out += 1
                continue
            errors = [2 * abs(a - b) + STEP for a, b in zip(there, rough)]
            n = next((i for i in range(len(there)) if there[i] > end - LATEST or i + 1 < len(there) and
                      there[i + 1] - there[i] <= errors[i] + errors[i + 1]), len(there))
            short = [i for times in (here, there) for i in range(len(times) - 1) if times[i + 1] - times[i] < SHORT]
            if len(here) != len(there):
                n = min([n, *short])
            goes_on = n == len(there) and n not in short
            if len(here) < n or goes_on and any(time < end - 2 * LATEST for time in here[n:]):
                self.faults.append(f"{name} has {len(here)} events, not {n}")
                continue
            self.events += [(there[i], here[i], errors[i], f"{name} {'end' if i % 2 else 'begin'} {there[i]:.4f}")
                            for i in range(n)]
        self.events.sort()
        self.n_pairs = 0
        for i, (time, here, error, event) in enumerate(self.events):
            for later, here_later, other_error, other in self.events[i + 1:]:
                if later - time > error + other_error:
                    self.n_pairs += 1
                    if here_later < here:
                        self.faults.append(f"{event} found at {here:.4f}, behind {other} found at {here_later:.4f}")


def compare(seed):
    scene = Scene(seed)
    if not scene.moves:
        return seed, 0., "", None
    directory = Path(f"row-{seed}")
    status, _, message = run("--quiet", "--output", directory, "rows.prm", *settings(scene.overrides()), seconds=100)
    if status != 0:
        return seed, float("inf"), message.splitlines()[0] if message else f"status {status}", None
    impulses, displacement, changes = solve(scene, PLACES)
    names = scene.contacts()
    found = [float(rows_of(directory / f"contacts/{name}.csv")[-1]["contact_impulse"]) for name in names]
    end = float(rows_of(directory / "contact.csv")[-1]["displacement_end"])
    events = rows_of(directory / "events.csv")
    shutil.rmtree(directory)
    scale = max([1.] + impulses)
    errors = [abs(a - b) / scale for a, b in zip(found + [end], impulses + [displacement])]
    order = Order(scene.end_time, names,
                  [[float(event["time"]) for event in events if event["contact"] == name] for name in names],
                  changes, solve(scene, PLACES // 2)[2])
    return seed, max(errors), " ".join(
        f"{a:.4f}/{b:.4f}" for a, b in zip(found + [end], impulses + [displacement])), order


def main():
    Path("rows.prm").write_text("# rows\nsubsection Output\nset Fields interval = 0\nset Contact interval = 0.1\nend\n")
    results = for_all(compare, range(first, first + number))
    bad = [f"{seed}: {error:.1e} {words}" for seed, error, words, _ in results if not error <= BOUND]
    print(f"{number} random rows:", "; ".join(bad) or f"all within {BOUND}")
    orders = [(seed, order) for seed, *_, order in results if order]
    wrong = [f"{seed}: {fault}" for seed, order in orders for fault in order.faults]
    n_events = sum(len(order.events) for _, order in orders)
    print("order of events:", "; ".join(wrong) or ("the same" if n_events > 3 * number else f"of {n_events} alone"))
    if len(sys.argv) > 3:
        print("largest", sorted((error for _, error, *_ in results), reverse=True)[:8])
        print(n_events, "events,", sum(order.n_pairs for _, order in orders), "pairs in order,",
              sum(order.n_left_out for _, order in orders), "contacts left out, times differ by at most",
              max((abs(a - b) for _, order in orders for a, b, *_ in order.events), default=0))


main()
