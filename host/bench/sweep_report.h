// The benchmark of whole renders: scenes by variants of the settings, as text, Markdown, JSON and a drawing.
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
  std::uint64_t processBytes = 0;  ///< resident memory of the process at its peak
  std::vector<SweepRow> rows;      ///< those of one scene follow each other

  /// Whether all variants of each image gave the same film.
  bool agree() const;
};

/// A table, and below it one line for each scene, to be pasted where people compare figures. A row whose film differs
/// has no figures but the word "differs".
std::string toText(const SweepReport& report);
std::string toMarkdown(const SweepReport& report);
/// "schema": "candela-bench/1".
nlohmann::ordered_json toJson(const SweepReport& report);
/// Bars of samples per second, as SVG.
std::string toSvg(const SweepReport& report);

}  // namespace candela::bench
