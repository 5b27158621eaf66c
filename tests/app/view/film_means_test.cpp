// Pictures that a device makes of its own film.
#include "host/trace/device/film_means.h"

#include <catch2/catch.hpp>

#include "host/app/view/picture.h"
#include "tests/trace/render/render_support.h"
#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::device;

namespace {

view::Picture pictureOf(const FilmMeans& means) {
  view::Picture picture(means.size());
  means.buffer().download(std::as_writable_bytes(std::span(picture.pixels)));
  return picture;
}

void requireClose(const view::Picture& actual, const view::Picture& expected) {
  std::size_t unequal = 0;
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    const glm::vec4 apart = glm::abs(actual.pixels[i] - expected.pixels[i]);
    const glm::vec4 allowed = 1e-6f * glm::abs(expected.pixels[i]);
    unequal += apart.w != 0 || glm::any(glm::greaterThan(apart, allowed));
  }
  CHECK(unequal == 0);
}

}  // namespace

TEST_CASE("the means of a film are computed on the device as on the host, in every resolution") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  vulkan::Device device = openTestDevice();
  const auto session = makeGpuRenderer(device)->prepare(scene, squareSettings(40, 3));
  FilmMeans means(device, {40, 40});
  CHECK(!means.update(*session));  // no film is on the device yet
  view::Picture expected({40, 40});
  for (const std::uint32_t side : {5u, 20u, 40u}) {
    session->setView(*scene.camera, {side, side});
    session->advance({0, side == 40 ? 3u : 1u}, {});
    REQUIRE(means.update(*session));
    show(session->film(), expected);
    requireClose(pictureOf(means), expected);
  }
}

TEST_CASE("the means of a film with a scale are those of its samples") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  vulkan::Device device = openTestDevice();
  render::RenderSettings settings = squareSettings(40, 2);
  settings.image.filmScale = 9;
  const auto session = makeGpuRenderer(device)->prepare(scene, settings);
  session->advance({0, 2}, {});
  FilmMeans means(device, {40, 40});
  REQUIRE(means.update(*session));
  view::Picture expected({40, 40});
  show(session->film(), expected);
  requireClose(pictureOf(means), expected);
}

TEST_CASE("films in several bands, and those of the reference, are not on the device") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  vulkan::Device device = openTestDevice();
  const auto banded = makeGpuRenderer(device,
                                      {.loopLimit = std::nullopt, .form = std::nullopt, .maxBandBytes = 64 << 10})
                          ->prepare(scene, squareSettings(40, 1));
  banded->advance({0, 1}, {});
  const auto reference = reference::makeReferenceRenderer()->prepare(scene, squareSettings(40, 1));
  reference->advance({0, 1}, {});
  FilmMeans means(device, {40, 40});
  CHECK(!means.update(*banded));
  CHECK(!means.update(*reference));
}
