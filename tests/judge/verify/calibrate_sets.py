#!/usr/bin/env python3
"""Compares sets of renders by `candela compare A... --with B...`: a Vulkan device against the reference, with other seeds.

    python3 tests/judge/verify/calibrate_sets.py --program build/release/candela [--icd FILE] [--comparisons 100]

Both tracers show the same light, so that at most a number of alarms that the level 0.05 explains may occur (99 % quantile of the
binomial distribution). A scene whose lamp is 1 % brighter on the device must then be told from it by 16 renders on each side, and be 1 % brighter
within the interval of confidence. Exit code: 0 if both hold, 1 otherwise.
"""
import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
ALPHA = 0.05
LAMP = (17, 12, 4)  # of scenes/cornell.p3f


def quantile99(trials, probability):
    """Returns the number of successes that is exceeded with a probability of at most 1 %."""
    below, count = 0, -1
    while below < 0.99:
        count += 1
        below += math.comb(trials, count) * probability**count * (1 - probability)**(trials - count)
    return count


def run(options, words):
    environment = {**os.environ, **({"VK_ICD_FILENAMES": options.icd} if options.icd else {})}
    return subprocess.run([options.program, *map(str, words)], env=environment, capture_output=True, text=True, check=False)


def render(options, scene, pattern, seeds, size, samples, device):
    """Renders one picture for each seed of a range, and returns their names."""
    words = [scene, "--frames", f"{seeds.start}:{seeds.stop}", "--seed", "frame", "--size", size, "--spp", samples, "-o", f"{pattern}.######.exr",
             "-q", *(["--device", device] if device else [])]
    done = run(options, words)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: exit code {done.returncode}: {done.stderr.strip()}")
    return [f"{pattern}.{seed:06}.exr" for seed in seeds]


def compare(options, device, reference, alpha):
    done = run(options, ["compare", *device, "--with", *reference, "--alpha", alpha, "--json", "-", "-q"])
    if done.returncode not in (0, 3, 8):
        sys.exit(f"compare: exit code {done.returncode}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def count_alarms(options, scene, folder):
    count = options.comparisons * options.renders
    device = render(options, scene, folder / "device", range(1, 1 + count), "32x32", 4, options.device)
    reference = render(options, scene, folder / "reference", range(200001, 200001 + count), "32x32", 4, "cpu")
    groups = [slice(i, i + options.renders) for i in range(0, count, options.renders)]
    return sum(compare(options, device[group], reference[group], ALPHA)["agrees"] is False for group in groups)


def find_bias(options, scene, folder):
    text = Path(scene).read_text(encoding="utf-8")
    lamp = " ".join(map(str, LAMP))
    if lamp not in text:
        sys.exit(f"{scene} has no lamp of {lamp}")
    bright = folder / "bright.p3f"
    bright.write_text(text.replace(lamp, " ".join(f"{1.01 * value:.6g}" for value in LAMP)), encoding="utf-8")
    device = render(options, bright, folder / "bright", range(1, 17), "32x32", 256, options.device)
    reference = render(options, scene, folder / "exact", range(200001, 200017), "32x32", 256, "cpu")
    return compare(options, device, reference, 0.01)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--program", default=str(ROOT / "build/release/candela"))
    parser.add_argument("--icd", help="driver file for VK_ICD_FILENAMES")
    parser.add_argument("--device", help="selector of the device (default: the best one)")
    parser.add_argument("--comparisons", type=int, default=100)
    parser.add_argument("--renders", type=int, default=6, help="on each side of a comparison")
    options = parser.parse_args()
    scene = ROOT / "scenes/cornell.p3f"
    with tempfile.TemporaryDirectory() as folder:
        alarms, permitted = count_alarms(options, scene, Path(folder)), quantile99(options.comparisons, ALPHA)
        biased = find_bias(options, scene, Path(folder))
    image = biased["regions"][0]
    found = biased["agrees"] is False
    covers = image["differenceLowFraction"] <= 0.01 <= image["differenceHighFraction"]
    print(f"{options.comparisons} comparisons of equal light at {ALPHA:g}, {options.renders} renders on each side: {alarms} alarms, "
          f"{permitted} permitted")
    print(f"a lamp that is 1 % brighter: {'found' if found else 'NOT found'}, {100 * image['differenceFraction']:+.2f} % "
          f"({100 * image['differenceLowFraction']:+.2f} % to {100 * image['differenceHighFraction']:+.2f} %), p = {biased['pValue']:.2g}")
    return 0 if alarms <= permitted and found and covers else 1


if __name__ == "__main__":
    sys.exit(main())
