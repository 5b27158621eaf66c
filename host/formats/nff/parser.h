// State shared by the statements of a scene file while it is read: the text, the scene so far, the current material.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/load.h"
#include "host/formats/loading/path_guard.h"
#include "host/formats/nff/statement_reader.h"
#include "host/formats/nff/tokenizer.h"

namespace candela::scene {

struct Parser {
  Parser(std::string_view text, const std::string& name, std::filesystem::path sceneFolder,
         const LoadOptions& loadOptions)
      : tokens(text),
        in(tokens),
        log(name),
        folder(std::move(sceneFolder)),
        options(loadOptions),
        guard(folder, options.allowedPaths) {}
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  Tokenizer tokens;
  StatementReader in;
  DiagnosticLog log;
  Scene scene;
  StatementCounts counts;
  std::filesystem::path folder;
  LoadOptions options;
  PathGuard guard;
  std::optional<std::uint32_t> material;                        ///< index of the current material
  std::map<std::array<float, 3>, std::uint32_t> lampMaterials;  ///< of area lights, by colour
  Position keyword;                                             ///< position of the current statement's keyword

  /// Reports a deviation from the format that can be ignored: an error, or a warning of this kind with `lenient`.
  void deviation(const std::string& kind, Position position, const std::string& message);
  /// Returns whether a deviation of this kind would be listed rather than counted, so that its message is needed.
  bool lists(const std::string& kind) const;
  /// Reports an error if `value` is negative, and continues with the statement.
  void requireNonNegative(std::string_view what, float value, Position position);
  void requireNonNegative(std::string_view what, const glm::vec3& value, Position position);
  /// Reads the number, in [min, max], of items of `numbersPerItem` numbers each. Refuses a number that the rest of the
  /// file cannot contain before memory is allocated for it. Throws StatementError.
  std::size_t itemCount(std::string_view what, std::int64_t min, std::int64_t max, std::size_t numbersPerItem);
  /// Returns the index of the current material. Before any `f`, this is the default material, which is added to the
  /// scene.
  std::uint32_t currentMaterial();
};

/// Handles a statement that does not begin with a keyword: an error, or a warning with `lenient`.
void skipUnknown(Parser& parser);
/// Reads all statements. Errors and warnings are then in `parser.log`.
void parseStatements(Parser& parser);

}  // namespace candela::scene
