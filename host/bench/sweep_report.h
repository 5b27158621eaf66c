// The benchmark of whole renders: scenes and variants of the settings, as text, Markdown, JSON and a chart.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/bench/measure.h"

namespace candela::bench {

struct SweepRow {
  std::string scene;
  std::uint64_t sceneHash = 0;
  Measurement measurement;
};

struct SweepReport {
  std::uint32_t repeats = 1;
  std::uint64_t processBytes = 0;  ///< peak resident memory of the process
  std::vector<SweepRow> rows;      ///< the rows of one scene are consecutive

  /// Returns whether all variants of each image gave the same film.
  bool agree() const;
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
