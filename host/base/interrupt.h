// Turns Ctrl-C into a flag, so that results computed so far can be written.
#pragma once
#include <atomic>

namespace candela {

/// From this call on, SIGINT (Ctrl-C), SIGTERM and SIGHUP set the returned flag instead of ending the program; SIGHUP
/// stays ignored if it was (nohup). A signal of the same kind that comes a second or more after the first ends the
/// program at once, even if it hangs. Until then it is taken for a copy of the first.
///
/// SIGXCPU (the limit of processor time is reached: `ulimit -t`, or a scheduler's) sets the flag, too, any number of
/// times. If the soft limit is not below the hard limit, at which the kernel kills the process, it is lowered by 10 %,
/// or by 5 s per processor if that is less.
const std::atomic<bool>& watchInterrupts();

/// Returns whether SIGXCPU has come since watchInterrupts().
bool isProcessorTimeUp();

/// From this call on, SIGUSR1 sets the returned flag, every time, instead of ending the program.
std::atomic<bool>& watchWriteRequests();

}  // namespace candela
