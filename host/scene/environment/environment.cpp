// Reads or computes the map, scales and places it.
#include "host/scene/environment/environment.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <span>

#include "host/base/errors.h"
#include "host/base/finite.h"
#include "host/base/hash.h"
#include "host/base/setting_words.h"
#include "host/image/image.h"
#include "host/scene/environment/placement.h"
#include "host/scene/environment/sun_sky.h"
#include "host/scene/environment/weights.h"

namespace candela::environment {
namespace {

constexpr std::string_view kWhite = "white";
constexpr std::string_view kSun = "sun:";

scene::Environment makeWhite() {
  constexpr std::uint32_t kWidth = 64;
  constexpr std::uint32_t kHeight = 32;
  return {.name = std::string(kWhite),
          .width = kWidth,
          .height = kHeight,
          .texels = std::vector<glm::vec3>(std::size_t{kWidth} * kHeight, glm::vec3(1)),
          .weights = {}};
}

/// Replaces pixels that are not finite by black. Returns a warning with their number; nothing if there are none.
std::optional<std::string> repair(image::Image& image) {
  std::size_t count = 0;
  for (glm::vec3& pixel : image.rgb) {
    if (isFinite(glm::dvec3(pixel))) continue;
    pixel = glm::vec3(0);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return fmt::format("{} of {} pixels are not finite, and are replaced by black", count, image.rgb.size());
}

/// Returns the colours of the whole frame, black where the file has no pixels.
std::vector<glm::vec3> coloursOfFrame(image::Image& image) {
  const image::PixelBox frame = frameOf(image), window = windowOf(image);
  if (frame == window) return std::move(image.rgb);
  std::vector<glm::vec3> colours(static_cast<std::size_t>(frame.width * frame.height), glm::vec3(0));
  const image::PixelBox common = intersection(frame, window);
  for (std::int64_t y = common.y; y < common.y + common.height; ++y) {
    for (std::int64_t x = common.x; x < common.x + common.width; ++x) {
      colours[static_cast<std::size_t>((y - frame.y) * frame.width + x - frame.x)] = image.rgb[static_cast<std::size_t>(
          (y - window.y) * window.width + x - window.x)];
    }
  }
  return colours;
}

ReadEnvironment readMap(const std::string& file, bool isLenient) {
  image::Image image = image::readImage(file);
  if (image.isCubeMap) {
    throw FileError(
        fmt::format("the environment {}: the file is a cube map (envmap = cube); convert it to latitude and longitude, "
                    "for example by exrenvmap -latlong",
                    file));
  }
  const image::PixelBox frame = frameOf(image);
  const auto maxTexels = static_cast<std::int64_t>(kMaxTexels);
  if (frame.isEmpty()) throw FileError(fmt::format("the environment {}: the display window is empty", file));
  if (frame.width > maxTexels || frame.width * frame.height > maxTexels) {
    throw FileError(fmt::format("the environment {}: {} x {} pixels; an environment may have at most {} pixels", file,
                                frame.width, frame.height, kMaxTexels));
  }
  ReadEnvironment result{.environment = {.name = std::filesystem::path(file).filename().string(),
                                         .width = static_cast<std::uint32_t>(frame.width),
                                         .height = static_cast<std::uint32_t>(frame.height),
                                         .texels = {},
                                         .weights = {}},
                         .warnings = image.warnings};
  if (intersection(frame, windowOf(image)).isEmpty()) {
    result.warnings.emplace_back("the data window is outside the display window, so that the environment is black");
  }
  if (isLenient) {
    if (const auto warning = repair(image)) result.warnings.push_back(*warning);
  }
  result.environment.texels = coloursOfFrame(image);
  return result;
}

ReadEnvironment makeMap(const std::string& source, bool isLenient) {
  if (isImageFile(source)) return readMap(source, isLenient);
  return {source == kWhite ? makeWhite() : makeSunSky(std::string_view(source).substr(kSun.size()))};
}

void scaleTexels(scene::Environment& environment, double scale) {
  for (std::size_t i = 0; i < environment.texels.size(); ++i) {
    glm::vec3& texel = environment.texels[i];
    const glm::vec3 scaled(glm::dvec3(texel) * scale);
    if (!std::isfinite(scaled.x) || !std::isfinite(scaled.y) || !std::isfinite(scaled.z)) {
      throw FileError(fmt::format(
          "the environment {}: the radiance of pixel {},{} is not finite; {} replaces such pixels of the file by black",
          environment.name, i % environment.width, i / environment.width, settingWords("lenient")));
    }
    texel = glm::max(scaled, 0.0f);
  }
}

}  // namespace

ReadEnvironment readEnvironment(const scene::EnvironmentRequest& request, const glm::vec3& up, bool isLenient) {
  ReadEnvironment result = makeMap(request.source, isLenient);
  result.environment.hasRowsAtPoles = request.hasRowsAtPoles && result.environment.height > 1;
  scaleTexels(result.environment, request.scale);
  setWeights(result.environment);
  place(result.environment, up, request.rotation);
  return result;
}

scene::Environment makeEnvironment(const scene::EnvironmentRequest& request, const glm::vec3& up) {
  return readEnvironment(request, up, false).environment;
}

bool isImageFile(std::string_view source) { return source != kWhite && !source.starts_with(kSun); }

std::uint64_t hashOf(const scene::Environment& environment, std::uint64_t hash) {
  const auto bytesOf = [](const auto& values) {
    return std::span(reinterpret_cast<const std::uint8_t*>(std::data(values)), std::size(values) * sizeof(values[0]));
  };
  hash = fnv1aOfText(fmt::format("environment {}x{}", environment.width, environment.height), hash);
  if (environment.hasRowsAtPoles) hash = fnv1aOfText("rows at poles", hash);
  return fnv1a(bytesOf(environment.axes), fnv1a(bytesOf(environment.texels), hash));
}

}  // namespace candela::environment
