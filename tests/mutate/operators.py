# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults that the syntax tree of a source allows, each a list of edits.

An edit (begin, end, text) replaces bytes of the source; in its text FAULT stands
for the condition that the fault is switched on. Nothing here knows whether what
comes out compiles.
"""
import re
from typing import NamedTuple

from clang.cindex import CursorKind as Kind, TypeKind

FLOATING = (TypeKind.FLOAT, TypeKind.DOUBLE, TypeKind.LONGDOUBLE)
INTEGER = (TypeKind.INT, TypeKind.UINT, TypeKind.LONG, TypeKind.ULONG,
           TypeKind.LONGLONG, TypeKind.ULONGLONG)
FUNCTIONS = (Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.FUNCTION_TEMPLATE,
             Kind.CONSTRUCTOR, Kind.LAMBDA_EXPR)
SIGNS = {"+": "-", "-": "+", "+=": "-=", "-=": "+="}
# of numbers the other way round, since ends of intervals are seldom met
COMPARISONS = {"<": ">", ">": "<", "<=": ">=", ">=": "<=", "==": "!=", "!=": "=="}
BOUNDARIES = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
# of twice a number the same as of itself
SIGN_ALONE = re.compile(r"[=<>] 0\.$|^0\. [=!<>]")
# what an early return does, too, and what is left of an assertion
NOTHING_LEFT = re.compile(r"(return *(false|0\.?|\{\}|\"\"|nullptr)?)?;?$")
# What they check is an error of the programmer; the tests of messages have others.
ASSERTIONS = re.compile(r"\b(Assert\w*|static_assert|Declare?Exception\w*)\s*\(")


class Fault(NamedTuple):
    kind: str
    file: str
    line: int
    was: str
    edits: tuple

    @property
    def begin(self):
        return min(edit[0] for edit in self.edits)

    @property
    def end(self):
        return max(edit[1] for edit in self.edits)


def assertions(text):
    """The ranges of the arguments of assertions."""
    ranges = []
    for match in ASSERTIONS.finditer(text):
        depth, end = 1, match.end()
        while depth and end < len(text):
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end += 1
        ranges.append((match.start(), end))
    return ranges


def kind_of(cursor):
    return cursor.type.get_canonical().kind


class Source:
    """A source as one character to a byte, and the faults that it allows."""

    def __init__(self, name, text):
        self.name, self.text = name, text
        self.left_out = assertions(text)
        self.faults = {}

    def span(self, cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def word(self, cursor):
        begin, end = self.span(cursor)
        return self.text[begin:end]

    def add(self, kind, *edits):
        fault = Fault(kind, self.name, 0, "", edits)
        line = self.text.count("\n", 0, fault.begin) + 1
        fault = fault._replace(
            line=line, was=" ".join(self.text[fault.begin:fault.end].split()))
        if not any(begin < fault.end and fault.begin < end
                   for begin, end in self.left_out):
            self.faults[kind, edits] = fault

    def choose(self, kind, cursor, other):
        begin, end = self.span(cursor)
        if end > begin:
            self.add(kind, (begin, end,
                            f"(FAULT ? ({other}) : ({self.text[begin:end]}))"))

    def visit(self, cursor, parent=None):
        children = list(cursor.get_children())
        for of_kind in (self.binary, self.condition, self.number, self.arguments,
                        self.statements, self.member):
            of_kind(cursor, children, parent)
        for child in children:
            place = child.location.file
            if place is None or place.name.endswith(self.name):
                self.visit(child, cursor)

    def binary(self, cursor, children, _):
        """Sign, comparison: the operator stands between its operands."""
        if cursor.kind == Kind.UNARY_OPERATOR:
            word = self.word(cursor)
            if word.startswith("-") and not word.startswith("--"):
                self.choose("sign", cursor, word[1:])
        if len(children) != 2 or cursor.kind not in (
                Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR):
            return
        left, right = self.word(children[0]), self.word(children[1])
        operator = self.text[children[0].extent.end.offset:
                             children[1].extent.start.offset].strip()
        if operator in SIGNS:
            self.choose("sign", cursor, f"{left} {SIGNS[operator]} {right}")
        if operator in COMPARISONS:
            is_real = any(kind_of(child) in FLOATING for child in children)
            other = (COMPARISONS if is_real else BOUNDARIES)[operator]
            self.choose("comparison", cursor, f"{left} {other} {right}")

    def condition(self, cursor, children, _):
        if cursor.kind in (Kind.IF_STMT, Kind.CONDITIONAL_OPERATOR) and children:
            begin, end = self.span(children[0])
            self.add("negated condition",
                     (begin, end, f"(bool({self.text[begin:end]}) != FAULT)"))

    def number(self, cursor, _, parent):
        """Twice a real value, one more or one less than a whole one."""
        if parent is None or not parent.kind.is_expression():
            return
        word = self.word(cursor)
        if kind_of(cursor) in FLOATING and not re.search(
                r"^0\.$|infinity\(\)$", word) and not SIGN_ALONE.search(
                    self.word(parent)) and cursor.kind in (
                Kind.CALL_EXPR, Kind.DECL_REF_EXPR, Kind.MEMBER_REF_EXPR,
                Kind.ARRAY_SUBSCRIPT_EXPR, Kind.FLOATING_LITERAL):
            self.choose("factor 2", cursor, f"2 * ({word})")
        if kind_of(cursor) in INTEGER and cursor.kind in (
                Kind.INTEGER_LITERAL, Kind.DECL_REF_EXPR, Kind.MEMBER_REF_EXPR):
            self.choose("one more", cursor, f"({word}) + 1")
            if word != "0":
                self.choose("one less", cursor, f"({word}) - 1")

    def arguments(self, cursor, *_):
        if cursor.kind != Kind.CALL_EXPR or re.match(r"operator.*=$", cursor.spelling):
            return
        given = [argument for argument in cursor.get_arguments() if argument]
        for first, second in zip(given, given[1:]):
            one, two = self.word(first), self.word(second)
            if one != two and one and two and (
                    first.type.get_canonical() == second.type.get_canonical()):
                self.add("swapped arguments",
                         (*self.span(first), f"(FAULT ? ({two}) : ({one}))"),
                         (*self.span(second), f"(FAULT ? ({one}) : ({two}))"))

    def statements(self, cursor, children, parent):
        """One that is dropped; a return before it."""
        if cursor.kind != Kind.COMPOUND_STMT:
            return
        for number, child in enumerate(children):
            begin, end = self.span(child)
            if child.kind.is_expression():
                self.add("dropped statement", (begin, begin, "if (!(FAULT)) "),
                         (end, end, ""))
            if parent is not None and parent.kind in FUNCTIONS and number > 0 and not (
                    NOTHING_LEFT.match(self.text[begin:end])):
                value = "" if parent.result_type.kind == TypeKind.VOID or (
                    parent.kind == Kind.CONSTRUCTOR) else " {}"
                self.add("early return",
                         (begin, begin, f"if (FAULT) return{value}; "),
                         (end, end, ""))

    def member(self, cursor, *_):
        """Another member of the same record, of the same type."""
        field = cursor.referenced
        if cursor.kind != Kind.MEMBER_REF_EXPR or field is None or (
                field.kind != Kind.FIELD_DECL):
            return
        word = self.word(cursor)
        for other in field.semantic_parent.get_children():
            if other.kind == Kind.FIELD_DECL and other.spelling != field.spelling \
                    and word.endswith(field.spelling) and (
                        other.type.get_canonical() == field.type.get_canonical()):
                self.choose("other member", cursor,
                            word.removesuffix(field.spelling) + other.spelling)
