"""Materials of glTF for Cycles, other than by Principled BSDF of Blender 3.4.

Principled BSDF differs from glTF's appendix B in three ways: below its specular lobe, the diffuse lobe is as bright as
without it; the diffuse lobe is Burley's, which depends on the roughness; and its clear coat has a quarter of the
strength and another distribution. `follow_gltf` replaces it by nodes with a Lambertian lobe that receives what the
specular lobe leaves, and with glTF's coat, so that the rest of a picture can be compared. For an index of refraction of
1.5; materials that transmit light stay as they are.
"""
import math

import bpy
import numpy

F0 = 0.04
SAMPLES = 4096  # per cosine and roughness
SIDE = 48  # of the table of albedos


def specular_albedo(cosine, roughness, generator):
    """Albedo of the specular lobe of a dielectric, all orders of scattering included (Turquin 2019), by Monte Carlo."""
    alpha = max(roughness, 0.01)**2
    wo = numpy.array([math.sqrt(1 - cosine * cosine), 0, cosine])
    stretched = wo * [alpha, alpha, 1]
    stretched /= numpy.linalg.norm(stretched)
    z = 1 - generator.random(SAMPLES) * (1 + stretched[2])  # visible normals by spherical caps (Dupuy and Benyoub 2023)
    phi = 2 * math.pi * generator.random(SAMPLES)
    radius = numpy.sqrt(numpy.clip(1 - z * z, 0, 1))
    h = (numpy.stack([radius * numpy.cos(phi), radius * numpy.sin(phi), z], axis=1) + stretched) * [alpha, alpha, 1]
    h /= numpy.linalg.norm(h, axis=1, keepdims=True)
    x = h @ wo
    cos_in = 2 * x * h[:, 2] - cosine

    def smith(c):
        return (numpy.sqrt(1 + alpha * alpha * (1 / (c * c) - 1)) - 1) / 2

    above = cos_in > 1e-6
    weight = numpy.where(above, (1 + smith(cosine)) / (1 + smith(cosine) + smith(numpy.where(above, cos_in, 1))), 0)
    fresnel = F0 + (1 - F0) * (1 - x)**5
    white = weight.mean()
    return (weight * fresnel).mean() * (1 + F0 * (1 - white) / white)


def albedo_image():
    """The column is the cosine, the row the roughness, each from 0 in the middle of the first texel to 1 in that of the last."""
    generator = numpy.random.default_rng(1)
    image = bpy.data.images.new("albedo", SIDE, SIDE, float_buffer=True, is_data=True)
    texels = [(value, value, value, 1) for row in range(SIDE) for column in range(SIDE)
              for value in [specular_albedo(max(column / (SIDE - 1), 0.005), row / (SIDE - 1), generator)]]
    image.pixels = [value for texel in texels for value in texel]
    image.pack()
    return image


class Graph:
    """Builds nodes; a value is a socket or a number."""

    def __init__(self, tree):
        self.tree = tree

    def node(self, kind, inputs, **properties):
        """`inputs` has the value of each input by name or index."""
        result = self.tree.nodes.new(kind)
        for name, value in properties.items():
            setattr(result, name, value)
        for name, value in inputs.items():
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, result.inputs[name])
            else:
                result.inputs[name].default_value = value
        return result

    def math(self, operation, *values):
        return self.node("ShaderNodeMath", dict(enumerate(values)), operation=operation).outputs[0]

    def mix(self, factor, first, second):
        return self.node("ShaderNodeMixShader", {0: factor, 1: first, 2: second}).outputs[0]

    def add(self, first, second):
        return self.node("ShaderNodeAddShader", {0: first, 1: second}).outputs[0]

    def scaled(self, colour, factor):
        return self.node("ShaderNodeVectorMath", {0: colour, "Scale": factor}, operation="SCALE").outputs[0]


def value_of(node, name):
    """What feeds an input: the socket that is linked to it, or its value."""
    socket = node.inputs[name]
    if socket.is_linked:
        return socket.links[0].from_socket
    value = socket.default_value
    return value if isinstance(value, float) else tuple(value)


