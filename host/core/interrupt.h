// Turns Ctrl-C into a flag, so that results computed so far can be written.
#pragma once
#include <atomic>

namespace candela {

/// From this call on, SIGINT (Ctrl-C), SIGTERM and SIGHUP set the returned flag instead of ending the program; SIGHUP
/// stays ignored if it was (nohup). A signal of the same kind that comes a second or more after the first ends the
/// program at once, even if it hangs. Until then it is taken for a copy of the first.
const std::atomic<bool>& watchInterrupts();

/// From this call on, SIGUSR1 sets the returned flag, every time, instead of ending the program.
std::atomic<bool>& watchWriteRequests();

}  // namespace candela
