#!/usr/bin/python3
"""Measures what --noise-threshold saves at equal error: docs/adaptive-sampling.md section 4. Needs python3-openimageio and python3-numpy.

    /usr/bin/python3 tests/job/adaptive/measure.py SCENE --thresholds 0.3,0.2 [--side 128] [--seeds 3] [--reference 6144] [--program FILE]
"""
import argparse
import math
import subprocess
import tempfile
from pathlib import Path

import numpy
import OpenImageIO as oiio

REGION = 16
UNIFORM = (16, 32, 64, 128, 256, 512)


def load(file):
    """The channels R, G, B of an image, and its numbers of samples."""
    source = oiio.ImageInput.open(str(file))
    spec = source.spec()
    values = source.read_image(0, spec.nchannels, oiio.FLOAT).reshape(spec.height, spec.width, spec.nchannels)
    colours = numpy.stack([values[:, :, spec.channelnames.index(name)] for name in "RGB"], 2).astype(float)
    samples = values[:, :, spec.channelnames.index("samples")] * 4294967295.0  # OpenImageIO scales integers to 1
    return colours, samples


class Measurement:
    def __init__(self, arguments, folder):
        self.arguments = arguments
        self.picture = folder / "picture.exr"
        self.reference, _ = self.render(1000, ["--spp", str(arguments.reference)])

    def render(self, seed, options):
        size = f"{self.arguments.side}x{self.arguments.side}"
        subprocess.run([self.arguments.program, "render", self.arguments.scene, "--size", size, "--seed", str(seed),
                        "-q", "-o", self.picture, *options], check=True)
        return load(self.picture)

    def errors(self, options):
        """Mean number of samples, relMSE, and the relMSE of the region with the largest error."""
        samples, regions = 0, 0
        count = self.arguments.side // REGION
        for seed in range(self.arguments.seeds):
            picture, numbers = self.render(seed, options)
            squares = (picture - self.reference) ** 2 / (self.reference ** 2 + 0.01)
            regions = regions + squares.mean(2).reshape(count, REGION, count, REGION).mean((1, 3)) / self.arguments.seeds
            samples += numbers.mean() / self.arguments.seeds
        return samples, regions.mean(), regions.max()


def equal_samples(table, error):
    """The uniform number of samples with this error, interpolated between those of the table."""
    for (n0, e0), (n1, e1) in zip(table, table[1:]):
        if error >= e1 or n1 == table[-1][0]:
            return math.exp(math.log(n0) + (math.log(error) - math.log(e0)) * math.log(n1 / n0) / math.log(e1 / e0))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scene")
    parser.add_argument("--thresholds", default="0.3,0.2")
    parser.add_argument("--side", type=int, default=128)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--reference", type=int, default=6144)
    parser.add_argument("--program", default=str(Path(__file__).resolve().parents[3] / "build/release/candela"))
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        measurement = Measurement(arguments, Path(folder))
        uniform = [(n, *measurement.errors(["--spp", str(n)])[1:]) for n in UNIFORM]
        print("| T | samples | relMSE | uniform | saved | worst | uniform | saved |")
        print("|---:|---:|---:|---:|---:|---:|---:|---:|")
        for threshold in arguments.thresholds.split(","):
            samples, mean, worst = measurement.errors(["--spp", "4096", "--noise-threshold", threshold])
            by_mean = equal_samples([(n, e) for n, e, _ in uniform], mean)
            by_worst = equal_samples([(n, e) for n, _, e in uniform], worst)
            print(f"| {threshold} | {samples:.1f} | {mean:.5f} | {by_mean:.1f} | {by_mean / samples:.2f} "
                  f"| {worst:.4f} | {by_worst:.1f} | {by_worst / samples:.2f} |", flush=True)


if __name__ == "__main__":
    main()
