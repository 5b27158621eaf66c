// Writes JSON to a file or to stdout.
#include "host/app/cli/json_output.h"

#include "host/app/cli/text_output.h"
#include "host/base/json_text.h"

namespace candela::cli {

void writeJson(const std::string& target, const nlohmann::ordered_json& json) {
  if (target.empty()) return;
  writeText(target, jsonText(json, 2) + "\n");
}

}  // namespace candela::cli
