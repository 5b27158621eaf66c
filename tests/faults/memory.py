#!/usr/bin/env python3
"""Compares the memory that candela predicts for a software device with its peak.

    memory.py --program candela --icd lvp_icd.json

Required: at each size, the prediction of -v is right to 10 %; with --memory, smaller bands keep the peak within the
limit; and a render that cannot fit is refused with exit code 6."""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SIZES = ["1000x750", "1600x1200", "2000x1500"]  # in the first render, the driver compiles the kernel
LIMIT = 280  # MiB, of a render of 1000x750 pixels
SCENE = """v
from 0 -4 1
at 0 0 0
up 0 0 1
angle 40
hither 1
resolution 16 12
f 0.8 0.6 0.4 1 0 0 0 0 1 1 1
s 0 0 0 0.5
"""


def run(options, folder, words):
    """Returns the exit code, stderr, and the peak of the resident set in MiB."""
    words = [options.program, folder / "scene.nff", "--spp", "1", "-v", "--no-cache", "-o", folder / "a.exr", *words]
    environment = dict(os.environ, VK_DRIVER_FILES=options.icd, VK_ICD_FILENAMES=options.icd,
                       MESA_SHADER_CACHE_DIR=str(folder / "shaders"))
    with open(folder / "stderr", "w+") as errors:
        child = subprocess.Popen(words, stderr=errors, env=environment)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        errors.seek(0)
        return child.returncode, errors.read(), usage.ru_maxrss / 1024


def problems(options, folder):
    for size in SIZES:
        code, text, peak = run(options, folder, ["--size", size])
        predicted = re.search(r"about (\d+) MiB of memory", text)
        if code != 0 or not predicted:
            yield f"{size}: exit code {code}, no prediction: {text}"
            continue
        print(f"{size}: predicted {predicted[1]} MiB, measured {peak:.0f} MiB")
        if abs(int(predicted[1]) / peak - 1) > 0.1:
            yield f"{size}: the prediction of {predicted[1]} MiB is wrong by more than 10 %: {peak:.0f} MiB"
    code, text, peak = run(options, folder, ["--size", "1000x750", "--memory", f"{LIMIT}MiB"])
    print(f"1000x750 with --memory {LIMIT}MiB: measured {peak:.0f} MiB")
    if code != 0 or peak > LIMIT:
        yield f"--memory {LIMIT}MiB: exit code {code}, {peak:.0f} MiB: {text}"
    code, text, _ = run(options, folder, ["--size", "1000x750", "--memory", "200MiB"])
    if code != 6 or "of 200 MiB" not in text:
        yield f"--memory 200MiB: exit code {code}: {text}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--icd", required=True)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="candela-memory-") as folder:
        folder = pathlib.Path(folder)
        (folder / "scene.nff").write_text(SCENE)
        found = list(problems(options, folder))
    sys.exit("\n".join(found) or 0)


if __name__ == "__main__":
    main()
