// The comparison of search structures: scenes by structures, as text, Markdown and JSON.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/bench/measure.h"

namespace candela::bench {

/// One structure on one scene.
struct StructureRow {
  std::string scene;
  std::uint64_t sceneHash = 0;
  Measurement measurement;
  std::optional<double> publishedSeconds;  ///< what somebody else's table says of the same work
};

struct StructureReport {
  std::uint32_t repeats = 1;
  std::vector<StructureRow> rows;

  /// Whether every structure of a scene gave the same image.
  bool agree() const;
};

/// The report's own structures: a uniform grid, a BVH split at the middle, and beside them one split by surface area.
std::vector<Variant> structureVariants(const render::RenderSettings& settings);

/// A row whose image differs from the others' has no figures but the word "differs".
std::string toText(const StructureReport& report);
std::string toMarkdown(const StructureReport& report);
/// "schema": "candela-bench/1".
nlohmann::ordered_json toJson(const StructureReport& report);

}  // namespace candela::bench
