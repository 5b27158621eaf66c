// Renders a scene with an installed Candela to an image file and to a film file, which it continues if it exists:
// consumer SCENE cpu|DEVICE IMAGE FILM
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "host/formats/load_scene.h"
#include "host/image/image.h"
#include "host/job/run_job.h"
#include "host/trace/device/gpu_renderer.h"
#include "host/trace/render/request.h"

int main(int argc, char** argv) try {
  if (argc != 5) return 1;
  const std::string device = argv[2];
  const std::filesystem::path film = argv[4];
  const auto scene = std::make_shared<const candela::scene::Scene>(candela::formats::loadScene(argv[1]).scene);

  candela::render::RenderRequest request;  // everything else is as the scene requests
  request.size = candela::render::Extent{64, 64};
  request.sampleCount = 4;
  candela::job::Job job{scene, {}, candela::render::resolve(request, *scene)};
  job.film.checkpoint = film;
  if (std::filesystem::exists(film)) job.film.resume = film;

  candela::job::OpenDevice open;  // empty: the reference tracer
  if (device != "cpu") open = [&] { return candela::device::makeGpuRenderer(device); };
  const candela::Log log(std::cerr, candela::Verbosity::normal);
  const candela::job::JobResult done = candela::job::runJob(job, open, {}, log);
  candela::image::writeImage(argv[3], candela::image::toImage(done.result.film), {});
  std::cout << done.result.statistics.device << '\n';
  return done.isFilmLost || done.failure ? 1 : 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
