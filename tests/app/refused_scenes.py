# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes that the program must refuse or accept, for check_*.py; and what the
sources say when they refuse."""
import os
import re
from pathlib import Path

from program import for_all, run, settings

SOURCES = Path(__file__).resolve().parents[2] / "source"
MEMORY = 3 * 1024**3  # bytes: a scene that is too large is not to be set up


def check(overrides):
    """Exit status of --check, and the message from the entry at fault on."""
    status, _, message = run("--check", "--quiet", "--output", "not-made",
                             "defaults.prm", *settings(overrides),
                             memory=MEMORY)
    return status, message


def check_all(scenes):
    """check() of each scene, a tuple of overrides; the same ones once."""
    Path("defaults.prm").write_text("# defaults\n")
    scenes = list(dict.fromkeys(scenes))
    results = dict(zip(scenes, for_all(check, scenes)))
    os.remove("defaults.prm")
    return results


def source_files():
    return sorted(SOURCES.rglob("*.cc"))


def without_comments(path):
    literal = r"""('(?:\\.|[^'\\])'|"(?:\\.|[^"\\])*")"""
    return re.sub(literal + r"|//[^\n]*|/\*.*?\*/",
                  lambda match: "0" if (match[1] or "")[:1] == "'"
                  else match[1] or "", path.read_text(), flags=re.S)


def closing(text, begin):
    """Behind the bracket that closes the one at begin, past strings."""
    depth = 0
    for token in re.finditer(r'"(?:\\.|[^"\\])*"|[(\[{]|[)\]}]', text[begin:]):
        if token[0][0] in "([{":
            depth += 1
        elif token[0][0] != '"':
            depth -= 1
        if depth == 0:
            return begin + token.end()
    return len(text)


def arguments(text):
    """Of a call, text from "(" to ")": each as its string literals and whether
    it chooses between some."""
    parts, depth, begin = [], 0, 1
    for token in re.finditer(r'"(?:\\.|[^"\\])*"|[(\[{]|[)\]}]|,', text):
        depth += (token[0] in "([{") - (token[0] in ")]}")
        if (token[0] == "," and depth == 1) or depth == 0:
            parts.append(text[begin:token.start()])
            begin = token.end()
    result = []
    for part in parts:
        joined = re.sub(r'"\s*"', "", part)  # of lines that follow each other
        words = [word.encode("latin-1", "backslashreplace").decode("unicode_escape")
                 for word in re.findall(r'"((?:\\.|[^"\\])*)"', joined)]
        code = re.sub(r'"(?:\\.|[^"\\])*"', "", part)
        result.append((words, "?" in code))
    return result


def unmet_refusals(messages):
    """The calls of refuse...() and since(), the throw InputError(...) and the Refusals in
    the sources that no message comes from: all literals in one message, those of the first
    two and the last in their order, or, of an argument that chooses, in those together."""
    unmet = []
    for path in source_files():
        text = without_comments(path)
        for call in re.finditer(r"\b(?:refuse\w*|since|throw InputError)\s*\(|"
                                r"\bRefusal( +\w+)?{", text):
            begin = call.end() - 1
            found = arguments(text[begin:closing(text, begin)])
            if call[0] == "since(":  # its condition is no part of the message
                del found[0]
            fixed = [w for words, chooses in found if not chooses for w in words]
            chosen = [w for words, chooses in found if chooses for w in words
                      if " " in w]
            if not fixed + chosen:
                continue  # a declaration, or one that passes on others' words
            those = [message for message in messages
                     if (all(word in message for word in fixed) if call[0][0] == "t" else
                         re.search(".*".join(map(re.escape, fixed)), message, re.S))]
            missing = [word for word in chosen
                       if not any(word in message for message in those)]
            if not those or missing:
                line = text.count("\n", 0, begin) + 1
                unmet.append(f"{path.name}, about line {line}: "
                             f"{(missing or fixed)[0]!r}")
        # why a scheme cannot do it
        unmet += [reason for reason in re.findall(r'scheme\.(?:needs|cannot)\w+ =\s*"(.*)";', text)
                  if not any(reason in message for message in messages)]
    return unmet
