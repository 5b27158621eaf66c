"""The window shows the layers of --aov by the colours that docs/viewer.md states."""
import unittest

import numpy
import OpenImageIO
import support

OPTIONS = ("--spp", 4, "--max-depth", 4)


def srgb(linear):
    return numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * numpy.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055)


class Layers(support.WindowTest):
    def channels(self, layer, names, *words):
        """Channels of the EXR file that `candela render --aov` writes."""
        self.render(*OPTIONS, "--aov", layer, *words, kind="exr")
        image = OpenImageIO.ImageBuf(str(self.rendered))
        listed = list(image.spec().channelnames)
        pixels = image.get_pixels(OpenImageIO.FLOAT)
        return numpy.stack([pixels[..., listed.index(name)] for name in names], axis=-1)

    def expect(self, viewer, signal, what):
        viewer.wait_for_picture(numpy.rint(255 * numpy.clip(signal, 0, 1)).astype(int), what)

    def test_keys_choose_layers_whose_colours_are_those_of_the_channels(self):
        viewer = self.view(*OPTIONS)
        viewer.wait_for_samples(4)
        viewer.key("v")
        self.expect(viewer, 0.5 + 0.5 * self.channels("normal", ["N.X", "N.Y", "N.Z"]), "normals")
        viewer.key("v")
        self.expect(viewer, srgb(self.channels("albedo", ["albedo.R", "albedo.G", "albedo.B"])), "albedos")
        viewer.key("v")
        depth = self.channels("depth", ["Z"])
        hits = depth[depth < 1e9]
        median = numpy.sort(hits)[len(hits) // 2]
        self.expect(viewer, numpy.repeat(1 / (1 + (depth / median) ** 2), 3, axis=2), "depths")
        viewer.key("v")
        position = self.channels("position", ["P.X", "P.Y", "P.Z"])
        inside = position[(position != 0).any(axis=2)]
        self.expect(viewer, (position - inside.min(axis=0)) / (inside.max(axis=0) - inside.min(axis=0)), "positions")
        viewer.key(*["shift+v"] * 4)
        viewer.wait_for_picture(self.render(*OPTIONS), "the picture")
        viewer.close()

    def test_parts_of_the_light_have_exposure_and_tone_map(self):
        viewer = self.view(*OPTIONS, "--layer", "indirect", "--exposure", 1)
        self.expect(viewer, srgb(2 * self.channels("indirect", ["indirect.R", "indirect.G", "indirect.B"])), "indirect light")
        viewer.close()

    def test_both_sides_show_a_layer_beside_the_divider(self):
        viewer = self.view(*OPTIONS, "--layer", "normal", "--show", "split")
        viewer.wait_for_samples(4)
        names = ["N.X", "N.Y", "N.Z"]
        device, reference = self.channels("normal", names), self.channels("normal", names, "--device", "cpu")
        middle = device.shape[1] // 2

        def is_right():
            shown = viewer.picture()[:200]
            left, right = (abs(shown - 255 * (0.5 + 0.5 * side[:200])) for side in (device, reference))
            return max(left[:, : middle - 2].max(), right[:, middle + 2 :].max()) <= 1.5

        support.wait_for(is_right, "the normals of both sides")
        viewer.close()

    def test_saved_files_have_the_layer_or_its_colours(self):
        viewer = self.view(*OPTIONS, "--layer", "id")
        viewer.wait_for_samples(4)
        viewer.key("p")
        saved = self.folder / "room.png"
        support.wait_for(lambda: saved.exists() and saved.read_bytes().endswith(b"IEND\xaeB`\x82"), "the saved image")
        colours = OpenImageIO.ImageBuf(str(saved)).get_pixels(OpenImageIO.UINT8).astype(int)
        viewer.wait_for_picture(colours, "the colours of the file")
        self.assertGreater(len(numpy.unique(colours.reshape(-1, 3), axis=0)), 5)
        viewer.close()


if __name__ == "__main__":
    unittest.main()
