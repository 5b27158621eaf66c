"""Renders a scene with Blender's Cycles on the CPU, with Candela's rules, and times it.

    blender -b -P tests/measure/bench/cycles.py -- SCENE OUT.exr [--spp N] [--size N] [--max-depth N] [--threads N] [--seed N]
                                                         [--roulette-start N] [--env FILE] [--surfaces principled|gltf]

Reads glTF (see cycles_gltf.py), and of NFF what the Cornell boxes consist of (v, b, f, al, p, mesh). Prints one line of JSON
that begins with `cycles: `: seconds and processor seconds of the path tracing alone, without building the scene or
writing the file, and samples per second; OUT.exr is linear. Written for Blender 3.4.
"""
import argparse
import json
import math
import os
import sys
import time
from dataclasses import dataclass, field

import bpy
from mathutils import Matrix, Vector

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import cycles_gltf  # noqa: E402

VIEW_ENTRIES = {"from": 3, "at": 3, "up": 3, "angle": 1, "hither": 1, "resolution": 2}


@dataclass
class Scene:
    view: dict = field(default_factory=dict)  # entry of `v`: its numbers
    materials: list = field(default_factory=list)  # dicts: colour, kd, ks, t, ior, emission
    vertices: list = field(default_factory=list)
    triangles: list = field(default_factory=list)  # indices of three vertices
    material_of: list = field(default_factory=list)  # of each triangle
    lamps: list = field(default_factory=list)  # corner, two sides and radiance


def statements(text):
    """Keywords, each with the numbers that follow it."""
    keyword, numbers = "", []
    for line in text.splitlines():
        for word in line.partition("#")[0].split():
            if not word[0].isalpha():
                numbers.append(float(word))
                continue
            if keyword:
                yield keyword, numbers
            keyword, numbers = word, []
    yield keyword, numbers


def triples(numbers):
    return [tuple(numbers[i:i + 3]) for i in range(0, len(numbers), 3)]


def read_material(n):
    if len(n) == 8:  # r g b Kd Ks Shine T ior
        return {"colour": n[:3], "kd": n[3], "ks": n[4], "t": n[6], "ior": n[7], "emission": [0, 0, 0]}
    if len(n) == 14:  # r g b Kd  r g b Ks  Shine T ior  emission
        return {"colour": n[:3], "kd": n[3], "ks": n[7], "t": n[9], "ior": n[10], "emission": n[11:]}
    sys.exit(f"a material of {len(n)} numbers is not read here")


def add_faces(scene, vertices, faces):
    """`faces` index `vertices` from 0; their material is the last one read."""
    first = len(scene.vertices)
    scene.vertices += vertices
    scene.triangles += [tuple(first + i for i in face) for face in faces]
    scene.material_of += [len(scene.materials) - 1] * len(faces)


def add_quad(scene, corners):
    if len(corners) != 4:
        sys.exit(f"a polygon of {len(corners)} corners is not read here")
    add_faces(scene, corners, [(3, 0, 1), (1, 2, 3)])  # the diagonal that Candela takes: not all quads are flat
    radiance = scene.materials[-1]["emission"]
    if any(radiance):
        corner, first, last = Vector(corners[0]), Vector(corners[1]), Vector(corners[3])
        scene.lamps.append((corner, first - corner, last - corner, Vector(radiance)))


def add_area_light(scene, numbers):
    corner, u, v, radiance = (Vector(triple) for triple in triples(numbers))
    scene.materials.append({"colour": [0, 0, 0], "kd": 1, "ks": 0, "t": 0, "ior": 1, "emission": list(radiance)})
    add_quad(scene, [tuple(corner), tuple(corner + u), tuple(corner + u + v), tuple(corner + v)])


def add_mesh(scene, numbers):
    vertex_count = int(numbers[0])
    indices = [int(i) - 1 for i in numbers[2 + 3 * vertex_count:]]
    add_faces(scene, triples(numbers[2:2 + 3 * vertex_count]), triples(indices))


