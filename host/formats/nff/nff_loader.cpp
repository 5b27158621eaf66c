// The loader of NFF and P3F: statements, checks, hash.
#include "host/formats/nff/nff_loader.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <vector>

#include "host/base/hash.h"
#include "host/base/setting_words.h"
#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/file_hash.h"
#include "host/formats/loading/number.h"
#include "host/formats/loading/scene_checks.h"
#include "host/formats/nff/keywords.h"
#include "host/formats/nff/parser.h"
#include "host/formats/nff/tokenizer.h"
#include "host/scene/scene.h"

namespace candela::scene {
namespace {

constexpr std::string_view kKey = "exact-mean:";
constexpr const char*
    kForm = "the form is: # exact-mean: r g b [x y width height], with the rectangle in fractions of the image";

// Returns the position of the first number, or npos if the line is not such a comment.
std::size_t numbersOf(std::string_view line) {
  const std::size_t hash = line.find_first_not_of(" \t");
  if (hash == std::string_view::npos || line[hash] != '#') return std::string_view::npos;
  const std::size_t key = line.find_first_not_of(" \t", hash + 1);
  if (key == std::string_view::npos || !line.substr(key).starts_with(kKey)) return std::string_view::npos;
  return key + kKey.size();
}

bool isInside(const glm::vec4& area) {
  return area.x >= 0 && area.y >= 0 && area.z > 0 && area.w > 0 && area.x + area.z <= 1 && area.y + area.w <= 1;
}

std::optional<ExactMean> parseNumbers(std::string_view words) {
  std::vector<float> numbers;
  for (Tokenizer tokens(words); !tokens.peek().atEnd();) {
    const ParsedNumber<float> number = parseFloat(tokens.take().text);
    if (number.status != NumberStatus::ok) return std::nullopt;
    numbers.push_back(number.value);
  }
  if (numbers.size() != 3 && numbers.size() != 7) return std::nullopt;
  ExactMean exact{{numbers[0], numbers[1], numbers[2]}};
  if (numbers.size() == 7) exact.area = {numbers[3], numbers[4], numbers[5], numbers[6]};
  const bool isLight = exact.rgb.r >= 0 && exact.rgb.g >= 0 && exact.rgb.b >= 0;
  return isLight && isInside(exact.area) ? std::optional(exact) : std::nullopt;
}

/// Returns the first "# exact-mean: r g b [x y width height]" in the text of a scene. If it cannot be read, an error is
/// added to `log`.
std::optional<ExactMean> findExactMean(std::string_view text, DiagnosticLog& log) {
  if (text.find(kKey) == std::string_view::npos) return std::nullopt;  // most files; the search is fast
  std::uint32_t lineNumber = 1;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    const std::size_t numbers = numbersOf(line);
    if (numbers != std::string_view::npos) {
      const std::optional<ExactMean> exact = parseNumbers(line.substr(numbers));
      if (!exact) log.error({lineNumber, static_cast<std::uint32_t>(numbers + 1)}, kForm);
      return exact;
    }
    text.remove_prefix(line.size());
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
    ++lineNumber;
  }
  return std::nullopt;
}

/// Returns whether this is WorldToolKit's format of the same name, which begins with its name, perhaps after //
/// comments.
bool isWorldToolKit(std::string_view text) {
  Tokenizer tokens(text);
  while (tokens.peek().text.starts_with("//")) {
    tokens.take();
    tokens.takeRestOfLine();
  }
  const std::string_view word = tokens.peek().text;
  return word == "nff" || word == "NFF";
}

bool recognisesNff(std::string_view text) {
  return findKeyword(Tokenizer(text).peek().text) != nullptr || isWorldToolKit(text);
}

// The signed axis to which the view's `up` is closest; among equals y, then z. Without a view, y.
glm::vec3 upAxisOf(const Scene& scene) {
  const glm::vec3 up = scene.camera ? scene.camera->up : glm::vec3(0, 1, 0);
  const glm::vec3 size = glm::abs(up);
  if (size.y >= size.x && size.y >= size.z) return {0, up.y < 0 ? -1 : 1, 0};
  if (size.z >= size.x) return {0, 0, up.z < 0 ? -1 : 1};
  return {up.x < 0 ? -1 : 1, 0, 0};
}

std::uint64_t hashOf(std::uint64_t hash, const Scene& scene) {
  if (!scene.sky) return hash;
  for (const SkyFace& face : scene.sky->faces) {
    hash = fnv1aOfText(fmt::format("{}x{}", face.width, face.height), hash);
    hash = fnv1a(face.rgb, hash);
  }
  return hash;
}

LoadedScene loadNff(const SceneFile& file, const LoadOptions& options) {
  if (isWorldToolKit(file.bytes)) {
    throw SceneError(
        {{file.name, 1, 1,
          "this is WorldToolKit's NFF, another format of the same name; Candela reads Haines' Neutral File "
          "Format and P3F"}});
  }
  const std::shared_future<std::uint64_t> hash = startHash(file.bytes);
  Parser parser(file.bytes, file.name, file.folder, options);
  parseStatements(parser);
  if (options.camera || options.time) {
    parser.log.warn("options", {},
                    fmt::format("{} and {} have no effect: the format has one view and no animation",
                                settingWords("camera"), settingWords("time")));
  }
  parser.scene.exactMean = findExactMean(file.bytes, parser.log);
  parser.log.throwIfErrors();
  parser.scene.up = upAxisOf(parser.scene);
  checkScene(parser.scene, options, parser.log);
  parser.scene.name = std::filesystem::path(file.name).filename().string();
  parser.scene.hash = hashOf(hash.get(), parser.scene);
  return {.scene = std::move(parser.scene),
          .counts = std::move(parser.counts),
          .warnings = parser.log.warnings(),
          .files = parser.guard.requiredPaths()};
}

std::unique_ptr<SceneReader> openNff(const SceneFile& file, const LoadOptions& options, bool) {
  return readStill(file, options, loadNff);
}

}  // namespace

Loader nffLoader() { return {"NFF or P3F", {".nff", ".p3f"}, recognisesNff, openNff}; }

LoadedScene parseScene(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                       const LoadOptions& options) {
  return loadNff({text, name, folderOrCurrent(folder)}, options);
}

}  // namespace candela::scene
