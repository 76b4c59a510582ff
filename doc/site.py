#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: doc/site.py FOLDER

Writes the manual as a site into FOLDER: the pages that the section "Manual" of
README.md lists, in its groups, and the classes by Doxygen. No page needs a
network or a server: formulas are drawn by Debian's libjs-mathjax, and the
search looks into an index of all sections, table rows and classes. Numbers of
equations, (M1.4), and entries, `Contact/Gap`, become links to their places. A
page of doc/ that is in no group, and a link that leads to no page, are faults.
"""
import base64
import html
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import markdown

top = Path(__file__).resolve().parent.parent
MATHJAX = Path("/usr/share/javascript/mathjax")
WORDY = ("messages", "how-to", "scope", "units")  # rows of their tables are places, too
SIGNS = dict(zip("alpha beta gamma delta epsilon varepsilon zeta eta theta kappa lambda mu nu pi rho sigma tau varphi "
                 "chi omega Delta Omega Gamma le ge ne lt gt sum int to infty cdot times approx".split(),
                 "α β γ δ ε ε ζ η θ κ λ μ ν π ρ σ τ φ χ ω Δ Ω Γ ≤ ≥ ≠ &lt; &gt; Σ ∫ → ∞ · × ≈".split()))
PLAIN = ("Dockerfile", "CITATION.cff", "LICENSE")  # copied as text
HEAD = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} - thermocontact</title>
<link rel="stylesheet" href="site.css">
<script src="search-index.js" defer></script><script src="search.js" defer></script>
<script type="text/x-mathjax-config">MathJax.Hub.Config({{
 extensions: ["tex2jax.js"], jax: ["input/TeX", "output/HTML-CSS"],
 TeX: {{extensions: ["AMSmath.js", "AMSsymbols.js"]}},
 "HTML-CSS": {{scale: 92, availableFonts: ["TeX"], webFont: "TeX"}},
 tex2jax: {{inlineMath: [["\\\\(", "\\\\)"]], processClass: "math", ignoreClass: "page"}},
 messageStyle: "none", showMathMenu: false}});</script>
<script src="mathjax/MathJax.js" defer></script>
</head><body><nav><details open><summary><b>thermocontact</b> {version}</summary>
<input id="search" type="search" placeholder="Search the manual" aria-label="Search">
{menu}</details></nav><main class="page"><div id="found" hidden></div>
<div id="text">
{text}</div></main>
<script>if (innerWidth < 800) document.querySelector("nav details").open = false</script>
</body></html>
"""


def name_of(path):
    """The file of a page of the project in the site."""
    name = path.relative_to(top).as_posix()
    if name == "README.md":
        return "index.html"
    stem = path.parent.name if path.name == "README.md" else path.stem
    return stem.lower() + ".html"


