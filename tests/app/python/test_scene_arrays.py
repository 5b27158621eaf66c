"""Scenes from arrays equal those from files."""
import base64
import json
import struct
import unittest

import numpy

import candela
from support import FolderTest, quad

CAMERA = {"from": (0, 0.5, 4), "at": (0, 0, 0), "up": (0, 1, 0), "angle": 40, "resolution": (24, 20)}


def gltf_of(vertices, faces, materials, lights=(), nodes=()):
    """A glTF file with one mesh, written by hand."""
    positions = numpy.asarray(vertices, "<f4")
    indices = numpy.asarray(faces, "<u4").reshape(-1)
    data = positions.tobytes() + indices.tobytes()
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_clearcoat"],
        "extensions": {"KHR_lights_punctual": {"lights": list(lights)}},
        "scene": 0,
        "scenes": [{"nodes": list(range(1 + len(nodes)))}],
        "nodes": [{"mesh": 0}, *nodes],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1, "aspectRatio": 1.5}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": materials,
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(positions), "type": "VEC3",
             "min": positions.min(0).tolist(), "max": positions.max(0).tolist()},
            {"bufferView": 1, "componentType": 5125, "count": len(indices), "type": "SCALAR"},
        ],
        "bufferViews": [{"buffer": 0, "byteLength": positions.nbytes},
                        {"buffer": 0, "byteOffset": positions.nbytes, "byteLength": indices.nbytes}],
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
    }
    return json.dumps(document)


def hash_of(scene, **options):
    return candela.render(scene, spp=16, size=(24, 20), device="cpu", **options).hash


