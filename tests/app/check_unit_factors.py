#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""All that --units prints, line by line, computed from the SI values.

A rod whose sides cannot move has lambda + 2 mu instead of E, and expands by
(3 lambda + 2 mu) alpha/(lambda + 2 mu) instead of alpha, with Lame's constants
lambda and mu. With that stiffness M and expansion beta, the diffusivity
D = kappa/(rho c), and Theta the temperature above the reference at which
M (beta Theta)^2 = beta^2 M^2 theta_ref/(rho c):
  unit of time L^2/D, b = (D/L)^2 rho/M, zeta = eta D/(L^2 M), a = beta Theta,
  k = h L/kappa, epsilon = (M A/L)/stiffness.
A stiffness in N/m^m has epsilon = (M A/stiffness)^(1/m)/L, a damping in s/m
c = damping L/(L^2/D), sides m = h P/(A rho c) L^2/D with their perimeter P.
Terms below 1e-6 are dropped unless they are to be kept. Then each number is
falsified once: the comparison must notice. At last each line of the file is left out: that
is refused, but for the title and the two that choose.
"""
import math
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from program import run  # noqa: E402

# All values differ, so that none can stand for another. Copper-like.
ROD = dict(L=0.3, A=2e-5, rho=8900.0, E=1.2e11, nu=0.34, sides="free", eta=7e3,
           alpha=17e-6, kappa=390.0, c=385.0, ref=290.0, initial=310.0,
           fixed=350.0, obstacle=270.0, gap=1e-4, rear=None, stiffness=3e7, h=900.0,
           t=500.0, small="dropped", v=0.0, force=0.0, power=0.0,
           force_time=math.inf, power_time=math.inf, time_unit=None, celsius=False,
           m=1.0, damping=0.0, h_sides=0.0, perimeter=0.05, around=285.0,
           base=None, gap_in_time=None, fixed_in_time=None, obstacle_in_time=None)
SECONDS = {"ms": 1e-3, "min": 60.0}


def scaled(**other):
    """A rod with inertia b and viscosity zeta as given, by L and eta."""
    rod = {**ROD, **other}
    diffusivity = rod["kappa"] / (rod["rho"] * rod["c"])
    if "b" in rod:
        rod["L"] = diffusivity * math.sqrt(rod["rho"] / (modulus(rod) * rod["b"]))
    if "zeta" in rod:
        rod["eta"] = rod["zeta"] * rod["L"]**2 * modulus(rod) / diffusivity
    return rod


def lame(rod):
    E, nu = rod["E"], rod["nu"]
    return E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))


def modulus(rod):
    lamda, mu = lame(rod)
    return lamda + 2 * mu if rod["sides"] == "confined" else rod["E"]


def expansion(rod):
    lamda, mu = lame(rod)
    return rod["alpha"] * ((3 * lamda + 2 * mu) / (lamda + 2 * mu)
                           if rod["sides"] == "confined" else 1)


CONFINED = dict(sides="confined")
RODS = {
    "free": ROD,
    "free, kept": {**ROD, "small": "kept"},
    "free, rigid": {**ROD, "stiffness": "infinity"},
    "free, no heat exchange": {**ROD, "h": 0.0},
    "confined": {**ROD, **CONFINED},
    "confined, kept, rigid, shrinks": {
        **ROD, **CONFINED, "small": "kept", "stiffness": "infinity",
        "alpha": -3e-6, "gap": -2e-5},
    # on both sides of 1e-6
    "confined, b kept": scaled(**CONFINED, b=1.001e-6, zeta=0.999e-6),
    "confined, zeta kept": scaled(**CONFINED, b=0.999e-6, zeta=1.001e-6),
    "free, both kept": scaled(b=1.001e-6, zeta=1.001e-6),
    # of loads only one ends before the run; times and temperatures as people have them
    "heated and pulled": {**ROD, "power": 3.0, "power_time": 120.0, "force": -2e5,
                          "force_time": 600.0, "time_unit": "min", "celsius": True},
    "pushed twice": {**ROD, "power": 3.0, "power_time": 120.0, "force": 2e5,
                     "force_time": 60.0, "v": 0.4},
    "thrown": {**ROD, "v": 0.4, "t": 2e-3, "time_unit": "ms", **CONFINED},
    "thrown, in ms by itself": {**ROD, "v": -0.4, "t": 2e-3},
    "thrown, damped": {**ROD, "v": 0.4, "t": 2e-3, "small": "kept"},
    "thrown between stops": {**ROD, "v": 0.4, "t": 2e-3, "small": "kept", "rear": 3e-5},
    "thrown between stops, elastic": {**ROD, "v": 0.4, "t": 2e-3, "rear": 3e-5},
    "heated between stops": {**ROD, "rear": 3e-5},
    # Hertz and Hunt-Crossley, in N/m^1.5 and s/m, and sides that lose heat
    "thrown at a rounded stop": {**ROD, "v": 0.4, "t": 2e-3, "m": 1.5,
                                 "stiffness": 2e10, "damping": 0.3},
    "damped, cooled": {**ROD, **CONFINED, "damping": 7.0, "h_sides": 12.0},
    # expressions in the units of the file
    # inertia by the obstacle alone, in runs of less than 1e5 waves, sqrt(rho/E) L each
    **{f"before an obstacle that moves, {n} waves": {
        **ROD, "gap_in_time": "1e-4*cos(0.02*t)", "t": n * math.sqrt(8900.0 / 1.2e11) * 0.3}
       for n in (0.999e5, 1.001e5)},
    "driven": {**ROD, "time_unit": "ms", "celsius": True, "t": 2e-3, "v": 0.4,
               "h_sides": 12.0, "base": "2e-6*sin(3*t)", "gap_in_time": "7e-6+4e-6*cos(2*t)",
               "fixed_in_time": "40+9*cos(5*t)", "obstacle_in_time": "if(t<1,30,50)"},
}


def duration(rod, seconds):
    return "infinity" if seconds == math.inf else repr(
        seconds / SECONDS.get(rod["time_unit"], 1.0))


def shown(rod, kelvin):
    """A temperature in the unit of the file."""
    return kelvin - 273.15 * rod["celsius"]


def loads(rod):
    if not (rod["v"] or rod["power"] or rod["force"]):
        return ""
    base = f"  set Base motion = {rod['base']}\n" if rod["base"] else ""
    return f"""subsection Loads
{base}  set Initial velocity = {rod["v"]!r}
  set Body force = {rod["force"]!r}
  set Body force duration = {duration(rod, rod["force_time"])}
  set Heater power = {rod["power"]!r}
  set Heater duration = {duration(rod, rod["power_time"])}
