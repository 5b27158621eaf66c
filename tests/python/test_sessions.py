"""Sessions: renders in parts equal whole renders."""
import unittest

import candela
from support import CORNELL, DEVICE, SMALL, FolderTest, cornell, run, words_of


class Stop(Exception):
    pass


class Sessions(FolderTest):
    def test_parts_are_the_whole(self):
        for device in ("cpu", DEVICE):
            for sampler in ("sobol", "stratified"):
                with self.subTest(device=device, sampler=sampler):
                    options = {**SMALL, "device": device, "sampler": sampler}
                    with candela.Session(cornell(), **options) as session:
                        session.advance(1)
                        self.assertEqual((session.done, session.spp), (1, 4))
                        session.advance(range(1, 3))
                        session.advance(100)
                        self.assertEqual(session.done, 4)
                        session.film.save(self.folder / "a.exr", checkpoint=self.folder / "a.film")
                    candela.render(cornell(), **options).save(self.folder / "b.exr", checkpoint=self.folder / "b.film")
                    self.assert_same_bytes("a.exr", "b.exr")
                    self.assert_same_bytes("a.film", "b.film")

    def test_a_part_has_the_bytes_of_that_part(self):
        with candela.Session(cornell(), **SMALL, device="cpu") as session:
            session.advance(range(1, 3))
            session.film.save(self.folder / "a.exr", checkpoint=self.folder / "a.film")
        run(CORNELL, *words_of(SMALL), "--device", "cpu", "--samples", "1:3", "-o", self.folder / "b.exr",
            "--checkpoint", self.folder / "b.film")
        self.assert_same_bytes("a.exr", "b.exr")
        self.assert_same_bytes("a.film", "b.film")

    def test_films_do_not_change(self):
        with candela.Session(cornell(), **SMALL, device="cpu") as session:
            session.advance(2)
            early = session.film
            before, hash_before = early.image.copy(), early.hash
            session.advance()
            self.assertNotEqual(session.film.hash, hash_before)
        self.assertTrue((early.image == before).all() and early.hash == hash_before)

    def test_reset(self):
        with candela.Session(cornell(), **SMALL, device="cpu") as session:
            session.advance()
            first = session.film
            session.reset(seed=5)
            self.assertEqual(session.done, 0)
            session.advance()
            other = session.film
        self.assertEqual(other.hash, candela.render(cornell(), **SMALL, device="cpu", seed=5).hash)
        self.assertNotEqual(other.hash, first.hash)
        self.assertEqual(other.description["seed"], 5)

    def test_an_interrupted_range_is_completed(self):
        def stop(fraction, samples):
            raise Stop

        options = {"size": (160, 160), "spp": 64, "device": "cpu", "threads": 1}
        with candela.Session(cornell(), **options) as session:
            with self.assertRaises(Stop):
                session.advance(32, progress=stop)
            film = session.film
            self.assertTrue(film.interrupted)
            self.assertEqual(session.done, 0)
            session.advance(64)
            self.assertEqual(session.done, 64)
            self.assertFalse(session.film.interrupted)
            self.assertEqual(session.film.hash, candela.render(cornell(), **options).hash)

    def test_wrong_ranges(self):
        with candela.Session(cornell(), **SMALL, device="cpu") as session:
            session.advance(2)
            for wrong in (range(3, 4), range(0, 9), range(2, 4, 2)):
                with self.assertRaises(candela.UsageError):
                    session.advance(wrong)
            for wrong in (-1, "4", 1.5):
                with self.assertRaises((TypeError, ValueError, RuntimeError, AttributeError)):
                    session.advance(wrong)
            session.advance()
            whole = session.film
        self.assertEqual(whole.hash, candela.render(cornell(), **SMALL, device="cpu").hash)
        for use in (session.advance, lambda: session.film, lambda: session.reset(1), session.close):
            with self.assertRaisesRegex(candela.UsageError, "the session is closed"):
                use()


if __name__ == "__main__":
    unittest.main()
