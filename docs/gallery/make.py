#!/usr/bin/env python3
"""Renders the pictures of docs/gallery.md except its animation, and writes the page.

    /usr/bin/python3 docs/gallery/make.py [--program build/release/candela] [--only NAME] [--scale S]

Each picture is one scene and one command, which the page shows with the time, the device and the noise, before and after
denoising. The noise is measured with a second render of another seed, which is not shown. --only renders one picture and
replaces its section. --scale S multiplies the number of samples, for drafts. It needs NumPy and python3-openimageio.
"""
import argparse
import json
import resource
import shlex
import subprocess
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

import numpy
import OpenImageIO

ROOT = Path(__file__).resolve().parents[2]
PICTURES = ROOT / "docs/images/gallery"
PAGE = ROOT / "docs/gallery.md"
AUTOMATIC = ["--exposure", "auto", "--tonemap", "agx"]


@dataclass
class Picture:
    name: str
    title: str
    text: str
    scene: str  # a file of the repository, or the words after `candela generate`
    samples: int
    size: str = "480x320"
    options: list = field(default_factory=list)
    display: list = field(default_factory=lambda: AUTOMATIC)


PICTURES_OF_PAGE = [
    Picture("still_life", "A still life in the afternoon",
            "Metal, coat, glass and textures under a computed sky, which is sampled as a light.",
            "still-life", 256, options=["--env", "sun:18,215,3"]),
    Picture("forest", "A forest in autumn",
            "20,000 trees, instances of five models: 192 million triangles in a file of 9 MB.",
            "forest --size 20000", 64, size="480x270", options=["--env", "sun:24,240,3"]),
    Picture("city", "A city in the afternoon",
            "1,000 buildings with windows, balconies and cornices, instances of five models: 11 million triangles in a file of 5 MB.",
            "city", 96, size="480x270", options=["--env", "sun:22,235,3"]),
    Picture("street", "A street at night",
            "10,000 emissive triangles, signs with emissive textures among them. Lights are chosen by a tree; rendered on an Intel Xeon.",
            "street", 192, size="480x270"),
    Picture("marbles", "Marbles through a wide lens",
            "The thin lens blurs everything that is not at the distance of the large marbles; glass focuses both lights on the floor.",
            "docs/gallery/marbles.p3f", 96, size="480x300"),
    Picture("cornell", "Mirror and glass in a box",
            "The caustic under the glass ball comes from paths that hit the light by BSDF sampling.",
            "cornell", 96, size="320x320", display=["--tonemap", "agx"]),
    Picture("materials", "A table of materials",
            "Six roughnesses from left to right: gold, copper, plastics, rough glass, coats.",
            "material-table --size 48", 48, size="400x480", options=["--env", "sun:40,200,4"]),
    Picture("mitsuba", "Materials of Mitsuba",
            "Rough gold, plastic, rough glass, a blend of plastic and silver, and rougher copper, on plastic with a bump map: a scene file of Mitsuba 3.",
            "docs/gallery/materials_of_mitsuba.xml", 256, size="480x240", display=["--exposure", "-0.4", "--tonemap", "agx"]),
    Picture("brilliants", "Brilliants between lamps",
            "Three stones of a diamond's index of refraction: without dispersion, with that of diamond, with that of rutile.",
            "brilliants", 128, size="480x200", display=["--exposure", "-1", "--tonemap", "agx"]),
    Picture("mountain", "Glass balls on a mountain",
            "131,072 triangles and four dielectric spheres.",
            "mount --size 8", 32, options=["--env", "sun:25,60,3", "--background", "colour"]),
    Picture("terrain", "A million triangles",
            "A height field with the sun near the horizon.",
            "terrain", 16, options=["--env", "sun:12,100,3"]),
    Picture("sphereflake", "A sphereflake",
            "66,430 spheres; light reaches the gaps between them after many reflections.",
            "balls --size 5", 32),
    Picture("tetrahedron", "Sierpinski's tetrahedron", "16,384 triangles that touch only at corners.",
            "tetra --size 7", 24, size="400x400", options=["--env", "sun:30,150,3", "--background", "colour"]),
    Picture("gears", "Gears", "Concave polygons of 144 corners, some of them of glass.",
            "gears", 24),
    Picture("tree", "A tree with seven lights", "Cones and spheres; every light casts a shadow of all branches.",
            "tree --size 13", 24),
    Picture("rings", "Interlocked rings", "Spheres and cylinders, 8,402 primitives.", "rings", 64, size="400x400"),
    Picture("teapot", "Newell's teapot", "Triangles with shading normals, which neither darken nor brighten the picture.",
            "teapot --size 20", 32, options=["--env", "sun:30,60,3", "--background", "colour"]),
]


# tests/farm/test_turntable.py runs these commands.
TURNTABLE = """\
## A turntable

![A turntable](images/gallery/turntable.webp)

The camera circles around the marbles, once in 3 s ([sequences](sequences.md)). `img2webp`, of the package `webp`, makes the animation.

    mkdir turntable
    candela docs/gallery/marbles.p3f --turntable 36 --size 240x150 --spp 64 --tonemap agx --exposure 1.2 -o turntable/frame.##.png
    img2webp -loop 0 -d 83 -lossy -q 75 turntable/*.png -o docs/images/gallery/turntable.webp

Slurm renders the same frames, byte by byte, as a job array ([farm](farm.md)):

    farm/slurm/candela-render --job turntable/job --shards 1 -- docs/gallery/marbles.p3f --turntable 36 --size 240x150 --spp 64 --tonemap agx --exposure 1.2 -o turntable/frame.##.png

16 s on llvmpipe (LLVM 15.0.6, 256 bits), two cores of an AMD EPYC (Zen 4), 64 samples per pixel. Frames are not denoised.
"""


