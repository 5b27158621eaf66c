// The records that flatten writes, compared with the scene.
#include <bit>
#include <catch2/catch.hpp>
#include <set>

#include "host/formats/load_scene.h"
#include "host/formats/loading/scene_builder.h"
#include "host/scene/coincidence/coincidence.h"
#include "host/trace/accel/grid.h"
#include "host/trace/accel/primitive_bounds.h"
#include "host/trace/flatten/flat_scene.h"
#include "shaders/shared/scene_rows.h"
#include "tests/trace/reference/default_settings.h"

using namespace candela;

namespace {

scene::Scene loadFixture(const char* name) {
  return formats::loadScene(std::filesystem::path(CANDELA_SOURCE_DIR) / "scenes" / name).scene;
}

render::RenderSettings smallSettings() {
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {64, 64};
  return settings;
}

glm::dvec3 xyz(const gpu::uvec4& row) {
  return {std::bit_cast<float>(row.x), std::bit_cast<float>(row.y), std::bit_cast<float>(row.z)};
}

}  // namespace

TEST_CASE("every primitive has one slot, with infinite planes last") {
  const scene::Scene scene = loadFixture("primitives.p3f");
  for (const render::AccelKind accel : {render::AccelKind::none, render::AccelKind::grid, render::AccelKind::bvh}) {
    render::RenderSettings settings = smallSettings();
    settings.structure.accel = accel;
    const flatten::FlatScene flat = flatten::flattenScene(scene, settings);
    REQUIRE(flat.shape.slotCount == scene.primitives.size());
    std::set<std::uint32_t> seen;
    for (std::uint32_t slot = 0; slot < flat.shape.slotCount; ++slot) {
      const std::uint32_t row = flat.constants.firstPrimitiveRow + slot * gpu::kPrimitiveRows;
      const std::uint32_t primitive = flat.rows[row + 1].w;
      const std::uint32_t kind = flat.rows[row + 2].w;
      seen.insert(primitive);
      CHECK((kind & gpu::kKindMask) == static_cast<std::uint32_t>(scene.primitives[primitive].kind));
      CHECK(kind >> gpu::kMaterialShift == scene.primitives[primitive].material);
      CHECK(((kind & gpu::kKindMask) == gpu::kKindPlane) == (slot >= flat.constants.firstPlaneSlot));
    }
    CHECK(seen.size() == scene.primitives.size());
  }
}

TEST_CASE("a huge sphere's anchor lies on it and k points from its centre") {
  const scene::Scene scene = loadFixture("smallpt.p3f");
  render::RenderSettings settings = smallSettings();
  settings.structure.accel = render::AccelKind::none;
  const flatten::FlatScene flat = flatten::flattenScene(scene, settings);
  for (std::uint32_t slot = 0; slot < flat.shape.slotCount; ++slot) {
    const std::uint32_t row = flat.constants.firstPrimitiveRow + slot * gpu::kPrimitiveRows;
    const scene::Sphere& sphere = scene.spheres[scene.primitives[flat.rows[row + 1].w].index];
    const glm::dvec3 anchor = xyz(flat.rows[row]);
    const glm::dvec3 k = xyz(flat.rows[row + 1]);
    const double scale = std::max(glm::length(anchor), 1.0);
    CHECK(std::abs(glm::length(anchor - glm::dvec3(sphere.centre)) - std::abs(sphere.radius)) <= 1e-6 * scale);
    CHECK(glm::length(k) == Approx(1).epsilon(1e-6));
    CHECK(std::bit_cast<float>(flat.rows[row].w) == std::abs(sphere.radius));
  }
}

TEST_CASE("the record of a light refers to its primitive, and the primitive to the light") {
  const scene::Scene scene = loadFixture("cornell.p3f");
  const flatten::FlatScene flat = flatten::flattenScene(scene, smallSettings());
  REQUIRE(flat.constants.lightCount == 2);  // the light's two triangles
  for (std::uint32_t light = 0; light < 2; ++light) {
    const gpu::uvec4& head = flat.rows[flat.constants.firstLightRow + light * gpu::kLightRows];
    const std::uint32_t row = flat.constants.firstPrimitiveRow + head.w * gpu::kPrimitiveRows;
    CHECK(flat.rows[flat.constants.firstLightRow + light * gpu::kLightRows + 1].w == gpu::kLightTriangle);
    const std::size_t geometry = flat.constants.firstGeometryRow + flat.rows[row].w * gpu::kGeometryRows;
    CHECK(flat.rows[geometry].x == 0);
    CHECK(flat.rows[geometry + 1].x == 1);
    CHECK(flat.rows[geometry + 1].y + flat.rows[row + 1].w == light + 1);
  }
}

