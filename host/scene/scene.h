// The scene as the file states it: values and indices, no pointers, nothing precomputed. Both tracers start from it.
// All numbers are binary32, each rounded once from its decimal notation.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/environment.h"
#include "host/scene/extent.h"
#include "host/scene/material.h"
#include "host/scene/mesh.h"
#include "host/scene/pixel_filter.h"
#include "host/scene/placement.h"
#include "host/scene/primitive_list.h"

namespace candela::scene {

/// The acceleration structure that a file requests, in the order of its numbers in the statement `accel`.
enum class RequestedAccel : std::uint8_t { none, grid, bvh };
inline constexpr std::array<const char*, 3> kRequestedAccelNames{"none", "grid", "bvh"};

/// The view, as in NFF. The view plane passes through `at`.
struct Camera {
  glm::vec3 from{0, 0, 1};
  glm::vec3 at{0, 0, 0};
  glm::vec3 up{0, 1, 0};
  float angle = 45;           ///< vertical field of view, degrees, in (0, 180); not of an orthographic camera
  float hither = 0;           ///< parsed and stored; neither tracer clips by it
  std::uint32_t width = 512;  ///< `resolution`, pixels, in [1, 65535]
  std::uint32_t height = 512;
  float aperture = 0;  ///< lens radius in pixels of the view plane at this resolution; 0: pinhole
  float focal = 1;     ///< distance of the plane in focus, as a multiple of |from - at|
  /// Height of the view of an orthographic camera, > 0, in units of the scene; absent: a perspective camera. Its rays
  /// start on the plane through `from` that is parallel to the view plane.
  std::optional<float> orthographicHeight;
  /// The centre of the view is right of `at` by x times the width of the view, and below it by y times the height.
  glm::vec2 shift{0, 0};
  bool isMirrored = false;  ///< left and right of the picture are exchanged, also in `shift`

  bool operator==(const Camera&) const = default;
};

/// Radius < 0: the surface is seen from inside only and its normal points to the centre.
struct Sphere {
  glm::vec3 centre;
  float radius;

  bool operator==(const Sphere&) const = default;
};

/// Axis-aligned, min <= max on each axis (equal: a flat box, allowed).
struct Box {
  glm::vec3 min;
  glm::vec3 max;

  bool operator==(const Box&) const = default;
};

/// The lateral surface of a truncated cone between two circles, without caps; a cylinder if the radii are equal. base
/// != apex; radii >= 0, not both 0.
struct Cone {
  glm::vec3 base;
  float baseRadius;
  glm::vec3 apex;
  float apexRadius;

  bool operator==(const Cone&) const = default;
};

/// Infinite plane through three points that are not collinear, normal (p1 - p0) x (p2 - p0).
struct Plane {
  glm::vec3 p[3];

  bool operator==(const Plane&) const = default;
};

/// `l`: a point light without fall-off, see docs/light-transport.md.
struct PointLight {
  glm::vec3 position;
  glm::vec3 colour{1, 1, 1};

  bool operator==(const PointLight&) const = default;
};

/// glTF's lights: docs/light-transport.md. Point and spot lights fall off with the square of the distance, directional
/// lights are infinitely far away.
struct PunctualLight {
  enum class Kind : std::uint8_t { point, spot, directional };

  Kind kind = Kind::point;
  glm::vec3 position{0, 0, 0};    ///< not of a directional light
  glm::vec3 direction{0, 0, -1};  ///< unit vector along which a spot or directional light shines
  /// Radiant intensity, W/sr; of a directional light the irradiance of a surface that faces it, W/m^2. >= 0.
  glm::vec3 intensity{1, 1, 1};
  /// A spot light has its full intensity within the inner angle from its direction, and none beyond the outer one. Both
  /// are given as 1 - cos, because cosines close to 1 do not distinguish small angles. 0 <= inner < outer.
  float versineInner = 0;
  float versineOuter = 1;
  float reach = 1;  ///< of a directional light: distance of a point light that would be as bright, for its choice

