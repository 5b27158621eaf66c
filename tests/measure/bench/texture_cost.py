#!/usr/bin/env python3
"""Measures what the textures of glTF models cost on lavapipe, and prints a table.

    python3 tests/measure/bench/texture_cost.py CANDELA MODEL... [--size N] [--spp N] [--rounds N]

Each model, a .gltf or .glb file, is rendered with its textures, without its normal maps, and without any texture, in
turn, under the same daylight. Emission is removed from all three, because without its texture it would be another light.
Factors and alpha modes stay, so that a mask by texture becomes opaque.
The figure is the processor time per ray, user and system of all threads, after that of a render of one sample has been
subtracted; medians over the rounds.
"""
import argparse
import json
import statistics
import struct
import tempfile
from pathlib import Path

from compare_cycles import run_candela

VARIANTS = ("all textures", "no normal maps", "no textures")
LIGHT = ["--env", "sun:40,30,3"]


def without(value, is_removed):
    """A copy of a JSON value without the members of objects whose name is_removed."""
    if isinstance(value, dict):
        return {name: without(member, is_removed) for name, member in value.items() if not is_removed(name)}
    if isinstance(value, list):
        return [without(member, is_removed) for member in value]
    return value


def is_normal_map(name):
    return name in ("normalTexture", "clearcoatNormalTexture")


def is_texture(name):
    return name.endswith("Texture")


def variant_of(document, variant):
    materials = without(document.get("materials", []), lambda name: name in ("emissiveTexture", "emissiveFactor"))
    if variant == "no normal maps":
        materials = without(materials, is_normal_map)
    elif variant == "no textures":
        materials = without(materials, is_texture)
    return document | {"materials": materials}


def read(model):
    """The document of a file, and what follows it in a GLB."""
    content = model.read_bytes()
    if content[:4] != b"glTF":
        return json.loads(content), None
    end = 20 + struct.unpack_from("<I", content, 12)[0]
    return json.loads(content[20:end]), content[end:]


def write(file, document, other_chunks):
    text = json.dumps(document).encode()
    if other_chunks is not None:
        text += b" " * (-len(text) % 4)
        length = 20 + len(text) + len(other_chunks)
        text = struct.pack("<4sIIII", b"glTF", 2, length, len(text), 0x4E4F534A) + text + other_chunks
    file.write_bytes(text)


def write_variants(model, folder):
    """The three files, in a folder that has links to everything beside the model."""
    for neighbour in model.resolve().parent.iterdir():
        if neighbour.name != model.name:
            (folder / neighbour.name).symlink_to(neighbour)
    document, other_chunks = read(model)
    files = []
    for index, variant in enumerate(VARIANTS):
        file = folder / f"variant-{index}{model.suffix}"
        write(file, variant_of(document, variant), other_chunks)
        files.append(file)
    return files


def render(options, model, file, spp):
    extra = [*LIGHT, "--allow-path", model.resolve().parent]
    return run_candela(options, file, file.with_suffix(".exr"), options.size, spp, 0, extra)


def nanoseconds_per_ray(options, model, file):
    one_report, one_seconds = render(options, model, file, 1)
    report, seconds = render(options, model, file, options.spp)
    return 1e9 * (seconds - one_seconds) / (report["rays"]["total"] - one_report["rays"]["total"])


def measure(options, model):
    times = {variant: [] for variant in VARIANTS}
    with tempfile.TemporaryDirectory() as name:
        files = write_variants(model, Path(name))
        for file in files:
            render(options, model, file, 1)  # fills the driver's cache of kernels
        for _ in range(options.rounds):
            for variant, file in zip(VARIANTS, files):
                times[variant].append(nanoseconds_per_ray(options, model, file))
    return times


def cell(times):
    return f"{statistics.median(times):.0f} ({min(times):.0f} to {max(times):.0f})"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("candela", help="the program")
    parser.add_argument("models", nargs="+", type=Path, help="glTF files")
    parser.add_argument("--spp", type=int, default=64, help="samples per pixel, at least 2")
    parser.add_argument("--size", type=int, default=256, help="side of the pictures, pixels")
    parser.add_argument("--max-depth", type=int, default=9, help="longest path in rays, the camera's included")
    parser.add_argument("--rounds", type=int, default=5, help="of all variants, in turn")
    options = parser.parse_args()
    print("| model | " + " | ".join(f"{variant}, ns per ray" for variant in VARIANTS) + " | all / none |")
    print("|---|" + "---:|" * (len(VARIANTS) + 1))
    for model in options.models:
        times = measure(options, model)
        ratio = statistics.median(times[VARIANTS[0]]) / statistics.median(times[VARIANTS[-1]])
        print(f"| {model.stem} | " + " | ".join(cell(times[variant]) for variant in VARIANTS) + f" | {ratio:.2f} |", flush=True)


if __name__ == "__main__":
    main()
