// Writes JSON to a file or to stdout.
#include "host/cli/json_output.h"

#include "host/cli/text_output.h"
#include "host/core/json_text.h"

namespace candela::cli {

void writeJson(const std::string& target, const nlohmann::ordered_json& json) {
  if (target.empty()) return;
  writeText(target, jsonText(json, 2) + "\n");
}

}  // namespace candela::cli
