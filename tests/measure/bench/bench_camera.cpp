// Measures how long Session::setCamera takes on a device: the host's time and that of the upload, without any tracing.
// Medians.
//   ninja bench_camera && tests/measure/bench/bench_camera SCENE... (CANDELA_TEST_DEVICE chooses the device)
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "host/base/statistics/quantiles.h"
#include "host/base/stopwatch.h"
#include "host/formats/load_scene.h"
#include "host/trace/device/gpu_renderer.h"
#include "host/trace/render/request.h"

using namespace candela;

namespace {

constexpr int kMoves = 51;

void measure(render::Renderer& renderer, const std::string& file) {
  const scene::Scene scene = formats::loadScene(file).scene;
  render::RenderRequest request;
  request.size = {256, 256};
  request.sampleCount = 1;
  const render::RenderSettings settings = render::resolve(request, scene);
  Stopwatch watch;
  const std::unique_ptr<render::Session> session = renderer.prepare(scene, settings);
  const double prepared = watch.lap();
  session->advance({0, 1}, {});
  std::vector<double> seconds;
  for (int i = 0; i < kMoves; ++i) {
    scene::Camera camera = *scene.camera;
    camera.from += 0.001f * static_cast<float>(i + 1) * (camera.at - camera.from);
    watch.lap();
    session->setCamera(camera);
    seconds.push_back(watch.lap());
  }
  std::ranges::sort(seconds);
  fmt::print("{}: {} primitives; prepare {:.0f} ms, setCamera {:.2f} ms ({:.2f} to {:.2f})\n", file,
             scene.primitives.size(), 1e3 * prepared, 1e3 * statistics::median(seconds), 1e3 * seconds.front(),
             1e3 * seconds.back());
}

}  // namespace

int main(int count, char** arguments) {
  const char* const device = std::getenv("CANDELA_TEST_DEVICE");
  const std::unique_ptr<render::Renderer> renderer = device::makeGpuRenderer(device == nullptr ? "" : device);
  for (int i = 1; i < count; ++i) measure(*renderer, arguments[i]);
}
