"""`candela compare A B` on files that oiiotool makes."""
import unittest

from support import ImageFileTest


class Compare(ImageFileTest):
    def make(self, name, *words, size="16x16", channels=3):
        noise = ["--noise:type=uniform:min=0.1:max=0.9:seed=3"]
        self.oiiotool("--create", size, str(channels), *noise, *words, "-o", name)

    def test_alpha(self):
        for suffix, depth in ((".exr", "float"), (".png", "uint8"), (".png", "uint16")):
            for name, alpha in (("a", "0.25"), ("b", "0.5")):
                self.make(name + suffix, "--ch", f"R,G,B,A={alpha}", "-d", depth)
            code, report = self.compare("a" + suffix, "b" + suffix, "--tolerance", "0")
            self.assertEqual(code, 3, suffix)
            self.assertIn("A", report["exceeding"])
            self.assertEqual(self.compare("a" + suffix, "a" + suffix, "--tolerance", "0")[0], 0)

    def test_opaque_files_equal_files_without_alpha(self):
        self.make("a.png")
        self.make("b.png", "--ch", "R,G,B,A=1")
        self.assertEqual(self.compare("a.png", "b.png", "--tolerance", "0")[0], 0)

    def test_depth_of_png_files(self):
        """Two neighbouring values of 16 bits are different, and equal in 8 bits."""
        for depth, code in (("uint16", 3), ("uint8", 0)):
            for name, value in (("a", 32896 / 65535), ("b", 32897 / 65535)):
                self.oiiotool("--create", "4x4", "3", "--fill:color=%.9f,%.9f,%.9f" % ((value,) * 3), "4x4", "-d", depth,
                              "-o", name + ".png")
            self.assertEqual(self.compare("a.png", "b.png", "--tolerance", "0")[0], code)

    def test_places(self):
        frame = ["--fullsize", "32x32+0+0", "-o"]
        self.make("origin.exr", "-d", "float", *frame[:2])
        self.make("moved.exr", "--origin", "+16+16", "-d", "float", *frame[:2])
        code, report = self.compare("origin.exr", "moved.exr", "--tolerance", "1e9")
        self.assertEqual(code, 3)
        self.assertEqual(report["apart"], "A has the window 0,0,16,16 of the frame and B the window 16,16,16,16, "
                                          "neither of which contains the other")

        self.make("whole.exr", "-d", "float", size="32x32")
        self.oiiotool("whole.exr", "--cut", "16x12+8+4", "--origin", "+8+4", "--fullsize", "32x32+0+0", "-o", "crop.exr")
        for pair in (("whole.exr", "crop.exr"), ("crop.exr", "whole.exr")):
            code, report = self.compare(*pair, "--tolerance", "0")
            self.assertEqual(code, 0)
            self.assertEqual((report["window"], report["frame"]), ("8,4,16,12", "0,0,32,32"))
        self.oiiotool("whole.exr", "--cut", "16x12+9+4", "--origin", "+8+4", "--fullsize", "32x32+0+0", "-o", "crop.exr")
        self.assertEqual(self.compare("whole.exr", "crop.exr", "--tolerance", "1e-6")[0], 3)

    def test_frames(self):
        self.make("a.exr")
        self.make("b.exr", "--fullsize", "16x17+0+0")
        self.make("c.png", size="16x17")
        for other in ("b.exr", "c.png"):
            code, report = self.compare("a.exr", other)
            self.assertEqual(code, 3)
            self.assertIs(report["agrees"], False)
            self.assertIn("the size 16x17", report["apart"])

    def test_layers(self):
        self.make("a.exr", "--chnames", "R,G,B,N.X,N.Y,variance.Y", "-d", "float", channels=6)
        for changed, code in (("N.Y", 3), ("variance.Y", 0), ("G", 3)):
            names = [f"{name}=0.5" if name == changed else name for name in "R,G,B,N.X,N.Y,variance.Y".split(",")]
            self.oiiotool("a.exr", "--ch", ",".join(names), "-d", "float", "-o", "b.exr")
            self.assertEqual(self.compare("a.exr", "b.exr", "--tolerance", "1e-6")[0], code, changed)
        self.oiiotool("a.exr", "--ch", "R,G,B,N.X,N.Y=0.5", "-d", "float", "-o", "b.exr")
        for selection, code in (("N", 3), ("normal", 3), ("N.X", 0), ("R,G,B", 0), ("Z", 1)):
            result = self.candela("compare", "a.exr", "b.exr", "--tolerance", "1e-6", "--channels", selection)
            self.assertEqual(result.returncode, code, selection)


if __name__ == "__main__":
    unittest.main()
