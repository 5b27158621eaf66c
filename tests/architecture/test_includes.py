#!/usr/bin/env python3
"""Compares the tables of folders in docs/architecture.md and docs/tiers.md with the #include lines of host/ and shaders/.

Every folder of host/ has a row, or belongs to the folder around it. The row names exactly the folders that its files include; no
two folders include each other, directly or not. The folders of host/ are the tiers, each of which includes only itself and those
below it. The reference's light transport does not include its error model. Shaders include only shaders and lists, and lists include only lists.
"""
import re
import sys
import unittest
from graphlib import TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^\s*#\s*include "host/([^"]+)"', re.MULTILINE)
ROW = re.compile(r"^\| `host/([\w/]+)` \| .* \| (.*) \|$", re.MULTILINE)
TIER = re.compile(r"^\| (\w+) \| ([\w, ]*) \| .* \|$", re.MULTILINE)
QUOTED = re.compile(r'^\s*#\s*include "([^"]+)"', re.MULTILINE)


def documented_folders():
    """Returns {folder: the folders that its row names}; None for "everything"."""
    rows = ROW.findall((ROOT / "docs/architecture.md").read_text())
    nothing, everything = "none of the others", "everything"
    return {folder: None if text == everything else set() if text == nothing else set(text.split(", "))
            for folder, text in rows}


def folder_of(path, folders):
    """Returns the folder that has a row and contains the file, the innermost one; the file's own folder if there is none."""
    parents = [str(parent) for parent in Path(path).parents]
    return next((parent for parent in parents if parent in folders), parents[0])


def included_folders():
    """Returns {folder: the other folders that its files include}."""
    folders = documented_folders()
    found = {}
    for file in (ROOT / "host").rglob("*"):
        if file.suffix in (".h", ".cpp"):
            folder = folder_of(file.relative_to(ROOT / "host"), folders)
            found.setdefault(folder, set()).update(folder_of(name, folders) for name in INCLUDE.findall(file.read_text()))
    return {folder: included - {folder} for folder, included in found.items()}


def tiers():
    """Returns {tier: the folders in it that the plan names}, from the bottom to the top."""
    section = (ROOT / "docs/tiers.md").read_text().split("## Rules")[0]
    return {tier: set(folders.split(", ")) - {""} for tier, folders in TIER.findall(section) if tier != "tier"}


def tier_of(folder):
    return folder.split("/")[0]


def above(included):
    """Returns the pairs of folders of which the first includes the second, which belongs to a tier above its own."""
    floor = {tier: i for i, tier in enumerate(tiers())}
    return {(folder, other) for folder, others in included.items() for other in others
            if floor[tier_of(other)] > floor[tier_of(folder)]}


class Includes(unittest.TestCase):
    def test_table_names_every_folder(self):
        self.assertEqual(set(documented_folders()), set(included_folders()))

    def test_table_names_what_is_included(self):
        found = included_folders()
        for folder, documented in documented_folders().items():
            with self.subTest(folder=folder):
                self.assertEqual(found[folder] if documented is None else documented, found[folder])

    def test_there_is_no_cycle(self):
        self.assertIn("base", list(TopologicalSorter(included_folders()).static_order()))


class Reference(unittest.TestCase):
    def test_light_transport_does_not_include_the_error_model(self):
        found = {file.name for file in (ROOT / "host/trace/reference").glob("*.*")
                 if '#include "host/trace/reference/rounding/' in file.read_text()}
        self.assertEqual(found, {"reference_session.h", "tile_job.h"})


class Tiers(unittest.TestCase):
    def test_the_plan_names_every_folder(self):
        found = {folder.name: {child.name for child in folder.iterdir() if child.is_dir() and any(child.glob("*.h"))}
                 for folder in (ROOT / "host").iterdir() if folder.is_dir()}
        self.assertEqual(tiers(), found)

    def test_tests_are_in_the_tiers_of_their_subjects(self):
        """A folder of tests that belongs to no tier is about the whole."""
        folders = {folder.name for folder in (ROOT / "tests").iterdir() if folder.is_dir()}
        self.assertEqual(folders - set(tiers()), {"architecture", "catch2_3", "farm", "faults", "fidelity", "fuzz", "guard", "install", "mutants"})

    def test_no_folder_includes_a_tier_above_its_own(self):
        self.assertEqual(above(included_folders()), set())

    def test_an_include_of_a_tier_above_is_found(self):
        included = included_folders()
        included["image"].add("trace/reference")
        self.assertEqual(above(included), {("image", "trace/reference")})

    def check_root_folders(self, including, permitted):
        """Every file of a folder of the root includes only files of the permitted folders."""
        files = list((ROOT / including).rglob("*.*"))
        self.assertGreater(len(files), 3)
        for file in files:
            for name in QUOTED.findall(file.read_text()):
                found = [folder / name for folder in (file.parent, ROOT / "shaders") if (folder / name).exists()]
                with self.subTest(file=file.name, include=name):
                    self.assertTrue(found, "no such file")
                    self.assertIn(found[0].resolve().relative_to(ROOT).parts[0], permitted)

    def test_shaders_include_only_shaders_and_lists(self):
        self.check_root_folders("shaders", ("shaders", "lists"))

    def test_lists_include_only_lists(self):
        self.check_root_folders("lists", ("lists",))


if __name__ == "__main__":
    sys.exit(unittest.main())
