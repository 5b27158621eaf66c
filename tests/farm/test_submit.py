"""candela-render with programs that stand in for those of Slurm.

    python3 test_submit.py CANDELA
"""
import fcntl
import json
import os
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from fake_slurm import FakeSlurm

ROOT = Path(__file__).resolve().parents[2]
SUBMIT = ROOT / "farm/slurm/candela-render"
CORNELL = ROOT / "scenes/cornell.p3f"
RENDER = ["--device", "cpu", "--threads", "1", "--size", "16x16"]
CANDELA = "candela"


class SubmitTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name).resolve()
        self.job = self.folder / "job"
        self.picture = self.folder / "picture.png"
        self.slurm = FakeSlurm(self.folder / "slurm")

    def tearDown(self):
        self.temporary.cleanup()

    def submit(self, *arguments, expected=0, cwd=None, **variables):
        """Returns what candela-render prints."""
        run = subprocess.run([str(SUBMIT), "--job", str(self.job), "--candela", CANDELA, "--probe-time", "0.2", *arguments],
                             cwd=cwd or self.folder, env=self.slurm.environment(**variables), capture_output=True, text=True,
                             check=False)
        self.assertEqual(run.returncode, expected, run.stdout + run.stderr)
        return run.stdout + run.stderr

    def still(self, *options):
        return ["--", str(CORNELL), *RENDER, *options, "-o", str(self.picture)]

    def list_of(self, *frames):
        """Writes a list of frames, each given by its options. Returns the arguments."""
        file = self.folder / "frames.txt"
        file.write_text("".join(f"{CORNELL} {' '.join(RENDER)} {options} -o {self.folder}/{index}.png\n"
                                for index, options in enumerate(frames)))
        return ["--frames", str(file)]

    def jobs(self):
        return json.loads((self.job / "jobs.json").read_text())

    def run_jobs(self):
        for number in self.jobs():
            self.assertEqual(set(self.slurm.run(number)), {0})

    def one_run(self, options, *outputs):
        subprocess.run([CANDELA, str(CORNELL), *RENDER, *options, *outputs, "-q"], check=True)

    def film_of_one_run(self, *options):
        film = self.folder / "one.exr"
        film.unlink(missing_ok=True)
        self.one_run(options, "--checkpoint", str(film))
        return film.read_bytes()


class SampleTest(SubmitTest):
    def test_each_frame_of_a_list_has_its_own_number_of_samples(self):
        samples = (2, 7, 0, 1)
        output = self.submit("--shards", "3", *self.list_of(*(f"--spp {count}" for count in samples)))
        self.assertIn("7 of 7 shards and 4 merges", output)
        self.run_jobs()
        for frame, count in enumerate(samples):
            film = self.job / f"frame-{frame:05}/film.exr"
            self.assertEqual(film.read_bytes(), self.film_of_one_run("--spp", str(count)), count)
        self.assertIn("7 of 7 shards and 4 of 4 frames", self.submit("--status"))

    def test_frames_with_more_samples_have_more_shards(self):
        self.submit("--shard-minutes", "1e-7", *self.list_of("--spp 4", "--spp 400"))
        plan = json.loads((self.job / "plan.json").read_text())
        self.assertEqual(plan["samples"], [4, 400])
        self.assertEqual(plan["shards"], [4, 400])

    def test_a_list_states_the_samples_of_each_frame(self):
        self.assertIn("frame 2 has no --spp", self.submit(*self.list_of("", ""), expected=2))
        self.assertIn("--spp x: is not a number", self.submit(*self.list_of("--spp 1", "--spp x"), expected=2))
        self.assertEqual(self.slurm.submitted(), [])

    def test_names_in_a_list_may_have_any_bytes(self):
        scene = self.folder / os.fsdecode(b"sc\xe8ne #1.p3f")
        scene.write_bytes(CORNELL.read_bytes())
        line = f"'{scene}' {' '.join(RENDER)} --spp 2 -o '{self.folder}/1.png'\n"
        (self.folder / "frames.txt").write_bytes(os.fsencode(line))
        self.submit("--shards", "2", "--frames", str(self.folder / "frames.txt"))
        self.run_jobs()
        self.assertEqual((self.job / "frame-00000/film.exr").read_bytes(), self.film_of_one_run("--spp", "2"))

    def test_a_still_without_samples_has_those_of_its_scene(self):
        self.submit("--shards", "3", *self.still())
        self.run_jobs()
        self.assertEqual((self.job / "frame-00000/film.exr").read_bytes(), self.film_of_one_run())


