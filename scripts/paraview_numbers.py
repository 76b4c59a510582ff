"""The numbers that the pictures of scripts/paraview show; knows no ParaView."""

import itertools
import math
import sys

from plot_common import fail

try:
    import numpy
except ImportError as error:
    fail(sys.executable, error, "install Debian's python3-numpy")

USUAL = ["temperature", "stress", "displacement", "velocity"]
# marks that are the begin and the end of a contact, by the picture that shows it
CONTACTS = {"first-contact": "first-contact", "peak": "contact-of-peak"}


def marks_of(run):
    """Names of pictures and the times that they show, of a run (plot_run); of the first contact,
    and of the contact with the largest force, its begin and end."""
    forces = [abs(force) if math.isfinite(force) else 0  # a rear obstacle pulls
              for force in run.data["contact_force"]]
    motion = [abs(u) if math.isfinite(u) else 0
              for u in run.data["displacement_end"]]
    peak = forces if max(forces) > 0 else motion
    marks = {"peak": run.data["time"][peak.index(max(peak))]}
    if run.contacts:
        marks["first-contact"] = list(run.contacts[0])
    marks.update({"contact-of-peak": [begin, end] for begin, end in run.contacts
                  if begin <= marks["peak"] <= end and peak is forces})
    return marks


def axial(values):
    """The first component, which is along the rod."""
    return values[:, 0] if values.ndim > 1 else values


def field_of(colour, names):
    """The one that colours; None if it is not there."""
    if colour == "automatic":
        colour = next((name for name in USUAL if name in names), None)
    return colour if colour in names else None


class Ranges:
    """What is to be known of all snapshots before one is drawn."""

    def __init__(self):
        self.length = 1.  # of the body
        self.motion, self.reach, self.compression = 0., 0., 0.
        self.low, self.high = math.inf, -math.inf
        # least and largest y and z, and of the displacement along them
        self.sides, self.sideways = numpy.zeros((2, 2)), numpy.zeros((2, 2))

    def add(self, points, values, displacement):
        """
        values: of the field that colours
        displacement: at the points, or None
        """
        values = axial(values)
        self.low = min(self.low, values.min())
        self.high = max(self.high, values.max())
        x = points[:, 0]
        self.length = length = x.max()
        self.sides = numpy.array([points[:, 1:3].min(0), points[:, 1:3].max(0)])
        if displacement is None:
            return
        u = axial(displacement)
        if displacement.ndim > 1:
            across = displacement[:, 1:3]
            self.sideways = numpy.array([
                numpy.minimum(self.sideways[0], across.min(0)),
                numpy.maximum(self.sideways[1], across.max(0))])
        places, of = numpy.unique(numpy.round(x / length, 6), return_inverse=True)
        places = places * length
        means = numpy.bincount(of, u) / numpy.bincount(of)
        strains = numpy.diff(means) / numpy.diff(places)
        self.motion = max(self.motion, abs(u).max())
        self.reach = max(self.reach, u[x > (1 - 1e-6) * length].max())
        self.compression = max(self.compression, -strains.min())

    def scale(self):
        """A third of the length; lengths shrink to a quarter at most."""
        scale = 0.33 * self.length / self.motion if self.motion > 0 else 1.
        if self.compression > 0:
            scale = min(scale, 0.75 / self.compression)
        power = 10. ** math.floor(math.log10(scale))
        return float(f"{math.floor(scale / power) * power:.1g}")

    def colours(self):
        """Ends of the colour bar, which must differ."""
        return self.low, self.high + 1e-9 * max(1, abs(self.high)) * (
            self.high == self.low)

    def plate(self, scale, gap):
        """Where the obstacle begins and ends, and the picture with it; None for
        the begin if there is none nearby.

        The obstacle is as thick as the end comes.
        """
        begin = self.length + scale * gap if gap is not None else math.inf
        back = self.length + scale * self.reach
        return (begin, max(begin, back) + 0.03 * self.length) if begin <= \
            2 * self.length else (None, back)

    def box_across(self, scale):
        """Least and largest y and z of the moved body at all times, at least of
        the body at rest."""
        return self.sides + scale * self.sideways


def path_of_obstacle(run, times):
    """The gap before a rod at rest at each of these times; empty if it is always the same."""
    return numpy.interp(times, *run.path).tolist() if run.path else []


def nearest(times, time):
    return min(times, key=lambda t: abs(t - time))


def within(times, contact):
    """The times of snapshots within a contact."""
    begin, end = contact
    rounding = 1e-9 * times[-1]  # of the times in the files
    return [time for time in times if begin - rounding <= time <= end + rounding]


def times_of_pictures(times, marks, n_frames):
    """Time of each picture by its name, and times of the animation. The first contact is the first
    snapshot within it, since those before show a gap; without one there is no picture of it. The
    largest force is the nearest snapshot within its contact, if there is one."""
    shown = {name: within(times, marks[mark]) for name, mark in CONTACTS.items() if mark in marks}
    pictures = {"peak": nearest(shown.get("peak") or times, marks["peak"])}
    if shown.get("first-contact"):
        pictures["first-contact"] = shown["first-contact"][0]
    pictures.update(first=times[0], last=times[-1])
    stride = math.ceil(len(times) / max(1, n_frames))
    return pictures, times[::stride] if n_frames else []


def remarks_on(pictures, marks):
    """What is to be said of pictures that are missing, or one snapshot."""
    remarks = []
    if "first-contact" in marks and "first-contact" not in pictures:
        begin, end = marks["first-contact"]
        remarks.append("no first-contact.png: there is no snapshot within the first contact, "
                       f"{begin:g} < t < {end:g}")
    if "contact-of-peak" in marks and not within([pictures["peak"]], marks["contact-of-peak"]):
        begin, end = marks["contact-of-peak"]
        remarks.append(f"peak.png shows t = {pictures['peak']:g}: there is no snapshot within the "
                       f"contact with the largest force, {begin:g} < t < {end:g}")
    names = {time: [name for name in ("first", "first-contact", "peak", "last")
                    if pictures.get(name) == time] for time in pictures.values()}
    remarks += [f"{' and '.join(same)} are one snapshot, t = {time:g}"
                for time, same in sorted(names.items()) if len(same) > 1]
    return [remark + "; a shorter Output/Fields interval makes more" * (
        "contact" in remark) for remark in remarks]


def view_of(low, high, is_oblique):
    """How a box is looked at: unit vectors to the camera and to the right of the picture, and the
    width and the height in which the box is seen. From the side, or obliquely from above.

    low, high: corners of the box
    """
    away = numpy.array([-0.35, 0.45, 1.5] if is_oblique else [0., 0., 1.])
    right = numpy.cross([0., 1., 0.], away)
    away, right = (v / numpy.linalg.norm(v) for v in (away, right))
    corners = numpy.array(list(itertools.product(*zip(low, high))))
    width, height = (numpy.ptp(corners @ v) for v in (right, numpy.cross(away, right)))
    return away, right, width, height


def scale_label(scale):
    return f"displacement \u00d7 {scale:g}"


def time_labels(times, unit=""):
    """By time; two decimals, or as many as tell the times apart."""
    spacing = (times[-1] - times[0]) / max(1, len(times) - 1)
    n = next((n for n in range(2, 16) if all(
        abs(float(f"{t:.{n}f}") - t) <= 0.1 * spacing for t in times)), 16)
    return {t: f"t = {t:.{n}f}{' ' * bool(unit)}{unit}" for t in times}
