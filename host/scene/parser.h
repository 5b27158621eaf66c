// What the statements of a scene file share while it is read: the text, the scene so far, the current material.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "host/scene/diagnostic_log.h"
#include "host/scene/load.h"
#include "host/scene/statement_reader.h"
#include "host/scene/tokenizer.h"

namespace candela::scene {

struct Parser {
  Parser(std::string_view text, const std::string& name, std::filesystem::path sceneFolder,
         const LoadOptions& loadOptions)
      : tokens(text), in(tokens), log(name), folder(std::move(sceneFolder)), options(loadOptions) {}
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  Tokenizer tokens;
  StatementReader in;
  DiagnosticLog log;
  Scene scene;
  StatementCounts counts;
  std::filesystem::path folder;
  LoadOptions options;
  std::optional<std::uint32_t> material;  ///< index of the current one
  Position keyword;                       ///< of the statement being read

  /// A departure from the format that can be passed over: an error, or with `lenient` a warning of this kind.
  void deviation(const std::string& kind, Position position, const std::string& message);
  /// True if a deviation of this kind would be shown rather than counted, so that its message is worth making.
  bool lists(const std::string& kind) const;
  /// Reports an error and goes on with the statement, if `value` is negative.
  void requireNonNegative(std::string_view what, float value, Position position);
  void requireNonNegative(std::string_view what, const glm::vec3& value, Position position);
  /// Reads how many items of `numbersPerItem` numbers each follow, in [min, max]. A count that the rest of the file
  /// cannot hold is refused before anyone allocates by it. Throws StatementError.
  std::size_t itemCount(std::string_view what, std::int64_t min, std::int64_t max, std::size_t numbersPerItem);
  /// Index of the current material; before any `f` that is the default one, which this adds to the scene.
  std::uint32_t currentMaterial();
};

/// Takes a statement that begins with no keyword: an error, or with `lenient` a warning.
void skipUnknown(Parser& parser);
/// Reads all statements; what is wrong is then in `parser.log`.
void parseStatements(Parser& parser);

}  // namespace candela::scene
