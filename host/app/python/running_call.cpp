// Keeps the interpreter alive until the calls that run without the GIL have stopped.
#include "host/app/python/running_call.h"

#include <chrono>
#include <optional>
#include <set>
#include <thread>

namespace candela::python {
namespace {

namespace py = pybind11;

/// The calls of this process. The GIL protects the members.
struct Calls {
  std::set<RunningCall*> running;
  std::optional<unsigned long> exiting;  ///< the thread that ends the interpreter
};

Calls& calls() {
  static Calls calls;
  return calls;
}

// Asks all calls to stop, and waits until they have ended. Ctrl-C ends the wait.
void stopAndWait() {
  constexpr std::chrono::milliseconds kPeriod{5};
  calls().exiting = PyThread_get_thread_ident();
  for (RunningCall* const call : calls().running) call->stop.store(true);
  while (!calls().running.empty()) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    const py::gil_scoped_release released;
    std::this_thread::sleep_for(kPeriod);
  }
}

// A child has no other threads than the one that called fork().
void forgetAll() { calls() = {}; }

}  // namespace

RunningCall::RunningCall() {
  requireInterpreter();
  calls().running.insert(this);
}

RunningCall::~RunningCall() { calls().running.erase(this); }

void RunningCall::requireInterpreter() {
  if (!calls().exiting || calls().exiting == PyThread_get_thread_ident()) return;
  PyErr_SetNone(PyExc_SystemExit);
  throw py::error_already_set();
}

void waitForCallsAtExit() {
  py::module_::import("atexit").attr("register")(py::cpp_function(&stopAndWait));
  py::module_::import("os").attr("register_at_fork")(py::arg("after_in_child") = py::cpp_function(&forgetAll));
}

}  // namespace candela::python
