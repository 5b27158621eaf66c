// Collects the errors and warnings of one file.
#include "host/formats/loading/diagnostic_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace candela::scene {
namespace {

void sortByPosition(std::vector<Diagnostic>& diagnostics) {
  // Line 0 denotes the whole file and comes last.
  std::ranges::stable_sort(diagnostics, {}, [](const Diagnostic& d) { return std::tuple(d.line - 1u, d.column); });
}

}  // namespace

Diagnostic DiagnosticLog::make(Position position, std::string message) const {
  return {file_, position.line, position.column, std::move(message)};
}

void DiagnosticLog::error(Position position, std::string message) {
  const auto equals = [&](const Diagnostic& listed) {
    return listed.line == position.line && listed.column == position.column && listed.message == message;
  };
  if (std::ranges::any_of(errors_, equals)) {
    ++repeatedCount_;
    return;
  }
  if (++errorCount_ <= kShown) errors_.push_back(make(position, std::move(message)));
}

void DiagnosticLog::warn(const std::string& kind, Position position, std::string message) {
  const auto known = warnings_.find(kind);
  if (known != warnings_.end()) {
    ++known->second.count;
  } else if (warnings_.size() < kShown) {
    warnings_.emplace(kind, Warning{make(position, std::move(message)), 1});
  } else {
    ++unlistedWarnings_;
  }
}

std::vector<Diagnostic> DiagnosticLog::errors() const {
  std::vector<Diagnostic> all = errors_;
  sortByPosition(all);
  if (errorCount_ > kShown) {
    const std::size_t more = errorCount_ - kShown;
    all.push_back(make({}, isFull() ? fmt::format("and at least {} more errors; reading stopped there", more)
                                    : fmt::format("and {} more error{}", more, more == 1 ? "" : "s")));
  }
  return all;
}

void DiagnosticLog::throwIfErrors() const {
  if (errorCount_ > 0) throw SceneError(errors());
}

std::vector<Diagnostic> DiagnosticLog::warnings() const {
  std::vector<Diagnostic> all;
  for (const auto& [kind, warning] : warnings_) {
    all.push_back(warning.first);
    if (warning.count > 1) all.back().message += fmt::format(" (and {} more like it)", warning.count - 1);
  }
  sortByPosition(all);
  if (unlistedWarnings_ > 0) all.push_back(make({}, fmt::format("and {} more warnings", unlistedWarnings_)));
  return all;
}

}  // namespace candela::scene
