"""Reads glTF for cycles.py by Blender's own importer, and gives camera, lights and environment Candela's units.

The importer's lights are in watts, of which it makes 683 lumens each; docs/scene-format.md takes candela as W/sr and
lux as W/m^2. Written for Blender 3.4.
"""
import json
import math
import os

import bpy
import cycles_surfaces
import numpy

numpy.bool = bool  # the importer needs this name, which NumPy 1.24 no longer has


def load(path, environment, surfaces):
    """Replaces the scene; `environment` is the name of an equirectangular image, or None for a black one.

    `surfaces` is "principled" for what the importer makes, or "gltf" for nodes that are closer to glTF's text.
    """
    with open(path, encoding="utf-8") as file:
        document = json.load(file)
    bpy.ops.import_scene.gltf(filepath=os.path.abspath(path))
    scene = bpy.context.scene
    scene.camera = next(o for o in scene.objects if o.type == "CAMERA")
    definitions = {light["name"]: light for light in document.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])}
    for placed in [o for o in scene.objects if o.type == "LIGHT"]:
        set_light(placed, definitions[placed.data.name])
    definitions = {material["name"]: material for material in document["materials"]}
    albedos = cycles_surfaces.albedo_image() if surfaces == "gltf" else None
    for material in bpy.data.materials:
        set_material(material, definitions[material.name])
        if albedos:
            cycles_surfaces.follow_gltf(material, albedos)
    build_world(environment)


def set_material(material, definition):
    """Cycles ignores the threshold that the importer sets for masks, and single scattering is the importer's choice."""
    tree = material.node_tree
    node = next(n for n in tree.nodes if n.type == "BSDF_PRINCIPLED")
    node.distribution = "MULTI_GGX"
    material.cycles.sample_as_light = node.inputs["Emission"].is_linked or any(node.inputs["Emission"].default_value[:3])
    if definition.get("alphaMode") == "MASK":
        opaque = tree.nodes.new("ShaderNodeMath")
        opaque.operation = "GREATER_THAN"
        opaque.inputs[1].default_value = definition.get("alphaCutoff", 0.5)
        tree.links.new(node.inputs["Alpha"].links[0].from_socket, opaque.inputs[0])
        tree.links.new(opaque.outputs[0], node.inputs["Alpha"])


def set_light(placed, definition):
    """A spot light becomes a point light whose shader has glTF's cone, which differs from Blender's."""
    intensity = definition.get("intensity", 1)
    spot = definition.get("spot", {})
    if definition["type"] == "directional":
        placed.data.energy = intensity
        placed.data.angle = 0
        return
    if definition["type"] == "spot":
        placed.data.type = "POINT"
    light = bpy.data.lights[placed.data.name]  # by another type, the object has another class
    light.energy = 4 * math.pi * intensity
    light.shadow_soft_size = 0
    if definition["type"] == "spot":
        add_cone(light, math.cos(spot.get("innerConeAngle", 0)), math.cos(spot.get("outerConeAngle", math.pi / 4)))


def add_cone(light, inner, outer):
    """Emission times clamp((cos t - outer) / (inner - outer))^2; the light shines along its own -z."""
    light.use_nodes = True
    nodes, links = light.node_tree.nodes, light.node_tree.links
    axes = nodes.new("ShaderNodeSeparateXYZ")
    links.new(nodes.new("ShaderNodeTexCoord").outputs["Normal"], axes.inputs[0])
    ramp = nodes.new("ShaderNodeMapRange")  # clamps
    for name, value in (("From Min", -outer), ("From Max", -inner), ("To Min", 0), ("To Max", 1)):
        ramp.inputs[name].default_value = value
    links.new(axes.outputs["Z"], ramp.inputs["Value"])
    square = nodes.new("ShaderNodeMath")
    square.operation = "MULTIPLY"
    links.new(ramp.outputs[0], square.inputs[0])
    links.new(ramp.outputs[0], square.inputs[1])
    links.new(square.outputs[0], nodes["Emission"].inputs["Strength"])


def build_world(environment):
    """Blender's map of directions is Candela's: the importer turns glTF's x, y, z to x, -z, y."""
    world = bpy.data.worlds.new("world")
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (0, 0, 0, 1)
    if environment:
        node = world.node_tree.nodes.new("ShaderNodeTexEnvironment")
        node.image = bpy.data.images.load(os.path.abspath(environment))
        world.node_tree.links.new(node.outputs["Color"], background.inputs["Color"])
    world.cycles.sampling_method = "AUTOMATIC" if environment else "NONE"
    bpy.context.scene.world = world
