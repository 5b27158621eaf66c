"""Cryptomatte files, decoded by an independent reader, and films with mattes that are divided and merged."""
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

import numpy
import OpenImageIO

PROGRAM = os.environ["CANDELA_PROGRAM"]
DEVICES = ("cpu", "llvmpipe")
SAMPLES = 72

# A card in front of a wall, both below the eye, and a node whose name has letters beyond ASCII. The names of the last two
# nodes are equal.
CAMERA = {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0.1, "zfar": 100}}
SQUARES = (("wall", "paint", (-0.75, -0.75, 0.75, 0.75), -3), ("Kärtchen", "paper", (-0.33, -0.4, 0.2, 0.6), -2),
           ("twin", "paper", (0.5, -0.9, 0.7, -0.8), -2), ("twin", None, (0.8, -0.9, 0.95, -0.8), -2))


def write_scene(file):
    materials = sorted({square[1] for square in SQUARES if square[1]})
    gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(SQUARES) + 1))}],
            "cameras": [CAMERA], "nodes": [{"camera": 0}], "meshes": [], "materials": [{"name": name} for name in materials],
            "accessors": [], "bufferViews": [], "buffers": []}
    data = struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    for name, material, (x0, y0, x1, y1), z in SQUARES:
        data += struct.pack("<12f", x0, y0, z, x1, y0, z, x1, y1, z, x0, y1, z)
        gltf["bufferViews"].append({"buffer": 0, "byteOffset": len(data) - 48, "byteLength": 48})
        gltf["accessors"].append({"bufferView": len(gltf["bufferViews"]) - 1, "componentType": 5126, "count": 4, "type": "VEC3",
                                  "min": [x0, y0, z], "max": [x1, y1, z]})
        primitive = {"attributes": {"POSITION": len(gltf["accessors"]) - 1}, "indices": len(SQUARES)}
        if material:
            primitive["material"] = materials.index(material)
        gltf["meshes"].append({"primitives": [primitive]})
        gltf["nodes"].append({"mesh": len(gltf["meshes"]) - 1, "name": name})
    gltf["bufferViews"].append({"buffer": 0, "byteOffset": 0, "byteLength": 12})
    gltf["accessors"].append({"bufferView": len(SQUARES), "componentType": 5123, "count": 6, "type": "SCALAR"})
    file.with_suffix(".bin").write_bytes(data)
    gltf["buffers"].append({"uri": file.with_suffix(".bin").name, "byteLength": len(data)})
    file.write_text(json.dumps(gltf))


def murmur3(data):
    """MurmurHash3_x86_32 with the seed 0, written from its description."""
    mask = 0xFFFFFFFF
    rotated = lambda value, bits: (value << bits | value >> (32 - bits)) & mask
    value = 0
    for start in range(0, len(data), 4):
        block = data[start:start + 4]
        word = rotated(int.from_bytes(block, "little") * 0xCC9E2D51 & mask, 15) * 0x1B873593 & mask
        value ^= word
        if len(block) == 4:
            value = (rotated(value, 13) * 5 + 0xE6546B64) & mask
    value ^= len(data)
    for factor, shift in ((0x85EBCA6B, 16), (0xC2B2AE35, 13), (1, 16)):
        value = (value ^ value >> shift) * factor & mask
    return value


class Matte:
    """A layer of a Cryptomatte file: the manifest, and the coverage of each name."""

    def __init__(self, file, layer):
        picture = OpenImageIO.ImageInput.open(str(file))
        spec, pixels = picture.spec(), picture.read_image(format="float")
        attributes = {attribute.name: attribute.value for attribute in spec.extra_attribs}
        self.key = next(name for name, value in attributes.items() if name.startswith("cryptomatte/") and value == layer)[:-4]
        self.attributes = {name: attributes[self.key + name] for name in ("name", "hash", "conversion")}
        self.manifest = json.loads(attributes[self.key + "manifest"])
        ids = {int(text, 16): name for name, text in self.manifest.items()}
        planes = [pixels[:, :, spec.channelnames.index(f"{layer}{rank:02}.{letter}")] for rank in range(3) for letter in "rgba"]
        self.alpha = pixels[:, :, spec.channelnames.index("A")] if "A" in spec.channelnames else None
        self.coverage = {name: numpy.zeros(planes[0].shape) for name in self.manifest}
        self.ranks = [plane.astype(float) for plane in planes[1::2]]
        for plane, amount in zip(planes[::2], planes[1::2]):
            for (y, x), bits in numpy.ndenumerate(numpy.ascontiguousarray(plane).view(numpy.uint32)):
                if amount[y, x] > 0:
                    self.coverage[ids[int(bits)]][y, x] += amount[y, x]


def exact_coverage(left, low, right, high, side):
    """The fraction of each pixel that a rectangle covers."""
    edges = numpy.linspace(-1, 1, side + 1)
    across = numpy.clip(numpy.minimum(edges[1:], right) - numpy.maximum(edges[:-1], left), 0, None) * side / 2
    down = numpy.clip(numpy.minimum(edges[1:], high) - numpy.maximum(edges[:-1], low), 0, None) * side / 2
    return numpy.outer(down[::-1], across)


