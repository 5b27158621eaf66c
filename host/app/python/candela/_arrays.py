"""Scenes from arrays: a glTF file in memory, to which every rule for files applies."""
import json
import math
import struct
from collections.abc import Iterable, Mapping

import numpy

from ._errors import UsageError
from ._gltf_material import material_of

_CAMERA = {
    "from": None,
    "at": None,
    "up": (0, 1, 0),
    "angle": 45,
    "resolution": (512, 512),
    "aperture": 0,
    "focal": 1,
    "orthographic_height": None,
}
_LIGHT = {"kind": None, "position": (0, 0, 0), "direction": (0, 0, -1), "intensity": (1, 1, 1), "inner": 0, "outer": 45}
_FLOAT, _UINT = 5126, 5125


def _fail(message):
    raise UsageError(message)


def _complete(what, given, defaults):
    """The entries of a dict, with defaults (None: required) for those that it lacks."""
    if not isinstance(given, Mapping):
        _fail(f"{what}: expected a dict, got {given!r}")
    for name in given:
        if name not in defaults:
            _fail(f"{what}: unknown entry {name!r}; the entries are {', '.join(defaults)}")
    return {**defaults, **given}


def _list(what, value):
    """The items of a list or another iterable; None has none."""
    if value is None:
        return []
    if isinstance(value, (str, bytes, Mapping)) or not isinstance(value, Iterable):
        _fail(f"{what}: expected a list of dicts, got {value!r}")
    return list(value)


def _name(value):
    try:
        value.encode()
        return value
    except (AttributeError, UnicodeEncodeError):
        _fail(f"name: expected a text, got {value!r}")


def _is_single(number):
    """Whether a number is finite in single precision."""
    with numpy.errstate(over="ignore"):
        return bool(numpy.isfinite(numpy.float32(number)))


def _vector(what, value, length=3):
    try:
        numbers = [float(number) for number in value]
    except (TypeError, ValueError):
        numbers = []
    if len(numbers) != length or not all(math.isfinite(number) for number in numbers):
        _fail(f"{what}: expected {length} finite numbers, got {value!r}")
    if not all(map(_is_single, numbers)):
        _fail(f"{what}: a number is not finite in single precision: {value!r}")
    return numbers


def _number(what, value, test, expected):
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not (math.isfinite(number) and test(number)):
        _fail(f"{what}: expected {expected}, got {value!r}")
    return number


def _array(what, value, width):
    """Rows of numbers in single precision."""
    try:
        with numpy.errstate(over="ignore"):
            array = numpy.ascontiguousarray(value, numpy.float32)
    except (TypeError, ValueError, OverflowError) as error:
        _fail(f"{what}: {error}")
    if array.ndim != 2 or array.shape[1] != width:
        _fail(f"{what}: expected an array of shape (n, {width}), got {array.shape}")
    if not numpy.isfinite(array).all():
        _fail(f"{what}: a number is not finite in single precision")
    return array


def _indices(what, value, count, width=None):
    """Whole numbers from 0 to count - 1."""
    array = numpy.asarray(value)
    if array.size == 0:
        array = array.astype(numpy.int64)
    if array.dtype.kind not in "iu":
        _fail(f"{what}: expected whole numbers, got {array.dtype}")
    if array.ndim != (1 if width is None else 2) or (width is not None and array.shape[1] != width):
        _fail(f"{what}: expected an array of shape {'(n,)' if width is None else f'(n, {width})'}, got {array.shape}")
    if array.size and (array.min() < 0 or array.max() >= count):
        wrong = array.min() if array.min() < 0 else array.max()
        _fail(f"{what}: index {wrong} is outside 0 to {count - 1}")
    return numpy.ascontiguousarray(array, numpy.uint32)


def _scaled(vector):
    """A multiple whose largest component is 1 or -1, so that products neither overflow nor vanish."""
    largest = max(map(abs, vector))
    return [number / largest for number in vector]


