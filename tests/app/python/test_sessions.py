"""Sessions: renders in parts equal whole renders."""
import unittest

import numpy

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

        options = {"size": (96, 96), "spp": 32, "device": "cpu", "threads": 1}
        with candela.Session(cornell(), **options) as session:
            with self.assertRaises(Stop):
                session.advance(16, progress=stop)
            film = session.film
            self.assertTrue(film.interrupted)
            self.assertEqual(session.done, 0)
            session.advance(32)
            self.assertEqual(session.done, 32)
            self.assertFalse(session.film.interrupted)
            self.assertEqual(session.film.hash, candela.render(cornell(), **options).hash)

    def test_wrong_ranges(self):
        with candela.Session(cornell(), **SMALL, device="cpu") as session:
            session.advance(2)
            for wrong in (range(3, 4), range(0, 9), range(2, 4, 2)):
                with self.assertRaises(candela.UsageError):
                    session.advance(wrong)
            for wrong in (-1, -2**70, range(-1, 2), range(4, 2), range(2, 3, 2**70)):
                with self.assertRaisesRegex(candela.UsageError, "samples"):
                    session.advance(wrong)
            for wrong in ("4", 1.5, numpy.float64(1), [1]):
                with self.assertRaisesRegex(TypeError, "samples: expected a whole number, a range or None, got "):
                    session.advance(wrong)
            session.advance()
            whole = session.film
        self.assertEqual(whole.hash, candela.render(cornell(), **SMALL, device="cpu").hash)
        for use in (session.advance, lambda: session.film, lambda: session.reset(1)):
            with self.assertRaisesRegex(candela.UsageError, "the session is closed"):
                use()

    def test_numbers_of_other_types(self):
        with candela.Session(cornell(), **SMALL, device="cpu") as session:
            session.advance(numpy.int64(1))
            session.advance(range(numpy.uint8(1), numpy.int32(2)))
            self.assertEqual(session.done, 2)
            session.advance(2**70)
            self.assertEqual(session.done, 4)

    def test_a_session_may_be_closed_twice(self):
        with candela.Session(cornell(), **SMALL, device="cpu") as session:
            session.close()
            session.close()
        self.assertEqual((session.done, session.spp), (0, 0))

    def test_the_exception_of_a_block_is_passed_on(self):
        for leave in (lambda session: session.close(), lambda session: None):
            with self.assertRaises(Stop):
                with candela.Session(cornell(), **SMALL, device="cpu") as session:
                    leave(session)
                    raise Stop
            with self.assertRaisesRegex(candela.UsageError, "the session is closed"):
                session.advance()

    def test_an_exception_is_more_important_than_a_session_in_use(self):
        session = candela.Session(cornell(), size=(256, 256), spp=64, device="cpu")

        def leave(fraction, samples):
            with session:
                raise Stop

        with self.assertRaises(Stop):
            session.advance(progress=leave)
        session.film  # the session was not closed

        def leave_without(fraction, samples):
            with session:
                pass

        with self.assertRaisesRegex(candela.UsageError, "the session is in use$"):
            session.advance(progress=leave_without)
        session.close()

    def test_done_is_the_next_sample(self):
        with candela.Session(cornell(), **SMALL, device="cpu") as session:
            session.advance(range(1, 3))
            self.assertEqual((session.done, session.film.samples.max()), (3, 2))
            session.advance(100)
            self.assertEqual((session.done, session.film.samples.max()), (4, 3))
        self.assertIn("Index of the next sample", candela.Session.done.__doc__)


if __name__ == "__main__":
    unittest.main()
