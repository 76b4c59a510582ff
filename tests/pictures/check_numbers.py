#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_numbers.py THERMOCONTACT SOURCE_DIRECTORY

Numbers behind the pictures of scripts/paraview, of runs made up by hand: the times
of the pictures, the obstacle, the speed of the animation. Exit status 77,
"skipped", without matplotlib and its PIL.
"""
import math
import os
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

try:
    import drawings
    from drawings import check
    from PIL import Image
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)


def check_marks(numbers):
    """The largest force, of either obstacle; without force the end that is farthest from its place,
    whichever way it went; contact begins where it begins first."""
    nan = math.nan
    for forces, displacements, contacts, expected in (
            ([0, 1, 3, 2], [0, 9, 1, 1], [(0.5, 1), (2, 3)],
             {"peak": 2, "first-contact": [0.5, 1], "contact-of-peak": [2, 3]}),
            ([0, 1, 0, -3], [0, 1, 0, -1], [(0.5, 1.5), (2.5, 3)],
             {"peak": 3, "first-contact": [0.5, 1.5], "contact-of-peak": [2.5, 3]}),
            ([0, 0, 0, 0], [0.1, -0.3, 0.2, 0], [], {"peak": 1}),
            ([nan] * 4, [0.1, -0.3, 0.4, 0], [], {"peak": 2}),
            ([nan] * 4, [nan] * 4, [], {"peak": 0})):
        run = SimpleNamespace(contacts=contacts, data={
            "time": [0, 1, 2, 3], "contact_force": forces,
            "displacement_end": displacements})
        marks = numbers.marks_of(run)
        check(f"marks of {forces}, {displacements}", marks == expected, str(marks))


def check_missing(numbers):
    """Snapshots at 0, 1, 2, 3: the first within the first contact, none if it lies between two; the
    peak at 2.9 is the last one, and of a contact up to 2.95 the one before; where the contact of the
    peak lies between two, its picture shows no contact, which is said."""
    for marks, expected, words in (
            ({"peak": 2.9, "first-contact": [0.4, 0.9]}, {"first": 0, "peak": 3, "last": 3},
             ["no first-contact.png: there is no snapshot within the first contact, 0.4 < t < 0.9; a "
              "shorter", "peak and last are one snapshot, t = 3"]),
            ({"peak": 1.2, "first-contact": [0.4, 1.5]},
             {"first": 0, "first-contact": 1, "peak": 1, "last": 3},
             ["first-contact and peak are one snapshot, t = 1"]),
            ({"peak": 2.9, "contact-of-peak": [1.5, 2.95]}, {"first": 0, "peak": 2, "last": 3}, []),
            ({"peak": 2.4, "contact-of-peak": [2.2, 2.6]}, {"first": 0, "peak": 2, "last": 3},
             ["peak.png shows t = 2: there is no snapshot within the contact with the largest force, "
              "2.2 < t < 2.6; a shorter Output/Fields interval makes more"]),
            ({"peak": 2, "first-contact": [1 + 1e-12, 3]},
             {"first": 0, "first-contact": 1, "peak": 2, "last": 3}, []),
            ({"peak": 2, "first-contact": [1.1, 3]},
             {"first": 0, "first-contact": 2, "peak": 2, "last": 3}, ["first-contact and peak are one"]),
            ({"peak": 2, "first-contact": [0, 1]}, {"first": 0, "first-contact": 0, "peak": 2,
                                                    "last": 3}, ["first and first-contact are one"])):
        pictures = numbers.times_of_pictures([0, 1, 2, 3], marks, 0)[0]
        remarks = numbers.remarks_on(pictures, marks)
        check(f"pictures of {marks}", pictures == expected and len(remarks) == len(words) and
              all(word in remark for word, remark in zip(words, remarks)), f"{pictures} {remarks}")


def check_views(numbers):
    """From the side a box is as wide and high as it is. Obliquely a cube is seen with the sum of
    its edges' projections: of the vector (-0.35, 0.45, 1.5) to the camera, of length l, to the
    right is (1.5, 0, 0.35)/r, and upwards e = (0.1575, r^2, -0.675)/(r l), r^2 = 1.5^2 + 0.35^2."""
    away, right, width, height = numbers.view_of([-1, 0, -2], [3, 0.5, 2], False)
    check("a view from the side", (*away, *right, width, height) == (0, 0, 1, 1, 0, 0, 4, 0.5),
          f"{away} {right} {width} {height}")
    r = math.hypot(1.5, 0.35)
    length = math.hypot(r, 0.45)
    away, right, width, height = numbers.view_of([0] * 3, [2] * 3, True)
    check("an oblique view", abs(width - 2 * 1.85 / r) + abs(
        height - 2 * (0.1575 + r * r + 0.675) / (r * length)) < 1e-12 and
        abs(away[2] - 1.5 / length) + abs(right[0] - 1.5 / r) < 1e-12,
        f"{away} {right} {width} {height}")


def check_plates(numbers):
    """At 1 + scale g, as thick as the end comes, but 0.03; not beyond x = 2."""
    for reach, scale, gap, expected in (
            (0.1, 2, 0.3, (1.6, 1.63)), (0.4, 2, 0.3, (1.6, 1.83)),
            (0.4, 2, 0, (1, 1.83)), (0.1, 2, 0.5, (2, 2.03)),
            (0.1, 2, 0.51, (None, 1.2)), (0.1, 2, None, (None, 1.2))):
        ranges = numbers.Ranges()
        ranges.reach = reach
        begin, end = ranges.plate(scale, gap)
        good = (begin is None) == (expected[0] is None) and all(
            value is None or abs(value - wanted) < 1e-12
            for value, wanted in zip((begin, end), expected))
        check(f"plate at {gap}", good, f"{begin}, {end}")


def check_gaps(script):
    """Settings have the gap of the scene, also 0."""
    for gap in (0.1, 0):
        drawings.run(f"gap-{gap}", "paper/experiment-1.prm", f"Contact/Gap={gap}",
                     "Time/End time=0.002", "Mesh/Cells=2",
                     "Output/Fields interval=0.001")
        before, sys.argv = sys.argv, ["paraview", f"gap-{gap}"]
        found = script.settings_of(script.parse_arguments())["gap"]
        sys.argv = before
        check(f"gap {gap}", found is not None and abs(found - gap) < 1e-11,
              str(found))


def check_animation(script):
    """Ten frames a second, each of them, again and again."""
    folder = Path("frames")
    folder.mkdir()
    for i in range(3):
        Image.new("RGB", (4, 4), (80 * i, 0, 0)).save(
            folder / f"frame-{i:04d}.png")
    script.animate(folder, Path("animation.gif"))
    with Image.open("animation.gif") as picture:
        found = picture.n_frames, picture.info["duration"], picture.info["loop"]
    check("animation", found == (3, 100, 0), str(found))


with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    paraview = drawings.load("paraview")
    check_marks(paraview.paraview_numbers)
    check_missing(paraview.paraview_numbers)
    check_plates(paraview.paraview_numbers)
    check_views(paraview.paraview_numbers)
    check_gaps(paraview)
    check_animation(paraview)
    os.chdir("/")
drawings.finish()
