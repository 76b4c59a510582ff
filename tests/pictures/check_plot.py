#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_plot.py THERMOCONTACT SOURCE_DIRECTORY

What scripts/plot draws of runs is what its labels say: the data of each line are
the column that the label of its axis names, of the run that the legend names by
colour and dashes; times in contact and the obstacle are those of the scene. By
the description of the pictures (scripts/plot --help), which files are written
follows from what a run has: error-controlled with both fields, cut off within a
row as a killed run leaves it, temperature alone. What cannot be drawn is refused.
Exit status 77, "skipped", without matplotlib.
"""
import argparse
import contextlib
import html
import io
import json
import re
import shutil
import struct
import sys
from pathlib import Path

try:
    import drawings
    import numpy
    from drawings import check, check_refused, table
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)


def defect(t):
    """E(0) + work + algebraic - E - all dissipations, (D4.1)."""
    return (t["energy"][0] + t["work"] + t.get("algebraic", 0.) - t["energy"] -
            t["dissipation"] - t["numerical_dissipation"] - t.get("contact_dissipation", 0.))


# The label of an axis, and the column that it names or what follows from some.
CURVES = {
    "displacement  $u(1, t)$": "displacement_end",
    "displacement  $u(1/2, t)$": "displacement_mid",
    "velocity  $u_t(1, t)$": "velocity_end",
    r"stress  $\sigma(1, t)$": "stress_end",
    r"temperature  $\theta(1, t)$": "temperature_end",
    r"mean temperature  $\bar{\theta}(t)$": "temperature_mean",
    r"heat flux  $-\theta_x(1, t)$": "heat_flux_end",
    r"$\ln\,(\hat{E} + 0.01)$": lambda t: numpy.log(t["energy"] + 0.01),
    "gap  $g - u(1, t)$": "gap",
    "contact force  $F(t)$": "contact_force",
    r"impulse  $\int_0^t F$": "contact_impulse",
    "energy  $\\hat{E}$\n(no heat content)": "energy",
    "work": "work", "dissipation": "dissipation",
    "numerical dissipation": "numerical_dissipation",
    "dissipation by the obstacle": "contact_dissipation",
    "largest pressure  $p$": "max_pressure", "area in contact / area": "contact_area",
    "defect of the balance": defect, "defect of the balance\n(rounding)": defect,
}
FIELDS = {r"temperature  $\theta$": "temperature",
          r"displacement  $u$": "displacement",
          r"velocity  $u_t$": "velocity", r"stress  $\sigma$": "stress"}
STEPS = {r"step size  $\Delta t$": "step_size", "error / tolerance": "error"}


def faults_of(figure, runs):
    """runs: the label in the legend (of one run "") and its tables."""
    panels, legend = drawings.panels_of(figure)
    faults = []
    for panel in panels:
        label = panel.get_ylabel()
        if label not in CURVES:
            return [f"unknown label {label!r}"]
        left = dict(runs)
        for line in panel.lines:
            if len(line.get_ydata()) == 2:  # the obstacle
                level = 0.1 if label.startswith("displacement") else 0.
                if set(line.get_ydata()) != {level}:
                    faults.append(f"{label}: obstacle at {line.get_ydata()}")
                continue
            name = legend.get(drawings.looks_of(line)) if len(runs) > 1 else ""
            if name not in left:
                faults.append(f"{label}: a curve of {name}")
                continue
            data, what = left.pop(name), CURVES[label]
            y = what(data) if callable(what) else data[what]
            rounding = 1e-14 * data["energy"][0] if what == defect else 0.
            if not drawings.same(line, data["time"], y, rounding):
                faults.append(f"{label}: another curve for {name!r}")
        faults += [f"{label}: no curve of {name!r}" for name in left]
    return faults


def check_figures(plot):
    """Two rods in contact; each line is falsified by the next column once."""
    tables = {name: table(Path(name, "contact.csv"))
              for name in ("controlled", "killed")}
    events, end = table("controlled/events.csv")["time"], tables["controlled"]["time"][-1]
    contact = [events[0], events[1] if len(events) > 1 else end]
    figures = drawings.figures_of(plot, "controlled")
    n_curves = 0
    for picture in ("figure", "contact", "energy"):
        figure = figures[picture]
        one = {"": tables["controlled"]}
        faults = faults_of(figure, one)
        check(f"curves of {picture}", not faults, "; ".join(faults))
        panels, _ = drawings.panels_of(figure)
        for panel in panels:
            # polygons, or rectangles from matplotlib 3.9
            x = panel.patches[0].get_patch_transform().transform(
                panel.patches[0].get_path().vertices)[:, 0]
            check(f"shaded in {panel.get_ylabel()!r}", numpy.allclose(
                [min(x), max(x)], contact, rtol=1e-12, atol=0), f"{min(x)} {max(x)}")
            line = next(l for l in panel.lines if len(l.get_ydata()) > 2)
            x, y = line.get_data()
            line.set_ydata(numpy.roll(y, 1))
            n_curves += bool(faults_of(figure, one))
            line.set_ydata(y)
    check("other data are noticed", n_curves == 12, str(n_curves))  # but the defect

    for name in tables:
        path = Path(name, "contact.csv")
        path.write_text(f"# {name}" + path.read_text().partition("\n")[1:][0] +
                        path.read_text().partition("\n")[2])
    two = drawings.figures_of(plot, "controlled", "killed")
    _, legend = drawings.panels_of(two["contact"])
    labels = [text for text in legend.values() if text.startswith(("contr", "killed"))]
    check("runs in the legend", [label.split()[0] for label in labels] == [
        "controlled", "killed"] and "unfinished" in labels[1], str(labels))
    for picture in ("figure", "contact", "energy"):
        faults = faults_of(two[picture], dict(zip(labels, tables.values())))
        check(f"curves of {picture}, two runs", not faults, "; ".join(faults))


def check_other_tables(plot):
    """The accepted steps, and the fields at two places."""
    steps = table("controlled/steps.csv")
    good = steps["accepted"] == 1
    panels, _ = drawings.panels_of(drawings.figures_of(
        plot, "controlled", "--figure", "steps")["steps"])
    check("steps", [panel.get_ylabel() for panel in panels] == list(STEPS) and all(
        any(drawings.same(line, steps["time"][good], steps[column][good])
            for line in panel.lines) for panel, column in zip(
                panels, STEPS.values())))
    probes = table("controlled/probes.csv")
    panels, legend = drawings.panels_of(drawings.figures_of(
        plot, "controlled", "--figure", "probes")["probes"])
    shown = [legend.get(drawings.looks_of(line)) == f"probe {i}: $x$ = {x}"
             for panel in panels for i, x in ((1, "0.25"), (2, "1"))
             for line in panel.lines
             if drawings.same(line, probes["time"],
                              probes[f"{FIELDS[panel.get_ylabel()]}_{i}"])]
    check("probes", len(panels) == 4 and len(shown) == 8 and all(shown), str(legend))


def check_end_time(plot):
    """Rows up to there in every picture, and contact that goes on cut off there."""
    end, figures = 0.3, drawings.figures_of(plot, "controlled", "--end-time", "0.3")
    rows = table("controlled/contact.csv")
    rows = {name: values[rows["time"] <= end] for name, values in rows.items()}
    for picture in ("figure", "contact", "energy"):
        faults = faults_of(figures[picture], {"": rows})
        check(f"end time: curves of {picture}", not faults, "; ".join(faults))
        panels, _ = drawings.panels_of(figures[picture])
        shaded = panels[0].patches[0]
        x = shaded.get_patch_transform().transform(shaded.get_path().vertices)[:, 0]
        check(f"end time: shaded in {picture}", numpy.allclose(
            [min(x), max(x)], [table("controlled/events.csv")["time"][0], rows["time"][-1]],
            rtol=1e-12, atol=0), f"{min(x)} {max(x)}")
    for picture in ("probes", "steps"):
        panels, _ = drawings.panels_of(figures[picture])
        times = [time for panel in panels for line in panel.lines if len(line.get_xdata()) > 2
                 for time in line.get_xdata()]
        table_of = table(f"controlled/{picture}.csv")["time"]
        check(f"end time: {picture}", max(times) == max(table_of[table_of <= end]), str(max(times)))


def check_strip(plot):
    """A strip by the iterative solver on a damped obstacle: all terms of the balance and the
    contact of its face; the run has failed, as the legend beside another one says."""
    rows = table("strip/contact.csv")
    figures = drawings.figures_of(plot, "strip")
    for picture, n_panels in (("contact", 5), ("energy", 5)):  # no work is done
        faults = faults_of(figures[picture], {"": rows})
        panels, _ = drawings.panels_of(figures[picture])
        check(f"strip: curves of {picture}", not faults and len(panels) == n_panels,
              "; ".join(faults) + str([panel.get_ylabel() for panel in panels]))
    check("strip: terms", max(abs(rows["algebraic"])) > 0 and rows["contact_dissipation"][-1] > 0)
    summary = json.loads(Path("strip/summary.json").read_text())
    summary["status"] = "failed: no step"
    Path("strip/summary.json").write_text(json.dumps(summary))
    _, legend = drawings.panels_of(drawings.figures_of(plot, "strip", "controlled")["contact"])
    end = f"{rows['time'][-1]:.4g}"
    check("strip: failed", any(f" (failed: no step, $t$ = {end})" in text
                               for text in legend.values()), str(legend))


def check_two_obstacles(plot):
    """Lines at u(1) = 0.1 and -0.07, the gaps of the scene, and both in the legend."""
    figures = drawings.figures_of(plot, "between")
    panel = drawings.panels_of(figures["figure"])[0][0]
    levels = sorted(line.get_ydata()[0] for line in panel.lines if len(line.get_ydata()) == 2)
    check("two obstacles", numpy.allclose(levels, [-0.07, 0.1], rtol=1e-9, atol=0), str(levels))
    panels, legend = drawings.panels_of(figures["contact"])
    check("two obstacles, words", panels[0].get_ylabel() == "gap to the nearer obstacle" and
          "obstacle, $g$ = 0.1; $g_2$ = 0.07" in legend.values(), str(legend))


def check_rounding(plot):
    """A rod that a rigid wall without a gap holds: its end moves by rounding, which a panel as
    high as the motion of the middle shows as nothing."""
    rows = table("held/contact.csv")
    panels = {panel.get_ylabel(): panel for panel in drawings.panels_of(
        drawings.figures_of(plot, "held")["figure"])[0]}
    moved = max(abs(rows["displacement_mid"]))
    for label, column, size in (
            ("displacement  $u(1, t)$", "displacement_end", moved),
            ("velocity  $u_t(1, t)$", "velocity_end", 1e3 * max(abs(rows["velocity_end"])))):
        panel = panels.get(f"{label}\n(rounding)")
        check(f"rounding of {column}", panel and numpy.allclose(
            panel.get_ylim(), (-size, size), rtol=1e-12, atol=0) and any(
                drawings.same(line, rows["time"], rows[column]) for line in panel.lines),
              str(list(panels)))
    check("rounding: the middle moves", "displacement  $u(1/2, t)$" in panels and moved > 1e-3 and
          0 < max(abs(rows["displacement_end"])) < 1e-12 * moved)


ROW = {"gap  $g - u_L + u_R$": "gap", "contact force  $F(t)$": "contact_force",
       r"impulse  $\int_0^t F$": "contact_impulse"}


def check_row(plot):
    """Of two rows of four rods each contact has the colour that the legend gives its name,
    and each run has dashes: its curves are the columns of contacts/NAME.csv, of which a report
    shows the bodies."""
    names = ["a-b", "b-c", "c-d"]
    for runs in (["row"], ["row", "wide-row"]):
        panels, legend = drawings.panels_of(drawings.figures_of(
            plot, *runs, "--figure", "row")["row"])
        colours = {looks[0]: text for looks, text in legend.items() if text in names}
        found = [(panel.get_ylabel(), name, run) for panel in panels for line in panel.lines
                 for name in [colours[drawings.looks_of(line)[0]]] for run in runs
                 if drawings.same(line, *(table(f"{run}/contacts/{name}.csv")[column]
                                          for column in ("time", ROW[panel.get_ylabel()])))]
        check(f"row: {len(runs)} runs", sorted(found) == sorted(
            (label, name, run) for label in ROW for name in names for run in runs) and
            all(len(panel.lines) == 3 * len(runs) for panel in panels), f"{found} {legend}")
    dashes = {line.get_label(): line.get_linestyle() for line in panels[0].lines}
    check("row: dashes", len({drawings.looks_of(line) for line in panels[0].lines}) == 6,
          str(dashes))
    end, times = 0.7, table("row/contacts/a-b.csv")["time"]
    panels, _ = drawings.panels_of(drawings.figures_of(
        plot, "row", "--figure", "row", "--end-time", f"{end}")["row"])
    check("row: end time", {max(line.get_xdata()) for panel in panels for line in panel.lines} == {
        max(times[times <= end])} and max(times) > end)
    page = io.StringIO()
    before, sys.argv = sys.argv, ["plot", "--report", "row"]
    with contextlib.redirect_stdout(page):
        plot.main()
    sys.argv = before
    text = html.unescape(Path("row/report.html").read_text(encoding="utf-8"))
    check("row: report", "  row       a (rod of length 0.5, 160 cells)" in text and
          '<img alt="row"' in text, text[:2000])


def check_prefixes(plot):
    """Of the largest value in SI units, from 1 to 1000: those of the columns; a tick at y
    says y in the unit of its label, of the probes too. The gap is 0.5 mm in the legend."""
    rows, probes = table("steel/contact.csv"), table("steel/probes.csv")
    rows.update({field: numpy.concatenate([probes[f"{field}_{i}"] for i in (1, 2)])
                 for field in FIELDS.values()})
    figures = drawings.figures_of(plot, "steel")
    for picture, label, column, unit in (
            ("contact", "gap  $g - u(L, t)$", "gap", "m"),
            ("contact", "contact force  $F(t)$", "contact_force", "N"),
            ("figure", r"stress  $\sigma(L, t)$", "stress_end", "Pa"),
            ("figure", r"temperature  $\theta(L, t)$", "temperature_end", "°C"),
            ("energy", "energy  $\\hat{E}$\n(no heat content)", "energy", "J"),
            ("probes", r"displacement  $u$", "displacement", "m"),
            ("probes", r"stress  $\sigma$", "stress", "Pa"),
            ("probes", r"temperature  $\theta$", "temperature", "°C")):
        largest, sizes = max(abs(rows[column])), {"µ": 1e-6, "m": 1e-3, "": 1, "k": 1e3, "M": 1e6}
        prefix, size = next((prefix, size) for prefix, size in sizes.items()
                            if unit == "°C" or size <= largest < 1e3 * size)
        prefix, size = ("", 1) if unit == "°C" else (prefix, size)
        panels = {panel.get_ylabel(): panel for panel in drawings.panels_of(figures[picture])[0]}
        panel = panels.get(f"{label} [{prefix}{unit}]")
        ticks = panel.get_yticks() if panel else []
        words = panel.yaxis.get_major_formatter().format_ticks(ticks) if panel else []
        numbers = [float(re.sub(r"[^-.\d]", "", word.replace("\u2212", "-"))) for word in words]
        check(f"prefix of {column}", len(numbers) > 2 and numpy.allclose(
            numpy.array(numbers) * size, ticks, rtol=1e-6, atol=1e-9 * size),
            f"{prefix}{unit} {list(panels)}")
    _, legend = drawings.panels_of(figures["contact"])
    check("prefix of the gap", "obstacle, $g$ = 500 µm" in legend.values(), str(legend))
    _, legend = drawings.panels_of(figures["probes"])
    check("prefix of places", {"probe 1: $x$ = 250 mm", "probe 2: $x$ = 1 m"} <= set(
        legend.values()), str(legend))


def check_places():
    """Two runs whose first probe is at different places, and whose second is at the same one."""
    import plot_probes
    runs = [argparse.Namespace(title=title, probes=(
        [f"probe 1: x = {x}", "probe 2: x = 1"], {"time": [0, 1], **{
            f"temperature_{i}": [0, i] for i in (1, 2)}})) for title, x in (("one", 0.25), ("two", 0.5))]
    labels = [handle.get_label() for handle in plot_probes.handles_of(runs, plot_probes.histories_of(runs))]
    check("places of probes", labels == ["probe 1: $x$ = 0.25 (one)", "probe 2: $x$ = 1",
                                         "probe 1: $x$ = 0.5 (two)", "one", "two"], str(labels))


def check_files(plot):
    """Which pictures there are, and that each shows something."""
    usual = ["figure", "contact", "energy"]
    for name, expected, *arguments in (
            ("error-controlled", [*usual, "probes", "steps"], "controlled"),
            ("killed", usual, "killed"),
            ("heat", ["figure", "energy", "steps"], "heat"),
            ("decay", ["decay"], "killed", "heat", "--figure", "decay")):
        figures = drawings.figures_of(plot, *arguments)
        check(f"pictures: {name}", sorted(figures) == sorted(expected), str(list(figures)))
    plot = drawings.load("plot")
    told = io.StringIO()
    before, sys.argv = sys.argv, ["plot", "killed", "heat", "--figure", "decay", "--dpi", "20"]
    with contextlib.redirect_stdout(told):
        plot.main()
    sys.argv = before
    check("several runs leave the pictures of the first one", told.getvalue() ==
          "wrote killed/decay-with-heat.png\n", told.getvalue())
    sizes = {}
    for name in ("40.png", "80.png", "one.svg", "one.pdf"):
        dpi = name.partition(".")[0] if name.endswith("png") else "40"
        before, sys.argv = sys.argv, ["plot", "heat", "--figure", "energy",
                                      "--output", name, "--dpi", dpi]
        with contextlib.redirect_stdout(io.StringIO()):
            plot.main()
        sys.argv = before
        data = Path(name).read_bytes()
        check(f"written: {name}", len(data) > 3000)
        sizes[name] = struct.unpack(">2I", data[16:24])
    check("dots per inch", sizes["80.png"] == tuple(
        2 * n for n in sizes["40.png"]), str(sizes))


REPORT = {  # key of summary.json: its words and cells
    "first_contact_time": (0.25, ["first contact", "0.25", "0.0013", "", "0.26", ""]),
    "contact_begins": (3, ["number of contacts", "3", "", "", "", ""]),
    "contact_duration": (0.125, ["time in contact", "0.125", "", "", "", ""]),
    "max_contact_force": (12345.678, ["largest contact force", "12.3457", "0.12", "1.2", "", "kN"]),
    "max_penetration": (2.5e-5, ["largest penetration", "25", "", "", "", "µm"]),
    "contact_impulse": (None, None),
    "restitution": (0.5, ["coefficient of restitution", "0.5", "", "", "", ""]),
    "final_displacement_end": (0.0015, ["final displacement of the end", "1.5", "", "", "1.4", "mm"]),
    "final_contact_force": (0., ["final contact force", "0", "", "", "7", "N"]),
    "final_temperature_end": (80., ["final temperature of the end", "80", "", "", "79", "°C"]),
    "final_energy": (-2e-3, ["final energy (no heat content)", "-2", "", "", "", "mJ"])}


def check_report():
    """The page of a run whose summary is made by hand: each result with its bars, forecast
    and unit, each warning, a picture each, all entries; without summary none."""
    shutil.copytree("controlled", "told")
    summary = json.loads(Path("told/summary.json").read_text())
    summary.update({key: value for key, (value, _) in REPORT.items()})
    summary.update({"title": "a < b", "warnings": ["one & two", "three"],
                    "units": {"max_contact_force": "N", "max_penetration": "m", "final_energy": "J",
                              "final_displacement_end": "m", "final_contact_force": "N",
                              "final_temperature_end": "°C"},
                    "first_contact_time_time_error": 0.00125, "max_contact_force_time_error": 123.4,
                    "max_contact_force_space_error": 1234., "first_contact_time_space_error": None,
                    "predicted_first_contact_time": 0.26, "predicted_displacement_end": 0.0014,
                    "predicted_contact_force": 7., "predicted_temperature_end": 79.})
    Path("told/summary.json").write_text(json.dumps(summary))
    plot, printed = drawings.load("plot"), io.StringIO()
    before, sys.argv = sys.argv, ["plot", "--report", "told"]
    with contextlib.redirect_stdout(printed):
        plot.main()
    sys.argv = before
    page = Path("told/report.html").read_text(encoding="utf-8")
    rows = [[html.unescape(cell) for cell in re.findall("<t[dh]>(.*?)</t[dh]>", row)]
            for row in re.findall("<tr>(.*?)</tr>", page)]
    check("report: results", rows == [
        ["", "value", "± by the steps", "± by the mesh", "predicted", "unit"],
        *(cells for _, cells in REPORT.values() if cells)], str(rows))
    check("report: warnings", re.findall('<p class="warning">(.*?)</p>', page) == [
        "one &amp; two", "three"])
    check("report: title", re.findall("<(?:title|h1)>(.*?)<", page) == ["a &lt; b"] * 2)
    check("report: pictures", re.findall('<img alt="(.*?)" src="data:image/png;base64,iVBOR', page) == [
        "figure", "contact", "energy", "steps", "probes"])
    entries = html.unescape(page.partition("used.prm</summary><pre>")[2].partition("</pre>")[0])
    check("report: entries", {"Dimension = 1", "Mesh/Cells = 4", "Time/Scheme = sdirk4",
                              "Contact/Gap = 0.1"} <= set(entries.splitlines()), entries)
    check("report: the scene", "  body      rod of length 1, 4 cells of degree 4" in
          html.unescape(page.partition("<pre>")[2].partition("</pre>")[0]).splitlines())
    check("report: where", printed.getvalue() == "wrote told/report.html\n", printed.getvalue())
    Path("told/summary.json").unlink()
    check_refused(plot, "a report of a run that goes on", ["a report needs a run that has ended"],
                  "--report", "told")


def check_refusals(plot):
    header = "".join(Path("killed/contact.csv").read_text().splitlines(
        keepends=True)[:3])
    n = header.splitlines()[-1].count(",") - 1
    for name, text, words in (
            ("empty", "", ["empty", "again"]), ("headed", header, ["no rows", "wait"]),
            ("other", "a,b\n1\n", ["no column"]),
            ("damaged", header + "0,x" + ",0" * n + "\n", ["contact.csv:4", "'x'"])):
        Path(name).mkdir()
        Path(name, "contact.csv").write_text(text)
        check_refused(plot, name, words, name)
    check_refused(plot, "no directory", ["nowhere", "give the directory"], "nowhere")
    check_refused(plot, "picture not of this scene", ["steps", "steps.csv"],
                  "killed", "--figure", "steps")
    check_refused(plot, "format", [".bmp", ".svg"], "killed", "--output", "x.bmp")


def main():
    drawings.run("controlled", "paper/experiment-1.prm", "Time/End time=0.5",
                 "Mesh/Cells=4", "Mesh/Degree=4", "Time/Scheme=sdirk4",
                 "Time/Start=consistent", "Time/Step size=automatic",
                 "Output/Fields interval=0", "Output/Probes=0.25; 1")
    drawings.run("killed", "paper/experiment-1.prm", "Time/End time=0.5",
                 "Mesh/Cells=10", "Output/Fields interval=0")
    Path("killed/summary.json").unlink()
    path = Path("killed/contact.csv")
    path.write_bytes(path.read_bytes()[:-137])  # within a row
    drawings.run("heat", "verification/heat-series.prm", "Time/End time=0.5",
                 "Time/Tolerance=1e-4", "Output/Fields interval=0")
    drawings.run("between", "examples/two-stops.prm", "Time/End time=4", "Contact/Rear gap=0.07",
                 "Output/Fields interval=0")
    drawings.run("held", "paper/experiment-1.prm", "Time/End time=0.5", "Contact/Gap=0",
                 "Contact/Condition=rigid", "Time/Scheme=sdirk4", "Time/Start=consistent",
                 "Time/Step size=automatic", "Initial values/Temperature=0.3",
                 "Initial values/Displacement=0", "Initial values/Velocity=0", "Mesh/Cells=4",
                 "Output/Fields interval=0")
    drawings.run("steel", "units/steel-rod.prm", "Time/End time=36 h", "Output/Fields interval=0",
                 "Output/Probes=250 mm; 1 m")
    for name, gap in (("row", "0.01"), ("wide-row", "0.05")):
        drawings.run(name, "rows/cradle.prm", "Time/End time=1.5", "Output/Fields interval=0",
                     f"Contact/Gap={gap}")
    drawings.run("strip", "examples/strip.prm", "Time/End time=0.4", "Output/Fields interval=0",
                 "Mesh/Cells=8", "Mesh/Cells across=2", "Time/Scheme=sdirk4",
                 "Time/Start=consistent", "Time/Step size=automatic", "Time/Tolerance=1e-3",
                 "Solver/Linear solver=iterative", "Contact/Damping=0.5")
    plot = drawings.load("plot")
    check_figures(plot)
    check_prefixes(plot)
    check_other_tables(plot)
    check_end_time(plot)
    check_strip(plot)
    check_two_obstacles(plot)
    check_rounding(plot)
    check_row(plot)
    check_places()
    check_files(plot)
    check_report()
    check_refusals(plot)


drawings.run_in_scratch(main)
