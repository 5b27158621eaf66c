// Progress: how often it is printed, and its text.
#include "host/base/progress.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>
#include <sstream>

namespace candela {
namespace {

std::size_t count(const std::string& text, char character) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), character));
}

}  // namespace

TEST_CASE("a quiet render prints no progress") {
  std::ostringstream sink;
  double now = 0;
  {
    Progress progress(sink, ProgressStyle::none, [&] { return now; });
    for (int i = 0; i <= 100; ++i) {
      now = i;
      progress.update(i / 100.0, 10);
    }
  }
  CHECK(sink.str().empty());
  CHECK(progressStyle(Verbosity::quiet) == ProgressStyle::none);
}

TEST_CASE("the line on a terminal is rewritten at most ten times a second and removed at the end") {
  std::ostringstream sink;
  double now = 0;
  std::optional<Progress> progress(std::in_place, sink, ProgressStyle::terminal, [&] { return now; });
  for (int i = 1; i <= 1000; ++i) {  // a second, in steps of a millisecond
    now = i / 1000.0;
    progress->update(i / 1000.0, 1000);
  }
  const std::string whileRunning = sink.str();
  CHECK(count(whileRunning, '\r') <= 10);
  CHECK(count(whileRunning, '\r') >= 9);
  CHECK(count(whileRunning, '\n') == 0);
  progress.reset();
  CHECK(sink.str() == whileRunning + "\r\x1b[K");
}

TEST_CASE("a plain log has no line for a render of two seconds, and one line per tenth of a long one") {
  std::ostringstream sink;
  double now = 0;
  Progress progress(sink, ProgressStyle::plain, [&] { return now; });
  const int seconds = GENERATE(2, 200);
  for (int i = 1; i <= 100; ++i) {
    now = seconds * i / 100.0;
    progress.update(i / 100.0, 1000);
  }
  if (seconds == 2) CHECK(sink.str().empty());
  if (seconds == 200) CHECK((count(sink.str(), '\n') >= 9 && count(sink.str(), '\n') <= 10));
  CHECK(count(sink.str(), '\r') == 0);
}

TEST_CASE("a render that hardly advances prints its progress every minute") {
  std::ostringstream sink;
  double now = 0;
  Progress progress(sink, ProgressStyle::plain, [&] { return now; });
  for (int i = 1; i <= 300; ++i) {
    now = i;
    progress.update(i * 1e-5, 1000);
  }
  CHECK(count(sink.str(), '\n') == 5);
}

TEST_CASE("the progress shows percentage, rate and remaining time") {
  CHECK(progressText(0.25, 5'000'000, 2) == "25 %, 2.5 Msamples/s, 6 s left");
  CHECK(progressText(0, 0, 0) == "0 %");
  CHECK(progressText(0.009, 1'000'000, 2) == "0 %, 0.5 Msamples/s");
  CHECK(progressText(0.01, 1'000'000, 2) == "1 %, 0.5 Msamples/s, 3 min 18 s left");
  CHECK(durationText(59.4) == "59 s");
  CHECK(durationText(125) == "2 min 5 s");
  CHECK(durationText(12000) == "3 h 20 min");
}

}  // namespace candela
