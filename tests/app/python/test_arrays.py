"""The arrays of a film: values, sharing, lifetimes."""
import gc
import sys
import unittest

import numpy

import candela
from support import CORNELL, DEVICE, SMALL, FolderTest, cornell, run, words_of


def read_pfm(file):
    """The pixels of a PFM file, whose rows go from the bottom to the top."""
    kind, size, scale, data = file.read_bytes().split(b"\n", 3)
    assert kind == b"PF" and float(scale) < 0
    width, height = map(int, size.split())
    return numpy.frombuffer(data, "<f4").reshape(height, width, 3)[::-1]


class Arrays(FolderTest):
    def setUp(self):
        super().setUp()
        self.film = candela.render(cornell(), **SMALL, device="cpu")

    def test_types_and_values(self):
        film = self.film
        run(CORNELL, *words_of(SMALL), "--device", "cpu", "-o", self.folder / "b.pfm")
        numpy.testing.assert_array_equal(film.image, read_pfm(self.folder / "b.pfm"))
        self.assertEqual((film.image.dtype, film.variance.dtype, film.samples.dtype),
                         (numpy.float32, numpy.float32, numpy.uint32))
        self.assertEqual((film.image.shape, film.variance.shape, film.samples.shape), ((20, 24, 3), (20, 24), (20, 24)))
        self.assertTrue((film.samples == 4).all() and (film.width, film.height) == (24, 20))
        self.assertIsNone(film.alpha)

    def test_variance_is_that_of_single_samples(self):
        parts = [candela.render(cornell(), **SMALL, device="cpu", samples=range(i, i + 1)).image for i in range(4)]
        luminance = numpy.array(parts, numpy.float64) @ [0.2126, 0.7152, 0.0722]
        numpy.testing.assert_allclose(self.film.variance, luminance.var(0, ddof=1), rtol=1e-4, atol=1e-6)

    def test_arrays_share_memory_and_are_not_written(self):
        film = self.film
        for name in ("image", "variance", "samples"):
            self.assertTrue(numpy.shares_memory(getattr(film, name), getattr(film, name)))
            self.assertFalse(getattr(film, name).flags.owndata)
            with self.assertRaises(ValueError):
                getattr(film, name)[0, 0] = 1
            with self.assertRaises(ValueError):
                getattr(film, name).flags.writeable = True

    def test_an_array_keeps_its_film_alive(self):
        expected = {name: getattr(self.film, name).copy() for name in ("image", "variance", "samples")}
        for name, values in expected.items():
            film = candela.render(cornell(), **SMALL, device="cpu")
            before = sys.getrefcount(film)
            array = getattr(film, name)
            self.assertEqual(sys.getrefcount(film), before + 1)
            self.assertIs(array.base, film)
            view = array[5:]
            del film, array
            gc.collect()
            others = [candela.render(cornell(), **SMALL, device="cpu", seed=seed).image for seed in range(3)]  # use the heap
            numpy.testing.assert_array_equal(view, values[5:])
            del view, others
        film = self.film
        before = sys.getrefcount(film)
        array = film.image
        del array
        self.assertEqual(sys.getrefcount(film), before)

    def test_alpha(self):
        film = candela.render(cornell(), **SMALL, device="cpu", background="none")
        self.assertEqual((film.alpha.shape, film.alpha.dtype), ((20, 24), numpy.float32))
        self.assertTrue(film.alpha.min() >= 0 and film.alpha.max() == 1)
        self.assertTrue((film.image[film.alpha == 0] == 0).all())

    def test_layers(self):
        names = ["normal", "albedo", "depth", "position", "uv", "direct", "indirect", "emission", "moments"]
        film = candela.render(cornell(), **SMALL, device="cpu", aovs=names + ["samples"])
        self.assertEqual(set(film.layers), set(names))
        depths = {"depth": (), "uv": (2,), "moments": (5,)}
        for name in names:
            layer = film.layer(name)
            self.assertEqual((layer.shape, layer.dtype), ((20, 24) + depths.get(name, (3,)), numpy.float32))
            self.assertTrue(numpy.shares_memory(layer, film.layer(name)) and numpy.shares_memory(layer, film.layers[name]))
            with self.assertRaises(ValueError):
                layer[0, 0] = 1
        numpy.testing.assert_allclose(film.layer("direct") + film.layer("indirect") + film.layer("emission"), film.image,
                                      rtol=1e-6, atol=1e-6)
        self.assertTrue(numpy.shares_memory(film.layer("samples"), film.samples))
        self.assertTrue(numpy.shares_memory(film.layer("variance"), film.variance))
        self.assertEqual(self.film.layers, {})

    def test_layers_are_those_of_the_file(self):
        import OpenImageIO
        options = {**SMALL, "device": "cpu"}
        film = candela.render(cornell(), **options, aovs=["normal", "depth", "uv"])
        run(CORNELL, *words_of(options), "--aov", "normal,depth,uv", "-o", self.folder / "b.exr")
        source = OpenImageIO.ImageInput.open(str(self.folder / "b.exr"))
        names, pixels = source.spec().channelnames, source.read_image("float")
        for layer, channels in (("normal", ("N.X", "N.Y", "N.Z")), ("depth", ("Z",)), ("uv", ("uv.U", "uv.V"))):
            expected = pixels[:, :, [names.index(channel) for channel in channels]]
            numpy.testing.assert_array_equal(film.layer(layer).reshape(expected.shape), expected)

    def test_a_layer_keeps_its_film_alive(self):
        film = candela.render(cornell(), **SMALL, device="cpu", aovs=["albedo"])
        expected = film.layer("albedo").copy()
        array = film.layer("albedo")
        self.assertIs(array.base, film)
        del film
        gc.collect()
        others = [candela.render(cornell(), **SMALL, device="cpu", seed=seed, aovs=["albedo"]).layers for seed in range(3)]
        numpy.testing.assert_array_equal(array, expected)
        del others

    def test_denoised(self):
        film = candela.render(cornell(), **SMALL, device="cpu", denoise=True)
        before = film.image.copy()
        denoised = film.denoise()
        self.assertEqual((denoised.shape, denoised.dtype), ((20, 24, 3), numpy.float32))
        film.save(self.folder / "a.pfm")
        numpy.testing.assert_array_equal(denoised, read_pfm(self.folder / "a.pfm"))
        numpy.testing.assert_array_equal(film.image, before)
        self.assertTrue((denoised != before).any())
        numpy.testing.assert_allclose(film.denoise(device=DEVICE), denoised, rtol=1e-4, atol=1e-4)

    def test_sessions_have_layers(self):
        with candela.Session(cornell(), **SMALL, device=DEVICE, aovs=["normal"], denoise=True) as session:
            session.advance(2)
            first = session.film
            session.advance()
            film = session.film
        whole = candela.render(cornell(), **SMALL, device=DEVICE, aovs=["normal", "moments"])
        self.assertEqual(set(film.layers), {"normal", "moments"})
        numpy.testing.assert_array_equal(film.layer("moments"), whole.layer("moments"))
        self.assertTrue((first.samples == 2).all() and first.denoise().shape == (20, 24, 3))


if __name__ == "__main__":
    unittest.main()
