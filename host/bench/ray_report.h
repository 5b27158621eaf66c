// The benchmark of rays alone: scenes by kinds of rays by layouts, as text, Markdown and JSON.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/bench/measure_rays.h"

namespace candela::bench {

struct RayRow {
  std::string scene;
  std::uint64_t sceneHash = 0;
  std::string tracer;            ///< "bvh2", "cwbvh", "none" or a peer's name
  std::string sceneLoads;        ///< "texel" or "storage"; empty of a peer
  std::uint64_t sceneBytes = 0;  ///< of nodes, primitives and all else of the scene; 0 of a peer
  RayMeasurement measurement;
  double leastShare = 1;  ///< of equal hits, for which its figures count
};

struct RayReport {
  std::string device;
  std::string driver;
  render::Extent workgroup{};
  render::Extent size{};
  std::uint32_t repeats = 1;
  std::vector<RayRow> rows;

  /// Whether every layout of a scene found the same hits, bit for bit.
  bool agree() const;
};

/// A row whose hits differ from the others' has no figures but the word "differs".
std::string toText(const RayReport& report);
std::string toMarkdown(const RayReport& report);
/// "schema": "candela-bench/1".
nlohmann::ordered_json toJson(const RayReport& report);

}  // namespace candela::bench
