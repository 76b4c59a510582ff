# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: site.py PROJECT PROGRAM

The manual as a site, made by doc/site.py as scripts/document does it: every
page is in a group of the menu, every link leads to a file and a heading, every
number of an equation to its place, and the words below are found. Skipped
(exit status 77) without Doxygen, MathJax or the Markdown module for Python.
"""
import importlib.util
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

WORDS = """restart sweep damping tolerance Hertz bifurcation contact_force ParaView
    cluster gap units python install trouble probes friction energy restitution
    Poisson friction checkpoint max_contact_force""".split()

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
    for word in WORDS:
        if not any(re.search(rf"\b{word}", " ".join(entry[1:]), re.I) for entry in index):
            faults.append(f"the search does not find {word}")
print(f"{len(index)} places, {len(WORDS)} words looked for")
print("\n".join(faults))
sys.exit(1 if status or faults else 0)
