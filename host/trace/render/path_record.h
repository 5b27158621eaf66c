// The decisions of a path (or of a tree of rays, in the order of its nodes) at each of its first vertices, for the
// comparison of two tracers.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "lists/lobes.h"

namespace candela::render {

/// The entries of CANDELA_LOBES, with their values.
enum class Lobe : std::uint8_t {
#define CANDELA_ENUMERATE_LOBE(lobe, name, value) lobe = value,
  CANDELA_LOBES(CANDELA_ENUMERATE_LOBE)
#undef CANDELA_ENUMERATE_LOBE
};
enum class ShadowOutcome : std::uint8_t { notTraced, visible, occluded };

/// One path vertex. `primitive` is the index in Scene::primitives, or kMiss.
struct VertexRecord {
  static constexpr std::uint32_t kMiss = 0xffffffffu;
  static constexpr std::uint32_t kRecordedLights = 14;
  std::uint32_t primitive = kMiss;
  Lobe lobe = Lobe::none;  ///< by which the path continued; none: it ended before the choice
  ShadowOutcome shadow = ShadowOutcome::notTraced;
  bool survivedRoulette = true;  ///< false only where roulette ended the path
  /// Whitted tracer: bit i mod kRecordedLights flips for every point light i that illuminates the vertex; `shadow` is
  /// then `occluded` if any light is.
  std::uint16_t visibleLights = 0;
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

/// Records the decisions of paths while a session advances: Session::recorder().
class PathRecorder {
 public:
  /// Returns the records so far; a pixel without samples has no vertices. Throws as Session::film() does if the device
  /// fails.
  virtual PathRecords paths() = 0;

 protected:
  ~PathRecorder() = default;
};

}  // namespace candela::render
