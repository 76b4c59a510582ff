"""A run on one page: part of scripts/plot, see there."""

import base64
import html
import io
import json

from plot_common import fail, prefix_of, raised
from plot_run import entries_of

# key of summary.json, words, key of what was predicted for the end
RESULTS = [("first_contact_time", "first contact", "predicted_first_contact_time"),
           ("contact_begins", "number of contacts", None),
           ("contact_duration", "time in contact", None),
           ("max_contact_force", "largest contact force", None),
           ("max_penetration", "largest penetration", None),
           ("contact_impulse", "contact impulse", None),
           ("restitution", "coefficient of restitution", None),
           ("final_displacement_end", "final displacement of the end",
            "predicted_displacement_end"),
           ("final_contact_force", "final contact force", "predicted_contact_force"),
           ("final_temperature_end", "final temperature of the end",
            "predicted_temperature_end"),
           ("final_energy", "final energy (no heat content)", None)]
STYLE = """body { font: 15px/1.5 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; }
table { border-collapse: collapse; } td, th { border: 1px solid #ccc; padding: .2em .6em; text-align: left; }
img { max-width: 100%; } pre { background: #f3f3f3; padding: .6em; white-space: pre-wrap; }
.warning { border-left: 4px solid #d55e00; padding-left: .8em; }"""


def number(value, power, digits=6):
    """As text, over this power of ten."""
    return "" if value is None else f"{value / 10.**power:.{digits}g}" if isinstance(
        value, float) else str(value)


def results_of(summary):
    """The key results as a table: value, bars, what was predicted, unit."""
    has_bars = any(f"{key}_time_error" in summary for key, _, _ in RESULTS)
    names = ["", "value", *["± by the steps", "± by the mesh"] * has_bars, "predicted", "unit"]
    rows = ["".join(f"<th>{name}</th>" for name in names)]
    for key, words, predicted in RESULTS:
        if summary.get(key) is None:
            continue
        unit = (summary.get("units") or {}).get(key, "")
        prefix, power = prefix_of(unit, [summary[key]])
        bars = [number(summary.get(f"{key}_{kind}_error"), power, 2) for kind in ("time", "space")]
        cells = [words, number(summary[key], power), *bars * has_bars,
                 number(summary.get(predicted), power), prefix + raised(unit)]
        rows.append("".join(f"<td>{html.escape(cell)}</td>" for cell in cells))
    return "<table>" + "".join(f"<tr>{row}</tr>" for row in rows) + "</table>"


def scene_of(directory):
    """What the screen showed of the scene, before the steps."""
    try:
        lines = (directory / "log.txt").read_text(encoding="utf-8").splitlines()
    except OSError:
        return ""
    return "\n".join(line for line in lines[2:] if line[:2] == "  " and line[2:3].strip()
                     and line[2:].split()[0] in (
                         "units", "body", "row", "unknowns", "terms", "model", "heat", "fixed",
                         "contact", "gap", "scheme", "time", "loads", "scales")
                     and " times, first at " not in line and "set-up" not in line)


def image_of(figure, name):
    data = io.BytesIO()
    figure.savefig(data, format="png", dpi=110)
    text = base64.b64encode(data.getvalue()).decode()
    return f'<h2>{"Histories" if name == "figure" else name.capitalize()}</h2><img alt="{name}" src="data:image/png;base64,{text}">'


def report_of(directory, pictures):
    """The page.

    pictures: (name, figure) of what can be drawn
    """
    path = directory / "summary.json"
    try:
        summary = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        fail(path, error, "a report needs a run that has ended")
    title = html.escape(summary["title"] or directory.resolve().name)
    warnings = "".join(f'<p class="warning">{html.escape(text)}</p>'
                       for text in summary["warnings"]) or "<p>none</p>"
    entries = "\n".join(f"{name} = {value}" for name, value in entries_of(directory).items())
    return "\n".join([
        f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{title}</title>',
        f"<style>{STYLE}</style></head><body><h1>{title}</h1>",
        f"<p>{html.escape(summary['status'])}; thermocontact {summary['version']}, "
        f"{summary['scheme']}, {summary['dofs']} unknowns, {summary['steps']} steps "
        f"({summary['rejected_steps']} rejected), {summary['wall_seconds']:.3g} s</p>",
        f"<h2>Scene</h2><pre>{html.escape(scene_of(directory))}</pre>",
        "<h2>Key results</h2>", results_of(summary), "<h2>Warnings</h2>", warnings,
        *(image_of(figure, name) for name, figure in pictures),
        f"<h2>Entries</h2><details><summary>used.prm</summary><pre>{html.escape(entries)}</pre>"
        "</details></body></html>", ""])
