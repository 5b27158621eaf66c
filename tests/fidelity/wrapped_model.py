"""A copy of a glTF model with one more camera, for renderers that take cameras from the file."""
import json
import math
import os
import struct
from pathlib import Path
from urllib.parse import quote

GLB_MAGIC, GLB_VERSION = 0x46546C67, 2
CHUNK_JSON, CHUNK_BINARY = 0x4E4F534A, 0x004E4942
CAMERA_NAME = "fidelity"


def camera_matrix(target, orbit):
    """Returns the node matrix (16 numbers, column by column) of a camera on a sphere around `target` that looks at it.

    `theta` is the azimuth from +z towards +x and `phi` the angle from +y, in degrees, as in three.js. The matrix
    exists at the poles and with radius 0, too.
    """
    theta, phi = math.radians(orbit["theta"]), math.radians(orbit["phi"])
    right = (math.cos(theta), 0.0, -math.sin(theta))
    up = (-math.cos(phi) * math.sin(theta), math.sin(phi), -math.cos(phi) * math.cos(theta))
    back = (math.sin(phi) * math.sin(theta), math.cos(phi), math.sin(phi) * math.cos(theta))
    position = [target[axis] + orbit["radius"] * back[i] for i, axis in enumerate("xyz")]
    return [*right, 0.0, *up, 0.0, *back, 0.0, *position, 1.0]


def with_camera(document, scenario):
    """Adds the camera of a scenario to the JSON of a model, at a root node of its scene."""
    width, height = scenario["dimensions"]["width"], scenario["dimensions"]["height"]
    lens = {"yfov": math.radians(scenario["verticalFoV"]), "aspectRatio": width / height, "znear": 1e-3}
    cameras = document.setdefault("cameras", [])
    cameras.append({"type": "perspective", "perspective": lens, "name": CAMERA_NAME})
    nodes = document.setdefault("nodes", [])
    nodes.append({"camera": len(cameras) - 1, "matrix": camera_matrix(scenario["target"], scenario["orbit"])})
    scenes = document.get("scenes")
    if scenes:
        scenes[document.get("scene", 0)].setdefault("nodes", []).append(len(nodes) - 1)
    return len(cameras) - 1


def move_uris(document, prefix):
    """Makes relative URIs of buffers and images valid in another folder, from which `prefix` leads to the model's."""
    for item in [*document.get("buffers", []), *document.get("images", [])]:
        uri = item.get("uri", "")
        if uri and not uri.startswith("data:"):
            item["uri"] = f"{prefix}/{uri}"


def read_chunks(data):
    """Returns the chunks of a GLB file as pairs of type and bytes."""
    chunks, offset = [], 12
    while offset + 8 <= len(data):
        length, kind = struct.unpack_from("<II", data, offset)
        chunks.append((kind, data[offset + 8:offset + 8 + length]))
        offset += 8 + length
    return chunks


def glb_of(document, others):
    """Returns a GLB file with this JSON and these other chunks."""
    text = json.dumps(document).encode()
    body = b""
    for kind, content in [(CHUNK_JSON, text + b" " * (-len(text) % 4)), *others]:
        body += struct.pack("<II", len(content), kind) + content
    return struct.pack("<III", GLB_MAGIC, GLB_VERSION, 12 + len(body)) + body


def wrap(model: Path, scenario, folder: Path):
    """Writes a copy of `model` with the scenario's camera into `folder`. Returns the file and the camera's index."""
    data = model.read_bytes()
    is_glb = data[:4] == b"glTF"
    chunks = read_chunks(data) if is_glb else [(CHUNK_JSON, data)]
    document = json.loads(chunks[0][1])
    camera = with_camera(document, scenario)
    move_uris(document, quote(os.path.relpath(model.parent.resolve(), folder.resolve())))
    copy = folder / model.name
    copy.write_bytes(glb_of(document, chunks[1:]) if is_glb else json.dumps(document).encode())
    return copy, camera
