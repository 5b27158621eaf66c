// The calling thread waits, and wakes up to run Python's signal handlers and the progress callback.
#include "host/app/python/watched.h"

#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>

#include "host/app/python/running_call.h"
#include "host/base/errors.h"
#include "host/trace/vulkan/unfinished_work.h"
#include "host/trace/vulkan/validation.h"

namespace candela::python {
namespace {

namespace py = pybind11;

/// The state that the two threads share.
class Meeting {
 public:
  std::atomic<bool>& stop() { return call_.stop; }

  void report(double fraction, std::uint64_t samples) {
    const std::scoped_lock lock(mutex_);
    fraction_ = fraction;
    samples_ = samples;
    isNew_ = true;
  }
  void finish(std::exception_ptr failure) {
    const std::scoped_lock lock(mutex_);
    failure_ = std::move(failure);
    isDone_ = true;
    done_.notify_one();
  }
  /// Waits without the GIL for the end of the work, at most until Python must be served again; returns whether the work
  /// has ended.
  bool wait() {
    constexpr std::chrono::milliseconds kPeriod{50};
    const py::gil_scoped_release released;
    std::unique_lock lock(mutex_);
    return done_.wait_for(lock, kPeriod, [this] { return isDone_; });
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }
  /// Calls `progress` if there is a report that it has not had.
  void passOn(const py::object& progress) {
    std::unique_lock lock(mutex_);
    const auto [fraction, samples, isNew] = std::tuple(fraction_, samples_, isNew_);
    isNew_ = false;
    lock.unlock();
    if (isNew && !progress.is_none()) progress(fraction, samples);
  }

 private:
  RunningCall call_;
  std::mutex mutex_;
  std::condition_variable done_;
  std::exception_ptr failure_;
  double fraction_ = 0;
  std::uint64_t samples_ = 0;
  bool isNew_ = false;
  bool isDone_ = false;
};

// Python runs handlers of signals only in its main thread, and only on request.
void lookAfterPython(Meeting& meeting, const py::object& progress) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  meeting.passOn(progress);
}

// Libraries must not be unloaded while threads of a driver still work.
void leaveQuickly() {
  static std::once_flag once;
  std::call_once(once, [] {
    on_exit(
        [](int status, void*) {
          std::fflush(nullptr);
          std::_Exit(status);
        },
        nullptr);
  });
}

// Every message of the validation layer is an error of the program, whatever the result looks like.
void requireValid() {
  const std::vector<std::string> messages = vulkan::validationMessages();
  if (!messages.empty()) throw InternalError(fmt::format("validation: {}", messages.front()));
}

void runAlone(const std::function<void(const Watch&)>& work, Meeting& meeting) {
  std::exception_ptr failure;
  try {
    work({meeting.stop(), [&](double fraction, std::uint64_t samples) { meeting.report(fraction, samples); }});
    requireValid();
  } catch (...) {
    failure = std::current_exception();
  }
  meeting.finish(std::move(failure));
}

}  // namespace

void runWatched(const std::function<void(const Watch&)>& work, const py::object& progress) {
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw py::type_error("progress: expected a callable");
  Meeting meeting;
  std::exception_ptr raised;
  {
    const std::jthread worker([&] { runAlone(work, meeting); });
    while (!meeting.wait()) {
      if (raised) continue;
      try {
        lookAfterPython(meeting, progress);
      } catch (const py::error_already_set&) {
        raised = std::current_exception();
        meeting.stop().store(true);
      }
    }
  }
  if (vulkan::hasUnfinishedWork()) leaveQuickly();
  RunningCall::requireInterpreter();
  if (raised) std::rethrow_exception(raised);
  meeting.rethrow();
  lookAfterPython(meeting, progress);
}

}  // namespace candela::python
