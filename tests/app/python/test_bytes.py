"""Files that the module writes have the bytes of the program's."""
import unittest

import candela
from support import CORNELL, DEVICE, SMALL, FolderTest, cornell, run, words_of

RENDERS = {
    "reference": {"device": "cpu"},
    "device": {"device": DEVICE},
    "options": {"device": "cpu", "seed": 7, "max_depth": 3, "sampler": "stratified", "filter": "tent", "nee": False,
                "clamp_indirect": 2.5, "one_sided": True},
    "window": {"device": "cpu", "crop": (3, 4, 9, 7), "samples": range(1, 3)},
    "alpha": {"device": "cpu", "background": "none"},
    "depth": {"device": "cpu", "integrator": "depth"},
    "one sample": {"device": DEVICE, "spp": 0},
    "layers": {"device": "cpu", "aovs": ["normal", "albedo", "depth", "samples"]},
    "layers of a device": {"device": DEVICE, "aovs": "indirect,uv"},
    "mattes": {"device": DEVICE, "aovs": ["crypto-object", "crypto-material"], "aov_through_specular": True},
    "no layers": {"device": "cpu", "aovs": []},
    "denoised": {"device": "cpu", "denoise": True},
    "denoised by a device": {"device": DEVICE, "denoise": True, "aovs": ["position"]},
}


class Bytes(FolderTest):
    def test_images_and_films(self):
        for name, given in RENDERS.items():
            with self.subTest(name):
                options = {**SMALL, **given}
                film = candela.render(cornell(), **options)
                film.save(*(self.folder / f"a.{end}" for end in ("exr", "png", "hdr", "pfm", "jpg")),
                          checkpoint=self.folder / "a.film")
                outputs = [word for end in ("exr", "png", "hdr", "pfm", "jpg") for word in ("-o", self.folder / f"b.{end}")]
                run(CORNELL, *words_of(options), *outputs, "--checkpoint", self.folder / "b.film")
                for end in ("exr", "png", "hdr", "pfm", "jpg", "film"):
                    self.assert_same_bytes(f"a.{end}", f"b.{end}")
                (self.folder / "b.film").unlink()

    def test_denoising_of_films(self):
        film = candela.render(cornell(), **SMALL, device="cpu", aovs=["moments"])
        film.save(self.folder / "plain.exr", checkpoint=self.folder / "film.exr")
        film.save(self.folder / "a.exr", denoise=True)
        for source in (film, candela.open_film(self.folder / "film.exr")):
            source.save(self.folder / "b.pfm", denoise=True, device="cpu")
            run("denoise", self.folder / "film.exr", "--device", "cpu", "-o", self.folder / "c.pfm")
            self.assert_same_bytes("b.pfm", "c.pfm")
        run(CORNELL, *words_of(SMALL), "--device", "cpu", "--denoise", "-o", self.folder / "b.exr")
        self.assert_same_bytes("a.exr", "b.exr")
        self.assertNotEqual((self.folder / "a.exr").read_bytes(), (self.folder / "plain.exr").read_bytes())
        candela.render(cornell(), **SMALL, device="cpu", denoise=True).save(self.folder / "plain2.exr", denoise=False)
        self.assert_same_bytes("plain.exr", "plain2.exr")

    def test_none_omits_an_option_of_saving(self):
        film = candela.render(cornell(), **SMALL, device="cpu", denoise=True)
        film.save(self.folder / "plain.png")
        film.save(self.folder / "none.png", checkpoint=None, denoise=None, tonemap=None, exposure=None, device=None, no_cache=None)
        self.assert_same_bytes("plain.png", "none.png")
        film.save(self.folder / "noisy.png", denoise=False)
        self.assertNotEqual((self.folder / "plain.png").read_bytes(), (self.folder / "noisy.png").read_bytes())
        film.save(checkpoint=None)
        self.assertEqual(len(list(self.folder.iterdir())), 3)

    def test_options_of_the_scene_file(self):
        given = {"env": "sun:30,120,3", "env_rotate": -20, "env_scale": 0.25}
        film = candela.render(cornell(**given), **SMALL, device="cpu")
        film.save(self.folder / "a.exr", checkpoint=self.folder / "a.film")
        words = [f"--{name.replace('_', '-')}={value}" for name, value in given.items()]
        run(CORNELL, *words, *words_of(SMALL), "--device", "cpu", "-o", self.folder / "b.exr", "--checkpoint", self.folder / "b.film")
        self.assert_same_bytes("a.exr", "b.exr")
        self.assert_same_bytes("a.film", "b.film")

    def test_display_options(self):
        film = candela.render(cornell(), **SMALL, device="cpu")
        film.save(self.folder / "a.png", tonemap="agx", exposure="auto")
        run(CORNELL, *words_of(SMALL), "--device", "cpu", "-o", self.folder / "b.png", "--tonemap", "agx", "--exposure", "auto")
        self.assert_same_bytes("a.png", "b.png")
        film.save(self.folder / "plain.png")
        self.assertNotEqual((self.folder / "a.png").read_bytes(), (self.folder / "plain.png").read_bytes())

    def test_film_files(self):
        candela.render(cornell(), **SMALL, device="cpu", integrator="depth").save(checkpoint=self.folder / "depth.film")
        film = candela.open_film(self.folder / "depth.film")
        film.save(self.folder / "a.exr", self.folder / "a.png", checkpoint=self.folder / "again.film")
        run("film", self.folder / "depth.film", "-o", self.folder / "b.exr", "-o", self.folder / "b.png")
        for a, b in (("a.exr", "b.exr"), ("a.png", "b.png"), ("again.film", "depth.film")):
            self.assert_same_bytes(a, b)
        self.assertIsNone(film.report)

    def test_merge_and_resume(self):
        whole = candela.render(cornell(), **SMALL, device="cpu")
        for part in (range(0, 1), range(1, 4)):
            candela.render(cornell(), **SMALL, device="cpu", samples=part).save(checkpoint=self.folder / f"{part.start}.film")
        parts = [self.folder / "0.film", self.folder / "1.film"]
        candela.merge(parts).save(checkpoint=self.folder / "a.film")
        run("merge", *parts, "-o", self.folder / "b.film")
        self.assert_same_bytes("a.film", "b.film")
        resumed = candela.render(cornell(), **SMALL, device="cpu", resume=parts[0])
        self.assertEqual([resumed.hash, candela.merge(parts).hash], [whole.hash, whole.hash])

    def test_notebooks_show_the_png(self):
        for options in ({}, {"integrator": "depth"}, {"background": "none"}, {"denoise": True}):
            film = candela.render(cornell(), **SMALL, device="cpu", **options)
            film.save(self.folder / "a.png")
            self.assertEqual(film._repr_png_(), (self.folder / "a.png").read_bytes())


if __name__ == "__main__":
    unittest.main()
