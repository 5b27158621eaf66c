#!/usr/bin/env python3
"""Compares the table of folders in docs/architecture.md with the #include lines of host/.

Every folder of host/ has a row, which names exactly the folders that its files include; no two folders include each other,
directly or not.
"""
import re
import sys
import unittest
from graphlib import TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^\s*#\s*include "host/(\w+)/', re.MULTILINE)
ROW = re.compile(r"^\| `host/(\w+)` \| .* \| (.*) \|$", re.MULTILINE)


def included_folders():
    """Returns {folder: the other folders that its files include}."""
    found = {folder.name: set() for folder in (ROOT / "host").iterdir() if folder.is_dir()}
    for file in (ROOT / "host").glob("*/*"):
        if file.suffix in (".h", ".cpp"):
            found[file.parent.name] |= set(INCLUDE.findall(file.read_text())) - {file.parent.name}
    return found


def documented_folders():
    """Returns {folder: the folders that its row names}; None for "everything"."""
    rows = ROW.findall((ROOT / "docs/architecture.md").read_text())
    nothing, everything = "none of the others", "everything"
    return {folder: None if text == everything else set() if text == nothing else set(text.split(", "))
            for folder, text in rows}


class Includes(unittest.TestCase):
    def test_table_names_every_folder(self):
        self.assertEqual(set(documented_folders()), set(included_folders()))

    def test_table_names_what_is_included(self):
        found = included_folders()
        for folder, documented in documented_folders().items():
            with self.subTest(folder=folder):
                self.assertEqual(found[folder] if documented is None else documented, found[folder])

    def test_there_is_no_cycle(self):
        self.assertIn("core", list(TopologicalSorter(included_folders()).static_order()))


if __name__ == "__main__":
    sys.exit(unittest.main())
