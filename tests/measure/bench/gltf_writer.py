"""What gltf_scenes.py builds scenes of: meshes, textures, lights and a camera, as one glTF file without other files."""
import base64
import math
import struct
import zlib
from array import array

FLOAT, UNSIGNED_INT = 5126, 5125


def sphere(radius, columns=96, rows=48):
    """Positions, normals, texture coordinates and indices of longitudes and latitudes."""
    positions, normals, coordinates, indices = array("f"), array("f"), array("f"), array("I")
    for row in range(rows + 1):
        for column in range(columns + 1):
            phi, theta = 2 * math.pi * column / columns, math.pi * row / rows
            normal = (math.sin(theta) * math.sin(phi), math.cos(theta), math.sin(theta) * math.cos(phi))
            normals.extend(normal)
            positions.extend(radius * c for c in normal)
            coordinates.extend((column / columns, row / rows))
    for row in range(rows):
        for column in range(columns):
            a = row * (columns + 1) + column
            b = a + columns + 1
            if row + 1 < rows:  # at a pole, one of the two triangles has no area
                indices.extend((a, b, b + 1))
            if row > 0:
                indices.extend((a, b + 1, a + 1))
    return positions, normals, coordinates, indices


def quad(corner, along_u, along_v):
    """A parallelogram; its texture's upper left is at `corner`."""
    normal = [along_v[1] * along_u[2] - along_v[2] * along_u[1], along_v[2] * along_u[0] - along_v[0] * along_u[2],
              along_v[0] * along_u[1] - along_v[1] * along_u[0]]
    length = math.hypot(*normal)
    positions, normals, coordinates = array("f"), array("f"), array("f")
    for u, v in ((0, 0), (0, 1), (1, 1), (1, 0)):
        positions.extend(c + u * a + v * b for c, a, b in zip(corner, along_u, along_v))
        normals.extend(n / length for n in normal)
        coordinates.extend((u, v))
    return positions, normals, coordinates, array("I", (0, 1, 2, 0, 2, 3))


def floor(side):
    return quad([-side / 2, 0, -side / 2], [side, 0, 0], [0, 0, side])


def panel(width, height):
    """Upright, its front towards +z."""
    return quad([-width / 2, height / 2, 0], [width, 0, 0], [0, -height, 0])


def texture(side, value):
    """A PNG file of side x side pixels; value(u, v), v from above, returns 3 or 4 numbers of 0 to 1, as stored."""
    rows = bytearray()
    for y in range(side):
        rows.append(0)
        for x in range(side):
            texel = value((x + 0.5) / side, (y + 0.5) / side)
            rows.extend(round(255 * min(max(c, 0), 1)) for c in texel)

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    header = struct.pack(">IIBBBBB", side, side, 8, 6 if len(texel) == 4 else 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def environment(width, height, radiance):
    """A Radiance file; radiance(x, y, z) is asked for the directions of docs/gltf.md, "Environment light"."""
    content = bytearray(f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode())
    for row in range(height):
        latitude = math.pi * (0.5 - (row + 0.5) / height)
        for column in range(width):
            longitude = 2 * math.pi * ((column + 0.5) / width - 0.5)
            light = radiance(math.cos(latitude) * math.cos(longitude), math.sin(latitude),
                             math.cos(latitude) * math.sin(longitude))
            exponent = math.frexp(max(light))[1]
            content.extend(min(int(c * 2.0**(8 - exponent)), 255) for c in light)
            content.append(exponent + 128)
    return bytes(content)


def rotation(direction):
    """The quaternion x, y, z, w that turns +z to a direction and leaves x horizontal."""
    x, y, z = (c / math.hypot(*direction) for c in direction)
    yaw, pitch = math.atan2(x, z) / 2, -math.asin(y) / 2
    return [math.cos(yaw) * math.sin(pitch), math.sin(yaw) * math.cos(pitch), -math.sin(yaw) * math.sin(pitch),
            math.cos(yaw) * math.cos(pitch)]


def data_uri(kind, content):
    return f"data:{kind};base64," + base64.b64encode(content).decode()


class Scene:
    """Collects a file; `sky` is the name of its environment's file, or None."""

    def __init__(self, eye, target, yfov, sky):
        back = [a - b for a, b in zip(eye, target)]
        self.buffer = bytearray()
        self.views, self.accessors, self.meshes, self.materials, self.images, self.lights = [], [], [], [], [], []
        self.nodes = [{"name": "camera", "camera": 0, "translation": eye, "rotation": rotation(back)}]
        self.yfov = yfov
        self.asset = {"version": "2.0"} | ({"extras": {"environment": sky}} if sky else {})

    def accessor(self, values, kind, component, width):
        self.views.append({"buffer": 0, "byteOffset": len(self.buffer), "byteLength": len(values) * values.itemsize})
        self.buffer += values.tobytes()
        result = {"bufferView": len(self.views) - 1, "componentType": component, "count": len(values) // width, "type": kind}
        if kind == "VEC3":
            result |= {"min": [min(values[i::3]) for i in range(3)], "max": [max(values[i::3]) for i in range(3)]}
        self.accessors.append(result)
        return len(self.accessors) - 1

    def texture(self, png):
        """Its index."""
        self.images.append({"uri": data_uri("image/png", png)})
        return len(self.images) - 1

    def add(self, shape, material, translation=(0, 0, 0)):
        positions, normals, coordinates, indices = shape
        attributes = {"POSITION": self.accessor(positions, "VEC3", FLOAT, 3), "NORMAL": self.accessor(normals, "VEC3", FLOAT, 3),
                      "TEXCOORD_0": self.accessor(coordinates, "VEC2", FLOAT, 2)}
        self.materials.append({"name": f"material {len(self.materials)}"} | material)
        self.meshes.append({"primitives": [{"attributes": attributes, "material": len(self.materials) - 1,
                                            "indices": self.accessor(indices, "SCALAR", UNSIGNED_INT, 1)}]})
        self.nodes.append({"mesh": len(self.meshes) - 1, "translation": list(translation)})

    def light(self, name, light, position):
        """A light that is directed from its position to the origin."""
        self.lights.append({"name": name} | light)
        self.nodes.append({"name": name, "translation": position, "rotation": rotation(position),
                           "extensions": {"KHR_lights_punctual": {"light": len(self.lights) - 1}}})

    def document(self):
        used = {name for material in self.materials for name in material.get("extensions", {})}
        result = {"asset": self.asset, "scene": 0, "scenes": [{"nodes": list(range(len(self.nodes)))}], "nodes": self.nodes,
                  "cameras": [{"type": "perspective", "perspective": {"yfov": self.yfov, "aspectRatio": 1, "znear": 0.01, "zfar": 100}}],
                  "meshes": self.meshes, "materials": self.materials, "accessors": self.accessors, "bufferViews": self.views,
                  "buffers": [{"byteLength": len(self.buffer), "uri": data_uri("application/octet-stream", self.buffer)}]}
        if self.images:
            result |= {"images": self.images, "textures": [{"source": index} for index in range(len(self.images))]}
        if self.lights:
            used.add("KHR_lights_punctual")
            result["extensions"] = {"KHR_lights_punctual": {"lights": self.lights}}
        return result | ({"extensionsUsed": sorted(used)} if used else {})
