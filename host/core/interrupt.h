// Turns Ctrl-C into a flag, so that results computed so far can be written.
#pragma once
#include <atomic>

namespace candela {

/// From this call on, the first SIGINT and the first SIGTERM set the returned flag instead of ending the program. The
/// second signal of a kind ends the program at once.
const std::atomic<bool>& watchInterrupts();

/// From this call on, SIGUSR1 sets the returned flag, every time, instead of ending the program.
std::atomic<bool>& watchWriteRequests();

}  // namespace candela
