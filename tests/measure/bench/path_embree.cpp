// Renders a scene of diffuse triangles with a path tracer on Embree, and times it. Built where Embree 3 is found:
//   ninja path_embree && tests/measure/bench/path_embree SCENE OUT.exr [spp] [pixels a side] [seed] [max depth]
// Prints one line of JSON that begins with `embree: `: seconds and processor seconds of path tracing alone.
#include <fmt/format.h>
#include <sys/resource.h>

#include "host/base/errors.h"
#include "host/base/stopwatch.h"
#include "host/formats/load_scene.h"
#include "host/trace/render/request.h"
#include "tests/measure/bench/embree_path_tracer.h"

using namespace candela;

namespace {

double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount < 3) {
    fmt::print("path_embree SCENE OUT.exr [spp] [pixels a side] [seed] [max depth]\n");
    return static_cast<int>(ExitCode::usage);
  }
  const auto number = [&](int i, std::uint32_t otherwise) {
    return argumentCount > i ? static_cast<std::uint32_t>(std::stoul(arguments[i])) : otherwise;
  };
  try {
    const scene::Scene scene = formats::loadScene(arguments[1]).scene;
    render::RenderRequest request;
    request.sampleCount = number(3, 16);
    request.size = {number(4, 512), number(4, 512)};
    request.image.seed = number(5, 0);
    if (argumentCount > 6) request.maxDepth = number(6, 0);
    const bench::EmbreePathTracer tracer(scene, render::resolve(request, scene));
    const double before = processorSeconds();
    Stopwatch watch;
    const image::Image picture = tracer.render();
    const double seconds = watch.lap(), ofProcessor = processorSeconds() - before;
    writeImage(arguments[2], picture, {});
    fmt::print("embree: {{\"seconds\": {}, \"processorSeconds\": {}, \"version\": \"Embree {}\"}}\n", seconds,
               ofProcessor, RTC_VERSION_STRING);
  } catch (const std::exception& error) {
    fmt::print(stderr, "path_embree: {}\n", error.what());
    return static_cast<int>(ExitCode::file);
  }
}
