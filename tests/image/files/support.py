"""Runs Candela and oiiotool in a temporary folder."""
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["CANDELA_PROGRAM"]
OIIOTOOL = os.environ["CANDELA_OIIOTOOL"]


class ImageFileTest(unittest.TestCase):
    """A test case with a folder of its own."""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def path(self, name):
        return str(self.folder / name)

    def oiiotool(self, *words):
        """Runs oiiotool in the folder, and returns its standard output."""
        return subprocess.run([OIIOTOOL, *words], cwd=self.folder, check=True, capture_output=True, text=True).stdout

    def candela(self, *words, binary=False, **options):
        """Runs Candela in the folder. The result has its exit code, standard output and standard error."""
        return subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True, text=not binary,
                              timeout=120, **options)

    def compare(self, *words):
        """Compares two files. Returns the exit code and the report."""
        result = self.candela("compare", *words, "--json", "-")
        return result.returncode, json.loads(result.stdout)

    def statistic(self, file, name="Avg"):
        """Returns a statistic of all channels, as oiiotool computes it."""
        text = self.oiiotool("--stats", file)
        numbers = re.search(rf"Stats {name}: ([-0-9. e+naif]+) \(", text).group(1)
        return [float(number) for number in numbers.split()]
