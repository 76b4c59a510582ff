"""What a study's runs came to over what it varies: part of scripts/plot."""

import argparse
import math

from plot_common import (fail, in_prefix, in_unit, label_axis, looks, new_figure, plain,
                         prefix_of, read_rows, title_of, units_of)
from plot_study import MARKERS, NO_WORD

RESULTS = {"first_contact_time": "time of the first contact",
           "contact_begins": "number of contacts",
           "contact_duration": "time in contact",
           "max_contact_force": "largest contact force",
           "max_penetration": "largest penetration",
           "contact_impulse": "contact impulse",
           "restitution": "coefficient of restitution",
           "final_displacement_end": r"final displacement  $u(1, T)$",
           "final_temperature_end": r"final temperature  $\theta(1, T)$",
           "reached_state_of_rest": "steady state reached, number"}
WHOLE = ("contact_begins", "reached_state_of_rest")  # no ticks between them
LEAST_MAP = 4  # values of each of two entries from which on there is a map
MOST_CURVES = 12  # that can be told apart


def number(word):
    try:
        value = float(word)
    except ValueError:
        return math.nan
    return value if math.isfinite(value) else math.nan


def read_sweep(path):
    """Title, varied entries, and the runs that are done: words by column."""
    comments, header, rows = read_rows(path, ["run", "status"])
    runs = [dict(zip(header, row)) for _, row in rows]
    done = [run for run in runs if run["status"] == "done"]
    return argparse.Namespace(
        path=path, title=title_of(comments) or path.parent.resolve().name,
        units=units_of(comments, header),
        varied=header[header.index("run") + 1:header.index("status")],
        n_runs=len(runs), runs=done,
        results=[name for name in RESULTS if name in header and any(
            not math.isnan(number(run[name])) for run in done)])


def numeric(sweep):
    """Varied entries with several values, all of them numbers, most first."""
    values = {name: {run[name] for run in sweep.runs} for name in sweep.varied}
    names = [name for name in sweep.varied if len(values[name]) > 1
             and not any(math.isnan(number(word)) for word in values[name])]
    return sorted(names, key=lambda name: -len(values[name]))


def wanted(path):
    """Whether there is something to draw."""
    sweep = read_sweep(path)
    names = numeric(sweep)
    return bool(sweep.results and names and (
        is_map(sweep, names) or len(curves_of(sweep, names[0])) <= MOST_CURVES))


def is_map(sweep, names):
    """Whether two entries with enough numbers each, and no other, are varied."""
    return len(names) > 1 and len({run[names[1]] for run in sweep.runs}) >= LEAST_MAP and not any(
        len({run[name] for run in sweep.runs}) > 1 for name in sweep.varied if name not in names[:2])


def scale_of(values):
    """Logarithmic for positive values over more than a decade and a half."""
    low, high = min(values), max(values)
    return "log" if low > 0 and high > 30 * low else "linear"


def value_of(sweep, name, run):
    """A varied entry of a run, as text."""
    unit = sweep.units.get(name)
    return in_prefix(number(run[name]), unit) if unit else run[name]


def curves_of(sweep, axis):
    """Runs by label, a curve for each combination of the other entries."""
    others = [name for name in sweep.varied if name != axis
              and len({run[name] for run in sweep.runs}) > 1]
    curves = {}
    for run in sweep.runs:
        words = [f"{name.split('/')[-1].lower()} {value_of(sweep, name, run)}"
                 if NO_WORD.match(run[name]) else run[name] for name in others]
        curves.setdefault(", ".join(words), []).append(run)
    for runs in curves.values():
        runs.sort(key=lambda run: number(run[axis]))
    return curves


def whole_numbers(result):
    """Where the ticks of a result that has no values between them are; else None."""
    from matplotlib.ticker import MaxNLocator
    return MaxNLocator(integer=True, min_n_ticks=1) if result in WHOLE else None


def label_entry(axis, sweep, name):
    """Label and ticks of an axis for a varied entry."""
    label_numbers(axis, name.split("/")[-1].lower(), sweep, name)


def label_numbers(axis, label, sweep, name):
    """Label and ticks of an axis for a column."""
    unit = sweep.units.get(name)
    if axis.get_scale() == "log":
        axis.set_label_text(in_unit(label, unit))
    else:
        label_axis(axis, label, unit, [number(run[name]) for run in sweep.runs])


def differs(sweep, result):
    """Whether a result varies by more than rounding and steps leave of it."""
    values = [v for v in (number(run[result]) for run in sweep.runs) if not math.isnan(v)]
    return max(values) - min(values) > 1e-6 * max(map(abs, values))


