"""The GIL is released, signals are handled, callbacks may raise."""
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import candela
from support import CORNELL, DEVICE, FolderTest, cornell

LONG = {"size": (1024, 1024), "spp": 512}  # takes minutes


class Stop(Exception):
    pass


def stop_at(seconds):
    """A callback that raises after a time."""
    start = time.monotonic()

    def progress(fraction, samples):
        if time.monotonic() > start + seconds:
            raise Stop(fraction, samples)

    return progress


class Threads(FolderTest):
    def test_other_threads_run(self):
        for device in ("cpu", DEVICE):
            with self.subTest(device):
                steps = []
                done = threading.Event()

                def count():
                    while not done.is_set():
                        steps.append(time.monotonic())
                        time.sleep(0.001)

                thread = threading.Thread(target=count)
                thread.start()
                start = time.monotonic()
                with self.assertRaises(Stop):
                    candela.render(cornell(), **LONG, device=device, threads=1, progress=stop_at(1.0))
                end = time.monotonic()
                done.set()
                thread.join()
                during = [step for step in steps if start < step < end]
                longest = max(b - a for a, b in zip([start, *during], [*during, end]))
                self.assertGreater(len(during), 50)
                self.assertLess(longest, 0.5, "the other thread had to wait")

    def test_progress(self):
        seen = []
        candela.render(cornell(), size=(64, 64), spp=64, device="cpu", progress=lambda *call: seen.append(call))
        self.assertEqual(seen[-1], (1.0, 64 * 64 * 64))
        self.assertEqual(seen, sorted(seen))

    def test_a_callback_that_raises_stops_the_work(self):
        for device in ("cpu", DEVICE):
            with self.subTest(device):
                start = time.monotonic()
                with self.assertRaises(Stop) as caught:
                    candela.render(cornell(), **LONG, device=device, progress=stop_at(0.2))
                self.assertLess(time.monotonic() - start, 20)
                self.assertLess(caught.exception.args[0], 1)

    def test_a_callback_that_is_none_of_a_callable(self):
        with self.assertRaises(TypeError):
            candela.render(cornell(), size=(8, 8), spp=1, device="cpu", progress=3)

    def test_callbacks_run_in_the_calling_thread(self):
        threads = set()
        candela.render(cornell(), size=(64, 64), spp=64, device="cpu",
                       progress=lambda *_: threads.add(threading.get_ident()))
        self.assertEqual(threads, {threading.get_ident()})

    def interrupt(self, call, device):
        """Ends a script in another process by SIGINT, and returns its output and the seconds that it took to end."""
        script = (f"import candela\nscene = candela.load({str(CORNELL)!r})\n"
                  f"started = lambda fraction, samples: samples and print('started', flush=True)\n"
                  f"options = dict(**{LONG!r}, device={device!r})\n"
                  f"try:\n    {call}\nexcept KeyboardInterrupt:\n    print('interrupted')\nprint('alive')\n")
        process = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline(), "started\n")
        start = time.monotonic()
        os.kill(process.pid, signal.SIGINT)
        output, errors = process.communicate(timeout=120)
        self.assertEqual((process.returncode, errors), (0, ""))
        lines = [line for line in output.splitlines() if line != "started"]
        self.assertEqual(lines[-2:], ["interrupted", "alive"])
        return lines[:-2], time.monotonic() - start

    def test_ctrl_c(self):
        for device in ("cpu", DEVICE):
            with self.subTest(device):
                film = self.folder / f"{device}.film"
                _, seconds = self.interrupt(f"candela.render(scene, **options, progress=started, checkpoint={str(film)!r})", device)
                self.assertLess(seconds, 15)
                description = candela.open_film(film).description
                self.assertGreater(description["samples"], 0)
                self.assertFalse(description["complete"])

    def test_ctrl_c_without_a_callback(self):
        """Then no code in Python runs in the main thread, which would handle signals by itself."""
        call = ("import threading\n"
                "    threading.Timer(1, print, ('started',), {'flush': True}).start()\n"
                "    candela.render(scene, **options)")
        _, seconds = self.interrupt(call, "cpu")
        self.assertLess(seconds, 15)

    def test_ctrl_c_leaves_a_session_usable(self):
        call = ("with candela.Session(scene, size=(16, 16), spp=8, device='cpu') as small:\n"
                "        session = candela.Session(scene, **options)\n"
                "        try:\n            session.advance(progress=started)\n"
                "        finally:\n            film = session.film\n            print(film.interrupted, film.samples.sum() > 0)")
        lines, seconds = self.interrupt(call, "cpu")
        self.assertEqual(lines, ["True True"])
        self.assertLess(seconds, 15)

    def test_a_session_is_for_one_thread_at_a_time(self):
        with candela.Session(cornell(), size=(512, 512), spp=512, device="cpu") as session:
            errors = []

            def intrude(fraction, samples):
                thread = threading.Thread(target=use)
                thread.start()
                thread.join()
                raise Stop

            def use():
                try:
                    session.film
                except candela.UsageError as error:
                    errors.append(str(error))

            with self.assertRaises(Stop):
                session.advance(progress=intrude)
            self.assertEqual(errors, ["the session is in use"])

    def test_a_session_is_not_for_its_own_callback(self):
        with candela.Session(cornell(), size=(512, 512), spp=512, device="cpu") as session:
            for use in (lambda: session.film, session.advance, session.close, lambda: session.reset(1)):
                with self.assertRaisesRegex(candela.UsageError, "the session is in use$"):
                    session.advance(progress=lambda *_: use())  # pylint: disable=cell-var-from-loop
            session.film

    def exit_beside(self, work, before="", threads=3):
        """Ends a program whose daemon threads work, and returns its output."""
        script = ("import threading, candela\n"
                  f"scene = candela.load({str(CORNELL)!r})\noptions = dict(**{LONG!r}, device='cpu')\n"
                  f"started = threading.Event()\nbegin = lambda *_: started.set()\n{before}\n"
                  f"def work():\n    {work}\n    print('worked')\n"
                  f"for _ in range({threads}):\n    threading.Thread(target=work, daemon=True).start()\n"
                  "started.wait()\nprint('end', flush=True)\n")
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False, timeout=120)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_the_interpreter_ends_while_daemon_threads_work(self):
        for work in ("candela.render(scene, **options, progress=begin)",
                     "candela.Session(scene, **options).advance(progress=begin)",
                     "while True: candela.render(scene, spp=1, size=(8, 8), device='cpu', progress=begin)",
                     "begin()\n    while True: candela.Scene([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])"):
            with self.subTest(work):
                output = self.exit_beside(work)
                self.assertEqual(output, "end\n")
        film = self.folder / "daemon.film"
        self.exit_beside(f"candela.render(scene, **options, progress=begin, checkpoint={str(film)!r})", threads=1)
        self.assertFalse(candela.open_film(film).description["complete"], "the film was written")

    def test_the_main_thread_may_render_while_the_interpreter_ends(self):
        late = "import atexit; atexit.register(lambda: print(candela.render(scene, spp=1, size=(8, 8), device='cpu').hash))"
        script = f"import atexit\ndef late():\n    print(candela.render(scene, spp=1, size=(8, 8), device='cpu').hash)\n" \
                 f"atexit.register(late)\nimport candela\nscene = candela.load({str(CORNELL)!r})\n"
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False, timeout=60)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, "^[0-9a-f]{16}$")
        self.assertEqual(self.exit_beside("candela.render(scene, **options, progress=begin)", late)[:4], "end\n")

    def test_a_child_process_does_not_wait_for_threads_of_its_parent(self):
        before = ("import os, sys\ndef child():\n    started.wait()\n    if os.fork() == 0:\n        print('child', flush=True); sys.exit()\n"
                  "    os.wait()\n")
        script = ("import threading, candela\n"
                  f"scene = candela.load({str(CORNELL)!r})\nstarted = threading.Event()\n{before}\n"
                  f"work = lambda: candela.render(scene, **{LONG!r}, device='cpu', progress=lambda *_: started.set())\n"
                  "threading.Thread(target=work, daemon=True).start()\nchild()\nprint('parent')\n")
        # From Python 3.12 on, every fork of a process with threads causes this warning.
        command = [sys.executable, "-W", "ignore::DeprecationWarning", "-c", script]
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "child\nparent\n", ""))


if __name__ == "__main__":
    unittest.main()
