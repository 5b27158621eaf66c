"""Malformed glTF files: changes to the base file, each with the place where the error must be reported.

Most are made by rules that apply to every place of a kind, the others are written by hand. A place is a JSON pointer, or
"line" where the JSON cannot be parsed, or "GLB" for the container.
"""
import copy
import json
import re
import struct
from dataclasses import dataclass

from base_file import FLOAT, GLB_BINARY, GLB_JSON, base, data_uri, glb, png


@dataclass
class Case:
    name: str
    content: bytes
    place: str
    suffix: str = ".gltf"


MEMBERS = re.compile(r"^(/animations/0/samplers/0/interpolation|.*/(name|mimeType|minFilter|znear|zfar|extensionsUsed))$")
INDICES = ("mesh", "skin", "camera", "light", "material", "indices", "POSITION", "NORMAL", "TANGENT", "TEXCOORD_0",
           "COLOR_0", "JOINTS_0", "WEIGHTS_0", "inverseBindMatrices", "TRANSLATION", "ROTATION", "SCALE", "bufferView",
           "buffer", "source", "sampler", "index", "input", "output", "node", "scene")
SIZES = ("count", "byteLength", "byteOffset")


def places(value, pointer=""):
    """Yields the JSON pointer, the key and the value of every place of a document."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        place = f"{pointer}/{key}"
        yield place, key, item
        yield from places(item, place)


def parent_of(root, pointer):
    *path, last = pointer.split("/")[1:]
    for key in path:
        root = root[int(key) if isinstance(root, list) else key]
    return root, int(last) if isinstance(root, list) else last


def seeing(pointer):
    """Returns the base file. Only the first camera is read, which is the one that the place belongs to."""
    file = base()
    if pointer.startswith("/cameras/1"):
        file.root["nodes"][3]["camera"] = 1
    return file


def changed(pointer, value):
    """Returns the base file with another value at a place."""
    file = seeing(pointer)
    parent, key = parent_of(file.root, pointer)
    parent[key] = value
    return file


def without(pointer):
    file = seeing(pointer)
    parent, key = parent_of(file.root, pointer)
    del parent[key]
    return file


def is_index(pointer, key):
    return key in INDICES or re.search(r"/(children|joints|scenes/0/nodes)/\d+$", pointer) is not None


def of_indices(root):
    """Every index: beyond the end, negative, with a fraction, of another type, 2^31."""
    for pointer, key, value in places(root):
        if not isinstance(value, int) or isinstance(value, bool) or not is_index(pointer, key):
            continue
        for label, bad in (("beyond", 999), ("negative", -1), ("fraction", 0.5), ("text", "0"), ("2-31", 2 ** 31)):
            yield Case(f"index-{label}{pointer}", changed(pointer, bad).text(), pointer)


def of_numbers(root):
    """Every number of a vector or factor: text, null, too large for binary32."""
    for pointer, key, value in places(root):
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if not is_number or is_index(pointer, key) or key in SIZES or MEMBERS.match(pointer):
            continue
        for label, bad in (("text", "1"), ("null", None), ("huge", 1e300)):
            yield Case(f"number-{label}{pointer}", changed(pointer, bad).text(), pointer)


def of_containers(root):
    """Every array that is an object instead, and every object that is an array."""
    for pointer, _, value in places(root):
        if isinstance(value, (dict, list)) and not MEMBERS.match(pointer) and not pointer.endswith("/spot"):
            yield Case(f"container{pointer}", changed(pointer, [7] if isinstance(value, dict) else {"a": 7}).text(),
                       pointer)


REQUIRED = ("/asset", "/asset/version", "/accessors/0/count", "/accessors/0/type", "/accessors/0/componentType",
            "/bufferViews/0/buffer", "/bufferViews/0/byteLength", "/meshes/0/primitives",
            "/meshes/0/primitives/0/attributes", "/skins/0/joints", "/cameras/0/type", "/cameras/0/perspective",
            "/cameras/0/perspective/yfov", "/cameras/1/orthographic", "/cameras/1/orthographic/xmag",
            "/cameras/1/orthographic/ymag", "/extensions/KHR_lights_punctual/lights",
            "/extensions/KHR_lights_punctual/lights/0/type", "/extensions/KHR_lights_punctual/lights/0/spot",
            "/images/0/bufferView", "/materials/0/pbrMetallicRoughness/baseColorTexture/index",
            "/nodes/1/extensions/EXT_mesh_gpu_instancing/attributes", "/nodes/5/extensions/KHR_lights_punctual/light",
            "/animations/0/channels", "/animations/0/samplers", "/animations/0/channels/0/sampler",
            "/animations/0/channels/0/target", "/animations/0/channels/0/target/path",
            "/animations/0/samplers/0/input", "/animations/0/samplers/0/output", "/accessors/9/sparse/count",
            "/accessors/9/sparse/indices", "/accessors/9/sparse/values",
            "/accessors/9/sparse/indices/bufferView", "/accessors/9/sparse/indices/componentType",
            "/accessors/9/sparse/values/bufferView")


def of_required():
    for pointer in REQUIRED:
        yield Case(f"missing{pointer}", without(pointer).text(), pointer.rpartition("/")[0] or "the root")


# Value at a pointer, and the place of the report where it is another one.
BY_HAND = (
    ("/asset/version", "1.0", None), ("/asset/version", 2, None), ("/asset/minVersion", "2.9", None),
    ("/extensionsRequired", ["EXT_unknown"], "/extensionsRequired/0"), ("/extensionsRequired", [3], "/extensionsRequired/0"),
    ("/accessors/0/count", 2 ** 31, "/accessors/0"), ("/accessors/0/count", 2 ** 52, None),
    ("/accessors/0/count", 0, None), ("/accessors/0/count", -3, None), ("/accessors/0/count", 2.5, None),
    ("/accessors/0/count", 4, "/accessors/0"), ("/accessors/0/byteOffset", 2 ** 53, "/accessors/0"),
    ("/accessors/0/byteOffset", -4, None), ("/accessors/0/componentType", 5124, None),
    ("/accessors/0/type", "VEC5", None), ("/accessors/0/type", "VEC2", "/meshes/0/primitives/0/attributes/POSITION"),
    ("/accessors/0/normalized", True, None), ("/accessors/0/normalized", 1, None),
    ("/bufferViews/0/byteLength", 0, None), ("/bufferViews/0/byteLength", 2 ** 53, "/bufferViews/0"),
    ("/bufferViews/0/byteOffset", 2 ** 53, "/bufferViews/0"), ("/bufferViews/0/byteOffset", 2 ** 31, "/bufferViews/0"),
    ("/bufferViews/0/byteLength", 35, "/accessors/0"), ("/bufferViews/0/byteStride", 8, "/accessors/0"),
    ("/bufferViews/0/byteStride", 3, None), ("/bufferViews/0/byteStride", 256, None),
    ("/bufferViews/0/byteStride", 24, "/accessors/0"),
    ("/accessors/9/sparse/count", 0, None), ("/accessors/9/sparse/count", 4, None),
    ("/accessors/9/sparse/count", 2 ** 31, None), ("/accessors/9/sparse/count", 3, "/accessors/9/sparse/indices"),
    ("/accessors/9/sparse/indices/componentType", FLOAT, "/accessors/9/sparse/indices"),
    ("/accessors/9/sparse/indices/byteOffset", 3, "/accessors/9/sparse/indices"),
    ("/accessors/9/sparse/values/byteOffset", 2 ** 52, "/accessors/9/sparse/values"),
    ("/accessors/9/count", 2 ** 25, None), ("/accessors/9/count", 2, "/accessors/9/sparse/indices"),
    ("/meshes/0/primitives/0/mode", 7, None), ("/meshes/0/primitives/0/mode", -1, None),
    ("/meshes/0/primitives/0/indices", 0, None), ("/meshes/0/primitives/0/attributes/NORMAL", 3, None),
    ("/meshes/0/primitives/0/attributes/JOINTS_0", 0, None), ("/accessors/1/count", 2,
                                                              "/meshes/0/primitives/0/attributes/NORMAL"),
    ("/accessors/8/count", 1, "/meshes/0/primitives/0/targets/0/POSITION"), ("/meshes/0/weights", ["1"],
                                                                              "/meshes/0/weights/0"),
    ("/nodes/2/children", [2], "/nodes/2"), ("/nodes/3/children", [2], "/nodes/2"),
    ("/nodes/2/children", [3, 3], "/nodes/2/children/1"), ("/nodes/4/children", [3], "/nodes/4/children/0"),
    ("/nodes/2/rotation", [0, 0, 1], None), ("/nodes/2/translation", [0, 0, 0, 0], None),
    ("/nodes/3/matrix", [1, 2, 3], None), ("/nodes/3/matrix", [1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], None),
    ("/nodes/2/scale", [1, 1], None), ("/nodes/4/scale", [1, 1, "1"], "/nodes/4/scale/2"),
    ("/scenes/0/nodes", [0, 0], "/scenes/0/nodes/1"), ("/scenes/0/nodes", [3], "/scenes/0/nodes/0"),
    ("/skins/0/joints", [], "/meshes/0/primitives/0"), ("/skins/0/inverseBindMatrices", 0, None),
    ("/skins/0/joints", [2, 3], "/skins/0/inverseBindMatrices"),
    ("/nodes/1/extensions/EXT_mesh_gpu_instancing/attributes/SCALE", 0,
     "/nodes/1/extensions/EXT_mesh_gpu_instancing/attributes"),
    ("/cameras/1/orthographic/xmag", 0, None), ("/cameras/1/orthographic/ymag", 1e-60, None),
    ("/cameras/0/type", "fisheye", None), ("/cameras/0/perspective/yfov", 0, None),
    ("/cameras/0/perspective/yfov", 3.2, None), ("/cameras/0/perspective/aspectRatio", -1, None),
    ("/extensions/KHR_lights_punctual/lights/0/type", "area", None),
    ("/extensions/KHR_lights_punctual/lights/0/intensity", -1, "/extensions/KHR_lights_punctual/lights/0"),
    ("/extensions/KHR_lights_punctual/lights/0/color", [-1, 0, 0], "/extensions/KHR_lights_punctual/lights/0"),
    ("/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", 1.6,
     "/extensions/KHR_lights_punctual/lights/0/spot"),
    ("/extensions", {}, "the root"),
    ("/animations/0/channels/0/target/path", "colour", None),
    ("/animations/0/samplers/0/interpolation", "CUBIC", None),
    ("/animations/0/samplers/0/interpolation", "CUBICSPLINE", "/animations/0/samplers/0/output"),
    ("/animations/0/samplers/0/output", 1, None), ("/animations/0/channels/0/target/node", 3, "/nodes/3/matrix"),
    ("/samplers/0/magFilter", 9984, None), ("/samplers/0/wrapS", 1, None), ("/samplers/0/wrapT", 33070, None),
    ("/materials/0/pbrMetallicRoughness/baseColorFactor", [1, 1, 1], None),
    ("/materials/0/pbrMetallicRoughness/baseColorFactor", [1, 1, 1, 1.5], None),
    ("/materials/0/pbrMetallicRoughness/metallicFactor", -0.1, None),
    ("/materials/0/pbrMetallicRoughness/roughnessFactor", 2, None),
    ("/materials/0/emissiveFactor", [0, -2, 0], None), ("/materials/0/alphaMode", "GLOW", None),
    ("/materials/0/alphaMode", 1, None), ("/materials/0/alphaMode", "x" + "\u00e9" * 99, None),
    ("/extensionsRequired", ["\u4e00" * 99], "/extensionsRequired/0"), ("/cameras/0/type", "\U0001f4f7" * 99, None), ("/materials/0/alphaCutoff", -1, None),
    ("/materials/0/doubleSided", "yes", None), ("/materials/0/extensions/KHR_materials_ior/ior", 0.5, None),
    ("/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength", -2, None),
    ("/materials/0/extensions/KHR_materials_specular/specularFactor", 2, None),
    ("/materials/0/extensions/KHR_materials_specular/specularColorFactor", [1, -1, 1], None),
    ("/materials/0/extensions/KHR_materials_transmission/transmissionFactor", -1, None),
    ("/materials/0/extensions/KHR_materials_volume/thicknessFactor", -1, None),
    ("/materials/0/extensions/KHR_materials_volume/attenuationDistance", 0, None),
    ("/materials/0/extensions/KHR_materials_clearcoat/clearcoatFactor", 1.1, None))


def of_values():
    for number, (pointer, value, place) in enumerate(BY_HAND):
        yield Case(f"value-{number}{pointer}", changed(pointer, value).text(), place or pointer)


def of_bytes():
    """Values in the buffer: not finite, an index beyond the vertices, a joint beyond the skin."""
    def poked(view, offset, content):
        file = base()
        at = file.root["bufferViews"][view]["byteOffset"] + offset
        file.binary = file.binary[:at] + content + file.binary[at + len(content):]
        return file.text()
    for accessor, label in ((0, "positions"), (1, "normals"), (2, "tangents"), (3, "coordinates"), (6, "weights")):
        for name, value in (("nan", float("nan")), ("infinity", float("-inf"))):
            yield Case(f"bytes-{name}-{label}", poked(accessor, 4, struct.pack("<f", value)), f"/accessors/{accessor}")
    yield Case("bytes-index", poked(7, 2, struct.pack("<H", 3)), "/meshes/0/primitives/0/indices")
    yield Case("bytes-joint", poked(5, 0, b"\x09"), "/meshes/0/primitives/0")
    yield Case("bytes-sparse-order", poked(9, 0, struct.pack("<2H", 2, 1)), "/accessors/9/sparse/indices")
    yield Case("bytes-sparse-index", poked(9, 0, struct.pack("<2H", 1, 3)), "/accessors/9/sparse/indices")
    yield Case("bytes-nan-sparse", poked(10, 0, struct.pack("<f", float("nan"))), "/accessors/9")
    file = base()
    file.root["nodes"][1]["scale"] = [3e38, 3e38, 3e38]
    file.root["nodes"][2].update({"scale": [3e38, 3e38, 3e38], "children": [3, 1]})
    file.root["scenes"][0]["nodes"] = [0, 2, 4, 5]
    yield Case("bytes-beyond-range", file.text(), "/nodes/1")


def of_images():
    """Images whose content contradicts their declaration."""
    def with_image(content):
        file = base()
        file.root["images"][1]["uri"] = data_uri(content, "image/png")
        return file.text()
    good = png(2, 2)
    jpeg = b"\xff\xd8\xff\xc0\x00\x11\x08\xff\xff\xff\xff\x03\x01\x11\x00\x02\x11\x01\x03\x11\x01\xff\xd9"
    webp = b"RIFF\x1a\0\0\0WEBPVP8L\x0d\0\0\0\x2f\xff\xff\xff\x0f\0\0\0\0\0\0\0\0"
    for name, content in (("too-wide", png(60000, 60000, b"\0" * 9)), ("few-rows", png(64, 64, b"\0" * 50)),
                          ("few-rows-of-16-bits", png(8, 8, b"\0" * (8 * 33), bits=16)), ("cut-16-bits", png(2, 2, bits=16)[:50]),
                          ("no-pixels", png(0, 0, b"")), ("beyond-limits", png(70000, 1, b"\0" * 99)),
                          ("cut", good[:40]), ("crc", good[:20] + b"\x09" + good[21:]), ("empty", b""),
                          ("text", b"no image"), ("jpeg-lies", jpeg), ("jpeg-cut", jpeg[:6]), ("webp-lies", webp),
                          ("gif", b"GIF89a\x01\0\x01\0\0\0\0;")):
        yield Case(f"image-{name}", with_image(content), "/images/1")
    yield Case("image-characters", changed("/images/1/uri", "data:image/png,abc").text(), "/images/1")
    for name, uri in (("no-comma", "data:image/png;base64"), ("escape", "data:image/png,%89%5"), ("bad-digit", "data:image/png;base64,a*bc"),
                      ("half-byte", "data:image/png;base64,a"), ("download", "https://example.org/a.png"),
                      ("outside", "../../../../../../../../etc/passwd"), ("nothing", "nothing.png"), ("none", ""),
                      ("percent", "a%zz.png"), ("zero-byte", "a%00.png"), ("drive", "c:/a.png")):
        yield Case(f"uri-{name}", changed("/images/1/uri", uri).text(), "/images/1/uri")


def of_buffers():
    for name, buffer, place in (("no-uri", {"byteLength": 9}, "/buffers/0"),
                                ("short", {"byteLength": 9, "uri": "data:;base64,AAAA"}, "/buffers/0/byteLength"),
                                ("download", {"byteLength": 9, "uri": "http://example.org/a"}, "/buffers/0/uri"),
                                ("folder", {"byteLength": 9, "uri": "/"}, "/buffers/0/uri"),
                                ("device", {"byteLength": 9, "uri": "/dev/zero"}, "/buffers/0/uri"),
                                ("negative", {"byteLength": -1, "uri": "data:;base64,AAAA"}, "/buffers/0/byteLength"),
                                ("no-length", {"uri": "data:;base64,AAAA"}, "/buffers/0")):
        root = {**base().root, "buffers": [buffer]}
        yield Case(f"buffer-{name}", json.dumps(root).encode(), place)
    root = base().root
    yield Case("buffer-none", json.dumps(root).encode(), "/bufferViews/15/buffer")


def of_text():
    """Text that is not JSON."""
    good = base().text()
    for name, content in (("cut", good[:len(good) // 2]), ("nan", good.replace(b'"yfov": 1', b'"yfov": NaN')),
                          ("infinity", good.replace(b'"yfov": 1', b'"yfov": Infinity')),
                          ("leading-zero", good.replace(b'"yfov": 1', b'"yfov": 01')),
                          ("utf-8", good.replace(b'"spot"', b'"sp\xff\xfet"', 1)),
                          ("utf-8-overlong", good.replace(b'"spot"', b'"sp\xc0\x80t"', 1)),
                          ("utf-8-surrogate", good.replace(b'"spot"', b'"sp\xed\xa0\x80t"', 1)),
                          ("surrogate", good.replace(b'"spot"', b'"sp\\ud800t"', 1)),
                          ("control", good.replace(b'"spot"', b'"sp\x01t"', 1)),
                          ("comma", good.replace(b'"scene": 0,', b'"scene": 0,,')),
                          ("comment", b"{ // a comment\n}"), ("two", good + good), ("quote", b'{"asset'),
                          ("deep", b'{"extras":' + b"[" * 100000), ("number", b'{"scene": 1e999999}'),
                          ("only-brace", b"{")):
        assert content != good, name
        yield Case(f"text-{name}", content, "line")
    for name, content in (("array", b"{}"), ("null", b'{"asset": null}')):
        yield Case(f"text-{name}", content, "the root" if content == b"{}" else "/asset")
    for name, content, place in (("scene", b'"scene": 1, "scenes": [{}]', "/scene"),
                                 ("scene-node", b'"scenes": [{"nodes": [0]}]', "/scenes/0/nodes/0")):
        yield Case(f"text-no-nodes-{name}", b'{"asset": {"version": "2.0"}, ' + content + b"}", place)


def of_containers_glb():
    """Containers whose lengths, versions and chunks are wrong."""
    good = base().glb()
    text = json.dumps(base().root).encode()
    for name, content in (("header", good[:11]), ("version-1", good[:4] + b"\x01" + good[5:]),
                          ("long", good[:8] + struct.pack("<I", len(good) + 1) + good[12:]),
                          ("short", good[:8] + struct.pack("<I", 11) + good[12:]), ("cut", good[:-1]),
                          ("cut-chunk-header", glb([], length=16)[:12] + b"\0" * 4),
                          ("no-chunks", glb([])), ("huge-chunk", good[:12] + b"\xff\xff\xff\x7f" + good[16:]),
                          ("all-ones", good[:12] + b"\xff\xff\xff\xff" + good[16:]),
                          ("binary-first", glb([(GLB_BINARY, b"1234"), (GLB_JSON, text)])),
                          ("lower-case", good[:16] + b"json" + good[20:]),
                          ("second-cut", good[:8] + struct.pack("<I", len(good) - 8) + good[12:-8])):
        yield Case(f"glb-{name}", content, "GLB", ".glb")
    yield Case("glb-not-json", glb([(GLB_JSON, b"\0\0\0\0")]), "line", ".glb")
    yield Case("glb-empty-json", glb([(GLB_JSON, b"")]), "line", ".glb")
    yield Case("glb-no-binary", glb([(GLB_JSON, json.dumps({**base().root, "buffers": [{"byteLength": 9}]}).encode())]),
               "/buffers/0", ".glb")
    file = base()
    root = {**file.root, "buffers": [{"byteLength": len(file.binary) + 1}]}
    yield Case("glb-short-binary", glb([(GLB_JSON, json.dumps(root).encode()), (GLB_BINARY, file.binary)]),
               "/buffers/0/byteLength", ".glb")
    yield Case("glb-utf-8", good.replace(b'"spot"', b'"sp\xfft"', 1), "line", ".glb")


def cases():
    root = copy.deepcopy(base().root)
    rules = (of_indices(root), of_numbers(root), of_containers(root), of_required(), of_values(), of_bytes(), of_images(),
             of_buffers(), of_text(), of_containers_glb())
    return [case for rule in rules for case in rule]
