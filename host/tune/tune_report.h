// What tuning measured and chose, as text, Markdown and JSON.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "host/tune/search.h"

namespace candela::tune {

struct TuneReport {
  SearchResult result;
  std::uint32_t repeats = 1;
  std::optional<std::filesystem::path> file;  ///< where the choice was stored

  bool agree() const { return result.agree(); }
};

/// A row for each candidate of each round: milliseconds for each scene, and how many times as fast as what is built in.
/// Below it the choice. A row whose image differs has the word "differs" instead of a score.
std::string toText(const TuneReport& report);
std::string toMarkdown(const TuneReport& report);
/// "schema": "candela-tune-report/1".
nlohmann::ordered_json toJson(const TuneReport& report);

}  // namespace candela::tune
