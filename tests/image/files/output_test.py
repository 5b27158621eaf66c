"""Image files that Candela writes, as oiiotool reads them."""
import os
import pty
import struct
import subprocess
import unittest

from support import PROGRAM, ImageFileTest

# A ball below a point light, before a background.
SCENE = """b .2 .3 .4
v
from 0 0 4
at 0 0 0
up 0 1 0
angle 40
hither 0
resolution 24 18
l 2 2 4 1 1 1
f .8 .6 .4 1 0 0 0 0 1 0 1 0 0 0
s 0 0 0 1
"""


class Output(ImageFileTest):
    def setUp(self):
        super().setUp()
        (self.folder / "a.p3f").write_text(SCENE)

    def render(self, *words, **options):
        return self.candela("a.p3f", "--device", "cpu", "--spp", "2", *words, **options)

    def test_hdr_has_no_bias(self):
        """An environment of 10^5 values, seen through a camera, has the same mean in both formats."""
        values = [0.05 + 9 * i / 1e5 for i in range(100000)]
        with open(self.path("ramp.pfm"), "wb") as file:
            file.write(b"Pf\n1000 100\n-1.0\n" + struct.pack("<100000f", *values))
        # The environment fills the view: the only ball is behind the camera.
        scene = SCENE.split("l 2")[0].replace("resolution 24 18", "resolution 400 300")
        (self.folder / "sky.p3f").write_text(scene + "f 1 1 1 1 0 0 0 0 1 0 1 0 0 0\ns 0 0 9 1\n")
        result = self.candela("sky.p3f", "--env", "ramp.pfm", "--device", "cpu", "--spp", "1", "-o", "a.hdr", "-o", "a.exr")
        self.assertEqual(result.returncode, 0, result.stderr)
        for a, b in zip(self.statistic("a.hdr"), self.statistic("a.exr")):
            self.assertLess(abs(a / b - 1), 2e-4)
        code, report = self.compare("a.hdr", "a.exr")
        self.assertLess(abs(report["relativeMeanDifference"]), 2e-4)

    def test_crop_has_the_frame_as_display_window(self):
        for words in (["-o", "crop.exr"], ["--denoise", "-o", "crop.exr"]):
            self.assertEqual(self.render("--crop", "5,4,10,6", *words).returncode, 0)
            info = self.oiiotool("--info", "-v", "crop.exr")
            self.assertIn("10 x    6", info)
            self.assertIn("pixel data origin: x=5, y=4", info)
            self.assertIn("full/display size: 24 x 18", info)
        self.assertEqual(self.render("-o", "whole.exr").returncode, 0)
        self.assertEqual(self.render("--crop", "5,4,10,6", "-o", "crop.exr", "--checkpoint", "film.exr").returncode, 0)
        self.assertEqual(self.compare("crop.exr", "whole.exr", "--tolerance", "0")[0], 0)
        self.assertEqual(self.candela("film", "film.exr", "-o", "again.exr").returncode, 0)
        self.assertEqual(self.compare("crop.exr", "again.exr", "--tolerance", "0")[0], 0)

    def test_stdout(self):
        for name in ("a.png", "a.exr", "a.hdr", "a.pfm", "a.jpg"):
            self.assertEqual(self.render("-o", name).returncode, 0)
            target = "-" if name == "a.png" else "-" + name[1:]
            result = self.render("-o", target, "-o", "b" + name[1:], "--stats", binary=True)
            self.assertEqual(result.returncode, 0)
            self.assertEqual(result.stdout, (self.folder / ("b" + name[1:])).read_bytes(), name)
            self.assertIn(b"samples", result.stderr)
            if name != "a.exr":  # whose metadata may differ
                self.assertEqual(result.stdout, (self.folder / name).read_bytes(), name)
        self.assertFalse((self.folder / "-").exists() or (self.folder / "-.exr").exists())
        self.assertEqual(self.render("-o", "./-.exr").returncode, 0)
        self.assertTrue((self.folder / "-.exr").exists())

    def test_pictures_of_differences_on_stdout(self):
        self.assertEqual(self.render("-o", "a.exr").returncode, 0)
        result = self.candela("compare", "a.exr", "a.exr", "--diff", "-", binary=True)
        self.assertTrue(result.stdout.startswith(b"\x89PNG"))
        self.assertIn(b"identical", result.stderr)

    def test_stdout_has_one_image_alone(self):
        for words in (["-o", "-", "--json", "-"], ["-o", "-", "-o", "-.exr"]):
            result = self.render(*words)
            self.assertEqual(result.returncode, 1)
            self.assertIn("the only output there", result.stderr)
            self.assertEqual(result.stdout, "")

    def test_stdout_that_cannot_be_written(self):
        with open("/dev/full", "wb") as full:
            result = subprocess.run([PROGRAM, "a.p3f", "--device", "cpu", "-o", "-"], cwd=self.folder, stdout=full,
                                    stderr=subprocess.PIPE, text=True)
        self.assertEqual(result.returncode, 2)
        self.assertIn("cannot write to stdout", result.stderr)

    def test_a_closed_pipe(self):
        """Whoever closed the pipe needs no message, and other files are written."""
        for target in ("-", "-.exr", "-.hdr"):
            ours, theirs = os.pipe()
            os.close(ours)
            result = subprocess.run([PROGRAM, "a.p3f", "--device", "cpu", "--spp", "1", "-q", "-o", target, "-o", "beside.pfm"],
                                    cwd=self.folder, stdout=theirs, stderr=subprocess.PIPE, text=True)
            os.close(theirs)
            self.assertEqual(result.returncode, 2, target)
            self.assertEqual(result.stderr, "", target)
            self.assertTrue((self.folder / "beside.pfm").exists())
            (self.folder / "beside.pfm").unlink()

    def test_terminals_are_refused(self):
        ours, theirs = pty.openpty()
        result = subprocess.run([PROGRAM, "a.p3f", "--device", "cpu", "-o", "-"], cwd=self.folder, stdout=theirs,
                                stderr=subprocess.PIPE, text=True)
        os.close(ours)
        os.close(theirs)
        self.assertEqual(result.returncode, 1)
        self.assertIn("stdout is a terminal", result.stderr)


if __name__ == "__main__":
    unittest.main()