def follow_gltf(material, albedos):
    """Replaces Principled BSDF; `albedos` is the result of albedo_image()."""
    tree = material.node_tree
    old = next(node for node in tree.nodes if node.type == "BSDF_PRINCIPLED")
    if value_of(old, "Transmission") != 0:
        return
    graph = Graph(tree)
    normal = {"Normal": value_of(old, "Normal")} if old.inputs["Normal"].is_linked else {}
    geometry = tree.nodes.new("ShaderNodeNewGeometry")
    cosine = graph.node("ShaderNodeVectorMath", {0: geometry.outputs["Incoming"], 1: normal.get("Normal", geometry.outputs["Normal"])},
                        operation="DOT_PRODUCT").outputs["Value"]
    colour, roughness = value_of(old, "Base Color"), value_of(old, "Roughness")
    shader = graph.mix(value_of(old, "Metallic"), dielectric(graph, colour[:3] if isinstance(colour, tuple) else colour, roughness,
                                                             cosine, normal, albedos),
                       principled(graph, {"Base Color": colour, "Metallic": 1.0, "Roughness": roughness} | normal, "MULTI_GGX"))
    if value_of(old, "Clearcoat") != 0:
        shader = coated(graph, shader, value_of(old, "Clearcoat"), value_of(old, "Clearcoat Roughness"), cosine)
    emission = value_of(old, "Emission")
    if not isinstance(emission, tuple) or any(emission[:3]):
        shader = graph.add(shader, graph.node("ShaderNodeEmission", {"Color": emission,
                                                                     "Strength": value_of(old, "Emission Strength")}).outputs[0])
    if value_of(old, "Alpha") != 1:
        shader = graph.mix(value_of(old, "Alpha"), graph.node("ShaderNodeBsdfTransparent", {}).outputs[0], shader)
    tree.links.new(shader, old.outputs[0].links[0].to_socket)
    tree.nodes.remove(old)


def principled(graph, inputs, distribution):
    return graph.node("ShaderNodeBsdfPrincipled", inputs, distribution=distribution).outputs[0]


def dielectric(graph, colour, roughness, cosine, normal, albedos):
    """A specular lobe, and a Lambertian one that receives what the former leaves.

    The lobe scatters once: a dielectric scatters hardly any light more often, and with MULTI_GGX, whose probability density
    Cycles only estimates, the sum of both lobes would be brighter than their pictures together.
    """
    place = graph.node("ShaderNodeCombineXYZ", {index: graph.math("MULTIPLY_ADD", value, 1 - 1 / SIDE, 0.5 / SIDE)
                                                for index, value in enumerate((graph.math("ABSOLUTE", cosine), roughness))}).outputs[0]
    albedo = graph.node("ShaderNodeTexImage", {0: place}, image=albedos, extension="EXTEND").outputs["Color"]
    rest = graph.math("SUBTRACT", 1.0, albedo)
    diffuse = graph.node("ShaderNodeBsdfDiffuse", {"Color": graph.scaled(colour, rest)} | normal).outputs[0]
    return graph.add(diffuse, principled(graph, {"Base Color": (0, 0, 0, 1), "Roughness": roughness} | normal, "GGX"))


def coated(graph, base, weight, roughness, cosine):
    """KHR_materials_clearcoat: Fresnel's reflectance for the cosine to the normal, of GGX."""
    grazing = graph.math("POWER", graph.math("SUBTRACT", 1.0, graph.math("ABSOLUTE", cosine)), 5.0)
    fresnel = graph.math("MULTIPLY", weight, graph.math("MULTIPLY_ADD", grazing, 1 - F0, F0))
    coat = graph.node("ShaderNodeBsdfGlossy", {"Color": (1, 1, 1, 1), "Roughness": roughness}, distribution="MULTI_GGX").outputs[0]
    return graph.mix(fresnel, base, coat)
