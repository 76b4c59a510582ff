"""Histories at the probes of runs: part of scripts/plot, see there."""

import math
import re

from plot_common import COLOURS, DASHES
from plot_run import PROBE

LABELS = {"temperature": r"temperature  $\theta$",
          "displacement": r"displacement  $u$",
          "velocity": r"velocity  $u_t$", "stress": r"stress  $\sigma$"}
POSITION = re.compile(r"probe (\d+):\s*(.*)")


def histories_of(runs):
    """By field: (run, number of the probe, times, values), if any is finite."""
    histories = {}
    for run in runs:
        table = run.probes[1] if run.probes else {"time": []}
        for name, values in table.items():
            match = PROBE.match(name)
            if match and any(map(math.isfinite, values)):
                histories.setdefault(match[1], []).append(
                    (run, int(match[2]), table["time"], values))
    return {name: histories[name] for name in LABELS if name in histories}


def place_of(run, probe):
    for comment in run.probes[0]:
        match = POSITION.match(comment)
        if match and int(match[1]) == probe:
            place = re.sub(r"([xyz]) = ([-+.\deE]+)",
                           lambda m: f"${m[1]}$ = {float(m[2]):g}", match[2])
            return f"probe {probe}: {place}"
    return f"probe {probe}"


def looks_of(runs, run, probe):
    """Probes by colour, runs by dashes; one run alone has both by probe."""
    i = probe - 1 if len(runs) == 1 else runs.index(run)
    return {"color": COLOURS[(probe - 1) % len(COLOURS)],
            "linestyle": DASHES[i % len(DASHES)]}


def handles_of(runs, histories):
    """For the legend: a line for each probe, then one for each run."""
    from matplotlib.lines import Line2D
    probes = {}
    for run, probe, _, _ in [h for field in histories.values() for h in field]:
        probes.setdefault(place_of(run, probe), (run, probe))
    handles = [Line2D([], [], label=label, **looks_of(runs[:1], *which))
               if len(runs) == 1 else
               Line2D([], [], label=label, color=looks_of(runs, *which)["color"])
               for label, which in probes.items()]
    return handles + [Line2D([], [], color="black", label=run.title,
                             linestyle=DASHES[i % len(DASHES)])
                      for i, run in enumerate(runs) if len(runs) > 1]


def draw_probes(runs, panels_of, finish):
    """
    panels_of, finish: make the panels with their legend, and what all pictures
    of runs have in common in the end (plot_figures).
    """
    runs = [run for run in runs if run.probes]
    histories = histories_of(runs)
    figure, panels = panels_of(histories, 2, 2.3, handles_of(runs, histories))
    for name, axes in panels.items():
        axes.set_ylabel(LABELS[name])
        for run, probe, times, values in histories[name]:
            axes.plot(times, values, zorder=3, **looks_of(runs, run, probe))
        axes.ticklabel_format(axis="y", scilimits=(-3, 4))
    if len(runs) == 1:
        figure.suptitle(runs[0].title, fontsize=11)
    finish(figure, panels, runs)
    return figure
