// Runs work that may crash or hang in a child process.
#pragma once
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace candela::doctor {

struct ChildResult {
  nlohmann::json answer;    ///< what the work returned; null after a failure
  std::string failure;      ///< predicate of a sentence about the work, e.g. "crashes (Aborted)"; empty: none
  std::string lastMessage;  ///< last line that the work printed on stdout or stderr; may be empty
};

/// Forks, calls `work` in the child, and ends the child after `limit`. An exception of `work` is a failure. Messages of
/// the validation layer in the child are added to those of this process. Call it while this process has one thread.
/// Throws InternalError if no process can be started.
ChildResult runInChild(std::chrono::milliseconds limit, const std::function<nlohmann::json()>& work);

}  // namespace candela::doctor
