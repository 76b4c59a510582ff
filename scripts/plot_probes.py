"""Histories at the probes of runs: part of scripts/plot, see there."""

import math
import re

from plot_common import COLOURS, DASHES, fail, in_prefix, label_axis
from plot_run import PROBE

LABELS = {"temperature": r"temperature  $\theta$",
          "displacement": r"displacement  $u$",
          "velocity": r"velocity  $u_t$", "stress": r"stress  $\sigma$"}
UNITS_AT_END = {name: f"{name}_end" for name in LABELS}  # as in contact.csv
POSITION = re.compile(r"probe (\d+):\s*(.*)")


def histories_of(runs):
    """By field: (run, number of the probe, times, values), if any is finite."""
    histories = {}
    for run in runs:
        table = run.probes[1]
        for name, values in table.items():
            match = PROBE.match(name)
            if match and any(map(math.isfinite, values)):
                histories.setdefault(match[1], []).append(
                    (run, int(match[2]), table["time"], values))
    return {name: histories[name] for name in LABELS if name in histories}


def place_of(run, probe):
    """As the comments of probes.csv have it."""
    for comment in run.probes[0]:
        match = POSITION.match(comment)
        if match and int(match[1]) == probe:
            place = re.sub(r"([xyz]) = ([-+.\deE]+)(?: (m)\b)?", lambda m: "${}$ = {}".format(
                m[1], in_prefix(float(m[2]), m[3])), match[2])
            return f"probe {probe}: {place}"
    return f"probe {probe}"


def looks_of(runs, run, probe):
    """Probes by colour, runs by dashes; one run alone has both by probe."""
    i = probe - 1 if len(runs) == 1 else runs.index(run)
    return {"color": COLOURS[(probe - 1) % len(COLOURS)],
            "linestyle": DASHES[i % len(DASHES)]}


def check_looks(runs, histories):
    """Ends if two curves of a panel would look alike."""
    for curves in histories.values():
        looks = [str(looks_of(runs, run, probe)) for run, probe, _, _ in curves]
        if len(set(looks)) < len(looks):
            fail(runs[0].directory, f"{len(looks)} histories at probes cannot "
                 "be told apart in one picture", "draw at most 12 probes of one "
                 f"run, or {len(COLOURS)} of each of {len(DASHES)} runs")


def handles_of(runs, histories):
    """For the legend: a line for each probe, then one for each run."""
    from matplotlib.lines import Line2D
    probes = {}
    curves = [h for field in histories.values() for h in field]
    places = {(probe, place_of(run, probe)) for run, probe, _, _ in curves}
    for run, probe, _, _ in curves:
        elsewhere = len([1 for number, _ in places if number == probe]) > 1
        probes.setdefault(place_of(run, probe) + (
            f" ({run.title})" if elsewhere else ""), (run, probe))
    handles = [Line2D([], [], label=label, **looks_of(runs[:1], *which))
               if len(runs) == 1 else
               Line2D([], [], label=label, color=looks_of(runs, *which)["color"])
               for label, which in probes.items()]
    return handles + [Line2D([], [], color="black", label=run.title,
                             linestyle=DASHES[i % len(DASHES)])
                      for i, run in enumerate(runs) if len(runs) > 1]


def draw_probes(runs, histories, panels):
    """panels: axes by the name of the field"""
    check_looks(runs, histories)
    for name, axes in panels.items():
        for run, probe, times, values in histories[name]:
            axes.plot(times, values, zorder=3, **looks_of(runs, run, probe))
        label_axis(axes.yaxis, LABELS[name], runs[0].units.get(UNITS_AT_END[name]),
                   [value for *_, values in histories[name] for value in values])
