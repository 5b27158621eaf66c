"""Plans, commands of tasks and the simulation of farm/, without a scheduler.

    python3 test_plan.py CANDELA
"""
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "farm"), str(ROOT / "farm/slurm")]
import commands  # noqa: E402
import frames as framing  # noqa: E402
import plan as planning  # noqa: E402
import sequences  # noqa: E402
import simulate  # noqa: E402
import tasks  # noqa: E402

CANDELA = "candela"
SCENE = str(ROOT / "scenes/furnace.p3f")
MOVING = ROOT / "tests/farm/moving_triangle.gltf"  # from x = -1 to 1 in one second


def plan_of(*shards, samples=10, render=("--device", "cpu", "--size", "8x8")):
    """Returns a plan of frames with these numbers of shards."""
    frame = framing.Frame([SCENE, *render, "--spp", str(samples)], [])
    return planning.Plan(CANDELA, "/", [frame] * len(shards), [samples] * len(shards), list(shards), "--shards", 5, "60s")


class PlanTest(unittest.TestCase):
    def test_shards_cover_every_sample_once_and_evenly(self):
        for samples, shards in ((10, 3), (7, 7), (1000, 64), (5, 1)):
            plan = plan_of(1, shards, samples=samples)
            ranges = [plan.range_of(1, shard) for shard in range(shards)]
            self.assertEqual([index for first, end in ranges for index in range(first, end)], list(range(samples)))
            lengths = [end - first for first, end in ranges]
            self.assertLessEqual(max(lengths) - min(lengths), 1)

    def test_tasks_are_numbered_frame_by_frame(self):
        plan = plan_of(3, 1, 2)
        self.assertEqual(plan.tasks(), [(0, 0), (0, 1), (0, 2), (1, 0), (2, 0), (2, 1)])
        self.assertEqual([plan.task(index) for index in range(6)], plan.tasks())

    def test_a_command_is_divided_into_render_and_pictures(self):
        frame = framing.frame_of(["a.glb", "--spp", "16", "-o", "a.png", "--exposure=2", "--output", "b.exr", "-oc.png"])
        self.assertEqual(frame.render, ["a.glb", "--spp", "16"])
        self.assertEqual(frame.pictures, [["-o", "a.png"], ["--exposure", "2"], ["-o", "b.exr"], ["-o", "c.png"]])
        self.assertEqual(frame.outputs(), ["a.png", "b.exr", "c.png"])

    def test_options_that_belong_to_shards_are_refused_by_name(self):
        for option in framing.REFUSED_OPTIONS:
            with self.assertRaisesRegex(framing.PlanError, option):
                framing.frame_of(["a.glb", option, "1"])
        with self.assertRaisesRegex(framing.PlanError, "-o: needs a value"):
            framing.frame_of(["a.glb", "-o"])

    def test_lines_of_a_list_are_words_of_a_shell(self):
        for line, words in (("a#1.glb --spp 4 -o 'out #2.png'", ["a#1.glb", "--spp", "4", "-o", "out #2.png"]),
                            ("a.glb -o a.png  # the first", ["a.glb", "-o", "a.png"]), ("# none", []), ("", []),
                            ('"a \\" #.glb" \\#b \\ #c', ['a " #.glb', "#b", " #c"])):
            self.assertEqual(framing.words_of(line), words, line)
        with self.assertRaises(ValueError):
            framing.words_of("a.glb -o 'a.png")

    def test_two_frames_never_write_the_same_file(self):
        frame = framing.frame_of(["a.glb", "-o", "a.png"])
        with self.assertRaisesRegex(framing.PlanError, "a.png: is the output of two frames"):
            framing.check_outputs([frame, framing.frame_of(["b.glb", "-o", "./a.png"])])
        with self.assertRaisesRegex(framing.PlanError, "folder does not exist"):
            framing.check_outputs([framing.frame_of(["b.glb", "-o", "/nowhere/a.png"])])

    def test_a_plan_is_read_as_it_was_written_and_damage_is_named(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            with self.assertRaisesRegex(framing.PlanError, "no plan.json"):
                planning.Plan.load(folder)
            plan = plan_of(3)
            plan.save(folder)
            self.assertEqual(planning.Plan.load(folder), plan)
            (folder / "plan.json").write_text((folder / "plan.json").read_text()[:-9])
            with self.assertRaisesRegex(framing.PlanError, "damaged"):
                planning.Plan.load(folder)

    def test_array_indices_are_written_as_sbatch_reads_them(self):
        self.assertEqual(commands.compact([0, 1, 2, 5, 7, 8]), "0-2,5,7-8")

    def test_wrong_usage_ends_with_1_and_an_unusable_file_with_2(self):
        program = str(ROOT / "farm/slurm/candela-render")
        codes = [subprocess.run([program, *arguments], capture_output=True, check=False).returncode
                 for arguments in (["--job"], ["--job", "/tmp"], ["--job", "/nowhere", "--status"])]
        self.assertEqual(codes, [1, 1, 2])


class TaskTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.job = Path(self.temporary.name)
        self.plan = plan_of(2)
        self.child = tasks.Child()

    def tearDown(self):
        self.temporary.cleanup()

    def film(self, shard):
        return planning.shard_file(self.job, 0, shard)

    def render(self, shard):
        return tasks.render_shard(self.plan, self.job, 0, shard, self.child)

    def test_a_shard_is_rendered_once_and_merged_with_the_others(self):
        self.assertFalse(planning.is_shard_done(self.plan, self.job, 0, 0))
        self.assertEqual(self.render(0), tasks.SUCCESS)
        self.assertTrue(planning.is_shard_done(self.plan, self.job, 0, 0))
        written = self.film(0).stat().st_mtime_ns
        self.assertEqual(self.render(0), tasks.SUCCESS)
        self.assertEqual(self.film(0).stat().st_mtime_ns, written)
        self.assertNotEqual(tasks.merge_frame(self.plan, self.job, 0, self.child), tasks.SUCCESS)
        self.assertEqual(self.render(1), tasks.SUCCESS)
        self.assertEqual(tasks.merge_frame(self.plan, self.job, 0, self.child), tasks.SUCCESS)
        self.assertTrue(planning.has_pictures(self.plan, self.job, 0))

    def test_a_damaged_shard_is_set_aside_and_rendered_again(self):
        self.film(0).parent.mkdir()
        self.film(0).write_bytes(b"not a film")
        self.assertEqual(self.render(0), tasks.SUCCESS)
        self.assertTrue(planning.is_shard_done(self.plan, self.job, 0, 0))
        self.assertEqual(len(list(self.film(0).parent.glob("*.damaged-*"))), 1)

    def test_a_good_shard_is_never_set_aside_because_it_could_not_be_examined(self):
        self.assertEqual(self.render(0), tasks.SUCCESS)
        good = self.film(0).read_bytes()
        for end in ("kill -9 $$", "kill -TERM $$", "exit 6", "exit 70"):
            broken = self.job / "broken"
            broken.write_text(f"#!/bin/sh\n{end}\n")
            broken.chmod(0o755)
            self.plan.candela = str(broken)
            with self.assertRaisesRegex(framing.PlanError, "cannot be examined"):
                self.render(0)
        self.assertEqual(self.film(0).read_bytes(), good)
        self.assertEqual(len(list(self.film(0).parent.glob("*.damaged-*"))), 0)

    def test_a_film_that_cannot_be_read_is_not_taken_for_a_damaged_one(self):
        self.film(0).parent.mkdir()
        self.film(0).symlink_to("/proc/self/mem")  # reading it fails with EIO
        with self.assertRaises(OSError):
            self.render(0)
        self.assertTrue(self.film(0).is_symlink())

    def test_a_task_that_is_stopped_while_it_examines_a_film_ends(self):
        self.film(0).parent.mkdir()
        self.film(0).write_bytes(b"not a film")
        self.child.forward(signal.SIGTERM, None)
        self.assertEqual(self.render(0), tasks.INTERRUPTED)
        self.assertTrue(self.film(0).exists())

    @contextmanager
    def rendered_beside_another_task(self):
        """Starts to render a shard whose lock another task has until the end of the block. Gives the list that the exit
        code is added to."""
        codes = []
        thread = threading.Thread(target=lambda: codes.append(self.render(0)))
        with tasks.exclusive(self.film(0).with_suffix(".lock"), self.child) as is_locked:
            self.assertTrue(is_locked)
            thread.start()
            time.sleep(2 * tasks.LOCK_POLL_SECONDS)
            self.assertEqual(codes, [], "the task waits")
            self.assertFalse(self.film(0).exists())
            yield codes
        thread.join(60)

    def test_a_task_waits_for_another_one_that_renders_its_shard(self):
        with self.rendered_beside_another_task() as codes:
            pass
        self.assertEqual(codes, [tasks.SUCCESS])
        self.assertTrue(planning.is_shard_done(self.plan, self.job, 0, 0))

    def test_a_shard_that_another_task_has_rendered_is_not_rendered_again(self):
        with self.rendered_beside_another_task() as codes:
            subprocess.run(tasks.shard_command(self.plan, self.job, 0, 0), check=True)
        self.assertEqual(codes, [tasks.SUCCESS])
        self.assertEqual(planning.describe(CANDELA, self.film(0))["work"]["runs"], 1)

    def test_a_task_that_waits_can_be_stopped(self):
        with self.rendered_beside_another_task() as codes:
            self.child.forward(signal.SIGUSR2, None)
            time.sleep(3 * tasks.LOCK_POLL_SECONDS)
            self.assertEqual(codes, [tasks.INTERRUPTED])
        self.assertFalse(self.film(0).exists())


class StopTest(unittest.TestCase):
    """Signals to tasks, which run in processes of their own."""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        self.task = None

    def tearDown(self):
        if self.task is not None and self.task.poll() is None:
            self.task.terminate()  # which is passed on to its program
            self.task.wait(30)
        self.temporary.cleanup()

    def start(self, work):
        """Starts a task in a group of its own: `work` are statements that set `code`, its exit code."""
        text = f"import sys; sys.path.insert(0, {str(ROOT / 'farm')!r})\nimport os, signal, subprocess, tasks\n" \
               f"import plan as planning\nfrom pathlib import Path\nchild = tasks.Child()\n{work}\nsys.exit(code)"
        self.task = subprocess.Popen([sys.executable, "-c", text], start_new_session=True, stderr=subprocess.DEVNULL)

    def wait_for(self, file):
        """Waits until the task has written the file."""
        for _ in range(6000):
            if file.exists() and file.stat().st_size > 0:
                return file
            self.assertIsNone(self.task.poll(), "the task has ended early")
            time.sleep(0.01)
        self.fail(f"{file} does not appear")

    def test_a_signal_to_the_whole_group_reaches_the_program_once(self):
        program = "import os, sys, time; open(sys.argv[1], 'w').write(str(os.getpgid(0))); time.sleep(60)"
        file = self.folder / "group"
        self.start(f"code = child.run([sys.executable, '-c', {program!r}, {str(file)!r}])")
        self.assertNotEqual(int(self.wait_for(file).read_text()), os.getpgid(self.task.pid))

    def test_a_render_whose_group_is_stopped_writes_its_film(self):
        plan = plan_of(1, samples=1 << 16, render=("--device", "cpu", "--threads", "1", "--size", "64x64"))
        plan.checkpoint_every = "0.01s"
        plan.save(self.folder)
        film = planning.shard_file(self.folder, 0, 0)
        for number in tasks.STOPS:
            film.unlink(missing_ok=True)
            job = f"Path({str(self.folder)!r})"
            self.start(f"code = tasks.render_shard(planning.Plan.load({job}), {job}, 0, 0, child)")
            self.wait_for(film)
            os.killpg(self.task.pid, number)
            self.assertEqual(self.task.wait(), tasks.INTERRUPTED)
            self.assertIsNotNone(planning.describe(CANDELA, film))

    def test_a_signal_while_the_program_is_started_stops_it(self):
        # The signal arrives between the start of the program and the end of Popen().
        self.start("class Start(subprocess.Popen):\n"
                   "    def __init__(self, *arguments, **options):\n"
                   "        super().__init__(*arguments, **options)\n"
                   "        os.kill(os.getpid(), signal.SIGTERM)\n"
                   "subprocess.Popen = Start\n"
                   "code = child.run(['sleep', '60'])")
        self.assertEqual(self.task.wait(30), tasks.INTERRUPTED)


def shown(frame):
    """Returns the arguments of a frame as one text."""
    return " ".join(word for words in (frame.render, *frame.pictures) for word in words)


class SequenceTest(unittest.TestCase):
    def frames(self, text, arguments):
        return [shown(frame) for frame in sequences.sequence_of(sequences.range_of(text), arguments.split())]

    def test_a_range_is_digits_colon_digits_and_everything_else_the_name_of_a_list(self):
        self.assertEqual(sequences.range_of("8:11"), range(8, 11))
        for name in ("frames.txt", "8", "8:", "a:b", "", "8:9:10"):
            self.assertIsNone(sequences.range_of(name))
        for text in ("3:3", "4:2"):
            with self.assertRaisesRegex(framing.PlanError, "not below the end"):
                sequences.range_of(text)

    def test_each_frame_has_its_time_and_its_files(self):
        self.assertEqual(self.frames("8:10", "a.glb --spp 4 --fps 30 -o out/f###.png --exposure 1"), [
            "a.glb --spp 4 --time 0.26666666666666666 -o out/f008.png --exposure 1",
            "a.glb --spp 4 --time 0.3 -o out/f009.png --exposure 1"])
        self.assertEqual(self.frames("0:2", "a.glb --seed=frame -of#.png"),
                         ["a.glb --time 0.0 --seed 0 -o f0.png", "a.glb --time 0.041666666666666664 --seed 1 -o f1.png"])

    def test_a_turntable_has_angles_and_with_a_rate_also_times(self):
        self.assertEqual(self.frames("", "a.glb --turntable 3 -o f#.png"), [
            "a.glb -o f0.png", "a.glb --orbit 120.0 -o f1.png", "a.glb --orbit 240.0 -o f2.png"])
        self.assertEqual(self.frames("5:6", "a.glb --turntable 4 --fps 4 --orbit -80 --seed 3 -o f#.png"),
                         ["a.glb --time 1.25 --orbit 10.0 --seed 3 -o f5.png"])
        self.assertEqual(self.frames("", "a.glb --time 2 -o f.png"), ["a.glb --time 2 -o f.png"])

    def test_what_makes_no_sense_is_refused(self):
        for arguments, message in (("a.glb --time 1 -o f#.png", "--time: each frame"), ("a.glb -o f.png", "lacks a place"),
                                   ("a.glb --fps 0 -o f#.png", "--fps 0"), ("a.glb --fps x -o f#.png", "--fps x"),
                                   ("a.glb --turntable 0 -o f#.png", "--turntable 0"),
                                   ("a.glb --frames 0:3 -o f#.png", "--frames: belongs before --")):
            with self.assertRaisesRegex(framing.PlanError, message):
                self.frames("0:3", arguments)

    def test_the_frames_are_those_of_the_program(self):
        options = ["--device", "cpu", "--size", "8x6", "--spp", "2", "--turntable", "7", "--fps", "30", "--orbit", "5",
                   "--seed", "frame"]
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([CANDELA, str(MOVING), *options, "--frames", "8:11", "-q", "-o", f"{folder}/a#.exr"], check=True)
            for frame in sequences.sequence_of(range(8, 11), [str(MOVING), *options, "-o", f"{folder}/b#.exr"]):
                subprocess.run([CANDELA, *frame.render, *frame.pictures[0], "-q"], check=True)
            for number in range(8, 11):
                self.assertEqual((Path(folder) / f"a{number}.exr").read_bytes(), (Path(folder) / f"b{number}.exr").read_bytes())


class TemplateTest(unittest.TestCase):
    def test_the_command_of_the_openjd_template_for_sequences_renders_and_resumes_a_frame(self):
        template = json.loads((ROOT / "farm/openjd/candela-sequence.template.json").read_text())
        text = template["steps"][0]["script"]["embeddedFiles"][0]["data"]
        with tempfile.TemporaryDirectory() as folder:
            values = {"Param.Scene": MOVING, "Param.Folder": folder, "Param.Candela": CANDELA,
                      "Param.Options": "--fps 24 --device cpu --size 8x8 --spp 2", "Task.Param.Frame": 7}
            for name, value in values.items():
                text = text.replace("{{" + name + "}}", str(value))
            self.assertNotIn("{{", text)
            for _ in range(2):
                subprocess.run(["sh", "-c", text], check=True, stderr=subprocess.DEVNULL)
            self.assertTrue(planning.describe(CANDELA, Path(folder) / "film.0007.exr")["complete"])
            self.assertTrue((Path(folder) / "frame.0007.png").exists())

    def test_the_commands_of_the_openjd_template_render_and_merge(self):
        template = json.loads((ROOT / "farm/openjd/candela.template.json").read_text())
        defaults = {one["name"]: one.get("default", "") for one in template["parameterDefinitions"]}
        with tempfile.TemporaryDirectory() as folder:
            parameters = {**defaults, "Scene": SCENE, "Folder": folder, "Samples": 5, "Shards": 2, "LastShard": 1,
                          "Options": "--device cpu --size 8x8", "Candela": CANDELA}

            def run(step, extra):
                text = step["script"]["embeddedFiles"][0]["data"]
                for name, value in {**{f"Param.{key}": value for key, value in parameters.items()}, **extra}.items():
                    text = text.replace("{{" + name + "}}", str(value))
                self.assertNotIn("{{", text)
                subprocess.run(["sh", "-c", text], check=True, stderr=subprocess.DEVNULL)

            render, merge = template["steps"]
            for shard in (1, 0, 0):
                run(render, {"Task.Param.Shard": shard})
            run(merge, {})
            self.assertTrue(planning.describe(CANDELA, Path(folder) / "film.exr")["complete"])
            self.assertTrue((Path(folder) / "picture.png").exists())


class SimulationTest(unittest.TestCase):
    def simulate(self, *arguments):
        return simulate.simulate(simulate.parse(arguments))

    def test_without_costs_and_losses_the_ideal_is_reached(self):
        outcome = self.simulate("--preemptions-per-day", "0", "--spread", "0", "--startup", "0", "--film-bytes", "0",
                                "--nodes", "10", "--shards", "40", "--node-hours", "20")
        self.assertAlmostEqual(outcome.finished, 7200)
        self.assertAlmostEqual(outcome.merged, 7200)
        self.assertEqual(outcome.lost, 0)

    def test_a_preemption_loses_no_more_than_a_checkpoint_and_a_start(self):
        outcome = self.simulate("--nodes", "50", "--shards", "200", "--node-hours", "100", "--preemptions-per-day", "48")
        self.assertGreater(outcome.preemptions, 50)
        self.assertLess(outcome.lost / outcome.preemptions, 200 + 20 + 2)

    def test_merging_as_a_tree_takes_less_time_than_at_once(self):
        tree, flat = self.simulate("--fan-in", "64"), self.simulate("--fan-in", "4000")
        self.assertLess(tree.merged - tree.finished, 0.1 * (flat.merged - flat.finished))


if __name__ == "__main__":
    CANDELA = str(Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=2)
