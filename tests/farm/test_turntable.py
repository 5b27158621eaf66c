"""Renders the turntable of the gallery as docs/gallery.md states it, small and with few frames, by an array of a real Slurm.

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

    def render(self, write, submit):
        """Runs the commands that write the frames and render them, with other sizes."""
        self.run_words([*write, "--frames", str(FRAMES), "--", "--size", "24x15", "--spp", "8", "--device", "cpu"])
        with SlurmCluster(self.folder / "slurm") as cluster:
            self.run_words([*submit, "--candela", CANDELA, "--probe-time", "0.5"], cluster.environment)
            cluster.wait_for(lambda: not cluster.run("squeue", "--noheader").strip(), "all jobs have ended")

    def test_the_commands_of_the_page_make_an_animation_of_a_full_turn(self):
        frames = self.folder / "turntable"
        write, submit, assemble = ([word.replace("turntable/", f"{frames}/") for word in words]
                                   for words in commands_of_page())
        self.render(write, submit)
        pictures = [frames / f"frame_{frame:03}.png" for frame in range(FRAMES)]
        self.assertEqual(len({picture.read_bytes() for picture in pictures}), FRAMES)
        animation = self.folder / "turntable.webp"
        self.run_words(["sh", "-c", " ".join(assemble[:-1]) + f" {animation}"])
        information = self.run_words(["webpmux", "-info", str(animation)])
        self.assertIn("Canvas size: 24 x 15", information)
        self.assertIn(f"Number of frames: {FRAMES}", information)

    def test_the_camera_circles_at_its_height(self):
        self.run_words([sys.executable, "docs/gallery/turntable.py", str(self.folder), "--frames", str(FRAMES)])
        positions = []
        for frame in range(FRAMES):
            text = (self.folder / f"frame_{frame:03}.p3f").read_text()
            positions.append([float(word) for word in re.search(r"^from (.*)$", text, re.MULTILINE)[1].split()])
        self.assertEqual(positions, [[0, -7.5, 2.6], [7.5, 0, 2.6], [0, 7.5, 2.6], [-7.5, 0, 2.6]])


if __name__ == "__main__":
    CANDELA = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
