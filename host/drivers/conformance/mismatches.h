// Collects the differences of one case, for its text.
#pragma once
#include <cstddef>
#include <string>

#include "host/drivers/conformance/case.h"

namespace candela::conformance {

class Mismatches {
 public:
  /// Counts one more comparison, which failed unless `text` is empty.
  void note(const std::string& text);
  /// Counts one more comparison of two numbers for `what`, e.g. "invocation 5, the sum".
  void expect(const std::string& what, std::uint32_t expected, std::uint32_t found);
  /// The same for a word of a buffer, which Finding::expected states.
  void expect(const std::string& what, capture::WordPosition position, std::uint32_t expected, std::uint32_t found);
  /// Adds a word or a float to Finding::expected. note() has the comparison.
  void require(capture::WordPosition position, std::uint32_t word);
  void require(capture::WordPosition position, double low, double high);

  /// Returns a failure with the number of mismatches and the first three, or a pass if there is none. Call it last.
  Finding finding();

 private:
  std::string text() const;

  std::size_t compared_ = 0;
  std::size_t failed_ = 0;
  std::string first_;
  capture::ExpectedValues expected_;
};

}  // namespace candela::conformance
