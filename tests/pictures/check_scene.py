#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_scene.py THERMOCONTACT SOURCE_DIRECTORY [PVBATCH]

What scripts/paraview shows of a rod, a strip and a rod without displacement is
what its texts say, without drawing it (scene_record.py). For each picture:
  end        the moved end is at 1 + S u(1), S from the text "displacement x S"
             and u(1) from contact.csv (a strip: between its corners)
  time       the text is the time of the snapshot, to a tenth of their distance
  which      peak: nearest to the time of the largest force in contact.csv;
             first-contact: to the first row of events.csv; first; last; frames
and of the scene:
  obstacle   its face is at 1 + S g, g from used.prm, or at the time of each picture by
             the formula of one that moves; the fixed end's at 0
  colours    smallest and largest axial value of the field in the title in all
             snapshots, read by meshio
  S          if it is not given: |S u| <= 0.33, and no cell shrinks to less than
             a quarter; the next larger number of one digit breaks one of these
And each panel of the space-time picture shows the field of its label. The check
is seen to fail when a number of the scene is changed. Without PVBATCH, a
stand-in for ParaView passes on what the scripts ask of it. Exit status 77,
"skipped", without matplotlib.
"""
import contextlib
import io
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import drawings
    import meshio
    import numpy
    from scene_truth import Truth, falsified, faults_of_record
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)
import paraview_stand_in
import scene_record

program, source = sys.argv[1], Path(sys.argv[2]).resolve()
pvbatch = sys.argv[3] if len(sys.argv) > 3 else None
n_failed = 0
FIELDS = {r"temperature  $\theta$": "temperature",
          r"displacement  $u$": "displacement",
          r"velocity  $u_t$": "velocity", r"stress  $\sigma$": "stress"}


def check(name, good, message=""):
    global n_failed
    n_failed += not good
    print(f"{'passed' if good else 'FAILED'}: {name}  {message}".rstrip())


def run(directory, prm, *settings):
    words = [word for entry in settings for word in ("--set", entry)]
    subprocess.run([program, "--quiet", "--output", directory, *words,
                    source / "prm" / prm], check=True, env={
                        **os.environ, "OMPI_MCA_btl": "self",
                        "OMPI_MCA_ess_singleton_isolated": "1"})


def settings_of(directory, *arguments):
    script = drawings.load(source / "scripts", "paraview")
    before, sys.argv = sys.argv, ["paraview", str(directory), *arguments]
    try:
        settings = script.settings_of(script.parse_arguments())
    finally:
        sys.argv = before
    return {**settings, "scratch": "scratch"}


def record_of(settings):
    """By pvbatch, or by the stand-in with a fresh copy of the scene."""
    if not pvbatch:
        sys.modules.pop("paraview_scene", None)
        paraview_stand_in.install()
        import paraview_scene
        return json.loads(json.dumps(
            scene_record.record(paraview_scene, settings)))
    result = subprocess.run(
        [pvbatch, "--force-offscreen-rendering", scene_record.__file__,
         source / "scripts", json.dumps(settings)],
        capture_output=True, text=True)
    lines = [line for line in result.stdout.splitlines()
             if line.startswith("record ")]
    if not lines:
        sys.exit(f"FAILED: pvbatch: {result.stdout} {result.stderr}")
    return json.loads(lines[0][len("record "):])


def check_scene(name, directory, field, *arguments, gaps=None, motion=None):
    truth = Truth(Path(directory), gaps, motion)
    record = record_of(settings_of(Path(directory), "--frames", "4",
                                   *arguments))
    faults = faults_of_record(record, truth, field, 4)
    check(name, not faults, "; ".join(faults))
    missed, n_faults = [], 0
    for fault, changed in falsified(record):
        n_faults += 1
        missed += [] if faults_of_record(changed, truth, field, 4) else [fault]
    check(f"{name}: faults noticed", n_faults > 10 and not missed,
          f"{n_faults - len(missed)} of {n_faults} {missed}")
    if truth.moves and "--scale" not in arguments:
        label = record["pictures"]["first"][1][1]
        scale = float(label.split()[-1])
        above = scale + 10 ** math.floor(math.log10(scale))
        check(f"{name}: factor", truth.is_suitable(scale) and
              not truth.is_suitable(above), label)


def check_space_time(directory):
    """Each panel: values at their places, colours symmetric where 0 is white."""
    paraview_stand_in.install()
    sys.path.insert(0, str(source / "scripts"))
    sys.modules.pop("paraview_space_time", None)
    import paraview_space_time
    figures = []
    paraview_space_time.save = lambda figure, path, dpi: figures.append(figure)
    path = Path(directory, "space-time.vtu")
    paraview_space_time.draw(str(path), "space-time.png", 700)
    mesh = meshio.read(path)
    bars = [axes for axes in figures[0].axes if axes.get_label() == "<colorbar>"]
    panels = [axes for axes in figures[0].axes if axes not in bars]
    check(f"space-time of {directory}", [bar.get_xlabel() for bar in bars]
          == [label for label, field in FIELDS.items()
              if field in mesh.point_data] and panels[0].get_ylabel() ==
          "time  $t$" and {axes.get_xlabel() for axes in panels} == {"$x$"})
    for axes, bar in zip(panels, bars):
        field, (picture,) = FIELDS[bar.get_xlabel()], axes.collections
        check(f"space-time of {directory}, {field}",
              shows_field(axes, bar, mesh), str(picture.get_clim()))
        before, limits = picture.get_array(), picture.get_clim()
        others = [mesh.point_data[name].reshape(len(mesh.points), -1)[:, 0]
                  for name in FIELDS.values() if name != field]
        missed = 0
        for other in others:
            picture.set_array(other)
            missed += shows_field(axes, bar, mesh)
        picture.set_array(before)
        for factor in (0.5, 2):
            picture.set_clim([factor * limit for limit in limits])
            missed += shows_field(axes, bar, mesh)
        check(f"space-time of {directory}, {field}: faults noticed", not missed)


def shows_field(axes, bar, mesh):
    """Its values at its points, all but 1 in 100 within the colours, whose ends
    are pointed if there are more; displacement, velocity, stress: white is 0.
    """
    field, (picture,) = FIELDS[bar.get_xlabel()], axes.collections
    values = mesh.point_data[field].reshape(len(mesh.points), -1)[:, 0]
    corners, end = picture._triangulation, mesh.points[:, 1].max()
    low, high = picture.get_clim()
    inside = numpy.sort(values)[round(0.005 * len(values)):][:round(
        0.99 * len(values))]
    farthest = max(abs(inside[[0, -1]]))
    ends = inside[[0, -1]] if field == "temperature" else [-farthest, farthest]
    extend = {(0, 0): "neither", (1, 0): "min", (0, 1): "max", (1, 1): "both"}[
        values.min() < low, values.max() > high]
    limits = [*axes.get_xlim(), *axes.get_ylim()]
    # the ends are between values: the next ones may be 2 in 100 apart
    near = 0.02 * (values.max() - values.min())
    return (numpy.array_equal(picture.get_array(), values) and
            numpy.array_equal(corners.x, mesh.points[:, 0]) and
            numpy.array_equal(corners.y, mesh.points[:, 1]) and
            numpy.allclose(moments(corners), [end, end / 2, end * end / 2],
                           rtol=0, atol=1e-6) and
            (low, high) == bar.get_xlim() and
            picture.colorbar.extend == extend and
            numpy.allclose([low, high], ends, rtol=0, atol=near) and
            numpy.allclose(limits, [0, 1, 0, end]))


def check_contact_face(directory):
    """Pressure and gap over y, or over y and z: values at their places, each in the panel
    of its label, at the time that the title says, which has the largest force."""
    paraview_stand_in.install()
    sys.path.insert(0, str(source / "scripts"))
    for name in ("paraview_space_time", "paraview_contact"):
        sys.modules.pop(name, None)
    import paraview_contact
    script, figures = drawings.load(source / "scripts", "paraview"), []
    paraview_contact.save = lambda figure, path, dpi: figures.append(figure)
    peak = Truth(Path(directory), gaps=(0., 0.)).marks["peak"]
    time, path = script.contact_face_at(Path(directory, "contact.pvd"), peak)
    paraview_contact.draw(path, time, "contact-face.png", 700)
    mesh = meshio.read(path)
    labels = {"contact pressure  $p$": "contact_pressure", "gap  $g - u$": "gap"}
    panels = [axes for axes in figures[0].axes if axes.get_label() != "<colorbar>"]
    title = figures[0].texts[0].get_text()
    check(f"contact face of {directory}", time == peak and len(panels) == 2 and
          title == f"contact end, t = {peak:.3g}", title)
    for field, axes in zip(labels.values(), panels):
        shown, label = shown_values(axes)
        values = {name: numpy.column_stack([
            mesh.points[:, 1:], mesh.point_data[name].ravel()]) for name in labels.values()}
        # a map has the middles of the cells as well
        same = {name: set(map(tuple, value)) <= set(map(tuple, shown))
                for name, value in values.items()}
        check(f"contact face of {directory}, {field}", labels[label] == field and
              [name for name, is_shown in same.items() if is_shown] == [field])


def shown_values(axes):
    """y, z and value of what a panel shows, and its label."""
    if axes.lines:
        y, values = axes.lines[0].get_data()
        return numpy.column_stack([y, 0 * y, values]), axes.get_ylabel()
    picture, = axes.collections
    corners = picture._triangulation
    return (numpy.column_stack([corners.x, corners.y, picture.get_array()]),
            picture.colorbar.ax.get_ylabel())


def moments(corners):
    """Integrals of 1, x and y over all triangles, which must not overlap."""
    x, y = corners.x[corners.triangles], corners.y[corners.triangles]
    areas = abs((x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) -
                (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])) / 2
    return [sum(areas), sum(areas * x.mean(1)), sum(areas * y.mean(1))]


def check_message():
    """Pictures of an earlier time are not said to be written."""
    script = drawings.load(source / "scripts", "paraview")
    old, new = (Path("rod/paraview", name) for name in ("old.png", "peak.png"))
    old.parent.mkdir(exist_ok=True)
    for file in (old, new):
        file.touch()
        os.utime(file, (1, 1))
    script.shutil.which = lambda name: name
    script.run_pvbatch = lambda settings, scratch: new.touch()
    before, sys.argv = sys.argv, ["paraview", "rod"]
    with contextlib.redirect_stdout(io.StringIO()) as text:
        script.main()
    sys.argv = before
    check("message", text.getvalue() == "wrote rod/paraview/: peak.png\n",
          text.getvalue().strip())


def check_factors():
    """By hand: 0.33 / max |u| or 0.75 / largest compression, to one digit."""
    import paraview_numbers
    points = numpy.array([[0, 0, 0], [0.5, 0, 0], [1, 0, 0]])
    for u, factor in (([0, 0.25, 0.5], 0.6),  # 0.66; nothing is compressed
                      ([0, -0.005, -0.01], 30),  # 33; 75
                      ([0, 0.2, -0.1], 1),  # 1.65; 0.75 / 0.6 = 1.25
                      ([0, 0.01, -0.01], 10),  # 33; 0.75 / 0.04 = 18.75
                      ([0, 0, 0], 1)):
        ranges = paraview_numbers.Ranges()
        ranges.add(points, points, numpy.array([[u_i, 0, 0] for u_i in u]))
        check(f"factor of {u}", ranges.scale() == factor, str(ranges.scale()))


def main():
    run("rod", "paper/experiment-1.prm", "Time/End time=0.5", "Mesh/Cells=10",
        "Output/Fields interval=0.05", "Output/Space-time interval=0.05")
    run("fine", "paper/experiment-1.prm", "Time/End time=0.032",
        "Mesh/Cells=4", "Output/Fields interval=0.002", "Contact/Gap=0.001")
    run("strip", "examples/strip.prm", "Time/End time=0.4", "Mesh/Cells=6",
        "Output/Fields interval=0.05", "Output/Space-time interval=0.05")
    run("shape", "examples/strip.prm", "Time/End time=0.2", "Mesh/Cells=6",
        "Output/Fields interval=0.05", "Contact/Gap=0.02+(y-0.1)^2")
    run("hammer", "examples/hammered-rod.prm", "Time/End time=3",
        "Output/Fields interval=0.3")
    run("turn", "examples/strip.prm", "Time/End time=0.4", "Mesh/Cells=6", "Time/Start=automatic",
        "Output/Fields interval=0.05", "Contact/Gap=0.02+0.1*y-(0.03+0.2*y)*sin(9*t)")
    run("heat", "verification/heat-series.prm", "Time/End time=0.2",
        "Output/Fields interval=0.05")
    check_scene("rod", "rod", "temperature")
    check_scene("strip, stress", "strip", "stress", "--colour", "stress")
    check_scene("shaped obstacle", "shape", "temperature", gaps=(0.02, 0.03))
    # faces of straight obstacles: their gaps at y = 0 and 0.2
    check_scene("obstacle that turns", "turn", "temperature", motion=lambda t: sorted(
        0.02 + 0.1 * y - (0.03 + 0.2 * y) * math.sin(9 * t) for y in (0, 0.2)))
    if not pvbatch:  # which takes seconds for each
        check_scene("hammer", "hammer", "displacement", "--colour", "displacement", motion=lambda t: (
            0.02 - 0.05 * max(0, math.sin(2 * t))**3,) * 2)
        check_scene("fine", "fine", "temperature")
        check_scene("heat", "heat", "temperature")
        check_scene("rod, half", "rod", "displacement", "--scale", "0.5",
                    "--colour", "displacement")
        check_scene("strip", "strip", "temperature")
        check_factors()
        check_message()
        check_space_time("rod")
        check_space_time("strip")
        run("block", "examples/tilted-block.prm", "Time/End time=0.2", "Mesh/Cells=4",
            "Mesh/Cells across=2", "Output/Fields interval=0.1")
        check_contact_face("strip")
        check_contact_face("block")


with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    main()
    os.chdir("/")
sys.exit(1 if n_failed else 0)
