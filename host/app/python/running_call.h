// Calls that are running when the interpreter exits.
#pragma once
#include <pybind11/pybind11.h>

#include <atomic>

namespace candela::python {

/// A call that works without the GIL or calls Python. At exit, the interpreter asks all of them to stop and waits for
/// their ends, because it may end a daemon thread wherever that waits for the GIL, and frames of C++ must not be
/// unwound there. It is made and destroyed with the GIL.
class RunningCall {
 public:
  /// Throws as requireInterpreter() does.
  RunningCall();
  ~RunningCall();
  RunningCall(const RunningCall&) = delete;
  RunningCall& operator=(const RunningCall&) = delete;

  /// Raises SystemExit, which ends a thread silently, if the interpreter is exiting and this is not the thread that
  /// ends it.
  static void requireInterpreter();

  std::atomic<bool> stop{false};  ///< true: the result is no longer wanted
};

/// Registers the handler that waits when the interpreter exits.
void waitForCallsAtExit();

}  // namespace candela::python
