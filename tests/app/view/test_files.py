"""Images that are saved, scenes that change, and the message without a display."""
import base64
import json
import os
import re
import signal
import struct
import subprocess
import unittest

import support

OPTIONS = ("--spp", 2, "--max-depth", 4)


def textured_triangle(image):
    """A glTF file as a dict: a triangle with an image from the folder."""
    values = struct.pack("<15f", -1, -1, 0, 1, -1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1)
    return {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}], "images": [{"uri": image}],
        "buffers": [{"uri": "data:application/octet-stream;base64," + base64.b64encode(values).decode(), "byteLength": 60}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
    }


class Files(support.WindowTest):
    def test_an_animation_is_played_and_paused_and_saved_with_its_time(self):
        self.scene = self.folder / "moving.gltf"
        self.scene.write_bytes((support.SOURCE / "tests/farm/moving_triangle.gltf").read_bytes())
        viewer = self.view("--time", 0.25, *OPTIONS)
        first = self.render("--time", 0.25, *OPTIONS)
        viewer.wait_for_picture(first, "the first time")
        viewer.key("k")
        for _ in range(5):
            before = viewer.picture()
            support.wait_for(lambda shown=before: abs(viewer.picture() - shown).max() > 1, "another time")
        viewer.key("k")
        viewer.wait_for_samples(2)
        viewer.key("p")
        saved = self.folder / "moving.png"
        support.wait_for(saved.exists, "the saved image")
        content, pictures = saved.read_bytes(), set()
        for frame in range(24):
            self.render("--time", repr(frame / 24), *OPTIONS)
            pictures.add(self.rendered.read_bytes())
        self.assertEqual(len(pictures), 24)
        self.assertIn(content, pictures)
        self.assertGreater(viewer.close()["frames"], 3)

    def test_saved_images_are_those_of_render(self):
        viewer = self.view(*OPTIONS)
        viewer.wait_for_samples(2)
        viewer.key("p")
        saved = self.folder / "room.png"
        support.wait_for(saved.exists, "the saved image")
        self.render(*OPTIONS)
        self.assertEqual(saved.read_bytes(), self.rendered.read_bytes())
        viewer.close()

    def test_a_saved_image_has_the_camera_that_is_shown(self):
        viewer = self.view(*OPTIONS)
        viewer.wait_for_samples(2)
        viewer.drag((support.LEFT + 144, 230), (support.LEFT + 204, 210))
        camera = viewer.copied_camera()
        _, view, rest = re.split(r"^(v\n(?:\w+ .*\n)+)", camera, flags=re.M)
        self.assertEqual(rest, "")
        text = self.scene.read_text()
        moved = self.folder / "moved.p3f"
        moved.write_text(re.sub(r"^v\s+(?:(?:from|at|up|angle|hither|resolution)\b.*\s+)+", view, text, count=1, flags=re.M))
        viewer.wait_for_picture(self.render(*OPTIONS, scene=moved), "the moved view")
        viewer.key("p")
        saved = self.folder / "room.png"
        support.wait_for(lambda: saved.exists() and saved.read_bytes().endswith(b"IEND\xaeB`\x82"), "the saved image")
        self.assertEqual(saved.read_bytes(), self.rendered.read_bytes())
        viewer.close()

    def test_a_texture_of_the_scene_is_not_overwritten(self):
        self.render("--spp", 1)
        texture = self.folder / "room.png"  # the name that the panel proposes
        texture.write_bytes(self.rendered.read_bytes())
        self.scene = self.folder / "room.gltf"
        self.scene.write_text(json.dumps(textured_triangle(texture.name)))
        viewer = self.view(*OPTIONS)
        viewer.wait_for_samples(2)
        panel = self.display.pixels()[:460, : support.LEFT]
        viewer.key("p")
        support.wait_for(lambda: (self.display.pixels()[:460, : support.LEFT] != panel).any(), "a message")
        viewer.close()
        self.assertEqual(texture.read_bytes(), self.rendered.read_bytes())

    def test_the_scene_is_read_again_when_its_file_changes(self):
        viewer = self.view(*OPTIONS)
        viewer.wait_for_samples(2)
        good = self.scene.read_text()
        self.scene.write_text(good + "\nnonsense\n")
        shown = self.render(*OPTIONS, scene=support.SOURCE / "scenes/cornell.p3f")
        viewer.wait_for_picture(shown, "the scene before")
        self.scene.write_text(good.replace("angle 39.3077", "angle 30"))
        viewer.wait_for_picture(self.render(*OPTIONS), "the new scene")
        viewer.close()

    def test_a_signal_ends_the_viewer(self):
        viewer = self.view(*OPTIONS)
        viewer.process.send_signal(signal.SIGINT)
        viewer.process.communicate(timeout=support.PATIENCE)
        self.assertEqual(viewer.process.returncode, 0)


class WithoutDisplay(unittest.TestCase):
    def run_view(self, *words, **environment):
        variables = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        return subprocess.run([support.PROGRAM, "view", *words], env={**variables, **environment}, capture_output=True, text=True, check=False)

    def test_a_missing_display_is_an_error_with_a_remedy(self):
        for environment in ({}, {"DISPLAY": ":4242"}):
            done = self.run_view(str(support.SOURCE / "scenes/cornell.p3f"), **environment)
            self.assertEqual(done.returncode, 4)
            self.assertIn("xvfb-run", done.stderr)

    def test_wrong_input_is_reported_before_the_display(self):
        done = self.run_view("missing.p3f")
        self.assertEqual(done.returncode, 2)
        self.assertIn("missing.p3f", done.stderr)
        self.assertEqual(self.run_view("a.p3f", "--show", "both").returncode, 1)


if __name__ == "__main__":
    unittest.main()
