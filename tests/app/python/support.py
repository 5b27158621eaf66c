"""Common parts of the tests of the Python module: paths, the program, and a folder for each test."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import candela

PROGRAM = os.environ["CANDELA_PROGRAM"]
SOURCE = pathlib.Path(__file__).resolve().parents[3]
CORNELL = SOURCE / "scenes/cornell.p3f"
DEVICE = os.environ.get("CANDELA_TEST_DEVICE", "llvmpipe")
FLAGS = ("one_sided", "resume_anyway", "denoise", "aov_through_specular")
SMALL = {"size": (24, 20), "spp": 4}


def with_keywords(text):
    """A text of the program with keywords instead of options."""
    text = re.sub(r"--([a-z][a-z-]*) (\d[\d.]*)(?![\d%])", r"--\1=\2", text)
    text = re.sub(r"--([a-z][a-z-]*) (path|none|cpu|moments|white|[\d.]+%|/[^\s,;]+)(?=[,;.)\s]|$)", r'--\1="\2"', text)
    return re.sub(r"--([a-z][a-z-]*)", lambda option: option[1].replace("-", "_").replace("aov", "aovs"), text)


def words_of(options):
    """The words of the command line for simple options."""
    words = []
    for name, value in options.items():
        if name == "aovs":
            words += ["--aov", value if isinstance(value, str) else ",".join(value) or "none"]
            continue
        if isinstance(value, tuple):
            value = ("," if name in ("crop", "pixel") else "x").join(map(str, value))
        elif isinstance(value, range):
            value = f"{value.start}:{value.stop}"
        words.append("--" + name.replace("_", "-"))
        if name not in FLAGS:
            words.append("on" if value is True else "off" if value is False else str(value))
    return words


def run(*words, code=0):
    """Runs the program, which must end with this exit code."""
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=False)
    assert done.returncode == code, (words, done.returncode, done.stderr)
    return done


class FolderTest(unittest.TestCase):
    """A test with an empty folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def assert_same_bytes(self, a, b):
        self.assertEqual((self.folder / a).read_bytes(), (self.folder / b).read_bytes(), f"{a} and {b} differ")


def quad(z=0.0):
    """The vertices and faces of the square from -1 to 1 at a height."""
    return [[-1, -1, z], [1, -1, z], [1, 1, z], [-1, 1, z]], [[0, 1, 2], [0, 2, 3]]


def cornell(**options):
    return candela.load(CORNELL, **options)
