#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_sweeps.py THERMOCONTACT SOURCE_DIRECTORY

The pictures of key results over what a study varies show what their labels say.
Tables made by hand, with the columns that the program writes and numbers that are all
different, are drawn: points of each curve, cells of each map, legend, ticks and scales
are compared with the columns that the labels name. The check is seen to fail with the
data of each other column and on changed texts. Exit status 77, "skipped", without
matplotlib.
"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import drawings
    import numpy
    import tables
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

program, source = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
n_failed = 0
LABELS = {"time of the first contact": "first_contact_time",
          "number of contacts": "contact_begins",
          "time in contact": "contact_duration",
          "largest contact force": "max_contact_force",
          "largest penetration": "max_penetration",
          "contact impulse": "contact_impulse",
          "coefficient of restitution": "restitution",
          r"final displacement  $u(1, T)$": "final_displacement_end",
          r"final temperature  $\theta(1, T)$": "final_temperature_end",
          "state of rest": "reached_state_of_rest"}


def check(name, good, message=""):
    global n_failed
    n_failed += not good
    print(f"{'passed' if good else 'FAILED'}: {name}  {message}".rstrip())


def write(directory, header, varied, changes=()):
    """A study.csv of runs that are done and have no errors; changes: (column, run, word)."""
    n = len(next(iter(varied.values())))
    rest = header[header.index("status"):]
    table = {"run": list(range(n)), **varied, **{
        name: [round((k + 2) * 1.37 ** i * 1e-3, 12) for i in range(n)]
        for k, name in enumerate(rest)}}
    table["status"] = ["done"] * n
    for name in rest:
        if "error_" in name:
            table[name] = ["nan"] * n
    for column, i, word in changes:
        table[column][i] = word
    directory.mkdir()
    tables.write_table(directory / "study.csv", "A sweep", table)
    return table


def faults_of_curves(figure, table, axis, curves, title="A sweep", scale="linear"):
    """curves: the runs by label, in the order in which they are joined."""
    panels, entries = drawings.parts_of(figure)
    faults = [] if [text.get_text() for text in figure.texts] == [title] else ["title"]
    if [text for text, _ in entries] != [label for label in curves if label]:
        faults.append(f"legend {entries}")
    for panel in panels:
        column = LABELS.get(panel.get_ylabel())
        if column is None or panel.get_xlabel() != axis.split("/")[-1].lower() or \
                (panel.get_xscale(), panel.get_yscale()) != (scale, "linear"):
            faults.append(f"labels {panel.get_xlabel()} {panel.get_ylabel()}")
            continue
        faults += drawings.unknown_artists(panel) + drawings.faults_of_range(panel)
        looks = [drawings.looks_of(handle) for _, handle in entries] or [
            drawings.looks_of(panel.lines[0])]
        for line, look, runs in zip(panel.lines, looks, curves.values()):
            wanted = [[float(table[name][i]) for i in runs] for name in (axis, column)]
            if drawings.looks_of(line) != look or not drawings.same(line, wanted):
                faults.append(f"{column} is another curve")
        if len(panel.lines) != len(curves) or panel.patches or panel.texts:
            faults.append(f"{column}: more than its curves")
    found = [LABELS.get(panel.get_ylabel()) for panel in panels]
    return faults if found == list(LABELS.values()) else [*faults, f"panels {found}"]


