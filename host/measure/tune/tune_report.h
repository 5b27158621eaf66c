// The measurements and the result of tuning, as text, Markdown and JSON.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "host/measure/tune/search.h"

namespace candela::tune {

struct TuneReport {
  SearchResult result;
  std::uint32_t repeats = 1;
  std::optional<std::filesystem::path> file;  ///< where the choice was stored

  bool agree() const { return result.agree(); }
};

/// Returns a row for each candidate of each round, with milliseconds for each scene and the speed relative to the
/// built-in choice, followed by the result. A row whose image differs shows the word "differs" instead of a score.
std::string toText(const TuneReport& report);
std::string toMarkdown(const TuneReport& report);
/// The schema is "candela-tune-report/2".
nlohmann::ordered_json toJson(const TuneReport& report);

}  // namespace candela::tune