end
"""


def rear_gap(rod):
    return "" if rod["rear"] is None else f"\n  set Rear gap = {rod['rear']!r}"


def si_file(rod):
    unit = f"  set Unit = {rod['time_unit']}\n" if rod["time_unit"] else ""
    degrees = "  set Unit = C\n" if rod["celsius"] else ""
    around = (f"  set Surroundings = {shown(rod, rod['around'])!r}\n"
              if rod["h_sides"] else "")
    law = (f"  set Exponent = {rod['m']!r}\n  set Damping = {rod['damping']!r}\n"
           if rod["m"] != 1 or rod["damping"] else "")
    sides = f"""subsection Sides
  set Exchange coefficient = {rod["h_sides"]!r}
  set Perimeter = {rod["perimeter"]!r}
end
""" if rod["h_sides"] else ""
    return f"""set Title = rod
set Small terms = {rod["small"]}
subsection Rod
  set Length = {rod["L"]!r}
  set Cross-section area = {rod["A"]!r}
  set Density = {rod["rho"]!r}
  set Young's modulus = {rod["E"]!r}
  set Poisson ratio = {rod["nu"]!r}
  set Lateral sides = {rod["sides"]}
  set Viscosity = {rod["eta"]!r}
  set Linear expansion = {rod["alpha"]!r}
  set Conductivity = {rod["kappa"]!r}
  set Heat capacity = {rod["c"]!r}
