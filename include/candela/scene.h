// Scenes: read from files, or built in memory. Both tracers read the same scene.
//
//   const candela::LoadedScene loaded = candela::loadScene("room.glb");
//   for (const candela::Diagnostic& warning : loaded.warnings) std::cerr << toString(warning) << '\n';
//
// Lengths have the unit of the file (glTF: metres). Colours and radiances are linear RGB with the primaries of Rec.
// 709. Axes are those of the file; Scene::up is the one that points up. All numbers are binary32.
#pragma once
#include "host/formats/load_scene.h"
#include "host/formats/loading/scene_builder.h"
#include "host/scene/scene.h"

namespace candela {

/// The model: a camera (which may be absent), a background, an environment or a sky, primitives, materials, textures
/// and lights, as values and indices. A scene of your own starts empty; append materials to Scene::materials and
/// primitives by the functions below.
using scene::Scene;

using scene::Camera;
using scene::DielectricLobe;
using scene::DiffuseLobe;
using scene::Environment;
using scene::GlossyLobe;
using scene::Material;
using scene::Mesh;
using scene::MirrorLobe;
using scene::PointLight;
using scene::PunctualLight;
using scene::TextureImage;

using scene::Box;
using scene::Cone;
using scene::Plane;
using scene::Sphere;
using scene::Triangle;
using scene::VertexNormals;

/// Functions that append a primitive with a material, which is an index into Scene::materials.
using scene::addBox;
using scene::addCone;
using scene::addMesh;
using scene::addPlane;
using scene::addSphere;
using scene::addTriangle;

/// The choices of a reader: lenient reading, permitted folders, camera, time of an animation (seconds), environment.
using scene::LoadOptions;
/// A scene with the warnings of its file, counts of its statements, and the other files that were read.
using scene::LoadedScene;

/// An error or a warning with its file, line and column (from 1; 0: the whole).
using scene::Diagnostic;
/// Every error of a file at once: a FileError.
using scene::SceneError;

/// Reads glTF, GLB, OBJ, PLY, NFF or P3F, from a file or from memory, by its content. Throws SceneError with every
/// error that was found, and FileError if the file cannot be read or is larger than 1 GiB.
using formats::loadScene;

}  // namespace candela
