#!/usr/bin/env python3
"""Writes the scenes and the list of frames of a turntable: a camera that circles around the marbles.

    docs/gallery/turntable.py FOLDER [--frames N] [-- OPTIONS OF candela render]
    farm/slurm/candela-render --job FOLDER/job --frames FOLDER/frames.txt
    img2webp -loop 0 -d 83 -lossy -q 75 FOLDER/*.png -o turntable.webp

The second command renders the frames as an array of Slurm, and the third, of the package `webp`, makes the animation.
"""
import argparse
import math
import shlex
from pathlib import Path

SCENE = Path(__file__).resolve().parent / "marbles.p3f"
OPTIONS = ["--size", "240x150", "--spp", "96", "--tonemap", "agx", "--exposure", "1.2"]


def scene_from(text, angle):
    """Returns the scene with its camera rotated about the vertical axis by `angle` in radians."""
    lines = text.split("\n")
    for i, line in enumerate(lines):
        if line.startswith("from "):
            x, y, z = map(float, line.split()[1:])
            cosine, sine = math.cos(angle), math.sin(angle)
            lines[i] = f"from {cosine * x - sine * y:.6f} {sine * x + cosine * y:.6f} {z}"
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--frames", type=int, default=36)
    parser.add_argument("options", nargs="*")
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    text = SCENE.read_text()
    commands = []
    for frame in range(arguments.frames):
        scene = folder / f"frame_{frame:03}.p3f"
        scene.write_text(scene_from(text, 2 * math.pi * frame / arguments.frames))
        commands.append(shlex.join([str(scene), *OPTIONS, *arguments.options, "-o", str(scene.with_suffix(".png"))]))
    (folder / "frames.txt").write_text("\n".join(commands) + "\n")


if __name__ == "__main__":
    main()