class PictureTest(SubmitTest):
    def test_pictures_are_denoised(self):
        options = ["--spp", "4", "--denoise", "--exposure", "1"]
        self.submit("--shards", "2", *self.still(*options))
        self.run_jobs()
        alone = self.folder / "alone.png"
        self.one_run(options, "-o", str(alone))
        self.assertEqual(self.picture.read_bytes(), alone.read_bytes())

    def test_a_picture_from_before_is_replaced(self):
        self.picture.write_bytes(b"of another render")
        self.submit("--shards", "1", *self.still("--spp", "2"))
        self.assertEqual(self.slurm.run(self.jobs()[0]), [0])
        frame = self.job / "frame-00000"  # The merging task is killed before it makes the picture.
        subprocess.run([CANDELA, "merge", str(frame / "shard-00000.exr"), "-o", str(frame / "film.exr"), "-q"], check=True)
        self.assertIn("0 of 1 frames", self.submit("--status"))
        self.assertIn("0 of 1 shards and 1 merges", self.submit(*self.still("--spp", "2")))
        self.assertEqual(self.slurm.run(self.jobs()[0]), [0])
        self.assertTrue(self.picture.read_bytes().startswith(b"\x89PNG"))
        self.assertIn("everything is done", self.submit(*self.still("--spp", "2")))
        self.picture.unlink()
        self.assertIn("0 of 1 frames", self.submit("--status"))

    def test_pictures_of_an_earlier_film_do_not_count(self):
        self.submit("--shards", "1", *self.still("--spp", "2"))
        self.run_jobs()
        (self.job / "frame-00000/film.exr").unlink()
        self.submit(*self.still("--spp", "2"))
        self.picture.unlink()
        self.picture.mkdir()  # so that the picture cannot be written
        self.assertNotEqual(self.slurm.run(self.jobs()[-1]), [0])
        self.assertIn("0 of 1 frames", self.submit("--status"))

    def test_adaptive_sampling_is_refused_at_once(self):
        self.assertIn("--noise-threshold: decides by all samples",
                      self.submit(*self.still("--noise-threshold", "0.1"), expected=2))
        self.assertEqual(self.slurm.submitted(), [])


