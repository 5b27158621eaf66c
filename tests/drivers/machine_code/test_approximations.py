#!/usr/bin/env python3
"""lavapipe computes reciprocals and square roots exactly: its machine code for our kernels has no approximate instructions.

    test_approximations.py PROGRAM

rcpps, rsqrtps and their successors have other bits on processors of other vendors. A render is stopped when its kernels have run, and
the memory that the driver filled with code is disassembled by objdump.
"""
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[3]
PROGRAM = sys.argv.pop()
APPROXIMATE = re.compile(r"v?(rcp|rsqrt)\w*")


def instructions_in(code):
    """The names of the instructions in bytes of machine code, with their numbers. Constants between functions are disassembled, too."""
    with tempfile.NamedTemporaryFile() as file:
        file.write(code)
        file.flush()
        text = subprocess.run(["objdump", "-D", "-b", "binary", "-m", "i386:x86-64", file.name], capture_output=True, text=True,
                              check=True).stdout
    counts = {}
    for name in re.findall(r"\t(?:\{\w+\} )?([a-z]\w+)", text):
        counts[name] = counts.get(name, 0) + 1
    return counts


def generated_code(pid):
    """The executable memory of a process that belongs to no file."""
    code = b""
    with open(f"/proc/{pid}/maps") as maps, open(f"/proc/{pid}/mem", "rb") as memory:
        for line in maps:
            addresses, permissions, _, _, inode, *name = line.split(None, 5)
            if "x" not in permissions or inode != "0" or name:
                continue
            start, end = (int(address, 16) for address in addresses.split("-"))
            memory.seek(start)
            code += memory.read(end - start)
    return code


def code_of_render(scene, *options):
    with tempfile.TemporaryDirectory() as folder:
        film = Path(folder, "film.exr")
        render = subprocess.Popen([PROGRAM, scene, "--quiet", "--checkpoint", film, "--checkpoint-every", "0.1s", "--spp", "1000000", "--size",
                                   "64x64", *options])
        try:
            deadline = time.monotonic() + 120
            while not film.exists() and render.poll() is None and time.monotonic() < deadline:
                time.sleep(0.1)
            if not film.exists():
                raise AssertionError(f"{scene}: no film was written")
            os.kill(render.pid, signal.SIGSTOP)
            return generated_code(render.pid)
        finally:
            render.kill()
            render.wait()


@unittest.skipUnless(os.uname().machine == "x86_64", "other processors have other instructions")
class Approximations(unittest.TestCase):
    def test_approximations_are_recognised(self):
        found = instructions_in(bytes.fromhex("0f53c0" "c5fc53c0" "c5fc52c0" "62f27d284cc0" "62f27d284ec0" "c5fc5ec0"))
        self.assertEqual([name for name in found if APPROXIMATE.fullmatch(name)], ["rcpps", "vrcpps", "vrsqrtps", "vrcp14ps", "vrsqrt14ps"])
        self.assertIn("vdivps", found)

    def check(self, scene, *options):
        found = instructions_in(code_of_render(scene, *options))
        divisions = sum(count for name, count in found.items() if re.fullmatch(r"v?divps", name))
        roots = sum(count for name, count in found.items() if re.fullmatch(r"v?sqrtps", name))
        self.assertGreater(divisions, 50)  # the code of the kernels is there
        self.assertGreater(roots, 5)
        self.assertEqual({name: count for name, count in found.items() if APPROXIMATE.fullmatch(name)}, {})

    def test_primitives(self):
        self.check(SOURCE / "scenes" / "primitives.p3f")

    def test_stages_of_the_wavefront(self):
        self.check(SOURCE / "scenes" / "primitives.p3f", "--kernel", "wavefront")

    def test_surfaces_under_daylight(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = Path(folder, "table.gltf")
            subprocess.run([PROGRAM, "generate", "material-table", "-o", scene, "--quiet"], check=True)
            self.check(scene, "--env", "sun:30,0,3")


unittest.main()