def slug(heading, _="-"):
    """The anchor of a heading, as GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def words_of(formula):
    """A formula in a line, as far as that can be read: Greek letters, indices."""
    formula = re.sub(r"\\([a-zA-Z]+) ?", lambda m: SIGNS.get(m[1], ""), formula)
    return re.sub(r"\\.|[{}]", "", formula)


def menu_of(readme):
    """[(group, [(title, path)])] of the lines `**Group**: [Title](path) · ...`."""
    menu = [(group, [(title, (top / path).resolve()) for title, path in
                     re.findall(r"\[([^]]+)\]\(([^)]+)\)", links)])
            for group, links in re.findall(r"^\* \*\*(.+?)\*\*:((?:.+\n(?:  .*\n)*))",
                                           readme, re.M)]
    menu[0][1].insert(0, ("Overview", top / "README.md"))
    return menu


def text_of_notebook(path, folder):
    """A notebook with its results as Markdown; its pictures go into folder."""
    parts = []
    for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            parts.append(source)
            continue
        parts.append(f"```python\n{source}\n```")
        for output in cell["outputs"]:
            if "text" in output:
                parts.append("```\n" + "".join(output["text"]).rstrip() + "\n```")
            image = output.get("data", {}).get("image/png")
            if image:
                name = f"{path.stem}-{len(parts)}.png"
                (folder / "images" / name).write_bytes(base64.b64decode(image))
                parts.append(f"![Picture](images/{name})")
    return "\n\n".join(parts)


class Site:
    def __init__(self, folder):
        self.folder = folder
        readme = (top / "README.md").read_text(encoding="utf-8")
        self.menu = menu_of(readme)
        self.pages = [path for _, links in self.menu for _, path in links
                      if path.suffix in (".md", ".ipynb")]
        self.titles = {name_of(path): title for _, links in self.menu for title, path in links}
        self.index, self.faults = [], []
        version = re.search(r"^project\(.*VERSION ([\d.]+)", (top / "CMakeLists.txt").read_text(), re.M)
        self.version = version[1] if version else ""
        for path in [*top.glob("*.md"), *(top / "doc").glob("*.md"), *(top / "doc").glob("*.ipynb")]:
            if path not in self.pages:
                self.faults.append(f"README.md: {path.name} is in no group of the manual")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(top / "doc/images", folder / "images")
        for path in (top / "prm").rglob("*.prm"):
            copy = folder / "prm" / path.relative_to(top / "prm").with_suffix(".prm.txt")
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, copy)
        for name in PLAIN:
            shutil.copy(top / name, folder / (name + ".txt"))
        for name in ("site.css", "search.js"):
            shutil.copy(top / "doc" / name, folder)
        self.texts = {path: text_of_notebook(path, folder) if path.suffix == ".ipynb" else
                      path.read_text(encoding="utf-8") for path in self.pages}
        self.equations = {number: name_of(path) for path, text in self.texts.items()
                          for number in re.findall(r"\\tag\{([A-Z][\d.]+)\}", text)}
        self.entries = {f"{section}/{entry}" for section, part in re.findall(
            r"^## (.+?)\n(.*?)(?=^## |\Z)", self.texts[top / "doc/parameters.md"], re.M | re.S)
            for entry in re.findall(r"^\| `([^`]+)`", part, re.M)}

    def link(self, page, target):
        """Where a link of a page leads to in the site."""
        if re.match(r"[a-z+.-]+:|//|#", target):
            return target
        name, _, anchor = target.partition("#")
        path = (page.parent / name).resolve()
        if path in self.pages:
            return name_of(path) + ("#" + anchor if anchor else "")
        if (self.folder / name).exists():
            return name  # a picture of a notebook
        if path.is_relative_to(top / "prm") and path.suffix == ".prm":
            return path.relative_to(top).as_posix() + ".txt"
        if path.is_relative_to(top / "doc/images") and path.is_file():
            return path.relative_to(top / "doc").as_posix()
        if path.parent == top and path.name in PLAIN:
            return path.name + ".txt"
        self.faults.append(f"{page.relative_to(top)}: {target} is not in the site")
        return target

    def body(self, page):
        """The HTML of a page, with its contents below its title."""
        kept = []

        def keep(text):
            kept.append(text)
            return f"KEPT{len(kept) - 1}TEXT"

        def block(match):
            tag = re.search(r"\\tag\{(.*?)\}", match[1])
            at = f' id="{tag[1]}"' if tag else ""
            return "\n\n" + keep(f'<div class="math"{at}>\\[{html.escape(match[1])}\\]</div>') + "\n\n"

        text = re.sub(r"^```math\n(.*?)^```$", block, self.texts[page], flags=re.M | re.S)
        code = re.split(r"(^```.*?^```$|`[^`\n]+`)", text, flags=re.M | re.S)
        for i in range(0, len(code), 2):
            code[i] = re.sub(r"(?<!\\)\$([^$]+)\$", lambda m: keep(
                f'<span class="math">\\({html.escape(m[1])}\\)</span>'), code[i])
        for i in range(1, len(code), 2):
            if not code[i].startswith("```"):
                code[i] = code[i].replace("\\|", "BARINCODE")
        maker = markdown.Markdown(extensions=["tables", "fenced_code", "toc", "sane_lists"],
                                  extension_configs={"toc": {"slugify": slug, "toc_depth": "2-3"}})
        text = maker.convert("".join(code))
        text = re.sub(r"<p>(KEPT\d+TEXT)</p>", r"\1", text).replace("BARINCODE", "|")
        text = re.sub(r'(href|src)="([^"]*)"',
                      lambda m: f'{m[1]}="{self.link(page, m[2])}"', text)
        text = re.sub(r'<a href="([\w-]+\.html)">[\w/-]+\.(?:md|ipynb)</a>', lambda m:
                      f'<a href="{m[1]}">{self.titles.get(m[1], m[1])}</a>', text)
        text = re.sub(r"(?<!\">)<code>(prm/[\w/-]+\.prm)</code>", lambda m: m[0] if not (top / m[1]).is_file()
                      else f'<code><a href="{m[1]}.txt">{m[1]}</a></code>', text)
        text = self.with_run_in_headings(text)
        here = name_of(page)
        text = re.sub(r"(?<![\w{\"])\(([A-Z]\d*\.\d+)\)", lambda m: m[0] if m[1] not in self.equations
                      else f'(<a href="{self.equations[m[1]]}#{m[1]}">{m[1]}</a>)', text)
        if here == "parameters.html":
            text = self.with_places(text)
        else:
            text = re.sub(r"(?<!\">)<code>([A-Z][\w ']*/[A-Z][\w ']*?)(?=( =[^<]*)?</code>)", lambda m:
                          f'<code><a href="parameters.html#{m[1].replace(" ", "-")}">{m[1]}</a>'
                          if m[1] in self.entries else m[0], text)
        if maker.toc.count("<li>") > 3:
            text = text.replace("</h1>", "</h1>" + maker.toc, 1)
        text = re.sub(r"KEPT(\d+)TEXT", lambda m: kept[int(m[1])], text)
        return re.sub(r"<table>", '<div class="wide"><table>', text).replace("</table>", "</table></div>")

    @staticmethod
    def with_run_in_headings(text):
        """An anchor in each paragraph that begins with bold words."""
        names = set(re.findall(r'id="([^"]*)"', text))

        def place(match):
            name = slug(html.unescape(re.sub(r"<[^>]+>|KEPT\d+TEXT", "", match[2])))
            if not name or name in names:
                return match[0]
            names.add(name)
            return f'<{match[1]} id="{name}"><strong>{match[2]}</strong>'

        return re.sub(r"<(p|li)>\s*<strong>(.*?)</strong>", place, text)

    @staticmethod
    def with_places(text):
        """An anchor in each row of the page of parameters."""
        section = ""

        def place(match):
            nonlocal section
            if match[1]:
                section = match[1]
                return match[0]
            at = f"{section}/{match[2]}".replace(" ", "-")
            return f'<tr id="{at}"><td><code>{match[2]}'

        return re.sub(r"<h2[^>]*>(.*?)</h2>|<tr>\s*<td><code>([^<]*)", place, text)

    def menu_in(self, page):
        items = []
        for group, links in self.menu:
            items.append(f"<h2>{group}</h2><ul>")
            for title, path in links:
                here = ' class="here"' if path == page else ""
                items.append(f'<li{here}><a href="{name_of(path)}">{title}</a></li>')
            items.append("</ul>")
        items.append('<ul><li><a href="classes/annotated.html">Classes</a></li></ul>')
        return "\n".join(items)

    def add_to_index(self, page, title, text):
        """Sections, paragraphs with run-in headings and rows of tables as places to be found,
        with the words of comments <!-- find: word, words --> that do not stand in them."""
        def plain(part):
            part = re.sub(r'<div class="math".*?</div>', " … ", part, flags=re.S)
            part = re.sub(r'<span class="math">\\\((.*?)\\\)</span>', lambda m: words_of(m[1]), part, flags=re.S)
            return " ".join(html.unescape(re.sub(r"<[^>]+>", " ", part)).split())

        def add(anchor, heading, part, first=None):
            found = re.search(r"<!-- find: (.*?) -->", part if first is None else first)
            self.index.append([f"{name_of(page)}#{anchor}", title, plain(heading),
                               plain(part), found[1] if found else ""])

        parts = re.split(r'<h[123] id="([^"]*)">(.*?)</h[123]>', text, flags=re.S)
        for anchor, heading, part in zip(parts[1::3], parts[2::3], parts[3::3]):
            inner = re.split(r'(?=<(?:p|li) id=)', part)
            add(anchor, heading, part, inner[0])
            for place in inner[1:]:
                at, name = re.match(r'<\w+ id="([^"]*)"><strong>(.*?)</strong>', place, re.S).groups()
                add(at, name.rstrip(".: "), place)
            for row in re.findall(r"<tr[^>]*>.*?</tr>", part, re.S):
                at = re.search(r'<tr id="([^"]*)"', row)
                cell = row.partition("</td>")[0]
                code = re.search(r"<td><code>(?:<a[^>]*>)?([^<]+)", cell)
                name = code[1] if code else plain(cell)
                if re.search(r"[A-Za-z]{3}", name) and (code or page.stem in WORDY) and "<td" in row:
                    entry = plain(heading) + "/" if at and at[1][0] != "/" else ""
                    words = f"<!-- find: {name} -->" if page.stem == "scope" else None
                    add(at[1] if at else anchor, entry + html.unescape(name), row, words)

    def write(self):
        for page in self.pages:
            text, title = self.body(page), self.titles[name_of(page)]
            self.add_to_index(page, title, text)
            heading = re.search(r"<h1[^>]*>(.*?)</h1>", text)
            (self.folder / name_of(page)).write_text(HEAD.format(
                title=html.escape(re.sub(r"<[^>]+>", "", heading[1] if heading else title)),
                version=self.version, menu=self.menu_in(page), text=text), encoding="utf-8")
        self.write_classes()
        (self.folder / "search-index.js").write_text(
            "const searchIndex = " + json.dumps(self.index, ensure_ascii=False) + ";\n",
            encoding="utf-8")

    def write_classes(self):
        """The headers by Doxygen, any warning of which is a fault."""
        target = self.folder / "mathjax"
        for part in ("MathJax.js", "extensions",
                     "fonts/HTML-CSS/TeX", "jax/element", "jax/input/TeX",
                     "jax/output/HTML-CSS"):
            source, copy = MATHJAX / part, target / part
            copy.parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if source.is_dir() else shutil.copy)(source, copy)
        settings = (top / "doc/Doxyfile").read_text() + f"""
PROJECT_NUMBER    = {self.version}
OUTPUT_DIRECTORY  = "{self.folder}"
INPUT             = "{top}/include"
STRIP_FROM_PATH   = "{top}"
STRIP_FROM_INC_PATH = "{top}/include"
HTML_EXTRA_STYLESHEET = "{top}/doc/classes.css"
"""
        done = subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=self.folder,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode:
            self.faults.append("Doxygen:\n" + done.stdout)
        for path in sorted((self.folder / "classes").glob("*.html")):
            name = re.search(r"<title>.*?: (.*?) (?:Class|Struct).*</title>", path.read_text())
            if name:
                self.index.append([f"classes/{path.name}", "Classes",
                                   html.unescape(name[1]).replace("ThermoContact::", ""), "", ""])


def main(folder):
    site = Site(folder)
    site.write()
    print("\n".join(site.faults), file=sys.stderr)
    return 1 if site.faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1] == "--help":
        sys.exit(__doc__)
    os.umask(0o022)
    sys.exit(main(Path(sys.argv[1]).resolve()))
