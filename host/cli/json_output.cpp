// JSON to a file or to stdout.
#include "host/cli/json_output.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <span>

#include "host/core/atomic_file.h"

namespace candela::cli {

void writeJson(const std::string& target, const nlohmann::ordered_json& json) {
  if (target.empty()) return;
  // File names and driver texts may be anything; what is not UTF-8 becomes U+FFFD instead of an exception.
  const std::string text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  if (target == "-") {
    std::cout << text << std::flush;
    return;
  }
  writeFileAtomically(target, std::as_bytes(std::span(text)));
}

}  // namespace candela::cli
