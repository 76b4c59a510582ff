#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_plot.py THERMOCONTACT SOURCE_DIRECTORY

scripts/plot draws what it can and refuses the rest with a message and exit
status 2. By the description of its pictures (scripts/plot --help): which files
are written follows from what the scene has. Runs: error-controlled with both
fields (all pictures), with fixed steps and cut off in the middle of a row as a
killed run leaves it (no steps.csv, no summary.json), temperature alone (no
contact). Exit status 77, "skipped", without matplotlib.
"""
import os
import shutil
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

program, source = sys.argv[1], Path(sys.argv[2])
one_process = {"OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_btl": "self"}
quick = ["--set", "Time/End time=0.5", "--set", "Output/Fields interval=0"]
n_failed = 0


def check(name, good, message=""):
    global n_failed
    n_failed += not good
    print(f"{'passed' if good else 'FAILED'}: {name}  {message}".rstrip())


def run(directory, *arguments):
    subprocess.run([program, "--quiet", "--output", directory, *quick,
                    *arguments], check=True,
                   env={**os.environ, **one_process})


def plot(*arguments):
    return subprocess.run([sys.executable, source / "scripts/plot", "--dpi",
                           "40", *arguments], capture_output=True, text=True)


def check_pictures(name, expected, *arguments):
    """The files expected are there, are PNG, and show something."""
    shutil.rmtree("pictures", ignore_errors=True)
    result = plot("--output", "pictures", *arguments)
    found = sorted(p.name for p in Path("pictures").glob("*"))
    check(name, result.returncode == 0 and
          found == sorted(f"{e}.png" for e in expected),
          f"{found} {result.stderr}")
    for picture in Path("pictures").glob("*"):
        data = picture.read_bytes()
        check(f"{name}, {picture.name}",
              data.startswith(b"\x89PNG") and len(data) > 3000)


def check_resolution():
    """Twice the dots per inch: twice as many in both directions."""
    sizes = []
    for dpi in (40, 80):
        plot("heat", "--figure", "energy", "--output", "size.png", "--dpi", str(dpi))
        sizes.append(struct.unpack(">2I", Path("size.png").read_bytes()[16:24]))
    check("dots per inch", sizes[1] == tuple(2 * n for n in sizes[0]), str(sizes))


def check_refusal(name, words, *arguments):
    result = plot(*arguments)
    check(f"refused: {name}", result.returncode == 2 and
          len(result.stderr.splitlines()) == 1 and
          all(word in result.stderr for word in words) and
          "Traceback" not in result.stderr, result.stderr.strip())


def main():
    run("controlled", source / "prm/paper/experiment-1.prm",
        "--set", "Mesh/Cells=4", "--set", "Mesh/Degree=4",
        "--set", "Time/Scheme=sdirk4", "--set", "Time/Start=consistent",
        "--set", "Time/Step size=automatic")
    run("killed", source / "prm/paper/experiment-1.prm",
        "--set", "Mesh/Cells=10")
    Path("killed/summary.json").unlink()
    table = Path("killed/contact.csv")
    table.write_bytes(table.read_bytes()[:-137])  # within a row
    run("heat", source / "prm/verification/heat-series.prm",
        "--set", "Time/Tolerance=1e-4")

    usual = ["figure", "contact", "energy"]
    check_pictures("error-controlled", [*usual, "steps"], "controlled")
    check_pictures("killed", usual, "killed")
    check_pictures("heat", ["figure", "energy", "steps"], "heat")
    check_pictures("several", [*usual, "steps"], "controlled", "killed", "heat")
    check_pictures("decay", ["decay"], "killed", "heat", "--figure", "decay")

    Path("probed").mkdir()
    shutil.copy("killed/contact.csv", "probed")
    Path("probed/probes.csv").write_text(
        "# t\n# probe 1: x = 0.5\ntime,temperature_1,displacement_1,"
        "velocity_1,stress_1\n0,1,nan,nan,nan\n1,2,nan,nan,nan\n2,3,n")
    check_pictures("probes", [*usual, "probes"], "probed")
    check_resolution()
    for format in ("svg", "pdf"):
        result = plot("killed", "--output", f"one.{format}")
        check(f"one file, {format}", result.returncode == 0 and
              Path(f"one.{format}").stat().st_size > 3000)

    header = "".join(table.read_text().splitlines(keepends=True)[:3])
    for name, text in (("empty", ""), ("headed", header), ("other", "a,b\n1\n"),
                       ("damaged", header + "0,x" + ",0" * 18 + "\n")):
        Path(name).mkdir()
        Path(name, "contact.csv").write_text(text)
    check_refusal("no directory", ["nowhere", "give the directory"], "nowhere")
    check_refusal("no contact.csv", ["contact.csv"], "pictures")
    check_refusal("empty file", ["empty", "again"], "empty")
    check_refusal("no rows", ["no rows", "wait"], "headed")
    check_refusal("another table", ["no column"], "other")
    check_refusal("no number", ["contact.csv:4", "'x'"], "damaged")
    check_refusal("picture not of this scene", ["steps", "steps.csv"],
                  "killed", "--figure", "steps")
    check_refusal("format", [".bmp", ".svg"], "killed", "--output", "x.bmp")


try:
    import matplotlib  # noqa: F401
except ImportError:
    print("skipped: no python3-matplotlib")
    sys.exit(77)
with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    main()
    os.chdir("/")
sys.exit(1 if n_failed else 0)
