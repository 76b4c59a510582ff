"""The pictures of runs: part of scripts/plot, see there."""

import argparse
import math
import textwrap

from plot_common import fail, in_prefix, in_unit, label_axis, looks, new_figure, plain
from plot_probes import draw_probes, handles_of, histories_of

FIGURE = {"displacement_end": r"displacement  $u(1, t)$",
          "displacement_mid": r"displacement  $u(1/2, t)$",
          "velocity_end": r"velocity  $u_t(1, t)$",
          "stress_end": r"stress  $\sigma(1, t)$",
          "temperature_end": r"temperature  $\theta(1, t)$",
          "energy_drawn": ""}  # by prepare()
HEAT = {"temperature_end": FIGURE["temperature_end"],
        "temperature_mean": r"mean temperature  $\bar{\theta}(t)$",
        "heat_flux_end": r"heat flux  $-\theta_x(1, t)$",
        "energy_drawn": ""}
CONTACT = {"gap": r"gap  $g - u(1, t)$",
           "contact_force": r"contact force  $F(t)$",
           "contact_impulse": r"impulse  $\int_0^t F$",
           "max_pressure": r"largest pressure  $p$",
           "contact_area": "area in contact / area"}
ROW = {"gap": r"gap  $g - u_L + u_R$", "contact_force": CONTACT["contact_force"],
       "contact_impulse": CONTACT["contact_impulse"]}
ENERGY = {"energy": "energy  $\\hat{E}$\n(no heat content)", "work": "work",
          "dissipation": "dissipation",
          "numerical_dissipation": "numerical dissipation",
          "contact_dissipation": "dissipation by the obstacle",
          "defect": "defect of the balance"}
LOADS = ["stress_end", "work"]  # 0 all the time if nothing acts on the rod
LOG_ENERGY = r"$\ln\,(\hat{E} + 0.01)$"
PLAIN_ENERGY = "energy  $\\hat{E}$\n(no ln: $\\hat{E} + 0.01 \\leq 0$ occurs)"
TIME = "time  $t$"
OBSTACLE = {"color": "0.25", "linewidth": 0.8, "linestyle": (0, (4, 2))}
LEGEND_LINE = 0.245  # inches


def prepare(runs):
    """Looks and labels of the runs; energy or its logarithm for all alike."""
    for run in runs:
        if run.units != runs[0].units:
            fail(run.directory, f"in other units than {runs[0].directory}",
                 "run both with the same Scales and Output/SI")
    titles = [run.title for run in runs]
    names = names_of(runs)
    for i, (run, name) in enumerate(zip(runs, names)):
        run.looks = looks(i)
        if titles.count(run.title) > 1:
            run.title = name or f"{run.title} ({run.directory})"
        run.title = plain(run.title, 80) + run.ended
        run.data["energy_drawn"] = run.data["energy"]
    unit = runs[0].units.get("energy")
    has_log = not unit and not any(
        e + 0.01 <= 0 for run in runs for e in run.data["energy"])
    if has_log:
        for run in runs:
            run.data["energy_drawn"] = [
                math.log(e + 0.01) for e in run.data["energy"]]
    FIGURE["energy_drawn"] = HEAT["energy_drawn"] = \
        LOG_ENERGY if has_log else ENERGY["energy"] if unit else PLAIN_ENERGY
    if unit:
        runs[0].units["energy_drawn"] = unit


def names_of(runs):
    """What the entries of used.prm tell the runs apart by, such as "gap = 0.1", or
    nothing if these are more than three or the same for two runs."""
    entries = sorted(set().union(*(run.entries for run in runs)))
    differing = [name for name in entries if len(
        {run.entries.get(name) for run in runs}) > 1]
    names = [", ".join(f"{name.split('/')[-1].lower()} = {run.entries.get(name, 'default')}"
                       for name in differing) for run in runs]
    usable = 0 < len(differing) <= 3 and len(set(names)) == len(runs)
    return names if usable else [None] * len(runs)


def has(runs, column):
    """Whether any run has numbers there."""
    return any(math.isfinite(v) for run in runs for v in run.data[column])


def drawn(runs, labels):
    """The labels of what has numbers, and loads if anything acts."""
    return {name: label for name, label in labels.items() if has(runs, name)
            and (name not in LOADS or any(any(run.data[name]) for run in runs))}


