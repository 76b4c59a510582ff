#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_relations.py DIR [N [SEED]]

Runs N scenes that scenes.py draws and others that have the same solution, or one that
follows from it (doc/model.md):

sign       a and all temperatures negated: temperatures and the flux of heat negated, all
           else the same.
mirror     displacements, mechanical loads and a negated, the gaps exchanged: displacements,
           velocities, stress, force, impulse negated, all else the same.
scaled     without a power law: mechanical and thermal data doubled, the damping halved, gap
           and pressure of the heat exchange half as much: fields doubled, energies four
           times.
strip,     a rod is a body on rollers of any Poisson ratio, without loss of heat through its
block,     sides, whose modulus is one: the columns that both have.
round
iterative  a body by the other solver of stages; impacts: a rod as one on a rigid obstacle
free       without Poisson's ratio and heat, a body with free sides
direct     a rod by sparse factors
fixed      the iteration of the paper, where it converges, of a body without matrices
point
alone      without heat of the deformation, and an exchange that knows of no contact,
           temperatures are those of heat alone.
rear       a rear stop out of reach; heat exchange + 0*pressure, solved with the contact.
conserving steps of 0.002 that conserve energy, and controlled ones
base       an obstacle that moves by w(t) is a base that moves by -w(t) before one at rest and
           a body force -b w'', w(0) = w'(0) = 0: gaps and forces.

flight     a free body, with masses on the ends of a rod, before an obstacle, and all of it
           in a frame that moves with 0.1: forces, gaps, stress, temperatures.
held       an end that is clamped and has a temperature, and one that a spring holds, in a
           rod, without inertia with a dashpot, and an exchange heats, all of 1e10.

