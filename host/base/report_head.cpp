// Makes the head of JSON documents.
#include "host/base/report_head.h"

#include <nlohmann/json.hpp>

#include "host/base/version.h"

namespace candela {

nlohmann::ordered_json reportHead(const std::string& schema) {
  return {{"schema", schema}, {"version", versionText()}};
}

}  // namespace candela
