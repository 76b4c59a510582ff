#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random rows with heat against tests/reference/heated_rows.py, an independent program.

usage: check_heated_rows.py DIR [SEED [NUMBER]]; in seeds from 1000 on coefficients depend on the temperature

Tolerance 1e-6. At four instants temperature, displacement and energy, the force and the heat flux of each contact: to 5
tolerances of the largest up to the end (all forces have the largest of any contact), as steps add up. The balance
energy(0) + work = energy + dissipation + numerical_dissipation to 1e-12 of its terms.
"""
import csv
import shutil
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "reference"))
import numpy  # noqa: E402
from heated_rows import Scene, solve  # noqa: E402
from program import for_all, run, settings  # noqa: E402

SEEDS = [*range(1, 11), *range(1000, 1005)]
if len(sys.argv) > 2:
    SEEDS = range(int(sys.argv[2]), int(sys.argv[2]) + int((sys.argv + ["1"])[3]))
TOLERANCE, BOUND = 1e-6, 5


def compare(seed):
    scene = Scene(seed, has_laws=seed >= 1000)
    directory = Path(f"row-{seed}")
    status, _, message = run("--quiet", "--output", directory, "rows.prm", *settings(scene.overrides()), seconds=100)
    if status != 0:
        return seed, float("inf"), float("inf"), message.splitlines()[0] if message else f"status {status}"

    def table(name):
        with open(directory / name) as file:
            return [{key: float(value) for key, value in row.items()}
                    for row in csv.DictReader(line for line in file if not line.startswith("#"))]
    rows, contacts = table("contact.csv"), [table(f"contacts/{name}.csv") for name in scene.contacts()]
    shutil.rmtree(directory)
    found = []
    for time in scene.times:
        i = min(range(len(rows)), key=lambda i: abs(rows[i]["time"] - time))
        values = [rows[i][name] for name in ("temperature_end", "displacement_end", "energy")]
        for contact in contacts:
            values += [contact[i]["contact_force"], contact[i]["heat_flux"]]
        found.append(values)
    exact, scale = solve(scene)
    errors = (abs(numpy.array(found) - exact) / numpy.maximum(scale, 1e-3)).max(axis=0) / TOLERANCE

    def terms(row):
        return [row["energy"], row["dissipation"], row["numerical_dissipation"], -row["work"]]
    balance = max(abs(sum(terms(row)) - rows[0]["energy"]) / sum(map(abs, terms(row) + [rows[0]["energy"]]))
                  for row in rows)
    return seed, errors.max(), balance, " ".join(f"{error:.1f}" for error in errors)


def main():
    Path("rows.prm").write_text("# rows\nsubsection Output\nset Fields interval = 0\nset Contact interval = 0.5\n"
                                "set Land on output times = true\nend\n")
    results = for_all(compare, SEEDS)
    bad = [f"{seed}: {error:.1f} ({words}), balance {balance:.0e}" for seed, error, balance, words in results
           if not (error <= BOUND and balance <= 1e-12)]
    print(f"{len(SEEDS)} random rows with heat:", "; ".join(bad) or f"all within {BOUND} tolerances, balances to 1e-12")
    if len(sys.argv) > 3:
        print("largest", [f"{error:.1f}" for error in sorted((r[1] for r in results), reverse=True)[:8]])


main()
