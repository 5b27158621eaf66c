// An error or a warning about an input file, with its position.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "host/base/errors.h"

namespace candela::scene {

/// A position in a file, 1-based. Columns count bytes; a tab is one column.
struct Position {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

struct Diagnostic {
  std::string file;
  std::uint32_t line = 0;    ///< 1-based; 0: the file as a whole
  std::uint32_t column = 0;  ///< 1-based; 0: the line as a whole
  std::string message;
};

/// Ends the reading of a statement. Parsers catch it, and continue with the next statement.
struct StatementError {
  Position position;
  std::string message;
};

/// "scene.p3f:14:9: unknown keyword "spehre"; did you mean "s"?"
std::string toString(const Diagnostic& diagnostic);

/// All errors of one scene, in the order of the file. `what()` contains one line for each.
struct SceneError : FileError {
  explicit SceneError(std::vector<Diagnostic> all);
  std::vector<Diagnostic> diagnostics;
};

}  // namespace candela::scene
