#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_curves.py THERMOCONTACT SOURCE_DIRECTORY

The pictures that scripts/plot makes of runs show what their labels say. Tables
whose every number tells where it stands (tables.py), with the columns that the
program writes, are drawn; the data of each line in each panel are compared with
the column that the label of the axis names, of the run that the legend names by
colour and dashes. Known by hand: times in contact, the place of the obstacle,
the texts. A panel, line or other artist that no check knows is a fault.

The check is seen to fail: each line takes the data of each other column, each
pair of labels is changed over, each number in a text changed, artists added.
Exit status 77, "skipped", without matplotlib.
"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import numpy
    import drawings
    import run_pictures
    import tables
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

program, source = sys.argv[1], Path(sys.argv[2]).resolve()
n_failed = 0
ALL = {"figure": run_pictures.FIGURE, "contact": run_pictures.CONTACT,
       "energy": run_pictures.ENERGY}


def check(name, good, message=""):
    global n_failed
    n_failed += not good
    print(f"{'passed' if good else 'FAILED'}: {name}  {message}".rstrip())


def other_columns(runs):
    """For a line: all the columns of all runs that it does not show."""
    def others(line):
        for run in runs:
            for name in run.contact:
                values = run.contact[name]
                curve = run.contact["time"], values
                if "nan" not in values and not drawings.same(line, curve):
                    yield curve
    return others


def check_seen(name, figure, faults_of, others):
    """A figure without faults, then one fault after the other: all noticed."""
    outside = drawings.texts_outside(figure)
    check(f"{name}: texts inside", not outside, str(outside))
    faults = faults_of()
    check(name, not faults, "; ".join(map(str, faults[:3])))
    n_faults, missed = 0, []
    for fault in drawings.falsified(figure, others):
        n_faults += 1
        missed += [] if faults_of() else [fault]
    check(f"{name}: faults noticed", n_faults > 10 and not missed,
          f"{n_faults - len(missed)} of {n_faults} " + "; ".join(missed[:5]))
    check(f"{name}: as before", not faults_of())


def check_histories(plot, name, runs, expected, *arguments, falsify=False):
    """expected: by the name of each picture, its panels and their columns."""
    figures = drawings.figures_of(plot, *(run.directory for run in runs),
                                  *arguments)
    for picture, (panels, columns) in expected.items():
        some, figure = run_pictures.shown(panels, runs), figures.pop(picture)

        def faults_of():
            return run_pictures.faults_of_histories(figure, some, panels,
                                                    columns)
        if falsify:
            check_seen(f"{name}, {picture}", figure, faults_of,
                       other_columns(some))
        else:
            faults = faults_of()
            check(f"{name}, {picture}", not faults, "; ".join(faults[:3]))
    check(f"{name}: pictures", not figures, str(list(figures)))


def check_attempts(plot, runs):
    """Pictures steps and probes; the other columns of their own tables."""
    for kind, faults_of in (("steps", run_pictures.faults_of_steps),
                            ("probes", run_pictures.faults_of_probes)):
        for some in (runs[:1], runs):
            figure = drawings.figures_of(plot, "--figure", kind, *(
                run.directory for run in some))[kind]

            def others(line):
                for table in (getattr(run, kind) for run in some):
                    for values in table.values():
                        curve = table["time"], values
                        if not isinstance(values[0], str) and not \
                                drawings.same(line, curve):
                            yield curve
            check_seen(f"{kind} of {len(some)}", figure,
                       lambda: faults_of(figure, some), others)


def check_end_time(plot, run):
    """Steps and probes until 0.6, when an attempt begins: six and four rows."""
    run.add_steps()
    run.add_probes(["x = 0.5"])
    for kind, n, faults_of in (("steps", 6, run_pictures.faults_of_steps),
                               ("probes", 4, run_pictures.faults_of_probes)):
        table = getattr(run, kind)
        table.update({name: values[:n] for name, values in table.items()})
        figure = drawings.figures_of(plot, "--figure", kind, "--end-time", "0.6",
                                     run.directory)[kind]
        faults = faults_of(figure, [run])
        check(f"{kind} until 0.6", not faults, "; ".join(faults))


def headers_of_program():
    """The columns of contact.csv, steps.csv and probes.csv as it writes them."""
    subprocess.run(
        [program, "--quiet", "--output", "program", "--set",
         "Time/End time=0.002", "--set", "Mesh/Cells=2", "--set",
         "Output/Probes=0.5", "--set", "Time/Step size=automatic", "--set",
         "Time/Scheme=sdirk4", "--set", "Time/Start=consistent",
         source / "prm/paper/experiment-1.prm"],
        check=True, env={**os.environ, "OMPI_MCA_btl": "self",
                         "OMPI_MCA_ess_singleton_isolated": "1"})
    return {name: tables.header_of(f"program/{name}.csv")
            for name in ("contact", "steps", "probes")}


