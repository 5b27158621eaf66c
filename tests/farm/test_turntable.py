"""Renders the turntable of the gallery as docs/gallery.md states it, small and with few frames, in one run and by a real Slurm.

    python3 test_turntable.py CANDELA
"""
import re
import shlex
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from slurm_cluster import SlurmCluster

ROOT = Path(__file__).resolve().parents[2]
FRAMES = 4
CANDELA = "candela"


def commands_of_page():
    """Returns the commands of the gallery's turntable, as lists of words."""
    section = (ROOT / "docs/gallery.md").read_text().split("## A turntable", 1)[1].split("\n## ", 1)[0]
    return [shlex.split(line) for line in re.findall(r"^    (.*)$", section, re.MULTILINE)]


class TurntableTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def run_words(self, words, environment=None):
        run = subprocess.run(words, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def small(self, words):
        """Returns a command of the page with other sizes, on the reference."""
        replaced = {"--turntable": str(FRAMES), "--size": "24x15", "--spp": "8"}
        result = [word.replace("turntable/", f"{self.folder}/") for word in words]
        for option, value in replaced.items():
            result[result.index(option) + 1] = value
        return [*result, "--device", "cpu"]

    def submit(self, words):
        with SlurmCluster(self.folder / "slurm") as cluster:
            position = words.index("--")
            self.run_words([*words[:position], "--candela", CANDELA, "--probe-time", "0.5", *words[position:]],
                           cluster.environment)
            cluster.wait_for(lambda: not cluster.run("squeue", "--noheader").strip(), "all jobs have ended")

    def test_the_commands_of_the_page_make_an_animation_of_a_full_turn(self):
        make_folder, render, assemble, submit = commands_of_page()
        self.assertEqual(make_folder, ["mkdir", "turntable"])
        self.run_words([CANDELA, *self.small(render)[1:]])
        pictures = [self.folder / f"frame.{frame:02}.png" for frame in range(FRAMES)]
        contents = [picture.read_bytes() for picture in pictures]
        self.assertEqual(len(set(contents)), FRAMES)

        animation = self.folder / "turntable.webp"
        words = [word.replace("turntable/*", f"{self.folder}/*") for word in assemble[:-1]]
        self.run_words(["sh", "-c", " ".join([*words, str(animation)])])
        information = self.run_words(["webpmux", "-info", str(animation)])
        self.assertIn("Canvas size: 24 x 15", information)
        self.assertIn(f"Number of frames: {FRAMES}", information)

        for picture in pictures:
            picture.unlink()
        self.submit(self.small(submit))
        self.assertEqual([picture.read_bytes() for picture in pictures], contents)


if __name__ == "__main__":
    CANDELA = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