def _unit(vector):
    vector = _scaled(vector)
    length = math.sqrt(sum(number * number for number in vector))
    return [number / length for number in vector]


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _placed(position, direction, up):
    """The matrix of a node that looks along a direction, column by column."""
    back = [-number for number in direction]
    right = _unit(_cross(_scaled(up), _scaled(back)))
    back = _unit(back)
    return [*right, 0, *_cross(back, right), 0, *back, 0, *position, 1]


def _any_up(direction):
    least = min(range(3), key=lambda axis: abs(direction[axis]))
    return [1.0 if axis == least else 0.0 for axis in range(3)]


def _camera(given):
    """The camera with all entries checked, or None."""
    if given is None:
        return None
    camera = _complete("camera", given, _CAMERA)
    for name in ("from", "at", "up"):
        camera[name] = _vector(f"camera: {name}", camera[name])
    if (numpy.float32(camera["at"]) == numpy.float32(camera["from"])).all():
        _fail("camera: from and at are the same point in single precision")
    view = [a - b for a, b in zip(camera["at"], camera["from"])]
    if not any(numpy.float32(camera["up"])) or not any(_cross(_scaled(camera["up"]), _scaled(view))):
        _fail("camera: up is the zero vector, or parallel to the direction of view")
    camera["angle"] = _number("camera: angle", camera["angle"], lambda a: 0 < a < 180, "degrees between 0 and 180")
    camera["aperture"] = _number("camera: aperture", camera["aperture"], lambda a: a >= 0, "a number from 0")
    camera["focal"] = _number("camera: focal", camera["focal"], lambda f: f > 0, "a number above 0")
    if camera["orthographic_height"] is not None:
        height = camera["orthographic_height"]
        camera["orthographic_height"] = _number("camera: orthographic_height", height, lambda h: h > 0, "a number above 0")
    sides = _vector("camera: resolution", camera["resolution"], 2)
    if not all(side == int(side) and 1 <= side <= 65535 for side in sides):
        _fail(f"camera: resolution: expected two whole numbers from 1 to 65535, got {camera['resolution']!r}")
    camera["resolution"] = tuple(int(side) for side in sides)
    return camera


def _camera_node(camera):
    direction = [a - b for a, b in zip(camera["at"], camera["from"])]
    return {"camera": 0, "matrix": _placed(camera["from"], direction, camera["up"])}


def _light(index, given):
    """A light of KHR_lights_punctual and the node that places it."""
    what = f"lights[{index}]"
    light = _complete(what, given, _LIGHT)
    if light["kind"] not in ("point", "spot", "directional"):
        _fail(f"{what}: kind: expected 'point', 'spot' or 'directional', got {light['kind']!r}")
    direction = _vector(f"{what}: direction", light["direction"])
    if not any(direction):
        _fail(f"{what}: direction is the zero vector")
    position = _vector(f"{what}: position", light["position"])
    entry = {"type": light["kind"], "color": _vector(f"{what}: intensity", light["intensity"])}
    if light["kind"] == "spot":
        cone = (light["inner"], light["outer"])
        inner, outer = (_number(f"{what}: inner, outer", a, lambda a: 0 <= a <= 90, "degrees from 0 to 90") for a in cone)
        entry["spot"] = {"innerConeAngle": math.radians(inner), "outerConeAngle": math.radians(outer)}
    return entry, {"matrix": _placed(position, direction, _any_up(direction))}


class _Binary:
    """The binary chunk of a file, with its accessors."""

    def __init__(self):
        self.parts, self.views, self.accessors, self.size = [], [], [], 0

    def add(self, array, component, kind):
        accessor = {"bufferView": len(self.views), "componentType": component, "count": len(array), "type": kind}
        if kind == "VEC3" and component == _FLOAT and len(array):
            accessor |= {"min": array.min(0).tolist(), "max": array.max(0).tolist()}
        self.views.append({"buffer": 0, "byteOffset": self.size, "byteLength": array.nbytes})
        self.accessors.append(accessor)
        self.parts.append(array.tobytes())
        self.size += array.nbytes
        return len(self.accessors) - 1


