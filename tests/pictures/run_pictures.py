# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with the pictures of runs: lists of faults, empty if nothing.

The tables below say what each label means; a panel, line or other artist that
stands in none of them is a fault.
"""
import drawings
import numpy

TIME = "time  $t$"


def log_energy(table):
    return numpy.log(numpy.array(table["energy"], float) + 0.01)


def defect(table):
    """E(0) + work + algebraic - E - dissipation - numerical dissipation, (M.22);
    algebraic and what the obstacle takes where the table has them, (M.65), (M.85)."""
    work, energy, *losses = (numpy.array(table[name], float) for name in (
        "work", "energy", "dissipation", "numerical_dissipation"))
    algebraic = numpy.array(table.get("algebraic", 0.), float)
    damping = numpy.array(table.get("contact_dissipation", 0.), float)
    return energy[0] + work + algebraic - energy - sum(losses) - damping


# The label of an axis, and the column that it names or what follows from some.
CURVES = {
    "displacement  $u(1, t)$": "displacement_end",
    "displacement  $u(1/2, t)$": "displacement_mid",
    "velocity  $u_t(1, t)$": "velocity_end",
    r"stress  $\sigma(1, t)$": "stress_end",
    r"temperature  $\theta(1, t)$": "temperature_end",
    r"mean temperature  $\bar{\theta}(t)$": "temperature_mean",
    r"heat flux  $-\theta_x(1, t)$": "heat_flux_end",
    r"$\ln\,(\hat{E} + 0.01)$": log_energy,
    "energy  $\\hat{E}$\n(no ln: $\\hat{E} + 0.01 \\leq 0$ occurs)": "energy",
    "gap  $g - u(1, t)$": "gap",
    "contact force  $p(t)$": "contact_force",
    r"impulse  $\int_0^t p$": "contact_impulse",
    r"energy  $\hat{E}$": "energy",
    "work": "work", "dissipation": "dissipation",
    "numerical dissipation": "numerical_dissipation",
    "defect of the balance": defect,
    "dissipation by the obstacle": "contact_dissipation",
}
FIELDS = {r"temperature  $\theta$": "temperature",
          r"displacement  $u$": "displacement",
          r"velocity  $u_t$": "velocity", r"stress  $\sigma$": "stress"}
STEPS = {r"step size  $\Delta t$": "step_size", "error / tolerance": "error"}
LABELS = list(CURVES)
DISPLACEMENT, PLAIN_ENERGY, GAP = LABELS[0], LABELS[8], LABELS[9]
COLUMNS = sorted({what for what in CURVES.values() if isinstance(what, str)}
                 - {"contact_dissipation"})  # of some runs
# The panels of a picture in their order, and how many stand side by side.
FIGURE = [*LABELS[:5], LABELS[7]], 2
HEAT = LABELS[4:8], 2
CONTACT = LABELS[9:12], 1
ENERGY = LABELS[12:17], 2
DAMPED = [*LABELS[12:16], LABELS[17], LABELS[16]], 2
REJECTED = {"tolerance": "rejected: error",
            "contact": "rejected: contact changes within",
            "failed": "rejected: not solved"}


def column_of(label, table):
    what = CURVES[label]
    return numpy.array(what(table) if callable(what) else table[what], float)


def shown(panels, runs):
    """The runs that have numbers for any of these labels."""
    return [run for run in runs if any(
        numpy.isfinite(column_of(label, run.contact)).any() for label in panels)]


def faults_of_legend(entries, runs, more=()):
    """The runs in their order, then the rest; looks that repeat."""
    faults = []
    labels = [label for label, _ in entries]
    if labels != [*(run.label for run in runs), *more]:
        faults.append(f"legend {labels}")
    looks = [drawings.looks_of(handle) for _, handle in entries[:len(runs)]]
    if len(set(looks)) < len(looks):
        faults.append("runs look alike")
    return faults


def colours_of(entries):
    return [drawings.colour_of(handle) for _, handle in entries]


def faults_of_spans(axes, runs, colours):
    """Times in contact: of one run, or bars of each run below the other."""
    expected = [run.contacts for run in runs if run.contacts]
    colours = [colour for run, colour in zip(runs, colours) if run.contacts]
    spans = drawings.spans_of(axes)
    rows = [[span for span in spans if span[2] == top] for top in
            sorted({span[2] for span in spans}, reverse=True)]
    # begin + length, as matplotlib keeps them from 3.9, is the end but for rounding
    good = [len(row) for row in rows] == [len(times) for times in expected] and all(
        numpy.allclose([span[:2] for span in row], times, rtol=1e-12, atol=0)
        for row, times in zip(rows, expected))
    if len(runs) > 1:
        good = good and [{span[3] for span in row} for row in rows] == [
            {colour} for colour in colours]
    return [] if good else [f"{axes.get_ylabel()}: shaded {spans}"]


def frame_faults(axes, scale, at_bottom):
    """Labels, scales and range of a panel over time."""
    label = axes.get_ylabel()
    faults = [f"{label}: {artist}" for artist in drawings.unknown_artists(axes)]
    faults += drawings.faults_of_range(axes)
    if (axes.get_xscale(), axes.get_yscale()) != ("linear", scale):
        faults.append(f"{label}: scale")
    if axes.get_xlabel() != (TIME if at_bottom else ""):
        faults.append(f"{label}: over {axes.get_xlabel()!r}")
    return faults


def faults_of_panel(axes, runs, entries, at_bottom):
    """A curve of each run, the obstacle, times in contact, and nothing else."""
    label = axes.get_ylabel()
    expected = {drawings.looks_of(handle): (run.contact["time"],
                                            column_of(label, run.contact))
                for run, (_, handle) in zip(runs, entries)}
    faults = frame_faults(axes, "linear", at_bottom)
    obstacle = [h for text, h in entries[len(runs):] if text.startswith("obst")]
    gs = sorted({run.g for run in runs if run.g is not None})
    levels = gs if label == DISPLACEMENT else [0] if label == GAP else []
    levels = levels[:]
    for line in axes.lines:
        looks = drawings.looks_of(line)
        if looks in expected:
            if not drawings.same(line, expected.pop(looks)):
                faults.append(f"{label}: {looks} is another curve")
        elif obstacle and looks == drawings.looks_of(obstacle[0]) and levels \
                and len(line.get_ydata()) == 2 and set(line.get_ydata()) <= \
                set(levels) and len(set(line.get_ydata())) == 1:
            levels.remove(line.get_ydata()[0])
        else:
            faults.append(f"{label}: unknown line {looks}")
    if expected or levels:
        faults.append(f"{label}: no curve {expected} {levels}")
    texts = [(text.get_text(), text.get_position()[1]) for text in axes.texts]
    if sorted(texts) != [("$g$", g) for g in gs if label == DISPLACEMENT] + [
            ("", 0)] * (label == GAP):
        faults.append(f"{label}: texts {texts}")
    return faults + faults_of_spans(axes, runs, colours_of(entries))


def faults_of_histories(figure, runs, panels, columns):
    """
    panels: labels of what is drawn, by rows
    columns: of the panels; those of the last row say what is to the right
    """
    axes, entries = drawings.parts_of(figure)
    gs = sorted({run.g for run in runs if run.g is not None})
    more = ["obstacle, $g$ = " + ", ".join(f"{g:g}" for g in gs)] if \
        gs and set(panels) & {DISPLACEMENT, GAP} else []
    if any(run.contacts for run in runs):
        more.append("in contact" + " (bars at the top)" * (len(runs) > 1))
    faults = faults_of_legend(entries, runs, more)
    if [panel.get_ylabel() for panel in axes] != panels:
        return [*faults, f"panels {[panel.get_ylabel() for panel in axes]}"]
    last_row = (len(panels) - 1) // columns * columns
    for i, panel in enumerate(axes):
        faults += faults_of_panel(panel, runs, entries, i >= last_row)
        limits = (min(run.contact["time"][0] for run in runs),
                  max(run.contact["time"][-1] for run in runs))
        if panel.get_xlim() != limits or panel.get_title():
            faults.append(f"times {panel.get_xlim()}, {panel.get_title()!r}")
    return faults + [text.get_text() for text in figure.texts]


def faults_of_decay(figure, runs):
    """Panels side by side: one run each, with its title and letter."""
    axes, entries = drawings.parts_of(figure)
    label = LABELS[7]
    labels = [label] + [""] * (len(runs) - 1)
    titles = [f"({letter})  {run.label}" for letter, run in zip("abcd", runs)]
    if entries or [a.get_ylabel() for a in axes] != labels or [
            a.get_title().replace("\n", " ") for a in axes] != titles:
        return ["panels, labels or titles"]
    faults = [text.get_text() for text in figure.texts]
    for panel, run in zip(axes, runs):
        faults += frame_faults(panel, "linear", True)
        if len(panel.lines) != 1 or panel.texts or panel.patches or not \
                drawings.same(panel.lines[0], (run.contact["time"],
                                               column_of(label, run.contact))):
            faults.append(f"{panel.get_title()}: not the energy alone")
        if panel.get_xlim() != (run.times[0], run.times[-1]):
            faults.append(f"{panel.get_title()}: times")
    return faults


def expected_attempts(runs, entries, column):
    """Curves of accepted steps by their looks, points of rejected attempts."""
    accepted, rejected = {}, []
    markers = {text: handle.get_marker() for text, handle in entries
               if text in REJECTED.values() and hasattr(handle, "get_marker")}
    for run, (_, handle) in zip(runs, entries):
        table, good = run.steps, numpy.array(run.steps["accepted"]) == 1
        x, y = numpy.array(table["time"]), numpy.array(table[column])
        accepted[drawings.looks_of(handle)] = x[good], y[good]
        colours = [drawings.colour_of(h) for text, h in entries
                   if text in REJECTED.values()] if len(runs) == 1 else [
                       drawings.colour_of(handle)]
        rejected += [(x[i], y[i], markers.get(REJECTED[table["reason"][i]]),
                      colours[0]) for i in numpy.flatnonzero(~good)]
    return accepted, sorted(rejected, key=str)


def faults_of_steps(figure, runs):
    axes, entries = drawings.parts_of(figure)
    more = ["in contact" + " (bars at the top)" * (len(runs) > 1)] if any(
        run.contacts for run in runs) else []
    faults = faults_of_legend(entries, runs, [*more, *REJECTED.values()])
    faults += [text.get_text() for text in figure.texts]
    marks = [handle.get_marker() for text, handle in entries
             if text in REJECTED.values() and hasattr(handle, "get_marker")]
    if len(set(marks)) < len(REJECTED):
        faults.append(f"reasons of rejections look alike: {marks}")
    if [panel.get_ylabel() for panel in axes] != list(STEPS):
        return [*faults, "panels"]
    for i, panel in enumerate(axes):
        label = panel.get_ylabel()
        faults += frame_faults(panel, "log", i == 1)
        faults += faults_of_spans(panel, runs, colours_of(entries))
        accepted, rejected = expected_attempts(runs, entries, STEPS[label])
        points, limit = [], []
        for line in panel.lines:
            looks = drawings.looks_of(line)
            if len(line.get_xdata()) == 1:
                points.append((line.get_xdata()[0], line.get_ydata()[0],
                               line.get_marker(), drawings.colour_of(line)))
            elif looks in accepted and line.get_marker() == ".":
                if not drawings.same(line, accepted.pop(looks)):
                    faults.append(f"{label}: {looks} is another curve")
            else:
                limit += list(line.get_ydata())
        if accepted or sorted(points, key=str) != rejected or panel.texts or \
                limit != [1, 1] * (label == "error / tolerance"):
            faults.append(f"{label}: {accepted}, {points}, {limit}")
    return faults


def expected_probes(runs, entries, field):
    """Curves by their looks: the legend has probes, then, if many, the runs."""
    n_probes = len(entries) - (len(runs) if len(runs) > 1 else 0)
    if not all(hasattr(handle, "get_marker") for _, handle in entries):
        return {}
    curves = {}
    for n, run in enumerate(runs):
        for i, place in run.places.items():
            text = f"probe {i}: {place.replace('x =', '$x$ =')}"
            handles = [handle for label, handle in entries[:n_probes]
                       if label in (text, f"{text} ({run.label})")]
            if len(handles) != 1:
                return {}
            looks = drawings.looks_of(handles[0])
            if len(runs) > 1:
                looks = looks[0], drawings.dashes_of(entries[n_probes + n][1])
            curves[looks] = run.probes["time"], run.probes[f"{field}_{i}"]
    return curves


def faults_of_probes(figure, runs):
    axes, entries = drawings.parts_of(figure)
    bars = " (bars at the top, runs downwards)" * (len(runs) > 1)
    contact = ["in contact" + bars] * any(run.contacts for run in runs)
    if [panel.get_ylabel() for panel in axes] != list(FIELDS):
        return ["panels"]
    faults = [] if [text.get_text() for text in figure.texts] == [
        run.label for run in runs if len(runs) == 1] else ["title"]
    end = len(entries) - len(contact)
    bars = [drawings.colour_of(handle) for _, handle in entries[end:]]
    if [text for text, _ in entries[end:]] != contact:
        faults.append("contact in the legend")
    entries = entries[:end]
    if len(runs) > 1 and [text for text, _ in entries[-len(runs):]] != [
            run.label for run in runs]:
        faults.append("runs in the legend")
    for i, panel in enumerate(axes):
        label = panel.get_ylabel()
        faults += frame_faults(panel, "linear", i >= 2)
        faults += faults_of_spans(panel, runs, bars * len(runs))
        expected = expected_probes(runs, entries, FIELDS[label])
        if len(expected) != sum(len(run.places) for run in runs):
            faults.append(f"legend {[text for text, _ in entries]}")
        for line in panel.lines:
            curve = expected.pop(drawings.looks_of(line), None)
            if curve is None or not drawings.same(line, curve):
                faults.append(f"{label}: another curve")
        if expected or panel.texts:
            faults.append(f"{label}: no curve {list(expected)}")
    return faults