def read_scene(path):
    scene = Scene()
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for keyword, numbers in statements(text):
        if keyword in VIEW_ENTRIES:
            scene.view[keyword] = numbers
        elif keyword == "b" and not any(numbers):
            pass  # black is what the world is given
        elif keyword == "f":
            scene.materials.append(read_material(numbers))
        elif keyword == "al":
            add_area_light(scene, numbers)
        elif keyword == "p":
            add_quad(scene, triples(numbers[1:]))
        elif keyword == "mesh":
            add_mesh(scene, numbers)
        elif keyword != "v":
            sys.exit(f"{path}: the statement \"{keyword}\" is not read here")
    return scene


def set_colour(node, colour):
    node.inputs["Color"].default_value = (*colour, 1)


def surface_node(nodes, material):
    """The first rule that fits, of docs/scene-format.md."""
    if material["kd"] == 1:
        node = nodes.new("ShaderNodeBsdfDiffuse")
    elif material["ks"] == 1:
        node = nodes.new("ShaderNodeBsdfGlossy")
        node.distribution = "SHARP"
    elif material["kd"] == 0 and material["ks"] == 0:
        node = nodes.new("ShaderNodeBsdfGlass")
        node.distribution = "SHARP"
        node.inputs["IOR"].default_value = material["ior"]
    else:
        sys.exit("a mixture of lobes is not read here")
    set_colour(node, material["colour"])
    return node


def shine_for_camera(nodes, links, radiance):
    """The visible surface of a light: area lights are invisible only to the camera."""
    node = nodes.new("ShaderNodeEmission")
    strength = max(radiance)
    set_colour(node, [channel / strength for channel in radiance])
    product = nodes.new("ShaderNodeMath")
    product.operation = "MULTIPLY"
    product.inputs[1].default_value = strength
    links.new(nodes.new("ShaderNodeLightPath").outputs["Is Camera Ray"], product.inputs[0])
    links.new(product.outputs["Value"], node.inputs["Strength"])
    return node.outputs["Emission"]


