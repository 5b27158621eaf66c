// Collects the errors and warnings of one file, and limits their number.
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "host/formats/loading/diagnostic.h"

namespace candela::scene {

class DiagnosticLog {
 public:
  static constexpr std::size_t kShown = 100;  ///< maximum number of errors, and of kinds of warnings, that are listed
  static constexpr std::size_t kCounted = 10'000;  ///< number of errors after which reading stops

  explicit DiagnosticLog(std::string file) : file_(std::move(file)) {}

  /// Stores the error, unless it equals one that is listed.
  void error(Position position, std::string message);
  /// Stores the first warning of each kind and counts the others.
  void warn(const std::string& kind, Position position, std::string message);

  /// Returns whether another error, or another warning of this kind, would be listed rather than only counted.
  bool listsError() const { return errorCount_ < kShown; }
  bool listsWarning(const std::string& kind) const { return warnings_.size() < kShown && !warnings_.contains(kind); }

  std::size_t errorCount() const { return errorCount_; }
  bool isFull() const { return errorCount_ + repeatedCount_ >= kCounted; }

  /// Returns the errors in the order of the file.
  std::vector<Diagnostic> errors() const;
  /// Throws SceneError with these errors, if there are any.
  void throwIfErrors() const;
  /// Returns the warnings in the order of the file.
  std::vector<Diagnostic> warnings() const;

 private:
  struct Warning {
    Diagnostic first;
    std::size_t count = 0;
  };
  Diagnostic make(Position position, std::string message) const;

  std::string file_;
  std::vector<Diagnostic> errors_;
  std::size_t errorCount_ = 0;     ///< without repeated ones
  std::size_t repeatedCount_ = 0;  ///< of errors that equal one in `errors_`
  std::map<std::string, Warning> warnings_;
  std::size_t unlistedWarnings_ = 0;
};

}  // namespace candela::scene
