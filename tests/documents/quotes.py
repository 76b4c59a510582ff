# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: quotes.py PROJECT PROGRAM

C++ that a page of doc/ quotes is in the file named last before it, line by line
but for blanks; a line `...` stands for lines left out. And every pair of files
of the library has its place in doc/architecture.md.
"""
import re
import sys
from pathlib import Path

project = Path(sys.argv[1])


def plain(text):
    """The lines without blanks, empty ones left out."""
    lines = ("".join(line.split()) for line in text.splitlines())
    return "\n" + "\n".join(line for line in lines if line) + "\n"


def faults_of(page):
    name, n_quotes, faults = None, 0, []
    for part in re.split(r"^(```.*?^```$)", page.read_text(),
                         flags=re.M | re.S):
        if not part.startswith("```cpp"):
            files = re.findall(r"`((?:source|include|tests)/[^`]*\.(?:cc|h))`",
                               part)
            name = files[-1] if files else name
            continue
        n_quotes += 1
        code = plain((project / name).read_text())
        for quote in re.split(r"^ *\.\.\. *$", part[6:-3], flags=re.M):
            if plain(quote).strip() and plain(quote) not in code:
                faults.append(f"{page.name}: not in {name}:{quote}")
    return n_quotes, faults


faults, n_quotes = [], 0
for page in sorted((project / "doc").glob("*.md")):
    n, f = faults_of(page)
    n_quotes += n
    faults += f
places = set(re.findall(r"`([\w.]+)`",
                        (project / "doc/architecture.md").read_text()))
names = {path.stem: path.name for folder in ("include", "source")
         for path in (project / folder).rglob("*.[ch]*")}
faults += [f"doc/architecture.md: no place for {name}"
           for stem, name in sorted(names.items())
           if not places & {stem, stem + ".h", stem + ".cc"}]
print(f"{n_quotes} quotes, {len(names)} pairs of files")
print("\n".join(faults))
sys.exit(1 if faults or not n_quotes or not names else 0)
