"""What a run left in its output directory, as scripts/plot draws it."""

import argparse
import json
import math
import re

from plot_common import (convert, fail, read_rows, read_table, title_of,
                         units_of)

COLUMNS = ["time", "displacement_end", "displacement_mid", "velocity_end",
           "stress_end", "gap", "contact_force", "contact_impulse",
           "temperature_end", "temperature_mean", "heat_flux_end", "energy",
           "work", "dissipation", "numerical_dissipation", "in_contact"]
# what residuals do to the energy, with the iterative solver; what damping takes; bodies
OPTIONAL = ["algebraic", "contact_dissipation", "contact_area", "max_pressure"]
ROW = ["time", "gap", "contact_force", "contact_impulse"]
STEPS = ["time", "step_size", "error", "accepted", "reason"]
PROBE = re.compile(r"(temperature|displacement|velocity|stress)_(\d+)$")


def read_contacts(path, data):
    """Times in contact from events.csv, or without events from the rows."""
    end = data["time"][-1]
    changes = list(zip(data["time"], data["in_contact"]))
    if path.exists() and path.stat().st_size > 0:  # empty at first
        events = read_table(path, ["time", "kind"])[1]
        changes = list(zip(events["time"], events["kind"])) or changes
    contacts, begin = [], None if changes[0][1] == 1 else data["time"][0]
    for time, contact in [*changes, (end, False)]:
        if contact == 1 and begin is None:
            begin = time
        elif contact != 1 and begin is not None:
            contacts.append((begin, min(time, end)))
            begin = None
    return [(begin, end) for begin, end in contacts if begin < end]


def read_optional(path, names, end_time):
    """Comments and the rows up to a time, or None without file or rows."""
    if not path.exists() or path.stat().st_size == 0:
        return None
    comments, header, rows = read_rows(path, names(["time"]))
    columns = names(header)
    table = convert(path, header, rows, columns)
    kept = [i for i, time in enumerate(table["time"]) if time <= end_time]
    table = {name: [table[name][i] for i in kept] for name in columns}
    return (comments, table) if kept and len(columns) > 1 else None


def read_data(path, end_time):
    """Comments of contact.csv, time of its last row, and the columns up to the
    end time, with what follows from them."""
    comments, header, rows = read_rows(path, COLUMNS)
    optional = [name for name in OPTIONAL if name in header]
    data = convert(path, header, rows, COLUMNS + optional)
    times = data["time"]
    for before, time, line in zip([-math.inf, *times], times, data["line"]):
        if not before <= time < math.inf:
            fail(f"{path}:{line}", f"time {time:g} after {before:g}")
    if not times:
        fail(path, "it has no rows yet", "wait, or run the scene again")
    count = sum(time <= end_time for time in times)
    if count < 2 or times[0] == times[count - 1]:
        fail(path, "fewer than two times to draw", "wait or raise --end-time")
    data = {name: values[:count] for name, values in data.items()}
    nothing = [0.] * count
    data["defect"] = [
        data["energy"][0] + work + residuals - energy - sum(lost)
        for work, residuals, energy, *lost in zip(
            data["work"], data.get("algebraic", nothing), data["energy"],
            data["dissipation"], data["numerical_dissipation"],
            data.get("contact_dissipation", nothing))]
    for name in OPTIONAL[1:]:
        data.setdefault(name, [math.nan] * count)
    units = units_of(comments, header)
    if "energy" in units:
        units["defect"] = units["energy"]
    return comments, times[-1], data, units


def how_it_ended(directory, time, unit):
    """Nothing if the run is done, else what a label says about it."""
    try:
        summary = json.loads((directory / "summary.json").read_text())
        status = summary["status"]
    except (OSError, ValueError, KeyError, TypeError):
        status = "unfinished"
    return "" if status == "done" else f" ({status}, $t$ = {time:.4g}{' ' * bool(unit)}{unit})"


def rounded(end):
    """A distance of (|u(1)|, g) without what rounding leaves of either."""
    u, g = end
    size = max(u, abs(g))
    return round(g, 11 - math.floor(math.log10(size))) if size > 0 else 0.0


def obstacle_moves(directory):
    """Whether the gap in used.prm depends on t."""
    try:
        text = (directory / "used.prm").read_text(encoding="utf-8")
    except OSError:
        return False
    gap = re.search(r"^\s*set Gap\s*=([^#\n]*)", text, re.MULTILINE)
    return bool(gap and re.search(r"\bt\b", gap[1]))


def entries_of(directory):
    """Section/Entry and value in used.prm, without titles and what is written."""
    try:
        text = (directory / "used.prm").read_text(encoding="utf-8")
    except OSError:
        return {}
    entries, sections = {}, []
    for line in text.splitlines():
        words = re.match(r"\s*(?:subsection (.+)|(end)\s*$|set (.+?)\s*=\s*([^#]*))", line)
        if words and words[1]:
            sections.append(words[1].strip())
        elif words and words[2]:
            sections.pop()
        elif words:
            entries["/".join([*sections, words[3]])] = words[4].strip()
    return {name: value for name, value in entries.items()
            if not re.match("Title|Output/|Study/", name)}


def path_of_obstacle(directory, data):
    """Times and gaps before the end at rest of a rod whose obstacle moves, else None; the
    end of a body does not move as one."""
    if (directory / "contact.pvd").exists() or not obstacle_moves(directory):
        return None
    return data["time"], [u + gap for u, gap in zip(data["displacement_end"], data["gap"])]


def obstacles(data, entries):
    """Where they are, g and -g_2; nan: there is none, or none of two that was met. The gap
    is that to the nearer one of two, which is the one that presses."""
    two = entries.get("Contact/Rear gap", "none") != "none"
    rows = [row for row in zip(data["displacement_end"], data["gap"], data["contact_force"])
            if math.isfinite(row[0] + row[1])]
    # rounding, and bending in 2-D and 3-D, spoil g least where u(1) is smallest
    front = [(abs(u), u + gap) for u, gap, force in rows if force > 0 or not two]
    rear = [(abs(u), u - gap) for u, gap, force in rows if force < 0]
    return [rounded(min(ends)) if ends else math.nan for ends in (front, rear)]


def read_row(directory, end_time):
    """Units and tables of the contacts of a row of bodies, by their names; nothing else."""
    tables = {}
    for path in sorted((directory / "contacts").glob("*.csv")):
        found = read_optional(path, lambda _: ROW, end_time)
        if found:
            tables[path.stem] = found[1]
    return tables


def read_run(directory, end_time):
    path = directory / "contact.csv"
    comments, last_time, data, units = read_data(path, end_time)
    entries = entries_of(directory)
    row = read_row(directory, end_time)
    front, rear = (math.nan, math.nan) if row else obstacles(data, entries)
    return argparse.Namespace(
        directory=directory, data=data, units=units, entries=entries,
        title=title_of(comments) or directory.resolve().name,
        ended=how_it_ended(directory, last_time, units.get("time", "")),
        # times of single contacts of a row are those of their forces
        row=row, contacts=[] if row else read_contacts(directory / "events.csv", data),
        obstacle=front, rear=rear,
        moves=obstacle_moves(directory), path=path_of_obstacle(directory, data),
        steps=read_optional(directory / "steps.csv", lambda _: STEPS, end_time),
        probes=read_optional(
            directory / "probes.csv", lambda header: ["time", *(
                name for name in header if PROBE.match(name))], end_time))
