#!/usr/bin/env python3
"""Compares the error of Candela on lavapipe in equal time with that of other path tracers on the processor.

    python3 tests/measure/bench/equal_time.py CANDELA SCENE... [--path-embree PROGRAM] [--spp N] [--size N] [--pictures N]
                                              [--references N] [--max-depth N] [--keep FOLDER]

Other tracers are Blender's Cycles, if `blender` is in PATH, and the path tracer on Embree (`ninja path_embree`), which
renders scenes of diffuse triangles. Each renders the same number of samples per pixel with several seeds, alternately,
and a reference of a few pictures with 8 times as many samples. `candela bench error` computes the figures.

Times are those of path tracing alone, without the start of the program, building the scene and compiling kernels. The
processor's time of Candela is the difference from a render of one sample per pixel.
"""
import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from compare_cycles import run_candela, run_cycles

REFERENCE_SAMPLES = 8  # times as many samples as a picture
REFERENCE_SEED = 1000


class Candela:
    def __init__(self, name, extra, options):
        self.name, self.extra, self.options = name, extra, options
        program = subprocess.run([options.candela, "--version"], check=True, capture_output=True, text=True)
        self.version = program.stdout.strip()

    def start(self, scene, film):
        run_candela(self.options, scene, film, self.options.size, 1, 0, self.extra)  # fills the driver's cache of kernels

    def render(self, scene, film, spp, seed):
        report, seconds = run_candela(self.options, scene, film, self.options.size, spp, seed, self.extra)
        self.version = self.version.split(";")[0] + "; " + report["driver"]
        return report["phaseSeconds"]["trace"], seconds

    def time(self, scene, film, spp, seed):
        _, start = run_candela(self.options, scene, film.with_name("start.exr"), self.options.size, 1, seed, self.extra)
        seconds, processor_seconds = self.render(scene, film, spp, seed)
        return seconds, (processor_seconds - start) * spp / (spp - 1)  # the start had one sample per pixel, too


class Cycles:
    def __init__(self, name, extra, options):
        self.name, self.extra, self.options, self.version = name, extra, options, ""

    def start(self, scene, film):
        self.version = "Blender " + run_cycles(self.options, scene, film, 16, 1, 0, self.extra)["version"]

    def render(self, scene, film, spp, seed):
        report = run_cycles(self.options, scene, film, self.options.size, spp, seed, self.extra)
        return report["seconds"], report["processorSeconds"]

    time = render


class Embree:
    name = "path tracer on Embree"

    def __init__(self, options):
        self.options, self.version = options, ""

    def start(self, scene, film):
        self.run(scene, film, 1, 0)

    def run(self, scene, film, spp, seed):
        command = [self.options.path_embree, scene, film, spp, self.options.size, seed, self.options.max_depth]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        if done.returncode:
            raise NotRendered(done.stderr.strip())
        report = json.loads(re.search("^embree: (.*)$", done.stdout, re.M)[1])
        self.version = report["version"]
        return report["seconds"], report["processorSeconds"]

    render = time = run


class NotRendered(Exception):
    """The tracer does not have the surfaces of the scene."""


def tracers_for(scene, options, folder):
    """Those that are installed and render the scene."""
    tracers = [Candela("Candela", [], options),
               Candela("Candela, independent samples", ["--sampler", "independent"], options)]
    if options.path_embree:
        tracers.append(Embree(options))
    else:
        print("no path tracer on Embree: install libembree-dev, build path_embree, and state it as --path-embree",
              file=sys.stderr)
    if shutil.which("blender"):
        tracers.append(Cycles("Cycles", [], options))
    else:
        print("no Cycles: install Blender (apt-get install --no-install-recommends blender)", file=sys.stderr)
    usable = []
    for tracer in tracers:
        try:
            tracer.start(scene, folder / "start.exr")
            usable.append(tracer)
        except NotRendered as reason:
            print(f"{tracer.name} is left out: {reason}", file=sys.stderr)
    return usable


def measure(scene, options, folder):
    """Renders all pictures, alternately, and writes the list of them."""
    tracers = tracers_for(scene, options, folder)
    lists = [{"tracer": tracer.name, "samplesPerPixel": options.spp, "pictures": [], "reference": []} for tracer in tracers]
    for seed in range(options.pictures):
        for index, (tracer, entry) in enumerate(zip(tracers, lists)):
            file = f"{index}-{seed}.exr"
            seconds, processor_seconds = tracer.time(scene, folder / file, options.spp, seed)
            entry["pictures"].append({"file": file, "seconds": seconds, "processorSeconds": processor_seconds})
    for picture in range(options.references):
        for index, (tracer, entry) in enumerate(zip(tracers, lists)):
            # References of different tracers are independent only with different seeds: two of them use the same numbers.
            seed = REFERENCE_SEED * (1 + index) + picture
            file = f"{index}-{seed}.exr"
            tracer.render(scene, folder / file, REFERENCE_SAMPLES * options.spp, seed)
            entry["reference"].append(file)
            entry["tracerVersion"] = tracer.version
    document = {"schema": "candela-error-runs/1", "scene": Path(scene).name, "tracers": lists}
    (folder / "runs.json").write_text(json.dumps(document, indent=1))


def parse_options():
    parser = argparse.ArgumentParser(prog="equal_time.py")
    parser.add_argument("candela", help="the program")
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--path-embree", help="the program that `ninja path_embree` builds")
    parser.add_argument("--spp", type=int, default=32, help="samples per pixel, at least 2")
    parser.add_argument("--size", type=int, default=256, help="side of the pictures, pixels")
    parser.add_argument("--pictures", type=int, default=5, help="of each tracer, at least 2")
    parser.add_argument("--references", type=int, default=3, help="pictures of its reference, at least 2")
    parser.add_argument("--max-depth", type=int, default=9, help="longest path in rays, the camera's included")
    parser.add_argument("--keep", type=Path, help="folder for the pictures, which are otherwise deleted")
    return parser.parse_args()


def main():
    options = parse_options()
    for scene in options.scenes:
        with tempfile.TemporaryDirectory() as temporary:
            folder = options.keep / Path(scene).stem if options.keep else Path(temporary)
            folder.mkdir(parents=True, exist_ok=True)
            measure(scene, options, folder)
            subprocess.run([options.candela, "bench", "error", folder / "runs.json", "--markdown", "-"], check=True)


if __name__ == "__main__":
    main()
