#!/usr/bin/env python3
"""Writes a GLB with a mesh of about N triangles that has indices, normals, tangents and texture coordinates.

    python3 tests/measure/bench/make_glb.py [--triangles N] [--textured | --coloured] [--instances M] -o FILE.glb

The mesh is a bumpy sphere under a grid of longitudes and latitudes. The same arguments give the same bytes. It is for
measurements of loading and building; see docs/performance.md. --textured adds a normal map, so that the tangents are
read when the picture is rendered; --coloured adds a base colour texture, so that the texture coordinates are.
--instances shows M of them on a square in front of a camera, each of another height.
"""
import argparse
import json
import math
import struct
import sys
import zlib
from array import array

FLOAT, UNSIGNED_INT = 5126, 5125
GLB_JSON, GLB_BINARY = 0x4E4F534A, 0x004E4942
BUMPS, HEIGHT = 9, 0.05


def vertex(u, v):
    """Returns position, normal, tangent and texture coordinates at (u, v) of the unit square."""
    phi, theta = 2 * math.pi * u, math.pi * (0.001 + 0.998 * v)
    radius = 1 + HEIGHT * math.sin(BUMPS * phi) * math.sin(BUMPS * theta)
    s, c, st, ct = math.sin(phi), math.cos(phi), math.sin(theta), math.cos(theta)
    d_phi = HEIGHT * BUMPS * math.cos(BUMPS * phi) * math.sin(BUMPS * theta)
    d_theta = HEIGHT * BUMPS * math.sin(BUMPS * phi) * math.cos(BUMPS * theta)
    direction = (st * c, ct, st * s)
    along_phi = [d_phi * d + radius * t for d, t in zip(direction, (-st * s, 0.0, st * c))]
    along_theta = [d_theta * d + radius * t for d, t in zip(direction, (ct * c, -st, ct * s))]
    normal = (along_phi[1] * along_theta[2] - along_phi[2] * along_theta[1],
              along_phi[2] * along_theta[0] - along_phi[0] * along_theta[2],
              along_phi[0] * along_theta[1] - along_phi[1] * along_theta[0])
    sign = 1 if sum(n * d for n, d in zip(normal, direction)) > 0 else -1
    scale, length = sign / math.hypot(*normal), math.hypot(*along_phi)
    return ([radius * d for d in direction], [scale * n for n in normal], [t / length for t in along_phi] + [1.0],
            [u, v])


def mesh(side):
    """Returns the attributes and indices of a grid of side x side cells as arrays."""
    attributes = [array("f") for _ in range(4)]
    for row in range(side + 1):
        for column in range(side + 1):
            for values, new in zip(attributes, vertex(column / side, row / side)):
                values.extend(new)
    indices = array("I")
    for row in range(side):
        for column in range(side):
            a = row * (side + 1) + column
            b = a + side + 1
            indices.extend((a, a + 1, b, b, a + 1, b + 1))
    return attributes, indices


def flat_normal_map():
    """Returns a PNG file of one texel, the normal itself."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(b"\0\x80\x80\xff")) + chunk(b"IEND", b""))


def places(count):
    """Returns translations and scales of instances, row by row from the front."""
    side = math.isqrt(count - 1) + 1
    translations, scales = array("f"), array("f")
    for i in range(count):
        height = 1 + 0.5 * math.sin(2.4 * i)
        translations.extend((2.4 * (i % side - side / 2 + 0.5), height, -2.4 * (i // side)))
        scales.extend((1, height, 1))
    return translations, scales


def document(side, texture, instances):
    """Returns the JSON and the binary chunk."""
    attributes, indices = mesh(side)
    kinds = (("POSITION", "VEC3", 3), ("NORMAL", "VEC3", 3), ("TANGENT", "VEC4", 4), ("TEXCOORD_0", "VEC2", 2))
    material = {"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.5,
                                         "baseColorFactor": [0.8, 0.6, 0.4, 1]}}
    root = {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "materials": [material],
            "bufferViews": [], "accessors": []}
    parts = []
    for (_, kind, width), values in zip(kinds, attributes):
        root["accessors"].append({"bufferView": len(parts), "componentType": FLOAT, "type": kind,
                                  "count": len(values) // width})
        parts.append(values.tobytes())
    positions = attributes[0]
    root["accessors"][0] |= {"min": [min(positions[i::3]) for i in range(3)],
                             "max": [max(positions[i::3]) for i in range(3)]}
    root["accessors"].append({"bufferView": len(parts), "componentType": UNSIGNED_INT, "type": "SCALAR",
                              "count": len(indices)})
    parts.append(indices.tobytes())
    if instances:
        names = {}
        for name, values in zip(("TRANSLATION", "SCALE"), places(instances)):
            names[name] = len(root["accessors"])
            root["accessors"].append({"bufferView": len(parts), "componentType": FLOAT, "type": "VEC3",
                                      "count": instances})
            parts.append(values.tobytes())
        root["extensionsUsed"] = ["EXT_mesh_gpu_instancing"]
        root["nodes"][0]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": names}}
        root["cameras"] = [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}]
        root["nodes"].append({"camera": 0, "translation": [0, 8, 10], "rotation": [math.sin(-0.15), 0, 0,
                                                                                  math.cos(-0.15)]})
        root["scenes"][0]["nodes"].append(1)
    if texture:
        root["images"] = [{"bufferView": len(parts), "mimeType": "image/png"}]
        root["textures"] = [{"source": 0}]
        owner = material if texture == "normalTexture" else material["pbrMetallicRoughness"]
        owner[texture] = {"index": 0}
        parts.append(flat_normal_map())
    offset = 0
    for i, part in enumerate(parts):
        root["bufferViews"].append({"buffer": 0, "byteOffset": offset, "byteLength": len(part)})
        parts[i] = part + b"\0" * (-len(part) % 4)
        offset += len(parts[i])
    names = {name: i for i, (name, _, _) in enumerate(kinds)}
    root["meshes"] = [{"primitives": [{"attributes": names, "indices": 4, "material": 0}]}]
    root["buffers"] = [{"byteLength": offset}]
    return root, b"".join(parts)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--triangles", type=int, default=1_000_000, metavar="N")
    kinds = parser.add_mutually_exclusive_group()
    kinds.add_argument("--textured", dest="texture", action="store_const", const="normalTexture")
    kinds.add_argument("--coloured", dest="texture", action="store_const", const="baseColorTexture")
    parser.add_argument("--instances", type=int, default=0, metavar="M")
    parser.add_argument("-o", "--output", required=True, metavar="FILE")
    options = parser.parse_args()
    if sys.byteorder != "little":
        sys.exit("this script writes the bytes of its arrays, which must be little-endian")
    root, binary = document(max(1, math.isqrt(options.triangles // 2)), options.texture,
                            options.instances)
    text = json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    with open(options.output, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(binary)))
        file.write(struct.pack("<II", len(text), GLB_JSON) + text)
        file.write(struct.pack("<II", len(binary), GLB_BINARY) + binary)


if __name__ == "__main__":
    main()
