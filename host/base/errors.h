// Expected failures, each with its exit code. They are thrown where they are detected and caught once, in main().
#pragma once
#include <stdexcept>
#include <string>

namespace candela {

/// Exit codes of the program, as docs/command-line.md documents them.
enum class ExitCode : int {
  done = 0,
  usage = 1,
  file = 2,        ///< invalid scene, image or file, or a size beyond the limits
  differ = 3,      ///< the compared images differ, or a verification failed
  noDevice = 4,    ///< no usable Vulkan device
  deviceLost = 5,  ///< the device was lost, hung, or its driver failed
  outOfMemory = 6,
  interrupted = 7,  ///< interrupted; the samples rendered so far are written
  undecided = 8,    ///< a verdict is not decided: rounding, noise or too few renders may hide more than is permitted
  internal = 70,
};

/// Base class of all expected failures. `what()` names the cause and the remedy, without a newline at the end.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

struct UsageError : Error {
  explicit UsageError(const std::string& message) : Error(ExitCode::usage, message) {}
};
struct FileError : Error {
  explicit FileError(const std::string& message) : Error(ExitCode::file, message) {}
};
struct NoDeviceError : Error {
  explicit NoDeviceError(const std::string& message) : Error(ExitCode::noDevice, message) {}
};
struct DeviceLostError : Error {
  explicit DeviceLostError(const std::string& message) : Error(ExitCode::deviceLost, message) {}
};
/// The device did not finish its work in time. It may still be at work, so that it cannot be opened again.
struct DeviceHungError : DeviceLostError {
  using DeviceLostError::DeviceLostError;
};
struct OutOfMemoryError : Error {
  explicit OutOfMemoryError(const std::string& message) : Error(ExitCode::outOfMemory, message) {}
};
/// Memory beyond a fixed limit of the device was requested: another attempt would fail, too.
struct DeviceLimitError : OutOfMemoryError {
  using OutOfMemoryError::OutOfMemoryError;
};
/// A verdict that is not decided was used as a condition.
struct UndecidedError : Error {
  explicit UndecidedError(const std::string& message) : Error(ExitCode::undecided, message) {}
};
/// Work was interrupted whose partial result is useless.
struct InterruptedError : Error {
  explicit InterruptedError(const std::string& message) : Error(ExitCode::interrupted, message) {}
};
struct InternalError : Error {
  explicit InternalError(const std::string& message) : Error(ExitCode::internal, message) {}
};

}  // namespace candela