  bool operator==(const PunctualLight&) const = default;
};

/// One face of the sky box: 8-bit sRGB, row 0 at the top, 3 bytes per texel.
struct SkyFace {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgb;

  bool operator==(const SkyFace&) const = default;
};

/// Faces in this order: right (+X), left (-X), top (+Y), bottom (-Y), front (+Z), back (-Z).
struct Sky {
  SkyFace faces[6];

  bool operator==(const Sky&) const = default;
};

/// The known mean of the image, or of a part of it: a comment "# exact-mean: r g b [x y width height]".
struct ExactMean {
  glm::vec3 rgb;
  glm::vec4 area{0, 0, 1, 1};  ///< x, y, width, height as fractions of the image, inside [0, 1]

  bool operator==(const ExactMean&) const = default;
};

struct Scene {
  std::string name;  ///< file name without folder, for reports
  std::optional<Camera> camera;
  glm::vec3 background{0, 0, 0};
  std::optional<Sky> sky;                  ///< replaces the background
  std::optional<Environment> environment;  ///< replaces background and sky
  glm::vec3 up{0, 1, 0};  ///< signed coordinate axis that points up, for the placement of an environment

  std::vector<Material> materials;
  std::vector<TextureImage> images;
  PrimitiveList primitives;
  std::vector<Sphere> spheres;
  std::vector<Mesh> meshes;  ///< at most Primitive::kMaxMeshes
  /// Placements of instances. The mesh of an instance that is mirrored has triangles and tangents of the other
  /// orientation, so that fronts stay fronts.
  std::vector<Placement> placements;
  std::vector<Box> boxes;
  std::vector<Cone> cones;
  std::vector<Plane> planes;
  /// The first primitive of each object, rising; the objects divide all primitives. An object is a statement of NFF or
  /// a node of glTF, see object_names.h.
  std::vector<std::uint32_t> objectStarts;
  std::vector<std::string> objectNames;    ///< one for each object; empty: the format has no names
  std::vector<std::string> materialNames;  ///< one for each material; empty: the format has no names
  std::vector<PointLight> pointLights;
  std::vector<PunctualLight> punctualLights;

