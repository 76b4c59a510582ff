#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: phrases.py SOURCE_DIRECTORY [REGEX]

Counts sentences of pages and comments that have to be decoded, since a pronoun stands where the
noun has not been named: "what", "whatever", "that which", "those that", "that of" or "those of"
behind at most two words. Headings, cells of tables and indirect questions ("says what it costs",
"what to do") are none. Prints the number of each file, the sentences of files that match REGEX, and
the sum. By hand: not a test.
"""
import re
import sys
from pathlib import Path

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


def phrases(path):
    """Line and text of each."""
    for line, text in texts(path):
        for match in PRONOUN.finditer(text):
            before = BEGIN.split(text[:match.start()])[-1].split()
            is_question = QUESTION.search(text[:match.start()].rstrip()) or re.match(
                r"\s+to\b", text[match.end():])
            if len(before) <= 2 and not is_question:
                rest = text[match.start():match.end() + 50].replace("\n", " ")
                yield line + text.count("\n", 0, match.start()), " ".join([*before, rest])


def main():
    top, shown = Path(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "$^"
    total = 0
    for path in sorted([*top.glob("include/**/*.h"), *top.glob("source/**/*.cc"), *top.glob("doc/*.md"),
                        *top.glob("*.md"), *top.glob("tests/*.md")]):
        found, name = list(phrases(path)), path.relative_to(top).as_posix()
        total += len(found)
        if found:
            print(name, len(found))
        if re.search(shown, name):
            for line, text in found:
                print(f"  {line}: {text}")
    print("all", total)


main()
