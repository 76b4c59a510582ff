"""Work-precision diagram of a study: part of scripts/plot, see there."""

import argparse
import collections
import math
import re

from plot_common import (convert, fail, in_unit, looks, new_figure, plain,
                         read_rows, title_of, units_of)

ERRORS = {"displacement_end": r"displacement  $u(1, t)$",
          "velocity_end": r"velocity  $u_t(1, t)$",
          "contact_force": "contact force",
          "temperature_end": r"temperature  $\theta(1, t)$",
          "first_contact_time": "time of the first contact",
          "energy": r"energy  $\hat{E}$"}
WORK = {"loop_seconds": "time of the loop, seconds",
        "solves": "linear solves", "dofs": "degrees of freedom"}
STEP_SIZE = "Time/Step size"
REFINE_TIME = [STEP_SIZE, "Time/Tolerance"]
REFINE_MESH = ["Mesh/Cells", "Mesh/Refinements"]
CONTROLLED = "error-controlled"
MARKERS = "osD^vPX"
NO_WORD = re.compile(r"[-+.\d]|(automatic|true|false|none|infinity)$")


def why_not(run):
    """Why a run is not drawn; empty if it is."""
    if run["status"] != "done":
        return run["status"].split(":")[0]
    for name in ["error", *WORK]:
        if not 1e-99 < run[name] < 1e99:  # nor has a logarithmic axis more
            return f"with {name} {run[name]:g}"
    return ""


def read_study(path, error):
    """Title, names of the varied entries, and runs: their values by column."""
    columns = ["run", "status", *WORK, f"error_{error}"]
    comments, header, rows = read_rows(path, columns)
    rows = [(n, [word or "nan" for word in row]) for n, row in rows]
    table = convert(path, header, rows, columns)
    runs = [dict(zip(header, row)) for _, row in rows]
    for i, run in enumerate(runs):
        run.update({name: table[name][i] for name in WORK})
        run["error"] = abs(table[f"error_{error}"][i])
        run["why not"] = why_not(run)
    return argparse.Namespace(
        path=path, title=title_of(comments) or path.parent.resolve().name,
        unit=units_of(comments, header).get(f"error_{error}"),
        varied=header[header.index("run") + 1:header.index("status")],
        runs=runs, drawn=[run for run in runs if not run["why not"]])


def has_errors(path):
    """Whether a run of the table has an error."""
    _, header, rows = read_rows(path, ["run", "status"])
    columns = [i for i, name in enumerate(header) if name.startswith("error_")]
    return any(row[i] not in ("", "nan") for _, row in rows for i in columns)


def note_on_left_out(study):
    """How many runs are not drawn and why; ends if none is."""
    reasons = collections.Counter(run["why not"] for run in study.runs)
    del reasons[""]
    counts = ", ".join(f"{n} {reason}" for reason, n in reasons.items())
    if not study.drawn:
        fail(study.path, f"no run to draw: {counts or 'none has ended yet'}",
             "wait, mend what failed, or give Study/Reference")
    return counts and f"Of {len(study.runs)} runs not drawn: {counts}"


def curves_of(study):
    """Runs by label: a curve for each combination of what does not refine."""
    numbers = [name for name in study.varied
               if all(NO_WORD.match(run[name]) for run in study.drawn)]
    refining = next((names for names in (REFINE_TIME, REFINE_MESH, numbers)
                     if set(names) & set(study.varied)), [])
    telling = [name for name in study.varied if name not in refining]
    automatic = [run.get(STEP_SIZE) == "automatic" for run in study.drawn]
    mixed = any(automatic) and not all(automatic)
    # a label leaves out what nearly all runs have in common
    usual = {name: value for name in telling for value, n in
             collections.Counter(run[name] for run in study.drawn).items()
             if n > 0.7 * len(study.drawn) and NO_WORD.match(value)}
    curves = {}
    for run in study.drawn:
        words = [f"{name.split('/')[-1].lower()} {run[name]}"
                 if NO_WORD.match(run[name]) else run[name] for name in telling
                 if run[name] != usual.get(name)]
        if mixed and run[STEP_SIZE] == "automatic":
            words.append(CONTROLLED)
        label = ", ".join(words) or ("fixed steps" if mixed else "")
        curves.setdefault(label, []).append(run)
    for runs in curves.values():
        runs.sort(key=lambda run: [run[n] for n in ("dofs", "solves", "error")])
    return curves


