#!/usr/bin/env python3
"""Writes the six faces of this sky box: a clear evening over water, the same on both sides of every seam."""
import math
import pathlib
import struct
import zlib

SIDE = 64
# Direction through (sc, tc) of each face, as docs/light-transport.md (section 7) defines the lookup.
FACES = {
    "right": lambda s, t: (1, t, -s), "left": lambda s, t: (-1, t, s),
    "top": lambda s, t: (-s, 1, -t), "bottom": lambda s, t: (-s, -1, t),
    "front": lambda s, t: (-s, t, 1), "back": lambda s, t: (s, t, -1),
}
SUN = (0.48, 0.36, 0.8)


def mix(a, b, w):
    return tuple(x + (y - x) * w for x, y in zip(a, b))


def colour(direction):
    """sRGB in [0, 1]."""
    length = math.sqrt(sum(x * x for x in direction))
    x, y, z = (c / length for c in direction)
    if y < 0:
        ripple = 0.03 * math.sin(40 * x / (0.05 - y)) * math.sin(40 * z / (0.05 - y)) * min(1, -4 * y)
        return mix((0.62, 0.58, 0.55), (0.08 + ripple, 0.2 + ripple, 0.3 + ripple), min(1, -y) ** 0.4)
    sky = mix((0.98, 0.83, 0.66), (0.2, 0.42, 0.78), y ** 0.45)
    towards_sun = max(0, sum(a * b for a, b in zip((x, y, z), SUN)) / math.sqrt(sum(c * c for c in SUN)))
    return mix(sky, (1, 0.98, 0.9), min(1, 0.5 * towards_sun ** 20 + 4 * towards_sun ** 600))


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write_png(path, pixels):
    rows = b"".join(b"\0" + bytes(round(255 * min(1, max(0, c))) for rgb in row for c in rgb) for row in pixels)
    header = struct.pack(">IIBBBBB", SIDE, SIDE, 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) +
                     chunk(b"IEND", b""))


for name, direction in FACES.items():
    centres = [(2 * i + 1) / SIDE - 1 for i in range(SIDE)]
    write_png(pathlib.Path(__file__).parent / f"{name}.png",
              [[colour(direction(s, -t)) for s in centres] for t in centres])
