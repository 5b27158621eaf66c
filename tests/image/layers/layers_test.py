"""Layers as other programs read them: OpenImageIO, its iinfo, and OpenEXR's exrheader."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy
import OpenImageIO

PROGRAM = os.environ["CANDELA_PROGRAM"]
LAYERS = "normal,albedo,depth,position,uv,direct,indirect,emission,variance,samples"
CHANNELS = {"R", "G", "B", "variance.Y", "samples", "N.X", "N.Y", "N.Z", "albedo.R", "albedo.G", "albedo.B", "Z",
            "P.X", "P.Y", "P.Z", "uv.U", "uv.V", "direct.R", "direct.G", "direct.B", "indirect.R", "indirect.G",
            "indirect.B", "emission.R", "emission.G", "emission.B"}

# A floor z = 0 of albedo (.75, .5, .25) below the eye, which looks straight down from z = 4, and a point light at the eye.
SCENE = """b 0 0 0
v
from 0 0 4
at 0 0 0
up 0 1 0
angle 90
hither 0
resolution 32 32
l 0 0 4 1 1 1
f .75 .5 .25 1 0 0 0 0 1 0 1 0 0 0
p 4
-2 -9 0
9 -9 0
9 9 0
-2 9 0
"""


def read(file):
    """Returns the channels of an EXR file by name, each an array of rows."""
    picture = OpenImageIO.ImageInput.open(str(file))
    names = picture.spec().channelnames
    pixels = picture.read_image(format="float")
    return {name: pixels[:, :, i].astype(float) for i, name in enumerate(names)}


class Layers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.folder.name)
        cls.file = folder / "layers.exr"
        scene = folder / "floor.p3f"
        scene.write_text(SCENE)
        subprocess.run([PROGRAM, scene, "-o", cls.file, "--aov", LAYERS, "--spp", "0", "--device", "cpu", "--quiet"],
                       check=True)
        cls.channels = read(cls.file)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_names(self):
        self.assertEqual(set(self.channels), CHANNELS)

    def test_header_programs(self):
        header = subprocess.run(["exrheader", self.file], check=True, capture_output=True, text=True).stdout
        info = subprocess.run(["iinfo", "-v", self.file], check=True, capture_output=True, text=True).stdout
        for name in CHANNELS:
            kind = "32-bit unsigned integer" if name == "samples" else "32-bit floating-point"
            self.assertIn(f"    {name}, {kind}, sampling 1 1\n", header)
            self.assertIn(f"{name} ({'uint' if name == 'samples' else 'float'})", info)

    def test_values(self):
        c = self.channels
        centre = (numpy.arange(32) + 0.5) / 16 - 1
        x, y = numpy.meshgrid(4 * centre, -4 * centre)
        hit = x > -2
        self.assertGreater(hit.sum(), 700)
        self.assertLess(hit.sum(), 1024)
        distance = numpy.sqrt(x * x + y * y + 16)
        expected = {"N.X": 0, "N.Y": 0, "N.Z": 1, "albedo.R": 0.75, "albedo.G": 0.5, "albedo.B": 0.25,
                    "Z": distance, "P.X": x, "P.Y": y, "P.Z": 0, "uv.U": 0, "uv.V": 0,
                    "direct.G": 0.5 * 4 / distance, "indirect.G": 0, "emission.G": 0}
        for name, value in expected.items():
            shown = numpy.where(hit, value, 1e10 if name == "Z" else 0)
            numpy.testing.assert_allclose(c[name], shown, rtol=1e-6, atol=1e-6, err_msg=name)

    def test_sum(self):
        for channel in "RGB":
            parts = sum(self.channels[f"{layer}.{channel}"] for layer in ("direct", "indirect", "emission"))
            numpy.testing.assert_array_equal(parts, self.channels[channel])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
