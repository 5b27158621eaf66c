// Scenes with many lights: how many there are, how strong, and that no wall or ceiling contains them.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/scene/generate/emitters.h"
#include "tests/scene/generate/generated_text.h"

namespace candela {
namespace {

using glm::dvec3;

struct EmitterCount {
  std::size_t spheres = 0, triangles = 0;
  bool operator==(const EmitterCount&) const = default;
};

EmitterCount countOf(const std::vector<Emitter>& emitters) {
  const auto spheres = static_cast<std::size_t>(std::ranges::count(emitters, true, &Emitter::isSphere));
  return {spheres, emitters.size() - spheres};
}

/// Checks the lights of a scene, its number of primitives, and that none of them coincide.
void checkLights(const std::string& kind, std::uint32_t size, const EmitterCount& expected) {
  CAPTURE(kind, size);
  const scene::Scene scene = generatedScene(kind, size).scene;
  CHECK(countOf(emittersOf(scene)) == expected);
  CHECK(scene.primitives.size() == kindNamed(kind).primitiveCount(size));
  CHECK(coincidentCount(scene) == 0);
  CHECK(scene.background == glm::vec3(0));
  CHECK((scene.pointLights.empty() && scene.punctualLights.empty() && !scene.environment));
}

std::pair<double, double> powerRange(const std::vector<Emitter>& emitters) {
  const auto [least, most] = std::ranges::minmax(emitters, {}, &Emitter::power);
  return {least.power(), most.power()};
}

}  // namespace

TEST_CASE("the corridor has as many lamps as its size, of which every fifth is a sphere and the others two triangles") {
  for (const std::uint32_t size : {1u, 4u, 5u, 20u, 21u, 120u, 121u, 999u, 1000u, 1001u, 31'234u}) {
    checkLights("corridor", size, {size / 5, 2 * (size - size / 5)});
  }
}

TEST_CASE("the street has as many emissive triangles as its size") {
  for (const std::uint32_t size : {2u, 3u, 5u, 17u, 255u, 256u, 257u, 258u, 10'000u, 10'239u, 10'240u, 10'243u}) {
    checkLights("street", size, {0, size});
  }
}

TEST_CASE("the office has as many panels of two triangles as its size") {
  for (const std::uint32_t size : {1u, 2u, 16u, 17u, 99u, 100u, 101u, 1023u})
    checkLights("office", size, {0, 2 * size});
}

TEST_CASE("the stage has as many lamps of two triangles as the size says") {
  for (const std::uint32_t size : {1u, 2u, 4u, 1000u, 10'001u}) checkLights("floodlights", size, {0, 2 * size});
}

TEST_CASE("the power of the corridor's lamps spreads over more than three orders of magnitude, evenly by octaves") {
  const std::vector<Emitter> emitters = emittersOf(generatedScene("corridor", 4000).scene);
  std::array<int, 12> octaves{};
  for (const Emitter& emitter : emitters) {
    const double power = emitter.power() * (emitter.isSphere ? 1 : 2);  // a lamp is two triangles
    const int octave = static_cast<int>(std::floor(std::log2(power))) + 6;
    REQUIRE((octave >= 0 && octave < 12));
    octaves[static_cast<std::size_t>(octave)] += emitter.isSphere ? 2 : 1;
  }
  for (const int count : octaves) CHECK(count == Approx(8000 / 12).epsilon(0.2));
}

TEST_CASE("the emitters of the street differ in power by more than a thousand") {
  const auto [least, most] = powerRange(emittersOf(generatedScene("street", 10'000).scene));
  CHECK(most > 1000 * least);
}

TEST_CASE("the panels of the office, and the floodlights, have equal power") {
  for (const char* kind : {"office", "floodlights"}) {
    const auto [least, most] = powerRange(emittersOf(generatedScene(kind, 1000).scene));
    CHECK(most < 1.0001 * least);
  }
}

TEST_CASE("every floodlight is of the same importance for all points of the stage, to 1 %") {
  for (const std::uint32_t size : {1000u, 1024u}) {
    const std::vector<Emitter> emitters = emittersOf(generatedScene("floodlights", size).scene);
    double total = 0;
    for (const dvec3& point : {dvec3(-2, 0, -2), {2, 0, -2}, {2, 0, 2}, {-2, 0, 2}, {-2, 1.8, -2}, {2, 1.8, -2}}) {
      double least = INFINITY, most = 0;
      for (const Emitter& emitter : emitters) {
        const dvec3 path = point - emitter.centre;
        const double importance = emitter.power() * dot(emitter.normal, normalize(path)) / dot(path, path);
        least = std::min(least, importance);
        most = std::max(most, importance);
        total += importance;
      }
      CHECK(least > 0);
      CHECK(most < 1.01 * least);
    }
    CHECK(total / 6 / (2 * std::numbers::pi) == Approx(3).epsilon(0.05));  // irradiance, whatever the size
  }
}

TEST_CASE("floor, ceiling and outer walls of corridor and office face inwards") {
  for (const char* kind : {"corridor", "office"}) {
    const scene::Scene scene = generatedScene(kind, 100).scene;
    const dvec3 inside(scene.camera->from);
    std::size_t count = 0;
    for (const scene::Primitive& primitive : scene.primitives) {
      if (primitive.kind != scene::PrimitiveKind::triangle || isEmissive(scene.materials[primitive.material])) continue;
      const scene::Triangle triangle = triangleOf(scene, primitive);
      const dvec3 a(triangle.p[0]), b(triangle.p[1]), c(triangle.p[2]);
      CHECK(dot(cross(b - a, c - a), inside - a) > 0);
      ++count;
    }
    CHECK(count >= 12);
  }
}

TEST_CASE("every lamp of corridor and office has free space before it") {
  for (const auto& [kind, size] : {std::pair("corridor", 1050u), {"office", 150u}}) {
    const scene::Scene scene = generatedScene(kind, size).scene;
    for (const Emitter& emitter : emittersOf(scene)) {
      CAPTURE(kind, emitter.primitive);
      for (const dvec3& point : pointsBefore(scene, emitter)) {
        if (emitter.isSphere) {
          REQUIRE_FALSE(isObstructed(scene, emitter.centre, point));
        } else {
          REQUIRE(emitter.normal.y < -0.999);
          REQUIRE_FALSE(isObstructed(scene, point, point - dvec3(0, 0.7, 0)));
        }
      }
    }
  }
}

TEST_CASE("every lamp of the corridor is between its outer walls, whatever their distance") {
  for (std::uint32_t pairs = 6; pairs <= 50; ++pairs) {
    for (const Emitter& emitter : emittersOf(generatedScene("corridor", 20 * pairs).scene)) {
      REQUIRE(std::abs(emitter.centre.x) < 6.02);
      REQUIRE((emitter.centre.y > 0 && emitter.centre.y < 2.7));
      REQUIRE((emitter.centre.z > 0 && emitter.centre.z < 4 * pairs));
    }
  }
}

TEST_CASE("most lamps of the corridor are hidden from the camera, and most panels of the office are not") {
  const auto hiddenFraction = [](const std::string& kind) {
    const scene::Scene scene = generatedScene(kind, 1000).scene;
    const std::vector<Emitter> emitters = emittersOf(scene);
    const auto hidden = std::ranges::count_if(emitters, [&](const Emitter& emitter) {
      return isObstructed(scene, emitter.centre, dvec3(scene.camera->from));
    });
    return static_cast<double>(hidden) / static_cast<double>(emitters.size());
  };
  CHECK(hiddenFraction("corridor") > 0.7);
  CHECK(hiddenFraction("office") < 0.5);
}

}  // namespace candela
