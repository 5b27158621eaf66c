// The comparison of acceleration structures: scenes and structures, as text, Markdown and JSON.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/measure/bench/render_rows.h"

namespace candela::bench {

/// Renders whose variants are the structures of structureVariants().
struct StructureReport : RenderRows {};

/// Returns a uniform grid, a BVH with midpoint splits, and a SAH BVH.
std::vector<Variant> structureVariants(const render::RenderSettings& settings);

/// A row whose image differs from the others shows the word "differs" instead of figures.
std::string toText(const StructureReport& report);
std::string toMarkdown(const StructureReport& report);
/// The schema is kBenchSchema.
nlohmann::ordered_json toJson(const StructureReport& report);

}  // namespace candela::bench
