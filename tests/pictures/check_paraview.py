#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_paraview.py THERMOCONTACT SOURCE_DIRECTORY

scripts/paraview renders a rod and a block with ParaView itself, and refuses what it
cannot. Exit status 77, "skipped", without Xvfb. What the pictures show is looked at
by check_scene.py, what the files hold by tests/app/properties.prm.
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import drawings
    from drawings import check
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)
if not shutil.which("Xvfb"):
    print("skipped: no Xvfb")
    sys.exit(77)
PICTURES = ("first.png", "first-contact.png", "peak.png", "last.png",
            "animation.gif", "space-time.png")


def paraview(*arguments):
    return subprocess.run(
        [sys.executable, drawings.SOURCE / "scripts/paraview", *arguments],
        capture_output=True, text=True, check=False,
        env={name: value for name, value in os.environ.items() if name != "DISPLAY"})


with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    interval = "Output/Space-time interval=0.1"
    drawings.run("rod", "paper/experiment-1.prm", "Time/End time=1", interval)
    drawings.run("block", "examples/strip.prm", "Time/End time=0.3", "Dimension=3",
                 "Mesh/Cells=4", "Mesh/Cells across=2", interval)
    for directory in ("rod", "block"):
        result = paraview(directory, "--width", "300", "--frames", "2")
        check(f"rendered: {directory}", result.returncode == 0 and all(
            Path(directory, "paraview", name).stat().st_size > 1000
            for name in PICTURES), result.stderr)
    result = paraview("rod", "--colour", "hue")
    check("refused: no such field", result.returncode == 2 and
          "temperature" in result.stderr, result.stderr)
    Path("rod/fields/fields-00002.vtu").unlink()
    result = paraview("rod")
    check("refused: a snapshot is missing", result.returncode == 2 and
          "fields-00002.vtu" in result.stderr, result.stderr)
    os.chdir("/")
drawings.finish()
