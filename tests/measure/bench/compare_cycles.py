#!/usr/bin/env python3
"""Compares the speed of Candela on lavapipe with that of Blender's Cycles on the same scenes, alternately, and prints a table.

    python3 tests/measure/bench/compare_cycles.py CANDELA SCENE... [--spp N] [--size N] [--max-depth N] [--rounds N] [--defaults-only]

Scenes are glTF files of gltf_scenes.py, and NFF files that cycles.py can read.

Figures are medians over the rounds. The processor's time, user and system of all threads, is what other work on the
machine changes least; a second is by the clock. Building the scene, compiling kernels and writing files are left out:
of Cycles by timing a second render, of Candela by taking away what a render of one sample per pixel takes. How much
noise the samples leave is measured by equal_time.py.
"""
import argparse
import glob
import json
import os
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

CYCLES = Path(__file__).with_name("cycles.py")
# Russian roulette may take the 6th vertex from Candela's paths, the 3rd from Cycles': each also as the other has it.
VARIANTS = [("Candela", "candela", []), ("Candela, early roulette", "candela", ["--rr-start", "1"]),
            ("Cycles", "cycles", []), ("Cycles, late roulette", "cycles", ["--roulette-start", "3"])]


@dataclass
class Runs:
    name: str
    tracer: str
    extra: list
    seconds: list = field(default_factory=list)
    processor_seconds: list = field(default_factory=list)
    rays_per_sample: float | None = None  # Cycles does not count


def lavapipe():
    drivers = glob.glob("/usr/share/vulkan/icd.d/lvp_icd*.json")
    if not drivers:
        sys.exit("lavapipe is not installed: apt-get install mesa-vulkan-drivers")
    return os.environ | {"VK_DRIVER_FILES": drivers[0], "VK_ICD_FILENAMES": drivers[0]}


def light_arguments(scene, tracer):
    """Options that light a glTF file as it asks in asset.extras.environment, and leave out Candela's default light."""
    if Path(scene).suffix != ".gltf":
        return []
    name = json.loads(Path(scene).read_text())["asset"].get("extras", {}).get("environment")
    if name:
        return ["--env", Path(scene).with_name(name)]
    return ["--env", "white", "--env-scale", "0"] if tracer == "candela" else []


def run_candela(options, scene, film, size, spp, seed, extra):
    """Its report, and the processor seconds of the whole process."""
    command = [options.candela, scene, "-q", "-o", film, "--json", "-", "--spp", spp, "--seed", seed,
               "--size", f"{size}x{size}", "--max-depth", options.max_depth, *light_arguments(scene, "candela"), *extra]
    process = subprocess.Popen([str(word) for word in command], env=lavapipe(), stdout=subprocess.PIPE, text=True)
    report = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit("failed: " + " ".join(process.args))
    return json.loads(report), usage.ru_utime + usage.ru_stime


def run_cycles(options, scene, film, size, spp, seed, extra):
    """The line of JSON that cycles.py prints."""
    command = ["blender", "-b", "-noaudio", "-P", CYCLES, "--", scene, film, "--spp", spp, "--seed", seed,
               "--size", size, "--max-depth", options.max_depth, *light_arguments(scene, "cycles"), *extra]
    done = subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True)
    lines = [line for line in done.stdout.splitlines() if line.startswith("cycles: ")]
    if not lines:
        sys.exit(done.stdout + done.stderr)
    return json.loads(lines[0].removeprefix("cycles: "))


def time_candela(options, scene, film, seed, runs):
    _, start_seconds = run_candela(options, scene, film, options.size, 1, seed, runs.extra)
    report, processor_seconds = run_candela(options, scene, film, options.size, options.spp, seed, runs.extra)
    runs.seconds.append(report["phaseSeconds"]["trace"])
    # The start had one sample per pixel, too.
    runs.processor_seconds.append((processor_seconds - start_seconds) * options.spp / (options.spp - 1))
    runs.rays_per_sample = report["rays"]["total"] / report["samples"]


def time_cycles(options, scene, film, seed, runs):
    report = run_cycles(options, scene, film, options.size, options.spp, seed, runs.extra)
    runs.seconds.append(report["seconds"])
    runs.processor_seconds.append(report["processorSeconds"])


def measure(options, scene, folder):
    all_runs = [Runs(*variant) for variant in VARIANTS if not (options.defaults_only and variant[2])]
    times = {"candela": time_candela, "cycles": time_cycles}
    run_candela(options, scene, folder / "timed.exr", options.size, 1, 0, [])  # fills the driver's cache of kernels
    for seed in range(options.rounds):
        for runs in all_runs:
            times[runs.tracer](options, scene, folder / "timed.exr", seed, runs)
    return all_runs


def print_table(options, scene, all_runs):
    samples = options.size * options.size * options.spp / 1e6
    print(f"\n{Path(scene).name}: {options.size} x {options.size}, {options.spp} samples per pixel, at most "
          f"{options.max_depth - 1} bounces, medians of {options.rounds}\n")
    print("| tracer | Msamples per processor second | Msamples/s | rays a sample |")
    print("|---|---:|---:|---:|")
    for runs in all_runs:
        rays = f"{runs.rays_per_sample:.2f}" if runs.rays_per_sample else ""
        speeds = sorted(samples / seconds for seconds in runs.processor_seconds)
        print(f"| {runs.name} | {statistics.median(speeds):.3f} ({speeds[0]:.3f} to {speeds[-1]:.3f})"
              f" | {samples / statistics.median(runs.seconds):.3f} | {rays} |")
    sys.stdout.flush()


def parse_options():
    parser = argparse.ArgumentParser(prog="compare_cycles.py")
    parser.add_argument("candela", help="the program")
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--spp", type=int, default=16, help="samples per pixel, at least 2")
    parser.add_argument("--size", type=int, default=512, help="side of the pictures, pixels")
    parser.add_argument("--max-depth", type=int, default=9, help="longest path in rays, the camera's included")
    parser.add_argument("--rounds", type=int, default=5, help="of all, in turn")
    parser.add_argument("--defaults-only", action="store_true", help="leave out the variants of Russian roulette")
    return parser.parse_args()


def main():
    options = parse_options()
    for scene in options.scenes:
        with tempfile.TemporaryDirectory() as folder:
            print_table(options, scene, measure(options, scene, Path(folder)))


if __name__ == "__main__":
    main()
