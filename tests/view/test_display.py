"""The window shows the same pixels as files."""
import unittest

import support


class Shown(support.WindowTest):
    def test_the_window_shows_the_film_with_exposure_and_tone_map(self):
        viewer = self.view("--spp", 3, "--exposure", -0.5)
        viewer.wait_for_samples(3)
        viewer.wait_for_picture(self.render("--spp", 3, "--exposure", -0.5), "the film")
        viewer.key("bracketright", "bracketright", "t")
        viewer.wait_for_picture(self.render("--spp", 3, "--tonemap", "aces"), "another display transform")
        report = viewer.close()
        self.assertTrue(report["presentsFromDevice"])
        self.assertEqual(report["deviceSamples"], 3)
        self.assertGreater(report["firstPictureSeconds"], 0)

    def test_integrators_are_chosen_by_a_key_and_depths_have_false_colours(self):
        viewer = self.view("--spp", 2, "--integrator", "albedo")
        viewer.wait_for_picture(self.render("--spp", 2, "--integrator", "albedo"), "the view albedo")
        viewer.key("i")
        viewer.wait_for_picture(self.render("--spp", 2, "--integrator", "depth"), "the view depth")

    def test_the_reference_alone_needs_no_device_to_render(self):
        viewer = self.view("--spp", 2, "--device", "cpu", "--max-depth", 3)
        viewer.wait_for_samples(2)
        viewer.wait_for_picture(self.render("--spp", 2, "--device", "cpu", "--max-depth", 3), "the reference's film")
        self.assertEqual(viewer.close()["deviceSamples"], 0)


if __name__ == "__main__":
    unittest.main()
