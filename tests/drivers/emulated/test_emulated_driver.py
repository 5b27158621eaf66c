#!/usr/bin/env python3
"""Runs a program for 64-bit ARM on lavapipe in an emulator: five scenes must agree with the reference, and ten conformance cases pass.

    python3 tests/drivers/emulated/test_emulated_driver.py --icd ICD COMMAND...

ICD is the manifest of lavapipe for arm64, COMMAND the emulator with its options and the program. Compiling a path tracer is most of the
work, so pictures are small. Exit code: 0 all passed, 1 not.
"""
import argparse
import os
import shlex
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCENES = ["balls", "cornell", "depth_of_field", "mirror", "primitives"]
CASES = ["leaf.integer.multiply_extended", "leaf.sampler.sobol", "leaf.float.divide", "leaf.float.sqrt", "leaf.float.pow", "leaf.film.carry",
         "control.loop.nested_break", "memory.atomic.combine", "memory.shared.scan", "group.size.3x5x2"]
RUN_SECONDS = 1800


def passes(command, environment):
    start = time.monotonic()
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=RUN_SECONDS)
    print(f"{'passed' if done.returncode == 0 else 'FAILED'} in {time.monotonic() - start:.0f} s: {shlex.join(command)}", flush=True)
    if done.returncode != 0:
        print(done.stdout, done.stderr, sep="\n", flush=True)
    return done.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--icd", required=True)
    parser.add_argument("command", nargs=argparse.REMAINDER)
    arguments = parser.parse_args()
    environment = os.environ | {"VK_DRIVER_FILES": arguments.icd, "VK_ICD_FILENAMES": arguments.icd}
    device = ["--device", "llvmpipe", "--untuned"]
    runs = [[*arguments.command, "compare", str(ROOT / "scenes" / f"{scene}.p3f"), *device, "--size", "8x8", "--spp", "1"] for scene in SCENES]
    cases = [word for case in CASES for word in ("--cases", case)]
    runs.append([*arguments.command, "conformance", "--device", "llvmpipe", "--jobs", "2", "--timeout", "600s", *cases])
    return 0 if all([passes(run, environment) for run in runs]) else 1


if __name__ == "__main__":
    sys.exit(main())
