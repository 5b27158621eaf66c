// Counts failures, and writes their messages.
#include "host/cli/device_failures.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "host/cli/option_table.h"

namespace candela::cli {
namespace {

constexpr int kMaxAttempts = 3;
constexpr double kShorterDispatches = 4;

template <class T>
bool is(const Error& error) {
  return dynamic_cast<const T*>(&error) != nullptr;
}

// A driver that resets its device needs time, especially after the second consecutive failure.
std::chrono::milliseconds pauseBefore(int attempt) {
  return std::chrono::milliseconds(attempt == 1 ? 0 : 500 * attempt);
}

}  // namespace

bool DeviceFailures::isOne(const Error& error) const {
  if (is<NoDeviceError>(error)) return count_ > 0 || job_.arguments.fallback == Fallback::reference;
  return is<DeviceLostError>(error) || is<OutOfMemoryError>(error);
}

// A pixel's state is below 256 bytes, so that the first step divides the image in bands, however large it is. One row
// is always allowed.
void DeviceFailures::limitBands() {
  constexpr std::uint64_t kBytesPerPixel = 256, kStep = 4, kBytesForOnePixel = 1024;
  const render::Window window = job_.settings.image.window();
  const std::uint64_t whole = std::uint64_t{window.width} * window.height * kBytesPerPixel;
  maxBandBytes_ = std::max(std::min(maxBandBytes_, whole) / kStep, window.width * kBytesForOnePixel);
}

bool DeviceFailures::mayTryAgain(const Error& error) {
  if (is<OutOfMemoryError>(error)) limitBands();
  if (is<DeviceLostError>(error)) dispatchSeconds_ /= kShorterDispatches;
  const bool wasAbsent = is<NoDeviceError>(error) && count_ == 0;
  const bool isFinal = is<DeviceHungError>(error) || is<DeviceLimitError>(error) || wasAbsent;
  if (isFinal || count_ == kMaxAttempts) return false;
  ++count_;
  log_.warning(fmt::format("{}; the device is opened again (attempt {} of {})", error.what(), count_, kMaxAttempts));
  std::this_thread::sleep_for(pauseBefore(count_));
  return true;
}

ExitCode DeviceFailures::codeOf(const Error& error) {
  return is<OutOfMemoryError>(error) ? ExitCode::outOfMemory : ExitCode::deviceLost;
}

std::string DeviceFailures::explain(const Error& error, const std::string& film) const {
  std::string text = error.what();
  if (count_ > 0) text += fmt::format("; opening the device again {} times did not help", count_);
  if (!film.empty()) {
    text += fmt::format("; {} contains the samples so far: run the same command with --resume {} to continue", film,
                        shellQuoted(film));
  }
  text += is<OutOfMemoryError>(error)
              ? "; close other programs that use the device, or render a smaller --size or --crop"
              : "; candela doctor checks the device and its driver";
  if (job_.arguments.fallback == Fallback::none)
    text += ", and --fallback cpu lets the reference tracer finish the render";
  return text;
}

}  // namespace candela::cli
