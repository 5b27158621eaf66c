#!/usr/bin/env python3
"""Tests what gpu_compilers.py judges, records and prints, with made reports."""
import collections
import contextlib
import io
import json
import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

import gpu_compilers

FIGURES = [0.5, 0, None, 100, 1000]


def row(figures=FIGURES, kernel="megakernel"):
    return {"kernel": kernel, **dict(zip(gpu_compilers.FIGURES, figures))}


def report(rows, driver="radv Mesa 26.2.6-1"):
    return {"device": "made", "driver": driver, "cases": {"a.p3f": rows, "model.glb": rows}, "recorded": ["a.p3f"],
            "conformance": {}, "notices": collections.Counter()}


def run(command, reports, baseline, **options):
    """The exit code, what was printed, and the baseline afterwards."""
    given = types.SimpleNamespace(**{"cases": "", "threshold": 0.05, "replace": False} | options)
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as printed:
        file = Path(folder) / "baseline.json"
        file.write_text(json.dumps(baseline))
        with mock.patch.object(gpu_compilers, "BASELINE", file):
            code = command(given, reports)
        return code, printed.getvalue(), json.loads(file.read_text())


def baseline(figures=FIGURES, version="26.2.6", name="a.p3f: megakernel"):
    return {version: {"navi21": {name: figures}}}


def check(figures, recorded=None, **options):
    return run(gpu_compilers.check, {"navi21": report([row(figures)])}, recorded or baseline(), **options)


class Check(unittest.TestCase):
    def test_equal_figures_pass(self):
        code, printed, _ = check(FIGURES)
        self.assertEqual((code, printed), (0, "1 kernels compared, 0 became worse or have no counterpart\n"))

    def test_worse_figures_fail(self):
        for figures in ([0.4999, 0, None, 100, 1000], [0.5, 1, None, 100, 1000], [0.5, 0, None, 100, 1051],
                        [None, 0, None, 100, 1000]):
            code, printed, _ = check(figures)
            self.assertEqual(code, 1, figures)
            self.assertIn("FAILED: navi21, a.p3f: megakernel: ", printed)

    def test_better_figures_and_small_changes_are_listed(self):
        for figures in ([0.75, 0, None, 100, 1000], [0.5, 0, None, 200, 1000], [0.5, 0, None, 100, 1050], [0.5, 0, 0, 100, 1000]):
            code, printed, _ = check(figures)
            self.assertEqual(code, 0, figures)
            self.assertIn("changed: navi21, a.p3f: megakernel: ", printed)

    def test_a_kernel_on_one_side_only_fails(self):
        code, printed, _ = check(FIGURES, baseline(name="b.p3f: megakernel"))
        self.assertEqual(code, 1)
        self.assertIn("b.p3f: megakernel: figures are recorded, but there is no such kernel", printed)
        self.assertIn("a.p3f: megakernel: no figures are recorded", printed)

    def test_scenes_that_were_not_chosen_are_not_missed(self):
        recorded = baseline()
        recorded["26.2.6"]["navi21"]["b.p3f: megakernel"] = FIGURES
        self.assertEqual(check(FIGURES, recorded, cases="^a")[0], 0)
        self.assertEqual(check(FIGURES, recorded)[0], 1)

    def test_another_version_of_mesa_is_skipped(self):
        self.assertEqual(check(FIGURES, baseline(version="26.3.0"))[0], gpu_compilers.SKIP)

    def test_a_scene_that_failed_fails_with_any_version(self):
        reports = {"navi21": report([row()])}
        reports["navi21"]["cases"]["model.glb"] = None
        for version in ("26.2.6", "26.3.0"):
            self.assertEqual(run(gpu_compilers.check, reports, baseline(version=version))[0], 1)

    def test_a_conformance_case_that_did_not_compile_fails(self):
        reports = {"navi21": report([row()])}
        for outcome, code in (("Pass", 0), ("Skip", 0), ("Fail", 1), ("Crash", 1), ("Timeout", 1)):
            reports["navi21"]["conformance"] = {"leaf.film.sums": outcome}
            self.assertEqual(run(gpu_compilers.check, reports, baseline())[0], code, outcome)

    def test_reports_of_two_versions_are_refused(self):
        reports = {"navi21": report([row()]), "m1": report([row()], "Honeykrisp Mesa 26.3.0")}
        with self.assertRaises(gpu_compilers.Failure):
            run(gpu_compilers.check, reports, baseline())


class Record(unittest.TestCase):
    def test_figures_are_added_but_replaced_only_on_request(self):
        reports = {"navi21": report([row([0.5, 0, None, 100, 900])])}
        code, _, recorded = run(gpu_compilers.record, reports, {})
        self.assertEqual((code, recorded), (0, baseline([0.5, 0, None, 100, 900])))
        code, _, recorded = run(gpu_compilers.record, reports, baseline())
        self.assertEqual((code, recorded), (1, baseline()))
        code, _, recorded = run(gpu_compilers.record, reports, baseline(), replace=True)
        self.assertEqual((code, recorded), (0, baseline([0.5, 0, None, 100, 900])))

    def test_figures_of_other_scenes_and_gpus_are_kept(self):
        other, new = [0.5, 0, None, 100, 800], [0.5, 0, None, 100, 900]
        old = {"navi21": {"b.p3f: megakernel": other, "a.p3f: megakernel": FIGURES, "a.p3f: gone": FIGURES},
               "m1": {"a.p3f: megakernel": other}}
        reports = {"navi21": report([row(new)])}
        code, _, recorded = run(gpu_compilers.record, reports, {"26.2.6": old}, cases="^a", replace=True)
        expected = old | {"navi21": {"b.p3f: megakernel": other, "a.p3f: megakernel": new}}
        self.assertEqual((code, recorded), (0, {"26.2.6": expected}))
        code, _, recorded = run(gpu_compilers.record, reports, {"26.2.6": old}, replace=True)
        expected["navi21"] = {"a.p3f: megakernel": new}
        self.assertEqual((code, recorded), (0, {"26.2.6": expected}))

    def test_only_the_figures_of_chosen_scenes_are_added(self):
        reports = {"navi21": report([row()])}
        code, _, recorded = run(gpu_compilers.record, reports, baseline(name="b.p3f: megakernel"), cases="^b", replace=True)
        self.assertEqual((code, recorded), (0, {"26.2.6": {"navi21": {}}}))

    def test_nothing_is_recorded_if_a_scene_or_a_case_failed(self):
        code, _, recorded = run(gpu_compilers.record, {"navi21": report(None)}, {})
        self.assertEqual((code, recorded), (1, {}))
        reports = {"navi21": report([row()]) | {"conformance": {"leaf.film.sums": "Crash"}}}
        self.assertEqual(run(gpu_compilers.record, reports, {})[0], 1)


class Table(unittest.TestCase):
    def test_the_worst_figures_are_printed(self):
        rows = [row(), row([0.25, 7, None, 50, 2000])]
        printed = run(gpu_compilers.table, {"navi21": report(rows)}, {})[1]
        self.assertIn("| megakernel | 25.0 %; 7; 2,000 |", printed)


if __name__ == "__main__":
    unittest.main()
