// The benchmark of whole renders: scenes and variants of the settings, as text, Markdown, JSON and a chart.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/measure/bench/render_rows.h"

namespace candela::bench {

struct SweepReport : RenderRows {
  std::uint64_t processBytes = 0;  ///< peak resident memory of the process
};

/// Returns a table, followed by one line per scene that is suitable for publication. A row whose film differs shows the
/// word "differs" instead of figures.
std::string toText(const SweepReport& report);
std::string toMarkdown(const SweepReport& report);
/// The schema is kBenchSchema.
nlohmann::ordered_json toJson(const SweepReport& report);
/// Returns a bar chart of samples per second, as SVG.
std::string toSvg(const SweepReport& report);

}  // namespace candela::bench
