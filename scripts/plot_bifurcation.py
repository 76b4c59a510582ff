"""Where the runs of a study are at each period of their drive, over what the
study varies: part of scripts/plot."""

import math

from plot_common import (COLOURS, convert, fail, label_axis, new_figure, plain,
                         read_rows, units_of)
from plot_sweep import curves_of, label_entry, number, numeric, read_sweep

POINTS = {"displacement_end": r"$u(1)$ at multiples of $P$",
          "velocity_end": r"$u_t(1)$ at multiples of $P$",
          "temperature_end": r"$\theta(1)$ at multiples of $P$"}
PEAKS = r"peak force of a period"
MOST_LABELS = 12


def directory_of(sweep, run):
    return sweep.path.parent / f"run-{run['run']}"


def wanted(path):
    """Whether runs have rows at a period, over an entry that is a number."""
    sweep = read_sweep(path)
    return bool(numeric(sweep)) and any(
        (directory_of(sweep, run) / "poincare.csv").exists()
        for run in sweep.runs)


def read(path, columns):
    _, header, rows = read_rows(path, columns)
    return convert(path, header, rows, columns)


def last_periods(times, n_periods):
    """The first of the last n periods among times at their ends; by default the
    second half."""
    n = len(times) - 1
    return max(n - (n_periods or math.ceil(n / 2)), 0)


def points_of(directory, n_periods):
    """Values by column at the ends of the last periods, and the largest
    magnitude of the force in each of them."""
    section = read(directory / "poincare.csv", ["time", *POINTS])
    first = last_periods(section["time"], n_periods)
    points = {name: section[name][first + 1:] for name in POINTS}
    history = read(directory / "contact.csv", ["time", "contact_force"])
    ends, peaks = section["time"][first:], []
    for begin, end in zip(ends, ends[1:]):
        forces = [abs(force) for time, force in zip(
            history["time"], history["contact_force"]) if begin < time <= end]
        peaks.append(max(forces, default=math.nan))
    points["peaks"] = peaks
    return points


def draw(path, n_periods):
    """n_periods: how many of the last ones; None: the second half of each run."""
    sweep = read_sweep(path)
    names = numeric(sweep)
    sweep.runs = [run for run in sweep.runs
                  if (directory_of(sweep, run) / "poincare.csv").exists()]
    if not sweep.runs:
        fail(path, "no run has a poincare.csv beside it",
             "set Output/Period and Study/Keep files = true")
    if not names:
        fail(path, "no varied entry has several values that are numbers, of "
             "runs that are done", "vary one")
    points = {run["run"]: points_of(directory_of(sweep, run), n_periods)
              for run in sweep.runs}
    labels = {**POINTS, "peaks": PEAKS}
    shown = [name for name in labels if any(
        math.isfinite(value) and (name != "peaks" or value > 0)
        for values in points.values() for value in values[name])]
    if not shown:
        fail(path, "no run has a whole period among those asked for",
             "a larger Time/End time")
    figure = new_figure(8, 2.4 * len(shown) + 0.8)
    figure.suptitle(plain(sweep.title, 90))
    comments, header, _ = read_rows(
        directory_of(sweep, sweep.runs[0]) / "contact.csv", [])
    units = units_of(comments, header)
    panels = figure.subplots(len(shown), 1, sharex=True, squeeze=False).flat
    for panel, name in zip(panels, shown):
        curves = curves_of(sweep, names[0])
        for i, (label, runs) in enumerate(curves.items()):
            xy = [(number(run[names[0]]), value) for run in runs
                  for value in points[run["run"]][name]]
            panel.plot([x for x, _ in xy], [y for _, y in xy], ".",
                       markersize=3, color=COLOURS[i % len(COLOURS)],
                       label=plain(label, 90) if i < MOST_LABELS else None,
                       rasterized=True)
        label_axis(panel.yaxis, labels[name], units.get(
            "contact_force" if name == "peaks" else name),
            [value for values in points.values() for value in values[name]])
        if label:
            left_out = len(curves) - MOST_LABELS
            panel.legend(fontsize=9, title=f"and {left_out} more"
                         if left_out > 0 else None)
    label_entry(panel.xaxis, sweep, names[0])
    return figure
