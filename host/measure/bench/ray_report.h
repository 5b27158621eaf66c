// The benchmark of rays: scenes, kinds of rays and layouts, as text, Markdown and JSON.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/measure/bench/measure_rays.h"

namespace candela::bench {

struct RayRow {
  std::string scene;
  std::uint64_t sceneHash = 0;
  std::string tracer;                            ///< "bvh2", "cwbvh", "list" or the name of another tracer
  std::optional<render::SceneLoads> sceneLoads;  ///< absent for another tracer
  std::uint64_t sceneBytes = 0;  ///< size of nodes, primitives and all other data of the scene; 0 for another tracer
  RayMeasurement measurement;
  double minEqualFraction = 1;  ///< minimum fraction of equal hits for which the figures are valid
};

struct RayReport {
  std::string device;
  std::string driver;
  render::Extent workgroup{};
  render::Extent size{};
  std::uint32_t repeats = 1;
  std::vector<RayRow> rows;

  /// Returns whether every layout of a scene gave the same hits, bit for bit.
  bool agree() const;
};

/// A row with different hits shows the word "differs" instead of figures.
std::string toText(const RayReport& report);
std::string toMarkdown(const RayReport& report);
/// The schema is kBenchSchema.
nlohmann::ordered_json toJson(const RayReport& report);

}  // namespace candela::bench
