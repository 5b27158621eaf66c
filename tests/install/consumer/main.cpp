// Renders a scene with an installed Candela to an image file and to a film file, which it continues if it exists:
// consumer SCENE cpu|DEVICE IMAGE FILM
#include <candela/errors.h>
#include <candela/film.h>
#include <candela/image.h>
#include <candela/scene.h>
#include <candela/session.h>
#include <candela/settings.h>

#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

int main(int argc, char** argv) try {
  if (argc != 5) return 1;
  const std::string device = argv[2];
  const std::filesystem::path film = argv[4];
  const auto scene = std::make_shared<const candela::Scene>(candela::loadScene(argv[1]).scene);

  candela::RenderRequest request;  // everything else is as the scene requests
  request.size = candela::Extent{64, 64};
  request.sampleCount = 4;
  candela::Job job{scene, {}, candela::resolve(request, *scene)};
  job.film.checkpoint = film;
  if (std::filesystem::exists(film)) job.film.resume = film;

  candela::OpenDevice open;  // empty: the reference tracer
  if (device != "cpu") open = [&] { return candela::makeGpuRenderer(device); };
  const candela::Log log(std::cerr, candela::Verbosity::normal);
  const candela::JobResult done = candela::runJob(job, open, {}, log);
  candela::writeImage(argv[3], candela::toImage(done.result.film), {});
  std::cout << done.result.statistics.device << '\n';
  return done.isFilmLost || done.failure ? 1 : 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
