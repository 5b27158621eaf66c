#!/usr/bin/env python3
"""Checks that no section of a Catch2 test is in a loop.

Catch2 enters a section at most once in each run of its test case, so that a loop around one leaves out most of the
combinations without a word. Loops belong into the section, or become GENERATE.
"""
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
STRING_OR_COMMENT = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*')
LOOP = re.compile(r"\b(?:for|while)\s*\(")
SECTION = re.compile(r"\b(?:SECTION|DYNAMIC_SECTION|onBoth\w+|onAllRenderers)\s*\(")
OPENING, CLOSING = "({[", ")}]"


def end_of(text, start, closes):
    """Returns the position behind the first character outside brackets for which `closes` is true."""
    depth = 0
    for position in range(start, len(text)):
        depth += (text[position] in OPENING) - (text[position] in CLOSING)
        if depth == 0 and closes(text[position]):
            return position + 1
    return len(text)


def loops(text):
    """Returns the ranges of the bodies of all loops: a block, or one statement."""
    found = []
    for match in LOOP.finditer(text):
        body = end_of(text, match.end() - 1, lambda c: c == ")")
        while text[body].isspace():
            body += 1
        found.append((body, end_of(text, body, lambda c: c in "};" if text[body] == "{" else c == ";")))
    return found


def sections_in_loops(text):
    """Returns the line numbers of sections in loops."""
    plain = STRING_OR_COMMENT.sub(lambda match: " " * len(match[0]), text)
    bodies = loops(plain)
    return [plain.count("\n", 0, match.start()) + 1 for match in SECTION.finditer(plain)
            if any(first <= match.start() < end for first, end in bodies)]


class Sections(unittest.TestCase):
    def test_no_section_is_in_a_loop(self):
        found = [f"{file.relative_to(ROOT)}:{line}" for file in sorted((ROOT / "tests").rglob("*.cpp"))
                 for line in sections_in_loops(file.read_text())]
        self.assertEqual(found, [])

    def test_the_check_finds_one(self):
        self.assertEqual(sections_in_loops('for (int i : {1, 2}) {\n  SECTION("a") { f(i); }\n}'), [2])
        self.assertEqual(sections_in_loops("for (int i = 0; i < 2; ++i)\n  onBothTracers([&] { f(i); });\n"), [2])
        self.assertEqual(sections_in_loops('SECTION("a") {\n  for (int i : {1, 2}) f(i);\n}\nSECTION("b") {}'), [])
        self.assertEqual(sections_in_loops('for (;;) f("SECTION()");  // SECTION()\nSECTION("b") {}'), [])


if __name__ == "__main__":
    unittest.main()