def draw_curves(figure, sweep, results, axis):
    curves = curves_of(sweep, axis)
    if len(curves) > MOST_CURVES:
        fail(sweep.path, f"{len(curves)} curves cannot be told apart",
             "vary fewer entries in one study, or two with a number each")
    columns = columns_of(results, False)
    rows = math.ceil(len(results) / columns)
    beside = max(1, min(4, 110 // (8 + max(len(label) for label in curves))))
    below = math.ceil(len(curves) / beside) * any(curves)
    grid = figure.add_gridspec(rows + 1, columns,
                               height_ratios=[12] * rows + [0.1 + below])
    for k, name in enumerate(results):
        panel = figure.add_subplot(grid[divmod(k, columns)])
        for i, (label, runs) in enumerate(curves.items()):
            points = [(number(run[axis]), number(run[name])) for run in runs]
            points = [point for point in points if not math.isnan(point[1])]
            panel.plot([x for x, _ in points], [y for _, y in points],
                       label=plain(label, 90), markersize=4,
                       marker=MARKERS[i % len(MARKERS)], **looks(i))
        panel.set_xscale(scale_of([number(run[axis]) for run in sweep.runs]))
        label_entry(panel.xaxis, sweep, axis)
        label_numbers(panel.yaxis, RESULTS[name], sweep, name)
        if ticks := whole_numbers(name):
            panel.yaxis.set_major_locator(ticks)
    legend = figure.add_subplot(grid[rows, :])
    legend.axis("off")
    if below:
        legend.legend(*panel.get_legend_handles_labels(), ncol=beside,
                      loc="upper center", borderaxespad=0, fontsize=10)


def draw_maps(figure, sweep, results, axes):
    """A map over two entries, a cell of equal size for each pair of values; what
    is missing is white."""
    xs, ys = (sorted({run[name] for run in sweep.runs}, key=number)
              for name in axes)
    columns = columns_of(results, True)
    rows = math.ceil(len(results) / columns)
    panels = figure.subplots(rows, columns, squeeze=False)
    for k, (panel, name) in enumerate(zip(panels.flat, results)):
        values = [[math.nan] * len(xs) for _ in ys]
        for run in sweep.runs:
            values[ys.index(run[axes[1]])][xs.index(run[axes[0]])] = number(
                run[name])
        cells = panel.pcolormesh(range(len(xs)), range(len(ys)), values,
                                 shading="nearest", cmap="viridis",
                                 rasterized=True)
        panel.grid(False)
        for axis, entry, words, is_labelled in (
                (panel.xaxis, axes[0], xs, k + columns >= len(results)),
                (panel.yaxis, axes[1], ys, k % columns == 0)):
            unit, shown = sweep.units.get(entry), range(0, len(words), 1 + len(words) // 20)
            prefix, power = prefix_of(unit, [number(words[len(words) // 2])])
            axis.set_ticks(shown, [f"{number(words[i]) / 10.**power:g}" if power else words[i]
                                   for i in shown],
                           rotation=90 * (axis is panel.xaxis and len(xs) > 6))
            if is_labelled:
                axis.set_label_text(in_unit(entry.split("/")[-1].lower(),
                                            prefix + unit if unit else None))
        bar = figure.colorbar(cells, ax=panel, ticks=whole_numbers(name))
        label_numbers(bar.ax.yaxis, RESULTS[name], sweep, name)
        panel.set_title(bar.ax.get_ylabel(), fontsize=11)
        bar.set_label("")
    for panel in list(panels.flat)[len(results):]:
        panel.remove()
    figure.align_ylabels()


def columns_of(results, as_map):
    """Panels beside each other, so that the last row is full if that can be."""
    n = len(results)
    return n if n < 3 else 2 if n % 2 == 0 and (n % 3 or n == 4) and as_map else 3


def draw(path, result):
    """result: one key result; None: all that differ between runs."""
    sweep = read_sweep(path)
    names = numeric(sweep)
    if not names:
        fail(path, "no varied entry has several values that are numbers, of "
             "runs that are done", "vary one")
    if result and result not in sweep.results:
        fail(path, f"no run has a {result}", "draw another result")
    differing = [name for name in sweep.results if differs(sweep, name)]
    results = [result] if result else differing or sweep.results
    as_map = is_map(sweep, names)
    columns = columns_of(results, as_map)
    figure = new_figure(3.6 * columns + 0.8,
                        2.9 * math.ceil(len(results) / columns) + 0.8)
    left_out = sweep.n_runs - len(sweep.runs)
    figure.suptitle(plain(sweep.title, 90) + (
        f"\n{left_out} of {sweep.n_runs} runs failed: not drawn"
        if left_out else ""))
    if as_map:
        draw_maps(figure, sweep, results, names[:2])
    else:
        draw_curves(figure, sweep, results, names[0])
    return figure
