"""The window shows the same pixels as files."""
import os
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

    def view_with_faults(self, faults):
        """Shows a film while calls of Vulkan fail, and returns how often each function was called."""
        counts = self.folder / "counts"
        self.display.environment.update(VK_LAYER_PATH=os.environ["CANDELA_FAULT_LAYERS"], VK_INSTANCE_LAYERS="VK_LAYER_CANDELA_faults",
                                        CANDELA_FAULT=faults, CANDELA_FAULT_COUNTS=str(counts))
        viewer = self.view("--spp", 3)
        viewer.wait_for_samples(3)
        viewer.wait_for_picture(self.render("--spp", 3), "the film")
        self.assertGreater(viewer.close()["frames"], 0)
        return dict(line.split() for line in counts.read_text().splitlines())

    def test_a_surface_that_changes_at_equal_size_gets_another_swapchain(self):
        self.assertEqual(self.view_with_faults("vkAcquireNextImageKHR:2:VK_ERROR_OUT_OF_DATE_KHR")["vkCreateSwapchainKHR"], "2")

    def test_frames_without_a_free_image_are_drawn_later(self):
        faults = ",".join(f"vkAcquireNextImageKHR:{call}:VK_TIMEOUT" for call in range(2, 12))
        self.assertEqual(self.view_with_faults(faults)["vkCreateSwapchainKHR"], "1")


if __name__ == "__main__":
    unittest.main()