def label_of(runs, name, label):
    """With the unit of the column."""
    return in_unit(label, runs[0].units.get(name))


def draw_obstacle(axes, g, name=""):
    low, high = axes.get_ylim()
    if 2 * low - high <= g <= 2 * high - low:  # not far away, not nan
        axes.axhline(g, zorder=2.5, **OBSTACLE)
        axes.text(1.01, g, name, va="center", transform=axes.get_yaxis_transform())


def mark_contacts(axes, runs, colour=None):
    """Shades the times in contact, or bars along the top for each of many.

    colour: of the bars; None: that of the run's curves
    """
    if len(runs) == 1:
        for begin, end in runs[0].contacts:
            axes.axvspan(begin, end, color="0.92", linewidth=0, zorder=0)
        return
    if not any(run.contacts for run in runs):
        return
    bar = 0.2 / max(5, len(runs))  # height of a bar in parts of the panel
    low, high = axes.get_ylim()
    if axes.get_yscale() == "linear":
        axes.set_ylim(low, low + (high - low) / (1 - bar * len(runs)))
    for i, run in enumerate(runs):
        top = 1 - (i + 0.25) * bar
        for begin, end in run.contacts:
            axes.axvspan(begin, end, top - 0.6 * bar, top, zorder=2,
                         color=colour or run.looks["color"], linewidth=0)


# what a column is small beside if it is rounding, and how small
ROUNDING = {"gap": ("displacement_end", 1e-12), "displacement_end": ("displacement_mid", 1e-12),
            "defect": ("energy", 1e-12)}


def scale_of_rounding(column, runs):
    """Half the height of a panel that shows a column of rounding as nothing; 0: it is more."""
    def largest(name):
        return max((abs(value) for run in runs for value in run.data[name]
                    if math.isfinite(value)), default=0)

    if column == "velocity_end":  # of an end that does not move
        return 1e3 * largest(column) if scale_of_rounding("displacement_end", runs) else 0
    if column not in ROUNDING:
        return 0
    name, small = ROUNDING[column]
    size = largest(name)
    if not largest(column) < small * size:
        return 0
    return 1e-9 * size if column == "defect" else size


def draw_history(axes, column, label, runs):
    """One curve per run, and the obstacle."""
    for run in runs:
        axes.plot(run.data["time"], run.data[column], zorder=3, **run.looks)
    if column == "gap" and any(math.isfinite(run.rear) for run in runs):
        label = "gap to the nearer obstacle"
    values = [value for run in runs for value in run.data[column]]
    if size := scale_of_rounding(column, runs):
        label, values = f"{label}\n(rounding)", [size]
        axes.set_ylim(-size, size)
    label_axis(axes.yaxis, label, runs[0].units.get(column), values)
    if column == "displacement_end":
        for g in {run.obstacle for run in runs if not run.moves}:
            draw_obstacle(axes, g, "$g$" if g else "")
        for rear in {run.rear for run in runs}:
            draw_obstacle(axes, rear, "$-g_2$" if rear else "")
        for run in runs:
            if run.path:
                axes.plot(*run.path, zorder=2.5, **OBSTACLE)
    if column == "gap":
        draw_obstacle(axes, 0)


def legend_of(runs, obstacle):
    """Handles of matplotlib's legend."""
    from matplotlib.lines import Line2D
    handles = [Line2D([], [], label=run.title, **run.looks) for run in runs]
    values = sorted({run.obstacle for run in runs if not run.moves} - {math.nan})
    values = [g for g in values if math.isfinite(g)]
    if values and obstacle:
        unit = runs[0].units.get("gap")
        rear = sorted(-run.rear for run in runs if math.isfinite(run.rear))
        words = [f"{name} = " + ", ".join(dict.fromkeys(in_prefix(g, unit) for g in gaps))
                 for name, gaps in (("$g$", values), ("$g_2$", rear)) if gaps]
        handles.append(Line2D([], [], label="obstacle, " + "; ".join(words), **OBSTACLE))
    elif obstacle and any(run.path for run in runs):
        handles.append(Line2D([], [], label="obstacle, $g(t)$", **OBSTACLE))
    return handles + legend_of_contacts(runs, "bars at the top")


def legend_of_contacts(runs, bars, colour="0.88"):
    """bars: what they are called if there are many runs"""
    from matplotlib.patches import Patch
    if not any(run.contacts for run in runs):
        return []
    return [Patch(facecolor=colour, label="in contact" + (
        f" ({bars})" if len(runs) > 1 else ""))]