def check_curves(plot, header):
    varied = {"Contact/Condition": ["rigid"] * 3 + ["normal compliance"] * 3,
              "Contact/Gap": ["0.1", "0.3", "0.2"] * 2}
    table = write(Path("curves"), header, varied)
    curves = {"rigid": [0, 2, 1], "normal compliance": [3, 5, 4]}
    figures = drawings.figures_of(plot, "curves")
    figure = figures["results"]
    outside = drawings.texts_outside(figure)
    faults = faults_of_curves(figure, table, "Contact/Gap", curves)
    check("curves", not faults and not outside and list(figures) == ["results"],
          "; ".join(faults + outside))

    def others(line):
        for name in LABELS.values():
            for runs in curves.values():
                curve = ([float(table["Contact/Gap"][i]) for i in runs],
                         [table[name][i] for i in runs])
                if not drawings.same(line, curve):
                    yield curve
    n_faults, missed = 0, []
    for fault in drawings.falsified(figure, others):
        n_faults += 1
        missed += [] if faults_of_curves(figure, table, "Contact/Gap", curves) else [
            fault]
    check("curves: faults noticed", n_faults > 100 and not missed,
          f"{n_faults - len(missed)} of {n_faults} {missed[:3]}")

    table = write(Path("failed"), header, {"Contact/Compliance": ["1", "0.01", "0.1"]},
                  [("status", 2, "failed: no convergence")])
    faults = faults_of_curves(
        drawings.figures_of(plot, "failed")["results"], table, "Contact/Compliance",
        {"": [1, 0]}, "A sweep\n1 of 3 runs failed: not drawn", "log")
    check("a run that failed; a wide range", not faults, "; ".join(faults))


def faults_of_map(figure, table, columns):
    """Cells by the order of the numbers of the two entries."""
    panels = [axes for axes in figure.axes if axes.get_xlabel()]
    bars = [axes.get_ylabel() for axes in figure.axes if not axes.get_xlabel() and
            axes.axison]
    faults = [] if bars == [label for label in LABELS if LABELS[label] in columns] else [
        f"colour bars {bars}"]
    xs, ys = (sorted(set(table[name]), key=float) for name in MAP)
    for panel, column in zip(panels, columns):
        words = [text.get_text() for text in panel.get_xticklabels()]
        if words != xs or [text.get_text() for text in panel.get_yticklabels()] != ys or \
                [panel.get_xlabel(), panel.get_ylabel()] != ["compliance", "gap"]:
            faults.append(f"{column}: ticks {words}")
        cells = numpy.reshape(panel.collections[0].get_array(), (len(ys), len(xs)))
        for i, (x, y) in enumerate(zip(*(table[name] for name in MAP))):
            if cells[ys.index(y), xs.index(x)] != table[column][i]:
                faults.append(f"{column} of run {i}")
    return faults if len(panels) == len(columns) else [*faults, "panels"]


MAP = ("Contact/Compliance", "Contact/Gap")


def check_maps(plot, header):
    pairs = [(x, y) for y in ("0.4", "0.1", "0.2", "0.3") for x in (
        "1", "10", "0.1", "0.01", "100")]
    varied = dict(zip(MAP, map(list, zip(*pairs))))
    table = write(Path("map"), header, varied)
    figure = drawings.figures_of(plot, "map")["results"]
    faults = faults_of_map(figure, table, list(LABELS.values()))
    check("maps", not faults, "; ".join(faults))
    other = {**table, "max_contact_force": table["max_penetration"]}
    check("maps: another column noticed", faults_of_map(
        figure, other, list(LABELS.values())))
    other = {**table, MAP[0]: table[MAP[0]][1:] + table[MAP[0]][:1]}
    check("maps: another order noticed", faults_of_map(
        figure, other, list(LABELS.values())))
    one = drawings.figures_of(plot, "map", "--result", "restitution")["results"]
    faults = faults_of_map(one, table, ["restitution"])
    check("one result", not faults, "; ".join(faults))


BIFURCATION = {r"$u(1)$ at multiples of $P$": "displacement_end",
               r"$u_t(1)$ at multiples of $P$": "velocity_end",
               r"$\theta(1)$ at multiples of $P$": "temperature_end",
               "peak force of a period": "peaks"}


