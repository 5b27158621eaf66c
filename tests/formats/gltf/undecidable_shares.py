#!/usr/bin/env python3
"""Runs `candela verify` on every glTF file below a folder, and prints a table of what could not be decided.

    python3 tests/formats/gltf/undecidable_shares.py CANDELA FOLDER [--size WxH] [--time-limit TIME]

The device is the one that Candela chooses by default; VK_DRIVER_FILES names a driver. The share is that of the samples of verify's first look for which
rounding errors of single precision may change the path (docs/testing.md).
"""
import argparse
import json
import subprocess
import sys
from pathlib import Path

HEADER = "| model | device | equal samples in % | undecidable samples in % | verdict |\n|---|---|---:|---:|---|"
EQUAL = "equal light"


def files_below(folder):
    return sorted(file for end in ("*.gltf", "*.glb") for file in folder.rglob(end))


def row(options, model):
    command = [options.candela, "verify", model, "--size", options.size, "--time-limit", options.time_limit, "-q", "--json", "-"]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if not done.stdout:
        return f"| {model.stem} | | | | exit code {done.returncode}: {done.stderr.strip()} |"
    report = json.loads(done.stdout)
    paths = report["samePaths"]
    verdict = {True: EQUAL, False: "DIFFERENT"}.get(report["agrees"], "no verdict")
    return (f"| {model.stem} | {report['device']} | {100 * paths['equalFraction']:.2f} | {100 * paths['decisions']['undecidableFraction']:.2f}"
            f" | {verdict} |")


def main():
    parser = argparse.ArgumentParser(prog="undecidable_shares.py")
    parser.add_argument("candela", help="the program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--size", default="64x64", help="of the pictures, pixels")
    parser.add_argument("--time-limit", default="5s", help="of the second part of each test")
    options = parser.parse_args()
    models = files_below(options.folder)
    if not models:
        sys.exit(f"{options.folder}: no glTF files")
    print(HEADER)
    for model in models:
        print(row(options, model), flush=True)


if __name__ == "__main__":
    main()
