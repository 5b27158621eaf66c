"""Common parts of the tests of the window: a display without a screen, the viewer on it, its pixels, keys and mouse."""
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import tempfile
import time
import unittest

import numpy
import OpenImageIO

PROGRAM = os.environ["CANDELA_PROGRAM"]
SOURCE = pathlib.Path(__file__).resolve().parents[3]
# Seconds until something that must happen counts as missing. SwiftShader compiles a kernel in up to 20 s, and on a loaded
# machine or with sanitizers in several times that.
PATIENCE = 240

# A picture of this size is shown with twice its size at this place of a window of 640 x 460 pixels.
SIZE = "144x230"
LEFT, TOP, ZOOM = 352, 0, 2


def wait_for(condition, what):
    """The first true value of condition()."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.05)
    raise AssertionError(f"{what}: not within {PATIENCE} s")


def read_pfm(file):
    """The pixels of a PFM file: rows from the top, three channels."""
    width, height, pixels = re.match(rb"PF\s(\d+)\s(\d+)\s\S+\s(.*)", file.read_bytes(), re.S).groups()
    return numpy.frombuffer(pixels, "<f4").reshape(int(height), int(width), 3)[::-1]


class Display:
    """A display without a screen, whose pixels are in a file."""

    def __init__(self, folder):
        self.folder = folder
        reader, writer = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "1024x768x24", "-fbdir", folder, "-nolisten", "tcp", "-noreset"],
                                       pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as pipe:
            self.name = ":" + pipe.readline().strip()
        self.environment = {**os.environ, "DISPLAY": self.name}

    def pixels(self):
        """The pixels of the screen, from the server's file, which has the format of xwd."""
        data = pathlib.Path(self.folder, "Xvfb_screen0").read_bytes()
        header = struct.unpack(">25I", data[:100])
        width, height, stride, colours = header[4], header[5], header[12], header[19]
        rows = numpy.frombuffer(data, numpy.uint8, stride * height, header[0] + 12 * colours).reshape(height, stride)
        return rows[:, : 4 * width].reshape(height, width, 4)[:, :, 2::-1].astype(int)

    def tool(self, *words):
        """Runs xdotool."""
        done = subprocess.run(["xdotool", *map(str, words)], env=self.environment, capture_output=True, text=True, check=True)
        return done.stdout.strip()

    def clipboard(self):
        return subprocess.run(["xclip", "-o", "-selection", "clipboard"], env=self.environment, capture_output=True, text=True, check=False).stdout

    def close(self):
        self.server.terminate()
        self.server.wait()


class Viewer:
    """A running viewer."""

    def __init__(self, display, folder, *words):
        self.display = display
        self.report_file = pathlib.Path(folder, "report.json")
        command = [PROGRAM, "view", *map(str, words), "--json", self.report_file]
        self.process = subprocess.Popen(command, env=display.environment, cwd=folder, stderr=subprocess.PIPE, text=True)
        self.window = wait_for(self.find, "the window")
        self.point(LEFT + 10, TOP + 10)

    def find(self):
        if self.process.poll() is not None:
            raise AssertionError(f"the viewer ended with {self.process.returncode}: {self.process.stderr.read()}")
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "candela"], env=self.display.environment, capture_output=True, text=True, check=False)
        return found.stdout.split()[0] if found.stdout.split() else None

    def title(self):
        return self.display.tool("getwindowname", self.window)

    def wait_for_samples(self, count):
        wait_for(lambda: f": {count} of " in self.title(), f"{count} samples")

    def picture(self):
        """One pixel of the screen for each pixel of the picture."""
        width, height = map(int, SIZE.split("x"))
        screen = self.display.pixels()
        return screen[TOP : TOP + ZOOM * height : ZOOM, LEFT : LEFT + ZOOM * width : ZOOM]

    def wait_for_picture(self, expected, what, tolerance=1):
        wait_for(lambda: abs(self.picture() - expected).max() <= tolerance, what)

    def key(self, *names):
        self.display.tool("key", *names)

    def point(self, x, y):
        self.display.tool("mousemove", x, y)

    def drag(self, start, end, button=1, steps=8):
        self.point(*start)
        self.display.tool("mousedown", button)
        for step in range(1, steps + 1):
            self.point(*(round(a + (b - a) * step / steps) for a, b in zip(start, end)))
            time.sleep(0.02)
        self.display.tool("mouseup", button)

    def copied_camera(self, previous=""):
        """The text of the camera, which must differ from the previous one."""
        self.key("c")

        def copied():
            text = self.display.clipboard()
            return text if text not in ("", previous) else None

        return wait_for(copied, "the camera in the clipboard")

    def close(self):
        """Ends the viewer by a key, and returns its report."""
        self.key("Escape")
        _, errors = self.process.communicate(timeout=PATIENCE)
        assert self.process.returncode == 0, errors
        return json.loads(self.report_file.read_text())


class WindowTest(unittest.TestCase):
    """A test with a display and a folder that has a copy of a scene."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="candela-view-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.renders = 0
        self.scene = self.folder / "room.p3f"
        shutil.copy(SOURCE / "scenes/cornell.p3f", self.scene)
        self.display = Display(folder.name)
        self.addCleanup(self.display.close)

    def view(self, *words):
        viewer = Viewer(self.display, self.folder, self.scene, "--size", SIZE, *words)
        self.addCleanup(viewer.process.kill)
        return viewer

    def render(self, *words, scene=None, size=SIZE, kind="png"):
        """The pixels of `candela render`; of a PNG file as they are shown, of a PFM file as they are. The file is `rendered`."""
        self.renders += 1
        file = self.folder / f"expected_{self.renders}.{kind}"  # OpenImageIO remembers what a file of this name had
        self.rendered = file
        subprocess.run([PROGRAM, "render", scene or self.scene, "--size", size, "-o", file, "--quiet", *map(str, words)], check=True)
        return read_pfm(file) if kind == "pfm" else OpenImageIO.ImageBuf(str(file)).get_pixels(OpenImageIO.UINT8).astype(int)
