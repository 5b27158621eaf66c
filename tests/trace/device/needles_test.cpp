// Needles, triangles that are much longer than wide: a hit must not depend on the structure in which it was searched.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "spirv/surface_leaf.h"
#include "tests/trace/device/cast_words.h"
#include "tests/trace/device/scene_leaf.h"
#include "tests/trace/reference/placed_meshes.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/render_support.h"
#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::device;
using glm::dvec3;

namespace {

using Triangle = std::array<dvec3, 3>;

dvec3 direction(test::RandomMaps& random) {
  const double z = random.number(-1, 1), angle = random.number(0, glm::two_pi<double>());
  const double radius = std::sqrt(1 - z * z);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

// Needles through a ball of radius 1, of a width between 1/1000 and 10^-digits of their length. Half of them are
// parallel to an axis, so that their boxes are hardly larger than they are.
std::vector<Triangle> needles(test::RandomMaps& random, std::size_t count, double digits = 6) {
  std::vector<Triangle> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    const dvec3 middle = 0.7 * random.point(1);
    dvec3 along = direction(random), across = direction(random);
    const int axis = static_cast<int>(i / 2 % 3);
    if (i % 2 == 0) along = across = dvec3(0), along[axis] = across[(axis + 1) % 3] = 1;
    across = glm::normalize(across - glm::dot(across, along) * along);
    const double length = std::pow(10, random.number(-1, 0)), width = length * std::pow(10, random.number(-digits, -3));
    const dvec3 start = middle - random.number(0, 1) * length * along;
    result[i] = {start, start + length * along, start + random.number(0, 1) * length * along + width * across};
  }
  return result;
}

// Triangles that share the ball into slices, so that rays have other hits between the box of a needle and its distance.
void addSlices(test::SceneBuilder& b) {
  constexpr int kSlices = 250;
  for (int i = 0; i < kSlices; ++i) {
    const float x = 2.0f * static_cast<float>(i) / kSlices - 1;
    b.triangle({x, -4, -4}, {x, 4, -4}, {x, 0, 4});
  }
}

// Rays to random points of the triangles from close by, in directions of which most are close to that of the needle.
std::vector<gpu::CastRay> raysTo(const std::vector<Triangle>& triangles, test::RandomMaps& random, std::size_t count) {
  std::vector<gpu::CastRay> rays(count);
  for (gpu::CastRay& ray : rays) {
    const auto at = static_cast<std::size_t>(random.number(0, static_cast<double>(triangles.size())));
    const auto& [a, b, c] = triangles[at];
    const double root = std::sqrt(random.number(0, 1)), second = root * random.number(0, 1);
    const dvec3 target = (1 - root) * a + (root - second) * b + second * c;
    const double turn = std::pow(10, random.number(-3, 1));
    const dvec3 towards = glm::normalize(glm::normalize(b - a) + turn * direction(random));
    const dvec3 origin = target - std::pow(10, random.number(-3.5, -0.5)) * towards;
    const glm::vec3 from(origin);
    ray.originLimit = glm::vec4(from, 1e30f);
    ray.direction = glm::vec4(glm::vec3(glm::normalize(target - dvec3(from))), 0);
  }
  return rays;
}

struct Search {
  const char* name;
  render::AccelKind accel;
  render::BvhLayout layout = render::BvhLayout::automatic;
  bool copiesInstances = true;
};

CastWords search(vulkan::Device& device, const scene::Scene& scene, const std::vector<gpu::CastRay>& rays,
                 const Search& how) {
  render::RenderSettings settings = squareSettings(1, 1);
  settings.structure.accel = how.accel;
  settings.structure.bvhLayout = how.layout;
  settings.structure.copiesInstances = how.copiesInstances;
  RayCaster caster(device, flatten::flattenScene(scene, settings), settings);
  return castWords(caster, rays, false);
}

std::size_t metBy(const CastWords& words) {
  return words.size() - static_cast<std::size_t>(
                            std::ranges::count(words, gpu::kNoPrimitive, [](const auto& word) { return word[1]; }));
}

void requireEqualHits(const scene::Scene& scene, const std::vector<gpu::CastRay>& rays) {
  vulkan::Device device = openTestDevice();
  const CastWords expected = search(device, scene, rays, {"list", render::AccelKind::none});
  CHECK(metBy(expected) > rays.size() / 2);
  for (const Search& how : {Search{"bvh2", render::AccelKind::bvh, render::BvhLayout::bvh2},
                            Search{"cwbvh", render::AccelKind::bvh, render::BvhLayout::cwbvh},
                            Search{"instances", render::AccelKind::bvh, render::BvhLayout::cwbvh, false},
                            Search{"grid", render::AccelKind::grid}}) {
    const CastWords found = search(device, scene, rays, how);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) differing += found[i] != expected[i];
    CAPTURE(how.name, rays.size(), metBy(expected), differing);
    CHECK(differing == 0);
  }
}

constexpr std::size_t kRays = 300000;

// The vertices of needles, whose colours are their positions.
scene::Mesh colouredMesh(const std::vector<Triangle>& triangles) {
  scene::Mesh mesh;
  for (const Triangle& triangle : triangles) {
    for (const dvec3& corner : triangle) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.emplace_back(corner);
      mesh.colours.emplace_back(glm::vec3(corner), 1.0f);
    }
  }
  return mesh;
}

