// Renders on the device under test, and compares films.
#include "tests/trace/render/render_support.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "host/formats/load_scene.h"
#include "host/formats/nff/nff_loader.h"
#include "tests/trace/reference/default_settings.h"
#include "tests/trace/vulkan_support/test_device.h"

namespace candela::device {
namespace {

const std::filesystem::path kScenes = std::filesystem::path(CANDELA_SOURCE_DIR) / "scenes";
const std::filesystem::path kSpd = std::filesystem::path(CANDELA_SOURCE_DIR) / "tests/formats/nff/spd";

}  // namespace

std::vector<std::filesystem::path> sceneFiles() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
    if (entry.is_regular_file() && entry.path().extension() == ".p3f") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

scene::Scene loadTestScene(const std::string& fileName) { return formats::loadScene(kScenes / fileName).scene; }

scene::Scene primitivesUnderLights() {
  scene::Scene scene = loadTestScene("primitives.p3f");
  for (int i = 0; i < 11; ++i) {
    const auto step = static_cast<float>(i);
    scene.pointLights.push_back({{step - 5, -6 + 0.7f * step, 3 + 0.3f * step}, glm::vec3(0.05f + 0.02f * step)});
  }
  return scene;
}

scene::Scene loadSpdScene(const std::string& fileName) { return formats::loadScene(kSpd / fileName).scene; }

scene::Scene sceneFromText(const std::string& text) { return scene::parseScene(text, "test.p3f", kScenes).scene; }

render::RenderSettings squareSettings(std::uint32_t side, std::uint32_t samples) {
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {side, side};
  settings.image.sampleCount = samples;
  return settings;
}

std::string testDevice() {
  const char* selector = std::getenv("CANDELA_TEST_DEVICE");
  return selector == nullptr ? "" : selector;
}

render::Renderer& testRenderer() {
  static std::unique_ptr<render::Renderer> renderer;
  if (!renderer) {
    renderer = makeGpuRenderer(testDevice());
    atTestRunEnd([] { renderer.reset(); });
  }
  return *renderer;
}

render::RenderResult renderOnDevice(const scene::Scene& scene, const render::RenderSettings& settings) {
  render::RenderResult result = testRenderer().render(scene, settings, {});
  REQUIRE(result.statistics.truncated == 0);
  return result;
}

render::RenderResult renderOnReference(const scene::Scene& scene, const render::RenderSettings& settings) {
  return reference::makeReferenceRenderer()->render(scene, settings, {});
}

void requireEqualCounts(const render::RenderStatistics& a, const render::RenderStatistics& b) {
  CHECK(a.samples == b.samples);
  CHECK(a.badSamples == b.badSamples);
  CHECK(a.cameraRays == b.cameraRays);
  CHECK(a.bounceRays == b.bounceRays);
  CHECK(a.shadowRays == b.shadowRays);
  CHECK(a.vertices == b.vertices);
  CHECK(a.traversalSteps == b.traversalSteps);
  CHECK(a.truncated == 0);
  CHECK(b.truncated == 0);
}

double meanLuminance(const image::Film& film) {
  double sum = 0;
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) sum += pixelLuminance(film, x, y);
  }
  return sum / (static_cast<double>(film.width()) * film.height());
}

double pixelLuminance(const image::Film& film, std::uint32_t x, std::uint32_t y) {
  return image::luminance(film.mean(x, y));
}

}  // namespace candela::device
