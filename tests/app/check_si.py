#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results in SI units, from those of the same run without units.

A rod, a study of it and a strip on a shaped obstacle are run with scales that are prime to
each other, in SI units and with Output/SI = false. What the latter write is what they write
without Scales, byte for byte. Each number of the former is that of the latter by the
factors of FACTORS, in units as there: displacements, stresses, the area, times (in min) and
temperatures (in degrees Celsius) are the scales; a force is a stress times the area, an
energy a force times a displacement, and so on. The flux of heat follows from
rho c Theta^2/theta_ref = stress displacement/length, by which heat and work are energies
of one scale: rho c Theta length/time. CSV and JSON to rounding, VTU to single precision.
A run that goes on in SI units is, byte for byte, the run that was not stopped.
"""
import json
import re
import sys
from fnmatch import fnmatch
from pathlib import Path

import numpy

sys.dont_write_bytecode = True
from program import run, settings  # noqa: E402
from run_files import Run  # noqa: E402

LENGTH, SECONDS, DISPLACEMENT, STRESS, AREA = 2.0, 3.0, 0.5, 7.0, 11.0
THETA, REFERENCE = 13.0, 300.0
SCALES = [f"Scales/{name}={value}" for name, value in {
    "Length": LENGTH, "Time": SECONDS, "Displacement": DISPLACEMENT, "Stress": STRESS,
    "Area": AREA, "Temperature": THETA, "Reference temperature": REFERENCE,
    "Time unit": "min", "Temperature unit": "C"}.items()]
FORCE = STRESS * AREA
CAPACITY = STRESS * DISPLACEMENT / LENGTH * REFERENCE / THETA**2  # rho c
METRES = (DISPLACEMENT, 0, "m")
MINUTES = (SECONDS / 60, 0, "min")
DEGREES = (THETA, REFERENCE - 273.15, "\u00b0C")
JOULE = (FORCE * DISPLACEMENT, 0, "J")
NONE = (1, 0, "")
PREFIXES = {"": 1, "\u00b0": 1, "u": 1e-6, "m": 1e-3, "k": 1e3, "M": 1e6, "G": 1e9}
FACTORS = {  # the first one that fits
    "*error_temperature_end": (THETA, 0, "K"), "difference_temperature*": (THETA, 0, "K"),
    "*wall_seconds": (1, 0, "s"), "*_seconds*": (1, 0, "s"), "peak_memory*": (1, 0, "MB"),
    "max_penetration": METRES, "max_contact_force": (FORCE, 0, "N"), "*_area": NONE,
    "*in_contact": NONE, "is_stable": NONE, "contact_begins": NONE, "predicted_first_penetration": METRES,
    "time": MINUTES, "step_size": MINUTES, "*_time": MINUTES, "*duration": MINUTES,
    "*step_size": MINUTES, "TIME": MINUTES,
    "*displacement*": METRES, "*gap": METRES, "penetration": METRES,
    "*velocity*": (DISPLACEMENT / SECONDS, 0, "m/s"),
    "stress*": (STRESS, 0, "Pa"), "*pressure": (STRESS, 0, "Pa"),
    "*contact_force": (FORCE, 0, "N"), "*impulse": (FORCE * SECONDS, 0, "N s"),
    "moment_*": (FORCE * LENGTH, 0, "N m"), "*temperature*": DEGREES,
    "heat_flux*": (CAPACITY * THETA * LENGTH / SECONDS, 0, "W/m^2"),
    "*energy*": JOULE, "work": JOULE, "*dissipation": JOULE, "algebraic": JOULE}
COMMON = ["Mesh/Cells=4", "Mesh/Degree=2", "Time/End time=0.3", "Output/Probes=0.5",
          "Output/Fields interval=0.1", "Output/Space-time interval=0.1"]
STRIP = ["Dimension=2", "Mesh/Cells across=2", "Contact/Gap=0.01+y", "Output/Probes=1,0.05",
         "Boundary/sides/Support=free", "Solver/Linear solver=iterative"]
COSTS = re.compile(r'.*"(?:[a-z_]*seconds|peak_memory[a-z_]*)":.*|^  (?:time|  ) .*| us per step'
                   r"|^ +[0-9.]+,?$|^ +\]?,?$")
faults = []


def factor_of(name):
    return next((f for pattern, f in FACTORS.items() if fnmatch(name, pattern)), NONE)


def compare(what, name, found, plain, bound):
    factor, offset, _ = factor_of(name)
    expected = factor * numpy.asarray(plain, float) + offset
    scale = numpy.nanmax(abs(expected), initial=0) + abs(offset)
    if not numpy.allclose(found, expected, rtol=bound, atol=bound * scale, equal_nan=True):
        faults.append(f"{what}: {name} is {numpy.ravel(found)[-1]}, not "
                      f"{numpy.ravel(expected)[-1]}")


def execute(name, *overrides, resume=()):
    status, screen, message = run("--output", name, *settings(overrides), *resume,
                                  "scene.prm")
    if status != 0:
        faults.append(f"{name}: {message}")
    return screen


def compare_tables(name, si, plain):
    for file, table in si.tables.items():
        units = next((c[len("units: "):].split(",") for c in table.comments
                      if c.startswith("units: ")), None)
        expected = ["" if "/" in column else factor_of(column)[2] for column in table.names]
        if units != expected or any(c.startswith("units") for c in plain.tables[file].comments):
            faults.append(f"{name}/{file}: units {units}, not {expected}")
        for column in table.names:
            if isinstance(table[column], numpy.ndarray) and "seconds" not in column:
                compare(f"{name}/{file}", column, table[column],
                        plain.tables[file][column], 1e-14)


def compare_summaries(name, si, plain):
    keys = {key: factor_of(key)[2] for key in plain if factor_of(key)[2]}
    if si.pop("units") != keys or "units" in plain:
        faults.append(f"{name}: units of summary.json")
    for key, value in si.items():
        if isinstance(value, float) and "seconds" not in key and "memory" not in key:
            compare(f"{name}/summary.json", key, value, plain[key], 1e-13)
    for state, other in zip(si.get("states_of_rest", ()), plain.get("states_of_rest", ())):
        for key in state:
            compare(f"{name}/states_of_rest", key, state[key], other[key], 1e-13)


def meshes_of(directory):
    """By file, meshes of all VTU files but pieces of a space-time file."""
    import meshio
    return {str(path.relative_to(directory)): meshio.read(path)
            for path in sorted(directory.rglob("*.vtu"))}


def compare_meshes(name, si, plain):
    found = meshes_of(si.directory)
    for file, mesh in meshes_of(plain.directory).items():
        is_space_time = file == "space-time.vtu"
        points = mesh.points * [LENGTH, MINUTES[0] if is_space_time else LENGTH, LENGTH]
        if not numpy.allclose(found[file].points, points, rtol=1e-6, atol=1e-6):
            faults.append(f"{name}/{file}: points")
        for field, values in mesh.point_data.items():
            compare(f"{name}/{file}", field, found[file].point_data[field], values, 1e-6)
        for directory, has_units in (si.directory, True), (plain.directory, False):
            text = (directory / file).read_text()
            arrays = re.findall(r'Name="(\w+)".* format="binary"(?: units="(.*)")?>', text)
            # no date; the first bytes that zlib writes where it is to be fast
            if any(unit != factor_of(array)[2] * has_units for array, unit in arrays) or text.count(
                    "==eA") != text.count("binary") or "deal.II library.\n" not in text:
                faults.append(f"{name}/{file}: units {arrays}, date or compression")
    for (time, _), (plain_time, _) in zip(si.snapshots(), plain.snapshots()):
        compare(f"{name}/fields.pvd", "time", time, plain_time, 1e-14)
    positions = [[LENGTH * x for x in place] for place in plain.probe_positions()]
    words = [c for c in si.probes.comments if c.startswith("probe ")]
    if [[float(x) for x in re.findall(r"= (\S+) m", c)] for c in words] != positions:
        faults.append(f"{name}: {words}, not {positions}")
    return len(found)


def same_bytes(name, *directories, but=()):
    """Faults if files differ, but for costs, the directory and these names."""
    one, two = ({str(path.relative_to(d)): path for path in Path(d).rglob("*")
                 if path.is_file() and path.name not in ("used.prm", *but)}
                for d in directories)
    if one.keys() != two.keys():
        faults.append(f"{name}: files {one.keys() ^ two.keys()}")
        return
    for file, path in one.items():
        texts = [p.read_bytes() for p in (path, two[file])]
        if path.suffix in (".json", ".txt", ".csv"):
            texts = ["\n".join(line.rpartition(",")[0] if file.endswith("steps.csv") else line
                               for line in text.decode().split("\n")
                               if not COSTS.match(line) and not re.search(
                                   r"us per step|files  |seconds|  set up  ", line))
                     for text in texts]
        if texts[0] != texts[1]:
            faults.append(f"{name}: {file} differs")


def check_scene(name, *overrides):
    screen = execute(name, *overrides, *SCALES)
    execute(name + "-plain", *overrides, *SCALES, "Output/SI=false")
    execute(name + "-without", *overrides)
    si, plain = Run(name), Run(name + "-plain")
    same_bytes(name, name + "-plain", name + "-without")
    compare_tables(name, si, plain)
    compare_summaries(name, si.summary, plain.summary)
    n_meshes = compare_meshes(name, si, plain)
    final = re.search(r"final     u\(1\) = (\S+) (\w?)m, theta\(1\) = (\S+) (\u00b0)C, "
                      r"force (\S+) (\w?)N", screen).groups()
    for i, key in enumerate(("displacement_end", "temperature_end", "contact_force")):
        compare(f"{name}: final", key, float(final[2 * i]) * PREFIXES[final[2 * i + 1]],
                plain.contact[key][-1], 6e-6)
    return sum(len(t.names) for t in si.tables.values()), n_meshes


def check_study():
    study = ["Study/Vary=Contact/Compliance = 0.1 | 0.2", "Study/Target error=0.5",
             "Study/Reference=Mesh/Degree = 3", "Mesh/Cells=2", "Time/End time=0.1"]
    screen = execute("study", *study, *SCALES)
    execute("study-plain", *study, *SCALES, "Output/SI=false")
    compare_tables("study", Run("study"), Run("study-plain"))
    if "of at most 250 mm has" not in screen:  # half a scale of displacement
        faults.append("study: no target in metres")
    # between the error and what it is in metres, half of it: too small for all
    smallest = min(Run("study-plain").study["error_displacement_end"])
    screen = execute("aimed", *study, *SCALES, f"Study/Target error={0.75 * smallest}")
    if "No run has an error of displacement_end" not in screen:
        faults.append("study: a target in other units than errors")
    status, _, message = run("--output", "no", *settings([
        *study, *SCALES, "Study/Vary=Scales/Time = 1 | 2"]), "scene.prm")
    if status != 2 or "which all rows of study.csv have in common" not in message:
        faults.append(f"study of units: {message}")


def check_resume():
    """Steps of 0.01 to 0.05, then to 0.1; snapshots, columns and checkpoints go on."""
    steps = [*SCALES, "Time/Step size=0.01", "Output/Checkpoint interval=3600",
             "Output/Fields interval=0.01", "Output/Space-time interval=0.01"]
    execute("whole", *steps, "Time/End time=0.1")
    execute("parts", *steps, "Time/End time=0.05")
    execute("parts", *steps, "Time/End time=0.1", resume=["--resume"])
    same_bytes("resumed", "whole", "parts", but=(
        "log.txt", "summary.json", "checkpoint.bin", "checkpoint.previous.bin"))
    status, _, message = run("--output", "parts", "--resume", *settings([
        *steps, "Time/End time=0.1", "Output/SI=false"]), "scene.prm")
    if status != 2 or "Output/SI = false: the checkpoint has true" not in message:
        faults.append(f"resumed without units: {message}")


def check_message(what, expected, found):
    if expected not in found:
        faults.append(f"{what}: {expected!r} is not in {found!r}")


def check_messages():
    """Times in minutes, 0.05 for one of the scene, beside those of entries."""
    failing = ["Sources/Heat source=sqrt(0.201-t)", "Time/End time=0.4", "Time/Tolerance=0.1",
               "Contact/Gap=1", "Mesh/Cells=3", *(
                   f"Time/{name} step size=2e-3" for name in ("First", "Minimum", "Maximum"))]
    status, screen, message = run("--output", "failing", *settings([*SCALES, *failing]),
                                  "scene.prm")
    if status != 1:
        faults.append(f"a source that is not finite: status {status}")
    # the source ends at 0.201
    not_finite = re.search(r"near t = (\S+) min \(nondimensional: (\S+)\)", screen)
    if not not_finite or abs(float(not_finite[2]) - 0.201) > 5e-3 or abs(
            float(not_finite[1]) / float(not_finite[2]) - 0.05) > 1e-6:
        faults.append(f"a source that is not finite: {screen}")
    # 100 steps of 2e-3 end at 0.2, and the next one behind the end of the source
    check_message("failed step", "step 101, from t = 0.01 min to 0.0101 min: no step is "
                  "accepted, the last one tried had size 0.0001 min: ", message)
    steps = [*SCALES, "Time/Step size=0.01", "Output/Checkpoint interval=3600"]
    execute("parts", *steps, "Time/End time=0.04")
    message = run("--output", "parts", "--resume", *settings([*steps, "Time/End time=0.02"]),
                  "scene.prm")[2]
    check_message("end time", "Time/End time = 0.02: the checkpoint is at t = 0.002 min "
                  "(nondimensional: 0.04)", message)
    # an impact with fixed steps creates energy, (M2.3)
    create = ["Model/Fields=displacement", "Model/Viscosity=0", "Contact/Condition=rigid",
              "Contact/Massless nodes=off", "Initial values/Velocity=x", "Mesh/Cells=4",
              "Mesh/Degree=5", "Time/Scheme=sdirk2", "Time/Step size=0.1", "Time/End time=20",
              "Time/Locate contact events=false", "Output/Fields interval=0"]
    pattern = (r"t = (\S+)( min)?: the scheme has created the energy (\S+?)( \w?J)?, more "
               r"than its accuracy explains \((\S+?)( \w?J)?\)")
    plain, found = (re.search(pattern, execute("creates", *create, *extra))
                    for extra in ((), SCALES))
    for i, (factor, unit) in enumerate((MINUTES[::2], JOULE[::2], JOULE[::2])):
        number, word = found.groups()[2 * i:2 * i + 2]
        prefix = PREFIXES[word.strip().removesuffix(unit)]
        if plain[2 * i + 2] or abs(
                float(number) * prefix / (factor * float(plain[2 * i + 1])) - 1) > 1e-5:
            faults.append(f"energy that is created: {found[0]}, not {plain[0]}")
    # 2 (b + 0.4)/a^2 for b = 1, a = 0.5 is 11.2
    screen = run("--check", *settings([*SCALES, "Model/Viscosity=0", "Model/Coupling=0.5"]),
                 "scene.prm")[1]
    check_message("decay", "over times of the order of 0.6 min", screen)


Path("scene.prm").write_text("# defaults\n", encoding="utf-8")
counts = [check_scene("rod", *COMMON, "Contact/Rear gap=0.02",
                      "Boundary/right/Heat exchange=1+pressure"), check_scene("strip", *COMMON, *STRIP)]
check_study()
check_resume()
check_messages()
print("columns and VTU files:", counts)
print("\n".join(faults) or "as by hand")