def is_generated(picture):
    return not (ROOT / picture.scene).exists()


def suffix_of(picture):
    return ".gltf" if picture.scene.startswith(("material", "still", "brilliants", "forest", "city", "street")) else ".p3f"


def run(words):
    subprocess.run(words, check=True, cwd=ROOT)


def command_of(picture, scene, samples):
    return [scene, *picture.options, *picture.display, "--size", picture.size, "--spp", str(samples)]


def channels_of(file, names):
    """Returns an array of shape (height, width, len(names))."""
    source = OpenImageIO.ImageBuf(str(file))
    listed = list(source.spec().channelnames)
    pixels = source.get_pixels(OpenImageIO.FLOAT)
    return numpy.stack([pixels[..., listed.index(name)] for name in names], axis=-1)


def luminance_of(file):
    return channels_of(file, ["R", "G", "B"]) @ numpy.array([0.2126, 0.7152, 0.0722])


def noisy_pixels(file):
    """Returns a mask of the pixels whose samples differ. A constant background has the noise of rounding."""
    return channels_of(file, ["variance.Y"])[..., 0] > (0.01 * luminance_of(file)) ** 2


def noise_between(files, noisy):
    """Returns the median standard deviation of a pixel's luminance, relative to it, from two pictures with different seeds."""
    a, b = (luminance_of(file)[noisy] for file in files)
    mean = (a + b) / 2
    # The median magnitude of a normal distribution is 0.6745 times its standard deviation.
    return float(numpy.median(abs(a - b)[mean > 0] / mean[mean > 0])) / (numpy.sqrt(2) * 0.6745)


def processor_seconds():
    """Returns the processor time of the commands so far."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def noise_of(program, words, film, linear, folder):
    """Returns the noise of a picture and of the denoised picture, which a second render with another seed shows."""
    other, other_linear = Path(folder) / "other.film.exr", Path(folder) / "other.exr"
    run([program, *words, "--seed", "1", "--aov", "moments", "--checkpoint", str(other), "-o", str(other_linear), "-q"])
    denoised = []
    for each in (film, other):
        denoised.append(each.with_suffix(".denoised.exr"))
        run([program, "denoise", str(each), "-o", str(denoised[-1]), "-q"])
    other.unlink()
    noisy = noisy_pixels(linear)
    return noise_between([linear, other_linear], noisy), noise_between(denoised, noisy)


def render(picture, program, scale, folder):
    """Renders one picture and its denoised version; returns the lines of the page about it."""
    scene = picture.scene
    lines = [f"## {picture.title}", ""]
    if is_generated(picture):
        scene = str(Path(folder) / (picture.name + suffix_of(picture)))
        run([program, "generate", *picture.scene.split(), "-o", scene, "-q"])
    samples = max(1, round(picture.samples * scale))
    linear, report = Path(folder) / f"{picture.name}.exr", Path(folder) / f"{picture.name}.json"
    words = command_of(picture, scene, samples)
    film = Path(folder) / f"{picture.name}.film.exr"
    start = processor_seconds()
    run([program, *words, "--aov", "moments", "--checkpoint", str(film), "-o", str(PICTURES / f"{picture.name}.png"), "-o",
         str(linear), "--json", str(report), "-q"])
    seconds = processor_seconds() - start
    figures = json.loads(report.read_text())
    images = f"![{picture.title}](images/gallery/{picture.name}.png)"
    run([program, "denoise", str(film), *picture.display, "-o", str(PICTURES / f"{picture.name}_denoised.png"), "-q"])
    images += f" ![{picture.title}, denoised](images/gallery/{picture.name}_denoised.png)"
    lines += [images, "", picture.text, ""]
    shown = picture.name + suffix_of(picture) if is_generated(picture) else picture.scene
    if is_generated(picture):
        lines.append(f"    candela generate {picture.scene} -o {shown}")
    lines += [f"    candela {shlex.join(command_of(picture, shown, samples))} -o {picture.name}.png", ""]
    before, after = noise_of(program, words, film, linear, folder)
    lines += [f"{seconds:.0f} s of processor time on {figures['device']}, {samples} samples per pixel; noise {100 * before:.1f} %. "
              f"On the right, the same samples with `--denoise`: {100 * after:.1f} %.", ""]
    return lines


def sections_of(page):
    """Returns the lines of each section of the page, by its title."""
    sections = {}
    for section in page.split("\n## ")[1:]:
        lines = ("## " + section).split("\n")
        sections[lines[0].removeprefix("## ")] = lines
    return sections


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/candela"))
    parser.add_argument("--only")
    parser.add_argument("--scale", type=float, default=1)
    options = parser.parse_args()
    PICTURES.mkdir(parents=True, exist_ok=True)
    lines = ["# Gallery", "",
             "`docs/gallery/make.py` renders these pictures, except the animation at the end, and writes this page. The noise is the standard deviation of a pixel's",
             "luminance relative to it, from two renders with different seeds: the median over the pixels whose samples differ. Pictures on the right are denoised by",
             "`--denoise`. Their noise does not include what denoising blurs; [denoising](denoising.md) states whole errors. Times are of two cores of an AMD EPYC, and",
             "include reading the scene, building its acceleration structure and writing files.",
             ""]
    sections = sections_of(PAGE.read_text()) if options.only else {}
    with tempfile.TemporaryDirectory() as folder:
        for picture in PICTURES_OF_PAGE:
            if options.only in (None, picture.name):
                sections[picture.title] = render(picture, options.program, options.scale, folder)
    for picture in PICTURES_OF_PAGE:
        lines += sections.get(picture.title, [])
    PAGE.write_text("\n".join([*lines, TURNTABLE]))


if __name__ == "__main__":
    main()
