// Reads and renders the scenes of this folder.
#include "tests/scene/mitsuba/mitsuba_scenes.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "host/formats/load_scene.h"

namespace candela::mitsuba {

scene::Scene sceneNamed(const std::string& file, const Reading& reading) {
  scene::LoadOptions options{.definitions = reading.definitions};
  if (!reading.camera.empty()) options.camera = reading.camera;
  const std::filesystem::path folder = std::filesystem::path(CANDELA_SOURCE_DIR) / "tests/scene/mitsuba";
  return formats::loadScene(folder / file, options).scene;
}

image::Film pictureOf(const std::string& file, const Reading& reading) {
  const scene::Scene scene = sceneNamed(file, reading);
  return render(scene, render::resolve({}, scene));
}

void checkRow(const std::string& file, const std::vector<glm::dvec3>& expected, const Reading& reading,
              double tolerance) {
  const image::Film film = pictureOf(file, reading);
  REQUIRE(film.width() == expected.size());
  REQUIRE(film.height() == 1);
  for (std::uint32_t x = 0; x < film.width(); ++x) {
    const glm::dvec3 mean = film.mean(x, 0);
    const double error = std::sqrt(film.luminanceVariance(x, 0) / film.at(x, 0).sampleCount);
    const double noise = error > 0 ? 5 * error / image::luminance(mean) : 0;
    INFO(file << ", pixel " << x << ": " << mean.x << ' ' << mean.y << ' ' << mean.z << " instead of " << expected[x].x
              << ' ' << expected[x].y << ' ' << expected[x].z << ", relative noise " << noise);
    for (int c = 0; c < 3; ++c)
      CHECK(std::abs(mean[c] - expected[x][c]) <= (tolerance + noise) * expected[x][c] + 1e-9);
  }
}

}  // namespace candela::mitsuba
