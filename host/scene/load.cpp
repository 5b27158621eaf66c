// Reads a scene: file, statements, checks, hash.
#include "host/scene/load.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "host/scene/exact_mean.h"
#include "host/scene/hash.h"
#include "host/scene/parser.h"
#include "host/scene/scene_checks.h"

namespace candela::scene {
namespace {

constexpr std::size_t kMaxFileSize = std::size_t{1} << 30;

/// Returns whether the text is WorldToolKit's format of the same name, which begins with this name after optional //
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

std::span<const std::uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::uint64_t hashOf(std::string_view text, const Scene& scene) {
  std::uint64_t hash = fnv1a(bytesOf(text));
  if (!scene.sky) return hash;
  for (const SkyFace& face : scene.sky->faces) {
    hash = fnv1a(bytesOf(fmt::format("{}x{}", face.width, face.height)), hash);
    hash = fnv1a(face.rgb, hash);
  }
  return hash;
}

std::string readFile(const std::filesystem::path& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw FileError(fmt::format("{}: cannot open: {}", path.string(), std::strerror(errno)));
  std::string text;
  std::string block(1 << 20, '\0');
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    text.append(block, 0, count);
    if (text.size() > kMaxFileSize) throw FileError(fmt::format("{}: larger than 1 GiB", path.string()));
  }
  if (std::ferror(file.get())) throw FileError(fmt::format("{}: cannot read: {}", path.string(), std::strerror(errno)));
  return text;
}

}  // namespace

LoadedScene parseScene(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                       const LoadOptions& options) {
  if (isWorldToolKit(text)) {
    throw SceneError(
        {{name, 1, 1,
          "this is WorldToolKit's NFF, another format of the same name; Candela reads Haines' Neutral File "
          "Format and P3F"}});
  }
  Parser parser(text, name, folder.empty() ? "." : folder, options);
  parseStatements(parser);
  parser.scene.exactMean = findExactMean(text, parser.log);
  parser.log.throwIfErrors();
  checkScene(parser.scene, parser.log);
  parser.scene.name = std::filesystem::path(name).filename().string();
  parser.scene.hash = hashOf(text, parser.scene);
  return {std::move(parser.scene), std::move(parser.counts), parser.log.warnings()};
}

LoadedScene loadScene(const std::filesystem::path& file, const LoadOptions& options) {
  return parseScene(readFile(file), file.string(), file.parent_path(), options);
}

void requireCamera(const Scene& scene) {
  if (scene.camera) return;
  throw SceneError(
      {{scene.name, 0, 0,
        "the scene has no view; add one: v / from x y z / at x y z / up x y z / angle degrees / hither 0 / "
        "resolution width height"}});
}

}  // namespace candela::scene