TEST_CASE("features that a scene does not use are disabled") {
  const flatten::FlatScene smallpt = flatten::flattenScene(loadFixture("smallpt.p3f"), smallSettings());
  CHECK(smallpt.shape.features.spheres);
  CHECK(!smallpt.shape.features.triangles);
  CHECK(smallpt.shape.features.sphereLights);
  CHECK(!smallpt.shape.features.pointLights);
  CHECK(!smallpt.shape.features.glossy);
  CHECK(!smallpt.shape.features.sky);
  render::RenderSettings withoutLightSampling = smallSettings();
  withoutLightSampling.image.nextEventEstimation = false;
  CHECK(!flatten::flattenScene(loadFixture("smallpt.p3f"), withoutLightSampling).shape.features.sphereLights);
  CHECK(flatten::flattenScene(loadFixture("sky.p3f"), smallSettings()).shape.features.sky);
}

TEST_CASE("a scene without primitives has no structure and no slots") {
  scene::Scene scene;
  scene.camera = scene::Camera{};
  for (const render::AccelKind accel : {render::AccelKind::none, render::AccelKind::grid, render::AccelKind::bvh}) {
    render::RenderSettings settings = smallSettings();
    settings.structure.accel = accel;
    const flatten::FlatScene flat = flatten::flattenScene(scene, settings);
    CHECK(flat.shape.slotCount == 0);
    CHECK(flat.shape.structure == gpu::kStructureNone);
  }
}

TEST_CASE("a grid's records contain three cells or four items each") {
  const scene::Scene scene = loadFixture("primitives.p3f");
  render::RenderSettings settings = smallSettings();
  settings.structure.accel = render::AccelKind::grid;
  settings.structure.gridDensity = 3;
  const flatten::FlatScene flat = flatten::flattenScene(scene, settings);
  REQUIRE(flat.shape.structure == gpu::kStructureGrid);
  const accel::SceneBounds bounds = accel::boundPrimitives(scene, scene::findCoincidences(scene).coincident);
  const accel::Grid grid = buildGrid(bounds.bounds, {.density = 3});
  REQUIRE(flat.constants.gridSides == grid.shape.sides);
  CHECK(flat.constants.gridStrides == grid.shape.strides);
  CHECK(flat.constants.gridScale == grid.shape.scale);
  CHECK(flat.constants.gridLow == grid.shape.bounds.min);
  CHECK(flat.constants.gridHigh == grid.shape.bounds.max);
  for (std::uint32_t cell = 0; cell < grid.shape.cellCount(); ++cell) {
    const gpu::uvec4& starts = flat.rows[flat.constants.firstStructureRow + cell / gpu::kCellsPerRow];
    const int place = static_cast<int>(cell % gpu::kCellsPerRow);
    REQUIRE(starts[place] == grid.starts[cell]);
    REQUIRE(starts[place + 1] == grid.starts[cell + 1]);
  }
  for (std::uint32_t item = 0; item < grid.items.size(); ++item) {
    const gpu::uvec4& items = flat.rows[flat.constants.firstItemRow + item / gpu::kItemsPerRow];
    const std::uint32_t slot = items[static_cast<int>(item % gpu::kItemsPerRow)];
    const std::uint32_t primitive = flat.rows[flat.constants.firstPrimitiveRow + slot * gpu::kPrimitiveRows + 1].w;
    REQUIRE(primitive == bounds.finite[grid.items[item]]);
  }
}

