#!/usr/bin/env python3
"""Renders and verifies every glTF file below a folder on one driver.

    python3 tests/formats/gltf/test_models.py CANDELA FOLDER [--icd FILE] [--size WxH] [--time-limit TIME] [--memory MIB]

The environment variable CANDELA_GLTF_MODELS, if it is set, replaces FOLDER. Exit code: 0 if every file is rendered and device and reference
compute the same light, 1 if not, 77 (skipped) if FOLDER is empty or has no glTF files. Prints the table of undecidable_shares.py. Each run of the program gets at most --memory of
address space, so that a driver that needs more fails instead of taking all memory of the machine.
"""
import argparse
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import undecidable_shares


def render(options, model, image):
    """Returns what went wrong; empty: nothing."""
    command = [options.candela, "render", model, "--size", options.size, "--spp", "1", "-q", "-o", image]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        return f"exit code {done.returncode} of a render: {done.stderr.strip()}"
    return "" if image.stat().st_size > 0 else "an empty image"


def failures(options, models):
    failed = []
    print(undecidable_shares.HEADER)
    with tempfile.TemporaryDirectory() as folder:
        for index, model in enumerate(models):
            problem = render(options, model, Path(folder) / f"{index}.pfm")
            row = undecidable_shares.row(options, model)
            print(row, flush=True)
            if not problem and undecidable_shares.EQUAL not in row:
                problem = "no verdict of equal light"
            if problem:
                failed.append(f"{model}: {problem}")
    return failed


def main():
    parser = argparse.ArgumentParser(prog="test_models.py")
    parser.add_argument("candela", help="the program")
    parser.add_argument("folder", help="is searched for .gltf and .glb; may be empty")
    parser.add_argument("--icd", help="manifest of the Vulkan driver")
    parser.add_argument("--size", default="64x64", help="of the pictures, pixels")
    parser.add_argument("--time-limit", default="3s", help="of the second part of each test")
    parser.add_argument("--memory", type=int, default=8192, help="address space of each run, MiB")
    options = parser.parse_args()
    folder = os.environ.get("CANDELA_GLTF_MODELS") or options.folder
    models = undecidable_shares.files_below(Path(folder)) if folder else []
    if not models:
        print(f"skipped: no glTF files in '{folder}'; CANDELA_GLTF_MODELS names a folder of models")
        sys.exit(77)
    if options.icd:
        os.environ["VK_DRIVER_FILES"] = os.environ["VK_ICD_FILENAMES"] = options.icd
    limit = options.memory << 20
    resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    failed = failures(options, models)
    print(f"{len(models)} files, {len(failed)} failed")
    for line in failed:
        print(line, file=sys.stderr)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
