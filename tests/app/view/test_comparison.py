"""Device and reference, side by side and as a difference."""
import unittest

import numpy
import support

OPTIONS = ("--spp", 2, "--max-depth", 4)


class Comparison(support.WindowTest):
    def setUp(self):
        super().setUp()
        self.device = self.render(*OPTIONS)
        self.reference = self.render(*OPTIONS, "--device", "cpu")

    def test_the_divider_separates_the_sides_and_can_be_dragged(self):
        viewer = self.view(*OPTIONS, "--show", "split")
        viewer.wait_for_samples(2)
        middle = self.device.shape[1] // 2
        self.assert_split(viewer, middle)
        viewer.drag((support.LEFT + 2 * middle, 300), (support.LEFT + 2 * 30, 300))
        support.wait_for(lambda: self.is_split(viewer, 30), "the divider at column 30")
        viewer.close()

    def is_split(self, viewer, column):
        shown = viewer.picture()
        # The names of the sides cover some pixels below.
        left = abs(shown - self.device)[:200, : column - 2]
        right = abs(shown - self.reference)[:200, column + 2 :]
        return max(left.max(), right.max()) <= 1 and (shown[:200, column] == 255).all()

    def assert_split(self, viewer, column):
        support.wait_for(lambda: self.is_split(viewer, column), f"the divider at column {column}")

    def test_the_difference_is_coloured_where_the_sides_differ_and_only_there(self):
        viewer = self.view(*OPTIONS, "--show", "device")
        viewer.key("4")
        viewer.key(*["period"] * 10)
        viewer.wait_for_samples(2)
        luminance = numpy.array([0.2126, 0.7152, 0.0722])
        device = self.render(*OPTIONS, kind="pfm") @ luminance
        reference = self.render(*OPTIONS, "--device", "cpu", kind="pfm") @ luminance
        relative = numpy.divide(2 * (device - reference), device + reference, out=numpy.zeros_like(device), where=device + reference > 0)
        self.assertTrue((abs(relative) < 1e-5).mean() > 0.9)

        def is_right():
            shown = viewer.picture()
            redness = shown[:, :, 0] - shown[:, :, 2]
            brighter, darker = relative > 1e-2, relative < -1e-2
            return (redness[brighter] > 100).all() and (redness[darker] < -100).all() and (abs(redness[abs(relative) < 1e-5]) < 8).all()

        support.wait_for(is_right, "the colours of the differences")
        viewer.close()

    def test_the_pixel_that_differs_most_is_explained_in_a_panel(self):
        viewer = self.view(*OPTIONS, "--show", "difference")
        viewer.wait_for_samples(2)
        before = self.display.pixels()[250:450, 360:630]
        viewer.key("n")
        support.wait_for(lambda: (abs(self.display.pixels()[250:450, 360:630] - before).max(axis=2) > 60).mean() > 0.02, "the panel of the path")
        viewer.close()


if __name__ == "__main__":
    unittest.main()
