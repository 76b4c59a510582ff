# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: paths.py PROJECT PROGRAM
#
# A path "Section/Entry" is one that the program declares, for a scene or for
# --units, wherever it stands: in the strings of C++, where a misprint would
# make a rule or a remedy that never applies, in the scripts, in the comments of
# the scenes, and in the code of the pages. Begins with a test of itself, on
# paths that are wrong.

import json
import pathlib
import re
import subprocess
import sys

# Words for any entry; constants, bodies and pairs have the names that a file gives them.
NO_ENTRIES = {"Section/Entry": "*", "Constants": "*", "Bodies": "*", "Contacts": "*"}

# Comments are skipped, and strings side by side are one.
CPP = re.compile(r"""//[^\n]* | /\*.*?\*/ | '(?:[^'\\\n]|\\.)+' |
                     R"\((?P<raw>.*?)\)" | "(?P<plain>(?:[^"\\\n]|\\.)*)" |
                     (?P<between>\s+) | (?P<other>.)""", re.X | re.S)


def strings_of_cpp(text):
    """The strings of a source, with the lines that they begin in."""
    strings, is_open, line = [], False, 1
    for token in CPP.finditer(text):
        part = token["plain"] if token["raw"] is None else token["raw"]
        if part is not None:
            part = part.replace("\\n", "\n").replace('\\"', '"')
            if is_open:
                strings[-1][1] += part
            else:
                strings.append([line, part])
            is_open = True
        elif token["other"] is not None:
            is_open = False
        line += token[0].count("\n")
    return strings


def code_of_page(text):
    """The code of a page of Markdown, in lines and in blocks."""
    code = []
    for span in re.finditer(r"^```.*?^```|`[^`\n]+`", text, re.M | re.S):
        code.append([text.count("\n", 0, span.start()) + 1, span[0]])
    return code


def texts_of(path):
    text = path.read_text()
    if path.suffix in (".cc", ".h"):
        return strings_of_cpp(text)
    if path.suffix == ".md":
        return code_of_page(text)
    return [[1, text]]


def pattern_of_paths(entries):
    """Capital/Capital, and sections that there are, in small letters too."""
    sections = "|".join({re.escape(entry.split("/")[0])
                         for entry in entries if "/" in entry})
    word = "[A-Z][a-z]+"
    return re.compile(rf"""(?<![\w/.-])
                           (?:({word}(?:[ ][a-z]+)*)/
                                  (?=((?:[a-z]+/)?{word}[\w' -]*)) |
                              ((?i:{sections}))/
                                  (?=((?:[A-Za-z]+/)?[A-Za-z][\w' -]*)))""",
                      re.X)


def paths_of(text, pattern):
    """Section, '/' and the words behind it, with their offsets."""
    for match in pattern.finditer(text):
        section, words = match.groups()[:2] if match[1] else match.groups()[2:]
        yield match.start(), f"{section}/{words.rstrip()}"


def begins_with(words, path):
    return words.startswith(path) and not words[len(path):][:1].isalnum()


def wrong_paths(name, text, entries):
    """How many paths in a text are right, and those that no entry has."""
    n_right, wrong = 0, []
    inner = {entry.rsplit("/", 1)[0] for entry in entries if entry.count("/") > 1}
    for at, path in paths_of(text, pattern_of_paths(entries)):
        if path in inner or any(begins_with(path, entry) for entry in entries):
            n_right += 1
        elif not any(begins_with(path, entry) and place in ("*", name)
                     for entry, place in NO_ENTRIES.items()):
            wrong.append((at, path))
    return n_right, wrong


def declared(program, *options):
    def collect(node, prefix):
        for name, value in node.items():
            if "pattern_description" in value:
                yield prefix + name
            else:
                yield from collect(value, f"{prefix}{name}/")

    output = subprocess.run([program, *options, "--print-parameters=json"],
                            check=True, text=True, stdout=subprocess.PIPE)
    return set(collect(json.loads(output.stdout), ""))


def check_self():
    """Texts of each kind, and how many wrong paths are in them."""
    entries = {"Time/Step size", "Time/Step", "Mesh/Cells", "Boundary/left/Mass"}
    cases = [
        (strings_of_cpp, 'refuse("Time/Step size");', 0),
        (strings_of_cpp, 'refuse("Time/Stepsize");', 1),
        (strings_of_cpp, 'refuse("Times/Step size");', 1),
        (strings_of_cpp, 'refuse("time/Step size, Time/step size");', 2),
        (strings_of_cpp, '"remedy: a smaller Time/"\n  "Steps"', 1),
        (strings_of_cpp, '"Time/Step = " + x + ", Mesh/Cell = "', 1),
        (strings_of_cpp, '// "Time/Steps"\n/* "Mesh/Cell" */ \'"\' "x"', 0),
        (strings_of_cpp, '"Section/Entry = value", "N/m", "http://A/B"', 0),
        (strings_of_cpp, '"Boundary/left/Mass", "Boundary/left"', 0),
        (strings_of_cpp, '"Boundary/left/Masses", "Boundary/right/Mass", "Boundary/lef"', 3),
        (code_of_page, "Time/Steps\n`Mesh/Cell=1`\n```\nMesh/Cell\n```\n", 2),
    ]
    return [f"paths.py: {n} wrong paths expected in {text!r}"
            for read, text, n in cases
            if n != sum(len(wrong_paths("", part, entries)[1])
                        for _, part in read(text))]


project, program = map(pathlib.Path, sys.argv[1:])
entries = declared(program) | declared(program, "--units")
faults, n_right = check_self(), 0
files = [path for folder, pattern in (("source", "**/*.cc"),
                                      ("include", "**/*.h"),
                                      ("tests", "**/*.cc"),
                                      ("tests", "**/*.h"),
                                      ("tests", "app/*.py"),
                                      ("prm", "**/*.prm"),
                                      ("scripts", "*"),
                                      ("doc", "**/*.md"),
                                      (".", "*.md"))
         for path in sorted((project / folder).glob(pattern))
         if path.is_file()]
for path in files:
    name = path.relative_to(project).as_posix()
    for line, text in texts_of(path):
        n, wrong = wrong_paths(name, text, entries)
        n_right += n
        faults += [f"{name}:{line + text.count(chr(10), 0, at)}: no entry {p}"
                   for at, p in wrong]
print(f"{len(files)} files, {len(entries)} entries, {n_right} paths")
print("\n".join(faults))
sys.exit(1 if faults or not n_right else 0)