def write_periods(directory, i):
    """Four periods of 2 of run i, with a force that is largest once in each,
    at the rear one of two stops in every other."""
    directory.mkdir()
    tables.write_table(directory / "poincare.csv", "A run", {
        "time": [0, 2, 4, 6, 8], **{name: [round((k + 2) * 0.1 + i + 0.01 * n, 9)
                                           for n in range(5)] for k, name in enumerate(
            list(BIFURCATION.values())[:3])}})
    times = [0.25 * n for n in range(33)]
    tables.write_table(directory / "contact.csv", "A run", {
        "time": times, "contact_force": [
            round((-1)**(t // 2) * (1 + i + 0.1 * (t // 2)), 9) if t % 2 == 1.25 else 0.5 for t in times]})


def check_bifurcation(plot, header):
    """The points of the last periods, and the largest force in each; run 2 has none."""
    gaps = ["0.1", "0.3", "0.2"]
    write(Path("driven"), header, {"Contact/Gap": gaps})
    for i in range(2):
        write_periods(Path(f"driven/run-{i}"), i)
    for options, periods in (([], (3, 4)), (["--periods", "3"], (2, 3, 4)),
                             (["--periods", "9"], (1, 2, 3, 4))):
        figure = drawings.figures_of(plot, "driven", "--figure", "bifurcation",
                                     *options)["bifurcation"]
        found = {BIFURCATION.get(panel.get_ylabel()): panel for panel in figure.axes}
        faults = [] if list(found) == list(BIFURCATION.values()) else [str(list(found))]
        for k, (name, panel) in enumerate(found.items()):
            expected = [(float(gaps[i]), (1 + i + 0.1 * (n - 1) if name == "peaks" else
                                          (k + 2) * 0.1 + i + 0.01 * n))
                        for i in range(2) for n in periods]
            points = [tuple(point) for line in panel.lines for point in line.get_xydata()]
            if sorted(points) != [(x, round(y, 9)) for x, y in sorted(expected)]:
                faults.append(f"{name}: {points}")
        if figure.axes[-1].get_xlabel() != "gap":
            faults.append("label of x")
        check(f"bifurcation {options}", not faults, "; ".join(faults))


def check_refusals(plot, header):
    write(Path("words"), header, {"Time/Scheme": ["sdirk2", "sdirk4"]})
    write(Path("many"), header, {"Contact/Gap": ["0.1", "0.2"] * 13, "Time/Scheme": [
        f"scheme {i // 2}" for i in range(26)]})
    write(Path("whole"), header, {"Contact/Gap": ["0.1", "0.2"]},
          [("restitution", i, "nan") for i in range(2)])
    for words, arguments in (
            (["several values that are numbers"], ["words", "--figure", "results"]),
            (["13 curves"], ["many"]), (["no run has a restitution"], [
                "whole", "--result", "restitution"]),
            (["--figure contact is one of runs"], ["whole", "--figure", "contact"]),
            (["drawn alone"], ["whole", "many"]),
            (["poincare.csv", "Output/Period"], ["whole", "--figure", "bifurcation"]),
            (["--periods must be at least 1"], ["whole", "--periods", "0"])):
        status, message = drawings.refusal_of(plot, *arguments)
        check(f"refused: {arguments}", status == 2 and message.count("\n") == 1 and
              all(word in message for word in words), message.strip())


def header_of_program():
    subprocess.run(
        [program, "--quiet", "--output", "program", "--set", "Time/End time=0.002",
         "--set", "Mesh/Cells=2", "--set", "Study/Vary=Mesh/Degree = 1 | 2",
         source / "prm/paper/experiment-1.prm"], check=True)
    return tables.header_of("program/study.csv")


def main():
    plot = drawings.load(source / "scripts", "plot")
    header = header_of_program()
    # every key result of the program has a label, and every label a key result
    n = len(LABELS)
    check("every result has a label", header[-n:] == list(LABELS.values()) == list(
        plot.plot_sweep.RESULTS) and list(LABELS) == list(
            plot.plot_sweep.RESULTS.values()))
    header = [name for name in header if "/" not in name]
    for part in (check_curves, check_maps, check_bifurcation, check_refusals):
        part(plot, header)


with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    main()
    os.chdir("/")
sys.exit(1 if n_failed else 0)
