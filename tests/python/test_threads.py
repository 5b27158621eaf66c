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
            self.assertEqual(errors, ["the session is in use by another thread"])


if __name__ == "__main__":
    unittest.main()
