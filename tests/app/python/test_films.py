"""Films are copied and pickled."""
import copy
import multiprocessing
import pickle
import unittest

import numpy

import candela
from support import CORNELL, SMALL, FolderTest, cornell, run, words_of


def rendered(**options):
    return candela.render(cornell(), **SMALL, device="cpu", **options)


def mean_of(film):
    return float(film.image.mean())


class Films(FolderTest):
    def test_pickled_films_have_the_bytes_of_their_film_files(self):
        for options in ({}, {"aovs": "all"}, {"background": "none"}, {"samples": range(1, 3), "crop": (3, 4, 9, 7)}):
            with self.subTest(options):
                film = rendered(**options)
                film.save(checkpoint=self.folder / "a.film")
                again = pickle.loads(pickle.dumps(film))
                again.save(checkpoint=self.folder / "b.film")
                self.assert_same_bytes("a.film", "b.film")
                self.assertEqual(again.hash, film.hash)
                self.assertEqual(again.description, candela.open_film(self.folder / "a.film").description)
                numpy.testing.assert_array_equal(again.image, film.image)

    def test_processes_exchange_films(self):
        films = [rendered(seed=seed) for seed in range(2)]
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            self.assertEqual(pool.map(mean_of, films), [mean_of(film) for film in films])

    def test_damaged_bytes_are_refused(self):
        data = bytearray(pickle.dumps(rendered()))
        data[len(data) // 2] ^= 1
        with self.assertRaises(candela.FileError):
            pickle.loads(bytes(data))

    def test_a_copy_is_the_film_itself_since_it_does_not_change(self):
        film = rendered()
        self.assertIs(copy.copy(film), film)
        self.assertIs(copy.deepcopy([film])[0], film)

    def test_floating_point_numbers_without_a_fraction_are_whole_numbers(self):
        whole = rendered().hash
        small = {"size": (24.0, numpy.float32(20)), "device": "cpu"}
        for spp in (4.0, numpy.float32(4), numpy.float64(4)):
            self.assertEqual(candela.render(cornell(), spp=spp, **small).hash, whole)
        for spp in (4.5, float("nan"), float("inf"), -1.0):
            with self.assertRaisesRegex(candela.UsageError, "spp: expected a whole number"):
                candela.render(cornell(), spp=spp, **small)

    def test_short_names_of_layers(self):
        film = rendered(aovs=["id", "material"])
        self.assertEqual(film.description["layers"], "crypto-object,crypto-material")
        film.save(checkpoint=self.folder / "a.film")
        run(CORNELL, *words_of(SMALL), "--device", "cpu", "--aov", "id,material", "--checkpoint", self.folder / "b.film")
        self.assert_same_bytes("a.film", "b.film")


if __name__ == "__main__":
    unittest.main()
