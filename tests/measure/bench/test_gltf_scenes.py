"""The glTF scenes for comparisons with other renderers: they are read without warnings, and lit as they say.

    python3 test_gltf_scenes.py CANDELA
"""
import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import gltf_scenes  # noqa: E402
import gltf_writer  # noqa: E402

CANDELA = "candela"


def turned(quaternion, v):
    """The vector v after a rotation."""
    x, y, z, w = quaternion
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]]


class Scenes(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)

    def run_candela(self, *words):
        return subprocess.run([CANDELA, *map(str, words)], capture_output=True, text=True)

    def test_all_are_read_without_warnings(self):
        for options, count in (([], 10), (["--furnace"], 15)):
            folder = self.folder / f"{count}"
            subprocess.run([sys.executable, HERE / "gltf_scenes.py", folder, *options], check=True)
            files = sorted(folder.glob("*.gltf"))
            self.assertEqual(len(files), count)
            for file in files:
                result = self.run_candela("check", file)
                self.assertEqual((result.returncode, result.stderr), (0, ""), file.name)
                self.assertIn("camera 0 of the file", result.stdout)
                self.assertNotIn("not used", result.stdout, file.name)

    def test_furnace_balls_cover_the_part_of_the_picture_that_albedos_assume(self):
        (self.folder / "white.hdr").write_bytes(gltf_writer.environment(16, 8, lambda x, y, z: [1, 1, 1]))
        scene = gltf_scenes.ball({"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1]}, "extensions": {"KHR_materials_unlit": {}}})
        (self.folder / "ball.gltf").write_text(json.dumps(scene.document()))
        result = self.run_candela(self.folder / "ball.gltf", "--env", self.folder / "white.hdr", "--device", "cpu", "--size", "64x64",
                                  "--spp", 4, "-q", "-o", self.folder / "ball.pfm")
        self.assertEqual(result.returncode, 0, result.stderr)
        report = json.loads(self.run_candela("compare", self.folder / "ball.pfm", self.folder / "ball.pfm", "--json", "-").stdout)
        self.assertAlmostEqual(report["meanLuminance"], 1 - math.pi / 4, delta=0.003)

    def test_the_environment_is_seen_where_its_function_has_it(self):
        (self.folder / "sky.hdr").write_bytes(gltf_writer.environment(256, 128, gltf_scenes.sky))
        for direction in ((1, 0, 0), (-1, 0, 0), (0, 0, 1), (0, 0, -1), (0.75, 0.45, 0.48), (-0.8, 0.55, -0.24), (0.3, -0.8, 0.5)):
            scene = gltf_writer.Scene(eye=[0, 0, 0], target=direction, yfov=0.01, sky="sky.hdr")
            scene.add(gltf_writer.panel(0.1, 0.1), {}, [-100 * c for c in direction])  # behind the camera
            (self.folder / "view.gltf").write_text(json.dumps(scene.document()))
            result = self.run_candela(self.folder / "view.gltf", "--env", self.folder / "sky.hdr", "--device", "cpu", "--size", "8x8",
                                      "--spp", 64, "-q", "-o", self.folder / "view.pfm")
            self.assertEqual(result.returncode, 0, result.stderr)
            report = json.loads(self.run_candela("compare", self.folder / "view.pfm", self.folder / "view.pfm", "--json", "-").stdout)
            length = math.hypot(*direction)
            for seen, expected in zip(report["mean"], gltf_scenes.sky(*(c / length for c in direction))):
                self.assertLess(abs(seen / expected - 1), 0.02, direction)

    def test_lights_and_cameras_look_at_their_target(self):
        for position in ([1, 2, 1.5], [-2, 3, 2], [0, 2.6, -4.05], [0.5, -1, 0.2]):
            axis = turned(gltf_writer.rotation(position), [0, 0, -1])
            for along, expected in zip(axis, position):
                self.assertAlmostEqual(along, -expected / math.hypot(*position))


if __name__ == "__main__":
    CANDELA = sys.argv.pop(1)
    unittest.main()
