"""What a study's runs came to over what it varies: part of scripts/plot."""

import argparse
import math
import re

from plot_common import (PREFIXES, fail, in_prefix, in_unit, label_axis, looks, new_figure, plain,
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
           "reached_state_of_rest": "steady state reached, number",
           "final_contact_force": "final contact force"}
WARNINGS = ("warnings", "warning_texts")  # behind the results
WHOLE = ("contact_begins", "reached_state_of_rest")  # no ticks between them
LEAST_MAP = 4  # values of each of two entries from which on there is a map
MOST_CURVES = 12  # that can be told apart
MOST_NUMBERS = 120  # that can be read in the cells of a map
LEAST_DISTANCE = 0.045  # of ticks, in lengths of an axis
LEAST_WIDTH = 0.065  # of cells whose numbers are level, in widths of all panels beside each other
SHORT = {"peak force": "max_contact_force", "peak penetration": "max_penetration",
         "impulse": "contact_impulse"}  # as on the screen


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
        results=[name for name in header[header.index("final_error_energy") + 1:]
                 if name not in WARNINGS and any(
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
    unit, value = sweep.units.get(name), number(run[name])
    return run[name] if not unit or math.isnan(value) else in_prefix(value, unit)


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


def draw_curves(figure, sweep, results, axis, limits):
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
        label_numbers(panel.yaxis, RESULTS.get(name, name), sweep, name)
        for _, _, value in (limit for limit in limits if limit[0] == name):
            panel.axhline(value, color="0.5", linewidth=1, zorder=1)
        if ticks := whole_numbers(name):
            panel.yaxis.set_major_locator(ticks)
    legend = figure.add_subplot(grid[rows, :])
    legend.axis("off")
    if below:
        legend.legend(*panel.get_legend_handles_labels(), ncol=beside,
                      loc="upper center", borderaxespad=0, fontsize=10)


def edges_of(values, scale):
    """The ends of cells around these numbers, half way between them."""
    at = [math.log(value) for value in values] if scale == "log" else values
    middles = [(a + b) / 2 for a, b in zip(at, at[1:])]
    edges = [2 * at[0] - middles[0], *middles, 2 * at[-1] - middles[-1]]
    return [math.exp(edge) for edge in edges] if scale == "log" else edges


def apart(values, scale):
    """The places of those of these numbers whose ticks do not touch each other."""
    at = [math.log(value) for value in values] if scale == "log" else values
    shown = []
    for i, place in enumerate(at):
        if not shown or place - at[shown[-1]] > LEAST_DISTANCE * (at[-1] - at[0]):
            shown.append(i)
    return shown


def draw_cells(panel, sweep, name, axes, limits, columns):
    """The cells of a map with their numbers, upright in narrow ones; those outside of the limits
    are hatched. columns: panels beside each other."""
    from matplotlib.patches import Rectangle
    xs, ys = (sorted({number(run[entry]) for run in sweep.runs}) for entry in axes)
    x_edges, y_edges = (edges_of(values, scale_of(values)) for values in (xs, ys))
    values = [[math.nan] * len(xs) for _ in ys]
    places = {}
    for run in sweep.runs:
        i, j = xs.index(number(run[axes[0]])), ys.index(number(run[axes[1]]))
        values[j][i] = number(run[name])
        places[i, j] = run
    places_x = [math.log(edge) for edge in x_edges] if scale_of(xs) == "log" else x_edges
    narrowest = min(b - a for a, b in zip(places_x, places_x[1:])) / (places_x[-1] - places_x[0])
    cells = panel.pcolormesh(x_edges, y_edges, values, cmap="viridis", rasterized=True)
    panel.set_xscale(scale_of(xs))
    panel.set_yscale(scale_of(ys))
    panel.grid(False)
    power = prefix_of(sweep.units.get(name), [v for row in values for v in row])[1]
    for (i, j), run in places.items():
        if not within(run, limits):
            panel.add_patch(Rectangle(
                (x_edges[i], y_edges[j]), x_edges[i + 1] - x_edges[i],
                y_edges[j + 1] - y_edges[j], fill=False, hatch="///", linewidth=0, edgecolor="0.6"))
        if len(places) <= MOST_NUMBERS and not math.isnan(values[j][i]):
            panel.text(xs[i], ys[j], f"{values[j][i] / 10.**power:.3g}", ha="center", va="center",
                       rotation=90 * (narrowest < LEAST_WIDTH * columns), fontsize=6,
                       color="black" if cells.norm(values[j][i]) > 0.6 else "white")
    return cells


def draw_maps(figure, sweep, results, axes, limits):
    """A map over two entries, a cell around each pair of values; what is missing is white."""
    xs, ys = (sorted({run[name] for run in sweep.runs}, key=number)
              for name in axes)
    columns = columns_of(results, True)
    rows = math.ceil(len(results) / columns)
    panels = figure.subplots(rows, columns, squeeze=False)
    for k, (panel, name) in enumerate(zip(panels.flat, results)):
        cells = draw_cells(panel, sweep, name, axes, limits, columns)
        for axis, entry, words, is_labelled in (
                (panel.xaxis, axes[0], xs, k + columns >= len(results)),
                (panel.yaxis, axes[1], ys, k % columns == 0)):
            unit, numbers = sweep.units.get(entry), [number(word) for word in words]
            shown = apart(numbers, axis.get_scale())
            prefix, power = prefix_of(unit, [numbers[len(numbers) // 2]])
            axis.set_ticks([numbers[i] for i in shown],
                           [f"{numbers[i] / 10.**power:g}" if power else words[i] for i in shown],
                           rotation=90 * (axis is panel.xaxis and len(xs) > 6))
            axis.set_ticks([], minor=True)
            if is_labelled:
                axis.set_label_text(in_unit(entry.split("/")[-1].lower(),
                                            prefix + unit if unit else None))
        bar = figure.colorbar(cells, ax=panel, ticks=whole_numbers(name))
        label_numbers(bar.ax.yaxis, RESULTS.get(name, name), sweep, name)
        panel.set_title(bar.ax.get_ylabel(), fontsize=11)
        bar.set_label("")
    for panel in list(panels.flat)[len(results):]:
        panel.remove()
    figure.align_ylabels()


def columns_of(results, as_map):
    """Panels beside each other, so that the last row is full if that can be."""
    n = len(results)
    return n if n < 3 else 2 if n % 2 == 0 and (n % 3 or n == 4) and as_map else 3


def read_limit(text, sweep):
    """(result, sign, number in the unit of its column) of "peak force < 60 kN"."""
    parts = re.fullmatch(r"\s*(.+?)\s*([<>])=?\s*(\S+)\s*(.*?)\s*", text)
    names = {**{key.replace("_", " "): key for key in sweep.results},
             **{re.sub(r"\s*\$.*?\$", "", label): key for key, label in RESULTS.items()},
             **SHORT, **{key: key for key in sweep.results}}
    if not parts or math.isnan(number(parts[3])):
        fail(sweep.path, f"--limit {text}: no limit", "write 'max_contact_force < 60 kN'")
    name = names.get(parts[1])
    if name not in sweep.results:
        fail(sweep.path, f"--limit {text}: no result {parts[1]}", f"take one of {', '.join(sweep.results)}")
    unit = sweep.units.get(name, "")
    factors = {unit: 1., "": 1., **{prefix + unit: 10.**(3 * i - 12) for i, prefix in
                                    [*enumerate(PREFIXES), (2, "u")] if unit}}
    if parts[4] not in factors:
        fail(sweep.path, f"--limit {text}: {name} is " + (f"in {unit}" if unit else "a number"),
             "write a number in it, perhaps with a prefix")
    return name, parts[2], number(parts[3]) * factors[parts[4]]


def within(run, limits):
    return all(number(run[name]) < value if sign == "<" else number(run[name]) > value
               for name, sign, value in limits)


def runs_within(path, texts):
    """What is told of the runs that keep all limits."""
    sweep = read_sweep(path)
    limits = [read_limit(text, sweep) for text in texts]
    good = [run for run in sweep.runs if within(run, limits)]
    return "\n".join([f"{len(good)} of {sweep.n_runs} runs within {', '.join(texts)}", *(
        f"  run {run['run']}: " + ", ".join(f"{name} = {value_of(sweep, name, run)}"
                                           for name in sweep.varied) for run in good)])


def draw(path, result, limits=()):
    """result: one key result; None: all that differ between runs. limits: texts."""
    sweep = read_sweep(path)
    limits = [read_limit(text, sweep) for text in limits]
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
        draw_maps(figure, sweep, results, names[:2], limits)
    else:
        draw_curves(figure, sweep, results, names[0], limits)
    return figure
