// One line of a diagnosis.
#pragma once
#include <string>
#include <vector>

namespace candela::doctor {

/// `warning`: a render works, but worse than it could. `problem`: a render does not work, or its picture is wrong.
enum class Status { ok, warning, problem };

constexpr const char* nameOf(Status status) {
  return status == Status::ok ? "ok" : status == Status::warning ? "warning" : "problem";
}

struct Check {
  std::string name;  ///< of the part that was examined, e.g. "driver lvp_icd.x86_64.json"
  Status status = Status::ok;
  std::string text;    ///< the finding, in one line
  std::string remedy;  ///< how to fix it; empty if and only if the status is `ok`
};

using Checks = std::vector<Check>;

}  // namespace candela::doctor
