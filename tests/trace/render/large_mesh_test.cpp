// A mesh of so many vertices that its triangles need long numbers for them (shaders/shared/scene_rows.h) has the film
// of the same triangles in smaller meshes.
#include <catch2/catch.hpp>
#include <cmath>

#include "host/formats/loading/scene_builder.h"
#include "shaders/shared/scene_rows.h"
#include "tests/trace/light/normal_mapped_meshes.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/render_support.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;

namespace {

constexpr std::uint32_t kCells = 1450;
static_assert((kCells + 1) * (kCells + 1) > gpu::kMaxPackedVertices);
static_assert((kCells / 2 + 1) * (kCells + 1) < gpu::kMaxPackedVertices);

// The rows of cells from `first` to before `end` of waves on the square of side 2 around the origin.
scene::Mesh waves(std::uint32_t first, std::uint32_t end) {
  scene::Mesh mesh;
  for (std::uint32_t row = first; row <= end; ++row) {
    for (std::uint32_t column = 0; column <= kCells; ++column) {
      const float x = 2.0f * static_cast<float>(column) / kCells - 1, y = 2.0f * static_cast<float>(row) / kCells - 1;
      mesh.positions.emplace_back(x, y, 0.05f * std::sin(20 * x) * std::sin(20 * y));
      mesh.normals.push_back(
          glm::normalize(vec3(-std::cos(20 * x) * std::sin(20 * y), -std::sin(20 * x) * std::cos(20 * y), 1)));
      mesh.texCoords[0].emplace_back(8 * x, 8 * y);
      if (row == end || column == kCells) continue;
      const std::uint32_t at = (row - first) * (kCells + 1) + column;
      mesh.indices.insert(mesh.indices.end(), {at, at + 1, at + kCells + 2, at, at + kCells + 2, at + kCells + 1});
    }
  }
  return mesh;
}

scene::Scene sceneOf(std::initializer_list<scene::Mesh> meshes) {
  test::SceneBuilder b;
  b.scene.images.push_back(test::bumps(16));
  b.material(test::diffuseMaterial(vec3(0.8f)));
  b.scene.materials.back().textures[static_cast<std::size_t>(scene::TextureSlot::baseColour)].emplace();
  for (const scene::Mesh& mesh : meshes) addMesh(b.scene, mesh, 0);
  b.scene.background = vec3(0.5f);
  b.view({0, -2, 1.5f}, {0, 0, 0}, {0, 0, 1}, 50);
  return b.scene;
}

}  // namespace

TEST_CASE("a mesh of more than two million vertices has the film of its halves", "[slow]") {
  const render::RenderSettings settings = squareSettings(64, 2);
  const render::RenderResult whole = renderOnDevice(sceneOf({waves(0, kCells)}), settings);
  const render::RenderResult halves = renderOnDevice(sceneOf({waves(0, kCells / 2), waves(kCells / 2, kCells)}),
                                                     settings);
  CHECK(whole.film.hash() == halves.film.hash());
}
