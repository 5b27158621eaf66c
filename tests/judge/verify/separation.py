#!/usr/bin/env python3
"""Measures how close surfaces may be: parallel plates with a gap, closed wedges, and the shadow at the foot of a wall.

    python3 tests/judge/verify/separation.py --program build/release/candela [--icd FILE] [gaps] [wedges] [contact]

Each table has the device and the reference, by `candela compare SCENE`. Without names: all tables.

gaps: two square plates emit 1/2 on their inner sides and reflect 1/2, so that they show 1 everywhere if no ray passes them. The
camera looks through the back of one of them (--one-sided), at most of the other. The table has the smallest gap at which the image
is right to 0.5 %, by bisection in steps of 26 %. The plates are inclined, and their vertices are rounded to single precision.
wedges: closed prisms of albedo 0.95 in a white sky, with the camera inside. The table has the mean of the image, which should be 0.
contact: a floor of albedo 1/2 at the foot of a black wall, both 10 long, in a white sky. The table has the quotient of the image
and the closed form at the distance d from the wall, from d/2 to 3d/2.
"""
import argparse
import itertools
import json
import math
import os
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SIDES = ("device", "reference")
PLATES = ((10, 10), (1, 0), (1000, 0), (100, 10), (10, 1e3))  # size, coordinate
GAPS = [float(f"{10 ** (e / 10):.2g}") for e in range(-80, 0)]  # ten for each power of ten
ANGLES = (5, 11, 20, 45, 90, 135)
DISTANCES = (0, 100, 1000, 10000)
WALL_DISTANCES = (1e-1, 1e-2, 1e-3, 1e-4)
WALL_HEIGHT = 4
WALL_HALF = 5  # half of its length
TOLERANCE = 0.005


