#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files in SI units: every quantity by hand, and the numbers in the heads of prm/units.

ROD has numbers that are prime to each other. With E* its modulus, t_0 = rho c L^2/kappa and
Theta^2 = E* theta_ref/(rho c), entries are in units of: L lengths, t_0 times, L/t_0 velocities,
E* pressures, E*/L forces per volume, kappa Theta/L heat fluxes, kappa Theta/L^2 heat per volume,
kappa/L and kappa/L^2 exchange of the end and of the sides; temperatures above the reference are
in Theta; a stiffness s is the compliance E* A/(s L). Without a temperature t_0 = L sqrt(rho/E*).
Each is given in SI base units and in other ones. Expressions, printed by --units, are evaluated
here in the variables of the scene.
"""
import json
import math
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from program import run, settings  # noqa: E402
from run_files import Run  # noqa: E402

PRM = Path(__file__).resolve().parents[2] / "prm/units"
L, A, RHO, E, NU, ETA, ALPHA, KAPPA, C, REF = (
    0.3, 2e-4, 5000.0, 9e10, 0.25, 4e8, 1.5e-5, 40.0, 500.0, 300.0)
ROD = {"Length": ("0.3", "30 cm"), "Cross-section area": ("2e-4", "2 cm^2"),
       "Density": ("5000", "5 g/cm3"), "Young's modulus": ("9e10", "90 GPa"),
       "Viscosity": ("4e8", "0.4 GPa s"),
       "Linear expansion": ("1.5e-5", "15 um/(m K)"), "Conductivity": ("40", "40 W/(m K)"),
       "Heat capacity": ("500", "0.5 kJ/(kg K)"),
       "Reference temperature": ("300", "26.85 degC"), "Small terms": ("kept", "kept")}
faults = []


def check(name, found, expected, bound=1e-13):
    if found is None or not abs(found - expected) <= bound * abs(expected):
        faults.append(f"{name} is {found}, not {expected}")


def write(name, entries, column):
    """A file with section Rod and entries {path: (in SI base units, in others)}."""
    entries = {**{f"Rod/{key}": pair for key, pair in ROD.items()}, **entries}
    lines = []
    for path, pair in entries.items():
        section, _, entry = path.rpartition("/")
        line = f"set {entry} = {pair[column]}\n"
        lines.append(f"subsection {section}\n  {line}end\n" if section else line)
    Path(name).write_text("".join(lines), encoding="utf-8")


def entries_of(text):
    """By path, the values and what is remarked behind them."""
    section, values = "", {}
    for line in text.splitlines():
        if match := re.match(r"subsection (.*)", line):
            section = match[1] + "/"
        elif line == "end":
            section = ""
        elif match := re.match(r" *(?:# )?set (.*?) = (.*?)(?: # (.*))?$", line):
            values[section + match[1]] = match[2], match[3] or ""
    return values


def scene_of(name, *overrides):
    """By path, the values that --units prints, without remarks."""
    status, text, message = run("--units", *settings(overrides), name)
    if status != 0:
        faults.append(f"{name}: {message}")
    return {path: value for path, (value, _) in entries_of(text).items()}


def check_scene(name, entries, expected):
    """entries {path: (text, text)}, expected {path: numbers}."""
    for column in 0, 1:
        write(name, entries, column)
        found = scene_of(name)
        for path, numbers in expected.items():
            words = re.split(r" ?[;,] ", found.get(path, "nan"))
            for word, number in zip(words, numbers if isinstance(numbers, list) else [numbers]):
                check(f"{name}, {path}", float(word), number)


def check_quantities():
    t, theta = RHO * C * L**2 / KAPPA, math.sqrt(E * REF / (RHO * C))
    flux = KAPPA * theta / L
    entries = {
        "Boundary/left/Temperature": ("350", "76.85 degC", 50 / theta),
        "Boundary/right/Heat exchange": ("70", "0.007 W/(cm^2 K)", 70 * L / KAPPA),
        "Boundary/right/Surroundings": ("320", "46.85 \u00b0C", 20 / theta),
        "Boundary/sides/Heat exchange": ("900", "0.9 kW/(m^3 K)", 900 * L**2 / KAPPA),
        "Boundary/sides/Surroundings": ("290", "16.85 celsius", -10 / theta),
        "Contact/Damping": ("0.2", "0.2 ms/mm", 0.2 * L / t),
        "Contact/Dashpot": ("4e3", "4 N s/mm", 4e3 * L / (E * A * t)),
        "Contact/Gap": ("3e-4", "0.3 mm", 3e-4 / L),
        "Contact/Rear gap": ("5e-4", "500 \u00b5m", 5e-4 / L),
        "Contact/Rear compliance": ("3e-12", "3 pm/Pa", 3e-12 * E / L),
        "Contact/Rear damping": ("as in front", "as in front", None),
        "Initial values/Temperature": ("310", "36.85 degC", 10 / theta),
        "Initial values/Displacement": ("0", "0 m", 0),
        "Sources/Heat source": ("2e6", "2 MW/m^3", 2e6 * L / flux),
        "Sources/Body force": ("4e4", "40 kN/m^3", 4e4 * L / E),
        "Boundary/right/Traction": ("5e5", "5 bar", 5e5 / E),
        "Boundary/right/Heat flux": ("800", "0.08 W/cm^2", 800 / flux),
        "Time/End time": ("7200", "2 h", 7200 / t),
        "Time/First step size": ("0.03", "30 ms", 0.03 / t),
        "Time/Minimum step size": ("1e-6", "1 us", 1e-6 / t),
        "Time/Maximum step size": ("600", "10 min", 600 / t),
        "Time/Break points": ("60 ; 90", "1 min ; 90 s", [60 / t, 90 / t]),
        "Output/Contact interval": ("120", "2 min", 120 / t),
        "Output/Fields interval": ("1800", "0.5 h", 1800 / t),
        "Output/Space-time interval": ("300", "5 min", 300 / t),
        "Output/Period": ("240", "4 min", 240 / t),
        "Output/Checkpoint interval": ("600", "10 min", 600),
        "Output/Probes": ("0.1 ; 0.3", "100 mm ; 0.3 m", [0.1 / L, 1])}
    expected = {path: entry[2] for path, entry in entries.items() if entry[2]}
    check_scene("rod.prm", {**{path: entry[:2] for path, entry in entries.items()},
                            "Contact/Stiffness": ("3e7", "30 kN/mm")},
                {**expected, "Contact/Compliance": E * A / (3e7 * L),
                 "Model/Inertia": (KAPPA / (RHO * C * L))**2 * RHO / E,
                 "Model/Viscosity": ETA / (E * t), "Model/Coupling": ALPHA * theta,
                 "Scales/Length": L, "Scales/Time": t, "Scales/Stress": E, "Scales/Area": A,
                 "Scales/Temperature": theta, "Scales/Reference temperature": REF})
    # what both ends carry, and what acts on the left one
    attached = {"Spring": ("2e6", "2 kN/mm", 2e6 * L / (E * A)),
                "Dashpot": ("3e3", "3 N s/mm", 3e3 * L / (E * A * t)),
                "Mass": ("0.05", "50 g", 0.05 * L / (E * A * t**2))}
    ends = {**{f"Boundary/{end}/{path}": entry for end in ("left", "right")
               for path, entry in attached.items()},
            "Boundary/left/Temperature": ("none", "none", None),
            "Boundary/left/Support": ("free", "free", None),
            "Boundary/left/Traction": ("6e5", "0.6 N/mm^2", 6e5 / E),
            "Boundary/left/Heat flux": ("900", "0.09 W/cm^2", 900 / flux),
            "Boundary/left/Heat exchange": ("40", "0.004 W/(cm^2 K)", 40 * L / KAPPA),
            "Boundary/left/Surroundings": ("330", "56.85 degC", 30 / theta),
            "Boundary/right/Heat exchange": ("0", "0", None),
            "Initial values/Velocity": ("1e-3", "1 mm/s", 1e-3 * t / L),
            "Contact/Condition": ("none", "none", None), "Time/End time": ("7200", "2 h", None)}
    check_scene("ends.prm", {path: entry[:2] for path, entry in ends.items()},
                {path: entry[2] for path, entry in ends.items() if entry[2]})
    # a strip: the modulus of P-waves, and more expansion
    e = E * (1 - NU) / ((1 + NU) * (1 - 2 * NU))
    theta = math.sqrt(e * REF / (RHO * C))
    needed = {path: entries[path][:2] for path in (
        "Boundary/left/Temperature", "Boundary/right/Heat exchange", "Contact/Gap",
        "Time/End time")}
    check_scene("strip.prm", {**needed, "Dimension": ("2", "2"), "Rod/Poisson ratio": ("0.25", "0.25"), "Mesh/Width": ("0.06", "6 cm"),
                              "Contact/Compliance": ("2e-12", "2 pm/Pa"),
                              "Time/Step size": ("90", "1.5 min")},
                {"Mesh/Width": 0.06 / L, "Contact/Compliance": 2e-12 * e / L,
                 "Time/Step size": 90 / t, "Boundary/left/Temperature": 50 / theta,
                 "Model/Coupling": ALPHA * (1 + NU) / (1 - NU) * theta,
                 "Model/Poisson ratio": NU, "Scales/Stress": e})
    # without a temperature; Hertz's law: the penetration at which the force is E A
    wave = L * math.sqrt(RHO / E)
    check_scene("waves.prm", {"Model/Fields": ("displacement", "displacement"),
                              "Contact/Condition": ("power law", "power law"),
                              "Contact/Exponent": ("1.5", "1.5"),
                              "Contact/Stiffness": ("1e10", "1e10"),
                              "Contact/Gap": ("1e-5", "10 um"),
                              "Time/End time": ("1e-3", "1 ms")},
                {"Contact/Compliance": (E * A / 1e10)**(1 / 1.5) / L,
                 "Model/Viscosity": ETA / (E * wave), "Scales/Time": wave,
                 "Time/End time": 1e-3 / wave,
                 "Output/Fields interval": float(f"{1e-3 / wave / 20:.6g}")})
    # stiffnesses with exponents of their own, or that of section Contact
    law = {"Model/Fields": ("displacement", "displacement"),
           "Contact/Condition": ("power law", "power law"), "Contact/Exponent": ("1.5", "1.5"),
           "Contact/Stiffness": ("1e10", "1e10"), "Contact/Gap": ("1e-5", "10 um"),
           "Time/End time": ("1e-3", "1 ms")}
    check_scene("stops.prm", {**law, "Contact/Rear gap": ("1e-5", "10 um"),
                              "Contact/Rear exponent": ("1", "1"),
                              "Contact/Rear stiffness": ("2e7", "20 MN/m")},
                {"Contact/Compliance": (E * A / 1e10)**(1 / 1.5) / L,
                 "Contact/Rear compliance": E * A / 2e7 / L})
    check_scene("pair.prm", {**law, "Bodies/a/Length": ("1", "1 m"), "Bodies/b/Length": ("1", "1 m"),
                             "Contacts/a b/Stiffness": ("3e9", "3e9")},
                {"Contacts/a b/Compliance": (E * A / 3e9)**(1 / 1.5) / L})
    # a contact of another kind; no other one needs a stiffness of section Contact
    check_scene("kind.prm", {"Model/Fields": ("displacement", "displacement"), "Contact/Gap": ("1e-5", "10 um"),
                             "Boundary/right/Support": ("free", "free"), "Time/End time": ("1e-3", "1 ms"),
                             "Bodies/a/Length": ("1", "1 m"), "Bodies/b/Length": ("1", "1 m"),
                             "Contacts/a b/Condition": ("power law", "power law"),
                             "Contacts/a b/Exponent": ("1.5", "1.5"), "Contacts/a b/Stiffness": ("3e9", "3e9")},
                {"Contacts/a b/Compliance": (E * A / 3e9)**(1 / 1.5) / L})


def check_expressions():
    """Of time, place, gap and pressure; units do not change what runs."""
    t, theta = RHO * C * L**2 / KAPPA, math.sqrt(E * REF / (RHO * C))
    Path("far").mkdir(exist_ok=True)
    Path("far/load.csv").write_text("t, F\n0, 0\n1, 7e4\n", encoding="utf-8")
    write("far/drives.prm", {
        "Boundary/left/Temperature": ["300 + 50*sin(1e-2*t)"],
        "Boundary/right/Heat exchange": ["if(pressure > 2e6, 9, 7/(1 + gap/1e-5))"],
        "Boundary/left/Displacement": ["1e-5*(1 - cos(3e-3*t))"],
        "Contact/Gap": ["5e-5 + 1e-6*t/3600"], "Contact/Stiffness": ["1e9"],
        "Initial values/Temperature": ["theta_A + 2*x/0.3"],
        "Initial values/Velocity": ["1e-9*x"], "Time/End time": ["1e3"],
        "Sources/Body force": ["1e3*x*exp(-1e-3*t)"], "Rod/Small terms": ["dropped"],
        "Boundary/right/Traction": ["table(load.csv, t)"]}, 0)
    found = scene_of("far/drives.prm", "Rod/Small terms=kept")
    names = {**vars(math), "exchange": lambda is_so, a, b: a if is_so else b}
    for path, variables, by_hand in (
            ("Boundary/left/Temperature", {"t": 0.01},
             50 * math.sin(1e-2 * 0.01 * t) / theta),
            ("Boundary/right/Heat exchange", {"gap": 0, "pressure": 3e6 / E}, 9 * L / KAPPA),
            ("Boundary/right/Heat exchange", {"gap": 1e-4, "pressure": 0},
             7 / (1 + 1e-4 * L / 1e-5) * L / KAPPA),
            ("Boundary/left/Displacement", {"t": 0.01},
             1e-5 * (1 - math.cos(3e-3 * 0.01 * t)) / L),
            ("Contact/Gap", {"t": 0.02}, (5e-5 + 1e-6 * 0.02 * t / 3600) / L),
            ("Initial values/Temperature", {"x": 0.7, "theta_A": 0.01}, 0.01 + 2 * 0.7 / theta),
            ("Initial values/Velocity", {"x": 0.7}, 1e-9 * 0.7 * t),
            ("Sources/Body force", {"x": 0.7, "t": 0.03},
             1e3 * 0.7 * L * math.exp(-1e-3 * 0.03 * t) * L / E)):
        text = found.get(path, "nan").replace("if(", "exchange(")
        check(path, eval(text, names, variables), by_hand, 1e-12)


def check_missing():
    """What has no default in SI units, by the fields, the law and the dimension."""
    Path("length.prm").write_text("subsection Rod\n  set Length = 1\nend\n", encoding="utf-8")
    rod, contact = ["Cross-section area", "Density"], ["Contact/Gap", "Contact/Stiffness"]
    hot = ["Conductivity", "Heat capacity", "Reference temperature"]
    ends = ["Boundary/left/Temperature", "Boundary/right/Heat exchange"]
    row = ("Model/Fields=displacement", "Boundary/right/Support=free", "Bodies/a/Length=0.5",
           "Bodies/b/Length=0.5")
    for names, *overrides in (
            (rod + ["Young's modulus"] + hot + ["Linear expansion"] + ends + contact,),
            (rod + hot + ends, "Model/Fields=temperature"),
            # between two bodies heat is exchanged, whatever holds the right end
            (rod + hot + ends[:1], "Model/Fields=temperature", "Boundary/right/Temperature=300"),
            (rod + hot + ends, "Model/Fields=temperature", "Boundary/right/Temperature=300",
             "Bodies/a/Length=0.5", "Bodies/b/Length=0.5"),
            (rod + ["Young's modulus"] + contact, "Model/Fields=displacement"),
            (rod + ["Young's modulus", "Poisson ratio"] + contact, "Model/Fields=displacement",
             "Rod/Lateral sides=confined"),
            (rod + ["Young's modulus", "Poisson ratio"] + contact[:1] + ["Mesh/Width"],
             "Model/Fields=displacement", "Contact/Condition=rigid", "Dimension=2"),
            # two bodies that meet each other alone, with a gap and a stiffness of their own
            (rod + ["Young's modulus"], *row, "Contacts/a b/Gap=1e-4", "Contacts/a b/Stiffness=1e8"),
            (rod + ["Young's modulus"] + contact[:1], *row, "Contacts/a b/Stiffness=1e8"),
            (rod + ["Young's modulus"] + contact[1:], *row, "Contacts/a b/Gap=1e-4"),
            (rod + ["Young's modulus"] + contact, *row, "Contacts/a b/Gap=1e-4",
             "Contacts/a b/Stiffness=1e8", "Boundary/right/Support=contact"),
            (rod + ["Young's modulus"], "Model/Fields=displacement", "Contact/Condition=none")):
        names = [name if "/" in name else f"Rod/{name}" for name in names] + ["Time/End time"]
        message = run("--units", *settings(overrides), "length.prm")[2]
        told = re.findall(r"^(.*) is not given\n  allowed: .+\n  meaning: .+\n  remedy:  give it: a "
                          "scene in SI units has no default of it$", message, re.M)
        if told != names or not message.startswith(f"{len(names)} faults\n"):
            faults.append(f"{overrides}: not given are {names}, {message}")


def check_choices():
    """Small terms, dropped in runs of more than 1e5 of their times without a motion that is
    given; units of time that are given or make numbers of ten or more."""
    wave, relaxing = L * math.sqrt(RHO / E), ETA / E
    write("choices.prm", {
        "Boundary/left/Temperature": ["350"], "Boundary/right/Heat exchange": ["70"],
        "Contact/Gap": ["3e-4"], "Contact/Stiffness": ["3e7"], "Time/End time": ["1"],
        "Rod/Small terms": ["automatic"]}, 0)
    long = f"Time/End time={1e9 * wave}"
    for path, value, *overrides in (
            ("Model/Inertia", "kept", f"Time/End time={0.99e5 * wave}"),
            ("Model/Inertia", "0", f"Time/End time={1.01e5 * wave}"),
            ("Model/Viscosity", "kept", f"Time/End time={0.99e5 * relaxing}"),
            ("Model/Viscosity", "0", f"Time/End time={1.01e5 * relaxing}"),
            ("Model/Inertia", "kept", long, "Initial values/Velocity=1e-9*x"),
            ("Model/Inertia", "kept", long, "Contact/Rear gap=1"),
            ("Model/Inertia", "kept", long, "Boundary/left/Displacement=1e-9*t"),
            ("Model/Inertia", "0", long, "Contact/Rear gap=none"),
            ("Model/Inertia", "0", long, "Boundary/left/Displacement=0"),
            ("Scales/Time unit", "s", "Time/End time=10.1"),
            ("Scales/Time unit", "ms", "Time/End time=9.9"),
            ("Scales/Time unit", "ms", "Time/End time=1.01e-5"),
            ("Scales/Time unit", "us", "Time/End time=9.9e-6"),
            ("Scales/Time unit", "h", "Time/End time=0.1 h"),
            ("Scales/Time unit", "s", "Time/End time=2 weeks"),
            ("Scales/Temperature unit", "K", "Rod/Reference temperature=300 K"),
            ("Scales/Temperature unit", "C", "Rod/Reference temperature=27 degC")):
        default = "K" if "Temp" in path else "s"
        found = scene_of("choices.prm", *overrides).get(path, default)
        if found == "0" if value == "kept" else found != value:
            faults.append(f"{path} is {found} with {overrides}")


def check_twins(stem, *end):
    """The printed scene, and used.prm, run as the file does; each has the values of the
    other, which are given, as remarks, and used.prm as remarks those that are not."""
    file = PRM / f"{stem}.prm"
    scene = run("--units", *settings(end), file)[1]
    Path("twin.prm").write_text(scene, encoding="utf-8")
    tables = []
    for name, path in (("si", file), ("scene", "twin.prm"), ("used", "si/used.prm")):
        status, _, message = run("--output", name, *settings(end if path == file else ()), path)
        if status != 0:
            faults.append(f"{name}: {message}")
        tables.append(Path(name, "contact.csv").read_bytes())
    if tables[0] != tables[1] or tables[0] != tables[2]:
        faults.append("a scene without units, or used.prm, is another one")
    used = entries_of(Path("si/used.prm").read_text(encoding="utf-8"))
    for path, (value, given) in entries_of(scene).items():
        if used.get(path) != ((given, value) if given else (value, "")):
            faults.append(f"{path} = {value} # {given} is {used.get(path)} in used.prm")


def results(name, *overrides):
    status, _, message = run("--output", name, *settings(overrides), PRM / f"{name}.prm")
    if status != 0:
        faults.append(f"{name}: {message}")
    return Run(name)


def last(run_, column):
    return run_.contact[column][-1]


def check_heads():
    """The numbers in the heads, six digits; a run is at rest to 1e-7 or so."""
    steel = results("steel-rod")
    check("steel, force", last(steel, "contact_force"), 7108.48, 1e-6)
    check("steel, end", last(steel, "temperature_end"), 71.5973, 1e-6)
    check("steel, penetration", last(steel, "penetration"), 71.0848e-6, 1e-6)
    actuator = results("micro-actuator")
    check("actuator, force", last(actuator, "contact_force"), 155.807e-6, 3e-6)
    check("actuator, end", last(actuator, "temperature_end"), 480, 1e-6)
    hot = results("radiating-rod")
    check("radiation, end", last(hot, "temperature_end"), 696.7603, 1e-6)
    check("radiation, heat", last(hot, "heat_flux_end"), 10323.97, 1e-6)
    check("radiation, way", last(hot, "displacement_end"), 1.524492e-3, 1e-6)
    hours, entered, left = (hot.tables["boundaries.csv"][n] for n in ("time", "heat_left", "heat_right"))
    hour = -2  # steps are hours long at last
    for heat in (entered, -left):
        check("radiation, heat in the end", (heat[-1] - heat[hour]) / (hours[-1] - hours[hour]), 3716.63, 1e-6)
    switch = Run("si")  # of check_all_twins()
    check("switch, force", last(switch, "contact_force"), 1727.10, 3e-6)
    check("switch, end", last(switch, "temperature_end"), 20 + 21.0564, 3e-6)
    check("switch, heat", last(switch, "heat_flux_end"), 374193, 3e-6)
    study = results("stop-design", "Contact/Damping=0",
                    "Study/Vary=Contact/Stiffness = 1e7 | 0.1 GN/m | 1e9 N/m")
    table = study.tables["study.csv"]
    check("stiffnesses", sum(float(s) for s in table["Contact/Stiffness"]), 1.11e9)
    # kinks of waves, and a tolerance of 1e-5
    for force, by_hand in zip(table["max_contact_force"], (418.152, 1982.88, 3512.57)):
        check("study, force", float(force), by_hand, 1e-3)
    gaps = results("stop-design", "Contact/Damping=0", "Time/End time=1 us",
                   "Study/Vary=Contact/Gap = 0.1 mm .. 0.3 mm (3)").tables["study.csv"]["Contact/Gap"]
    check("gaps of a range", max(abs(float(gap) - at) for gap, at in zip(gaps, (1e-4, 2e-4, 3e-4))) + 1, 1, 1e-12)
    results("shaken-rod", "Study/Vary=Constants/frequency = 1700")
    ends = Run("shaken-rod/run-0").tables["poincare.csv"]["displacement_end"]
    check("shaken rod", ends[-1], -0.856131e-6, 3e-6)
    # a base that moves by B (1 - cos(2 pi f t)): until its wave has come back, d'Alembert's end
    # is at twice that L/c later; waves are adiabatic, c^2 = (1 + a^2) E/rho, a^2 = E alpha^2 T/(rho C)
    stop = results("hertzian-stop", "Time/End time=0.5 ms")
    d, v, force = (stop.contact[n] for n in ("penetration", "velocity_end", "contact_force"))
    law = 1.54e10 * d**1.5 * (1 + 0.15 * v)
    check("stop, force", 1 + max(abs(force - law)) / max(law), 1, 1e-9)
    wave = math.sqrt((1 + 2.1e11 * 12e-6**2 * 293.15 / (7850 * 440)) * 2.1e11 / 7850)
    check("stop, first contact", stop.events["time"][0],
          1e3 * 0.2 / wave + math.acos(1 - 5 / 40) / (4 * math.pi), 1e-3)
    block = results("curved-stop", "Mesh/Cells=16")
    force, pressure = last(block, "contact_force") / 0.01, last(block, "max_pressure")
    check("block, pressure", pressure, math.sqrt(force * 2.1e11 / 0.91 / (math.pi * 0.1)), 0.05)
    width = 4 * math.sqrt(force * 0.1 / (math.pi * 2.1e11 / 0.91))
    check("block, width", last(block, "contact_area") * 0.01, width, 0.15)


def check_other_rods():
    """A study over what the scales follow from has the numbers of single runs; between
    rods no errors are measured."""
    file = PRM / "thermal-switch.prm"
    rods = ["Rod/Young's modulus=35 GPa", "Rod/Conductivity=220", "Rod/Length=120 mm",
            "Rod/Density=5400", "Rod/Cross-section area=2 cm^2",
            "Rod/Reference temperature=30 degC"]
    study = "Study/Vary=" + " ;; ".join(rods)
    status, _, message = run("--output", "rods", *settings((study,)), file)
    if status != 0:
        faults.append(f"study of rods: {message}")
    table = Run("rods").tables["study.csv"]
    for number, rod in enumerate(rods):
        run("--output", "alone", *settings((rod,)), file)
        alone = json.loads(Path("alone/summary.json").read_text(encoding="utf-8"))
        names = [name for name in table.names if isinstance(alone.get(name), float) and
                 "seconds" not in name]
        if len(names) < 7:
            faults.append(f"study of rods has {names} alone")
        for name in names:
            check(f"{rod}, {name}", table[name][number], alone[name], 1e-12)
    study = settings(("Study/Vary=Rod/Density = 5400", "Study/Reference=Time/Tolerance = 1e-7"))
    status, _, message = run("--output", "rods", *study, file)
    if status != 2 or "makes another rod" not in message:
        faults.append(f"errors between rods: {message}")


def check_end_times():
    """A rod that is pressed from the start on is in contact up to the end: all rows of a study
    have the unit of the file, also where a run alone would have s or ms."""
    write("ends.prm", {
        "Boundary/left/Temperature": ["350"], "Boundary/right/Heat exchange": ["70"],
        "Contact/Gap": ["-3e-4"], "Contact/Stiffness": ["3e7"], "Time/End time": ["1 h"],
        "Rod/Small terms": ["dropped"], "Study/Vary": ["Time/End time = 9 | 11"]}, 0)
    status, _, message = run("--output", "ends", "ends.prm")
    if status != 0:
        faults.append(f"study of end times: {message}")
    for found, seconds in zip(Run("ends").tables["study.csv"]["contact_duration"], (9, 11)):
        check("time in contact in h", found, seconds / 3600, 1e-12)


def check_doubts():
    """A number that hardly is in SI base units; an exponent that is none, beside a unit."""
    screen = run("--check", "--output", "doubts", "--set", "Rod/Density=7.85",
                 PRM / "steel-rod.prm")[1]
    if "doubt     Rod/Density = 7.85: is that in kg/m^3, or 7.85 g/cm^3?" not in screen:
        faults.append(f"no doubt of a density of 7.85: {screen}")
    # a gap of more than a tenth of the rod; a rod of steel that meets a wall with v has the
    # strain v/c, c = sqrt(E (1 + a^2)/rho) = 5172 m/s: 5.1 m/s are below 1e-3, 7 m/s above,
    # and what arrives at t is v (1 - c t/L), at t = 10 um/(7 m/s) 0.9926 of it:
    # 6.948/5172 = 1.34e-3
    for entry in ("Contact/Gap", "Contact/Rear gap"):
        for gap, doubts in (("0.11 m", [f"{entry} = 0.11 m: that is 11 % of Rod/Length, and the "
                                        "model is one of small strains"]), ("0.09 m", [])):
            screen = run("--check", "--output", "doubts", "--set", f"{entry}={gap}",
                         PRM / "steel-rod.prm")[1]
            if re.findall("^  doubt     (.*)$", screen, re.MULTILINE) != doubts:
                faults.append(f"doubts of {entry} = {gap}: {screen}")
    for velocity, doubts in ((5.1, []), (7, [
            "the peak force is a strain of 0.0013: most metals yield there, and the model does not"])):
        screen = run("--output", "doubts", *settings((f"Initial values/Velocity={velocity}*x",)),
                     PRM / "steel-impact.prm")[1]
        if re.findall("^  doubt     (.*)$", screen, re.MULTILINE) != doubts:
            faults.append(f"doubts of {velocity} m/s: {screen}")
    message = run("--check", *settings(("Contact/Condition=power law", "Contact/Exponent=high",
                                        "Contact/Stiffness=1e8 N/m")), PRM / "steel-rod.prm")[2]
    if not message.startswith("Contact/Exponent = high\n"):
        faults.append(f"an exponent that is none: {message}")
    # of N/m^m with another m no number of section Contact is one
    for more, refused in (("Contact/Rear exponent=1", True), ("Contact/Rear exponent=1.5", False),
                          ("Contact/Rear stiffness=1e8", False)):
        status, _, message = run("--check", *settings((
            "Contact/Condition=power law", "Contact/Exponent=1.5", "Contact/Stiffness=1e10", "Contact/Rear gap=1 mm",
            more, *("Contact/Rear exponent=1",) * (more[-1] == "8"))), PRM / "steel-rod.prm")
        if (status == 2 and "remedy:  Contact/Rear stiffness = a number" in message) != refused or \
                (status == 0) == refused:
            faults.append(f"{more}: {message}")


def check_all_twins():
    # the second has a body whose entries are all defaults
    check_twins("hammer", "Time/End time=0.02 ms")
    check_twins("thermal-switch")


for checks in (check_quantities, check_expressions, check_missing, check_choices, check_all_twins,
               check_heads, check_other_rods, check_end_times, check_doubts):
    checks()
print("\n".join(faults) or "as by hand")