class SceneArrays(FolderTest):
    def load_text(self, name, text):
        (self.folder / name).write_text(text)
        return candela.load(self.folder / name)

    def test_the_film_of_a_file(self):
        vertices, faces = quad()
        vertices = numpy.array(vertices) * [1.5, 1, 1] + [0.1, 0.2, 0.3]
        material = {"pbrMetallicRoughness": {"baseColorFactor": [0.7, 0.2, 0.1, 1], "metallicFactor": 0.25, "roughnessFactor": 0.3},
                    "emissiveFactor": [0.5, 0.25, 0.75],
                    "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 2},
                                   "KHR_materials_clearcoat": {"clearcoatFactor": 0.5, "clearcoatRoughnessFactor": 0.1}}}
        lights = [{"type": "point", "color": [3, 2, 1]}]
        nodes = [{"translation": [1, 2, 3], "extensions": {"KHR_lights_punctual": {"light": 0}}}]
        of_file = self.load_text("a.gltf", gltf_of(vertices, faces, [material], lights, nodes))
        of_arrays = candela.Scene(
            vertices, faces,
            [{"base_colour": (0.7, 0.2, 0.1), "metallic": 0.25, "roughness": 0.3, "emission": (1, 0.5, 1.5), "clearcoat": 0.5,
              "clearcoat_roughness": 0.1}],
            lights=[{"kind": "point", "position": (1, 2, 3), "intensity": (3, 2, 1)}])
        self.assertEqual(hash_of(of_arrays), hash_of(of_file))

    def test_the_view_of_a_file(self):
        """Only emitters, and only camera rays: P3F and arrays then agree whatever their materials are."""
        text = ("v\nfrom 0 0.5 4\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 24 20\naperture 2\nfocal 1.5\n"
                "f 0 0 0 0 0 0 0 0 1 0 0 0.5 0.25 0.125\np 3\n-1 -1 0\n1 -1 0\n1 1 0\np 3\n-1 -1 0\n1 1 0\n-1 1 0\n")
        of_file = self.load_text("a.p3f", text)
        vertices, faces = quad()
        given = {"vertices": vertices, "faces": faces, "materials": [{"emission": (0.5, 0.25, 0.125), "double_sided": True}]}
        of_arrays = candela.Scene(**given, camera={**CAMERA, "aperture": 2, "focal": 1.5})
        self.assertEqual(of_arrays.report["camera"], of_file.report["camera"])
        self.assertEqual(hash_of(of_arrays, max_depth=1), hash_of(of_file, max_depth=1))
        for other in ({"aperture": 0}, {"aperture": 2, "focal": 2}, {"angle": 30}, {"orthographic_height": 3}):
            scene = candela.Scene(**given, camera={**CAMERA, **other})
            self.assertNotEqual(hash_of(scene, max_depth=1), hash_of(of_file, max_depth=1))
            self.assertNotEqual(scene.hash, of_arrays.hash, "other cameras make other scenes")

    def test_faces_have_their_materials_and_their_order(self):
        below, above = quad(0)[0], quad(1)[0]
        faces = [[0, 1, 2], [4, 5, 6], [0, 2, 3], [4, 6, 7]]
        scene = candela.Scene(below + above, faces, [{"emission": (1, 0, 0)}, {"emission": (0, 2, 0)}], [0, 1, 0, 1],
                              camera={**CAMERA, "from": (0, 0, 9), "angle": 5})
        image = candela.render(scene, spp=1, device="cpu").image
        self.assertTrue((image[..., 1] == 2).all() and (image[..., 0] == 0).all())
        ids = candela.render(scene, spp=0, device="cpu", integrator="id").image.reshape(-1, 3)
        self.assertEqual(len(numpy.unique(ids, axis=0)), 2)

    def test_emission_is_exact(self):
        for emission in ((0.1, 0.2, 0.3), (1e-6, 7.3, 1000.1), (0, 0, 1)):
            scene = candela.Scene(*quad(), [{"emission": emission}], camera={**CAMERA, "from": (0, 0, 9), "angle": 5})
            image = candela.render(scene, spp=1, device="cpu", max_depth=1).image
            numpy.testing.assert_allclose(image[10, 10], numpy.float32(emission), rtol=0, atol=2**-40)

    def test_lights(self):
        vertices, faces = quad()
        for light in ({"kind": "spot", "position": (0, 0, 3), "inner": 5, "outer": 15, "intensity": (9, 9, 9)},
                      {"kind": "directional", "direction": (0, -1, -1), "intensity": (1, 2, 3)}):
            scene = candela.Scene(vertices, faces, [{"metallic": 0}], lights=[light], camera=CAMERA)
            image = candela.render(scene, spp=4, device="cpu").image
            self.assertGreater(image[10, 12].sum(), 0.1)
        # Lambert's law, with only the diffuse part: the irradiance is cos 45 degrees times the intensity.
        matte = {"metallic": 0, "specular": 0, "base_colour": (0.5, 0.5, 0.5)}
        scene = candela.Scene(vertices, faces, [matte], lights=[light], camera={**CAMERA, "from": (0, 0, 4)})
        pixel = candela.render(scene, spp=1, device="cpu").image[10, 12]
        numpy.testing.assert_allclose(pixel, numpy.array([1, 2, 3]) * 0.5 / numpy.pi * 0.5**0.5, rtol=1e-5)

    def test_without_light_and_camera(self):
        scene = candela.Scene(*quad())
        self.assertGreater(candela.render(scene, spp=1, size=(9, 9), device="cpu").image[4, 4].min(), 0.1)
        dark = candela.Scene(*quad(), env="white", env_scale=0)
        self.assertEqual(candela.render(dark, spp=1, size=(9, 9), device="cpu").image.max(), 0)

    def test_attributes(self):
        vertices, faces = quad()
        tilted = numpy.tile(numpy.array([0.6, 0, 0.8]), (4, 1))
        light = [{"kind": "directional", "direction": (0, 0, -1)}]
        matte = [{"metallic": 0, "specular": 0}]
        camera = {**CAMERA, "from": (0, 0, 4)}
        flat, smooth = (candela.render(candela.Scene(vertices, faces, matte, lights=light, camera=camera, **given), spp=1,
                                       device="cpu", max_depth=2).image[10, 12] for given in ({}, {"normals": tilted}))
        numpy.testing.assert_allclose(smooth / flat, 0.8, rtol=1e-4)
        coloured = candela.Scene(vertices, faces, matte, lights=light, camera=camera, colours=[[0.5, 0.25, 1, 1]] * 4)
        numpy.testing.assert_allclose(candela.render(coloured, spp=1, device="cpu").image[10, 12] / flat, [0.5, 0.25, 1], rtol=1e-5)

    def test_the_length_of_a_direction_has_no_effect(self):
        def hash_with(length, up):
            light = {"kind": "spot", "position": (0, 0, 3), "direction": (0, 0, -length), "outer": 30, "intensity": (9, 9, 9)}
            return hash_of(candela.Scene(*quad(), [{"metallic": 0}], lights=[light], camera={**CAMERA, "up": (0, up, 0)}))

        for length, up in ((1e-200, 1), (5e-324, 1), (1e30, 1), (1, 1e-12), (1, 1e12)):
            self.assertEqual(hash_with(length, up), hash_with(1, 1), (length, up))

    def test_none_omits_an_argument(self):
        omitted = candela.Scene(*quad(), materials=None, face_materials=None, normals=None, lights=None, camera=None)
        self.assertEqual(omitted.hash, candela.Scene(*quad()).hash)

    def test_mistakes(self):
        vertices, faces = quad()
        good = {"vertices": vertices, "faces": faces}
        mistakes = [
            ({"vertices": [[0, 0]]}, r"vertices: expected an array of shape \(n, 3\), got \(1, 2\)"),
            ({"vertices": "abc"}, "vertices: "),
            ({"vertices": [[0, 0, numpy.inf]] * 4}, "vertices: a number is not finite"),
            ({"vertices": [[0, 0, 1e300]] * 4}, "vertices: a number is not finite in single precision"),
            ({"faces": [[0, 1, 4]]}, "faces: index 4 is outside 0 to 3"),
            ({"faces": [[0, 1, -1]]}, "faces: index -1 is outside 0 to 3"),
            ({"faces": [[0, 1, 2.0]]}, "faces: expected whole numbers, got float64"),
            ({"faces": []}, "faces: expected an array of shape"),
            ({"face_materials": [0]}, "face_materials: expected 2 indices, one for each face, got 1"),
            ({"face_materials": [0, 1]}, "face_materials: index 1 is outside 0 to 0"),
            ({"materials": [{"rougness": 1}]}, r"materials\[0\]: unknown entry 'rougness'; the entries are base_colour,"),
            ({"materials": [{"emission": (1, -1, 1)}]}, r"materials\[0\]: emission: expected numbers from 0"),
            ({"materials": [{"roughness": "x"}]}, r"materials\[0\]: roughness: expected a finite number, got 'x'"),
            ({"materials": [{"alpha_cutoff": 1}]}, "alpha_cutoff has no effect without alpha"),
            ({"lights": [{"kind": "area"}]}, r"lights\[0\]: kind: expected 'point', 'spot' or 'directional', got 'area'"),
            ({"lights": [{"kind": "spot", "direction": (0, 0, 0)}]}, "direction is the zero vector"),
            ({"camera": {"from": (0, 0, 0), "at": (0, 0, 0)}}, "camera: from and at are the same point"),
            ({"camera": {"from": (0, 0, 0)}}, "camera: at: expected 3 finite numbers, got None"),
            ({"camera": {**CAMERA, "up": (0, 0.5, 4)}}, "camera: up is the zero vector, or parallel"),
            ({"camera": {**CAMERA, "angle": 180}}, "camera: angle: expected degrees between 0 and 180, got 180"),
            ({"camera": {**CAMERA, "resolution": (0, 5)}}, "camera: resolution: expected two whole numbers from 1 to 65535"),
            ({"camera": {**CAMERA, "zoom": 2}}, "camera: unknown entry 'zoom'"),
            ({"normals": [[0, 0, 1]]}, "normals: expected 4 rows, as many as vertices, got 1"),
            ({"camera": {"from": (0, 0, 1e-170), "at": (0, 0, 0)}}, "camera: from and at are the same point in single precision"),
            ({"camera": {"from": (0, 0, 1e200), "at": (0, 0, 0)}}, "camera: from: a number is not finite in single precision"),
            ({"camera": {**CAMERA, "up": (1e-170, 0, 0)}}, "camera: up is the zero vector"),
            ({"camera": {**CAMERA, "up": (0, 1e-30, 8e-30)}}, "camera: up is the zero vector, or parallel"),
            ({"camera": 3}, "camera: expected a dict, got 3"),
            ({"lights": {"kind": "point"}}, "lights: expected a list of dicts, got {'kind': 'point'}"),
            ({"lights": 3}, "lights: expected a list of dicts, got 3"),
            ({"lights": ["point"]}, r"lights\[0\]: expected a dict, got 'point'"),
            ({"materials": [1]}, r"materials\[0\]: expected a dict, got 1"),
            ({"materials": {"roughness": 1}}, "materials: expected a list of dicts, got {'roughness': 1}"),
            ({"materials": [{"unlit": numpy.zeros(2)}]}, r"materials\[0\]: unlit: expected True or False, got array"),
            ({"name": None}, "name: expected a text, got None"),
            ({"name": "\udcff"}, "name: expected a text, got '.udcff'"),
            ({"spp": 4}, r"spp is not an option of candela.Scene\(\)"),
        ]
        for change, text in mistakes:
            with self.subTest(text):
                with self.assertRaisesRegex(candela.UsageError, text):
                    candela.Scene(**{**good, **change})
        for change, text in (({"materials": [{"roughness": 2}]}, "scene: /materials/0/pbrMetallicRoughness/roughnessFactor: 2 is outside 0 to 1"),
                             ({"lights": [{"kind": "spot", "outer": 0}]}, "the angles of the cones are not inner >= 0 and 1e-6 <= outer")):
            with self.assertRaisesRegex(candela.SceneError, text):
                candela.Scene(**{**good, **change})


if __name__ == "__main__":
    unittest.main()