// Where the line of a ray meets the plane of a triangle of a mesh, and by how much an error of 1 of the ray's origin
// could move that point.
struct Meeting {
  dvec3 point;
  double reach;
};
Meeting meetingOf(const gpu::CastRay& ray, const scene::Mesh& mesh, std::size_t triangle) {
  const auto corner = [&](std::size_t k) { return dvec3(mesh.positions[mesh.indices[3 * triangle + k]]); };
  const dvec3 origin(ray.originLimit), along(ray.direction);
  const dvec3 normal = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
  const double slope = glm::dot(along, normal);
  return {origin + glm::dot(corner(0) - origin, normal) / slope * along, 1 + 1 / std::abs(slope)};
}

double largest(const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

TEST_CASE("needles are hit at the same distance in every structure") {
  test::RandomMaps random(1);
  const std::vector<Triangle> triangles = needles(random, 300);
  test::SceneBuilder b;
  b.material(test::diffuseMaterial(glm::vec3(0.5f)));
  for (const auto& [p0, p1, p2] : triangles) b.triangle(glm::vec3(p0), glm::vec3(p1), glm::vec3(p2));
  addSlices(b);
  requireEqualHits(b.scene, raysTo(triangles, random, kRays));
}

TEST_CASE("needles of instances are hit at the same distance in every structure") {
  test::RandomMaps random(2);
  const std::vector<Triangle> ofMesh = needles(random, 80);
  scene::Mesh mesh;
  for (const Triangle& triangle : ofMesh) {
    for (const dvec3& corner : triangle) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.emplace_back(corner);
    }
  }
  test::SceneBuilder b;
  b.material(test::diffuseMaterial(glm::vec3(0.5f)));
  addSlices(b);
  const std::uint32_t stored = test::storeBoth(b.scene, mesh);
  std::vector<Triangle> triangles;
  for (int i = 0; i < 6; ++i) {
    const glm::dmat4 map = random.next(random.number(0.3, 1), random.point(1));
    test::addInstance(b.scene, map, stored, 0);
    for (const Triangle& triangle : ofMesh) {
      Triangle placed;
      for (std::size_t k = 0; k < 3; ++k) placed[k] = dvec3(map * glm::dvec4(triangle[k], 1));
      triangles.push_back(placed);
    }
  }
  requireEqualHits(b.scene, raysTo(triangles, random, kRays));
}

TEST_CASE("rays do not hit tiny triangles that are far beside them") {
  test::RandomMaps random(3);
  test::SceneBuilder b;
  b.material(test::diffuseMaterial(glm::vec3(0.5f)));
  for (int i = 0; i < 200; ++i) {
    const dvec3 middle(random.number(20, 60), 100, random.number(-20, 20));
    const auto corner = [&] { return glm::vec3(middle + random.point(1e-5)); };
    const glm::vec3 p0 = corner(), p1 = corner(), p2 = corner();
    b.triangle(p0, p1, p2);
  }
  std::vector<gpu::CastRay> rays(20000);
  for (gpu::CastRay& ray : rays) {
    ray.originLimit = glm::vec4(glm::vec3(random.point(1)), 1e30f);
    ray.direction = glm::vec4(glm::normalize(glm::vec3(dvec3(1, 0, 0) + 0.3 * random.point(1))), 0);
  }
  vulkan::Device device = openTestDevice();
  CHECK(metBy(search(device, b.scene, rays, {"list", render::AccelKind::none})) == 0);
}

TEST_CASE("rays reach needles where they meet their planes") {
  test::RandomMaps random(4);
  const std::vector<Triangle> triangles = needles(random, 300, 4);
  const scene::Mesh mesh = colouredMesh(triangles);
  test::SceneBuilder b;
  b.material(test::diffuseMaterial(glm::vec3(0.5f)));
  scene::addInstance(b.scene, scene::storeMesh(b.scene, mesh), scene::placementOf(glm::dmat4(1)).value(), 0);
  const std::vector<gpu::CastRay> rays = raysTo(triangles, random, kRays);
  std::vector<glm::vec4> inputs;
  for (const gpu::CastRay& ray : rays) inputs.insert(inputs.end(), {ray.originLimit, ray.direction});
  SceneLeaf leaf(spirv::surface_leaf, b.scene);
  const auto rows = leaf.run<glm::vec4>(inputs, inputs.size(), rays.size());
  std::vector<double> errors;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (rows[2 * i].w == 0) continue;
    const dvec3 position(rows[2 * i]), colour(rows[2 * i + 1]);
    const Meeting meeting = meetingOf(rays[i], mesh, static_cast<std::size_t>(rows[2 * i + 1].w));
    const double scale = std::max(largest(dvec3(rays[i].originLimit)), largest(meeting.point)) * meeting.reach;
    errors.push_back(std::max(largest(position - meeting.point), largest(colour - meeting.point)) / scale);
  }
  REQUIRE(errors.size() > rays.size() / 2);
  std::ranges::sort(errors);
  const double worst = errors.back() * 0x1p24, thousandth = errors[errors.size() - errors.size() / 1000] * 0x1p24;
  CAPTURE(errors.size(), errors[errors.size() / 2] * 0x1p24, thousandth, worst);
  CHECK(thousandth < 6);  // RoundingBounds::position
  CHECK(worst < 300);
}
