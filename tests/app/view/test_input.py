"""Mouse and keyboard move the camera, and its text renders the picture that is shown."""
import re
import time
import unittest

import support

OPTIONS = ("--spp", 2, "--max-depth", 4)
CENTRE = (support.LEFT + 144, 230)


def entry(text, name):
    return [float(word) for word in re.search(rf"^{name} (.*)$", text, re.M).group(1).split()]


class Input(support.WindowTest):
    def scene_with(self, camera):
        """A copy of the scene with the view that was copied."""
        text = self.scene.read_text()
        entries = r"v\s+(?:(?:from|at|up|angle|hither|resolution|aperture|apperture|focal)\b.*\s+)+"
        self.assertEqual(len(re.findall(rf"^{entries}", text, re.M)), 1)
        moved = self.folder / "moved.p3f"
        moved.write_text(re.sub(rf"^{entries}", camera, text, count=1, flags=re.M))
        return moved

    def test_a_dragged_camera_is_copied_as_text_that_renders_the_same_picture(self):
        viewer = self.view(*OPTIONS)
        viewer.wait_for_samples(2)
        start = self.render(*OPTIONS)
        viewer.wait_for_picture(start, "the first view")
        viewer.drag(CENTRE, (CENTRE[0] + 60, CENTRE[1] - 20))
        viewer.display.tool("click", 4)
        camera = viewer.copied_camera()
        moved = self.render(*OPTIONS, scene=self.scene_with(camera))
        self.assertGreater((abs(moved - start) > 8).mean(), 0.3)
        viewer.wait_for_picture(moved, "the view of the copied camera")
        viewer.key("r")
        viewer.wait_for_picture(start, "the first view again")
        report = viewer.close()
        self.assertGreater(report["responses"]["count"], 0)

    def test_keys_fly_and_the_other_buttons_pan_and_look(self):
        viewer = self.view(*OPTIONS)
        first = viewer.copied_camera()
        self.display.tool("keydown", "w")
        time.sleep(0.3)
        self.display.tool("keyup", "w")
        flown = viewer.copied_camera(first)
        before, after = entry(first, "from"), entry(flown, "from")
        forward = [b - a for a, b in zip(before, entry(first, "at"))]
        self.assertGreater(sum(f * (b - a) for f, a, b in zip(forward, before, after)), 0)

        viewer.drag(CENTRE, (CENTRE[0] + 30, CENTRE[1]), button=2)
        panned = viewer.copied_camera(flown)
        moved = [b - a for a, b in zip(after, entry(panned, "from"))]
        self.assertGreater(max(map(abs, moved)), 0)
        for each, was in zip(entry(panned, "at"), (a + m for a, m in zip(entry(flown, "at"), moved))):
            self.assertAlmostEqual(each, was, places=3)

        viewer.drag(CENTRE, (CENTRE[0] + 30, CENTRE[1]), button=3)
        looked = viewer.copied_camera(panned)
        self.assertEqual(entry(looked, "from"), entry(panned, "from"))
        self.assertNotEqual(entry(looked, "at"), entry(panned, "at"))
        viewer.close()


if __name__ == "__main__":
    unittest.main()
