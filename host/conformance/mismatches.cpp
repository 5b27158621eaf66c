// Formats mismatches.
#include "host/conformance/mismatches.h"

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

Finding Mismatches::finding() const {
  if (failed_ == 0) return passed();
  const std::string more = failed_ > kShown ? fmt::format(", the first {} of them", kShown) : "";
  return failed(fmt::format("{} of {} values differ{}:\n{}", failed_, compared_, more, first_));
}

}  // namespace candela::conformance
