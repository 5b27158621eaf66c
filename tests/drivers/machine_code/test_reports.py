#!/usr/bin/env python3
"""docs/mesa/run_report.py counts instructions and finds wrong values.

    test_reports.py

The device is lavapipe. Its versions execute different instructions, which is what the reports are about.
"""
import os
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "docs" / "mesa"))
import run_report

OPERATIONS = 80  # of the body of the branch in empty_branches.comp


class Reports(unittest.TestCase):
    def test_period_of_addresses(self):
        self.assertEqual(run_report.period([1, 2, 3, 2, 3, 4] * 5), 6)  # an inner loop of two iterations
        self.assertEqual(run_report.period([7, 8, 9] + [1, 2, 3, 4] * 5), 4)  # a beginning that is visited once
        self.assertEqual(run_report.period([1, 2] * 3 + [5, 6, 7] + [1, 2] * 3), 2)

    @unittest.skipUnless(os.uname().machine == "x86_64", "other processors have other registers")
    def test_instructions_of_a_branch(self):
        with tempfile.TemporaryDirectory() as folder:
            runner = run_report.Runner(Path(folder), [], Path(folder))
            without = runner.count("empty_branches", ["CONDITION=0", "WITHOUT_BODY"], (run_report.ROUNDS, 0))
            none, all_of_them = (runner.count("empty_branches", ["CONDITION=0"], (run_report.ROUNDS, lanes)) for lanes in (0, 8))
            lines = Path(folder, f"empty_branches_CONDITION0_{run_report.ROUNDS}_8.txt").read_text().splitlines()
        self.assertEqual(len(lines), all_of_them)
        self.assertGreaterEqual(sum("pmul" in line for line in lines), OPERATIONS // 4)
        self.assertLess(without, none)
        self.assertLessEqual(none, all_of_them)
        self.assertGreaterEqual(all_of_them - without, OPERATIONS)

    def test_wrong_values_are_counted(self):
        with tempfile.TemporaryDirectory() as folder:
            runner = run_report.Runner(Path(folder), [])
            self.assertRegex(runner.check("nested_conditions", []), r"^\d+ of 1024 values differ$|^ended by SIG")
            self.assertEqual(runner.check("empty_branches", ["CONDITION=0"]).split()[0], "896")  # of seven invocations in eight


unittest.main()
