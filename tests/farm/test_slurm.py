"""Renders on a real Slurm whose tasks are killed: the film has the bytes of one uninterrupted run.

    python3 test_slurm.py CANDELA [TEST...]
"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from slurm_cluster import SlurmCluster

ROOT = Path(__file__).resolve().parents[2]
SUBMIT = ROOT / "farm/slurm/candela-render"
SCENE = ROOT / "scenes/cornell.p3f"
SHARDS = 8
RENDER = ["--device", "cpu", "--threads", "1", "--size", "64x64", "--spp", "128"]
CANDELA = "candela"


class SlurmTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        self.job = self.folder / "job"
        self.picture = self.folder / "picture.png"
        self.cluster = SlurmCluster(self.folder / "slurm", max_array_size=6)
        self.cluster.__enter__()

    def tearDown(self):
        self.cluster.__exit__()
        self.temporary.cleanup()

    def submit(self, *arguments, expected=0):
        command = [str(SUBMIT), "--job", str(self.job), "--candela", CANDELA, "--probe-time", "0.5", "--checkpoint-every",
                   "0.1s", *arguments]
        run = subprocess.run(command, env=self.cluster.environment, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, expected, run.stdout + run.stderr)
        return run.stdout + run.stderr

    def submit_still(self):
        return self.submit("--shards", str(SHARDS), "--", str(SCENE), *RENDER, "-o", str(self.picture), "--exposure", "1")

    def jobs(self):
        return json.loads((self.job / "jobs.json").read_text())

    def films(self):
        return sorted(self.job.glob("frame-*/shard-*.exr"))

    def finish(self):
        self.cluster.wait_for(lambda: not self.cluster.run("squeue", "--noheader").strip(), "all jobs have ended")

    def running(self, job):
        return [task for task, state in self.cluster.states(job).items() if state == "RUNNING"]

    def run_in_the_middle(self, job):
        """Returns a task that is running and whose shard has been written at least once."""
        found = []

        def look():
            found[:] = [task for task in self.running(job)
                        if (self.job / f"frame-00000/shard-{int(task.split('_')[1]):05}.exr").exists()]
            return found

        self.cluster.wait_for(look, "a task runs")
        return found[0]

    def check_equals_one_run(self, film):
        alone = self.folder / "alone.exr"
        subprocess.run([CANDELA, str(SCENE), *RENDER, "--checkpoint", str(alone), "-q"], check=True)
        self.assertEqual(film.read_bytes(), alone.read_bytes())

    def test_a_render_survives_kills_requeues_and_a_lost_daemon(self):
        output = self.submit_still()
        self.assertIn("8 of 8 shards", output)
        first = self.jobs()[0]
        self.assertIn("already submitted", self.submit_still())

        requeued = self.run_in_the_middle(first)
        self.cluster.run("scontrol", "requeue", requeued)
        killed = self.run_in_the_middle(first)
        self.cluster.run("scancel", "--signal=KILL", "--full", killed)
        self.run_in_the_middle(first)
        self.cluster.kill_node()
        self.cluster.start_node()
        self.finish()

        done = {film: film.read_bytes() for film in self.films()}
        self.assertFalse(self.picture.exists(), "the merge waits for a shard that was killed")
        output = self.submit_still()
        self.assertNotIn("8 of 8 shards", output)
        self.finish()
        self.assertTrue(self.picture.exists())
        self.check_equals_one_run(self.job / "frame-00000/film.exr")
        shards = [self.job / f"frame-00000/shard-{index:05}.exr" for index in range(SHARDS)]
        again = self.folder / "again.exr"
        subprocess.run([CANDELA, "merge", *map(str, shards), "-o", str(again), "-q"], check=True)
        self.assertEqual(again.read_bytes(), (self.job / "frame-00000/film.exr").read_bytes())
        self.assertGreater(len(done), 4)
        self.assertIn("everything is done", self.submit_still())

    def test_a_shard_that_reaches_its_time_limit_is_requeued_and_resumed(self):
        self.submit("--shards", "1", "--", str(SCENE), *RENDER, "-o", str(self.picture))
        job = self.jobs()[0]
        task = self.run_in_the_middle(job)
        self.cluster.run("scancel", "--batch", "--signal=USR2", task)
        self.cluster.wait_for(lambda: any("is asked to requeue" in log.read_text() for log in self.job.glob("logs/candela-shard*")),
                              "the task asks to be requeued")
        self.finish()
        self.check_equals_one_run(self.job / "frame-00000/film.exr")
        runs = json.loads((self.job / "frame-00000/film.exr.json").read_text())["runs"]
        self.assertGreaterEqual(runs, 2)

    def test_frames_of_a_list_are_rendered_and_merged_each(self):
        frames = self.folder / "frames.txt"
        lines = [f"{SCENE} --device cpu --size 16x16 --spp 4 --seed {seed} -o '{self.folder}/frame {seed}.png'"
                 for seed in range(7)]
        frames.write_text("# seven frames\n" + "\n".join(lines) + "\n")
        output = self.submit("--shards", "2", "--frames", str(frames))
        self.assertIn("14 of 14 shards and 7 merges", output)
        self.assertEqual(len(self.jobs()), 5, "arrays are split at Slurm's limit of indices")
        self.finish()
        self.assertEqual(len(list(self.folder.glob("frame *.png"))), 7)
        self.assertIn("14 of 14 shards and 7 of 7 frames are done", self.submit("--status"))

    def test_a_sequence_that_is_killed_and_submitted_again_equals_one_run(self):
        options = [str(ROOT / "tests/farm/moving_triangle.gltf"), "--device", "cpu", "--size", "160x120", "--spp", "64"]
        command = ["--shards", "1", "--frames", "0:48", "--", *options, "-o", str(self.folder / "frame.##.png")]
        self.assertIn("48 of 48 shards and 48 merges", self.submit(*command))
        first = self.jobs()[0]

        def films():
            return [film for film in self.job.glob("frame-*/shard-*.exr")]

        self.cluster.wait_for(lambda: len(films()) > 5, "some frames are rendered")
        for task in self.running(first):
            self.cluster.run("scancel", "--signal=KILL", "--full", task)
        self.cluster.run("scancel", *self.jobs())
        self.finish()
        self.assertFalse(list(self.folder.glob("frame.*.png")), "the merges waited for frames that were killed")
        rendered = len(films())
        self.assertLess(rendered, 48)

        output = self.submit(*command)
        self.assertNotIn("48 of 48 shards", output)
        self.finish()
        self.assertIn("48 of 48 shards and 48 of 48 frames are done", self.submit("--status"))
        subprocess.run([CANDELA, *options, "--frames", "0:48", "-o", str(self.folder / "one.##.png"), "--checkpoint",
                        str(self.folder / "one.##.exr"), "-q"], check=True)
        for frame in range(48):
            self.assertEqual((self.folder / f"frame.{frame:02}.png").read_bytes(),
                             (self.folder / f"one.{frame:02}.png").read_bytes())
            self.assertEqual((self.job / f"frame-{frame:05}/film.exr").read_bytes(),
                             (self.folder / f"one.{frame:02}.exr").read_bytes())


if __name__ == "__main__":
    CANDELA = str(Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=2)