def _attributes(binary, vertices, normals, texcoords, colours):
    attributes = {"POSITION": binary.add(vertices, _FLOAT, "VEC3")}
    given = (("NORMAL", "normals", normals, 3, "VEC3"), ("TEXCOORD_0", "texcoords", texcoords, 2, "VEC2"),
             ("COLOR_0", "colours", colours, 4, "VEC4"))
    for name, what, value, width, kind in given:
        if value is None:
            continue
        array = _array(what, value, width)
        if len(array) != len(vertices):
            _fail(f"{what}: expected {len(vertices)} rows, as many as vertices, got {len(array)}")
        attributes[name] = binary.add(array, _FLOAT, kind)
    return attributes


def _runs(materials):
    """The ends of the runs of equal materials: primitives keep the order of the faces."""
    changes = numpy.flatnonzero(numpy.diff(materials)) + 1
    return [0, *changes.tolist(), len(materials)]


def _primitives(binary, attributes, faces, materials):
    if not len(faces):
        _fail("faces: a scene needs at least one triangle")
    ends = _runs(materials)
    return [{"attributes": attributes, "indices": binary.add(faces[first:end].reshape(-1), _UINT, "SCALAR"),
             "material": int(materials[first])} for first, end in zip(ends, ends[1:])]


def _glb(document, binary):
    text = json.dumps(document, separators=(",", ":"), allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    size = 28 + len(text) + binary.size
    if size >= 1 << 32:
        _fail("the arrays exceed 4 GiB")
    head = struct.pack("<4sIII4s", b"glTF", 2, size, len(text), b"JSON")
    return b"".join([head, text, struct.pack("<I4s", binary.size, b"BIN\0"), *binary.parts])


def build(vertices, faces, materials=(), face_materials=None, *, normals=None, texcoords=None, colours=None, lights=(),
          camera=None, name="scene", **options):
    """Returns the file, its name, the camera with all entries, and the options for loading."""
    materials = _list("materials", materials)
    vertices = _array("vertices", vertices, 3)
    faces = _indices("faces", faces, len(vertices), 3)
    if face_materials is None:
        face_materials = numpy.zeros(len(faces), numpy.uint32)
    face_materials = _indices("face_materials", face_materials, max(1, len(materials)))
    if len(face_materials) != len(faces):
        _fail(f"face_materials: expected {len(faces)} indices, one for each face, got {len(face_materials)}")
    camera = _camera(camera)
    binary = _Binary()
    attributes = _attributes(binary, vertices, normals, texcoords, colours)
    document = {
        "asset": {"version": "2.0", "generator": "candela.Scene"},
        "extensionsUsed": [],
        "scene": 0,
        "materials": [material_of(index, material) for index, material in enumerate(materials or [{}])],
        "meshes": [{"primitives": _primitives(binary, attributes, faces, face_materials)}],
        "nodes": [{"mesh": 0}],
    }
    _add_camera(document, camera)
    _add_lights(document, lights)
    document["scenes"] = [{"nodes": list(range(len(document["nodes"])))}]
    document |= {"accessors": binary.accessors, "bufferViews": binary.views, "buffers": [{"byteLength": binary.size}]}
    _name_extensions(document)
    return {"glb": _glb(document, binary), "name": _name(name), "camera": camera, "options": options}


def _add_camera(document, camera):
    if camera is not None:
        document["cameras"] = [{"type": "perspective", "perspective": {"yfov": math.radians(camera["angle"]), "znear": 1}}]
        document["nodes"].append(_camera_node(camera))


def _add_lights(document, lights):
    placed = [_light(index, light) for index, light in enumerate(_list("lights", lights))]
    if placed:
        document["extensions"] = {"KHR_lights_punctual": {"lights": [light for light, _ in placed]}}
    for index, (_, node) in enumerate(placed):
        document["nodes"].append(node | {"extensions": {"KHR_lights_punctual": {"light": index}}})


def _name_extensions(document):
    used = {name for material in document["materials"] for name in material.get("extensions", {})}
    used |= set(document.get("extensions", {}))
    document["extensionsUsed"] = sorted(used)
    if not used:
        del document["extensionsUsed"]
