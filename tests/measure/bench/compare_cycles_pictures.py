#!/usr/bin/env python3
"""Compares pictures of glTF scenes by Candela on lavapipe with those by Blender's Cycles, and prints a table.

    python3 tests/measure/bench/gltf_scenes.py scenes
    python3 tests/measure/bench/compare_cycles_pictures.py CANDELA OUT scenes/*.gltf [--spp N] [--size N] [--max-depth N]

Cycles renders each scene twice: with Principled BSDF, as Blender's importer makes it, and with the nodes of
cycles_surfaces.py, which are closer to glTF's text. Differences are Candela's minus Cycles', in per cent of Cycles' mean
radiance. The standard error, of the nodes' column, counts every difference as noise. The folder OUT has the pictures, the
maps of FLIP for the nodes, and all of them in comparison.png: for each scene Cycles (nodes), Candela, FLIP. With
--albedo, the scenes are those of `gltf_scenes.py --furnace`, and the table has the albedo of each ball instead.
"""
import argparse
import json
import math
import subprocess
import sys
from pathlib import Path

from compare_cycles import run_candela, run_cycles

MONTAGE = Path(__file__).with_name("montage.py")
SURFACES = ("principled", "gltf")
CYCLES_SEED = 1
TABLE_HEAD = ("| scene | Principled BSDF: difference of red, green and blue in % | relMSE | FLIP "
              "| nodes: difference of red, green and blue in % | relMSE | FLIP | standard error in % |\n"
              "|---|---|---:|---:|---|---:|---:|---:|")


def compare(options, ours, theirs, extra):
    """The report of `candela compare`, whose exit code would state whether the light differs."""
    command = [options.candela, "compare", ours, theirs, "-q", "--json", "-", *extra]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if not done.stdout:
        sys.exit(done.stderr)
    return json.loads(done.stdout)


def cells(report):
    """Differences of red, green and blue in per cent, relMSE and FLIP."""
    channels = " ".join(f"{100 * (ours / theirs - 1):+.2f}" for ours, theirs in zip(report["mean"], report["referenceMean"]))
    return f" {channels} | {report['relativeMeanSquaredError']:.4f} | {report['meanFlip']:.3f} |"


def standard_error(options, report):
    """Of the difference of the means, in per cent; too large where the pictures differ by more than noise."""
    return 100 * math.sqrt(report["meanSquaredError"]) / options.size / report["referenceMeanLuminance"]


def render(options, scene):
    name = scene.stem
    run_candela(options, scene, options.out / f"{name}.exr", options.size, options.spp, 0, ["-o", options.out / f"{name}.hdr"])
    for surfaces in SURFACES:
        run_cycles(options, scene, options.out / f"{name}-{surfaces}.exr", options.size, options.spp, CYCLES_SEED,
                   ["--surfaces", surfaces])


def table_row(options, name):
    row, error = f"| {name} |", 0
    for surfaces in SURFACES:
        flip = ["--flip", options.out / f"{name}-flip.png"] if surfaces == "gltf" else []
        report = compare(options, options.out / f"{name}.exr", options.out / f"{name}-{surfaces}.exr", flip)
        row, error = row + cells(report), standard_error(options, report)
    return row + f" {error:.2f} |"


def albedo_row(options, name):
    """A ball covers pi/4 of its picture; the rest has the radiance 1."""
    reports = [compare(options, options.out / f"{name}.exr", options.out / f"{name}-{surfaces}.exr", []) for surfaces in SURFACES]
    means = [reports[0]["meanLuminance"]] + [report["referenceMeanLuminance"] for report in reports]
    return f"| {name} |" + "".join(f" {1 - (1 - mean) * 4 / math.pi:.4f} |" for mean in means)


def write_montage(options):
    pictures = [options.out / f"{scene.stem}{end}" for scene in options.scenes for end in ("-gltf.exr", ".hdr", "-flip.png")]
    command = ["blender", "-b", "-noaudio", "-P", MONTAGE, "--", options.out / "comparison.png", options.columns, *pictures]
    subprocess.run([str(word) for word in command], check=True, capture_output=True)


def main():
    parser = argparse.ArgumentParser(prog="compare_cycles_pictures.py")
    parser.add_argument("candela", help="the program")
    parser.add_argument("out", type=Path, help="folder of the results")
    parser.add_argument("scenes", type=Path, nargs="+")
    parser.add_argument("--spp", type=int, default=128, help="samples per pixel")
    parser.add_argument("--size", type=int, default=256, help="side of the pictures, pixels; even")
    parser.add_argument("--max-depth", type=int, default=17, help="longest path in rays, the camera's included")
    parser.add_argument("--albedo", action="store_true", help="print the albedos of balls in a white environment")
    parser.add_argument("--columns", type=int, default=6, help="pictures in a row of comparison.png; a multiple of 3")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    print("| ball | Candela | Principled BSDF | nodes |\n|---|---:|---:|---:|" if options.albedo else TABLE_HEAD)
    for scene in options.scenes:
        render(options, scene)
        print((albedo_row if options.albedo else table_row)(options, scene.stem), flush=True)
    write_montage(options)


if __name__ == "__main__":
    main()
