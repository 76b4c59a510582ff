"""What the pictures of scripts/plot share: tables, style, errors."""

import csv
import math
import os
import re
import subprocess
import sys
import textwrap
from importlib import invalidate_caches
from importlib.util import find_spec
from pathlib import Path

CONVERT = {"kind": {"begin": 1, "end": 0}.__getitem__,  # the rest: float
           "run": str, "status": str, "reason": str}
# Okabe and Ito: distinct in all kinds of colour vision; dashes for grey prints
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"]
DASHES = ["-", (0, (5, 1.5)), (0, (5, 1.5, 1, 1.5)), (0, (1.5, 1.2))]
STYLE = {"font.family": ["STIXGeneral", "DejaVu Serif"], "font.size": 11,
         "mathtext.fontset": "stix", "axes.formatter.use_mathtext": True,
         "axes.linewidth": 0.7, "lines.linewidth": 1.2, "legend.frameon": False,
         "axes.grid": True, "grid.color": "0.85", "grid.linewidth": 0.5,
         "xtick.direction": "in", "ytick.direction": "in", "pdf.fonttype": 42,
         "agg.path.chunksize": 20000, "svg.hashsalt": "plot"}
PREFIXES = ["p", "n", "µ", "m", "", "k", "M", "G"]  # of SI, from 1e-12 on
METADATA = {".png": {}, ".pdf": {"CreationDate": None}, ".svg": {"Date": None}}


def name_of_call():
    """scripts/plot, or the name under which it is installed."""
    name = os.path.basename(sys.argv[0])
    return name if name.startswith("thermocontact-") else "scripts/" + name


def fail(where, problem, remedy="run the scene again"):
    """End with one line that says what is wrong and what to do."""
    print(f"{name_of_call()}: {where}: {problem}; {remedy}", file=sys.stderr)
    sys.exit(2)


def read_rows(path, columns):
    """Comments, header, and rows with their lines; a row cut off is left out.

    Ends if one of the columns is missing; there may be more.
    """
    try:
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        fail(path, error.strerror, "give the directory of a run or a study")
    lines = text.split("\n")[:-1]  # the last one is empty or not all there yet
    comments = [line[1:].strip() for line in lines if line.startswith("#")]
    lines = [(n, line.strip()) for n, line in enumerate(lines, 1)
             if line.strip() and not line.startswith("#")]
    reader = csv.reader(line for _, line in lines)
    try:
        rows = [(lines[reader.line_num - 1][0], row) for row in reader]
    except csv.Error as error:
        fail(f"{path}:{lines[reader.line_num - 1][0]}", error)
    if not rows:
        fail(path, "it is empty or has no complete header line yet")
    header = rows.pop(0)[1]
    for name in columns:
        if name not in header:
            fail(path, f"there is no column {name}")
    if rows and len(rows[-1][1]) < len(header):
        rows.pop()
    for n, row in rows:
        if len(row) != len(header):
            fail(f"{path}:{n}", f"{len(row)} fields under {len(header)} names")
    return comments, header, rows


def convert(path, header, rows, columns):
    """Numbers by column, and the "line" of each row."""
    table = {"line": [n for n, _ in rows], **{name: [] for name in columns}}
    for name in columns:
        column = header.index(name)
        for n, row in rows:
            try:
                table[name].append(CONVERT.get(name, float)(row[column]))
            except (KeyError, ValueError):
                fail(f"{path}:{n}", f"{name} cannot be '{row[column]:.30}'")
    return table


def read_table(path, columns):
    comments, header, rows = read_rows(path, columns)
    return comments, convert(path, header, rows, columns)


def units_of(comments, header):
    """Units of the columns that have one, by name."""
    line = next((text[6:].strip(" ") for text in comments
                 if text.startswith("units:")), "")
    return {name: unit for name, unit in zip(header, next(csv.reader([line]), ()))
            if unit}


def in_unit(label, unit):
    """A label of an axis with its unit, if there is one: the body then ends at L."""
    return f"{label.replace('(1', '(L')} [{raised(unit)}]" if unit else label


def raised(unit):
    """With its exponents as such."""
    return unit.replace("^2", "²").replace("^3", "³")


def prefix_of(unit, values):
    """The prefix of SI, and its power of ten, with which the largest of these values is
    from 1 to 1000; none for a unit that takes none, as those of times and temperatures."""
    largest = max((abs(value) for value in values if math.isfinite(value)), default=0.)
    if not re.match(r"(m|N|Pa|J|W)(?![\w^])", unit or "") or not 1e-12 <= largest < 1e12:
        return "", 0
    thousands = math.floor(math.log10(largest * (1 + 1e-9)) / 3)
    return PREFIXES[thousands + 4], 3 * thousands


def in_prefix(value, unit):
    """A number with its unit, if it has one, as text."""
    prefix, power = prefix_of(unit, [value])
    return f"{value / 10.**power:g} {prefix}{raised(unit)}" if unit else f"{value:g}"


def label_axis(axis, label, unit, values):
    """Label and ticks of an axis with a linear scale, in the unit that suits the values.

    unit: that of the values, or nothing
    """
    from matplotlib.ticker import ScalarFormatter
    prefix, power = prefix_of(unit, values)
    axis.set_label_text(in_unit(label, prefix + unit if unit else None))
    formatter = axis.get_major_formatter()
    formatter.set_powerlimits((-3, 4))
    if power:
        class Formatter(ScalarFormatter):
            def format_ticks(self, values):
                return super().format_ticks([value / 10.**power for value in values])
        formatter = Formatter(useOffset=False)
        formatter.set_scientific(False)
        axis.set_major_formatter(formatter)


def title_of(comments):
    """The first comment that is neither a version of a program nor the units."""
    version = re.compile(r"(?i)((thermocontact|deal\.?ii|version)\b.*\d|units:)")
    titles = [text for text in comments if text and not version.match(text)]
    return re.sub(r"(?i)^title\s*[:=]\s*", "", titles[0]) if titles else ""


def looks(i):
    """Of the curve with number i."""
    return {"color": COLOURS[i % 6], "linestyle": DASHES[i % 4]}


def plain(text, width):
    """Text in lines of this width, in which matplotlib finds no formula."""
    text = textwrap.fill(text, int(width)).replace("$", r"\$")
    return re.sub("^_", " _", text)  # labels with _ in front are left out


def need_matplotlib():
    """Before anything of it is used: installs it if it is missing, or ends."""
    os.environ["MPLBACKEND"] = "Agg"  # no display
    installer = Path(__file__).resolve().parent / "install_packages"
    is_system = sys.executable == "/usr/bin/python3"
    try:
        if not find_spec("matplotlib") and is_system and installer.exists():
            subprocess.run([installer, "--only", "python3-matplotlib"], check=False)
            invalidate_caches()
        import matplotlib  # noqa: F401
    except ImportError as error:
        fail(sys.executable, error, "install Debian's python3-matplotlib"
             if is_system else "run it by /usr/bin/python3")


def new_figure(width, height):
    need_matplotlib()
    import matplotlib
    from matplotlib.figure import Figure
    matplotlib.rcdefaults()
    matplotlib.rcParams.update(STYLE)
    return Figure(figsize=(width, height), layout="constrained")


def save(figure, path, dpi):
    try:
        figure.savefig(path, dpi=dpi, metadata=METADATA[path.suffix.lower()])
    except OSError as error:
        fail(path, error.strerror, "give another --output")
