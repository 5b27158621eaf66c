#include "tests/render/render_support.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

namespace candela {
namespace {

const std::filesystem::path kScenes = std::filesystem::path(CANDELA_SOURCE_DIR) / "scenes";
const std::filesystem::path kSpd = std::filesystem::path(CANDELA_SOURCE_DIR) / "tests/scene/spd";

}  // namespace

std::vector<std::filesystem::path> sceneFiles() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
    if (entry.is_regular_file() && entry.path().extension() == ".p3f") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Scene loadTestScene(const std::string& fileName) { return loadScene(kScenes / fileName).scene; }

Scene primitivesUnderLights() {
  Scene scene = loadTestScene("primitives.p3f");
  for (int i = 0; i < 11; ++i) {
    const auto step = static_cast<float>(i);
    scene.pointLights.push_back({{step - 5, -6 + 0.7f * step, 3 + 0.3f * step}, glm::vec3(0.05f + 0.02f * step)});
  }
  return scene;
}

Scene loadSpdScene(const std::string& fileName) { return loadScene(kSpd / fileName).scene; }

Scene sceneFromText(const std::string& text) { return parseScene(text, "test.p3f", kScenes).scene; }

RenderSettings squareSettings(std::uint32_t side, std::uint32_t samples) {
  RenderSettings settings;
  settings.size = {side, side};
  settings.sampleCount = samples;
  return settings;
}

std::string testDevice() {
  const char* selector = std::getenv("CANDELA_TEST_DEVICE");
  return selector == nullptr ? "" : selector;
}

Renderer& testRenderer() {
  static const std::unique_ptr<Renderer> renderer = makeGpuRenderer(testDevice());
  return *renderer;
}

RenderResult renderOnDevice(const Scene& scene, const RenderSettings& settings) {
  RenderResult result = testRenderer().render(scene, settings, {});
  REQUIRE(result.statistics.truncated == 0);
  return result;
}

RenderResult renderOnReference(const Scene& scene, const RenderSettings& settings) {
  return makeReferenceRenderer()->render(scene, settings, {});
}

double meanLuminance(const Film& film) {
  double sum = 0;
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) sum += pixelLuminance(film, x, y);
  }
  return sum / (static_cast<double>(film.width()) * film.height());
}

double pixelLuminance(const Film& film, std::uint32_t x, std::uint32_t y) { return luminance(film.mean(x, y)); }

}  // namespace candela