class RefusalTest(SubmitTest):
    def test_jobs_before_a_refusal_are_not_forgotten(self):
        output = self.submit("--shards", "2", *self.still("--spp", "2"), expected=4, FAKE_REFUSES="3")
        self.assertIn("QOSMaxSubmitJobPerUserLimit", output)
        self.assertIn("\n2 had been submitted before", output)
        self.assertEqual(self.jobs(), ["2"])
        self.assertIn("already submitted as 2", self.submit(*self.still("--spp", "2"), FAKE_QUEUE="2"))
        self.assertEqual(self.slurm.submitted(), ["1", "2"])
        self.assertEqual(self.slurm.run("2"), [0, 0])
        self.assertIn("0 of 2 shards and 1 merges", self.submit(*self.still("--spp", "2")))

    def start_task(self, **variables):
        """Starts the first shard, and returns its process."""
        environment = self.slurm.environment(SLURM_ARRAY_JOB_ID="2", SLURM_ARRAY_TASK_ID="0", **variables)
        return subprocess.Popen([str(SUBMIT), "--job", str(self.job), "--shard", "0"], env=environment, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def test_a_task_that_may_not_be_requeued_says_so(self):
        self.submit("--shards", "1", *self.still("--spp", "2"))
        (self.job / "frame-00000").mkdir()
        for variables, text in (({}, ""), ({"FAKE_REQUEUE": "Requeue is disabled"}, "is not requeued (scontrol: Requeue")):
            with open(self.job / "frame-00000/shard-00000.lock", "w", encoding="utf-8") as lock:
                fcntl.flock(lock, fcntl.LOCK_EX)  # so that the task waits
                task = self.start_task(**variables)
                self.assertIn("waiting", task.stdout.readline())
                task.send_signal(signal.SIGUSR2)
                output = task.communicate(timeout=60)[0]
            self.assertEqual(task.returncode, 7)
            self.assertIn("Slurm is asked to requeue the task", output)
            self.assertIn(text, output)
            self.assertEqual("not requeued" in output, bool(variables))

    def test_a_frame_that_cannot_be_rendered_is_unusable(self):
        (self.folder / "bad.p3f").write_text("nonsense")
        output = self.submit("--", "bad.p3f", *RENDER, "-o", "a.png", expected=2)
        log = self.job / "logs/candela-probe-1_4294967294.log"
        self.assertIn(f"the first frame could not be rendered; see {log}", output)
        self.assertIn("bad.p3f:1", log.read_text())
        self.assertIn("--checkpoint-every", self.submit("--checkpoint-every", "often", *self.still(), expected=2))

    def test_a_program_that_fails_without_a_message_is_named_with_its_exit_code(self):
        self.submit("--shards", "1", *self.still("--spp", "2"))
        self.assertIn("squeue: ended with exit code 7", self.submit(*self.still("--spp", "2"), expected=4,
                                                                    FAKE_SQUEUE_FAILS="1"))


class PlanTest(SubmitTest):
    def test_numbers_that_make_no_plan_are_wrong_usage(self):
        for option in ("--shard-minutes", "--shards", "--limit", "--running", "--probe-time"):
            for value in ("0", "-1", "nan", "inf", "many"):
                self.assertIn(f"argument {option}: invalid positive", self.submit(f"{option}={value}", *self.still(),
                                                                                  expected=1))

    def test_another_division_is_refused(self):
        self.submit("--shards", "3", *self.still("--spp", "4"))
        for option in (["--shards", "2"], ["--shard-minutes", "1"]):
            self.assertIn("was divided by --shards 3, not by " + " ".join(option),
                          self.submit(*option, *self.still("--spp", "4"), expected=2))
        self.assertIn("3 of 3 shards", self.submit("--shards", "3", *self.still("--spp", "4")))
        self.assertIn("3 of 3 shards", self.submit(*self.still("--spp", "4")))

    def test_relative_names_are_those_of_the_folder_of_the_submission(self):
        work, elsewhere = self.folder / "work", self.folder / "elsewhere"
        for folder in (work, elsewhere):
            folder.mkdir()
            (folder / "scene.p3f").write_bytes(CORNELL.read_bytes())
        command = ["--", "scene.p3f", *RENDER, "--spp", "2", "-o", "picture.png"]
        self.submit("--shards", "2", *command, cwd=work)
        self.run_jobs()
        self.assertTrue((work / "picture.png").exists())
        self.assertIn("1 of 1 frames", self.submit("--status", cwd=elsewhere))
        self.assertIn(f"was submitted in {work}", self.submit(*command, cwd=elsewhere, expected=2))

    def test_absolute_names_may_be_submitted_anywhere(self):
        self.submit("--shards", "2", *self.still("--spp", "2"))
        self.assertIn("2 of 2 shards", self.submit(*self.still("--spp", "2"), cwd=ROOT))

    def test_a_folder_that_a_node_does_not_see_is_no_obstacle_to_absolute_names(self):
        work = self.folder / "work"
        work.mkdir()
        self.submit("--shards", "1", *self.still("--spp", "2"), cwd=work)
        os.rmdir(work)
        self.run_jobs()

    def test_a_line_without_a_scene_is_named(self):
        file = self.folder / "frames.txt"
        file.write_text(f"{CORNELL} --spp 1 -oa.png\n--output=b.png\n")
        self.assertIn("frames.txt:2: a scene is missing", self.submit("--frames", str(file), expected=2))
        file.write_text("# nothing\n")
        self.assertIn("has no frame", self.submit("--frames", str(file), expected=2))


if __name__ == "__main__":
    CANDELA = str(Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=2)