def check_usual(plot, make):
    """One run and several; every line takes the data of every other column."""
    check("every picture has a check", set(plot.plot_figures.FIGURES) == {
        *ALL, "steps", "probes", "decay"})
    a = make("a", 0, "Rod A", contacts=[(0.15, 0.5), (0.7, 1.2)])
    b = make("b", 1, "Rod B", contacts=[(0.2, 0.4)], status=None,
             label="Rod B (unfinished, $t$ = 1.8)")
    c = make("c", 2, "Rod C")
    for name, runs in (("one", [a]), ("two", [b, a])):
        check_histories(plot, name, runs, ALL, falsify=True)
    for name, runs in (("without contact", [c]), ("three", [c, a, b])):
        check_histories(plot, name, runs, ALL)

    for run in (a, b):
        run.add_steps()
        run.add_probes(["x = 0.5", "x = 0.75", "x = 1"])
    check_attempts(plot, [a, b])
    check_end_time(plot, make("end", 2, "Rod C"))
    b.add_probes(["x = 0.5", "x = 0.25"])
    figure = drawings.figures_of(plot, "--figure", "probes", a.directory,
                                 b.directory)["probes"]
    faults = run_pictures.faults_of_probes(figure, [a, b])
    check("probes at other places", not faults, "; ".join(faults))
    for some in ([a], [b, c]):
        figure = drawings.figures_of(plot, "--figure", "decay", *(
            run.directory for run in some))["decay"]
        check_seen(f"decay of {len(some)}", figure, lambda:
                   run_pictures.faults_of_decay(figure, some),
                   other_columns(some))


def check_labels(plot, make):
    """What the legend says of runs of the same title, or that have not ended."""
    twins = [make(f"twin {r}", r, "Twin", label=f"Twin ({Path().resolve()}"
                  f"/twin {r})") for r in range(2)]
    check_histories(plot, "same title", twins, ALL)
    blank = [make(f"untitled {r}", r, "", label=f"untitled {r}")
             for r in range(2)]
    check_histories(plot, "no title", blank, ALL)
    costs = [make(f"costs {r}", r, f"Rod {r} of 5$ or 6$",  # no formula
                  label=rf"Rod {r} of 5\$ or 6\$") for r in range(2)]
    check_histories(plot, "dollars", costs, ALL)
    ten = [make(f"of ten {r}", r, f"Rod {r}") for r in range(10)]
    check_histories(plot, "ten", ten, ALL)
    long = [make(f"long {r}", r, f"Rod {r}" + 50 * "o", contacts=[(0, 1)])
            for r in range(2)]
    for run in long:
        run.add_probes(["x = 0.5", "x = 1"])
    for name, figure in drawings.figures_of(
            plot, *(run.directory for run in long)).items():
        outside = drawings.texts_outside(figure)
        check(f"long titles: {name}", not outside, str(outside))
    # by summary.json; the time is that of the last row, whatever is drawn
    for status in ("failed", "interrupted"):
        run = make(status, 0, "Rod", status=status, contacts=[(0.7, 1.2)],
                   label=f"Rod ({status}, $t$ = 1.7)")
        check_histories(plot, status, [run], ALL)
    run.times = run.times[:4]
    run.contact = {name: values[:4] for name, values in run.contact.items()}
    run.contacts = []
    check_histories(plot, "until 0.6", [run], ALL, "--end-time", "0.6")


def check_cut(plot, make):
    """A last row that is not all there, of which each number could be one, and
    a first one that the user has cut off."""
    run = make("cut", 0, "Rod", status=None, label="Rod (unfinished, $t$ = 1)")
    run.contact = {name: values[1:] for name, values in run.contact.items()}
    run.write_contact()
    path = run.directory / "contact.csv"
    path.write_text(path.read_text()[:-3])  # the end of the line and two digits
    run.times = run.times[1:5]
    run.contact = {name: values[:4] for name, values in run.contact.items()}
    check_histories(plot, "cut", [run], ALL)


def check_contacts(plot, make):
    """Contact at the start, at the end, and by the rows without events."""
    start = make("start", 0, "Rod", contacts=[(0, 0.05), (1.6, 1.7)])
    tables.write_table(start.directory / "events.csv", "Rod", {
        "time": [0.05, 1.6], "kind": ["end", "begin"], "velocity": [1, 1]})
    check_histories(plot, "contact at both ends", [start], ALL)
    rows = make("rows", 0, "Rod", in_contact=[0, 1, 1, 0, 0, 1],
                contacts=[(0.1, 0.6)])
    for name, text in (("no events.csv", None), ("empty events.csv", ""),
                       ("no events", "# Rod\ntime,kind,velocity\n")):
        (rows.directory / "events.csv").unlink()
        if text is not None:
            (rows.directory / "events.csv").write_text(text)
        check_histories(plot, name, [rows], ALL)
        (rows.directory / "events.csv").touch()


