#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_studies.py THERMOCONTACT SOURCE_DIRECTORY

What scripts/plot draws of studies is what its labels say. A study.csv with the
columns that the program writes and numbers that are all different is drawn:
errors over work, key results over what is varied, as curves and as maps, and the
points of each period; each is compared with the columns that the labels name, of
the runs that the legend names. Known by hand: which runs belong to a curve, which
are not drawn. Exit status 77, "skipped", without matplotlib.
"""
import contextlib
import io
import sys
from pathlib import Path

try:
    import drawings
    import numpy
    from drawings import check, check_refused
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

WORK = {"time of the loop, seconds": "loop_seconds", "linear solves": "solves",
        "degrees of freedom": "dofs"}
ERRORS = {r"error of the displacement  $u(1, t)$": "displacement_end",
          r"error of the velocity  $u_t(1, t)$": "velocity_end",
          "error of the contact force": "contact_force",
          r"error of the temperature  $\theta(1, t)$": "temperature_end",
          "error of the time of the first contact": "first_contact_time",
          r"error of the energy  $\hat{E}$": "energy"}
RESULTS = {"time of the first contact": "first_contact_time",
           "number of contacts": "contact_begins",
           "time in contact": "contact_duration",
           "largest contact force": "max_contact_force",
           "largest penetration": "max_penetration",
           "contact impulse": "contact_impulse",
           "coefficient of restitution": "restitution",
           r"final displacement  $u(1, T)$": "final_displacement_end",
           r"final temperature  $\theta(1, T)$": "final_temperature_end",
           "steady state reached, number": "reached_state_of_rest",
           "final contact force": "final_contact_force"}
BIFURCATION = {r"$u(1)$ at multiples of $P$": "displacement_end",
               r"$u_t(1)$ at multiples of $P$": "velocity_end",
               r"$\theta(1)$ at multiples of $P$": "temperature_end",
               "peak force of a period": "peaks"}


def write_table(path, columns, units=()):
    path.parent.mkdir(exist_ok=True)
    path.write_text("# A study\n# thermocontact 0\n" + (
        f"# units: {','.join(units)}\n" if units else "") + ",".join(columns) + "\n" +
                    "".join(",".join(map(str, row)) + "\n"
                            for row in zip(*columns.values())))


def make_study(name, header, varied, changes=(), has_units=False):
    """changes: (column, run, word). Column k of run i holds (k + 2) 1.37^i / 1000, in a
    unit with the name of the column."""
    n = len(next(iter(varied.values())))
    rest = header[header.index("status"):]
    table = {"run": list(range(n)), **varied, **{
        column: [round((k + 2) * 1.37 ** i * 1e-3, 12) for i in range(n)]
        for k, column in enumerate(rest)}, "status": ["done"] * n}
    for column, i, word in changes:
        table[column][i] = word
    write_table(Path(name, "study.csv"), table, [
        f"of {column}" for column in table] if has_units else ())
    return table


def faults_of(panels, legend, x_of, y_of, curves, table):
    """curves: the runs by label, in the order in which they are joined."""
    faults = []
    for panel in panels:
        left = dict(curves)
        for line in panel.lines:
            label = legend.get(drawings.looks_of(line))
            runs = left.pop(label, None)
            if runs is None or not drawings.same(line, *(
                    [abs(float(table[name][i])) for i in runs]
                    for name in (x_of(panel), y_of(panel)))):
                faults.append(f"{panel.get_xlabel()}, {panel.get_ylabel()}: {label}")
        faults += [f"{panel.get_ylabel()}: no {label}" for label in left]
    return faults


def check_errors(plot, header):
    """Errors over work; run 1 failed, of run 5 there is no error."""
    varied = {"Time/Scheme": ["backward euler"] * 3 + ["sdirk4"] * 3,
              "Time/Step size": ["0.02", "0.01", "0.005"] * 2}
    errors = [name for name in header if name.startswith("error_")]
    check("every error has a label", list(ERRORS.values()) == [
        name[6:] for name in errors] == list(plot.plot_study.ERRORS))
    table = make_study("errors", header, varied, [
        ("status", 1, "failed: no"), *((name, 5, "nan") for name in errors)])
    curves = {"backward euler": [0, 2], "sdirk4": [3, 4]}
    for label, error in ERRORS.items():
        figure = drawings.figures_of(plot, "errors", "--error", error)[
            "work-precision"]
        panels, legend = drawings.panels_of(figure)
        faults = faults_of(panels, legend, lambda panel: WORK[panel.get_xlabel()],
                           lambda panel: f"error_{error}", curves, table)
        notes = [text.get_text() for axes in figure.axes if not axes.axison
                 for text in axes.texts]
        check(f"errors: {error}", not faults and panels[0].get_ylabel() == label and
              {panel.get_xscale() + panel.get_yscale() for panel in panels} == {
                  "loglog"} and notes == [
                      "Of 6 runs not drawn: 1 failed, 1 with error nan"],
              f"{faults} {notes}")
    for label, words in (("a=1", ["run 1 cannot be marked: failed"]),
                         ("a=9", ["run 9", "not in the study"])):
        check_refused(plot, f"mark {label}", words, "errors", "--mark", label)


def check_results(plot, header):
    """Curves of results over the gap, and maps over gap and compliance."""
    first = header.index("first_contact_time")
    check("every result has a label", header[first:] == [
        *RESULTS.values(), *plot.plot_sweep.WARNINGS] and
        list(RESULTS.values()) == list(plot.plot_sweep.RESULTS))
    without = [(name, i, "nan") for name in header if "error_" in name for i in range(6)]
    table = make_study("curves", header, {
        "Contact/Condition": ["rigid"] * 3 + ["normal compliance"] * 3,
        "Contact/Gap": ["0.1", "0.3", "0.2"] * 2}, without)
    panels, legend = drawings.panels_of(drawings.figures_of(plot, "curves")["results"])
    faults = faults_of(panels, legend, lambda panel: "Contact/Gap",
                       lambda panel: RESULTS[panel.get_ylabel()],
                       {"rigid": [0, 2, 1], "normal compliance": [3, 5, 4]}, table)
    check("results", not faults and len(panels) == len(RESULTS), "; ".join(faults))
    make_study("many", header, {"Time/Scheme": [f"scheme {i // 2}" for i in range(26)],
                                "Time/Step size": ["0.1", "0.2"] * 13})
    check("13 curves are too many", list(drawings.figures_of(plot, "many")) == ["work-precision"])
    check_refused(plot, "13 curves, asked for", ["13 curves", "fewer entries"],
                  "many", "--figure", "results")

    pairs = [(x, y) for y in ("0.4", "0.1", "0.2", "0.3")
             for x in ("1", "10", "0.1", "0.01", "100")]
    xs, ys = map(list, zip(*pairs))
    table = make_study("map", header, {"Contact/Compliance": xs, "Contact/Gap": ys}, [
        (name, i, "nan") for name in header if "error_" in name for i in range(20)], True)
    figure = drawings.figures_of(plot, "map")["results"]
    panels = [axes for axes in figure.axes if axes.get_title()]
    for panel in panels:
        title, _, unit = panel.get_title().replace("(L, T)", "(1, T)").partition(" [")
        check(f"unit of {title}", unit == f"of {RESULTS[title]}]", unit)
        cells = numpy.reshape(panel.collections[0].get_array(), (4, 5))
        expected = [[table[RESULTS[title]][pairs.index((x, y))] for x in sorted(
            set(xs), key=float)] for y in sorted(set(ys), key=float)]
        check(f"map of {title}", numpy.array_equal(cells, expected) and [
            text.get_text() for text in panel.get_xticklabels()] == sorted(
                set(xs), key=float))
    check("maps", [panel.get_title().replace("(L, T)", "(1, T)").partition(" [")[0] for panel in panels] == list(
        RESULTS) and {panel.get_xlabel() for panel in panels} == {
            "", "compliance [of Contact/Compliance]"} and {
                panel.get_ylabel() for panel in panels} == {"", "gap [of Contact/Gap]"})
    check_limits(plot, header, table, xs, ys)


def check_limits(plot, header, table, xs, ys):
    """Cells end half way between their values, with ratios where these are 30 or more; in each
    is its number, upright where it would reach into the next cell; a limit hatches the cells of
    other runs and lists its own."""
    forces = table["max_contact_force"]
    limit = forces[12]  # grows with the number of the run
    told = io.StringIO()
    with contextlib.redirect_stdout(told):
        figure = drawings.figures_of(plot, "map", "--limit", f"peak force < {limit} of max_contact_force",
                                     "--limit", "restitution > 0")["results"]
    panel = next(axes for axes in figure.axes if "largest contact force" in axes.get_title())
    edges = panel.collections[0].get_coordinates()
    check("cells end half way", numpy.allclose(
        edges[0, :, 0], [10**(n - 2.5) for n in range(6)]) and numpy.allclose(
            edges[:, 0, 1], [0.05, 0.15, 0.25, 0.35, 0.45]), str(edges[0, :, 0]))
    check("numbers in cells", sorted(text.get_text() for text in panel.texts) == sorted(
        f"{force:.3g}" for force in forces))
    alone = {}
    for name, words in (("wide", ["1", "2", "3", "4"]), ("narrow", ["1", "1.2", "3", "4"])):
        make_study(name, header, {"Contact/Compliance": words * 4,
                                  "Contact/Gap": [str(i // 4 + 1) for i in range(16)]})
        figure = drawings.figures_of(plot, name, "--result", "max_contact_force")["results"]
        alone[name] = {text.get_rotation() for axes in figure.axes for text in axes.texts}
    check("numbers in narrow cells", alone == {"wide": {0}, "narrow": {90}}, str(alone))
    outside = {(float(x), float(y)) for x, y, force in zip(xs, ys, forces) if force >= limit}
    hatched = {(round((patch.get_x() * (patch.get_x() + patch.get_width()))**0.5, 9),
                round(patch.get_y() + 0.05, 9)) for patch in panel.patches if patch.get_hatch()}
    check("hatched", hatched == outside and len(outside) == 8, str(hatched))
    lines = [f"12 of 20 runs within peak force < {limit} of max_contact_force, restitution > 0"]
    lines += [f"  run {i}: Contact/Compliance = {float(xs[i]):g} of Contact/Compliance, "
              f"Contact/Gap = {float(ys[i]):g} of Contact/Gap" for i in range(12)]
    check("runs within a limit", told.getvalue().splitlines() == lines, told.getvalue())
    for text, words in (("force < 1", ["no result force", "max_contact_force"]),
                        ("restitution", ["no limit"]),
                        ("max_contact_force < 1 kg", ["is in of max_contact_force"])):
        check_refused(plot, f"limit {text}", words, "map", "--limit", text)


def check_units_of_limits(plot, header):
    """Forces of 1e-6 N on and twice that each: by a limit in any unit of force as many runs are
    within as by the number in N; of 12 runs the third and the last two have failed."""
    forces = [1e-6 * 2**i for i in range(12)]
    table = make_study("limits", header, {"Contact/Gap": [str(i + 1) for i in range(12)]}, [
        *(("max_contact_force", i, force) for i, force in enumerate(forces)),
        *(("status", i, "failed: no") for i in (2, 10, 11))])
    write_table(Path("limits/study.csv"), table, [
        "N" * (name == "max_contact_force") for name in table])
    for prefix, size in (("n", 1e-9), ("u", 1e-6), ("µ", 1e-6), ("m", 1e-3), ("", 1.), ("k", 1e3),
                         ("M", 1e6), ("G", 1e9)):
        limit, told = 3e-4 / size, io.StringIO()
        with contextlib.redirect_stdout(told):
            figure = drawings.figures_of(plot, "limits", "--figure", "results", "--limit",
                                         f"peak force < {limit:g} {prefix}N")["results"]
        # 256e-6 N is the last below, of run 8; run 2 has failed
        check(f"limit in {prefix}N", told.getvalue().startswith("8 of 12 runs within "), told.getvalue())
    # matplotlib has no public name of the title before 3.8
    check("failed runs", figure._suptitle.get_text().endswith("\n3 of 12 runs failed: not drawn"),
          figure._suptitle.get_text())


def check_bifurcation(plot, header):
    """The points of the last two of four periods of 2, and the largest force in each,
    in every other at the rear one of two stops, at the end of the third period the largest,
    which is not one of the fourth; run 2 has none."""
    gaps = ["0.1", "0.3", "0.2"]
    make_study("driven", header, {"Contact/Gap": gaps})
    times = [0.25 * n for n in range(33)]
    for i in range(2):
        write_table(Path(f"driven/run-{i}/poincare.csv"), {
            "time": [0, 2, 4, 6, 8], **{
                name: [round((k + 2) * 0.1 + i + 0.01 * n, 9) for n in range(5)]
                for k, name in enumerate(list(BIFURCATION.values())[:3])}})
        write_table(Path(f"driven/run-{i}/contact.csv"), {
            "time": times, "contact_force": [3 + i if t == 6 else
                round((-1)**(t // 2) * (1 + i + 0.1 * (t // 2)), 9)
                if t % 2 == 1.25 else 0.5 for t in times]})
    figure = drawings.figures_of(plot, "driven", "--figure", "bifurcation",
                                 "--periods", "2")["bifurcation"]
    for k, (panel, label) in enumerate(zip(figure.axes, BIFURCATION)):
        expected = [(float(gaps[i]), round(
            (3 + i if n == 3 else 1 + i + 0.1 * (n - 1)) if BIFURCATION[label] == "peaks" else
            (k + 2) * 0.1 + i + 0.01 * n, 9)) for i in range(2) for n in (3, 4)]
        points = [tuple(point) for line in panel.lines for point in line.get_xydata()]
        check(f"bifurcation: {label}", panel.get_ylabel() == label and
              sorted(points) == sorted(expected), str(points))


def check_refusals(plot, header):
    make_study("words", header, {"Time/Scheme": ["sdirk2", "sdirk4"]})
    make_study("whole", header, {"Contact/Gap": ["0.1", "0.2"]},
               [("restitution", i, "nan") for i in range(2)])
    Path("empty").mkdir()
    Path("empty/study.csv").write_text("")
    for words, arguments in (
            (["is empty"], ["empty"]), (["drawn alone"], ["whole", "words"]),
            (["several values that are numbers"], ["words", "--figure", "results"]),
            (["no run has a restitution"], ["whole", "--result", "restitution"]),
            (["--figure contact is one of runs"], ["whole", "--figure", "contact"]),
            (["poincare.csv", "Output/Period"], ["whole", "--figure", "bifurcation"])):
        check_refused(plot, " ".join(arguments), words, *arguments)


def main():
    plot = drawings.load("plot")
    drawings.run("program", "paper/experiment-1.prm", "Time/End time=0.002",
                 "Mesh/Cells=2", "Study/Vary=Mesh/Degree = 1 | 2",
                 "Study/Reference=Mesh/Degree = 3")
    header = [name for name in drawings.table("program/study.csv") if "/" not in name]
    for part in (check_errors, check_results, check_units_of_limits, check_bifurcation, check_refusals):
        part(plot, header)


drawings.run_in_scratch(main)
