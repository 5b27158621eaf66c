#!/usr/bin/env python3
"""Writes ten small glTF scenes, and the environment of eight of them, for comparisons with other renderers.

    python3 tests/measure/bench/gltf_scenes.py FOLDER [--furnace]

With --furnace, it writes single balls in a white environment instead, which show the albedos of their materials.
Each scene has a camera, and materials that Blender's importer and Principled BSDF know. `asset.extras.environment`
names the equirectangular image that lights a scene; without it, the scene has lights of its own. The same version of
this program always writes the same files. docs/gltf.md shows the pictures.
"""
import argparse
import json
import math
from pathlib import Path

from gltf_writer import Scene, environment, floor, panel, sphere, texture

SKY, WHITE = "sky.hdr", "white.hdr"
GREY = {"baseColorFactor": [0.5, 0.5, 0.5, 1], "metallicFactor": 0, "roughnessFactor": 1}


def surface(colour, metallic, roughness, **extensions):
    """A material; `extensions` are named without KHR_materials_."""
    material = {"pbrMetallicRoughness": {"baseColorFactor": [*colour, 1], "metallicFactor": metallic,
                                         "roughnessFactor": roughness}}
    if extensions:
        material["extensions"] = {"KHR_materials_" + name: value for name, value in extensions.items()}
    return material


def glass(roughness):
    return surface([1, 1, 1], 0, roughness, transmission={"transmissionFactor": 1}, volume={"thicknessFactor": 1},
                   ior={"ior": 1.5})


def row(scene, materials):
    """Balls of radius 0.5 side by side on the floor."""
    for index, material in enumerate(materials):
        scene.add(sphere(0.5), material, [1.1 * (index - (len(materials) - 1) / 2), 0.5, 0])


def on_floor(sky=SKY, material=None, size=12):
    scene = Scene(eye=[0, 2.6, 4.4], target=[0, 0.35, 0], yfov=0.6, sky=sky)
    scene.add(floor(size), material or {"pbrMetallicRoughness": GREY})
    return scene


def metal():
    scene = on_floor()
    gold = [1, 0.77, 0.34]
    row(scene, [surface(gold, 1, 0.1), surface(gold, 1, 0.5), surface([0.9, 0.9, 0.9], 1, 1)])
    return scene


def dielectric():
    scene = on_floor()
    row(scene, [surface([0.7, 0.1, 0.1], 0, roughness) for roughness in (0.1, 0.5, 1)])
    return scene


