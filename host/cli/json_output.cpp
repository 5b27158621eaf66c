// Writes JSON to a file or to stdout.
#include "host/cli/json_output.h"

#include <nlohmann/json.hpp>

#include "host/cli/text_output.h"

namespace candela::cli {

void writeJson(const std::string& target, const nlohmann::ordered_json& json) {
  if (target.empty()) return;
  // File names and driver names may contain any bytes; invalid UTF-8 becomes U+FFFD instead of an exception.
  const std::string text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  writeText(target, text);
}

}  // namespace candela::cli
