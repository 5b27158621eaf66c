// The progress line: when it is printed, and its text.
#include "host/base/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ostream>

namespace candela {
namespace {

constexpr double kTerminalInterval = 0.1;  // seconds
constexpr double kPlainInterval = 5;
constexpr double kPlainMaxInterval = 60;
constexpr double kPlainStep = 0.1;              // fraction of the work
constexpr double kMinEstimatedFraction = 0.01;  // before, the remaining time is a guess
constexpr const char* kClearLine = "\r\x1b[K";

}  // namespace

ProgressStyle progressStyle(Verbosity verbosity) {
  if (verbosity == Verbosity::quiet) return ProgressStyle::none;
  return isatty(STDERR_FILENO) ? ProgressStyle::terminal : ProgressStyle::plain;
}

double monotonicSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string durationText(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::llround(std::clamp(seconds, 0.0, 1e15)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string progressText(double fraction, std::uint64_t samplesDone, double elapsedSeconds) {
  const auto percent = static_cast<int>(100 * fraction);
  if (fraction <= 0 || elapsedSeconds <= 0) return fmt::format("{} %", percent);
  const double rate = static_cast<double>(samplesDone) / elapsedSeconds / 1e6;
  if (fraction < kMinEstimatedFraction) return fmt::format("{} %, {:.3g} Msamples/s", percent, rate);
  const double left = elapsedSeconds * (1 - fraction) / fraction;
  return fmt::format("{} %, {:.3g} Msamples/s, {} left", percent, rate, durationText(left));
}

Progress::Progress(std::ostream& sink, ProgressStyle style, Clock clock)
    : sink_(sink), style_(style), clock_(std::move(clock)), start_(clock_()), shownAt_(start_) {}

bool Progress::isDue(double now, double fraction) const {
  const double waited = now - shownAt_;
  if (style_ == ProgressStyle::terminal) return waited >= kTerminalInterval;
  return waited >= kPlainMaxInterval || (waited >= kPlainInterval && fraction >= shownFraction_ + kPlainStep);
}

void Progress::update(double fraction, std::uint64_t samplesDone, const std::string& head) {
  if (style_ == ProgressStyle::none) return;
  const std::lock_guard lock(mutex_);
  const double now = clock_();
  if (!isDue(now, fraction)) return;
  shownAt_ = now;
  shownFraction_ = fraction;
  const std::string text = head + progressText(fraction, samplesDone, now - start_);
  if (style_ == ProgressStyle::terminal) {
    sink_ << kClearLine << text << std::flush;
  } else {
    sink_ << text << std::endl;
  }
}

void Progress::clear() {
  if (style_ == ProgressStyle::terminal) sink_ << kClearLine << std::flush;
}

Progress::~Progress() { clear(); }

}  // namespace candela
