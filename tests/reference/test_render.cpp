// Whole renders by the reference: sameness of bytes, statistics, records, interruption.
#include <atomic>
#include <catch2/catch.hpp>

#include "tests/reference/scene_builder.h"

using namespace candela;
using namespace candela::test;

TEST_CASE("neither threads nor tiles nor the structure change a byte of the film") {
  const Scene scene = cornellBox().scene;
  RenderSettings settings = settingsOf(24, 17, 4);
  settings.threads = 1;
  const std::uint64_t hash = render(scene, settings).film.hash();

  settings.threads = 2;
  CHECK(render(scene, settings).film.hash() == hash);
  settings.threads = 7;
  settings.tile = Extent{5, 3};
  CHECK(render(scene, settings).film.hash() == hash);
  settings.accel = AccelKind::none;
  CHECK(render(scene, settings).film.hash() == hash);
  settings.seed = 1;
  CHECK(render(scene, settings).film.hash() != hash);
}
