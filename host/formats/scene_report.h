// A description of the content of a scene, as text and as JSON.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/formats/loading/load.h"
#include "host/scene/bounds.h"
#include "host/scene/coincidence/coincident_objects.h"
#include "host/scene/memory.h"

namespace candela::scene {

struct SceneReport {
  /// Primitives as traced: polygons, patches, meshes and emitting boxes have become triangles.
  struct Primitives {
    std::uint64_t spheres = 0, triangles = 0, boxes = 0, cones = 0, planes = 0;
    std::uint64_t total() const { return spheres + triangles + boxes + cones + planes; }
  };
  /// Emitting primitives by kind, and lights without extent: point (with and without fall-off), spot and directional.
  struct Lights {
    std::uint64_t spheres = 0, triangles = 0, cones = 0, planes = 0, points = 0, spots = 0, directionals = 0;
    std::uint64_t total() const { return spheres + triangles + cones + planes + points + spots + directionals; }
  };
  /// By kindOf(); `emitting` counts across the kinds.
  struct Materials {
    std::uint64_t diffuse = 0, glossy = 0, mirror = 0, dielectric = 0, mixture = 0, surface = 0, black = 0,
                  emitting = 0;
    std::uint64_t total() const { return diffuse + glossy + mirror + dielectric + mixture + surface + black; }
  };

  std::string name;
  StatementCounts statements;  ///< numbers of statements in the file
  FileFacts facts;             ///< further properties that the loader reports
  Primitives primitives;
  std::optional<Bounds> bounds;  ///< as boundsOf() returns them
  Lights lights;
  Materials materials;
  CoincidenceReport coincident;
  std::optional<Camera> camera;
  glm::vec3 background{0, 0, 0};
  std::optional<std::uint32_t> skySide;  ///< maximum side of a face of the sky box, in texels
  std::uint32_t filmScale = 0;           ///< as filmScaleOf() returns it
  std::optional<RequestedAccel> requestedAccel;
  std::optional<std::uint32_t> requestedSamples;
  std::optional<std::uint32_t> requestedMaxDepth;
  std::optional<PixelFilter> requestedFilter;
  std::optional<Window> requestedCrop;
  std::uint64_t hash = 0;
  SceneMemory memory;
  std::vector<std::string> warnings;
};

SceneReport makeReport(const LoadedScene& loaded);
/// Returns several lines, each ending in a newline.
std::string toText(const SceneReport& report);
nlohmann::json toJson(const SceneReport& report);

}  // namespace candela::scene