  std::optional<RequestedAccel> requestedAccel;    ///< `accel`
  std::optional<std::uint32_t> requestedSamples;   ///< `spp`, samples per pixel in total; 0: no antialiasing
  std::optional<std::uint32_t> requestedMaxDepth;  ///< maximum number of rays in a path, counting the camera ray, >= 1
  std::optional<PixelFilter> requestedFilter;
  std::optional<Window> requestedCrop;  ///< the pixels of a picture, within the resolution of the camera
  std::optional<ExactMean> exactMean;   ///< for paths of any length, with and without next-event estimation
  std::uint64_t hash = 0;               ///< of everything that was read, sky images included
};

/// Returns the mesh of a primitive that is a triangle.
inline const Mesh& meshOf(const Scene& scene, const Primitive& triangle) { return scene.meshes[triangle.mesh]; }

/// Returns the vertices of a primitive that is a triangle.
inline Triangle triangleOf(const Scene& scene, const Primitive& triangle) {
  const Mesh& mesh = meshOf(scene, triangle);
  const auto [p0, p1, p2] = attributeOf(mesh, mesh.positions, triangle.index);
  if (!triangle.isPlaced()) return {{p0, p1, p2}};
  const Placement& placement = scene.placements[triangle.placement];
  return {{placedPoint(placement, p0), placedPoint(placement, p1), placedPoint(placement, p2)}};
}

/// Tracers copy meshes of fewer triangles, since traversing an instance costs more.
inline constexpr std::uint32_t kMinInstanceTriangles = 64;

/// Returns whether tracers traverse a run of Scene::primitives as an instance, where their structure permits it. They
/// copy small meshes, and emitters, to which lights refer.
inline bool isInstance(const Scene& scene, const PrimitiveRun& run) {
  return run.start.isPlaced() && scene.primitives.countOf(run) >= kMinInstanceTriangles &&
         !isEmissive(scene.materials[run.start.material]);
}

/// Returns whether a run of Scene::primitives is one light of a light tree: docs/light-transport.md section 6.1.
inline bool isEmissiveInstance(const Scene& scene, const PrimitiveRun& run) {
  return run.start.isPlaced() && scene.primitives.countOf(run) >= kMinInstanceTriangles &&
         isEmissive(scene.materials[run.start.material]);
}

/// Returns whether the primitive is a triangle whose vertices have normals.
inline bool isSmooth(const Scene& scene, const Primitive& primitive) {
  return primitive.kind == PrimitiveKind::triangle && !meshOf(scene, primitive).normals.empty();
}

/// Returns whether a predicate is true of a material, which is an index, or of one of those between which it is a
/// choice.
template <class Predicate>
bool anyMaterial(const Scene& scene, std::uint32_t material, const Predicate& predicate) {
  const Material& own = scene.materials[material];
  return predicate(own) || (own.choice && (anyMaterial(scene, own.choice->first, predicate) ||
                                           anyMaterial(scene, own.choice->second, predicate)));
}

/// Returns tangentTextureOf() of a material, which is an index, or of the first one of those between which it is a
/// choice.
inline const std::optional<TextureReference>& tangentTextureOf(const Scene& scene, std::uint32_t material) {
  const auto& choice = scene.materials[material].choice;
  if (!choice) return tangentTextureOf(scene.materials[material]);
  const std::optional<TextureReference>& first = tangentTextureOf(scene, choice->first);
  return first ? first : tangentTextureOf(scene, choice->second);
}

/// Returns whether the primitive is a triangle whose vertices have tangents, and whose material needs them.
inline bool hasTangents(const Scene& scene, const Primitive& primitive) {
  return primitive.kind == PrimitiveKind::triangle && !meshOf(scene, primitive).tangents.empty() &&
         tangentTextureOf(scene, primitive.material).has_value();
}

/// Returns the vertex colours that scale the emission of a primitive; null if there are none.
inline const std::vector<glm::vec4>* coloursOfEmission(const Scene& scene, const Primitive& primitive) {
  if (primitive.kind != PrimitiveKind::triangle || !scene.materials[primitive.material].coloursScaleEmission) {
    return nullptr;
  }
  const std::vector<glm::vec4>& colours = meshOf(scene, primitive).colours;
  return colours.empty() ? nullptr : &colours;
}

/// Returns the vertex normals of a primitive for which isSmooth is true. Those of an instance have any length.
inline VertexNormals vertexNormalsOf(const Scene& scene, const Primitive& triangle) {
  const Mesh& mesh = meshOf(scene, triangle);
  const auto [n0, n1, n2] = attributeOf(mesh, mesh.normals, triangle.index);
  if (!triangle.isPlaced()) return {{n0, n1, n2}};
  const Placement& placement = scene.placements[triangle.placement];
  return {{placedNormal(placement, n0), placedNormal(placement, n1), placedNormal(placement, n2)}};
}

/// Returns the tangents at the vertices of a primitive that is a triangle of a mesh with tangents: a vector, which has
/// unit length unless the triangle belongs to an instance, and the handedness, see Mesh.
inline std::array<glm::vec4, 3> vertexTangentsOf(const Scene& scene, const Primitive& triangle) {
  const Mesh& mesh = meshOf(scene, triangle);
  std::array<glm::vec4, 3> tangents = attributeOf(mesh, mesh.tangents, triangle.index);
  if (!triangle.isPlaced()) return tangents;
  for (glm::vec4& tangent : tangents) tangent = placedTangent(scene.placements[triangle.placement], tangent);
  return tangents;
}

}  // namespace candela::scene
