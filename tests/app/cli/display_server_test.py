"""--display-server against a stub that speaks tev's protocol: https://github.com/Tom94/tev, src/Ipc.cpp."""
import os
import pathlib
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy
import OpenImageIO

PROGRAM = os.environ["CANDELA_PROGRAM"]
CORNELL = pathlib.Path(__file__).resolve().parents[3] / "scenes/cornell.p3f"


class Packet:
    """Reads the content of a packet."""

    def __init__(self, data):
        self.data, self.place = data, 0

    def take(self, form):
        values = struct.unpack_from("<" + form, self.data, self.place)
        self.place += struct.calcsize("<" + form)
        return values if len(values) > 1 else values[0]

    def text(self):
        end = self.data.index(b"\0", self.place)
        text = self.data[self.place:end].decode()
        self.place = end + 1
        return text


class Stub(threading.Thread):
    """A server that stores the images that it receives. `limit`: closes the connection after this number of packets."""

    def __init__(self, limit=None, reads=True):
        super().__init__(daemon=True)
        self.server = socket.create_server(("127.0.0.1", 0))
        self.port = self.server.getsockname()[1]
        self.limit, self.reads = limit, reads
        self.images, self.updates, self.creations, self.tiles = {}, 0, 0, []
        self.ended = threading.Event()
        self.start()

    def run(self):
        connection, _ = self.server.accept()
        self.server.close()
        with connection:
            stream = connection.makefile("rb")
            count = 0
            while self.reads and (head := stream.read(4)):
                self.handle(Packet(stream.read(struct.unpack("<I", head)[0] - 4)))
                count += 1
                if self.limit and count >= self.limit:
                    break
            if not self.reads:
                self.ended.wait(60)
        self.ended.set()

    def handle(self, packet):
        kind, focus, name = *packet.take("BB"), packet.text()
        assert focus == 0
        if kind == 4:
            width, height, channels = packet.take("iii")
            self.images[name] = {packet.text(): numpy.full((height, width), numpy.nan, "<f4") for _ in range(channels)}
            self.creations += 1
        elif kind == 6:
            channels = packet.take("i")
            names = [packet.text() for _ in range(channels)]
            x, y, width, height = packet.take("iiii")
            offsets = [packet.take("q") for _ in names]
            strides = [packet.take("q") for _ in names]
            values = numpy.frombuffer(packet.data[packet.place:], "<f4")
            assert len(values) == max(o + (width * height - 1) * s + 1 for o, s in zip(offsets, strides))
            for channel, offset, stride in zip(names, offsets, strides):
                self.images[name][channel][y:y + height, x:x + width] = values[offset::stride].reshape(height, width)
            self.updates += 1
            self.tiles.append((x, y, width, height))
        else:
            raise AssertionError(f"packet of kind {kind}")


def read(file):
    picture = OpenImageIO.ImageInput.open(str(file))
    pixels = picture.read_image(format="float")
    return {name: pixels[:, :, i] for i, name in enumerate(picture.spec().channelnames)}


class DisplayServer(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def render(self, address, *words, code=0, scene=CORNELL):
        done = subprocess.run([PROGRAM, scene, "--display-server", address, *map(str, words)], capture_output=True, text=True, check=False,
                              timeout=120)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr

    def check(self, device, *words):
        stub = Stub()
        file = self.folder / f"{device}.exr"
        self.render(f"127.0.0.1:{stub.port}", "--size", "80x70", "--device", device, *words, "-o", file, "--aov", "normal,depth")
        self.assertTrue(stub.ended.wait(10), "the connection is closed at the end")
        self.assertEqual((set(stub.images), stub.creations), ({file.name}, 1))
        shown, expected = stub.images[file.name], read(file)
        self.assertEqual(set(shown), set(expected) - {"samples", "variance.Y"})
        for name, values in shown.items():
            numpy.testing.assert_array_equal(values, expected[name], err_msg=name)
        return stub

    def test_the_last_image_is_that_of_the_file(self):
        for device in ("cpu", "llvmpipe"):
            stub = self.check(device, "--spp", "2")
            self.assertGreaterEqual(set(stub.tiles), {(0, 0, 64, 64), (64, 0, 16, 64), (0, 64, 64, 6), (64, 64, 16, 6)})

    def test_alpha(self):
        self.assertIn("A", self.check("cpu", "--spp", "1", "--background", "none").images["cpu.exr"])

    def test_tiles_are_sent_while_samples_finish(self):
        plain = self.folder / "plain.exr"
        subprocess.run([PROGRAM, CORNELL, "--size", "80x70", "--device", "cpu", "--spp", "100", "-o", plain, "--quiet"], check=True)
        stub = self.check("cpu", "--spp", "100")
        self.assertGreater(stub.updates, 4 * 3)
        numpy.testing.assert_array_equal(stub.images["cpu.exr"]["R"], read(plain)["R"])

    def test_other_outputs_may_be_omitted(self):
        stub = Stub()
        self.render(f"localhost:{stub.port}", "--size", "8x8", "--spp", "1", "--device", "cpu")
        self.assertTrue(stub.ended.wait(10))
        self.assertEqual(set(stub.images), {"cornell.p3f"})

    def test_servers_that_fail_are_warnings(self):
        silent = socket.create_server(("127.0.0.1", 0))
        port = silent.getsockname()[1]
        silent.close()
        file = self.folder / "a.png"
        words = ("--size", "8x8", "--spp", "1", "--device", "cpu", "-o", file)
        errors = self.render(f"127.0.0.1:{port}", *words)
        self.assertIn(f"warning: --display-server 127.0.0.1:{port}: Connection refused; the render continues without it", errors)
        self.assertTrue(file.exists())
        errors = self.render("no-such-host.invalid:14158", *words)
        self.assertIn("--display-server no-such-host.invalid:14158: ", errors)
        stub = Stub(limit=1)
        errors = self.render(f"127.0.0.1:{stub.port}", "--size", "200x150", "--spp", "30", "--device", "cpu", "-o", file)
        self.assertRegex(errors, "(Connection reset by peer|Broken pipe); the render continues without it")
        self.assertEqual(errors.count("--display-server"), 1)

    def test_a_server_that_takes_nothing_does_not_hold_the_render(self):
        stub = Stub(reads=False)
        errors = self.render(f"127.0.0.1:{stub.port}", "--size", "1200x900", "--spp", "1", "--max-depth", "1", "--device", "cpu", "-o", self.folder / "a.pfm")
        stub.ended.set()
        self.assertIn("Connection timed out; the render continues without it", errors)

    def test_wrong_addresses(self):
        for address in ("", "host", "host:", ":14158", "host:0", "host:65536", "host:12x", "[::1]", "::1:14158"):
            errors = self.render(address, "--device", "cpu", "--spp", "1", code=1)
            self.assertIn("--display-server: expected HOST:PORT", errors)

    def test_addresses_of_ipv6(self):
        errors = self.render("[::1]:9", "--size", "8x8", "--device", "cpu", "--spp", "1")
        self.assertIn("warning: --display-server [::1]:9: ", errors)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
