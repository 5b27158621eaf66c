// Reads the JSON report of `candela doctor`.
#pragma once
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

namespace candela {

/// Returns the check of that name. The test fails if there is none.
inline nlohmann::json checkNamed(const nlohmann::json& report, const std::string& name) {
  for (const nlohmann::json& check : report["checks"]) {
    if (check["name"] == name) return check;
  }
  FAIL("no check " << name << " in " << report.dump());
  return {};
}

}  // namespace candela