Errors of a column relative to its largest value, with fixed steps 1e-8 (1e-6 by the
iterative solver, or held), with error control 50 tolerances, of the two schemes 1e-3 at the end;
where the steps are the same, 1e-5 (1e-4). What a relation is not for is left out.
DIR is not read.
"""
import re
import sys
import tempfile
from pathlib import Path

import numpy

sys.dont_write_bytecode = True
from program import for_all, run, settings  # noqa: E402
from run_files import Run  # noqa: E402
from scenes import draw  # noqa: E402

N = int(sys.argv[2]) if len(sys.argv) > 2 else 40
FIRST = int(sys.argv[3]) if len(sys.argv) > 3 else 1
THERMAL = ("Initial values/Temperature", "Boundary/left/Temperature",
           "Boundary/right/Surroundings", "Boundary/sides/Surroundings",
           "Sources/Heat source", "Boundary/right/Heat flux")
MECHANICAL = ("Initial values/Displacement", "Initial values/Velocity",
              "Sources/Body force", "Boundary/right/Traction",
              "Boundary/left/Displacement")
# columns by the powers of temperatures and displacements that they have
TEMPERATURES = ("temperature_end", "temperature_mean", "heat_flux_end", "lateral_heat_flux")
LENGTHS = ("displacement_end", "displacement_mid", "velocity_end", "stress_end",
           "contact_force", "contact_impulse", "moment_y", "moment_z")
UNSIGNED = ("gap", "penetration", "max_pressure", "min_gap")
ENERGIES = ("energy", "dissipation", "numerical_dissipation", "work", "contact_dissipation",
            "lateral_dissipation")
ITERATIVE = {"Solver/Linear solver": "iterative", "Solver/Linear tolerance": "1e-10"}
COUNTS = ("step", "iterations", "algebraic")  # and what a solver leaves


def times(factor, scene, names):
    """Entries times a factor; theta_A is a value of one of them."""
    drive = scene.get("Boundary/left/Temperature", "10")
    theta_A = "10" if "cos" in drive else drive
    return {name: f"{factor}*({scene[name].replace('theta_A', f'({theta_A})')})"
            for name in names if name in scene}


def has_heat(scene):
    return "temperature" in scene["Model/Fields"]


def moves(scene):
    return "displacement" in scene["Model/Fields"]


def exchange_varies(scene):
    return any(word in scene.get("Boundary/right/Heat exchange", "") for word in ("gap", "pressure"))


def negated_coupling(scene):
    return {"Model/Coupling": str(-float(scene.get("Model/Coupling", "0.017")))} if (
        has_heat(scene) and moves(scene)) else {}


def thermal(scene):
    return {"Boundary/left/Temperature": "10"} | scene if has_heat(scene) else scene


def sign(scene):
    if not has_heat(scene):
        return None
    scene = thermal(scene)
    return scene | times(-1, scene, THERMAL) | negated_coupling(scene), dict.fromkeys(
        TEMPERATURES, -1.)


def mirror(scene):
    if not moves(scene) or re.search("[ty]", scene.get("Contact/Gap", "")):
        return None  # an obstacle behind the end rests and is flat
    gaps = {} if "Contact/Gap" not in scene else {
        "Contact/Gap": scene.get("Contact/Rear gap", "9"), "Contact/Rear gap": scene["Contact/Gap"]}
    return scene | times(-1, scene, MECHANICAL) | negated_coupling(scene) | gaps, \
        dict.fromkeys(LENGTHS, -1.)


def scaled(scene):
    if scene.get("Contact/Condition") == "power law":
        return None
    scene = thermal(scene)
    other = scene | times(2, scene, THERMAL + MECHANICAL + (
        ("Contact/Gap",) if "Contact/Gap" in scene else ()))
    if "Contact/Rear gap" in scene:
        other["Contact/Rear gap"] = str(2 * float(scene["Contact/Rear gap"]))
    if "Contact/Damping" in scene:  # a dashpot is as it was
        other["Contact/Damping"] = str(float(scene["Contact/Damping"]) / 2)
    if "Boundary/right/Heat exchange" in scene:
        other["Boundary/right/Heat exchange"] = scene["Boundary/right/Heat exchange"].replace(
            "pressure", "pressure/2").replace("gap", "gap/2")
    return other, dict.fromkeys(TEMPERATURES + LENGTHS + UNSIGNED, 2.) | dict.fromkeys(
        ENERGIES, 4.)


def body(entries):
    def relation(scene):
        is_large = entries["Dimension"] == "3" and scene["Mesh/Degree"] != "2"
        if scene["Dimension"] != "1" or "Boundary/sides/Heat exchange" in scene or is_large \
                or scene.get("Time/Scheme") == "box":
            return None
        elastic = {"Model/Poisson ratio": "0.3", "Boundary/sides/Support": "rollers",
                   } if moves(scene) else {}
        if scene.get("Contact/Condition") == "rigid" and scene["Model/Inertia"] != "0" and \
                scene.get("Time/Scheme") != "energy conserving":
            elastic["Contact/Massless nodes"] = "off"  # as they are in a rod
        middle = ", 0.05, 0.05" if entries["Dimension"] == "3" else (
            ", 0" if "Mesh/Geometry" in entries else ", 0.05")  # the axis
        return scene | entries | elastic | {"Output/Probes": f"0.5{middle}; 1{middle}"}, {}
    return relation


def iterative(scene):
    if scene["Dimension"] == "1":
        return None
    return scene | ITERATIVE, {}


def impacts(scene):
    """On a rigid obstacle that moves, of a strip that is a rod, by the iterative solver."""
    first = scene | {"Contact/Gap": scene.get("Contact/Gap", "") + "+0.09*sin(9*t)"}
    strip = RELATIONS["strip"](first)
    return (strip[0] | ITERATIVE, {}, first) if strip and "off" in strip[0].values() else None


def free(scene):
    """Nothing moves across a body with free sides if nu = 0 and a = 0."""
    related = body({"Dimension": "2", "Mesh/Cells across": "2"})(scene)
    if related is None or scene["Model/Fields"] != "displacement":
        return None
    return related[0] | {"Model/Poisson ratio": "0", "Boundary/sides/Support": "free"}, {}


def direct(scene):
    return (scene | {"Solver/Linear solver": "direct"}, {}) if scene["Dimension"] == "1" else None


def fixed_point(scene):
    """The iteration of the paper, of its model with a soft obstacle; without matrices."""
    if not moves(scene) or not has_heat(scene) or exchange_varies(scene) or \
            scene["Contact/Condition"] not in ("none", "normal compliance"):
        return None
    left_out = ("Time/Tolerance", "Output/Period", "Contact/Damping", "Contact/Dashpot")
    paper = {key: value for key, value in scene.items() if key not in left_out} | {
        "Time/Scheme": "backward euler", "Time/Step size": "0.005", "Model/Inertia": "1",
        "Time/Start": "consistent"} | (
        {"Contact/Compliance": "1"} if "Contact/Compliance" in scene else {})
    without_matrices = {} if scene["Dimension"] == "1" else {"Solver/Linear solver": "iterative"}
    return paper | without_matrices | {"Solver/Step solver": "fixed point",
                                       "Solver/Fixed point tolerance": "1e-13"}, {}, paper


def base(scene):
    gap, b = scene.get("Contact/Gap", ""), scene.get("Model/Inertia", "0")
    if "t" not in gap or "Boundary/left/Displacement" in scene:
        return None
    at_rest, motion = re.fullmatch(r"(0\.08)\+(.*)", gap).groups()  # 0.02*cos(4*t)
    first = scene
    if b != "0":
        steps = ("Time/Scheme", "Time/Step size", "Time/Start")
        first = {key: value for key, value in scene.items() if key not in steps} | {
            "Time/Tolerance": "1e-5", "Contact/Massless nodes": "off"}
    force = {"Sources/Body force": first.get("Sources/Body force", "0") + f"+{b}*0.32*cos(4*t)"}
    return first | (force if b != "0" else {}) | {
        "Contact/Gap": f"{at_rest}+0.02", "Boundary/left/Displacement": f"0.02-{motion}"}, \
        dict.fromkeys(("displacement_end", "displacement_mid", "velocity_end", "work", "energy",
                       "numerical_dissipation", "dissipation")), first


def conserving(scene):
    """Without contact, where a first event later by a step is another motion."""
    if scene["Dimension"] != "1" or scene.get("Model/Inertia", "0") == "0" or \
            exchange_varies(scene) or "Boundary/left/Displacement" in scene:
        return None
    bare = {key: value for key, value in scene.items() if not key.startswith((
        "Contact/", "Time/Scheme", "Time/Start", "Time/Step size", "Time/Tolerance",
        "Output/Period"))} | {"Contact/Condition": "none"}
    return bare | {"Time/Scheme": "energy conserving", "Time/Step size": "0.002"}, {
        "numerical_dissipation": None}, bare | {"Time/Tolerance": "1e-5"}


def alone(scene):
    """Nothing acts on the temperature."""
    if not (has_heat(scene) and moves(scene)) or exchange_varies(scene) or \
            "Time/Tolerance" in scene or scene.get("Time/Scheme") == "box":
        return None
    both = {key: value for key, value in scene.items() if not key.startswith("Contact/")} | {
        "Model/Thermoelastic heating": "false", "Contact/Condition": "none"}
    heat = {key: value for key, value in scene.items() if not key.startswith((
        "Contact/", "Model/", "Time/Start", "Boundary/sides/Support", *MECHANICAL))}
    mechanical = dict.fromkeys(LENGTHS + UNSIGNED + ENERGIES + (
        "in_contact", "contact_area", "velocity_end"), None)
    return heat | {"Model/Fields": "temperature"}, mechanical, both


def rear(scene):
    if not moves(scene) or scene["Contact/Condition"] == "none" or "Contact/Rear gap" in scene:
        return None
    exchange = scene.get("Boundary/right/Heat exchange", "0")
    if exchange in "13" and "t" not in scene.get("Boundary/right/Surroundings", "0"):
        return scene | {"Boundary/right/Heat exchange": f"{exchange}+0*pressure"}, {}
    return None if "t" in scene["Contact/Gap"] else (scene | {"Contact/Rear gap": "9"}, {})


def flight(scene):
    if not moves(scene) or scene["Model/Inertia"] == "0" or "Contact/Rear gap" in scene:
        return None
    first = {key: value for key, value in scene.items()
             if key != "Boundary/left/Displacement"} | {"Boundary/left/Support": "free"}
    if scene["Dimension"] == "1" and scene.get("Time/Scheme") not in ("box", "energy conserving"):
        first |= {"Boundary/left/Mass": "0.3", "Boundary/right/Mass": "0.2"}
    first["Initial values/Velocity"] = first.get("Initial values/Velocity", "20*x*(x-1)^2")
    other = first | {"Initial values/Velocity": f"{first['Initial values/Velocity']}+0.1"}
    if "Contact/Gap" in scene:
        other["Contact/Gap"] = f"{scene['Contact/Gap']}+0.1*t"
    return other, dict.fromkeys(("displacement_end", "displacement_mid", "velocity_end", *ENERGIES)), \
        first


def held(scene):
    """The midpoint rule of the box does not damp what a stiff spring starts; where the
    temperature begins with a layer, an exchange dissipates what its heat had."""
    drive = scene.get("Boundary/left/Temperature", "10")
    if scene.get("Time/Scheme") == "box":
        return None
    related = dict(scene)
    if has_heat(scene) and "t" not in drive and "x^2" not in scene["Initial values/Temperature"]:
        related |= {"Boundary/left/Temperature": "none", "Boundary/left/Heat exchange": "1e10",
                    "Boundary/left/Surroundings": drive}
    if moves(scene) and scene["Dimension"] == "1" and "Boundary/left/Displacement" not in scene:
        related |= {"Boundary/left/Support": "free", "Boundary/left/Spring": "1e10"}
        if scene["Model/Inertia"] == "0":
            related["Boundary/left/Dashpot"] = "1e10"
    return (related, {}) if related != scene else None


RELATIONS = {"sign": sign, "mirror": mirror, "scaled": scaled,
             "strip": body({"Dimension": "2", "Mesh/Cells across": "1"}),
             "round": body({"Dimension": "2", "Mesh/Cells across": "1",
                            "Mesh/Geometry": "axisymmetric"}),
             "block": body({"Dimension": "3", "Mesh/Cells across": "1"}),
             "iterative": iterative, "impacts": impacts, "base": base, "alone": alone,
             "rear": rear, "free": free, "direct": direct,
             "fixed point": fixed_point, "conserving": conserving,
             "flight": flight, "held": held}
SAME_STEPS = ("sign", "mirror", "scaled", "iterative", "direct")


def faults(one, other, factors, bound, is_same_method):
    a, b = one.contact, other.contact
    if len({"massless contact nodes" in run.summary["terms"] for run in (one, other)}) > 1:
        return  # "automatic" may choose otherwise
    if one.settings["Model/Fields"] == other.settings["Model/Fields"] and [
            e for e in one.events["kind"]] != [e for e in other.events["kind"]]:
        yield f"{len(one.events)} and {len(other.events)} events"
    coarsest, dofs = (other.summary[name] for name in ("factorized_unknowns", "dofs"))
    if "iterative" in other.summary["linear_solver"] and not 0 < coarsest < dofs:
        yield f"{coarsest} unknowns on the coarsest level"
    has_same_times = len(a) == len(b) and numpy.allclose(a["time"], b["time"])
    last = slice(None) if has_same_times else slice(-1, None)
    if is_same_method and one.settings.has("displacement") and not has_same_times:
        yield "other steps"
    columns = [(a, b, name, name) for name in set(a.names) & set(b.names) - set(COUNTS)] + [
        (one.probes, other.probes, name, name[:-1] + "end") for name in one.probes.names
        if name in other.probes.names and name != "time"]
    for c, d, column, name in columns:
        factor = factors.get(name, 1.)
        if factor is None or name == "step_size" and last.start == -1:
            continue
        expected = factor * c[column]
        both = [name for name in (ENERGIES if name in ENERGIES else [name]) if name in a.names]
        scale = max(numpy.nanmax(abs(factor * a[of]), initial=0) for of in both) + 1e-2
        scale = max(scale, numpy.nanmax(abs(expected), initial=0))
        error = numpy.nan_to_num(abs(d[column][last] - expected[last])).max()
        if not error <= bound * scale:
            yield f"{column} differs by {error / scale:.2g}"


def compare(seed, parent):
    """Words on each relation of a scene."""
    scene = draw(seed)
    for key in ("Output/Fields interval", "Title"):
        scene.pop(key)

    def execute(name, entries):
        directory = parent / f"{name}-{seed}"
        status, _, message = run("--quiet", "--output", directory, *settings(
            f"{key}={value}" for key, value in entries.items()), parent / "x.prm")
        return Run(directory) if status == 0 else message.strip().replace("\n", ";")

    one = execute("one", scene)
    if isinstance(one, str):
        return []
    found = []
    for name, relation in RELATIONS.items():
        related = relation(scene)
        if related is None:
            continue
        other, (entries, factors, *first) = execute(name, related[0]), related
        reference = execute("first", first[0]) if first else one
        bound = {"iterative": 1e-6, "impacts": 1e-6, "held": 1e-6, "conserving": 1e-3}.get(name, 1e-8)
        if "Time/Tolerance" in entries:
            bound = max(1e-5, 1e2 * bound) if name in SAME_STEPS else max(
                bound, (1 if name == "impacts" else 50) * float(entries["Time/Tolerance"]))
        found.append((name, [run for run in (reference, other) if isinstance(run, str)] or
                      list(faults(reference, other, factors, bound, name in SAME_STEPS))))
    return [(name, seed, words) for name, words in found]


with tempfile.TemporaryDirectory() as parent:
    Path(parent, "x.prm").write_text("# defaults\n")
    results = sum(for_all(lambda seed: compare(seed, Path(parent)),
                          range(FIRST, FIRST + N)), [])
for name in RELATIONS:
    tried = [(seed, words) for other, seed, words in results if other == name]
    print(f"{name}: {'tried, ' if tried else 'not tried'}"
          f"{sum(bool(words) for _, words in tried)} differ")
for name, seed, words in results:
    if words:
        print(f"  {name} of scene {seed}: {'; '.join(words[:3])}")
sys.exit(any(words for _, _, words in results))
