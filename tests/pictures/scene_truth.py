# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the files of a run say of its scene in ParaView, and what a record of the
scene (scene_record.py) shows otherwise; for check_scene.py."""
import copy
import csv
import math
import re
import xml.etree.ElementTree as xml

import meshio
import numpy


def rows_of(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if line[0] != "#"))


class Truth:
    """What contact.csv, events.csv, used.prm and the snapshots say.

    gaps: of an obstacle with a shape, smallest and largest
    motion: these two by the time, of one that moves
    """

    def __init__(self, directory, gaps=None, motion=None):
        self.rows = {float(row["time"]): row
                     for row in rows_of(directory / "contact.csv")}
        events = directory / "events.csv"
        begins = [float(row["time"]) for row in rows_of(events) if row["kind"]
                  == "begin"] if events.exists() else []
        entries = xml.parse(directory / "fields.pvd").findall(".//DataSet")
        self.snapshots = {float(entry.get("timestep")): meshio.read(
            directory / entry.get("file")) for entry in entries}
        self.times = list(self.snapshots)
        self.moves = "displacement" in self.field_names()
        gap = re.search(r"set Gap += (\S+)", (directory / "used.prm").read_text())
        self.has_shape = bool(gaps) or (directory / "obstacle.pvd").exists()
        self.n_moved, self.has_motion = self.moves + self.has_shape, bool(motion)
        self.gaps = gaps or motion and motion(0.) or (
            float(gap[1]) if self.moves else math.nan,) * 2
        self.motion = motion or (lambda time: self.gaps)
        column = "contact_force" if self.moves and any(
            float(row["contact_force"]) for row in self.rows.values()) else None
        peak = max(self.rows, key=lambda t: float(self.rows[t][column])) \
            if column else self.times[0]
        self.marks = {"peak": self.nearest(peak), "first": self.times[0],
                      "last": self.times[-1]}
        if begins:
            self.marks["first-contact"] = self.nearest(begins[0])

    def nearest(self, time):
        return min(self.times, key=lambda t: abs(t - time))

    def field_names(self):
        return list(next(iter(self.snapshots.values())).point_data)

    def values(self, field):
        """Axial values of all snapshots."""
        return numpy.concatenate([
            mesh.point_data[field].reshape(len(mesh.points), -1)[:, 0]
            for mesh in self.snapshots.values()])

    def end(self, time):
        """Smallest and largest u of the end; contact.csv has one between."""
        mesh = self.snapshots[time]
        u = mesh.point_data["displacement"][abs(mesh.points[:, 0] - 1) < 1e-6, 0]
        u_csv = float(self.rows[time]["displacement_end"])
        return (u_csv, u_csv) if numpy.ptp(u) < 1e-6 else (u.min(), u.max())

    def thickness(self, scale):
        """Of the obstacle: as far as the end comes, and a bit."""
        nearest = min(self.motion(time)[0] for time in self.times)
        return max(0, scale * (max(self.end(time)[1] for time in self.times) - nearest)) + 0.03

    def is_suitable(self, scale):
        """No farther than a third, no cell shorter than a quarter."""
        for mesh in self.snapshots.values():
            u, x = mesh.point_data["displacement"][:, 0], mesh.points[:, 0]
            places = numpy.unique(numpy.round(x, 6))
            means = [u[abs(x - place) < 2e-6].mean() for place in places]
            stretches = 1 + scale * numpy.diff(means) / numpy.diff(places)
            if scale * abs(u).max() > 0.33 or stretches.min() < 0.25:
                return False
        return True


def faults_of_pictures(record, truth, scale, n_frames):
    faults = []
    spacing = (truth.times[-1] - truth.times[0]) / (len(truth.times) - 1)
    frames = {name: picture[0] for name, picture in record["pictures"].items()
              if name.startswith("frame")}
    stride = math.ceil(len(truth.times) / n_frames)
    times = {f"frame-{i:04d}": time for i, time in
             enumerate(truth.times[::stride])}
    if frames != times or len(times) > n_frames:
        faults.append(f"frames {frames}")
    marks = {name: picture[0] for name, picture in record["pictures"].items()
             if name not in frames}
    if marks != truth.marks:
        faults.append(f"pictures {marks}, not {truth.marks}")
    for name, (time, texts, (_, right), obstacle) in record["pictures"].items():
        shown = re.fullmatch(r"t = (\d+\.\d{2,})", texts[0])
        if not shown or abs(float(shown[1]) - time) > 0.1 * spacing:
            faults.append(f"{name}: {texts[0]}, not {time}")
        if not truth.moves:
            continue
        largest = max(float(mesh.points[:, 0].max())
                      for mesh in [truth.snapshots[truth.nearest(time)]])
        expected = largest + scale * truth.end(truth.nearest(time))[1]
        if abs(right - expected) > 1e-6:
            faults.append(f"{name}: end at {right}, not {expected}")
        face, foot = (1 + scale * gap for gap in truth.motion(time))
        if not numpy.allclose(obstacle, [face, foot + truth.thickness(scale)], rtol=0, atol=2e-6):
            faults.append(f"{name}: obstacle at {obstacle}, not from {face}")
    return faults


def faults_of_record(record, truth, field, n_frames):
    texts = next(iter(record["pictures"].values()))[1]
    label = re.fullmatch(r"displacement \u00d7 (\S+)", texts[-1])
    if bool(label) != truth.moves:
        return [f"texts {texts}"]
    scale = float(label[1]) if label else 0
    faults = faults_of_pictures(record, truth, scale, n_frames)
    if any(picture[1][1:] != texts[1:] for picture in
           record["pictures"].values()):
        faults.append("other factors")
    values = truth.values(field)
    if not numpy.allclose(record["range"], [values.min(), values.max()],
                          rtol=1e-6):
        faults.append(f"range {record['range']}")
    if [record["title"], record["table"], record["coloured"][:2]] != [
            field, field, ["POINTS", field]] or record["coloured"][2:] not in (
                [], ["X"], ["0"]):
        faults.append(f"coloured {record['coloured']}, {record['title']}")
    if record["vectors"] != [["POINTS", "displacement"]] * truth.n_moved:
        faults.append(f"moved by {record['vectors']}")
    boxes = [x for box in record["boxes"] + record["shapes"] for x in box]
    face, foot = (1 + scale * gap for gap in truth.gaps)
    plate = [face, foot + truth.thickness(scale)] if truth.moves else []
    # a box that moves: with each picture; a shape is at its first place here
    n = 2 if truth.has_motion and not truth.has_shape else len(boxes)
    if len(boxes) != 2 + len(plate) or len(record["shapes"]) != truth.has_shape \
            or not numpy.allclose(boxes[:n], ([-0.03, 0] + plate)[:n], atol=2e-6):
        faults.append(f"obstacle {boxes}, not {plate}")
    return faults


def falsified(record):
    """Copies with one number or name changed."""
    places = [("pictures", name, i) for name in record["pictures"] for i in
              range(2)] + [(key,) for key in record if key != "pictures"]
    if record["vectors"]:
        places += [("pictures", name, 2) for name, picture in
                   record["pictures"].items() if picture[2][1] != 1]
        places += [("pictures", name, 3) for name in record["pictures"]]

    def other(value):
        if isinstance(value, list):
            return [other(part) for part in value]
        if isinstance(value, str):
            return re.sub(r"\d", lambda m: str((int(m[0]) + 1) % 10), value) \
                if re.search(r"\d", value) else value + "?"
        return 2 * value + 0.01

    for *path, last in places:
        copied = copy.deepcopy(record)
        part = copied
        for key in path:
            part = part[key]
        if part[last]:
            part[last] = other(part[last])
            yield f"{path} {last}", copied
        elif last == 0:
            part[last] = 0.01
            yield f"{path} {last}", copied
