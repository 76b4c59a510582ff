#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Resumes the run of an output directory with other parameters.

usage: check_resume_changes.py DIR

DIR holds a finished run with checkpoints and fixed steps that divide its end
time, so that the longer run passes through the same states.
"""
import csv
import os
import re
import shutil
import signal
import sys
import time
from pathlib import Path

import meshio

sys.dont_write_bytecode = True
import program  # noqa: E402

PROGRAM = os.environ["THERMOCONTACT"]
TWO_RANKS = ("mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2")


def start(directory, *options, launcher=()):
    return program.start([*launcher, PROGRAM, "--quiet", "--output", str(directory), *options])


def run(directory, *options):
    status, _, message = program.run("--quiet", "--output", directory, *options)
    return status, message.replace(str(directory), "DIR")


def contents(directory):
    return {path: path.read_bytes() for path in directory.rglob("*")
            if path.is_file()}


def refuse(reference, what, *options):
    before = contents(reference)
    status, message = run(reference, "--resume", *options)
    print(f"{what}: status {status}, files untouched",
          int(contents(reference) == before))
    print(message.rstrip())


MAY_CHANGE = ("Title", "Time/End time", "Output/Directory", "Output/Fields interval",
              "Output/Contact interval", "Output/Space-time interval",
              "Output/Checkpoint interval", "Output/Error bars")


def words_of_entries():
    """The words that each entry allows, by its path, of those that allow words alone."""
    page = program.run("--print-parameters=markdown")[1]
    section, words = "", {}
    for line in page.splitlines():
        if line.startswith("## "):
            section = line[3:] + "/"
        elif match := re.match(r"\| `([^`]+)` \| [^|]* \| ((?:`[^`]+`(?:, )?)+) \|", line):
            words[section + match[1]] = re.findall("`([^`]+)`", match[2])
    return words


def others(path, value, words):
    """Other values of an entry that a scene could have."""
    if path in words:
        return [word for word in words[path] if word != value]
    if path == "Boundary/left/Displacement":
        return ["0.1*t"]  # it begins at zero
    if path == "Output/Probes":
        return ["0.25"]
    if path == "Time/Break points":
        return ["0.5"]
    try:
        number = float(value)
    except ValueError:
        return ["1"] if value in ("none", "automatic", "infinity") else [f"{value}+0.01*x*(1-x)"]
    return [f"{number + 1:.0f}" if number == int(number) else f"{1.01 * number!r}"]


def not_refused(reference):
    """Entries of used.prm that --resume lets change, each alone, but for MAY_CHANGE; and those
    that are refused for another reason than the checkpoint whatever the value."""
    accepted, elsewhere, section, n_refused, words = [], [], "", 0, words_of_entries()
    for line in (reference / "used.prm").read_text().splitlines():
        if match := re.match(r"subsection (.*)", line):
            section = match[1] + "/"
        elif line == "end":
            section = ""
        elif match := re.match(r" *set (.*?) *= ?(.*?)(?: # .*)?$", line):
            path, messages = section + match[1], []
            if path in MAY_CHANGE or path.startswith("Study/"):
                continue
            for other in others(path, match[2], words):
                status, message = run(reference, "scene.prm", "--resume", "--set",
                                      f"{path}={other}")
                if status != 2:
                    accepted.append(f"{path}={other}: {status}, {message}")
                messages.append(message)
            if any(f"{path} = " in message and ": the checkpoint has" in message
                   for message in messages):
                n_refused += 1
            else:
                elsewhere.append(path)
    return (", ".join(accepted) or ("none" if n_refused >= 30 else f"{n_refused} asked")) + (
        "; for another reason: " + (", ".join(elsewhere) or "none"))


def rows(directory):
    with open(directory / "contact.csv") as lines:
        return list(csv.reader(line for line in lines if line[0] != "#"))


def extend(reference, prm):
    """Another end time and other intervals: the steps are the same."""
    longer = Path("longer")
    status, _ = run(longer, prm, "--set", "Time/End time=1.5")
    resumed = Path("resumed")
    shutil.copytree(reference, resumed)
    for i in (6, 7):  # as if the run had been killed later, with more of them
        shutil.copy(resumed / "fields/fields-00005.vtu",
                    resumed / f"fields/fields-0000{i}.vtu")
    again, _ = run(resumed, prm, "--resume", "--set", "Time/End time=1.5",
                   "--set", "Output/Fields interval=0.5",
                   "--set", "Output/Checkpoint interval=0")
    print("longer:", status, again, "rows", len(rows(resumed)) - 1, "the same",
          int(rows(longer) == rows(resumed)), "snapshots at",
          [line.split('"')[1] for line in
           (resumed / "fields.pvd").read_text().splitlines()
           if "timestep" in line], "files", len(list(resumed.glob("fields/*"))))
    shutil.rmtree(resumed)
    return longer


def without_space_time(reference, prm):
    """The space-time file of a run that for a while did not write it."""
    resumed = Path("resumed")
    shutil.copytree(reference, resumed)
    status = [run(resumed, prm, "--resume", "--set", f"Time/End time={time}",
                  "--set", f"Output/Space-time interval={interval}")[0]
              for time, interval in ((1.25, 0), (1.75, 0.25))]
    times = meshio.read(resumed / "space-time.vtu").points[:, 1]
    print("space-time file, not written from 1 to 1.25: status", *status, "times",
          *sorted({f"{t:g}" for t in times}))
    shutil.rmtree(resumed)


def without_fields(prm):
    """A run without snapshots goes on with some, is killed before its next checkpoint, and
    goes on from its first one without snapshots: neither files nor their list are left."""
    directory = Path("without-fields")
    status = [run(directory, prm, "--set", "Output/Fields interval=0")[0]]
    checkpoint = (directory / "checkpoint.bin").read_bytes()
    for end, interval in ((1.25, 0.25), (1.5, 0)):
        (directory / "checkpoint.bin").write_bytes(checkpoint)
        status.append(run(directory, prm, "--resume", "--set", f"Time/End time={end}",
                          "--set", f"Output/Fields interval={interval}")[0])
        print("snapshots of a run with none up to its checkpoint,", "status", *status,
              "interval", interval, sorted(
                  str(path.relative_to(directory)) for path in
                  (*directory.glob("*.pvd"), *directory.glob("fields/*"))))
    shutil.rmtree(directory)


def kill(reference, prm):
    """Files that tell of the end of a run are not there once it goes on."""
    directory = Path("resumed")
    shutil.copytree(reference, directory)
    table = directory / "contact.csv"
    size = table.stat().st_size
    process = start(directory, prm, "--resume", "--set", "Time/End time=1e4")
    while table.stat().st_size <= size and process.poll() is None:
        time.sleep(0.01)
    process.kill()
    process.communicate()
    print("files of the end after a resumed run was killed:",
          [name for name in ("summary.json", "space-time.vtu")
           if (directory / name).exists()])
    shutil.rmtree(directory)


def damage(directory):
    path = directory / "checkpoint.bin"
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(data)


def damage_twice(reference, prm, longer):
    """A damaged checkpoint never becomes the one to fall back on."""
    directory = Path("resumed")
    shutil.copytree(reference, directory)
    status = []
    for _ in range(2):
        damage(directory)
        status.append(run(directory, prm, "--resume", "--set",
                          "Time/End time=1.5")[0])
    print("newest checkpoint damaged, resumed, both once more: status", *status,
          "the same", int(rows(directory) == rows(longer)))
    shutil.rmtree(directory)


def short_tables(reference, prm):
    """Tables that have lost their last byte, and tables that are gone."""
    for name in ("contact.csv", "events.csv", "probes.csv", "space-time.columns"):
        table = reference / name
        data = table.read_bytes()
        for what, content in (("is shorter than the checkpoint says", data[:-1]),
                              ("No such file or directory", None)):
            table.unlink()
            if content is not None:
                table.write_bytes(content)
            before = contents(reference)
            status, message = run(reference, prm, "--resume")
            print(f"{name}: status {status}, files untouched",
                  int(contents(reference) == before), "said", int(
                      message.startswith(f"DIR/{name}: {what}\n")))
        table.write_bytes(data)


def interrupt(prm):
    """The command that a run of a strip on two ranks names when it is interrupted."""
    directory = Path("interrupted")
    process = start(directory, prm, "--set", "Time/Step size=1e-4",
                    "--set", "Time/End time=1e3", "--set", "Dimension=2",
                    "--set", "Mesh/Cells=2", "--set", "Mesh/Cells across=1",
                    "--set", "Output/Probes=1, 0.1", launcher=TWO_RANKS)
    # from the first checkpoint on signals are waited for
    while not (directory / "checkpoint.bin").exists() and process.poll() is None:
        time.sleep(0.01)
    # not to mpirun: that of Open MPI 5 hands it on, but then nothing of stderr
    for rank in program.started_by(process):
        os.kill(rank, signal.SIGTERM)
    message = process.communicate()[1]
    # prterun is what mpirun of Open MPI 5 becomes
    print("SIGTERM on two ranks:", message.partition("resume:  ")[2].partition(
        "\n")[0].replace(PROGRAM, "thermocontact").replace("prterun ", "mpirun ", 1))
    shutil.rmtree(directory)


def with_table():
    """A constant, and a table beside a parameter file elsewhere: used.prm is beside its
    copy, and the run goes on to what it would have been at once."""
    scene = Path("measured/scene.prm")
    scene.parent.mkdir()
    (scene.parent / "force.csv").write_text("t,f\n0,0\n1,1\n3,0\n")
    scene.write_text("""
