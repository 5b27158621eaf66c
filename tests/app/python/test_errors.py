"""Errors and warnings have the texts and the exit codes of the program."""
import ctypes
import logging
import os
import pathlib
import re
import unittest
import warnings

import numpy

import candela
from support import CORNELL, DEVICE, SMALL, FolderTest, cornell, run, with_keywords, words_of


def text_of(done):
    """The output of the program, without its name at the beginning of each line, and without the reference to its help."""
    lines = [line.removeprefix("candela: ") for line in done.stderr.splitlines()]
    return "\n".join(line for line in lines if not re.fullmatch("see candela [a-z]+ --help", line))


class Errors(FolderTest):
    def check(self, error, done):
        self.assertEqual(str(error), with_keywords(text_of(done)))
        self.assertEqual(error.exit_code, done.returncode)

    def test_options(self):
        wrong = [
            {"spp": -1}, {"spp": "many"}, {"size": (0, 5)}, {"size": 5}, {"integrator": "pathh"}, {"sampler": "halton"},
            {"max_depht": 3}, {"nee": "yes"}, {"samples": range(3, 3)}, {"samples": range(0, 99)}, {"crop": (20, 0, 9, 9)},
            {"resume_anyway": True}, {"clamp_indirect": 0}, {"integrator": "whitted", "max_depth": 99}, {"threads": 9999},
        ]
        for change in wrong:
            with self.subTest(change):
                options = {**SMALL, "device": "cpu", **change}
                with self.assertRaises(candela.UsageError) as caught:
                    candela.render(cornell(), **options)
                self.check(caught.exception, run(CORNELL, *words_of(options), "-o", self.folder / "a.png", code=1))

    def test_layers_and_denoising(self):
        wrong = [{"aovs": ["normals"]}, {"aovs": ["normal"], "integrator": "ao"}, {"denoise": True, "integrator": "ao"},
                 {"denoise": True, "spp": 1}, {"denoise": True, "spp": 0}]
        for change in wrong:
            with self.subTest(change):
                options = {**SMALL, "device": "cpu", **change}
                with self.assertRaises(candela.UsageError) as caught:
                    candela.render(cornell(), **options)
                self.check(caught.exception, run(CORNELL, *words_of(options), "-o", self.folder / "a.exr", code=1))
        film = candela.render(cornell(), **SMALL, device="cpu", aovs=["normal", "uv"])
        with self.assertRaisesRegex(candela.UsageError, 'the film has no layer "depth"; its layers are normal,uv'):
            film.layer("depth")
        with self.assertRaisesRegex(candela.UsageError, 'the film has no layer "colour"'):
            film.layer("colour")
        film.save(checkpoint=self.folder / "a.film")
        with self.assertRaises(candela.UsageError) as caught:
            film.denoise()
        done = run("denoise", self.folder / "a.film", "-o", self.folder / "a.exr", code=2)
        self.assertEqual(with_keywords(text_of(done)), f"{self.folder / 'a.film'}: {caught.exception}")
        with self.assertRaises(candela.UsageError):
            film.save(self.folder / "a.exr", denoise=True)
        self.assertFalse((self.folder / "a.exr").exists())

    def test_open_image_denoise(self):
        with self.assertRaisesRegex(candela.UsageError, 'denoise: expected no value or oidn, got "optix"'):
            candela.render(cornell(), **SMALL, device="cpu", denoise="optix")
        try:
            ctypes.CDLL("libOpenImageDenoise.so.2")
        except OSError:
            with self.assertRaisesRegex(candela.NoDeviceError, "the library Open Image Denoise cannot be loaded"):
                candela.render(cornell(), **SMALL, device="cpu", denoise="oidn")

    def test_files_that_are_read_are_not_overwritten(self):
        scene_file, sky, film_file = (self.folder / name for name in ("room.png", "sky.exr", "a.exr"))
        scene_file.write_bytes(CORNELL.read_bytes())
        candela.render(cornell(), **SMALL, device="cpu").save(sky)
        scene = candela.load(scene_file, env=sky)
        films = [candela.render(scene, **SMALL, device="cpu"), candela.Session(scene, **SMALL, device="cpu").film]
        films[0].save(checkpoint=film_file)
        before = {file: file.read_bytes() for file in self.folder.iterdir()}
        opened = [candela.open_film(film_file), candela.merge([film_file])]
        read = [(film, file) for film in films for file in (scene_file, sky)] + [(film, film_file) for film in opened]
        for film, file in read:
            with self.subTest(file.name):
                with self.assertRaisesRegex(candela.UsageError, "this file is read by the command, and an image would overwrite it"):
                    film.save(file)
                with self.assertRaisesRegex(candela.UsageError, "checkpoint would overwrite it"):
                    film.save(checkpoint=file)
        with self.assertRaisesRegex(candela.UsageError, "checkpoint would overwrite it"):
            candela.render(scene, **SMALL, device="cpu", checkpoint=sky)
        with self.assertRaisesRegex(candela.UsageError, "an image and checkpoint would both write this file"):
            films[0].save(self.folder / "b.exr", checkpoint=self.folder / "b.exr")
        self.assertEqual(before, {file: file.read_bytes() for file in self.folder.iterdir()})
        films[0].save(self.folder / "b.exr", checkpoint=self.folder / "c.exr")

    def test_devices(self):
        with self.assertRaises(candela.NoDeviceError) as caught:
            candela.render(cornell(), **SMALL, device="no such device")
        self.check(caught.exception, run(CORNELL, *words_of(SMALL), "--device", "no such device", "--stats", code=4))

    def test_files(self):
        (self.folder / "bad.p3f").write_text("spehre 1 2 3\nv\n")
        for file in (self.folder / "bad.p3f", self.folder / "missing.p3f", self.folder):
            with self.subTest(file):
                with self.assertRaises(candela.FileError) as caught:
                    candela.load(file)
                self.check(caught.exception, run(file, "-o", self.folder / "a.png", code=2))
        with self.assertRaises(candela.SceneError) as caught:
            candela.load(self.folder / "bad.p3f")
        self.assertEqual(caught.exception.diagnostics[0][:3], (str(self.folder / "bad.p3f"), 1, 1))

    def test_outputs(self):
        film = candela.render(cornell(), **SMALL, device="cpu")
        for file, kind, code in ((self.folder / "a.bmp", candela.UsageError, 1), (self.folder / "none/a.png", candela.FileError, 2)):
            with self.assertRaises(kind) as caught:
                film.save(file)
            self.check(caught.exception, run(CORNELL, *words_of(SMALL), "-o", file, code=code))
        (self.folder / "a.film").write_text("precious")
        with self.assertRaises(candela.FileError) as caught:
            candela.render(cornell(), **SMALL, device="cpu", checkpoint=self.folder / "a.film")
        self.check(caught.exception, run(CORNELL, *words_of(SMALL), "--checkpoint", self.folder / "a.film", code=2))
        self.assertEqual((self.folder / "a.film").read_text(), "precious")

    def test_tracers(self):
        for function, command in ((candela.verify, "verify"), (candela.explain, "explain"), (candela.compare, "compare")):
            with self.assertRaises(candela.UsageError) as caught:
                function(cornell(), device="cpu")
            self.check(caught.exception, run(command, CORNELL, "--device", "cpu", code=1))
        options = {"size": (8, 8), "pixel": (8, 0), "device": DEVICE}
        with self.assertRaises(candela.UsageError) as caught:
            candela.explain(cornell(), **options)
        self.check(caught.exception, run("explain", CORNELL, *words_of(options), code=1))

    def test_options_of_other_functions(self):
        for function, options, text in (
            (candela.render, {"env": "white"}, r"env is not an option of candela.render\(\); candela.load\(\) has it"),
            (candela.render, {"output": "a.png"}, r"output is not an option of candela.render\(\)"),
            (candela.render, {"pixel": (1, 1)}, r"pixel is not an option of candela.render\(\)"),
            (candela.Session, {"checkpoint": "a.film"}, r"checkpoint is not an option of candela.Session\(\)"),
            (candela.verify, {"spp": 4}, r"spp is not an option of candela.verify\(\)"),
            (candela.render, {"one_sided": 1}, 'one_sided: expected True or False, got "1"'),
        ):
            with self.assertRaisesRegex(candela.UsageError, text):
                function(cornell(), **options)
        with self.assertRaises(TypeError):
            candela.render("cornell.p3f")

    def test_numbers_and_truth_values_of_numpy(self):
        plain = candela.render(cornell(), **SMALL, device="cpu", nee=False, one_sided=True).hash
        for numpy_size in (numpy.array(SMALL["size"]), numpy.uint16(SMALL["size"]), [numpy.int64(24), 20]):
            options = {**SMALL, "size": numpy_size, "spp": numpy.int8(SMALL["spp"])}
            film = candela.render(cornell(), **options, device="cpu", nee=numpy.bool_(False), one_sided=numpy.bool_(True))
            self.assertEqual(film.hash, plain)
        with self.assertRaisesRegex(candela.UsageError, 'size: expected .*, got "24.5x20"'):
            candela.render(cornell(), size=numpy.array([24.5, 20.0]), device="cpu")
        with self.assertRaisesRegex(candela.UsageError, 'size: expected .*, got "5"'):
            candela.render(cornell(), size=numpy.array(5), device="cpu")

    def test_what_is_not_the_name_of_a_file(self):
        film = candela.render(cornell(), **SMALL, device="cpu")
        for what, use in (("files", lambda: film.save(3)), ("checkpoint", lambda: film.save(checkpoint=3)),
                          ("file", lambda: candela.load(None)), ("file", lambda: candela.open_film(3)),
                          ("files", lambda: candela.merge([3])), ("resume", lambda: candela.render(cornell(), resume=3)),
                          ("allow_path", lambda: candela.load(CORNELL, allow_path=[3]))):
            with self.assertRaisesRegex(TypeError, f"^{what}: expected the name of a file, got (3|None)$"):
                use()
        with self.assertRaisesRegex(TypeError, "files: expected several names of files"):
            candela.merge("a.film")
        with self.assertRaisesRegex(ValueError, "null"):
            candela.load("a\0b")

    def test_names_that_are_not_utf8(self):
        strange = os.fsencode(self.folder) + b"/\xff.p3f"
        (self.folder / "plain.p3f").write_bytes(CORNELL.read_bytes())
        os.rename(self.folder / "plain.p3f", strange)
        films = []
        for name in (strange, os.fsdecode(strange), pathlib.Path(os.fsdecode(strange))):
            scene = candela.load(name)
            self.assertEqual((scene.name, scene.report["scene"]), (r"\xff.p3f", "\ufffd.p3f"))
            self.assertIn(r"candela.Scene \xff.p3f:", repr(scene))
            film = os.fsdecode(strange) + ".film"
            candela.render(scene, **SMALL, device="cpu", checkpoint=film).save(film + ".png", checkpoint=film + "2")
            films.append(candela.merge([film + "2"]).hash)
            self.assertEqual(candela.open_film(os.fsencode(film)).hash, films[-1])
            self.assertEqual(candela.render(scene, **SMALL, device="cpu", resume=film).hash, films[-1])
            self.assertIsNotNone(candela.compare(film + ".png", os.fsencode(film + ".png")).report)
            os.remove(film)
        self.assertEqual(set(films), {candela.render(cornell(), **SMALL, device="cpu").hash})
        with open(strange, "ab") as file:
            file.write(b"nonsense\n")
        with self.assertRaisesRegex(candela.SceneError, r"\\xff\.p3f:\d+") as caught:
            candela.load(strange)
        self.assertTrue(caught.exception.diagnostics[0][0].endswith(r"\xff.p3f"))
        with self.assertRaisesRegex(candela.FileError, r"\\xff\.p3f2"):
            candela.load(strange + b"2")

    def test_kinds(self):
        self.assertTrue(issubclass(candela.UsageError, ValueError) and issubclass(candela.FileError, OSError))
        self.assertTrue(issubclass(candela.OutOfMemoryError, MemoryError) and issubclass(candela.SceneError, candela.Error))

    def test_warnings(self):
        text = CORNELL.read_text() + "\nf 2 0.5 0.5 1 0 1 0 1\n"
        (self.folder / "warn.p3f").write_text(text)
        with self.assertWarns(candela.CandelaWarning) as caught:
            candela.load(self.folder / "warn.p3f")
        self.assertEqual(pathlib.Path(caught.filename).name, "test_errors.py", "the warning names the line of the caller")
        done = run(self.folder / "warn.p3f", *words_of(SMALL), "--device", "cpu", "--stats")
        self.assertIn("warning: " + str(caught.warning), text_of(done))
        with warnings.catch_warnings():
            warnings.simplefilter("error", candela.CandelaWarning)
            with self.assertRaises(candela.CandelaWarning):
                candela.load(self.folder / "warn.p3f")

    def test_notes(self):
        with self.assertLogs("candela", logging.INFO) as logs:
            candela.render(cornell(), **SMALL, device="cpu", light_size=1)
        self.assertIn("INFO:candela:--light-size has no effect here; it applies to --integrator whitted", logs.output)


if __name__ == "__main__":
    unittest.main()
