// The comparison of acceleration structures: scenes and structures, as text, Markdown and JSON.
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
  std::optional<double> publishedSeconds;  ///< seconds published elsewhere for the same work
};

struct StructureReport {
  std::uint32_t repeats = 1;
  std::vector<StructureRow> rows;

  /// Returns whether every structure of a scene gave the same image.
  bool agree() const;
};

/// Returns a uniform grid, a BVH with midpoint splits, and a SAH BVH.
std::vector<Variant> structureVariants(const render::RenderSettings& settings);

/// A row whose image differs from the others shows the word "differs" instead of figures.
std::string toText(const StructureReport& report);
std::string toMarkdown(const StructureReport& report);
/// The schema is kBenchSchema.
nlohmann::ordered_json toJson(const StructureReport& report);

}  // namespace candela::bench
