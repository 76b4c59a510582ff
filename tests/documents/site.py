# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: site.py PROJECT PROGRAM

The manual as a site, made by doc/site.py as scripts/document does it: every
page is in a group of the menu, every link leads to a file and a heading, every
number of an equation to its place, and the words below are found: their page comes
first where node.js can tell. Skipped (exit status 77) without Doxygen, MathJax or the
Markdown module for Python.
"""
import importlib.util
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

WORDS = {"restart": "how-to", "sweep": "how-to", "damping": "parameters", "tolerance": "parameters",
         "Hertz": "laws", "bifurcation": "how-to", "contact_force": "output", "ParaView": "how-to",
         "cluster": "how-to", "gap": "parameters", "units": "units", "python": "fit-of-a-stop",
         "install": "how-to", "probes": "parameters", "friction": "scope", "restitution": "scope",
         "Poisson": "parameters", "checkpoint": "how-to", "max_contact_force": "output",
         "error bars": "numerics", "slow": "messages", "time step": "accuracy", "MPI": "how-to",
         "steady state": "model", "preload": "laws", "convergence order": "accuracy",
         "resume": "how-to", "Robin": "model", "order": "accuracy", "error bar": "numerics",
         "memory": "performance", "study": "how-to", "fit": "fit-of-a-stop",
         "thermal switch": "gallery", "gravity": "scope", "Gmsh": "scope", "spring": "scope", "mass": "scope",
         "temperature-dependent": "scope", "two materials": "scope", "free rod": "scope",
         "plasticity": "scope", "large deformation": "scope", "limitations": "scope", "adhesion": "scope"}
WHOLE = ("spring", "string")  # what is found has all of the word, not its first letters alone
HITS = """
const fs = require("fs"), folder = process.argv[1], [,, ...queries] = process.argv;
const document = {getElementById: () => ({addEventListener() {}})};
eval(["search-index.js", "search.js"].map((name) => fs.readFileSync(folder + "/" + name, "utf8")).join("")
  + ";for (const query of queries) console.log(JSON.stringify(hitsOf(query).map((hit) => hit[1])))");
"""

project = Path(sys.argv[1]).resolve()
if not (shutil.which("doxygen") and importlib.util.find_spec("markdown") and
        Path("/usr/share/javascript/mathjax").exists()):
    print("not made: doxygen, python3-markdown or libjs-mathjax is not installed")
    sys.exit(77)
with tempfile.TemporaryDirectory() as folder:
    site = Path(folder) / "html"
    status = subprocess.run([sys.executable, "-B", project / "doc/site.py", site]).returncode
    status |= subprocess.run([project / "scripts/check_links", site]).returncode
    text = (site / "search-index.js").read_text(encoding="utf-8")
    index = json.loads(text[text.index("["):text.rindex(";")])
    numbers = {}
    for page in site.glob("*.html"):
        text = re.sub(r"\\\[.*?\\\]", "", page.read_text(encoding="utf-8"), flags=re.S)
        numbers.update(dict.fromkeys(re.findall(r"\(([MDCU]\d*\.\d+)\)", text), page.name))
    faults = [f"{page}: ({number}) is no equation" for number, page in sorted(numbers.items())]
    faults += [f"{page.name}: a link in a formula" for page in site.glob("*.html")
               for formula in re.findall(r"\\\[.*?\\\]", page.read_text(encoding="utf-8"), re.S)
               if "<a " in formula]
    for words in WORDS:
        if not any(all(re.search(rf"\b{word}", " ".join(entry[1:]), re.I) for word in words.split())
                   for entry in index):
            faults.append(f"the search does not find {words}")
    if shutil.which("node"):
        hits = [json.loads(line) for line in subprocess.run(
            ["node", "-e", HITS, site, *WORDS, *WHOLE], check=True, text=True,
            stdout=subprocess.PIPE).stdout.splitlines()]
        faults += [f"{words}: {found[0][0]} comes first, not {page}.html" for (words, page), found in
                   zip(WORDS.items(), hits) if not found[0][0].startswith(page + ".html")]
        faults += [f"{word}: {place} is found" for word, found in zip(WHOLE, hits[len(WORDS):])
                   for place, *texts in found if word not in " ".join(texts).lower()]
print(f"{len(index)} places, {len(WORDS)} words looked for")
print("\n".join(faults))
sys.exit(1 if status or faults else 0)
