// Formats diagnostics, and the error that contains all errors of a file.
#include "host/formats/loading/diagnostic.h"

#include <fmt/format.h>

namespace candela::scene {
namespace {

std::string joinLines(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!text.empty()) text += '\n';
    text += toString(diagnostic);
  }
  return text;
}

}  // namespace

std::string toString(const Diagnostic& diagnostic) {
  const auto& [file, line, column, message] = diagnostic;
  if (line == 0) return fmt::format("{}: {}", file, message);
  if (column == 0) return fmt::format("{}:{}: {}", file, line, message);
  return fmt::format("{}:{}:{}: {}", file, line, column, message);
}

SceneError::SceneError(std::vector<Diagnostic> all) : FileError(joinLines(all)), diagnostics(std::move(all)) {}

}  // namespace candela::scene
