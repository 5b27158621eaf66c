"""A correct glTF file that uses most of what the loader reads, small enough to change at every place."""
import base64
import copy
import json
import struct
import zlib

FLOAT, UNSIGNED_BYTE, UNSIGNED_SHORT = 5126, 5121, 5123
GLB_JSON, GLB_BINARY = 0x4E4F534A, 0x004E4942


def png(width, height, pixels=None, bits=8):
    """Returns a PNG file of RGBA pixels; `pixels` (default: all pixels of the size) may be shorter than the size requires."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    rows = b"".join(b"\0" + b"\xff" * (bits // 2 * width) for _ in range(height)) if pixels is None else pixels
    header = struct.pack(">IIBBBBB", width, height, bits, 6, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def data_uri(content, kind="application/octet-stream"):
    return f"data:{kind};base64," + base64.b64encode(content).decode()


class File:
    """`root` is the JSON of the file, `binary` the bytes of buffer 0."""

    def __init__(self):
        self.root = {"asset": {"version": "2.0"}, "accessors": [], "bufferViews": []}
        self.binary = b""

    def view(self, content, **members):
        self.binary += b"\0" * (-len(self.binary) % 4)
        self.root["bufferViews"].append(
            {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(content), **members})
        self.binary += content
        return len(self.root["bufferViews"]) - 1

    def accessor(self, values, component, kind, components, **members):
        letter = {FLOAT: "f", UNSIGNED_BYTE: "B", UNSIGNED_SHORT: "H"}[component]
        view = self.view(struct.pack(f"<{len(values)}{letter}", *values))
        self.root["accessors"].append({"bufferView": view, "componentType": component, "type": kind,
                                       "count": len(values) // components, **members})
        return len(self.root["accessors"]) - 1

    def floats(self, values, kind, components):
        return self.accessor(values, FLOAT, kind, components)

    def text(self):
        root = copy.deepcopy(self.root)
        root["buffers"] = [{"byteLength": len(self.binary), "uri": data_uri(self.binary)}] + root.get("buffers", [])[1:]
        return json.dumps(root, indent=1).encode()

    def glb(self):
        root = {**self.root, "buffers": [{"byteLength": len(self.binary)}]}
        return glb([(GLB_JSON, json.dumps(root).encode()), (GLB_BINARY, self.binary)])


def glb(chunks, version=2, length=None):
    """Returns a GLB container of these chunks; `length` replaces the correct length in the header."""
    body = b"".join(struct.pack("<II", len(content), kind) + content for kind, content in chunks)
    return struct.pack("<4sII", b"glTF", version, 12 + len(body) if length is None else length) + body


def base():
    """A skinned and morphed triangle with a textured material, an instanced one, a light, two cameras, an animation."""
    file = File()
    root = file.root
    attributes = {"POSITION": file.floats([0, 0, 0, 1, 0, 0, 0, 1, 0], "VEC3", 3),
                  "NORMAL": file.floats([0, 0, 1] * 3, "VEC3", 3),
                  "TANGENT": file.floats([1, 0, 0, 1] * 3, "VEC4", 4),
                  "TEXCOORD_0": file.floats([0, 0, 1, 0, 0, 1], "VEC2", 2),
                  "COLOR_0": file.accessor([255] * 12, UNSIGNED_BYTE, "VEC4", 4, normalized=True),
                  "JOINTS_0": file.accessor([0] * 12, UNSIGNED_BYTE, "VEC4", 4),
                  "WEIGHTS_0": file.floats([1, 0, 0, 0] * 3, "VEC4", 4)}
    indices = file.accessor([0, 1, 2], UNSIGNED_SHORT, "SCALAR", 1)
    target = {"POSITION": file.floats([0, 0, 1] * 3, "VEC3", 3)}
    root["meshes"] = [{"primitives": [{"attributes": attributes, "indices": indices, "material": 0,
                                       "targets": [target]}], "weights": [0.5]},
                      {"primitives": [{"attributes": {"POSITION": sparse(file)}, "material": 1}]}]
    root["skins"] = [{"joints": [2], "inverseBindMatrices": file.floats(identity(), "MAT4", 16)}]
    moves = {"TRANSLATION": file.floats([0, 0, 0, 2, 0, 0], "VEC3", 3),
             "ROTATION": file.floats([0, 0, 0, 1] * 2, "VEC4", 4), "SCALE": file.floats([1] * 6, "VEC3", 3)}
    root["nodes"] = [{"mesh": 0, "skin": 0},
                     {"mesh": 1, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": moves}}},
                     {"children": [3], "translation": [0, 0, 0], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1]},
                     {"camera": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1]},
                     {"camera": 1, "translation": [0, 0, 9]},
                     {"extensions": {"KHR_lights_punctual": {"light": 0}}}]
    root["scenes"] = [{"nodes": [0, 1, 2, 4, 5]}]
    root["scene"] = 0
    root["cameras"] = [{"type": "perspective", "perspective": {"yfov": 1, "aspectRatio": 1, "znear": 0.1}},
                       {"type": "orthographic", "orthographic": {"xmag": 2, "ymag": 1, "znear": 0, "zfar": 10}}]
    root["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "spot", "color": [1, 1, 1], "intensity": 5, "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.5}}]}}
    root["extensionsUsed"] = ["KHR_lights_punctual", "EXT_mesh_gpu_instancing", "KHR_texture_transform",
                              "KHR_materials_pbrSpecularGlossiness"]
    root["animations"] = [{"channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}}],
                           "samplers": [{"input": file.floats([0, 1], "SCALAR", 1), "interpolation": "LINEAR",
                                         "output": file.floats([0, 0, 0, 1, 1, 1], "VEC3", 3)}]}]
    add_material(file)
    return file


def identity():
    return [1 if i % 5 == 0 else 0 for i in range(16)]


def sparse(file):
    """An accessor of zeros, of which two elements are replaced."""
    indices = file.view(struct.pack("<2H", 1, 2))
    values = file.view(struct.pack("<6f", 1, 0, 0, 0, 1, 0))
    file.root["accessors"].append(
        {"componentType": FLOAT, "type": "VEC3", "count": 3,
         "sparse": {"count": 2, "indices": {"bufferView": indices, "componentType": UNSIGNED_SHORT},
                    "values": {"bufferView": values}}})
    return len(file.root["accessors"]) - 1


def add_material(file):
    root = file.root
    root["images"] = [{"bufferView": file.view(png(2, 2)), "mimeType": "image/png"},
                      {"uri": data_uri(png(1, 1), "image/png")}]
    root["samplers"] = [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 33071}]
    root["textures"] = [{"source": 0, "sampler": 0}, {"source": 1}]
    transform = {"KHR_texture_transform": {"offset": [0, 0], "rotation": 0, "scale": [1, 1], "texCoord": 0}}
    root["materials"] = [{
        "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1], "metallicFactor": 0.5, "roughnessFactor": 0.5,
                                 "baseColorTexture": {"index": 0, "texCoord": 0, "extensions": transform},
                                 "metallicRoughnessTexture": {"index": 1}},
        "emissiveFactor": [0.5, 0.5, 0.5], "emissiveTexture": {"index": 0}, "alphaMode": "MASK", "alphaCutoff": 0.5,
        "doubleSided": True,
        "extensions": {"KHR_materials_ior": {"ior": 1.4}, "KHR_materials_emissive_strength": {"emissiveStrength": 2},
                       "KHR_materials_specular": {"specularFactor": 1, "specularColorFactor": [1, 1, 1]},
                       "KHR_materials_transmission": {"transmissionFactor": 0.5},
                       "KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 2,
                                                "attenuationColor": [1, 1, 1]},
                       "KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0.1}}},
        {"extensions": {"KHR_materials_pbrSpecularGlossiness": {
            "diffuseFactor": [1, 1, 1, 1], "specularFactor": [0.5, 0.5, 0.5], "glossinessFactor": 0.5,
            "diffuseTexture": {"index": 0, "texCoord": 0, "extensions": transform},
            "specularGlossinessTexture": {"index": 1}}}}]