def set_scale(axis, set_limits, values):
    """Logarithmic, a decade at least; what is short has ticks at 2 and 5."""
    from matplotlib.ticker import LogFormatterSciNotation, LogLocator
    low, high = math.log10(min(values)), math.log10(max(values))
    middle, half = (low + high) / 2, max(0.5, 0.62 * (high - low))
    set_limits(10 ** (middle - half), 10 ** (middle + half))
    few = half < 0.9
    if few:
        axis.set_minor_locator(LogLocator(subs=[2, 5]))
    axis.set_minor_formatter(LogFormatterSciNotation(
        minor_thresholds=[math.inf] * 2 if few else [0, 0]))


def draw_marks(axes, work, study, marks):
    """Rings around runs, with labels on the side that has more room."""
    runs = {run["run"]: run for run in study.runs}
    for label, _, name in marks:
        why = runs[name]["why not"] if name in runs else "not in the study"
        if why:
            fail(study.path, f"run {name} cannot be marked: {why}",
                 "mark another run")
        x, y = runs[name][work], runs[name]["error"]
        axes.plot(x, y, "o", markersize=12, color="black", fillstyle="none",
                  zorder=4)
        low, high = axes.get_xlim()
        side = 1 if x * x < low * high else -1
        axes.annotate(plain(label, 30), (x, y), (8 * side, 8 * side),
                      textcoords="offset points", zorder=5, fontsize=10,
                      ha="left" if side > 0 else "right",
                      va="bottom" if side > 0 else "top",
                      bbox={"color": "white", "alpha": 0.7, "pad": 0})


def draw_panel(axes, work, curves):
    for i, (label, runs) in enumerate(curves.items()):
        hollow = {"markerfacecolor": "white"} if CONTROLLED in label else {}
        axes.loglog([run[work] for run in runs], [run["error"] for run in runs],
                    label=plain(label, 90), marker=MARKERS[i % len(MARKERS)],
                    markersize=5, zorder=3, **looks(i), **hollow)
    axes.set_xlabel(WORK[work])


def draw(path, error, marks):
    study = read_study(path, error)
    note = note_on_left_out(study)
    curves = curves_of(study)
    columns = max(1, min(4, 110 // (8 + max(len(label) for label in curves))))
    rows = math.ceil(len(curves) / columns) + bool(note)
    figure = new_figure(8, 4.2 + 0.22 * rows)
    figure.suptitle(plain(study.title, 90))
    grid = figure.add_gridspec(2, 2, height_ratios=[16, rows])
    left = figure.add_subplot(grid[0, 0])
    right = figure.add_subplot(grid[0, 1], sharey=left)
    refined = any(len({run["dofs"] for run in runs}) > 1
                  for runs in curves.values())
    for axes, work in ((left, "loop_seconds"),
                       (right, "dofs" if refined else "solves")):
        draw_panel(axes, work, curves)
        set_scale(axes.xaxis, axes.set_xlim, [run[work] for run in study.drawn])
        draw_marks(axes, work, study, marks)
    set_scale(left.yaxis, left.set_ylim, [run["error"] for run in study.drawn])
    right.tick_params(which="both", labelleft=False)
    left.set_ylabel(in_unit(f"error of the {ERRORS[error]}", study.unit))
    below = figure.add_subplot(grid[1, :])
    below.axis("off")
    if any(curves):
        below.legend(*left.get_legend_handles_labels(), ncol=columns,
                     loc="upper center", borderaxespad=0, fontsize=10)
    below.text(0.5, 0, note, ha="center", va="bottom", fontsize=9)
    return figure
