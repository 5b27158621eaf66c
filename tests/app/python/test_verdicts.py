"""Verdicts equal those of the program."""
import json
import unittest

import numpy

import candela
from support import CORNELL, DEVICE, SMALL, FolderTest, cornell, run, with_keywords, words_of


def without_times(report):
    return {name: value for name, value in report.items() if "econds" not in name}


def in_python(report):
    """A report of the program with keywords instead of options in all texts."""
    if isinstance(report, dict):
        return {key: in_python(value) for key, value in report.items()}
    if isinstance(report, list):
        return [in_python(value) for value in report]
    return with_keywords(report) if isinstance(report, str) else report


class Verdicts(FolderTest):
    def check(self, outcome, *words, code=0):
        done = run(*words, "--json", self.folder / "report.json", code=code)
        self.assertEqual(outcome.text, with_keywords(done.stdout))
        self.assertEqual(str(outcome), outcome.text)
        report = json.loads((self.folder / "report.json").read_text())
        self.assertEqual(without_times(outcome.report), without_times(in_python(report)))
        self.assertIs(outcome.agrees, {0: True, 3: False, 8: None}[code])

    def test_verify(self):
        options = {"size": (24, 24), "device": DEVICE, "alpha": "0.01%"}
        verdict = candela.verify(cornell(), **options)
        self.check(verdict, "verify", CORNELL, *words_of(options))
        self.assertTrue(verdict)
        self.assertIn(verdict.verdict, verdict.text)

    def test_compare_tracers(self):
        options = {**SMALL, "device": DEVICE}
        self.check(candela.compare(cornell(), **options), "compare", CORNELL, *words_of(options))

    def test_explain(self):
        options = {"size": (24, 24), "device": DEVICE, "pixel": (12, 9), "sample": 3}
        explanation = candela.explain(cornell(), **options)
        self.check(explanation, "explain", CORNELL, *words_of(options))
        self.assertIn("12,9", explanation.text)
        worst = candela.explain(cornell(), size=(24, 24), device=DEVICE)
        self.assertEqual(worst.text, run("explain", CORNELL, "--size", "24x24", "--device", DEVICE).stdout)

    def test_compare_films(self):
        options = {**SMALL, "spp": 64, "device": "cpu"}
        a, b = (candela.render(cornell(), **options, seed=seed) for seed in (1, 2))
        darker = candela.render(cornell(env="white", env_scale=0.1), **options, seed=3)
        for name, film in (("a", a), ("b", b), ("darker", darker)):
            film.save(self.folder / f"{name}.exr")
        files = {name: self.folder / f"{name}.exr" for name in ("a", "b", "darker")}
        self.check(candela.compare(a, b, bias=0.9), "compare", files["a"], files["b"], "--bias", "90%")
        self.check(candela.compare(a, files["b"], bias=0.9), "compare", files["a"], files["b"], "--bias", "90%")
        undecided = candela.compare(a, b)
        self.check(undecided, "compare", files["a"], files["b"], code=8)
        with self.assertRaisesRegex(candela.UndecidedError, "noise may hide"):
            bool(undecided)
        self.check(candela.compare(a, darker), "compare", files["a"], files["darker"], code=3)
        self.check(candela.compare(a, b, tolerance=1e-9), "compare", files["a"], files["b"], "--tolerance", "1e-9", code=3)

    def test_compare_arrays(self):
        film = candela.render(cornell(), **SMALL, device="cpu")
        same = candela.compare(film.image, film.image.astype(numpy.float64), tolerance=0)
        self.assertTrue(same)
        self.assertEqual(same.report["worst"]["difference"], 0)
        brighter = candela.compare(film.image[:, ::-1] * 1.5, film.image[:, ::-1])
        self.assertIsNone(brighter.agrees)
        self.assertAlmostEqual(brighter.report["relativeMeanDifference"], 0.5, 5)
        with self.assertRaisesRegex(candela.UsageError, "there is no verdict"):
            bool(brighter)
        for wrong in (film.variance, 3, "missing.exr", None):
            with self.assertRaises(candela.Error):
                candela.compare(film, wrong)
        cut = candela.compare(film, film.image[:5])
        self.assertIs(cut.agrees, False)
        self.assertIn("pixel by pixel", cut.verdict)
        self.assertTrue(candela.compare(film, film.image, tolerance=0, channels=["R", "G", "B"]))


if __name__ == "__main__":
    unittest.main()
