# SPDX-License-Identifier: LGPL-2.1-or-later
"""Output directories made by hand: every number in them tells where it stands.

Run number r has 6 + r rows at times that are not equidistant. Column k of its
contact.csv holds 1 + 0.37 k + 9 r + 0.001 (k + 2) t in the row of time t: no two
columns, no two runs and no two rows have a number in common. Two columns have
to obey others: gap = g - u(1), and in_contact is 0 or 1.
"""
import csv

TIMES = [0, 0.1, 0.25, 0.6, 1.0, 1.7, 1.8, 2.3, 2.4, 2.9, 3.1, 3.3, 3.5, 3.6,
         3.9, 4.0]
VERSIONS = "# thermocontact 0.1.0, deal.II 9.4.1\n"


def header_of(path):
    """Names of the columns, as the program writes them."""
    with open(path, encoding="utf-8") as file:
        return next(line for line in file if line[0] != "#").strip().split(",")


def read(path):
    """Columns by name; numbers where all of a column are."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if line[0] != "#"))
    columns = dict(zip(rows[0], zip(*rows[1:])))
    for name, words in columns.items():
        try:
            columns[name] = [float(word) for word in words]
        except ValueError:
            pass
    return columns


def write_table(path, title, columns, comments=""):
    path.write_text(f"# {title}\n{VERSIONS}{comments}" + ",".join(columns)
                    + "\n" + "".join(",".join(map(str, row)) + "\n"
                                     for row in zip(*columns.values())))


class Run:
    """A directory and what its pictures have to show of it."""

    def __init__(self, directory, number, headers, title, label=None,
                 contacts=(), status="done", **columns):
        """
        label: of the legend
        contacts: begin and end of each
        status: of summary.json; None: there is no such file
        columns: of contact.csv that are other than usual: all their numbers,
            one for all rows, or None for no number
        """
        self.directory, self.number, self.headers = directory, number, headers
        self.title, self.label = title, label or title
        self.contacts, self.steps, self.probes = list(contacts), None, None
        self.times = TIMES[:6 + number]
        self.places = {}
        directory.mkdir()
        self.contact = {
            name: [round(1 + 0.37 * k + 9 * number + 0.001 * (k + 2) * t, 9)
                   for t in self.times]
            for k, name in enumerate(headers["contact"])}
        self.g = round(self.contact["displacement_end"][0] + 0.004, 9)
        self.contact["time"] = self.times
        self.contact["gap"] = [round(self.g - u, 9) for u in
                               self.contact["displacement_end"]]
        self.contact["in_contact"] = [0 for _ in self.times]
        for name, value in columns.items():
            self.contact[name] = value if isinstance(value, list) else [
                "nan" if value is None else value for _ in self.times]
        if "gap" in columns:
            self.g = None
        self.write_contact()
        if status:
            (directory / "summary.json").write_text(
                f'{{"status": "{status}"}}')
        events = sorted([(begin, "begin") for begin, _ in self.contacts] +
                        [(end, "end") for _, end in self.contacts])
        write_table(directory / "events.csv", title, {
            "time": [time for time, _ in events],
            "kind": [kind for _, kind in events],
            "velocity": [7.5 for _ in events]})

    def write_contact(self):
        write_table(self.directory / "contact.csv", self.title, self.contact)

    def add_steps(self):
        """Attempts of each reason; the rejected ones have numbers of their own."""
        r = self.number
        reasons = ["tolerance", "ok", "contact", "event", "failed", "ok",
                   "tolerance", "output", "contact", "end"]
        accepted = [reason not in ("tolerance", "contact", "failed")
                    for reason in reasons]
        n = len(reasons)
        self.steps = {"time": [round(0.05 + 0.11 * i, 9) for i in range(n)],
                      "step_size": [round(0.01 * (i + 1) + 0.001 * r, 9)
                                    for i in range(n)],
                      "error": [round(0.2 + 0.3 * i + 0.01 * r, 9)
                                for i in range(n)],
                      "accepted": [int(good) for good in accepted],
                      "reason": reasons,
                      "wall_seconds": [5 + i for i in range(n)]}
        assert list(self.steps) == self.headers["steps"]
        write_table(self.directory / "steps.csv", self.title, self.steps)

    def add_probes(self, places):
        fields = [name[:-2] for name in self.headers["probes"]
                  if name.endswith("_1")]
        self.places = {}
        self.probes = {"time": [round(0.99 * t, 9) for t in self.times]}
        for i, place in enumerate(places, 1):
            self.places[i] = place
            for k, field in enumerate(fields):
                self.probes[f"{field}_{i}"] = [
                    round(2 + k + 0.11 * i + 7 * self.number + 0.01 * t, 9)
                    for t in self.times]
        write_table(self.directory / "probes.csv", self.title, self.probes,
                    "".join(f"# probe {i}: {place}\n"
                            for i, place in enumerate(places, 1)))
