"""Reads pictures of the fidelity comparison and measures their differences. Needs NumPy and Pillow."""
import numpy
from PIL import Image, ImageDraw

BACKDROP = 255  # level of each channel behind pictures with alpha: the page of the comparison is white
COVERED = 0.5  # minimum alpha, in one of two pictures, of a pixel that counts
PROPORTION_TOLERANCE = 0.01  # relative difference of the proportions of pictures that are compared
GAP, LABEL_HEIGHT, SHEET_WIDTH = 4, 14, 320  # pixels between pictures of a sheet, above them, and across each


def read(path):
    """Returns a picture in mode RGBA with straight alpha."""
    with Image.open(path) as image:
        return image.convert("RGBA")


def reduced(image, size):
    return image if image.size == size else image.resize(size, Image.Resampling.LANCZOS)


def on_backdrop(image):
    """Returns the picture over the backdrop in mode RGB."""
    whole = Image.new("RGBA", image.size, (BACKDROP, BACKDROP, BACKDROP, 255))
    whole.alpha_composite(image)
    return whole.convert("RGB")


def levels_and_cover(image):
    """Returns levels of 0 to 1 over the backdrop (height x width x 3), and the alpha (height x width)."""
    alpha = numpy.asarray(image.getchannel("A"), dtype=numpy.float64) / 255
    return numpy.asarray(on_backdrop(image), dtype=numpy.float64) / 255, alpha


def difference(ours, theirs):
    """Returns the mean and the root mean square of ours minus theirs, in per cent of the range of a channel.

    Pixels count that at least one of both pictures covers, all of them in pictures that show their environment. The
    larger picture is reduced to the size of the smaller one. The result is None if nothing is covered, or if the
    pictures have other proportions, as those of scenarios whose size has changed since.
    """
    if abs(ours.width * theirs.height / (ours.height * theirs.width) - 1) > PROPORTION_TOLERANCE:
        return None
    size = min(ours.size, theirs.size)
    (a, cover_a), (b, cover_b) = (levels_and_cover(reduced(image, size)) for image in (ours, theirs))
    counted = numpy.maximum(cover_a, cover_b) >= COVERED
    if not counted.any():
        return None
    delta = (a - b)[counted]
    return 100 * delta.mean(), 100 * numpy.sqrt((delta**2).mean())


def write_sheet(path, pictures):
    """Writes pictures, [(label, picture)], side by side."""
    shown = [(label, on_backdrop(image).resize((SHEET_WIDTH, round(SHEET_WIDTH * image.height / image.width)),
                                               Image.Resampling.LANCZOS)) for label, image in pictures]
    height = max(image.height for _, image in shown) + LABEL_HEIGHT
    sheet = Image.new("RGB", (len(shown) * (SHEET_WIDTH + GAP) - GAP, height), (200, 200, 200))
    draw = ImageDraw.Draw(sheet)
    for index, (label, image) in enumerate(shown):
        left = index * (SHEET_WIDTH + GAP)
        draw.text((left + 2, 1), label, fill=(0, 0, 0))
        sheet.paste(image, (left, LABEL_HEIGHT))
    sheet.save(path)
