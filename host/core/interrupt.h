// Turns Ctrl-C into a flag, so that what was computed can be written.
#pragma once
#include <atomic>

namespace candela {

/// From this call on the first SIGINT, and the first SIGTERM, set the flag that is returned instead of ending the
/// program. The second of a kind ends it at once.
const std::atomic<bool>& watchInterrupts();

}  // namespace candela
