#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_studies.py THERMOCONTACT SOURCE_DIRECTORY

The work-precision diagrams of scripts/plot show what their labels say. Tables
with the columns that the program writes, whose numbers are all different, are
drawn: the points of each curve are compared with the columns that the labels of
the axes name, of the runs that the legend names. Known by hand: which runs
belong to a curve and what it is called, which runs are not drawn, the axes.
The check is seen to fail on each curve with the data of each other column, on
exchanged and changed texts, and on artists that it does not know. Exit status
77, "skipped", without matplotlib.
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

program, source = sys.argv[1], Path(sys.argv[2]).resolve()
n_failed = 0
WORK = {"time of the loop, seconds": "loop_seconds",
        "linear solves": "solves", "degrees of freedom": "dofs"}
ERRORS = {r"error of the displacement  $u(1, t)$": "displacement_end",
          r"error of the velocity  $u_t(1, t)$": "velocity_end",
          "error of the contact force": "contact_force",
          r"error of the temperature  $\theta(1, t)$": "temperature_end",
          "error of the time of the first contact": "first_contact_time",
          r"error of the energy  $\hat{E}$": "energy"}
SCHEMES = {"Time/Scheme": ["backward euler"] * 3 + ["sdirk4"] * 3,
           "Time/Step size": ["0.02", "0.01", "0.005"] * 2}


def check(name, good, message=""):
    global n_failed
    n_failed += not good
    print(f"{'passed' if good else 'FAILED'}: {name}  {message}".rstrip())


class Study:
    """A directory with a study.csv, and what its picture has to show."""

    def __init__(self, directory, header, varied, curves, dofs=None, note="",
                 marks=(), changes=()):
        """
        varied: the entries and their values in each run
        curves: the runs by label, in the order in which they are joined
        dofs: of each run, if they are refined
        marks: (label, run)
        changes: (column, run, word in the table)
        """
        self.directory, self.curves, self.note = directory, curves, note
        self.marks, self.refined = list(marks), dofs is not None
        n_runs = len(next(iter(varied.values())))
        rest = header[header.index("status"):]
        self.table = {"run": list(range(n_runs)), **varied, **{
            name: [round((k + 2) * 1.37 ** i * 1e-3, 12) for i in range(n_runs)]
            for k, name in enumerate(rest)}}
        self.table["status"] = ["done"] * n_runs
        self.table["dofs"] = dofs or [77] * n_runs
        for column, i, word in changes:
            self.table[column][i] = word
        directory.mkdir()
        self.write(self.table)

    def write(self, table):
        tables.write_table(self.directory / "study.csv", "A study", table)

    def curve(self, runs, work, error):
        x, y = ([float(self.table[name][i]) for i in runs]
                for name in (work, error))
        return x, [abs(value) for value in y]


def faults_of_marks(axes, study, work, error):
    """Rings with their labels, which are taken from the lists of the axes."""
    points = [(*study.curve([run], work, error), label)
              for label, run in study.marks]
    rings = [line for line in axes.lines if line.get_markersize() == 12]
    found = [([*ring.get_xdata()], [*ring.get_ydata()], text.get_text())
             for ring, text in zip(rings, axes.texts)
             if text.xy == (ring.get_xdata()[0], ring.get_ydata()[0])]
    return [] if found == points and len(rings) == len(axes.texts) == len(
        points) else [f"marks {found}"]


def faults_of_study(figure, study):
    panels, entries = drawings.parts_of(figure)
    titles = [text.get_text() for text in figure.texts]
    notes = [text.get_text() for axes in figure.axes if not axes.axison
             for text in axes.texts]
    labels = [panel.get_xlabel() for panel in panels]
    faults = [] if titles == ["A study"] and notes == [study.note] else [
        f"texts {titles} {notes}"]
    if labels != ["time of the loop, seconds", "degrees of freedom" if
                  study.refined else "linear solves"] or \
            panels[0].get_ylabel() not in ERRORS or panels[1].get_ylabel():
        return [*faults, f"labels {labels}"]
    if [text for text, _ in entries] != [label for label in study.curves
                                         if label]:
        return [*faults, f"legend {entries}"]
    error = "error_" + ERRORS[panels[0].get_ylabel()]
    for panel, label in zip(panels, labels):
        expected = dict(zip(
            [(drawings.looks_of(handle), handle.get_marker())
             for _, handle in entries] or [None],
            [study.curve(runs, WORK[label], error)
             for runs in study.curves.values()]))
        faults += [label + artist for artist in drawings.unknown_artists(panel)]
        faults += drawings.faults_of_range(panel)
        faults += faults_of_marks(panel, study, WORK[label], error)
        for line in panel.lines:
            looks = drawings.looks_of(line), line.get_marker()
            curve = expected.pop(looks if entries else None, None)
            if line.get_markersize() != 12 and (
                    curve is None or not drawings.same(line, curve)):
                faults.append(f"{label}: {looks} is another curve")
        if expected or panel.patches or panel.get_title():
            faults.append(f"{label}: no curve {list(expected)}")
        if (panel.get_xscale(), panel.get_yscale()) != ("log", "log"):
            faults.append(f"{label}: scales")
    return faults


