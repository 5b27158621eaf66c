// Reads or computes the map, scales and places it.
#include "host/environment/environment.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <span>

#include "host/core/errors.h"
#include "host/core/hash.h"
#include "host/environment/placement.h"
#include "host/environment/sun_sky.h"
#include "host/environment/weights.h"
#include "host/image/image.h"

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

scene::Environment readMap(const std::string& file) {
  image::Image image = image::readImage(file);
  if (image.rgb.size() > kMaxTexels) {
    throw FileError(fmt::format("--env {}: {} x {} pixels; an environment may have at most {} pixels", file,
                                image.width, image.height, kMaxTexels));
  }
  return {.name = std::filesystem::path(file).filename().string(),
          .width = image.width,
          .height = image.height,
          .texels = std::move(image.rgb),
          .weights = {}};
}

scene::Environment makeMap(const std::string& source) {
  if (isImageFile(source)) return readMap(source);
  return source == kWhite ? makeWhite() : makeSunSky(std::string_view(source).substr(kSun.size()));
}

void scaleTexels(scene::Environment& environment, double scale) {
  for (std::size_t i = 0; i < environment.texels.size(); ++i) {
    glm::vec3& texel = environment.texels[i];
    const glm::vec3 scaled(glm::dvec3(texel) * scale);
    if (!std::isfinite(scaled.x) || !std::isfinite(scaled.y) || !std::isfinite(scaled.z)) {
      throw FileError(fmt::format("--env {}: the radiance of pixel {},{} is not finite", environment.name,
                                  i % environment.width, i / environment.width));
    }
    texel = glm::max(scaled, 0.0f);
  }
}

}  // namespace

scene::Environment makeEnvironment(const scene::EnvironmentRequest& request, const glm::vec3& up) {
  scene::Environment environment = makeMap(request.source);
  scaleTexels(environment, request.scale);
  setWeights(environment);
  place(environment, up, request.rotation);
  return environment;
}

bool isImageFile(std::string_view source) { return source != kWhite && !source.starts_with(kSun); }

std::uint64_t hashOf(const scene::Environment& environment, std::uint64_t hash) {
  const auto bytesOf = [](const auto& values) {
    return std::span(reinterpret_cast<const std::uint8_t*>(std::data(values)), std::size(values) * sizeof(values[0]));
  };
  hash = fnv1aOfText(fmt::format("environment {}x{}", environment.width, environment.height), hash);
  return fnv1a(bytesOf(environment.axes), fnv1a(bytesOf(environment.texels), hash));
}

}  // namespace candela::environment
