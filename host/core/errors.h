// The kinds of failure that a user can meet, each with the exit code it ends in. Thrown low, caught once in main().
#pragma once
#include <stdexcept>
#include <string>

namespace candela {

/// Exit codes of the program, as README documents them.
enum class ExitCode : int {
  done = 0,
  usage = 1,
  file = 2,        ///< scene, image or file error; also sizes beyond stated limits
  differ = 3,      ///< compared images differ, verification failed
  noDevice = 4,    ///< no usable Vulkan device
  deviceLost = 5,  ///< device lost beyond recovery
  outOfMemory = 6,
  interrupted = 7,  ///< what was done of an image is written
  internal = 70,
};

/// Base of all expected failures. `what()` says what is wrong and what to do, without a trailing newline.
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
struct OutOfMemoryError : Error {
  explicit OutOfMemoryError(const std::string& message) : Error(ExitCode::outOfMemory, message) {}
};
/// For work whose half is worth nothing.
struct InterruptedError : Error {
  explicit InterruptedError(const std::string& message) : Error(ExitCode::interrupted, message) {}
};
struct InternalError : Error {
  explicit InternalError(const std::string& message) : Error(ExitCode::internal, message) {}
};

}  // namespace candela
