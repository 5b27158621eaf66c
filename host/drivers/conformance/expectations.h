// The files that state the expected results of a driver, in the formats of deqp-runner.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "host/drivers/conformance/status.h"

namespace candela::conformance {

/// Results by the name of their case.
using Baseline = std::map<std::string, Status, std::less<>>;

/// Reads lines `case,Result` or `case,Result,seconds`; empty lines and lines that start with # are ignored. Throws
/// FileError with the line for any other line, an unknown result, and a case that occurs twice.
Baseline parseBaseline(const std::string& text, const std::string& fileName);
/// Reads the file. Throws FileError.
Baseline readBaseline(const std::filesystem::path& file);
/// Adds the results of the file `fileName` to `all`. Throws FileError if `all` has another result of one of its cases.
void addBaseline(const Baseline& baseline, const std::string& fileName, Baseline& all);

/// Regular expressions. A name matches if any of them occurs anywhere in it.
class NamePatterns {
 public:
  NamePatterns() = default;
  /// Reads one expression per line; empty lines and lines that start with # are ignored. Throws FileError with the
  /// line.
  NamePatterns(const std::string& text, const std::string& fileName);
  bool match(const std::string& name) const;
  void add(const NamePatterns& other);

 private:
  std::vector<std::regex> expressions_;
};

/// Reads the file. Throws FileError.
NamePatterns readPatterns(const std::filesystem::path& file);

struct Expectations {
  Baseline baseline;
  NamePatterns skips;   ///< cases that do not run
  NamePatterns flakes;  ///< cases whose failures do not count

  std::optional<Status> of(std::string_view name) const;
};

}  // namespace candela::conformance
