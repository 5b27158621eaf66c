// Formats mismatches.
#include "host/drivers/conformance/mismatches.h"

#include <fmt/format.h>

namespace candela::conformance {
namespace {

constexpr std::size_t kShown = 3;

}  // namespace

void Mismatches::note(const std::string& text) {
  ++compared_;
  if (text.empty()) return;
  if (++failed_ <= kShown) first_ += (failed_ == 1 ? "" : "\n") + text;
}

void Mismatches::expect(const std::string& what, std::uint32_t expected, std::uint32_t found) {
  note(expected == found
           ? ""
           : fmt::format("{}: expected {} ({:#x}), found {} ({:#x})", what, expected, expected, found, found));
}

void Mismatches::expect(const std::string& what, capture::WordPosition position, std::uint32_t expected,
                        std::uint32_t found) {
  require(position, expected);
  expect(what, expected, found);
}

void Mismatches::require(capture::WordPosition position, std::uint32_t word) {
  expected_.push_back({capture::ValueType::word, position, static_cast<double>(word), static_cast<double>(word)});
}

void Mismatches::require(capture::WordPosition position, double low, double high) {
  expected_.push_back({capture::ValueType::number, position, low, high});
}

Finding Mismatches::finding() {
  Finding finding = failed_ == 0 ? passed() : failed(text());
  finding.expected = std::move(expected_);
  return finding;
}

std::string Mismatches::text() const {
  const std::string more = failed_ > kShown ? fmt::format(", the first {} of them", kShown) : "";
  return fmt::format("{} of {} values differ{}:\n{}", failed_, compared_, more, first_);
}

}  // namespace candela::conformance
