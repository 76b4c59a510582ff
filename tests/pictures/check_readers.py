#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_readers.py THERMOCONTACT SOURCE_DIRECTORY PVBATCH

ParaView and meshio read the files of experiment 1, of the strip, of a block and
of a rod of degree 4 with the numbers of contact.csv (check_paraview.py). The
comparison is seen to fail on a table whose u(1) is moved by 1e-5. Then
scripts/paraview renders two of them, if there is Xvfb.
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

program, source, pvbatch = sys.argv[1], Path(sys.argv[2]), sys.argv[3]
check_paraview = Path(__file__).with_name("check_paraview.py")
environment = {**os.environ, "OMPI_MCA_ess_singleton_isolated": "1",
               "OMPI_MCA_btl": "self"}
environment.pop("DISPLAY", None)
n_failed = 0


def check(name, good, message=""):
    global n_failed
    n_failed += not good
    print(f"{'passed' if good else 'FAILED'}: {name}  {message}".rstrip(),
          flush=True)


def run(directory, prm, **entries):
    settings = [part for name, value in entries.items() for part in
                ("--set", f"{name.replace('__', '/').replace('_', ' ')}={value}")]
    subprocess.run([program, "--quiet", "--output", directory, *settings,
                    "--set", "Output/Space-time interval=0.1",
                    source / "prm" / prm], check=True, env=environment)


def reads(directory, reader):
    command = [pvbatch if reader == "paraview" else sys.executable,
               check_paraview, directory, reader]
    result = subprocess.run(command, capture_output=True, text=True,
                            env=environment)
    return (f"{reader}: passed" in result.stdout and "space-time" in
            result.stdout, result.stdout + result.stderr)


def falsify(directory):
    """A copy whose contact.csv has another displacement at the end."""
    shutil.copytree(directory, "false")
    lines = Path(directory, "contact.csv").read_text().splitlines()
    n = next(i for i, line in enumerate(lines) if line.startswith("step,")) + 1
    rows = [line.split(",") for line in lines[n:]]
    Path("false/contact.csv").write_text("\n".join(lines[:n] + [",".join(
        [*row[:3], str(float(row[3]) + 1e-5), *row[4:]]) for row in rows]) + "\n")


def main():
    run("rod", "paper/experiment-1.prm", Time__End_time=1)
    run("degree", "paper/experiment-1.prm", Time__End_time=1, Mesh__Cells=8,
        Mesh__Degree=4)
    run("strip", "examples/strip.prm", Time__End_time=0.5)
    run("block", "examples/strip.prm", Time__End_time=0.3, Dimension=3,
        Mesh__Cells=4, Mesh__Cells_across=2)
    for directory in ("rod", "degree", "strip", "block"):
        for reader in ("paraview", "meshio"):
            check(f"{directory}, {reader}", *reads(directory, reader))
    falsify("rod")
    for reader in ("paraview", "meshio"):
        good, message = reads("false", reader)
        check(f"moved, {reader}", not good and "worst 1.0e-05" in message and
              f"{reader}: FAILED" in message)

    if not shutil.which("Xvfb"):
        return
    for directory in ("rod", "block"):
        result = subprocess.run(
            [sys.executable, source / "scripts/paraview", directory, "--width",
             "300", "--frames", "2"], capture_output=True, text=True,
            env=environment)
        check(f"rendered, {directory}", result.returncode == 0 and all(
            Path(directory, "paraview", name).exists() for name in
            ("first.png", "first-contact.png", "peak.png", "last.png",
             "animation.gif", "space-time.png")), result.stderr)
    result = subprocess.run(
        [sys.executable, source / "scripts/paraview", "rod", "--colour", "hue"],
        capture_output=True, text=True, env=environment)
    check("refused: no such field", result.returncode == 2 and
          "temperature" in result.stderr, result.stderr)
    Path("rod/fields/fields-00002.vtu").unlink()
    result = subprocess.run([sys.executable, source / "scripts/paraview", "rod"],
                            capture_output=True, text=True, env=environment)
    check("refused: a snapshot is missing", result.returncode == 2 and
          "fields-00002.vtu" in result.stderr, result.stderr)


with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    main()
    os.chdir("/")
sys.exit(1 if n_failed else 0)