def rounded(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def text(point):
    return " ".join(repr(rounded(c)) for c in point)


def view(origin, target, up, angle):
    return f"v\nfrom {text(origin)}\nat {text(target)}\nup {up}\nangle {angle!r}\nhither 0\nresolution 32 32\n"


def polygon(points):
    return f"p {len(points)}\n" + "".join(text(point) + "\n" for point in points)


def plates(size, coordinate, gap):
    """Returns two inclined plates around (coordinate, coordinate, coordinate), whose fronts face each other."""
    a, b = 0.123456789, -0.0456789123  # slopes
    length = math.sqrt(a * a + b * b + 1)
    normal = (-a / length, -b / length, 1 / length)

    def at(x, y, height):
        return tuple(coordinate + c + height * n for c, n in zip((x, y, a * x + b * y), normal))
    half = size / 2
    corners = ((-half, -half), (half, -half), (half, half), (-half, half))
    lower = [at(x, y, 0) for x, y in corners]
    upper = [at(x, y, gap) for x, y in reversed(corners)]
    return ("b 0 0 0\n" + view(at(0.01 * size, 0.02 * size, size), at(0.01 * size, 0.02 * size, 0), "0 1 0", 40) +
            "f .5 .5 .5 1 0 0 0 0 1 0 1 .5 .5 .5\n" + polygon(lower) + polygon(upper))


def wedge(angle, x):
    """Returns a closed prism of length 2, whose sides of length 1 meet at the angle."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    if angle < 90:
        c, s = 1, math.tan(math.radians(angle))  # a right angle at the back
    ends = [[(x, y, 0), (x + 1, y, 0), (x + c, y, s)] for y in (-1, 1)]
    middle = (1 + c) / 2, s / 2
    inside = (x + 0.9 * middle[0], 0, 0.9 * middle[1])
    target = (x + 0.05 * middle[0], 0.05, 0.05 * middle[1])
    faces = ((1, 3, 2), (4, 5, 6), (1, 2, 5), (1, 5, 4), (2, 3, 6), (2, 6, 5), (1, 4, 6), (1, 6, 3))
    return ("b 1 1 1\n" + view(inside, target, "0 1 0", 60) + "f .95 .95 .95 1 0 0 0 0\nmesh 6 8\n" +
            "".join(text(point) + "\n" for point in itertools.chain(*ends)) +
            "".join(" ".join(map(str, face)) + "\n" for face in faces))


def wall(coordinate, distance):
    """Returns a floor at the foot of a black wall."""
    c, half = coordinate, WALL_HALF
    eye = (c + distance, c, c + 5)
    angle = math.degrees(2 * math.atan(0.5 * distance / 5))
    return ("b 1 1 1\n" + view(eye, (c + distance, c, c), "0 1 0", angle) + "f .5 .5 .5 1 0 0 0 0\n" +
            polygon([(c - half, c - half, c), (c + half, c - half, c), (c + half, c + half, c), (c - half, c + half, c)]) +
            "f 0 0 0 1 0 0 0 0\n" +
            polygon([(c, c - half, c), (c, c + half, c), (c, c + half, c + WALL_HEIGHT), (c, c - half, c + WALL_HEIGHT)]))


def shown_before_wall(distance):
    """Returns the albedo times the fraction of the sky's irradiance that a rectangle at a right angle leaves."""
    top = math.hypot(distance, WALL_HEIGHT)
    factor = (math.atan2(WALL_HALF, distance) - distance / top * math.atan2(WALL_HALF, top)) / math.pi
    return 0.5 * (1 - factor)


def means(options, scene, *arguments):
    """Returns the mean of the device's and of the reference's image."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.nff"
        path.write_text(scene, encoding="utf-8")
        environment = {**os.environ, **({"VK_ICD_FILENAMES": options.icd} if options.icd else {})}
        done = subprocess.run([options.program, "compare", str(path), "--size", "32x32", "--spp", str(options.spp), "--quiet",
                               "--json", "-", *arguments], env=environment, capture_output=True, text=True, check=False)
        if not done.stdout:
            sys.exit(done.stderr)
        mean = json.loads(done.stdout)["mean"]
        return [mean[side] for side in SIDES]


def smallest_right(is_right):
    """Returns the smallest gap that is right, of which all larger ones are; None if none is."""
    wrong, right = -1, len(GAPS)
    while right - wrong > 1:
        middle = (wrong + right) // 2
        wrong, right = (wrong, middle) if is_right(middle) else (middle, right)
    return GAPS[right] if right < len(GAPS) else None


def print_gaps(options):
    print("| size of the plates | coordinates | device | reference |\n|---:|---:|---:|---:|")
    for size, coordinate in PLATES:
        found = {}

        def is_right(index, side):
            if index not in found:
                found[index] = means(options, plates(size, coordinate, GAPS[index]), "--one-sided", "--rr-start", "30", "--max-depth", "60")
            return abs(found[index][side] - 1) <= TOLERANCE
        limits = [smallest_right(lambda index, at=side: is_right(index, at)) for side in range(len(SIDES))]
        print(f"| {size:g} | {coordinate:g} | " + " | ".join("none" if x is None else f"{x:g}" for x in limits) + " |", flush=True)


def print_wedges(options):
    print("| angle | " + " | ".join(f"{x:g}, {side}" for x in DISTANCES for side in SIDES) + " |")
    print("|---:|" + "---:|" * 2 * len(DISTANCES))
    for angle in ANGLES:
        found = [mean for x in DISTANCES for mean in means(options, wedge(angle, x))]
        print(f"| {angle} | " + " | ".join(f"{mean:.1g}" if mean else "0" for mean in found) + " |", flush=True)


def print_contact(options):
    print("| coordinates | " + " | ".join(f"d = {d:g}, {side}" for d in WALL_DISTANCES for side in SIDES) + " |")
    print("|---:|" + "---:|" * 2 * len(WALL_DISTANCES))
    for coordinate in (0, 10, 100, 1000):
        cells = []
        for d in WALL_DISTANCES:
            cells += [f"{mean / shown_before_wall(d):.4f}" for mean in means(options, wall(coordinate, d))]
        print(f"| {coordinate} | " + " | ".join(cells) + " |", flush=True)


TABLES = {"gaps": print_gaps, "wedges": print_wedges, "contact": print_contact}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/candela"))
    parser.add_argument("--icd", help="driver file for VK_ICD_FILENAMES")
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("tables", nargs="*", metavar="TABLE", help="gaps, wedges, contact (default: all)")
    options = parser.parse_args()
    for name in options.tables or TABLES:
        TABLES[name](options)
        print()


if __name__ == "__main__":
    main()