class Cryptomatte(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)
        write_scene(cls.folder / "cards.gltf")

    def render(self, *words):
        subprocess.run([PROGRAM, self.folder / "cards.gltf", "--size", "12x12", "--spp", str(SAMPLES), "--max-depth", "2", "--env", "white",
                        "--aov", "crypto-object,crypto-material,depth", "--quiet", *map(str, words)], check=True)

    def picture(self, device):
        file = self.folder / f"{device}.exr"
        if not file.exists():
            self.render("--device", device, "--background", "none", "-o", file)
        return file

    def test_metadata(self):
        for layer in ("CryptoObject", "CryptoMaterial"):
            matte = Matte(self.picture("cpu"), layer)
            self.assertEqual(matte.key, f"cryptomatte/{murmur3(layer.encode()):08x}"[:-1] + "/")
            self.assertEqual(matte.attributes, {"name": layer, "hash": "MurmurHash3_32", "conversion": "uint32_to_float32"})
            names = {"CryptoObject": {"wall", "Kärtchen", "twin"}, "CryptoMaterial": {"paint", "paper", "default"}}[layer]
            self.assertEqual(set(matte.manifest), names)
            for name, text in matte.manifest.items():
                self.assertEqual(int(text, 16), murmur3(name.encode()))
        self.assertEqual(murmur3(b"bunny"), 0x13851A76)

    def test_exrheader_reads_them(self):
        header = subprocess.run(["exrheader", self.picture("cpu")], check=True, capture_output=True, text=True).stdout
        for layer in ("CryptoObject", "CryptoMaterial"):
            for rank in range(3):
                for letter in "rgba":
                    self.assertIn(f"    {layer}{rank:02}.{letter}, 32-bit floating-point, sampling 1 1\n", header)
        self.assertIn('cryptomatte/3ae39a5/conversion (type string): "uint32_to_float32"', header)

    def test_coverage(self):
        for device in DEVICES:
            matte = Matte(self.picture(device), "CryptoObject")
            card = exact_coverage(*SQUARES[1][2], 12)
            expected = {"wall": exact_coverage(*SQUARES[0][2], 12) - card, "Kärtchen": card,
                        "twin": sum(exact_coverage(*square[2], 12) for square in SQUARES[2:])}
            for name, coverage in expected.items():
                numpy.testing.assert_allclose(matte.coverage[name], coverage, atol=0.06, err_msg=f"{name} on {device}")
                numpy.testing.assert_array_equal(matte.coverage[name] == 1, coverage > 1 - 1e-9)
            self.assertTrue((matte.ranks[0] >= matte.ranks[1]).all() and (matte.ranks[1] >= matte.ranks[2]).all())

    def test_coverage_and_background_add_up(self):
        for device in DEVICES:
            for layer in ("CryptoObject", "CryptoMaterial"):
                matte = Matte(self.picture(device), layer)
                numpy.testing.assert_allclose(sum(matte.coverage.values()), matte.alpha, atol=1e-6)
                self.assertTrue((matte.alpha == 0).any() and (matte.alpha == 1).any())

    def test_both_tracers_agree(self):
        for layer in ("CryptoObject", "CryptoMaterial"):
            a, b = (Matte(self.picture(device), layer) for device in DEVICES)
            for name in a.manifest:
                numpy.testing.assert_array_equal(a.coverage[name], b.coverage[name])

    def test_divided_renders_merge_to_the_same_bytes(self):
        for device in DEVICES:
            words = ("--device", device)
            whole = self.folder / f"{device}-whole.film"
            self.render(*words, "--checkpoint", whole)
            parts = []
            for i, part in enumerate((("--samples", "0:41", "--crop", "0,0,12,5"), ("--samples", f"41:{SAMPLES}", "--crop", "0,0,12,5"),
                                      ("--crop", "0,5,7,7"), ("--crop", "7,5,5,7", "--kernel", "wavefront"))):
                parts.append(self.folder / f"{device}-{i}.film")
                self.render(*words, *part, "--checkpoint", parts[-1])
            merged = self.folder / f"{device}-merged.film"
            subprocess.run([PROGRAM, "merge", *parts[::-1], "-o", merged, "--quiet"], check=True)
            self.assertEqual(merged.read_bytes(), whole.read_bytes())
            resumed = self.folder / f"{device}-resumed.film"
            self.render(*words, "--samples", "0:33", "--checkpoint", resumed)
            self.render(*words, "--resume", resumed, "--checkpoint", resumed)
            self.assertEqual(resumed.read_bytes(), whole.read_bytes())

    def test_a_film_file_gives_the_same_mattes(self):
        film = self.folder / "export.film"
        self.render("--device", "cpu", "--background", "none", "--checkpoint", film)
        subprocess.run([PROGRAM, "film", film, "-o", self.folder / "export.exr", "--quiet"], check=True)
        a, b = (Matte(file, "CryptoObject") for file in (self.picture("cpu"), self.folder / "export.exr"))
        self.assertEqual(a.manifest, b.manifest)
        for name in a.manifest:
            numpy.testing.assert_array_equal(a.coverage[name], b.coverage[name])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
