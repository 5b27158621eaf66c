// `b`, `env`, `accel` and `spp`: settings of the whole scene.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/base/errors.h"
#include "host/base/quote.h"
#include "host/base/setting_words.h"
#include "host/formats/loading/path_guard.h"
#include "host/formats/nff/parser.h"
#include "host/formats/nff/statements.h"
#include "host/image/image.h"
#include "host/scene/scene.h"

namespace candela::scene {
namespace {

/// Maximum side of a face, in texels.
constexpr std::uint32_t kMaxSkySide = 8192;

namespace fs = std::filesystem;

constexpr std::array kFaceNames{"right", "left", "top", "bottom", "front", "back"};
constexpr std::array kExtensions{".jpg", ".jpeg", ".png", ".webp", ".hdr", ".exr", ".pfm"};

fs::path findFace(const fs::path& folder, const std::string& name) {
  for (const char* extension : kExtensions) {
    const fs::path file = folder / (name + extension);
    std::error_code error;
    if (fs::exists(file, error)) return file;
  }
  throw FileError(fmt::format("the sky box {} has no {}.jpg or {}.png", quote(folder.string()), name, name));
}

SkyFace readFace(const fs::path& file, std::vector<std::string>& warnings) {
  const image::Image image = image::readImage(file);
  for (const std::string& warning : image.warnings) warnings.push_back(fmt::format("{}: {}", file.string(), warning));
  const auto isBright = [](const glm::vec3& pixel) { return glm::any(glm::greaterThan(pixel, glm::vec3(1))); };
  if (std::ranges::any_of(image.rgb, isBright)) {
    warnings.push_back(fmt::format(
        "{}: values above 1 are clipped, since faces of sky boxes have 8 bits; {} reads maps of any brightness",
        file.string(), settingWords("env")));
  }
  image::Pixels8 pixels = toPixels8(image, {});
  const bool fits = pixels.width <= kMaxSkySide && pixels.height <= kMaxSkySide;
  if (!fits) {
    throw FileError(fmt::format("{} has {} x {} pixels; a face of a sky box may have at most {} per side",
                                quote(file.string()), pixels.width, pixels.height, kMaxSkySide));
  }
  return {pixels.width, pixels.height, std::move(pixels.rgb)};
}

/// `folder` holds right, left, top, bottom, front and back, each an image file of a format that is read. The folder and
/// each image, links resolved, must be permitted by `guard`. Faces have 8 bits: brighter pixels are clipped, with a
/// warning. Empty if there is no such folder. Throws FileError.
std::optional<Sky> loadSky(const fs::path& folder, PathGuard& guard, std::vector<std::string>& warnings) {
  guard.require(folder);
  std::error_code error;
  if (!fs::is_directory(folder, error)) return std::nullopt;
  Sky sky;
  for (std::size_t i = 0; i < kFaceNames.size(); ++i) {
    const fs::path file = findFace(folder, kFaceNames[i]);
    guard.require(file);
    sky.faces[i] = readFace(file, warnings);
  }
  return sky;
}

}  // namespace

void parseBackground(Parser& parser) {
  const Position position = parser.in.here();
  parser.scene.background = parser.in.vector("the background's colour");
  parser.requireNonNegative("the background's colour", parser.scene.background, position);
}

void parseSky(Parser& parser) {
  if (!parser.tokens.nextIsOnLine()) parser.in.word("the sky's folder");
  const Token name = parser.tokens.takeRestOfLine();
  const bool printable = std::ranges::none_of(name.text, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  if (!printable) StatementReader::fail(name.position, "the sky's folder has a control character in its name");
  std::vector<std::string> warnings;
  try {
    parser.scene.sky = loadSky(parser.folder / name.text, parser.guard, warnings);
    for (const std::string& warning : warnings) parser.log.warn(warning, name.position, warning);
  } catch (const FileError& error) {
    return parser.deviation("sky", name.position, error.what());
  }
  if (parser.scene.sky) return;
  parser.log.warn("no sky", name.position,
                  fmt::format("there is no folder {}; the background's colour is used", quote(name.text)));
}

void parseAccel(Parser& parser) {
  if (parser.in.numberFollows()) {
    parser.scene.requestedAccel = static_cast<RequestedAccel>(parser.in.wholeNumber("accel", 0, 2));
    return;
  }
  const Token word = parser.in.word("0, 1, 2, none, grid or bvh");
  const auto* const found = std::ranges::find(kRequestedAccelNames, word.text);
  if (found == kRequestedAccelNames.end()) {
    StatementReader::fail(word.position,
                          fmt::format("expected 0, 1, 2, none, grid or bvh, found {}", quote(word.text)));
  }
  parser.scene.requestedAccel = static_cast<RequestedAccel>(found - kRequestedAccelNames.begin());
}

void parseSamples(Parser& parser) {
  constexpr std::int64_t kMaxSamples = 1'000'000'000;
  const auto samples = static_cast<std::uint32_t>(parser.in.wholeNumber("spp", 0, kMaxSamples));
  parser.scene.requestedSamples = samples;
  if (samples == 0) {
    return parser.log.warn("spp", parser.keyword,
                           "spp 0 is read as one ray through the centre of each pixel, without antialiasing");
  }
  parser.log.warn(
      "spp", parser.keyword,
      fmt::format("spp {} is read as {} samples per pixel in total; some programs read it as samples per side", samples,
                  samples));
}

}  // namespace candela::scene
