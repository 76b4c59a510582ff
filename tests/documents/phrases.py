#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: phrases.py PROJECT PROGRAM

Sentences of pages and comments that have to be decoded, since a pronoun stands where the noun has
not been named: "what", "whatever", "that which", "those that", "that of" or "those of" behind at
most two words. Headings, cells of tables and indirect questions ("says what it costs", "what to
do") are none. Lists them; fails if there are more than MOST, or if SAMPLES are not counted right.
"""
import re
import sys
from pathlib import Path

MOST = 60
SAMPLES = {"What a run does.": 1, "Pressures; those of the rear node are negative.": 1,
           "The force, and the nodes that carry it, are those of the run before.": 0,
           "It says what it costs.": 0, "Those with a mass.": 0, "A rod; whatever it carries.": 1}
PRONOUN = re.compile(r"\b(?:what|whatever|that which|those that|those of|that of)\b", re.IGNORECASE)
BEGIN = re.compile(r"[.:;(!?]\s|\n\s*\n|\n\s*[*-] |@(?:return|throw|param)\b")
QUESTION = re.compile(r"\b(?:says?|said|tells?|told|shows?|knows?|known|asks?|sees?|decides?|and)$")


def texts(path):
    """Comments of a source, a page without code; each with its first line."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".md":
        page = re.sub(r"```.*?```", lambda code: "\n" * code[0].count("\n"), text, flags=re.DOTALL)
        # headings and rows of tables are blank lines
        yield 1, re.sub(r"^(?:#|.*\|).*$", "", page, flags=re.MULTILINE)
        return
    for comment in re.finditer(r"/\*.*?\*/|(?:^[ \t]*//[^\n]*\n)+|//[^\n]*", text,
                               re.DOTALL | re.MULTILINE):
        yield (1 + text.count("\n", 0, comment.start()), re.sub(
            r"^[ \t]*(?:///?<?|/\*\*?|\*/?)[ \t]?", "", comment[0], flags=re.MULTILINE))


def phrases(text):
    """Position and words of each."""
    for match in PRONOUN.finditer(text):
        before = BEGIN.split(text[:match.start()])[-1].split()
        is_question = QUESTION.search(text[:match.start()].rstrip()) or re.match(
            r"\s+to\b", text[match.end():])
        if len(before) <= 2 and not is_question:
            rest = text[match.start():match.end() + 50].replace("\n", " ")
            yield match.start(), " ".join([*before, rest])


def main():
    top, found = Path(sys.argv[1]), []
    for path in sorted([*top.glob("include/**/*.h"), *top.glob("source/**/*.cc"), *top.glob("doc/*.md"),
                        *top.glob("*.md"), *top.glob("tests/*.md")]):
        for line, text in texts(path):
            found += [f"{path.relative_to(top).as_posix()}:{line + text.count(chr(10), 0, begin)}: "
                      + words for begin, words in phrases(text)]
    counts = {text: len(list(phrases(text))) for text in SAMPLES}
    print("\n".join(found))
    print(f"{len(found)} sentences, at most {MOST}; samples: {counts}")
    return 1 if len(found) > MOST or counts != SAMPLES else 0


sys.exit(main())
