#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_scene.py THERMOCONTACT SOURCE_DIRECTORY

What scripts/paraview shows is what its texts say, of a rod and of a strip before
an obstacle that turns. Without ParaView: a stand-in passes on what the scripts ask
of it. For each picture: the text is the time of its snapshot, the moved end is at
1 + S u(1), S from the text "displacement x S", and the face of the obstacle at
1 + S g; peak is nearest to the time of the largest force, first-contact the first
within the first contact; all is in the picture, beside the colours; an obstacle with
a shape has a flat back; the colours span the field of the title over all snapshots. Then the
panels of the space-time picture and of the contact face. Exit status 77,
"skipped", without matplotlib.
"""
import math
import re
import sys
from pathlib import Path

try:
    import drawings
    import meshio
    import numpy
    import paraview_stand_in
    from drawings import check, table
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

FIELDS = {r"temperature  $\theta$": "temperature",
          r"displacement  $u$": "displacement",
          r"velocity  $u_t$": "velocity", r"stress  $\sigma$": "stress"}


def scene_of(directory, *arguments):
    """What the script has ParaView make: by picture, time, texts, and the bounds along
    x of body and obstacle; the ends of the colours; title of the colours."""
    script = drawings.load("paraview")
    before, sys.argv = sys.argv, ["paraview", directory, "--frames", "4", *arguments]
    settings = {**script.settings_of(script.parse_arguments()), "scratch": "scratch"}
    sys.argv = before
    paraview_stand_in.install()
    sys.modules.pop("paraview_scene", None)
    import paraview_scene
    made, pictures = {}, {}

    def watch(kind):
        call = getattr(paraview_scene, kind)

        def watched(*arguments, **more):
            made.setdefault(kind, []).append(call(*arguments, **more))
            return made[kind][-1]
        setattr(paraview_scene, kind, watched)

    for kind in ("WarpByVector", "Text", "Box", "Calculator",
                 "GetColorTransferFunction", "GetScalarBar"):
        watch(kind)

    def bounds(source, time):
        source.UpdatePipeline(time)
        return source.output().GetBounds()[:2]

    def screenshot(path, view):
        obstacle = (made.get("Calculator") or made["Box"])[-1]
        for source in (obstacle, made["WarpByVector"][0]):
            source.UpdatePipeline(view.ViewTime)
        camera, focus = map(numpy.array, (view.CameraPosition, view.CameraFocalPoint))
        body = made["WarpByVector"][0].output().points
        check("all is before the camera", ((camera - body) @ (camera - focus)).min() > 0)
        # in halves of the height of the picture, from its middle
        right = numpy.cross(view.CameraViewUp, camera - focus)
        upwards = numpy.cross(camera - focus, right)
        width, height = view.ViewSize
        for name, points in (("body", body), ("fixed end", made["Box"][0].output().corners()),
                             ("obstacle", obstacle.output().corners())):
            x, y = ((points - focus) @ axis / numpy.linalg.norm(axis) / view.CameraParallelScale
                    for axis in (right, upwards))
            share = (x * height / width + 1) / 2
            check(f"the {name} is in the picture", 0 < share.min() and share.max() < 0.8 and
                  abs(y).max() < 1, f"{share.min()} {share.max()} {abs(y).max()}")
        if "Calculator" in made:
            x = obstacle.output().points[:, 0]
            check("a flat back", (x[len(x) // 2:] == x.max()).all() and
                  (x[:len(x) // 2] <= x.max()).all(), f"{x.min()} {x.max()}")
        pictures[Path(path).stem] = (
            view.ViewTime, [text.Text for text in made["Text"]],
            bounds(made["WarpByVector"][0], view.ViewTime),
            bounds(obstacle, view.ViewTime))
    paraview_scene.Render, paraview_scene.SaveScreenshot = lambda view: None, screenshot
    paraview_scene.render(settings)
    points = made["GetColorTransferFunction"][0].RGBPoints
    return pictures, (points[0], points[-4]), made["GetScalarBar"][0].Title


def check_scene(directory, field, gaps, *arguments):
    """gaps: the smallest and the largest at a time, by hand."""
    pictures, colours, title = scene_of(directory, *arguments)
    rows = table(Path(directory, "contact.csv"))
    series = re.findall(r'timestep="(\S+)".*?file="(\S+)"', Path(
        directory, "fields.pvd").read_text())
    meshes = {float(time): meshio.read(Path(directory, name)) for time, name in series}
    axial = numpy.concatenate([mesh.point_data[field].reshape(
        len(mesh.points), -1)[:, 0] for mesh in meshes.values()])
    check(f"{directory}: colours", title == field and numpy.allclose(
        colours, [axial.min(), axial.max()], rtol=1e-6), f"{title} {colours}")

    def nearest(time):
        return min(meshes, key=lambda t: abs(t - time))
    begin = table(Path(directory, "events.csv"))["time"][0]
    peak = rows["time"][rows["contact_force"].argmax()]
    times = {"first": 0., "last": max(meshes), "peak": nearest(peak),
             "first-contact": min(time for time in meshes if time >= begin)}
    check(f"{directory}: which", {name: picture[0] for name, picture in
          pictures.items() if "frame" not in name} == times, str(list(pictures)))
    for name, (time, texts, body, obstacle) in pictures.items():
        scale = float(texts[-1].rpartition("\u00d7 ")[2])
        mesh = meshes[nearest(time)]
        u = mesh.point_data["displacement"][abs(mesh.points[:, 0] - 1) < 1e-6, 0]
        check(f"{directory}, {name}", texts[0].startswith("t = ") and
              abs(float(texts[0][4:]) - time) < 0.006 and
              abs(body[1] - 1 - scale * u.max()) < 1e-6 and
              abs(obstacle[0] - 1 - scale * gaps(time)[0]) < 2e-6,
              f"{texts} {body} {obstacle}")


def check_space_time(directory):
    """Each panel shows the values of its label at their places."""
    import paraview_space_time
    figures = []
    paraview_space_time.save = lambda figure, path, dpi: figures.append(figure)
    path = Path(directory, "space-time.vtu")
    paraview_space_time.draw(str(path), "space-time.png", 700)
    mesh = meshio.read(path)
    bars = [axes for axes in figures[0].axes if axes.get_label() == "<colorbar>"]
    panels = [axes for axes in figures[0].axes if axes not in bars]
    check(f"space-time of {directory}", [FIELDS[bar.get_xlabel()] for bar in bars] == [
        field for field in FIELDS.values() if field in mesh.point_data])
    for axes, bar in zip(panels, bars):
        (picture,), field = axes.collections, FIELDS[bar.get_xlabel()]
        values = mesh.point_data[field].reshape(len(mesh.points), -1)[:, 0]
        low, high = picture.get_clim()
        check(f"space-time of {directory}, {field}",
              numpy.array_equal(picture.get_array(), values) and
              numpy.array_equal(picture._triangulation.x, mesh.points[:, 0]) and
              numpy.array_equal(picture._triangulation.y, mesh.points[:, 1]) and
              (low, high) == bar.get_xlim() and
              (field == "temperature" or low == -high))  # white is 0
    # one value of 2000 beyond the colours of the others
    for beyond, word in (((), "neither"), ((-1,), "min"), ((2,), "max"), ((-1, 2), "both")):
        values = numpy.array([0.] * 1000 + [1.] * 1000 + list(beyond))
        check(f"colours with {beyond}", paraview_space_time.limits_of(values, "viridis") == (0, 1, word))


def check_contact_face(directory):
    """Pressure and gap over y at the time that the title says."""
    sys.modules.pop("paraview_space_time", None)
    import paraview_contact
    script, figures = drawings.load("paraview"), []
    paraview_contact.save = lambda figure, path, dpi: figures.append(figure)
    time, path = script.contact_face_at(Path(directory, "contact.pvd"), 0.2)
    paraview_contact.draw(path, time, "contact-face.png", 700)
    mesh = meshio.read(path)
    check(f"contact face of {directory}", abs(time - 0.2) < 1e-9 and
          figures[0].texts[0].get_text() == "contact end, t = 0.2")
    for axes, field in zip(figures[0].axes, ("contact_pressure", "gap")):
        y, values = axes.lines[0].get_data()
        check(f"contact face of {directory}, {field}", set(zip(
            mesh.points[:, 1], mesh.point_data[field].ravel())) == set(zip(y, values)))
    paraview_contact.draw(path, time, "contact-face.png", 700, {
        "gap": "m", "stress_end": "Pa", "displacement_end": "m", "time": "s"})
    labels = [(axes.get_xlabel()[-2:], axes.get_ylabel()) for axes in figures[1].axes]
    check("contact face: units", [x for x, _ in labels] == ["m]"] * 2 and all(
        re.search(f"{name}.*\\[.?{unit}\\]$", label) for (_, label), (name, unit) in zip(
            labels, (("pressure", "Pa"), ("gap", "m")))), labels)
    axes = figures[0].axes[0]
    axes.clear()
    y = numpy.array([0.2, 0.0, 0.1])  # as cells may be written
    paraview_contact.draw_line(axes, y, 10 * y, "")
    check("a line in the order of y", numpy.array_equal(
        axes.lines[0].get_xydata(), [[0, 0], [0.1, 1], [0.2, 2]]))


def check_factors():
    """By hand: 0.33 / max |u| or 0.75 / largest compression, to one digit."""
    import paraview_numbers
    points = numpy.array([[0, 0, 0], [0.5, 0, 0], [1, 0, 0]])
    for u, factor in (([0, 0.25, 0.5], 0.6),  # 0.66; nothing is compressed
                      ([0, -0.005, -0.01], 30),  # 33; 75
                      ([0, 0.02, -0.02], 9),  # 16.5; 0.75 / 0.08 = 9.4, of the tension 18.75
                      ([0, 0.02, -0.01], 10),  # 16.5; 0.75 / 0.06 = 12.5
                      ([0, 0, 0], 1)):
        ranges = paraview_numbers.Ranges()
        ranges.add(points, points, numpy.array([[u_i, 0, 0] for u_i in u]))
        check(f"factor of {u}", ranges.scale() == factor, str(ranges.scale()))


def main():
    drawings.run("rod", "paper/experiment-1.prm", "Time/End time=0.5", "Mesh/Cells=10",
                 "Output/Fields interval=0.05", "Output/Space-time interval=0.05")
    drawings.run("turn", "examples/strip.prm", "Time/End time=0.4", "Mesh/Cells=6",
                 "Time/Start=automatic", "Output/Fields interval=0.05",
                 "Contact/Gap=0.02+0.1*y-(0.03+0.2*y)*sin(9*t)")
    check_scene("rod", "temperature", lambda t: (0.1, 0.1))
    # the gaps at y = 0 and 0.2
    check_scene("turn", "stress", lambda t: sorted(
        0.02 + 0.1 * y - (0.03 + 0.2 * y) * math.sin(9 * t) for y in (0, 0.2)),
        "--colour", "stress")
    drawings.run("wide block", "examples/strip.prm", "Time/End time=0.3", "Dimension=3",
                 "Mesh/Cells=1", "Mesh/Cells across=1", "Mesh/Width=8", "Contact/Gap=0.02")
    check_scene("wide block", "temperature", lambda t: (0.02, 0.02))
    check_factors()
    check_space_time("rod")
    check_contact_face("turn")


drawings.run_in_scratch(main)
