#!/usr/bin/env python3
"""Writes the scenes and the list of frames of a turntable: a camera that circles around the marbles.

    docs/gallery/turntable.py FOLDER [--frames N] [-- OPTIONS OF candela render]

docs/gallery.md has the commands that render the frames as a job array and make an animation of them.
"""
import argparse
import math
import shlex
import sys
from pathlib import Path

SCENE = Path(__file__).resolve().parent / "marbles.p3f"
OPTIONS = ["--size", "240x150", "--spp", "64", "--tonemap", "agx", "--exposure", "1.2"]


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
    words = sys.argv[1:]
    end = words.index("--") if "--" in words else len(words)
    arguments, options = parser.parse_args(words[:end]), words[end + 1:]
    if arguments.frames < 1:
        parser.error("--frames must be at least 1")
    folder = arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    text = SCENE.read_text()
    commands = []
    for frame in range(arguments.frames):
        scene = folder / f"frame_{frame:03}.p3f"
        scene.write_text(scene_from(text, 2 * math.pi * frame / arguments.frames))
        commands.append(shlex.join([str(scene), *OPTIONS, *options, "-o", str(scene.with_suffix(".png"))]))
    (folder / "frames.txt").write_text("\n".join(commands) + "\n")


if __name__ == "__main__":
    main()
