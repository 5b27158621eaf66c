// Prints, as JSON, one verdict for each relative error of the device's albedos:
//   measure_power SCENE SIDE SEED BIAS SECONDS ERROR...
// SIDE is the side of the square image in pixels. BIAS is verify's --bias, and SECONDS its --time-limit; 0: its
// default. The device renders the scene with the colours of all lobes multiplied by 1 + ERROR, and the reference
// without.
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "host/formats/load_scene.h"
#include "host/judge/verify/verify.h"
#include "host/trace/device/gpu_renderer.h"
#include "host/trace/reference/reference_renderer.h"
#include "tests/judge/verify/changed_renderer.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::verify {
namespace {

void scaleAlbedos(scene::Scene& scene, float factor) {
  for (scene::Material& material : scene.materials) {
    if (material.surface) throw std::invalid_argument("only scenes of NFF and P3F have lobes whose colours are scaled");
    if (material.diffuse) material.diffuse->colour *= factor;
    if (material.glossy) material.glossy->colour *= factor;
    if (material.dielectric) material.dielectric->colour *= factor;
    if (material.mirror) material.mirror->colour *= factor;
  }
}

std::optional<double> positive(double value) { return value > 0 ? std::optional(value) : std::nullopt; }

// Processor time of all threads, drivers' included, in seconds.
double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

nlohmann::ordered_json verdictOn(double error, const scene::Scene& scene, const render::RenderSettings& settings,
                                 const LightTestOptions& options, render::Renderer& device) {
  scene::Scene changed = scene;
  scaleAlbedos(changed, static_cast<float>(1 + error));
  ChangedRenderer changedDevice(device, changed);
  const double start = processorSeconds();
  const VerifyReport report = verifyScene(scene, settings, changedDevice, *reference::makeReferenceRenderer(), options,
                                          {});
  return {{"error", error},
          {"seed", settings.image.seed},
          {"foundByPaths", !report.paths.agree()},
          {"foundByLight", report.light.differs()},
          {"oddDevice", report.paths.decisions.oddDevice},
          {"samplesPerPixel", report.light.samplesPerPixel},
          {"looks", report.light.looks},
          {"relativeDifference", report.light.image().relativeDifference()},
          {"margin", report.light.image().margin / report.light.image().referenceMean},
          {"detectableBias", report.light.image().detectableBias},
          {"seconds", report.seconds},
          {"processorSeconds", processorSeconds() - start}};
}

void measure(char** words, int errorCount) {
  const scene::Scene scene = formats::loadScene(words[1]).scene;
  render::RenderSettings settings = render::defaultSettings();
  const auto side = static_cast<std::uint32_t>(std::atoi(words[2]));
  settings.image.size = {side, side};
  settings.image.seed = static_cast<std::uint32_t>(std::atoi(words[3]));
  const LightTestOptions options{.bias = positive(std::atof(words[4])), .timeLimit = positive(std::atof(words[5]))};
  const std::unique_ptr<render::Renderer> device = device::makeGpuRenderer("");
  for (int i = 0; i < errorCount; ++i) {
    std::cout << verdictOn(std::atof(words[6 + i]), scene, settings, options, *device).dump() << std::endl;
  }
}

}  // namespace
}  // namespace candela::verify

int main(int argc, char** argv) {
  if (argc < 7) {
    std::cerr << "usage: measure_power SCENE SIDE SEED BIAS SECONDS ERROR...\n";
    return 1;
  }
  try {
    candela::verify::measure(argv, argc - 6);
  } catch (const std::exception& error) {
    std::cerr << "measure_power: " << error.what() << '\n';
    return 2;
  }
  return 0;
}
