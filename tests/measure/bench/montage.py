"""Puts pictures of equal size side by side, in rows, into one PNG file of half their size.

    blender -b -noaudio -P tests/measure/bench/montage.py -- OUT.png COLUMNS PICTURE...

Reads Radiance files and Blender's OpenEXR, shown by the sRGB curve, and PNG. Blender is used for its readers; written for Blender 3.4.
"""
import os
import struct
import sys
import zlib

import bpy
import numpy

GAP = 4  # pixels of white between pictures
LEVELS = 52  # of each channel: noise in 256 levels would double the size of the file


def read(path):
    """Values of 0 to 1 as a screen gets them; row 0 is the bottom one."""
    image = bpy.data.images.load(os.path.abspath(path))
    width, height = image.size
    values = numpy.array(image.pixels[:], dtype=numpy.float32).reshape(height, width, -1)[:, :, :3]
    # The mean of blocks of 2 x 2 pixels, of light where the file has light.
    values = values.reshape(height // 2, 2, width // 2, 2, 3).mean(axis=(1, 3))
    if image.is_float:
        values = numpy.where(values <= 0.0031308, 12.92 * values, 1.055 * numpy.maximum(values, 0)**(1 / 2.4) - 0.055)
    return numpy.clip(values, 0, 1)


def write_png(path, values):
    height, width, _ = values.shape
    step = 255 // (LEVELS - 1)
    texels = (numpy.round(values[::-1] * 255 / step) * step).astype(numpy.int16)
    above = numpy.vstack([numpy.zeros_like(texels[:1]), texels[:-1]])
    rows = b"".join(b"\2" + row.astype(numpy.uint8).tobytes() for row in (texels - above) % 256)

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def main():
    output, columns, *paths = sys.argv[sys.argv.index("--") + 1:]
    pictures = [read(path) for path in paths]
    height, width, _ = pictures[0].shape
    columns = int(columns)
    row_count = (len(pictures) + columns - 1) // columns
    sheet = numpy.ones((row_count * (height + GAP) - GAP, columns * (width + GAP) - GAP, 3), dtype=numpy.float32)
    for index, picture in enumerate(pictures):
        top = (row_count - 1 - index // columns) * (height + GAP)  # rows of pictures from above, pixels from below
        left = index % columns * (width + GAP)
        sheet[top:top + height, left:left + width] = picture
    write_png(output, sheet)


main()
