# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts/plot has drawn, as data: the tests of pictures share this."""
import contextlib
import csv
import importlib.util
import io
import os
import sys
import tempfile
from importlib.machinery import SourceFileLoader
from pathlib import Path

import numpy
from matplotlib.colors import to_hex
from matplotlib.lines import Line2D

SOURCE = Path(sys.argv[2]).resolve()
sys.path.append(str(SOURCE / "tests/app"))
import program  # noqa: E402

_failed = []


def check(name, good, message=""):
    if not good:
        _failed.append(name)
    print(f"{'passed' if good else 'FAILED'}: {name}  {message}".rstrip())


def finish():
    sys.exit(1 if _failed else 0)


def run_in_scratch(main):
    """Calls it in a directory of its own; ends with the status of all checks."""
    with tempfile.TemporaryDirectory() as scratch:
        os.chdir(scratch)
        main()
        os.chdir("/")
    finish()


def run(directory, prm, *settings):
    """A run of the program; prm within prm/."""
    words = [word for entry in settings for word in ("--set", entry)]
    status, _, message = program.run("--quiet", "--output", directory, *words,
                                     SOURCE / "prm" / prm)
    if status != 0:
        raise RuntimeError(message)


def table(path):
    """Columns of whole rows by name; numbers where all of a column are."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if line[0] != "#"))
    whole = [row for row in rows[1:] if len(row) == len(rows[0])]
    columns = dict(zip(rows[0], map(list, zip(*whole))))
    for name, words in columns.items():
        with contextlib.suppress(ValueError):
            columns[name] = numpy.array([float(word) for word in words])
    return columns


def load(name):
    """A program of the scripts as a module, whose parts can be called."""
    sys.dont_write_bytecode = True
    scripts = SOURCE / "scripts"
    if str(scripts) not in sys.path:
        sys.path.insert(0, str(scripts))
    loader = SourceFileLoader(f"script_{name}", str(scripts / name))
    module = importlib.util.module_from_spec(
        importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


def figures_of(plot, *arguments):
    """Figures by name that a command line of scripts/plot makes; not saved."""
    figures = {}
    plot.write = lambda figure, options, name: figures.update({name: figure})
    before, sys.argv = sys.argv, ["scripts/plot", *map(str, arguments)]
    try:
        plot.main()
    finally:
        sys.argv = before
    return figures


def check_refused(plot, what, words, *arguments):
    """Exit status 2 and one line with these words."""
    message, status = io.StringIO(), 0
    with contextlib.redirect_stderr(message):
        try:
            figures_of(plot, *arguments)
        except SystemExit as end:
            status = end.code
    text = message.getvalue()
    check(f"refused: {what}", status == 2 and text.count("\n") == 1 and
          all(word in text for word in words), text.strip())


def looks_of(artist):
    """What tells a curve from others, in a panel and in the legend."""
    if not isinstance(artist, Line2D):
        return to_hex(artist.get_facecolor())
    # matplotlib shows no pattern of dashes in public
    return to_hex(artist.get_color()), str(artist._unscaled_dash_pattern)


def panels_of(figure):
    """Panels, and the legend: texts by looks."""
    legends = [axes.get_legend() for axes in figure.axes if axes.get_legend()]
    # matplotlib has the first name from 3.7, the second up to 3.8
    entries = {looks_of(handle): text.get_text() for legend in legends
               for text, handle in zip(legend.texts, getattr(
                   legend, "legend_handles", None) or legend.legendHandles)}
    return [axes for axes in figure.axes if axes.axison], entries


def same(line, x, y, rounding=0.):
    """Whether a line has these points: all of them, in their order."""
    return all(len(found) == len(wanted) and numpy.allclose(
        found, wanted, rtol=1e-12, atol=rounding, equal_nan=True)
        for found, wanted in zip((line.get_xdata(), line.get_ydata()), (x, y)))
