#!/usr/bin/env python3
"""Checks the rules of docs/style.md that need no reader.

Every source file begins with a comment that says what it contains, and no comment begins with a word that leaves it
without a subject.
"""
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SUFFIXES = {".h", ".cpp", ".c", ".glsl", ".comp", ".vert", ".frag"}
FOLDERS = ("host", "lists", "shaders", "tests")
# Rule 1. "As" begins a comment such as "As that of the base class.", which has no subject, either.
WITHOUT_SUBJECT = re.compile(r"(?:Of|What|That|So many|And|As)\b")
WHOLE_LINE = re.compile(r"\s*//[/!]?<? ?")
TRAILING = re.compile(r"[^\s/\"].*?\s//[/!]?<? ?([A-Z][^\"]*)$")


def comment_beginnings(text):
    """Returns [(line number, first line of a comment)]."""
    found, previous = [], False
    for number, line in enumerate(text.splitlines(), 1):
        whole = WHOLE_LINE.match(line)
        if whole and not previous:
            found.append((number, line[whole.end():]))
        trailing = None if whole else TRAILING.match(line.strip())
        if trailing:
            found.append((number, trailing[1]))
        previous = bool(whole)
    return found


def sources():
    for folder in FOLDERS:
        for file in sorted((ROOT / folder).rglob("*")):
            if file.suffix in SUFFIXES:
                yield file.relative_to(ROOT), file.read_text()


class Comments(unittest.TestCase):
    def test_beginnings_of_comments_are_found(self):
        text = "// One.\n// Of two.\nint a;  ///< Of three\n  /// Four.\n\n// Five.\nauto b = \"x  // Six\";\n"
        self.assertEqual(comment_beginnings(text), [(1, "One."), (3, "Of three"), (4, "Four."), (6, "Five.")])

    def test_every_file_begins_with_a_comment(self):
        self.assertEqual([str(file) for file, text in sources() if not text.startswith(("//", "/*"))], [])

    def test_every_comment_has_a_subject(self):
        wrong = [f"{file}:{number}: {line}" for file, text in sources() for number, line in comment_beginnings(text)
                 if WITHOUT_SUBJECT.match(line)]
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    unittest.main()
