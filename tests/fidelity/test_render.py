"""The scenarios of the fidelity comparison: cameras, copies of models, commands and pictures.

    python3 test_render.py CANDELA
"""
import base64
import json
import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import render  # noqa: E402
import wrapped_model  # noqa: E402

CANDELA = "candela"


def png_head(file):
    """Returns width, height and colour type (2: RGB, 6: RGBA) of a PNG file."""
    return struct.unpack(">IIBB", file.read_bytes()[16:26])[:2] + (file.read_bytes()[25],)


def generated(folder, name="box.gltf"):
    """Writes a generated glTF model, with its buffer in another file."""
    model = folder / name
    subprocess.run([CANDELA, "generate", "material-table", "--size", "8", "-o", str(model)], check=True,
                   capture_output=True)
    document = json.loads(model.read_text())
    buffer = document["buffers"][0]
    (folder / "a box.bin").write_bytes(base64.b64decode(buffer["uri"].partition(",")[2]))
    buffer["uri"] = "a%20box.bin"
    model.write_text(json.dumps(document))


class CameraTest(unittest.TestCase):
    def position(self, **orbit):
        matrix = wrapped_model.camera_matrix({"x": 1, "y": 2, "z": 3}, {"theta": 0, "phi": 90, "radius": 2, **orbit})
        return matrix

    def assertVector(self, found, expected):
        for a, b in zip(found, expected, strict=True):
            self.assertAlmostEqual(a, b)

    def test_the_camera_is_in_front_at_theta_0_and_to_the_right_at_90(self):
        self.assertVector(self.position()[12:15], (1, 2, 5))
        self.assertVector(self.position(theta=90)[12:15], (3, 2, 3))
        self.assertVector(self.position(phi=0)[12:15], (1, 4, 3))

    def test_the_axes_are_orthonormal_and_right_handed_everywhere(self):
        for theta in (-155, 0, 30, 90):
            for phi in (0, 49, 90, 180):
                m = self.position(theta=theta, phi=phi, radius=0)
                right, up, back = m[0:3], m[4:7], m[8:11]
                cross = (right[1] * up[2] - right[2] * up[1], right[2] * up[0] - right[0] * up[2],
                         right[0] * up[1] - right[1] * up[0])
                self.assertVector(cross, back)
                self.assertAlmostEqual(math.hypot(*up), 1)
                self.assertGreaterEqual(up[1], -1e-12)

    def test_the_camera_is_appended_and_belongs_to_the_default_scene(self):
        document = {"cameras": [{}], "nodes": [{}, {}], "scene": 1, "scenes": [{"nodes": [0]}, {"nodes": [1]}]}
        scenario = render.completed({"name": "a", "dimensions": {"width": 1000, "height": 500}})
        self.assertEqual(wrapped_model.with_camera(document, scenario), 1)
        self.assertEqual(document["nodes"][2]["camera"], 1)
        self.assertEqual([scene["nodes"] for scene in document["scenes"]], [[0], [1, 2]])
        self.assertAlmostEqual(document["cameras"][1]["perspective"]["yfov"], math.pi / 4)
        self.assertEqual(document["cameras"][1]["perspective"]["aspectRatio"], 2)


class CopyTest(unittest.TestCase):
    def test_uris_lead_back_to_the_models_folder(self):
        document = {"buffers": [{"uri": "a b.bin"}, {"uri": "data:;base64,AAAA"}, {}], "images": [{"uri": "c.png"}]}
        wrapped_model.move_uris(document, "../x")
        self.assertEqual([item.get("uri") for item in document["buffers"]], ["../x/a b.bin", "data:;base64,AAAA", None])
        self.assertEqual(document["images"][0]["uri"], "../x/c.png")

    def test_a_glb_keeps_its_other_chunks(self):
        glb = wrapped_model.glb_of({"asset": {"version": "2.0"}}, [(wrapped_model.CHUNK_BINARY, b"12345678")])
        self.assertEqual(struct.unpack_from("<I", glb, 8)[0], len(glb))
        chunks = wrapped_model.read_chunks(glb)
        self.assertEqual(json.loads(chunks[0][1]), {"asset": {"version": "2.0"}})
        self.assertEqual(chunks[1], (wrapped_model.CHUNK_BINARY, b"12345678"))


class ScenarioTest(unittest.TestCase):
    def test_defaults_are_those_of_the_comparison(self):
        scenario = render.completed({"name": "a", "model": "m", "orbit": {"radius": 3}, "target": {"y": 1}})
        self.assertEqual(scenario["orbit"], {"theta": 0, "phi": 90, "radius": 3})
        self.assertEqual(scenario["target"], {"x": 0, "y": 1, "z": 0})
        self.assertEqual(scenario["dimensions"], {"width": 768, "height": 768})

    def test_leading_dots_stand_for_the_root(self):
        self.assertEqual(render.below(Path("/r"), "../../../a/b.glb"), Path("/r/a/b.glb"))