TEST_CASE("a grid has at most the given number of cells along an axis") {
  render::RenderSettings settings = smallSettings();
  settings.structure.accel = render::AccelKind::grid;
  const scene::Scene scene = loadFixture("primitives.p3f");
  const flatten::FlatScene free = flatten::flattenScene(scene, settings);
  const flatten::FlatScene limited = flatten::flattenScene(scene, settings, {.maxGridSide = 4, .smallScene = {}});
  CHECK(free.constants.gridSides.x > 4);
  CHECK(glm::all(glm::lessThanEqual(limited.constants.gridSides, glm::uvec3(4))));
  CHECK(free.structureQuality.at("density") == 2);
  CHECK(limited.structureQuality.at("density") < 2);
}

TEST_CASE("the bytes of a structure are those of all records before the primitives, with and without instances") {
  scene::Scene scene = loadFixture("primitives.p3f");
  const auto structureBytes = [&] {
    render::RenderSettings settings = smallSettings();
    settings.structure.bvhLayout = render::BvhLayout::cwbvh;
    const flatten::FlatScene flat = flatten::flattenScene(scene, settings);
    const double bytes = flat.structureQuality.at("bytes");
    CHECK(bytes == static_cast<double>(flat.constants.firstPrimitiveRow * sizeof(gpu::uvec4)));
    return bytes;
  };
  const double alone = structureBytes();
  scene::Mesh strip;
  for (std::uint32_t i = 0; i <= scene::kMinInstanceTriangles; ++i) {
    strip.positions.emplace_back(static_cast<float>(i), static_cast<float>(i % 2), 0.0f);
    if (i > 1) strip.indices.insert(strip.indices.end(), {i - 2, i - 1, i});
  }
  strip.positions.emplace_back(0.0f, 2.0f, 0.0f);
  strip.indices.insert(strip.indices.end(), {0, 1, scene::kMinInstanceTriangles + 1});
  scene.meshes.push_back(strip);
  const auto mesh = static_cast<std::uint32_t>(scene.meshes.size() - 1);
  for (const double x : {0.0, 100.0}) {
    glm::dmat4 map(1);
    map[3].x = x;
    scene::addInstance(scene, mesh, scene::placementOf(map).value(), 0);
  }
  CHECK(structureBytes() > alone);
}

TEST_CASE("the Whitted tracer's lights are squares that face the camera's target") {
  scene::Scene scene = loadFixture("point_light.p3f");
  scene.pointLights.push_back({scene.camera->at, glm::vec3(1)});  // faces z
  render::RenderSettings settings = smallSettings();
  settings.image.integrator = render::Integrator::whitted;
  settings.image.maxDepth = 4;
  settings.image.lightSize = 0.5f;
  const flatten::FlatScene flat = flatten::flattenScene(scene, settings);
  REQUIRE(flat.constants.lightCount == scene.pointLights.size());
  for (std::size_t i = 0; i < scene.pointLights.size(); ++i) {
    const std::size_t row = flat.constants.firstLightRow + i * gpu::kPointLightRows;
    const glm::dvec3 edgeU = xyz(flat.rows[row + 2]);
    const glm::dvec3 edgeV = xyz(flat.rows[row + 3]);
    const glm::dvec3 towards = glm::dvec3(scene.camera->at) - glm::dvec3(scene.pointLights[i].position);
    const glm::dvec3 facing = glm::length(towards) > 0 ? glm::normalize(towards) : glm::dvec3(0, 0, 1);
    CHECK(xyz(flat.rows[row]) == glm::dvec3(scene.pointLights[i].colour));
    CHECK(xyz(flat.rows[row + 1]) == glm::dvec3(scene.pointLights[i].position));
    CHECK(glm::length(glm::cross(edgeU, edgeV) - 0.25 * facing) < 1e-7);
    CHECK(glm::length(edgeU) == Approx(0.5));
  }
}

TEST_CASE("states have space for a pending ray at each depth but the first if the scene has glass") {
  render::RenderSettings settings = smallSettings();
  settings.image.integrator = render::Integrator::whitted;
  settings.image.maxDepth = 5;
  CHECK(flatten::flattenScene(loadFixture("point_light.p3f"), settings).constants.stateRows == gpu::kTreeRows);
  CHECK(flatten::flattenScene(loadFixture("primitives.p3f"), settings).constants.stateRows ==
        gpu::kTreeRows + 4 * gpu::kPendingRows);
}
