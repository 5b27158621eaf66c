"""Sequences: frames equal renders of scenes that were loaded at their times."""
import pathlib
import unittest

import candela
from support import DEVICE, SMALL, FolderTest

MOVING = pathlib.Path(__file__).resolve().parents[3] / "tests/farm/moving_triangle.gltf"


class Sequences(FolderTest):
    def check(self, film, scene, seed=0, device="cpu"):
        film.save(self.folder / "a.exr", checkpoint=self.folder / "a.film")
        other = candela.render(scene, **SMALL, seed=seed, device=device)
        other.save(self.folder / "b.exr", checkpoint=self.folder / "b.film")
        self.assert_same_bytes("a.exr", "b.exr")
        self.assert_same_bytes("a.film", "b.film")

    def test_frames_are_renders_at_their_times(self):
        for device in ("cpu", DEVICE):
            with self.subTest(device=device):
                sequence = candela.Sequence(MOVING, frames=range(8, 11), fps=30, **SMALL, device=device)
                self.assertEqual(sequence.frames, range(8, 11))
                for frame in (10, 8, 8):
                    self.check(sequence.render(frame), candela.load(MOVING, time=frame / 30), device=device)

    def test_a_turntable_has_angles_and_seeds_of_its_frames(self):
        sequence = candela.Sequence(MOVING, turntable=4, seed="frame", **SMALL, device=DEVICE)
        self.assertEqual(sequence.frames, range(4))
        self.check(sequence.render(3), candela.load(MOVING, orbit=270), seed=3, device=DEVICE)
        self.check(sequence.render(0), candela.load(MOVING), device=DEVICE)

    def test_what_makes_no_sense_is_refused(self):
        with self.assertRaisesRegex(candela.UsageError, "frames: no frames given"):
            candela.Sequence(MOVING)
        with self.assertRaisesRegex(candela.UsageError, "frames: expected A:B"):
            candela.Sequence(MOVING, frames=range(3, 3))
        with self.assertRaisesRegex(candela.UsageError, "time and frames both state"):
            candela.Sequence(MOVING, frames=range(3), time=1)
        with self.assertRaisesRegex(candela.UsageError, "frame: expected a frame from 0 to 2, got 3"):
            candela.Sequence(MOVING, frames=range(3), **SMALL, device="cpu").render(3)
        with self.assertRaises(candela.FileError):
            candela.Sequence(self.folder / "none.glb", turntable=3)

    def test_progress_is_reported_and_may_stop_a_frame(self):
        reports = []
        sequence = candela.Sequence(MOVING, frames=range(2), **SMALL, device="cpu")
        sequence.render(1, progress=lambda fraction, samples: reports.append(fraction))
        self.assertEqual(reports[-1], 1)

        def stop(_fraction, _samples):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            sequence.render(0, progress=stop)
        self.check(sequence.render(1), candela.load(MOVING, time=1 / 24))


if __name__ == "__main__":
    unittest.main()
