// The loader of NFF and P3F: statements, checks, hash.
#include "host/formats/nff/nff_loader.h"

#include <fmt/format.h>

#include "host/base/hash.h"
#include "host/base/setting_words.h"
#include "host/formats/loading/scene_checks.h"
#include "host/formats/nff/exact_mean.h"
#include "host/formats/nff/keywords.h"
#include "host/formats/nff/parser.h"

namespace candela::scene {
namespace {

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

std::uint64_t hashOf(std::string_view text, const Scene& scene) {
  std::uint64_t hash = fnv1aOfText(text);
  if (!scene.sky) return hash;
  for (const SkyFace& face : scene.sky->faces) {
    hash = fnv1aOfText(fmt::format("{}x{}", face.width, face.height), hash);
    hash = fnv1a(face.rgb, hash);
  }
  return hash;
}

}  // namespace

Loader nffLoader() { return {"NFF or P3F", {".nff", ".p3f"}, recognisesNff, loadNff}; }

LoadedScene loadNff(const SceneFile& file, const LoadOptions& options) {
  if (isWorldToolKit(file.bytes)) {
    throw SceneError(
        {{file.name, 1, 1,
          "this is WorldToolKit's NFF, another format of the same name; Candela reads Haines' Neutral File "
          "Format and P3F"}});
  }
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
  parser.scene.hash = hashOf(file.bytes, parser.scene);
  return {.scene = std::move(parser.scene),
          .counts = std::move(parser.counts),
          .warnings = parser.log.warnings(),
          .files = parser.guard.requiredPaths()};
}

LoadedScene parseScene(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                       const LoadOptions& options) {
  return loadNff({text, name, folderOrCurrent(folder)}, options);
}

}  // namespace candela::scene