def check_scenes(plot, make):
    """Fields, loads and logarithms that a scene does not have."""
    still = dict.fromkeys(["displacement_end", "displacement_mid", "stress_end",
                           "velocity_end", "gap", "contact_force",
                           "contact_impulse", "penetration"])
    heat = make("heat", 3, "Heat", **still)
    check_histories(plot, "heat", [heat], {
        "figure": run_pictures.HEAT, "energy": run_pictures.ENERGY})
    check_histories(plot, "heat and rod", [heat, make("rod", 0, "Rod")], ALL)
    cold = make("cold", 0, "Cold", temperature_end=None, temperature_mean=None,
                heat_flux_end=None)
    figure, columns = run_pictures.FIGURE
    energy, _ = run_pictures.ENERGY
    check_histories(plot, "no temperature", [cold], {**ALL, "figure": (
        [label for label in figure if "theta" not in label], columns)})
    free = make("free", 0, "Free", gap=None, contact_force=None,
                contact_impulse=None, stress_end=0, work=0)
    check_histories(plot, "nothing acts", [free], {
        "figure": ([label for label in figure if "sigma" not in label], 2),
        "energy": ([label for label in energy if label != "work"], 2)})
    for value, name in ((-0.01, "no logarithm"), (-0.00999, "logarithm")):
        low = make(name, 0, "Low", energy=[2, 1, value, 1, 1, 1])
        labels = figure[:-1] + [run_pictures.PLAIN_ENERGY
                                if value == -0.01 else figure[-1]]
        for runs in ([low], [make(f"high {name}", 1, "High"), low]):
            check_histories(plot, f"{name} of {len(runs)}", runs,
                            {**ALL, "figure": (labels, 2)})
    solved = make("iterative", 0, "Iterative", algebraic=[0, -.1, .2, .1, .4, .3])
    check_histories(plot, "what residuals do", [solved], ALL)
    damped = make("damped", 0, "Damped", contact_dissipation=[0, 0, .1, .2, .2, .3])
    check_histories(plot, "what the obstacle takes", [damped],
                    {**ALL, "energy": run_pictures.DAMPED})
    blind = make("blind", 0, "Blind", energy=None)
    check_histories(plot, "no energy", [blind], {
        "figure": (figure[:-1], 2), "contact": ALL["contact"]})


def check_refused(plot, what, words, *arguments):
    status, message = drawings.refusal_of(plot, *arguments)
    check(f"refused: {what}", status == 2 and message.count("\n") == 1 and
          all(word in message for word in words), message.strip())


def check_refusals(plot, make):
    """Each column that is missing, empty or no number; nothing to tell apart."""
    names = [*run_pictures.COLUMNS, "time", "in_contact"]
    run = make("whole", 0, "Rod")
    whole = dict(run.contact)
    for name in names:
        run.contact = {n: v for n, v in whole.items() if n != name}
        run.write_contact()
        check_refused(plot, f"no {name}", ["contact.csv", f"no column {name};"],
                      run.directory)
        run.contact = {**whole, name: ["", *whole[name][1:]]}
        run.write_contact()
        check_refused(plot, f"empty {name}", ["contact.csv:4", name, "''"],
                      run.directory)
    run.contact = {n: v for n, v in whole.items() if n in names}
    run.write_contact()
    check_histories(plot, "only what is drawn", [run], ALL)
    none = make("none", 0, "None", **dict.fromkeys(
        name for name in run_pictures.COLUMNS))
    for picture in ("figure", "contact", "energy", "steps", "probes", "decay"):
        check_refused(plot, f"{picture} without numbers",
                      [f"no picture {picture}", "it needs"], none.directory,
                      "--figure", picture)
    check_refused(plot, "no numbers at all", ["no numbers"], none.directory)

    some = [make(f"some {r}", r, f"Rod {r}") for r in range(5)]
    for one in some:
        one.add_steps()
        one.add_probes([f"x = {i / 20}" for i in range(13 if one is some[0]
                                                       else 1)])
    for runs in (some[:1], some):
        check_refused(plot, f"probes of {len(runs)}", ["cannot be told apart"],
                      "--figure", "probes", *(one.directory for one in runs))
    for table in ("steps", "events"):
        path = some[0].directory / f"{table}.csv"
        path.write_text("# Rod\nother\n1\n")
        check_refused(plot, f"{path.name} of something else",
                      [path.name, "no column"], some[0].directory)
        path.unlink()


def main():
    plot = drawings.load(source / "scripts", "plot")
    headers = headers_of_program()
    here = Path(".").resolve()

    def make(name, number, title, **more):
        return tables.Run(here / name, number, headers, title, **more)

    for part in (check_usual, check_labels, check_cut, check_contacts, check_scenes,
                 check_refusals):
        part(plot, make)


with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    main()
    os.chdir("/")
sys.exit(1 if n_failed else 0)
