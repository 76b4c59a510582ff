# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: pvbatch scene_record.py SCRIPTS SETTINGS

What scripts/paraview shows, without drawing it: numbers and texts of the scene,
as paraview_scene.py has ParaView make it, and the point of the moved end at the
time of each picture. SETTINGS are those that paraview_scene.py takes. Prints
them as a line of JSON. Tests without ParaView call record() with a stand-in.
"""
import json
import sys
from pathlib import Path

KINDS = ["WarpByVector", "Text", "Box", "ColorBy", "GetColorTransferFunction",
         "GetScalarBar", "CreateView", "LinearExtrusion"]


def bounds_of(servermanager, source, time):
    source.UpdatePipeline(time)
    bounds = servermanager.Fetch(source).GetBounds()
    return [float(bounds[0]), float(bounds[1])]


def record(scene, settings):
    """Calls of the scene are passed on, and what they make is looked at."""
    from paraview import servermanager
    made = {kind: [] for kind in KINDS}

    def watch(kind, call):
        def watched(*arguments, **more):
            result = call(*arguments, **more)
            made[kind].append((arguments, result))
            return result
        return watched

    for kind in KINDS:
        setattr(scene, kind, watch(kind, getattr(scene, kind)))
    bodies, show_body = [], scene.show_body

    def watch_body(view, snapshots, scale):
        bodies.append(snapshots)
        return show_body(view, snapshots, scale)
    scene.show_body, scene.Render = watch_body, lambda view: None
    pictures, shown = {}, []

    def obstacle():
        """A shape, or the box beside that of the fixed end, which stands for none too."""
        return (made["LinearExtrusion"] or made["Box"])[-1][1]

    def screenshot(path, view):
        snapshots, warps = bodies[0], made["WarpByVector"]
        body = warps[0][1] if warps else snapshots.reader
        pictures[Path(path).stem] = [
            float(view.ViewTime), [text.Text for _, text in made["Text"]],
            bounds_of(servermanager, body, view.ViewTime),
            bounds_of(servermanager, obstacle(), view.ViewTime)]
        shown.append(Path(path).name)
    scene.SaveScreenshot = screenshot
    scene.render(settings)

    tables = [table for _, table in made["GetColorTransferFunction"]]
    points = list(tables[0].RGBPoints)
    return {"pictures": pictures, "range": [float(points[i]) for i in (0, -4)],
            "vectors": [list(warp.Vectors) for _, warp in made["WarpByVector"]],
            "table": made["GetColorTransferFunction"][0][0][0],
            "title": made["GetScalarBar"][0][1].Title,
            "coloured": list(made["ColorBy"][0][0][1]),
            "boxes": [bounds_of(servermanager, box, 0.)
                      for _, box in made["Box"]],
            "shapes": [bounds_of(servermanager, shape, 0.)
                       for _, shape in made["LinearExtrusion"]]}


def main():
    sys.path.insert(0, sys.argv[1])
    import paraview_scene
    print("\nrecord " + json.dumps(record(paraview_scene,
                                          json.loads(sys.argv[2]))), flush=True)


if __name__ == "__main__":
    main()
