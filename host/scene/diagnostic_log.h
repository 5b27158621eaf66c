// Collects what is wrong and what is odd in one file, and keeps the list readable however bad the file is.
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "host/scene/diagnostic.h"
#include "host/scene/tokenizer.h"

namespace candela::scene {

class DiagnosticLog {
 public:
  static constexpr std::size_t kShown = 100;       ///< errors, and kinds of warning, that are listed
  static constexpr std::size_t kCounted = 10'000;  ///< errors after which reading stops

  explicit DiagnosticLog(std::string file) : file_(std::move(file)) {}

  void error(Position position, std::string message);
  /// Keeps the first warning of each kind and counts the others.
  void warn(const std::string& kind, Position position, std::string message);

  /// True if another error, or a warning of this kind, would be listed rather than counted.
  bool listsError() const { return errorCount_ < kShown; }
  bool listsWarning(const std::string& kind) const { return warnings_.size() < kShown && !warnings_.contains(kind); }

  std::size_t errorCount() const { return errorCount_; }
  bool isFull() const { return errorCount_ >= kCounted; }

  /// Throws SceneError, in the order of the file, if there was an error.
  void throwIfErrors() const;
  /// In the order of the file.
  std::vector<Diagnostic> warnings() const;

 private:
  struct Warning {
    Diagnostic first;
    std::size_t count = 0;
  };
  Diagnostic make(Position position, std::string message) const;

  std::string file_;
  std::vector<Diagnostic> errors_;
  std::size_t errorCount_ = 0;
  std::map<std::string, Warning> warnings_;
  std::size_t unlistedWarnings_ = 0;
};

}  // namespace candela::scene
