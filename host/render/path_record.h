// What a path decided at each of its first vertices, so that two tracers' paths can be held against each other.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace candela {

enum class Lobe : std::uint8_t { none, diffuse, glossy, mirror, reflect, refract };
enum class ShadowOutcome : std::uint8_t { notTraced, visible, occluded };

/// One path vertex. `primitive` is the primitive index (place in Scene::primitives), or kMiss.
struct VertexRecord {
  static constexpr std::uint32_t kMiss = 0xffffffffu;
  std::uint32_t primitive = kMiss;
  Lobe lobe = Lobe::none;                          ///< that continued the path; none: it ended before the choice
  ShadowOutcome shadow = ShadowOutcome::notTraced;
  bool survivedRoulette = true;                    ///< false only where roulette ended the path
  bool operator==(const VertexRecord&) const = default;
};

/// The first kRecordedVertices vertices of one path; `vertexCount` counts those in use.
struct PathRecord {
  static constexpr std::uint32_t kRecordedVertices = 32;
  std::uint32_t vertexCount = 0;
  std::array<VertexRecord, kRecordedVertices> vertices;
};

/// One record per pixel, row by row from the top.
using PathRecords = std::vector<PathRecord>;

}  // namespace candela