def clearcoat():
    scene = on_floor()
    row(scene, [surface([0.6, 0.05, 0.05], 0, 0.8, clearcoat={"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0.05}),
                surface([0.9, 0.6, 0.3], 1, 0.5, clearcoat={"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0.3}),
                surface([0.05, 0.2, 0.5], 0, 0.8, clearcoat={"clearcoatFactor": 0.5, "clearcoatRoughnessFactor": 0.1})])
    return scene


def glasses():
    scene = on_floor()
    row(scene, [glass(roughness) for roughness in (0, 0.3, 0.6)])
    return scene


def textured():
    """A colour texture, and one of metalness (blue) and roughness (green)."""
    scene = on_floor()
    colours = scene.texture(texture(256, lambda u, v: checks(u, v, [0.8, 0.35, 0.1], [0.15, 0.3, 0.6])))
    rough = scene.texture(texture(256, lambda u, v: [0, 0.3 + 0.5 * wave(2 * u), wave(4 * v)]))
    material = {"pbrMetallicRoughness": {"baseColorTexture": {"index": colours}, "metallicRoughnessTexture": {"index": rough}}}
    row(scene, [material] * 3)
    return scene


def normal_map():
    scene = on_floor()
    bumps = scene.texture(texture(256, bump))
    for material in (surface([0.6, 0.6, 0.6], 0, 0.6), surface([0.9, 0.9, 0.9], 1, 0.3)):
        material["normalTexture"] = {"index": bumps}
        scene.add(sphere(0.7), material, [0.85 if material["pbrMetallicRoughness"]["metallicFactor"] else -0.85, 0.7, 0])
    return scene


def emission():
    """A screen that is the only light."""
    scene = on_floor(sky=None)
    screen = scene.texture(texture(256, lambda u, v: checks(u, v, [1, 0.6, 0.25], [0.1, 0.3, 0.8])))
    scene.add(panel(3, 1.5), {"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0, "roughnessFactor": 1},
                              "emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": screen},
                              "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 5}}}, [0, 1.2, -1.5])
    row(scene, [surface([0.7, 0.7, 0.7], 0, 0.5), surface([0.9, 0.9, 0.9], 1, 0.3)])
    return scene


def opacity():
    """A mask, and a half-transparent panel, before balls and a sun."""
    scene = on_floor()
    holes = scene.texture(texture(256, lambda u, v: [0.2, 0.5, 0.2, 1 if dots(u, v) > 0 else 0]))
    veil = scene.texture(texture(256, lambda u, v: [0.7, 0.5, 0.1, 0.1 + 0.8 * wave(3 * u) * wave(3 * v)]))
    row(scene, [surface([0.7, 0.7, 0.7], 0, 0.7)] * 2)
    base = {"metallicFactor": 0, "roughnessFactor": 0.8}
    scene.add(panel(1.1, 1.1), {"pbrMetallicRoughness": base | {"baseColorTexture": {"index": holes}}, "alphaMode": "MASK",
                                "doubleSided": True}, [-0.7, 0.6, 0.8])
    scene.add(panel(1.1, 1.1), {"pbrMetallicRoughness": base | {"baseColorTexture": {"index": veil}}, "alphaMode": "BLEND",
                                "doubleSided": True}, [0.7, 0.6, 0.8])
    scene.light("sun", {"type": "directional", "intensity": 2}, [1, 2, 1.5])
    return scene


def lamps():
    """A spot light and a point light, without an environment."""
    scene = on_floor(sky=None)
    row(scene, [surface([0.7, 0.7, 0.7], 0, 0.6), surface([0.9, 0.7, 0.4], 1, 0.4)])
    scene.light("spot", {"type": "spot", "intensity": 40, "color": [1, 0.85, 0.6],
                         "spot": {"innerConeAngle": 0.15, "outerConeAngle": 0.4}}, [-2, 3, 2])
    scene.light("point", {"type": "point", "intensity": 3, "color": [0.5, 0.7, 1]}, [1.5, 1.5, 0.8])
    return scene


def sun_and_sky():
    """The view shows the horizon, so that a turned or mirrored environment would be seen."""
    scene = Scene(eye=[0, 0.9, 4.4], target=[0, 0.6, 0], yfov=0.6, sky=SKY)
    scene.add(floor(12), {"pbrMetallicRoughness": GREY})
    row(scene, [surface([1, 1, 1], 1, 0), surface([0.2, 0.5, 0.2], 0, 0.3), surface([0.9, 0.7, 0.4], 1, 0.3)])
    scene.light("sun", {"type": "directional", "intensity": 2.5, "color": [1, 0.9, 0.75]}, [2, 1.5, 1])
    return scene


def ball(material, normal_map=None):
    """It touches the edges of the picture, so that it covers pi/4 of it."""
    sine = 0.5 / 20
    scene = Scene(eye=[0, 0, 20], target=[0, 0, 0], yfov=2 * math.asin(sine), sky=WHITE)
    if normal_map:
        material["normalTexture"] = {"index": scene.texture(texture(256, normal_map))}
    scene.add(sphere(0.5), material)
    return scene


def furnace():
    scenes = {f"dielectric-{colour}-{roughness}": ball(surface([colour] * 3, 0, roughness))
              for colour, roughness in ((1, 1), (1, 0.1), (0.5, 1), (0, 1), (0, 0.5))}
    scenes |= {f"metal-{colour}-{roughness}": ball(surface([colour] * 3, 1, roughness))
               for colour, roughness in ((1, 1), (0.9, 1), (0.5, 1), (0.5, 0.5))}
    scenes |= {f"glass-{roughness}": ball(glass(roughness)) for roughness in (0, 0.3, 0.6)}
    scenes["clearcoat-on-black"] = ball(surface([0, 0, 0], 1, 1, clearcoat={"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0.1}))
    scenes["bumps-on-metal-1-0.3"] = ball(surface([1, 1, 1], 1, 0.3), bump)
    scenes["bumps-on-dielectric-1-0.6"] = ball(surface([1, 1, 1], 0, 0.6), bump)
    return scenes


def wave(t):
    return 0.5 - 0.5 * math.cos(2 * math.pi * t)


def checks(u, v, first, second):
    """Without edges, because programs differ in whether they interpolate before or after decoding sRGB."""
    t = 0.5 + 0.5 * math.sin(16 * math.pi * u) * math.sin(8 * math.pi * v)
    return [a + (b - a) * t for a, b in zip(first, second)]


def dots(u, v):
    return math.hypot((u * 6) % 1 - 0.5, (v * 6) % 1 - 0.5) - 0.3


def bump(u, v):
    """The normal of sin waves whose slope is at most 0.5, encoded."""
    x, y = 0.5 * math.sin(2 * math.pi * 12 * u), 0.5 * math.sin(2 * math.pi * 6 * v)
    return [0.5 + 0.5 * c / math.hypot(x, y, 1) for c in (x, y, 1)]


def sky(x, y, z):
    """Radiance from a direction in glTF's axes, different in each of the six axes: no symmetry hides a turned map."""
    level = 0.25 + 0.35 * max(y, 0)
    light = [level * (1 + 0.3 * x), level, level * (1.3 - 0.3 * z)]
    for direction, width, colour in (((0.75, 0.45, 0.48), 60, [12, 10, 7]), ((-0.8, 0.55, -0.24), 25, [1, 2, 4])):
        lobe = math.exp(width * (x * direction[0] + y * direction[1] + z * direction[2] - 1))
        light = [a + lobe * b for a, b in zip(light, colour)]
    return light


SCENES = {"metal": metal, "dielectric": dielectric, "clearcoat": clearcoat, "glass": glasses, "textures": textured,
          "normal-map": normal_map, "emissive-texture": emission, "alpha": opacity, "spot-and-point": lamps,
          "sun-and-sky": sun_and_sky}


def main():
    parser = argparse.ArgumentParser(prog="gltf_scenes.py")
    parser.add_argument("folder", type=Path, help="where the files are written; made if it does not exist")
    parser.add_argument("--furnace", action="store_true", help="single balls in a white environment")
    options = parser.parse_args()
    folder = options.folder
    folder.mkdir(parents=True, exist_ok=True)
    if options.furnace:
        (folder / WHITE).write_bytes(environment(16, 8, lambda x, y, z: [1, 1, 1]))
    else:
        (folder / SKY).write_bytes(environment(256, 128, sky))
    scenes = furnace() if options.furnace else {name: build() for name, build in SCENES.items()}
    for name, scene in scenes.items():
        (folder / f"{name}.gltf").write_text(json.dumps(scene.document()))


if __name__ == "__main__":
    main()
