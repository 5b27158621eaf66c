"""Differences of pictures and the tables of the fidelity comparison.

    python3 test_table.py
"""
import contextlib
import io
import json
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from PIL import Image  # noqa: E402

import pictures  # noqa: E402
import table  # noqa: E402


def picture(colour, size=(8, 4), hole=False):
    """Returns a picture of one colour, whose left half is transparent if it has a hole."""
    image = Image.new("RGBA", size, (*colour, 255))
    if hole:
        image.paste((0, 0, 0, 0), (0, 0, size[0] // 2, size[1]))
    return image


class DifferenceTest(unittest.TestCase):
    def test_equal_pictures_differ_by_nothing(self):
        self.assertEqual(pictures.difference(picture((9, 8, 7)), picture((9, 8, 7))), (0, 0))

    def test_the_mean_has_a_sign_and_the_root_mean_square_has_not(self):
        mean, root = pictures.difference(picture((0, 0, 0)), picture((51, 51, 51)))
        self.assertAlmostEqual(mean, -20)
        self.assertAlmostEqual(root, 20)

    def test_pixels_count_that_one_picture_covers(self):
        ours = picture((0, 0, 0), hole=True)
        self.assertAlmostEqual(pictures.difference(ours, picture((51, 51, 51), hole=True))[1], 20)
        self.assertAlmostEqual(pictures.difference(ours, picture((0, 0, 0)))[0], 50)
        self.assertIsNone(pictures.difference(*[Image.new("RGBA", (4, 4))] * 2))

    def test_the_larger_picture_is_reduced_and_other_proportions_are_not_compared(self):
        self.assertAlmostEqual(pictures.difference(picture((0, 0, 0), (16, 8)), picture((51, 51, 51)))[0], -20)
        self.assertIsNone(pictures.difference(picture((0, 0, 0), (8, 8)), picture((0, 0, 0), (8, 4))))


class TableTest(unittest.TestCase):
    def test_a_table_has_the_differences_the_noise_and_the_verdict(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for made in ("ours/khronos-A", "published/khronos-A"):
                (folder / made).mkdir(parents=True)
            scenarios = [{"name": "khronos-A"}, {"name": "khronos-B"}]
            (folder / "config.json").write_text(json.dumps({"scenarios": scenarios}))
            ours = folder / "ours/khronos-A"
            picture((0, 0, 0)).save(ours / table.PICTURE_NAME)
            picture((51, 51, 51)).save(ours / table.NOISE_NAME)
            picture((102, 102, 102)).save(folder / "published/khronos-A/vray-golden.png")
            picture((51, 51, 51)).save(folder / "published/khronos-A/blender-cycles-golden.thumb.webp", lossless=True)
            (ours / table.REPORT_NAME).write_text(json.dumps({"phaseSeconds": {"total": 7.1}}))
            (ours / table.VERDICT_NAME).write_text(json.dumps({"agrees": True, "undecided": None, "interrupted": False,
                                                               "sameLight": {"regions": [{"detectableBias": 0.0012}]}}))
            words = ["table.py"]
            for option, value in (("config", "config.json"), ("ours", "ours"), ("published", "published"),
                                  ("sheets", "sheets")):
                words += [f"--{option}", str(folder / value)]
            with mock.patch("sys.argv", words), contextlib.redirect_stdout(io.StringIO()) as printed:
                table.main()
            lines = printed.getvalue().splitlines()
            self.assertIn("| V-Ray | 1 | -40.0 | 40.0 |", lines)
            row = next(line for line in lines if line.startswith("| A |"))
            self.assertIn("| -40.0 / 40.0 | -20.0 / 20.0 |  |  |  | 20.0 | 8.94 | 7 | same light | 0.12 |", row)
            self.assertIn("| B | not rendered |", lines)
            self.assertTrue((folder / "sheets/khronos-A.png").is_file())


if __name__ == "__main__":
    unittest.main()