end
subsection Temperatures
{degrees}  set Reference = {shown(rod, rod["ref"])!r}
  set Initial = {shown(rod, rod["initial"])!r}
  set Fixed end = {rod["fixed_in_time"] or repr(shown(rod, rod["fixed"]))}
  set Obstacle = {rod["obstacle_in_time"] or repr(shown(rod, rod["obstacle"]))}
{around}end
subsection Obstacle
  set Gap = {rod["gap_in_time"] or repr(rod["gap"])}{rear_gap(rod)}
  set Stiffness = {rod["stiffness"]}
{law}  set Exchange coefficient = {rod["h"]!r}
end
{sides}{loads(rod)}subsection Time
{unit}  set End time = {duration(rod, rod["t"])}
end
"""


def scales(rod):
    """D, L^2/D and Theta."""
    capacity = rod["rho"] * rod["c"]
    diffusivity = rod["kappa"] / capacity
    return (diffusivity, rod["L"]**2 / diffusivity,
            math.sqrt(modulus(rod) * rod["ref"] / capacity))


def expected_comments(rod):
    """What is printed first: lines with {} for numbers, and the numbers."""
    L, A, M, kappa = rod["L"], rod["A"], modulus(rod), rod["kappa"]
    diffusivity, time, Theta = scales(rod)
    yield "# One unit of the scene is",
    yield "# length, displacement {} m", L
    yield "# time {} s", time
    yield "# temperature above the reference {} K", Theta
    yield "# velocity {} m/s", diffusivity / L
    yield "# stress, pressure {} Pa", M
    yield "# force {} N", M * A
    yield "# heat flux {} W/m^2", kappa * Theta / L
    yield "# energy {} J", M * A * L
    yield "#",
    yield "# Columns of contact.csv in SI units: multiply those of Output/SI = false by",
    yield "# time, step_size {} s", time
    yield "# displacement_*, gap, penetration {} m", L
    yield "# velocity_end {} m/s", diffusivity / L
    yield "# stress_end {} Pa", M
    yield "# contact_force {} N", M * A
    yield "# contact_impulse {} N s", M * A * time
    yield "# temperature_*, then add {} {} K", rod["ref"], Theta
    yield "# heat_flux_end {} W/m^2", kappa * Theta / L
    yield "# energy, work, *dissipation {} J", M * A * L
    yield "",


def expected_scene(rod):
    """What is printed then."""
    L, M = rod["L"], modulus(rod)
    diffusivity, time, Theta = scales(rod)
    yield "set Title = rod",
    yield "subsection Model",
    kept = {}
    for entry, symbol, value in (
            ("Inertia", "b", (diffusivity / L)**2 * rod["rho"] / M),
            ("Viscosity", "zeta", rod["eta"] * diffusivity / (L**2 * M))):
        kept[symbol] = rod["small"] == "kept" or value >= 1e-6 or (
            symbol == "b" and bool(rod["v"] or rod["base"] or rod["rear"] or (
                rod["gap_in_time"] and rod["t"] <= 1e5 * math.sqrt(rod["rho"] / M) * L)))
        if kept[symbol]:
            yield f"set {entry} = {{}} # {symbol}", value
        else:
            yield (f"set {entry} = {{}} # {symbol} = {{}}, dropped; kept by Small "
                   "terms = kept"), 0, value
    yield "set Coupling = {} # a", expansion(rod) * Theta
    yield "end",
    yield "subsection Boundary",
    degree = "\u00b0C" if rod["celsius"] else "K"
    yield expected_temperature(rod, "Fixed end temperature", "theta_A", "fixed")
    if rod["base"]:
        yield expected_length(rod, "Fixed end displacement", "u_A", "base")
    yield "set Heat exchange = {} # k", rod["h"] * L / rod["kappa"]
    if rod["h"] > 0:
        yield expected_temperature(rod, "Obstacle temperature", "theta_obs", "obstacle")
    if rod["h_sides"] > 0:
        # what the sides take from a length dx, over what it holds, per time L^2/D
        yield ("set Lateral heat exchange = {} # m",
               rod["h_sides"] * rod["perimeter"] / (rod["A"] * rod["rho"] * rod["c"])
               * time)
        yield (f"set Ambient temperature = {{}} # theta_inf; {{}} {degree}",
               (rod["around"] - rod["ref"]) / Theta, shown(rod, rod["around"]))
    yield "end",
    yield "subsection Contact",
    if rod["stiffness"] == "infinity":
        yield "set Condition = rigid",
    else:
        power = rod["m"]
        if power != 1:
            yield "set Condition = power law",
        # the penetration over L at which stiffness * penetration^m is M A
        yield ("set Compliance = {} # epsilon; {} N/m" + f"^{power}" * (power != 1),
               (M * rod["A"] / rod["stiffness"])**(1 / power) / L, rod["stiffness"])
        if power != 1:
            yield "set Exponent = {} # m", power
        if rod["damping"]:
            yield ("set Damping = {} # c; {} s/m", rod["damping"] * L / time,
                   rod["damping"])
    if rod["gap_in_time"]:
        yield expected_length(rod, "Gap", "g", "gap_in_time")
    else:
        yield "set Gap = {} # g; {} m", rod["gap"] / L, rod["gap"]
    if rod["rear"] is not None:
        yield "set Rear gap = {} # g_2; {} m", rod["rear"] / L, rod["rear"]
    yield "end",
    yield "subsection Initial values",
    yield (f"set Temperature = {{}} # theta_0; {{}} {degree}",
           (rod["initial"] - rod["ref"]) / Theta, shown(rod, rod["initial"]))
    if kept["b"] or kept["zeta"]:
        yield "set Displacement = {}", 0
    if kept["b"] and rod["v"]:
        yield ("set Velocity = {}*x # u_1; {} m/s at x = {}",
               rod["v"] * L / diffusivity, rod["v"], 1)
    elif kept["b"]:
        yield "set Velocity = {}", 0
    yield "end",
    yield from expected_loads(rod)
    unit = rod["time_unit"] or "s"
    yield "subsection Time",
    yield (f"set End time = {{}} # T; {{}} {unit}", rod["t"] / time,
           rod["t"] / SECONDS.get(unit, 1))
    ends = [rod[name] / time for name in ("power_time", "force_time")
            if rod[name] < rod["t"]]
    if ends:
        yield "set Break points = " + " ; ".join("{}" for _ in ends), *ends
    wave = math.sqrt(rod["rho"] / M) * L  # seconds
    if (rod["v"] and not kept["zeta"] and rod["t"] < 100 * wave and rod["m"] == 1
            and not rod["damping"] and not rod["base"] and not rod["rear"]):
        yield "set Scheme = energy conserving",
        yield "set Step size = {}", wave / time / 2000
        yield "end",
        yield "subsection Mesh",
        yield "set Cells = {}", 2000
        yield "set Degree = {}", 1
        yield "set Mass matrix = midpoint",
    yield "end",
    yield "subsection Output",
    yield "set Fields interval = {}", float(f"{rod['t'] / time / 20:.6g}")
    yield "end",
    yield "subsection Scales",
    yield "set Length = {} # m", L
    yield "set Time = {} # s", time
    yield "set Stress = {} # Pa", M
    yield "set Area = {} # m^2", rod["A"]
    yield "set Temperature = {} # K", Theta
    yield "set Reference temperature = {} # K", rod["ref"]
    yield "set Time unit = " + (rod["time_unit"] or ("s" if rod["t"] > 10 else "ms")),
    yield "set Temperature unit = " + ("C" if rod["celsius"] else "K"),
    yield "end",


NUMBER = r"(?<![\w.])\d[\d.]*(?:e[+-]?\d+)?"


def escaped(expression):
    """With {} for each of its numbers."""
    return re.sub(NUMBER, "{}", expression)


def in_scene_time(rod, expression):
    return re.sub(r"\bt\b", "({}*t)", escaped(expression))


def numbers_of(rod, expression, is_scaled=True):
    """Its numbers in order, and, in scene time, the factor of each t."""
    factor = scales(rod)[1] / SECONDS.get(rod["time_unit"], 1.0)
    for match in re.finditer(NUMBER + (r"|\bt\b" if is_scaled else ""), expression):
        yield factor if match[0] == "t" else float(match[0])


def expected_length(rod, entry, symbol, name):
    """An expression, in the scene and in the file."""
    return (f"set {entry} = ({in_scene_time(rod, rod[name])})/{{}} # {symbol}; "
            f"{escaped(rod[name])} m, t in {rod['time_unit'] or 's'}",
            *numbers_of(rod, rod[name]), rod["L"], *numbers_of(rod, rod[name], False))


def expected_temperature(rod, entry, symbol, name):
    """A number or an expression, in the scene and in the file."""
    Theta = scales(rod)[2]
    degree = "\u00b0C" if rod["celsius"] else "K"
    expression = rod[name + "_in_time"]
    if not expression:
        return (f"set {entry} = {{}} # {symbol}; {{}} {degree}",
                (rod[name] - rod["ref"]) / Theta, shown(rod, rod[name]))
    return (f"set {entry} = (({in_scene_time(rod, expression)}) - ({{}}))/{{}} # "
            f"{symbol}; {escaped(expression)} {degree}, t in {rod['time_unit']}",
            *numbers_of(rod, expression), shown(rod, rod["ref"]), Theta,
            *numbers_of(rod, expression, False))


def expected_loads(rod):
    """Power over volume and heat capacity, force over stiffness; until they end."""
    diffusivity, time, Theta = scales(rod)
    volume, capacity = rod["A"] * rod["L"], rod["rho"] * rod["c"]
    if not (rod["power"] or rod["force"]):
        return
    yield "subsection Sources",
    for entry, symbol, value, given, end, unit in (
            ("Heat source", "q", rod["power"] / volume * time / (capacity * Theta),
             rod["power"], rod["power_time"], "W"),
            ("Body force", "f", rod["force"] * rod["L"] / modulus(rod),
             rod["force"], rod["force_time"], "N/m^3")):
        if end < rod["t"]:
            yield (f"set {entry} = if(t < {{}}, {{}}, {{}}) # {symbol}; {{}} {unit}",
                   end / time, value, 0, given)
        else:
            yield f"set {entry} = {{}} # {symbol}; {{}} {unit}", value, given
    yield "end",


def differences(text, expected):
    """Lines of text that are not as expected. 12 digits are printed."""
    lines = text.splitlines()
    found = [f"{len(lines)} lines"] if len(lines) != len(expected) else []
    for line, (pattern, *numbers) in zip(lines, expected):
        match = re.fullmatch(
            re.escape(pattern).replace(r"\{\}", r"(\S+?)"),
            re.sub(" +", " ", line.strip()))
        if not match or not all(
                abs(float(value) - number) <= 1e-11 * abs(number)
                for value, number in zip(match.groups(), numbers)):
            found.append(f"{line.strip()}, expected {pattern.format(*numbers)}")
    return found


def falsified(text):
    """The text with each of its numbers, in turn, off by a millionth."""
    for match in re.finditer(r"(?<=[ =(+/,<*])-?\d[\d.]*(e[+-]?\d+)?(?=[ ,\n*+)/;])", text):
        wrong = repr(float(match[0]) * (1 + 1e-6) or 1e-6)
        yield text[:match.start()] + wrong + text[match.end():]


def answer(si_text):
    Path("rod.prm").write_text(si_text, encoding="utf-8")
    result = run("--units", "rod.prm")
    Path("rod.prm").unlink()
    return result


def left_out():
    """The entries without which a file is accepted; wrong words for the others."""
    lines, accepted, section = si_file(ROD).splitlines(keepends=True), [], ""
    for i, line in enumerate(lines):
        section = (line.split()[1] + "/" if line.startswith("subsection") else
                   "" if line == "end\n" else section)
        if " = " not in line:
            continue
        entry = section + re.search(r"set (.*?) =", line)[1]
        status, _, message = answer("".join(lines[:i] + lines[i + 1:]))
        if status == 0:
            accepted.append(entry)
        elif status != 2 or not message.startswith(f"rod.prm: {entry} is not given\n"):
            accepted.append(f"{entry}: {status}, {message}")
    return accepted


def main():
    faults, n_blind = [], 0
    for name, rod in RODS.items():
        status, text, message = answer(si_file(rod))
        expected = [*expected_comments(rod), *expected_scene(rod)]
        if status != 0:
            faults.append(f"{name}: {message}")
            continue
        faults += [f"{name}: {fault}" for fault in differences(text, expected)]
        noticed = [len(differences(wrong, expected)) for wrong in falsified(text)]
        n_numbers = sum(len(numbers) for _, *numbers in expected)
        n_blind += noticed.count(0) + abs(n_numbers - len(noticed))
    print("lines of --units:", "; ".join(faults) or "as by hand")
    print("numbers whose fault is not noticed:", n_blind)

    print("may be left out:", ", ".join(left_out()))
    for old, new in (("  set Density = 8900.0\n", ""),
                     ("Stiffness = 30000000.0", "Stiffness = 0"),
                     ("Initial = 310.0", "Initial = 20"),
                     ("Initial = 310.0", "Initial = -20\n  set Unit = K"),
                     ("Unit = s", "Unit = days"),
                     ("subsection Rod", "subsection Model\n  set Inertia = 1\nend\n"
                      "subsection Rod"),
                     ("= 0.0001\n  set Stiffness = 30000000.0",
                      "= 0.0001\n  set Stiffness = infinity\n  set Damping = 0.1"),
                     ("= 0.0001\n  set Stiffness = 30000000.0",
                      "= 0.0001\n  set Stiffness = infinity\n  set Exponent = 1.5"),
                     ("subsection Rod", "subsection Sides\n  set Exchange coefficient "
                      "= 9\n  set Perimeter = 0.015\nend\nsubsection Rod"),
                     ("subsection Rod", "subsection Loads\n  set Base motion = "
                      "cos(t)\nend\nsubsection Rod"),
                     ("subsection Rod", "subsection Loads\n  set Base motion = 0.0"
                      "\nend\nsubsection Contact\n  set Rear gap = 1\nend\n"
                      "subsection Rod"),
                     ("subsection Rod", "subsection Sides\n  set Perimeter = 0.05\n"
                      "end\nsubsection Rod"),
                     ("= 0.0001\n", "= 0.0001\n  set Rear gap = 0\n"),
                     ("= 0.0001\n", "= 1e-4+if(t<2,0,1/(t-t))\n"),
                     ("= 0.0001\n", "= 1e-4*y\n"),
                     ("Initial = 310.0\n  set Fixed end = 350.0",
                      "Initial = 310.0\n  set Fixed end = 300+if(t<2,0,1/(t-t))"),
                     ("subsection Rod", "subsection Mesh\n  set Cels = 1\nend\n"
                      "subsection Rod")):
        status, _, message = answer(si_file({**ROD, "time_unit": "s"}).replace(old, new))
        print(message.rstrip())
        print("exit status", status)
    for perimeter in 0.015, 50.0:
        status, _, message = answer(si_file({**ROD, "h_sides": 9.0,
                                             "perimeter": perimeter}))
        print(message.rstrip())
        print("exit status", status)


main()
