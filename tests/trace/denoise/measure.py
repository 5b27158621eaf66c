#!/usr/bin/env python3
"""Measures the denoiser, and prints the tables of docs/denoising.md.

Each scene is rendered with few samples, and with 4,096 samples and another seed as the reference. Films are kept in
--work and rendered only if they are not there. Of each pair, relMSE and FLIP are printed for the image as it is, after a
plain joint bilateral filter, and denoised; of the reference, how much denoising changes it.

  tests/trace/denoise/measure.py --build build/release --work /tmp/films --gltf ToyCar.glb
"""

import argparse
import json
import pathlib
import statistics
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCENES = ("cornell", "balls", "depth_of_field", "mirrors", "sky", "smallpt")
COUNTS = (4, 16, 64)
REFERENCE = 4096


def rendered(options, name, words, count):
    """Returns the film of a scene, which is rendered if it is not there."""
    film = options.work / f"{name}.{count}.film"
    if not film.exists():
        seed = 1000 if count == REFERENCE else 1
        subprocess.run([options.build / "candela", *words, "--size", "96x96", "--spp", str(count), "--seed", str(seed),
                        "--aov", "moments", "--checkpoint", film, "--quiet", *options.render], check=True)
    return film


def errors(options, film, reference):
    """Returns the errors of the image of a film."""
    program = options.build / "tests/trace/denoise/measure_denoising"
    return json.loads(subprocess.run([program, film, reference], check=True, capture_output=True, text=True).stdout)


def row(name, measured):
    """Prints a row of the table of one number of samples, and returns the ratio of denoised and input."""
    before, bilateral, after = (measured[key] for key in ("input", "bilateral", "denoised"))
    ratio = after["relMSE"] / before["relMSE"]
    print(f"| {name} | {before['relMSE']:.5f} | {bilateral['relMSE']:.5f} | {after['relMSE']:.5f} | {ratio:.2f} "
          f"| {before['FLIP']:.3f} | {bilateral['FLIP']:.3f} | {after['FLIP']:.3f} |")
    return ratio


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder of the films")
    parser.add_argument("--gltf", help="a glTF model to measure besides")
    parser.add_argument("render", nargs="*", help="options of the renders, behind --")
    options = parser.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    scenes = {name: [ROOT / f"scenes/{name}.p3f"] for name in SCENES}
    if options.gltf:
        scenes[pathlib.Path(options.gltf).stem] = [options.gltf, "--env", "sun:40,120,3"]
    references = {name: rendered(options, name, words, REFERENCE) for name, words in scenes.items()}
    for count in COUNTS:
        print(f"\n{count} samples\n\n| scene | relMSE | bilateral | denoised | ratio | FLIP | bilateral | denoised |\n"
              "|---|---:|---:|---:|---:|---:|---:|---:|")
        ratios = [row(name, errors(options, rendered(options, name, words, count), references[name]))
                  for name, words in scenes.items()]
        print(f"\nratio: median {statistics.median(ratios):.2f}, maximum {max(ratios):.2f}")
    print(f"\nchange of the image of {REFERENCE} samples\n\n| scene | relMSE | FLIP | brightness |\n|---|---:|---:|---:|")
    for name, film in references.items():
        change = errors(options, film, film)["denoised"]
        print(f"| {name} | {change['relMSE']:.2e} | {change['FLIP']:.4f} | {100 * change['brightness']:+.3f} % |")


if __name__ == "__main__":
    main()
