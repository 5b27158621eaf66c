// Renders that need more memory than is available.
#include "host/job/memory_need.h"

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "host/base/memory_budget.h"
#include "host/formats/loading/scene_builder.h"
#include "host/image/film.h"
#include "host/scene/memory.h"

namespace candela::job {
namespace {

/// A mesh of `count` triangles that share their vertices.
scene::Scene heavyScene(std::size_t count) {
  scene::Scene scene;
  scene.name = "heavy.glb";
  scene.materials.resize(1);
  scene::Mesh mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  for (std::size_t i = 0; i < count; ++i) mesh.indices.insert(mesh.indices.end(), {0, 1, 2});
  addMesh(scene, std::move(mesh), 0);
  return scene;
}

/// Returns the message that refuses a render of one pixel under a budget.
std::string refusalOf(const scene::Scene& scene, std::uint64_t budget,
                      const render::StructureSettings& structure = {}) {
  render::ImageSettings image;
  image.size = {1, 1};
  limitMemory(budget);
  try {
    requireMemoryForRender(scene, image, structure, false);
    limitMemory(0);
    return "";
  } catch (const OutOfMemoryError& error) {
    limitMemory(0);
    CHECK(error.code() == ExitCode::outOfMemory);
    return error.what();
  }
}

}  // namespace

TEST_CASE("a scene is refused if building its structure exceeds the memory, although the scene itself fits") {
  const scene::Scene scene = heavyScene(100'000);
  const std::uint64_t own = scene::memoryOf(scene).total;
  CHECK(own < 3'000'000);
  const std::uint64_t film = 2 * sizeof(image::FilmPixel);
  CHECK(refusalOf(scene, own + film + 30'000'000).empty());
  const std::string refusal = refusalOf(scene, own + film + 29'999'999);
  CHECK(refusal.starts_with("heavy.glb: rendering 100000 primitives to 1x1 pixels needs about"));
  CHECK(refusal.find("; memory allows") != std::string::npos);
  CHECK(refusal.ends_with("render fewer primitives"));
}

TEST_CASE("the triangles of instances count once, unless the structure needs copies") {
  scene::Scene scene = heavyScene(1);
  scene::Mesh mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  for (int i = 0; i < 10'000; ++i) mesh.indices.insert(mesh.indices.end(), {0, 1, 2});
  const std::uint32_t stored = storeMesh(scene, std::move(mesh));
  for (int i = 0; i < 50; ++i) addInstance(scene, stored, *scene::placementOf(glm::dmat4(1)), 0);
  CHECK(refusalOf(scene, 4'000'000).empty());
  render::StructureSettings grid;
  grid.accel = render::AccelKind::grid;
  CHECK_THAT(refusalOf(scene, 100'000'000, grid), Catch::StartsWith("heavy.glb: rendering 500001 primitives"));
}

}  // namespace candela::job