def panels_of(runs, names, columns, height, handles):
    """Figure, its panels by name and, below them, the legend.

    The last panel is as wide as the figure if the others fill their rows.
    """
    rows = math.ceil(len(names) / columns)
    length = max(len(handle.get_label()) for handle in handles)
    ncol = max(1, min(len(handles), 100 // (length + 8)))
    lines = sum(handle.get_label().count("\n") + 1 for handle in handles)
    # lines with formulas are higher; one has room enough
    formulas = sum("$" in handle.get_label() for handle in handles) - 1
    below = LEGEND_LINE * (math.ceil(lines / ncol) + 0.35 + 0.25 * math.ceil(
        max(0, formulas) / ncol))
    figure = new_figure(8, rows * height + below)
    grid = figure.add_gridspec(rows + 1, columns,
                               height_ratios=[height] * rows + [below])
    panels, first = {}, None
    for i, name in enumerate(names):
        row, column = divmod(i, columns)
        wide = i + 1 == len(names) and column == 0
        axes = figure.add_subplot(grid[row, slice(None) if wide else column],
                                  sharex=first)
        first = first or axes
        panels[name] = axes
        below = i + columns  # a panel of another width has its own labels
        is_over_wide = columns > 1 and below + 1 == len(names) and below % columns == 0
        if below < len(names) and not is_over_wide:
            axes.tick_params(labelbottom=False)
        else:
            axes.set_xlabel(label_of(runs, "time", TIME))
    axes = figure.add_subplot(grid[rows, :])
    axes.axis("off")
    legend = axes.legend(handles=handles, loc="upper center", ncol=ncol,
                         borderaxespad=0, fontsize=10.5)
    legend.set_in_layout(False)
    return figure, panels


def finish(figure, panels, runs, colour=None):
    """Times in contact, one range of time, labels in line."""
    for axes in panels.values():
        mark_contacts(axes, runs, colour)
    next(iter(panels.values())).set_xlim(
        min(run.data["time"][0] for run in runs),
        max(run.data["time"][-1] for run in runs))
    figure.align_ylabels()


def draw_histories(runs, labels, columns, height):
    labels = drawn(runs, labels)
    runs = [run for run in runs if any(has([run], name) for name in labels)]
    figure, panels = panels_of(runs, labels, columns, height, legend_of(
        runs, obstacle="displacement_end" in labels or "gap" in labels))
    for name, axes in panels.items():
        draw_history(axes, name, labels[name], runs)
    finish(figure, panels, runs)
    return figure


def draw_row(runs):
    """Each contact of a row of bodies in a colour of its own, each run in a dash of its own."""
    from matplotlib.lines import Line2D

    runs = [run for run in runs if run.row]
    names = list(dict.fromkeys(name for run in runs for name in run.row))
    colours = {name: looks(i)["color"] for i, name in enumerate(names)}
    dashes = [(), (4, 2), (1, 1.5), (6, 2, 1, 2)]
    handles = [Line2D([], [], color=colours[name], label=name) for name in names]
    if len(runs) > 1:
        handles += [Line2D([], [], color="0.3", dashes=dashes[i % len(dashes)], label=run.title)
                    for i, run in enumerate(runs)]
    labels = {name: ROW[name] for name in ROW if any(
        math.isfinite(value) for run in runs for table in run.row.values() for value in table[name])}
    figure, panels = panels_of(runs, labels, 1, 2.1, handles)
    for column, axes in panels.items():
        values = []
        for i, run in enumerate(runs):
            for name, table in run.row.items():
                axes.plot(table["time"], table[column], zorder=3, linewidth=1.2, color=colours[name],
                          dashes=dashes[i % len(dashes)])
                values += table[column]
        label_axis(axes.yaxis, labels[column], runs[0].units.get(column), values)
    if len(runs) == 1:
        figure.suptitle(runs[0].title, fontsize=11)
    finish(figure, panels, runs)
    return figure


def histories_of_figure(runs):
    return FIGURE if has(runs, "displacement_end") else HEAT


def draw_figure(runs):
    return draw_histories(runs, histories_of_figure(runs), 2, 2.3)


def draw_steps(runs):
    """Attempts as points; the accepted ones joined."""
    from matplotlib.lines import Line2D

    labels = {"step_size": r"step size  $\Delta t$",
              "error": "error / tolerance"}
    kinds = {"tolerance": ("x", "rejected: error"),
             "contact": ("+", "rejected: contact changes within"),
             "failed": ("v", "rejected: not solved")}
    runs = [run for run in runs if run.steps]
    reasons = {reason for run in runs for reason in run.steps[1]["reason"]}
    colour = "black" if len(runs) > 1 else looks(1)["color"]
    marks = [Line2D([], [], linestyle="", color=colour, label=label,
                    marker=marker, markersize=6)
             for reason, (marker, label) in kinds.items() if reason in reasons]
    figure, panels = panels_of(runs, labels, 1, 2.8, [
        *legend_of(runs, obstacle=False), *marks])
    for name, axes in panels.items():
        axes.set_ylabel(label_of(runs, name, labels[name]))
        axes.set_yscale("log")
        for run in runs:
            rows = [row for row in zip(*run.steps[1].values())]
            at = list(run.steps[1]).index(name)
            good = [row for row in rows if row[3] and row[at] > 0]
            axes.plot([row[0] for row in good], [row[at] for row in good],
                      marker=".", markersize=3, zorder=3,
                      **{**run.looks, "linewidth": 0.7})
            for row in rows:
                if not row[3] and row[at] > 0:
                    axes.plot(row[0], row[at], zorder=4, markersize=6,
                              marker=kinds.get(row[4], "x")[0],
                              color=run.looks["color"] if len(runs) > 1
                              else colour)
    panels["error"].axhline(1, **OBSTACLE)
    finish(figure, panels, runs)
    return figure


def draw_decay(runs):
    """Energies side by side, as in figure 5 of the paper."""
    runs = [run for run in runs if has([run], "energy")]
    figure = new_figure(8, 3.4)
    grid = figure.subplots(1, len(runs), sharey=True, squeeze=False)[0]
    for letter, axes, run in zip("abcdefghij", grid, runs):
        axes.plot(run.data["time"], run.data["energy_drawn"], zorder=3,
                  **looks(0))
        axes.set_xlim(run.data["time"][0], run.data["time"][-1])
        axes.set_xlabel(label_of(runs, "time", TIME))
        title = textwrap.fill(run.title, int(80 / len(runs)))
        axes.set_title(f"({letter})  {title}", fontsize=11)
    label_axis(grid[0].yaxis, FIGURE["energy_drawn"], runs[0].units.get("energy_drawn"),
               [value for run in runs for value in run.data["energy_drawn"]])
    return figure


def draw_histories_at_probes(runs):
    """Colours tell probes apart, so that the bars of the runs are grey."""
    runs = [run for run in runs if run.probes and histories_of([run])]
    histories = histories_of(runs)
    grey = "0.5" if len(runs) > 1 else "0.88"
    figure, panels = panels_of(runs, histories, 2, 2.3, [
        *handles_of(runs, histories),
        *legend_of_contacts(runs, "bars at the top, runs downwards", grey)])
    draw_probes(runs, histories, panels)
    if len(runs) == 1:
        figure.suptitle(runs[0].title, fontsize=11)
    finish(figure, panels, runs, grey)
    return figure


def picture(draw, wanted, needs, usual=True):
    return argparse.Namespace(draw=draw, wanted=wanted, needs=needs,
                              usual=usual)


FIGURES = {
    "figure": picture(
        draw_figure, lambda runs: drawn(runs, histories_of_figure(runs)),
        "numbers in contact.csv"),
    "contact": picture(
        lambda runs: draw_histories(runs, CONTACT, 1, 2.1),
        lambda runs: has([run for run in runs if not run.row], "gap"), "a scene with an obstacle"),
    "row": picture(draw_row, lambda runs: any(run.row for run in runs), "a row of bodies (section Bodies)"),
    "energy": picture(
        lambda runs: draw_histories(runs, ENERGY, 2, 2.1),
        lambda runs: has(runs, "energy"), "the column energy of contact.csv"),
    "steps": picture(draw_steps, lambda runs: any(run.steps for run in runs),
                     "steps.csv (error-controlled steps)"),
    "probes": picture(
        draw_histories_at_probes,
        lambda runs: histories_of(run for run in runs if run.probes),
        "numbers in probes.csv"),
    "decay": picture(draw_decay, lambda runs: has(runs, "energy"),
                     "the column energy of contact.csv", usual=False),
}