def check_study(plot, name, study, falsify=False):
    """The errors one after the other."""
    for label, error in ERRORS.items():
        figure = drawings.figures_of(
            plot, study.directory, "--error", error, *(
                part for text, run in study.marks
                for part in ("--mark", f"{text}={run}")))["work-precision"]
        outside = drawings.texts_outside(figure)
        faults = faults_of_study(figure, study) + outside
        good = drawings.parts_of(figure)[0][0].get_ylabel() == label
        check(f"{name}, {error}", good and not faults, "; ".join(faults))
    if not falsify:
        return
    columns = [[float(value) for value in values] for column, values in
               study.table.items() if column == "dofs" or "_" in column]

    def others(line):
        for runs in study.curves.values():
            x = [study.table[name] for name in WORK.values()]
            for xs in x:
                for ys in columns:
                    curve = [xs[i] for i in runs], [ys[i] for i in runs]
                    if not drawings.same(line, curve):
                        yield curve
    n_faults, missed = 0, []
    for fault in drawings.falsified(figure, others):
        n_faults += 1
        missed += [] if faults_of_study(figure, study) else [fault]
    check(f"{name}: faults noticed", n_faults > 100 and not missed,
          f"{n_faults - len(missed)} of {n_faults} {missed[:3]}")
    check(f"{name}: as before", not faults_of_study(figure, study))


def check_curves(plot, make):
    """Schemes, the mesh, what has no name, error control."""
    two = {"backward euler": [0, 1, 2], "sdirk4": [3, 4, 5]}
    check_study(plot, "schemes", make("schemes", SCHEMES, two,
                                      marks=[("mine", 4), ("yours", 0)]),
                falsify=True)
    mesh = {"Mesh/Degree": ["1", "2"] * 3, "Mesh/Cells": [
        "16", "16", "8", "8", "4", "4"]}
    # joined by degrees of freedom; a label has the name of a number
    check_study(plot, "mesh", make(
        "mesh", mesh, {"degree 1": [4, 2, 0], "degree 2": [5, 3, 1]},
        dofs=[34, 66, 18, 34, 10, 18]), falsify=True)
    check_study(plot, "numbers", make(
        "numbers", {"Model/Viscosity": ["0.1", "0.2", "0.4"]}, {"": [0, 1, 2]}))
    # what more than 70 % have in common is not in the labels
    check_study(plot, "common", make("common", {
        **SCHEMES, "Mesh/Degree": ["6", "6", "6", "6", "1", "6"]}, {
            "backward euler": [0, 1, 2], "sdirk4": [3, 5],
            "sdirk4, degree 1": [4]}))
    check_study(plot, "error control", make("controlled", {
        "Time/Scheme": [*SCHEMES["Time/Scheme"], "sdirk4", "sdirk4"],
        "Time/Step size": [*SCHEMES["Time/Step size"], *["automatic"] * 2],
        "Time/Tolerance": ["1e-5"] * 6 + ["1e-3", "1e-4"]},
        {**two, "sdirk4, error-controlled": [6, 7]}))


def check_left_out(plot, make):
    """Runs that failed, or whose error or work no logarithmic axis has."""
    errors = [f"error_{error}" for error in ERRORS.values()]
    check_study(plot, "left out", make(
        "left out", SCHEMES, {"backward euler": [0, 2], "sdirk4": [4]},
        changes=[("status", 1, "failed: no convergence"), ("solves", 3, 0),
                 *((error, 5, "") for error in errors),
                 *((error, 2, -0.75) for error in errors)],
        note="Of 6 runs not drawn: 1 failed, 1 with solves 0, "
        "1 with error nan"))


def check_refused(plot, what, words, *arguments):
    status, message = drawings.refusal_of(plot, *arguments)
    check(f"refused: {what}", status == 2 and message.count("\n") == 1 and
          all(word in message for word in words), message.strip())


def check_refusals(plot, make):
    study = make("whole", SCHEMES, {}, changes=[("status", 1, "failed: no")])
    whole = dict(study.table)
    for label, words in (("a=1", ["run 1 cannot be marked: failed"]),
                         ("a=9", ["run 9", "not in the study"]),
                         ("a", ["LABEL=RUN"])):
        check_refused(plot, f"mark {label}", words, study.directory, "--mark",
                      label)
    for name in ("run", "status", *WORK.values(), "error_displacement_end"):
        study.write({n: v for n, v in whole.items() if n != name})
        check_refused(plot, f"no {name}", [f"no column {name};"],
                      study.directory)
        if name not in ("run", "status"):
            study.write({**whole, name: ["nan"] * 6})
            check_refused(plot, f"{name} without numbers", [
                "no run to draw", "1 failed", "5 with", "nan"], study.directory)
            study.write({**whole, name: ["x"] * 6})
            check_refused(plot, f"{name} x", ["study.csv:4", name, "'x'"],
                          study.directory)
    study.write({n: [] for n in whole})
    check_refused(plot, "no rows", ["none has ended yet"], study.directory)
    (study.directory / "study.csv").write_text("")
    check_refused(plot, "an empty file", ["is empty"], study.directory)
    check_refused(plot, "two studies", ["drawn alone"], study.directory,
                  study.directory)


def header_of_program():
    subprocess.run(
        [program, "--quiet", "--output", "program", "--set",
         "Time/End time=0.002", "--set", "Mesh/Cells=2", "--set",
         "Study/Vary=Mesh/Degree = 1 | 2", "--set",
         "Study/Reference=Mesh/Degree = 3",
         source / "prm/paper/experiment-1.prm"], check=True,
        env={**os.environ, "OMPI_MCA_btl": "self",
             "OMPI_MCA_ess_singleton_isolated": "1"})
    return tables.header_of("program/study.csv")


def main():
    plot = drawings.load(source / "scripts", "plot")
    header = header_of_program()
    here = Path(".").resolve()
    # every error of the table has a label, and every label an error
    check("every error has a check", list(ERRORS.values()) == [
        name[6:] for name in header if name.startswith("error_")] == list(
            plot.plot_study.ERRORS))

    def make(name, *arguments, **more):
        return Study(here / name, header, *arguments, **more)

    for part in (check_curves, check_left_out, check_refusals):
        part(plot, make)


with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    main()
    os.chdir("/")
sys.exit(1 if n_failed else 0)
