"""Films as bytes, for pickle: those of their film files."""
import copyreg
import pathlib
import tempfile

from ._candela import Film, open_film

_NAME = "film.exr"


def _film_of(files):
    with tempfile.TemporaryDirectory(prefix="candela-") as folder:
        for name, data in files.items():
            pathlib.Path(folder, name).write_bytes(data)
        return open_film(pathlib.Path(folder, _NAME))


def _reduced(film):
    with tempfile.TemporaryDirectory(prefix="candela-") as folder:
        film.save(checkpoint=pathlib.Path(folder, _NAME))
        return _film_of, ({file.name: file.read_bytes() for file in pathlib.Path(folder).iterdir()},)


copyreg.pickle(Film, _reduced)
