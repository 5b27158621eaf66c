"""The arrays of a film: values, sharing, lifetimes."""
import gc
import sys
import unittest

import numpy

import candela
from support import CORNELL, SMALL, FolderTest, cornell, run, words_of


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


if __name__ == "__main__":
    unittest.main()
