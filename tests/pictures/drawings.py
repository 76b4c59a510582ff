# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts/plot has drawn, as data: the tests of its curves share this."""
import contextlib
import importlib.util
import io
import re
import sys
from importlib.machinery import SourceFileLoader

import numpy
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex
from matplotlib.lines import Line2D


def load(scripts, name):
    """A program of the scripts as a module, whose parts can be called."""
    sys.dont_write_bytecode = True
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


def refusal_of(plot, *arguments):
    """Exit status and message of a command line."""
    message = io.StringIO()
    with contextlib.redirect_stderr(message):
        try:
            figures_of(plot, *arguments)
        except SystemExit as end:
            return end.code, message.getvalue()
    return 0, message.getvalue()


def colour_of(artist):
    return to_hex(artist.get_color() if isinstance(artist, Line2D) else
                  artist.get_facecolor())


def dashes_of(line):
    """In units of the line's width. matplotlib shows no pattern in public."""
    offset, pattern = line._unscaled_dash_pattern
    return (line.get_linestyle() if line.get_linestyle() in ("None", "-")
            else "dashed", offset, tuple(pattern or ()))


def looks_of(artist):
    """What tells a curve from others, in a panel or in the legend."""
    if not isinstance(artist, Line2D):
        return colour_of(artist), "patch"
    return colour_of(artist), dashes_of(artist)


def parts_of(figure):
    """Panels, and (label, handle) of the entries of the one legend."""
    panels = [axes for axes in figure.axes if axes.axison]
    legends = [axes.get_legend() for axes in figure.axes if axes.get_legend()]
    assert len(legends) <= 1 and not figure.legends
    # matplotlib has the first name from 3.7, the second up to 3.8
    return panels, [(text.get_text(), handle) for legend in legends for
                    text, handle in zip(legend.texts, legend.legend_handles
                                        if hasattr(legend, "legend_handles")
                                        else legend.legendHandles)]


def same(curve, expected):
    """Whether a line has these points: all of them, in their order."""
    return all(
        len(found) == len(wanted) and
        numpy.allclose(found, wanted, rtol=1e-12, atol=0, equal_nan=True)
        for found, wanted in zip((curve.get_xdata(), curve.get_ydata()),
                                 map(numpy.asarray, expected)))


def spans_of(axes):
    """(begin, end, top, colour) of what is shaded, downwards, then by time."""
    spans = []
    for patch in axes.patches: # polygons, or rectangles from matplotlib 3.9
        x, y = numpy.transpose(patch.get_patch_transform().transform(
            patch.get_path().vertices))
        spans.append((min(x), max(x), max(y), to_hex(patch.get_facecolor())))
    return sorted(spans, key=lambda span: (-span[2], span[0]))


def unknown_artists(axes):
    """Kinds of artists that no check looks at."""
    return [str(artist) for artist in
            [*axes.collections, *axes.images, *axes.tables, *axes.artists,
             *axes.child_axes]]


def faults_of_range(axes):
    """Whether the panel shows all of its curves."""
    faults = []
    for name, limits, data in (
            ("times", axes.get_xlim(), [line.get_xdata() for line in axes.lines
                                        if len(line.get_xdata()) > 2]),
            ("values", axes.get_ylim(), [line.get_ydata() for line in axes.lines
                                         if len(line.get_xdata()) > 2])):
        data = numpy.concatenate([*map(numpy.asarray, data), []])
        data = data[numpy.isfinite(data)]
        if len(data) and not limits[0] <= data.min() <= data.max() <= limits[1]:
            faults.append(f"{axes.get_ylabel()}: {name} outside {limits}")
    return faults


def texts_outside(figure):
    """Texts that the picture cuts off, at the resolution of the gallery."""
    figure.set_dpi(95)
    renderer = FigureCanvasAgg(figure).get_renderer()
    for _ in range(2):  # as savefig does: texts move once their sizes are known
        figure.draw(renderer)
    texts = [*figure.texts, *(text for axes in figure.axes for text in [
        axes.title, axes.xaxis.label, axes.yaxis.label, *axes.texts,
        *(axes.get_legend().texts if axes.get_legend() else [])])]
    boxes = [(text.get_text(), text.get_window_extent(renderer))
             for text in texts if text.get_text()]
    return [f"{text}: {box} of {figure.bbox.size}" for text, box in boxes
            if min(box.x0, box.y0) < 0 or
            box.x1 > figure.bbox.x1 or box.y1 > figure.bbox.y1]


def swapped_texts(figure):
    """Each pair of different labels changed over for as long as it is given."""
    panels, _ = parts_of(figure)
    legend = [t for axes in figure.axes if axes.get_legend()
              for t in axes.get_legend().texts]
    labels = [axes.yaxis.label for axes in panels if axes.get_ylabel()]
    titles = [axes.title for axes in panels if axes.get_title()]
    for texts in (legend, labels, titles):
        for i, one in enumerate(texts):
            for two in texts[:i]:
                before = one.get_text(), two.get_text()
                if before[0] == before[1]:
                    continue
                one.set_text(before[1]), two.set_text(before[0])
                yield f"labels {before[0]!r} and {before[1]!r} swapped"
                one.set_text(before[0]), two.set_text(before[1])
    for text in [*legend, *labels, *titles, *figure.texts,
                 *(t for axes in figure.axes for t in axes.texts)]:
        before = text.get_text()
        changed = re.sub(r"\d", lambda m: str((int(m[0]) + 1) % 10), before)
        if changed != before:
            text.set_text(changed)
            yield f"numbers of {before!r} changed"
            text.set_text(before)


def falsified(figure, others):
    """The figure with one fault after the other, and what it is.

    others: for a line, the curves (x, y) that it must not be taken for.
    """
    yield from swapped_texts(figure)
    for axes in parts_of(figure)[0]:
        where = axes.get_ylabel() or axes.get_title() or axes.get_xlabel()
        for line in list(axes.lines):
            before = line.get_data()
            for x, y in list(others(line)):
                line.set_data(x, y)
                yield f"{where}: another column drawn"
            line.set_data(before)
            for factor in (-1, 2):
                if any(before[1]):
                    line.set_data(before[0], factor * numpy.array(before[1]))
                    yield f"{where}: values times {factor}"
            line.set_data(before)
        extra = axes.plot([0.3, 0.4, 0.5], [1, 2, 3], color="black")[0]
        yield f"{where}: a line without a check"
        extra.remove()
        for artist in (axes.text(0.5, 0.5, "0.7"), axes.scatter([0.5], [0.5]),
                       axes.axvspan(0.3, 0.4)):
            yield f"{where}: {artist} without a check"
            artist.remove()
        scale = axes.get_yscale()
        axes.set_yscale("linear" if scale == "log" else "log")
        yield f"{where}: another scale"
        axes.set_yscale(scale)
