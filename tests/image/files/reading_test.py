"""Image files that oiiotool makes, as environments and in comparisons."""
import struct
import unittest

from support import ImageFileTest

# A ball behind the camera, so that the environment fills the view.
SCENE = """v
from 0 0 4
at 0 0 0
up 0 1 0
angle 40
hither 0
resolution 16 16
f 1 1 1 1 0 0 0 0 1 0 1 0 0 0
s 0 0 9 1
"""


class Reading(ImageFileTest):
    def setUp(self):
        super().setUp()
        (self.folder / "a.p3f").write_text(SCENE)

    def seen(self, file, *words):
        """Returns the mean of red, green and blue in a view of the environment, and the messages."""
        result = self.candela("a.p3f", "--env", file, "--device", "cpu", "--spp", "4", "-o", "seen.exr", *words)
        self.assertEqual(result.returncode, 0, result.stderr)
        return self.statistic("seen.exr")[:3], result.stderr

    def assertSeen(self, file, colour, tolerance=1e-5):
        for value, expected in zip(self.seen(file)[0], colour):
            self.assertLessEqual(abs(value - expected), tolerance * expected + 1e-7, file)

    def test_one_reader(self):
        """One colour in all formats and depths is the same environment, as oiiotool reads it."""
        fill = ["--create", "16x8", "3", "--fill:color=.25,.5,.75", "16x8"]
        self.oiiotool(*fill, "-d", "float", "-o", "a.exr")
        self.oiiotool(*fill, "-d", "half", "-o", "half.exr")
        with open(self.path("a.pfm"), "wb") as file:
            file.write(b"PF\n16 8\n-1.0\n" + 128 * struct.pack("<3f", 0.25, 0.5, 0.75))
        self.oiiotool(*fill, "-o", "a.hdr")
        for file in ("a.exr", "half.exr", "a.pfm", "a.hdr"):
            self.assertSeen(file, (0.25, 0.5, 0.75))
        linear = [((value + 0.055) / 1.055) ** 2.4 for value in (0.25, 0.5, 0.75)]
        self.oiiotool(*fill, "-d", "uint16", "-o", "deep.png")
        self.assertSeen("deep.png", linear, 1e-4)
        for name, tolerance in (("a.png", 0.02), ("a.jpg", 0.02), ("a.webp", 0.05)):  # WebP with losses
            self.oiiotool(*fill, "-d", "uint8", "--quality", "100", "-o", name)
            self.assertSeen(name, linear, tolerance)

    def test_pfm_scale(self):
        with open(self.path("a.pfm"), "wb") as file:
            file.write(b"PF\n2 1\n-2.5\n" + struct.pack("<6f", 1, 2, 3, 1, 2, 3))
        self.assertEqual(self.statistic("a.pfm"), [2.5, 5.0, 7.5])
        self.assertSeen("a.pfm", (2.5, 5, 7.5))

    def test_display_window(self):
        """An environment whose pixels fill the lower half of its frame equals one with black pixels in the upper half."""
        self.oiiotool("--create", "32x8", "3", "--fill:color=1,2,3", "32x8", "--origin", "+0+8", "--fullsize", "32x16+0+0",
                      "-d", "float", "-o", "part.exr")
        self.oiiotool("part.exr", "--croptofull", "-o", "whole.exr")
        self.assertEqual(self.seen("part.exr")[0], self.seen("whole.exr")[0])
        self.assertNotEqual(self.statistic("seen.exr")[:3], [1.0, 2.0, 3.0])

    def test_parts_and_layers(self):
        self.oiiotool("--create", "8x4", "3", "-o", "a.exr")
        self.oiiotool("a.exr", "a.exr", "--siappend", "-o", "parts.exr")
        self.oiiotool("--create", "8x4", "6", "--chnames", "a.R,a.G,a.B,b.R,b.G,b.B", "-o", "layers.exr")
        self.oiiotool("--create", "8x4", "2", "--chnames", "R,G", "-o", "two.exr")
        for file, message in (("parts.exr", "several parts"), ("layers.exr", "several layers"), ("two.exr", "it has")):
            result = self.candela("a.p3f", "--env", file, "--device", "cpu", "-o", "seen.exr")
            self.assertEqual(result.returncode, 2, file)
            self.assertIn(message, result.stderr)
            self.assertFalse((self.folder / "seen.exr").exists())
        self.oiiotool("--create", "8x4", "3", "--fill:color=1,2,3", "8x4", "--chnames", "a.R,a.G,a.B", "-o", "one.exr")
        colour, messages = self.seen("one.exr")
        self.assertEqual(colour, [1.0, 2.0, 3.0])
        self.assertIn('one.exr: the file has no channels R, G and B; those of its layer "a" are read', messages)

    def test_kinds_of_files_that_are_refused(self):
        """Each is refused by name with exit code 2, as an environment and in a comparison."""
        self.oiiotool("--create", "8x4", "3", "-d", "float", "-o", "a.exr")
        deep = bytearray((self.folder / "a.exr").read_bytes())
        deep[5] |= 8  # the flag of deep pixels
        (self.folder / "deep.exr").write_bytes(deep)
        self.oiiotool("--create", "8x4", "3", "--chnames", "Y,RY,BY", "-o", "chroma.exr")
        (self.folder / "xyze.hdr").write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n\x80\x80\x80\x81")
        for file, message in (("deep.exr", "deep EXR files are not read"), ("chroma.exr", "luminance and chroma"),
                              ("xyze.hdr", "HDR files of the format 32-bit_rle_xyze are not read")):
            for words in (("a.p3f", "--env", file, "--device", "cpu", "-o", "seen.exr"), ("compare", file, file)):
                result = self.candela(*words)
                self.assertEqual(result.returncode, 2, words)
                self.assertIn(f"cannot read \"{file}\": ", result.stderr)
                self.assertIn(message, result.stderr)
        self.assertFalse((self.folder / "seen.exr").exists())

    def test_pixels_that_are_not_finite(self):
        with open(self.path("a.pfm"), "wb") as file:
            file.write(b"Pf\n4 2\n-1.0\n" + struct.pack("<8f", 1, float("inf"), 1, 1, 1, float("nan"), 1, 1))
        result = self.candela("a.p3f", "--env", "a.pfm", "--device", "cpu", "-o", "seen.exr")
        self.assertEqual(result.returncode, 2)
        self.assertIn("--lenient", result.stderr)
        self.assertIn("a.pfm: 2 of 8 pixels are not finite, and are replaced by black", self.seen("a.pfm", "--lenient")[1])


if __name__ == "__main__":
    unittest.main()