def build_material(material):
    result = bpy.data.materials.new("material")
    result.use_nodes = True
    result.cycles.sample_as_light = False  # area lights are sampled in its place
    nodes, links = result.node_tree.nodes, result.node_tree.links
    nodes.clear()
    surface = surface_node(nodes, material).outputs["BSDF"]
    if any(material["emission"]):
        both = nodes.new("ShaderNodeAddShader")
        links.new(surface, both.inputs[0])
        links.new(shine_for_camera(nodes, links, material["emission"]), both.inputs[1])
        surface = both.outputs["Shader"]
    links.new(surface, nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return result


def build_mesh(scene):
    """All triangles as one object, so that Cycles traces one BVH over all of them."""
    mesh = bpy.data.meshes.new("scene")
    mesh.from_pydata(scene.vertices, [], scene.triangles)
    for material in scene.materials:
        mesh.materials.append(build_material(material))
    mesh.polygons.foreach_set("material_index", scene.material_of)
    mesh.update()
    bpy.context.collection.objects.link(bpy.data.objects.new("scene", mesh))


def build_lamp(corner, u, v, radiance):
    """A rectangle that emits along u x v: area lights are sampled more exactly than triangles that emit."""
    if abs(u.dot(v)) > 1e-6 * u.length * v.length:
        sys.exit("a lamp that is no rectangle is not read here")
    normal = u.cross(v).normalized()
    light = bpy.data.lights.new("lamp", "AREA")
    light.shape = "RECTANGLE"
    light.size, light.size_y = u.length, v.length
    strength = max(radiance)
    light.color = radiance / strength
    light.energy = 4 * strength * u.length * v.length  # Blender's radiance is energy / (4 area)
    light.cycles.use_multiple_importance_sampling = True
    placed = bpy.data.objects.new("lamp", light)
    placed.matrix_world = Matrix((u.normalized(), -v.normalized(), -normal)).transposed().to_4x4()
    # Just in front of its surface, which rays hit behind it, because area lights let them pass.
    placed.matrix_world.translation = corner + (u + v) / 2 + 1e-5 * math.sqrt(u.length * v.length) * normal
    bpy.context.collection.objects.link(placed)


def build_camera(view):
    eye, target = Vector(view["from"]), Vector(view["at"])
    back = (eye - target).normalized()
    right = Vector(view["up"]).cross(back).normalized()
    up = back.cross(right)
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle_y = math.radians(view["angle"][0])
    distance = (eye - target).length
    camera.clip_start, camera.clip_end = 1e-4 * distance, 1e4 * distance
    placed = bpy.data.objects.new("camera", camera)
    placed.matrix_world = Matrix((right, up, back)).transposed().to_4x4()
    placed.matrix_world.translation = eye
    bpy.context.collection.objects.link(placed)
    bpy.context.scene.camera = placed


def build_black_world():
    world = bpy.data.worlds.new("world")
    world.use_nodes = True
    set_colour(world.node_tree.nodes["Background"], (0, 0, 0))
    world.cycles.sampling_method = "NONE"
    bpy.context.scene.world = world


def build_scene(scene):
    build_mesh(scene)
    for lamp in scene.lamps:
        build_lamp(*lamp)
    build_camera(scene.view)
    build_black_world()


def choose_estimator(options):
    """Light samples and lobes with multiple importance weights, unbiased, and the same samples for every pixel."""
    cycles = bpy.context.scene.cycles
    cycles.device = "CPU"
    cycles.seed = options.seed
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.light_sampling_threshold = 0  # else it would leave out faint light samples
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.blur_glossy = 0
    cycles.pixel_filter_type = "BOX"  # one pixel wide
    cycles.film_exposure = 1
    cycles.use_auto_tile = False
    # Russian roulette is not played at vertices before this one.
    cycles.min_light_bounces = options.roulette_start
    # N bounces of Cycles still sample the lights at the last one: N + 2 rays, the camera's included.
    bounces = options.max_depth - 2
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = bounces
    cycles.transparent_max_bounces = 1024  # they do not count for Candela


def choose_picture(options):
    render = bpy.context.scene.render
    render.resolution_x = render.resolution_y = options.size
    render.resolution_percentage = 100
    render.threads_mode = "FIXED"
    render.threads = options.threads
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"


def render_and_time(options):
    """Times a second render, for which Cycles keeps the scene and its BVH from a first one of one sample."""
    scene = bpy.context.scene
    scene.render.use_persistent_data = True
    scene.cycles.samples = 1
    bpy.ops.render.render()
    scene.cycles.samples = options.spp
    scene.update_tag()
    wall, processor = time.perf_counter(), time.process_time()
    bpy.ops.render.render()
    wall, processor = time.perf_counter() - wall, time.process_time() - processor
    bpy.data.images["Render Result"].save_render(os.path.abspath(options.output))
    samples = options.size * options.size * options.spp
    return {"version": bpy.app.version_string, "samples": samples, "seconds": wall, "processorSeconds": processor,
            "msamplesPerSecond": samples / wall / 1e6, "msamplesPerProcessorSecond": samples / processor / 1e6}


def parse_options():
    parser = argparse.ArgumentParser(prog="cycles.py")
    parser.add_argument("scene")
    parser.add_argument("output", help="OpenEXR file")
    parser.add_argument("--spp", type=int, default=16)
    parser.add_argument("--size", type=int, default=512, help="side of the picture, pixels")
    parser.add_argument("--max-depth", type=int, default=9, help="longest path in rays, as Candela counts; at least 2")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--env", help="equirectangular image that lights a glTF scene")
    parser.add_argument("--surfaces", choices=["principled", "gltf"], default="principled", help="see cycles_gltf.py")
    parser.add_argument("--roulette-start", type=int, default=0, help="bounces before Russian roulette; Cycles' own: 0")
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1:])


def main():
    options = parse_options()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.engine = "CYCLES"
    if options.scene.endswith(".gltf"):
        cycles_gltf.load(options.scene, options.env, options.surfaces)
    else:
        build_scene(read_scene(options.scene))
    choose_estimator(options)
    choose_picture(options)
    print("cycles: " + json.dumps(render_and_time(options)), flush=True)


main()
