"""Images that are saved, scenes that change, and the message without a display."""
import os
import signal
import subprocess
import unittest

import support

OPTIONS = ("--spp", 2, "--max-depth", 4)


class Files(support.WindowTest):
    def test_saved_images_are_those_of_render(self):
        viewer = self.view(*OPTIONS)
        viewer.wait_for_samples(2)
        viewer.key("p")
        saved = self.folder / "room.png"
        support.wait_for(saved.exists, "the saved image")
        self.render(*OPTIONS)
        self.assertEqual(saved.read_bytes(), self.rendered.read_bytes())
        viewer.close()

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
