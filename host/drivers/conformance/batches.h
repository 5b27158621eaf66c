// Divides cases among child processes.
#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "host/drivers/conformance/case.h"

namespace candela::conformance {

/// The cases of one child process, in the order in which they run.
struct Batch {
  std::vector<const Case*> cases;
  bool isSecondAttempt = false;
};

/// Returns one batch for each group. The order of groups and of the cases within each is that of `cases`, or one that
/// the seed `shuffle` determines.
std::deque<Batch> divide(const std::vector<const Case*>& cases, std::optional<std::uint32_t> shuffle);

}  // namespace candela::conformance