subsection Constants
  set F = 0.1
end
subsection Boundary
  set right/Traction = F*table(force.csv, t)
end
subsection Time
  set Scheme    = backward euler
  set Step size = 0.05
  set End time  = 1
end
subsection Output
  set Checkpoint interval = 3600
end
""")
    resumed, longer = Path("measured-resumed"), Path("measured-longer")
    to_later = ("--set", "Time/End time=1.5")
    status = [run(resumed, scene)[0],
              run(resumed, "--resume", resumed / "used.prm", *to_later)[0],
              run(longer, scene, *to_later)[0]]
    print("a constant and a table: status", *status, "rows", len(rows(resumed)) - 1,
          "the same", int(rows(resumed) == rows(longer)))
    for directory in (scene.parent, resumed, longer):
        shutil.rmtree(directory)


def lock(prm):
    """A second run in the directory of one that goes on is refused."""
    directory = Path("locked")
    first = start(directory, prm, "--set", "Time/Step size=1e-5",
                  "--set", "Time/End time=1e3")
    while not (directory / "contact.csv").exists() and first.poll() is None:
        time.sleep(0.01)
    status, message = run(directory, prm)
    print(f"second run: status {status}")
    print(message.rstrip())
    first.kill()
    first.communicate()
    status, message = run(directory, prm)
    print(f"after the first was killed: status {status}")
    shutil.rmtree(directory)


def main():
    reference = Path(sys.argv[1])
    prm = str(reference / "used.prm")
    shutil.copy(prm, "scene.prm")
    refuse(reference, "other viscosity", "scene.prm",
           "--set", "Model/Viscosity=0.3")
    refuse(reference, "same viscosity, written otherwise, end time too early",
           "scene.prm", "--set", "Model/Viscosity=2e-1",
           "--set", "Time/End time=0.5")
    refuse(reference, "study", "scene.prm",
           "--set", "Study/Vary=Mesh/Cells = 4 | 8")
    print("other values that are not refused:", not_refused(reference))
    status, message = run(Path("nowhere"), "scene.prm", "--resume")
    print(f"no directory: status {status}, directory",
          int(Path("nowhere").exists()))
    print(message.rstrip())
    for what, files in (("of a run", ["contact.csv"]), ("of a study", ["study.csv"])):
        directory = Path(what)
        directory.mkdir(exist_ok=True)
        for file in files:
            (directory / file).touch()
        refuse(directory, what, "scene.prm")
    # a directory behind --resume, as other programs take it
    for words in (["--resume", str(reference), "scene.prm"], ["--resume=" + str(reference), "scene.prm"],
                  ["--quiet=yes", "scene.prm"]):
        status, _, message = program.run(*words)
        print(f"{words[0].partition('=')[0]} and a word: status {status}")
        print(message.replace(str(reference), "DIR").rstrip())
    longer = extend(reference, "scene.prm")
    damage_twice(reference, "scene.prm", longer)
    shutil.rmtree(longer)
    without_space_time(reference, "scene.prm")
    without_fields("scene.prm")
    kill(reference, "scene.prm")
    short_tables(reference, "scene.prm")
    lock("scene.prm")
    interrupt("scene.prm")
    with_table()
    os.remove("scene.prm")


main()
