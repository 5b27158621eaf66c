"""The scenes that show planted faults to `candela verify`, by the name or the test layer of the fault.

A scene is a path and further options. models/NAME is one of Khronos' sample models of glTF, generated/KIND is written by
`candela generate`, made/FILE is defined here, and all others are files of the project.
"""
import base64
import struct

LOBES = ["cornell.p3f", "balls.p3f", "primitives.p3f", "smallpt.p3f", "depth_of_field.p3f", "lamp_over_plane.p3f", "sky.p3f",
         "point_light.p3f"]
DATABASES = ["balls_2", "teapot_2", "mount_3", "gears_1", "tree_3", "lattice_2"]
SKY = ["--env", "sun:40,60,3"]
GENERATED = ["material-table", "brushed-table", "still-life"]


def nff(names):
    return [(f"scenes/{name}", []) for name in names]


def models(*names):
    return [(f"models/{name}", SKY) for name in names]


def generated(*kinds):
    return [(f"generated/{kind}", SKY) for kind in kinds]


SURFACES = generated(*GENERATED) + models("ToyCar", "ClearCoatTest", "AttenuationTest", "SunglassesKhronos", "SpecularTest")
TEXTURES = models("TextureTransformTest", "MultiUVTest", "AlphaBlendModeTest", "VertexColorTest", "ToyCar", "ClearCoatTest",
                  "SunglassesKhronos")
LAMPS = [("made/lamps.gltf", [])]
# Scenes by the beginning of a fault's name, or else by its first layer. Faults of other layers do not change the light of
# the default kernel.
SCENES_BY_NAME = {"textures: ": TEXTURES, "spot lights": LAMPS, "directional lights": LAMPS}
SCENES = {
    **dict.fromkeys(("equivalence", "flatten", "reference", "verify", "leaf"), nff(LOBES)),
    **dict.fromkeys(("structures", "structure", "amplified"), [(f"tests/formats/nff/spd/{name}.nff", []) for name in DATABASES]),
    "undecidable": [("tests/judge/verify/mirror_cell.p3f", [])],
    "touching": [("made/touching.p3f", []), ("scenes/cornell.p3f", [])],
    "punctual": LAMPS,
    "lamps proof": LAMPS,
    **dict.fromkeys(("environment proof", "environment reference", "environment pixels"),
                    [("scenes/balls.p3f", SKY), ("scenes/primitives.p3f", SKY), *generated("material-table")]),
    "surfaces": SURFACES, "surfaces of the reference": SURFACES, "volumes": SURFACES,
    "textures": TEXTURES, "opacity": TEXTURES, "normal maps": TEXTURES[2:],
    "anisotropy": [*generated("brushed-table"), *models("AnisotropyStrengthTest")],
    "anisotropic energy": [*generated("brushed-table"), *models("AnisotropyStrengthTest")],
}
# A room whose walls, a box, a sphere and a cone are touched by point lights.
TOUCHING = """v
from 0 -3.5 1.5
at 0 0 1
up 0 0 1
angle 70
hither 0
resolution 64 64
f .7 .7 .7 1  0 0 0 0 1 0 1  0 0 0
box -4 -4 0 4 4 4
box -1 0 0 0 1 1
s 1.5 .5 .5 .5
c -2.5 0 0 .5 -2.5 0 1 .2
l 0 -4 2 .03 .03 .03
l -.5 .5 1 .03 .03 .03
l 1.5 .5 1 .03 .03 .03
l 4 4 4 .03 .03 .03
f 0 0 0 1  0 0 0 0 1 0 1  .9 .9 .9
p 4
-1 3 4
1 3 4
1 2 4
-1 2 4
"""


def lamps():
    """Returns a glTF file with two spot lights, two point lights and a directional light over a floor."""
    corners = [(-4, 0, -4), (4, 0, -4), (4, 0, 4), (-4, 0, 4)]
    data = b"".join(struct.pack("<3f", *corner) for corner in corners) + struct.pack("<6H", 0, 2, 1, 0, 3, 2)
    spot = {"type": "spot", "intensity": 40, "spot": {"innerConeAngle": 0.3, "outerConeAngle": 0.7}}
    wide = {"type": "spot", "intensity": 20, "color": [1, 0.5, 0.3], "spot": {"innerConeAngle": 0.1, "outerConeAngle": 1.1}}
    down = [-0.7071068, 0, 0, 0.7071068]
    places = [(-1.5, 2.5, 0), (1.5, 2, 1), (0, 1, -2), (2.5, 0.7, -1)]
    lights = [spot, wide, {"type": "point", "intensity": 10}, {"type": "point", "intensity": 5, "color": [0.3, 0.6, 1]},
              {"type": "directional", "intensity": 1}]
    nodes = [{"mesh": 0}, {"camera": 0, "translation": [0, 4, 6], "rotation": [-0.3007058, 0, 0, 0.953717]}]
    for index in range(len(lights)):
        place = {"translation": list(places[index])} if index < len(places) else {}
        nodes.append({"rotation": down, "extensions": {"KHR_lights_punctual": {"light": index}}, **place})
    return {
        "asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"], "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
        "extensions": {"KHR_lights_punctual": {"lights": lights}},
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.9, "znear": 0.1}}],
        "materials": [{"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.6}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-4, 0, -4], "max": [4, 0, 4]},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}


def scenes_of(mutant):
    """Returns the scenes for a fault, as pairs of path and options."""
    named = (scenes for beginning, scenes in SCENES_BY_NAME.items() if mutant["name"].startswith(beginning))
    return next(named, SCENES[mutant["layers"][0]])