class EntryTest(unittest.TestCase):
    """The entry among the generator's renderers, read as its render-goldens.ts and renderer-offline.ts read it."""

    def test_it_has_the_members_that_the_generator_reads(self):
        entry = json.loads((HERE / "renderer.json").read_text())
        self.assertEqual(set(entry), {"name", "description", "command"})
        self.assertEqual(entry["name"], render.RENDERER_NAME)
        self.assertEqual(f"{entry['name']}-golden.png", render.PICTURE_NAME)
        self.assertIsInstance(entry["description"], str)
        self.assertEqual(set(entry["command"]), {"executable", "args"})
        words = [entry["command"]["executable"], *entry["command"]["args"]]
        self.assertTrue(all(isinstance(word, str) for word in words))

    def test_the_generator_gets_a_picture_or_an_exit_code_and_a_message(self):
        entry = json.loads((HERE / "renderer.json").read_text())
        with tempfile.TemporaryDirectory() as name:
            root = Path(name)
            scripts, programs = root / "test/renderers/candela", root / "programs"
            models = root / "glTF-Sample-Assets/box"
            for folder in (scripts, programs, models, root / "environments"):
                folder.mkdir(parents=True)
            for file in ("render.py", "wrapped_model.py"):
                shutil.copy(HERE / file, scripts)
            (programs / "candela").symlink_to(Path(CANDELA).resolve())
            generated(models)
            (root / "environments/grey.pfm").write_bytes(b"PF\n2 1\n-1.0\n" + struct.pack("<6f", *[0.5] * 6))
            scenario = render.completed({"name": "a", "model": "../../../glTF-Sample-Assets/box/box.gltf",
                                         "lighting": "../../../environments/grey.pfm", "orbit": {"radius": 12},
                                         "dimensions": {"width": 4, "height": 2}})
            output = root / "test/goldens/a" / render.PICTURE_NAME
            for model, code in (("box.gltf", 0), ("none.gltf", 1)):
                scenario["model"] = scenario["model"].replace("box.gltf", model)
                command = [entry["command"]["executable"], *entry["command"]["args"],
                           json.dumps({"scenario": scenario, "outputFile": str(output)})]
                result = subprocess.run(command, cwd=root, capture_output=True, text=True,
                                        env={**os.environ, "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}"})
                self.assertEqual(result.returncode, code, result.stderr)
            self.assertIn("the model is not there", result.stderr)
            self.assertEqual(png_head(output), (8, 4, 6))


class RenderTest(unittest.TestCase):
    def run_script(self, *words):
        return subprocess.run([sys.executable, HERE / "render.py", "--candela", CANDELA, "--spp", "2", *map(str, words)],
                              capture_output=True, text=True)

    def device(self):
        """The index of a device that can be verified; the reference tracer cannot be compared with itself."""
        listed = subprocess.run([CANDELA, "devices"], capture_output=True, text=True).stdout
        if not listed.lstrip().startswith("0 "):
            self.skipTest("no Vulkan device renders here")
        return "0"

    def test_a_list_of_scenarios_gives_pictures_with_and_without_alpha(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            generated(folder)
            common = {"model": "../../../elsewhere/box.gltf", "dimensions": {"width": 24, "height": 12},
                      "orbit": {"radius": 12}}
            config = {"scenarios": [{**common, "name": "one"}, {**common, "name": "two", "renderSkybox": True},
                                    {**common, "name": "three", "model": "../../../none.glb"},
                                    {**common, "name": "four", "model": "../../../folder"},
                                    {**common, "name": "five", "model": "../../../broken.glb"},
                                    {**common, "name": "six", "exclude": ["vray", "candela"]}]}
            (folder / "folder").mkdir()
            (folder / "broken.glb").symlink_to(folder / "broken.glb")
            (folder / "config.json").write_text(json.dumps(config))
            words = ["--config", folder / "config.json", "--models", folder, "--env", "white", "-o", folder / "out"]
            result = self.run_script(*words, "--", "--device", "cpu", "-q")
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertIn("three: ../../../none.glb: the model is not there", result.stderr)
            self.assertIn("four: ../../../folder: the model is not there", result.stderr)
            self.assertIn("five: ", result.stderr)
            self.assertFalse((folder / "out/six").exists())
            self.assertEqual(png_head(folder / "out/one/candela-golden.png"), (48, 24, 6))
            self.assertEqual(png_head(folder / "out/two/candela-golden.png"), (48, 24, 2))
            result = self.run_script(*words, "--scenario", "TWO", "--", "--device", "cpu", "-q")
            self.assertEqual(result.returncode, 0, result.stderr)

    def test_one_scenario_as_a_command_renderer_gets_it(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            scenario = render.completed({"name": "a", "model": "../../../models/box.gltf",
                                         "dimensions": {"width": 8, "height": 8}, "orbit": {"radius": 12}})
            (folder / "models").mkdir()
            generated(folder / "models")
            request = json.dumps({"scenario": scenario, "outputFile": str(folder / "deep/a.png")})
            words = ["--root", folder, "--env", "white", request, "--", "--device", "cpu", "-q"]
            result = self.run_script(*words)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(png_head(folder / "deep/a.png"), (16, 16, 6))
            self.assertIn("the environment is not there", self.run_script("--root", folder, request).stderr)

    def test_a_measured_scenario_has_reports_a_second_picture_and_a_verdict(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            generated(folder)
            scenario = {"name": "a", "model": "../../../box.gltf", "dimensions": {"width": 40, "height": 30},
                        "orbit": {"radius": 12}}
            (folder / "config.json").write_text(json.dumps({"scenarios": [scenario]}))
            words = ["--config", folder / "config.json", "--root", folder, "--env", "white", "-o", folder / "out",
                     "--width", "8", "--measure", "--verify", "4", "--", "--device", self.device(), "-q"]
            result = self.run_script(*words)
            self.assertEqual(result.returncode, 0, result.stderr)
            made = folder / "out/a"
            self.assertEqual(png_head(made / render.PICTURE_NAME), (8, 6, 6))
            self.assertEqual(png_head(made / render.NOISE_NAME), (8, 6, 6))
            self.assertEqual(json.loads((made / render.REPORT_NAME).read_text())["settings"]["samplesPerPixel"], 2)
            self.assertIn("verdict", json.loads((made / render.VERDICT_NAME).read_text()))


if __name__ == "__main__":
    CANDELA = sys.argv.pop(1)
    unittest.main()
