// Sets of boxes that builders find easy, hard, and hopeless. All are the same on every run.
#pragma once
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "host/trace/accel/bounds.h"

namespace candela::test {

using namespace accel;

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// Uniform in [low, high).
  double real(double low = 0, double high = 1) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  glm::dvec3 inCube(double low, double high) {
    const double x = real(low, high), y = real(low, high), z = real(low, high);
    return {x, y, z};
  }
  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 v = inCube(-1, 1);
      const double square = glm::dot(v, v);
      if (square > 0.01 && square <= 1) return v / std::sqrt(square);
    }
  }

 private:
  std::mt19937_64 engine_;
};

inline Aabb boxAround(const glm::dvec3& centre, const glm::dvec3& halfExtent) {
  return {glm::vec3(centre - halfExtent), glm::vec3(centre + halfExtent)};
}

inline std::vector<accel::Aabb> randomBoxes(std::size_t count, std::uint64_t seed = 1) {
  Random random(seed);
  std::vector<accel::Aabb> boxes(count);
  for (Aabb& b : boxes) {
    const glm::dvec3 halfExtent = random.inCube(0, 1);  // first, since compilers differ in the order of arguments
    b = boxAround(random.inCube(0, 100), halfExtent);
  }
  return boxes;
}

struct NamedInput {
  std::string name;
  std::vector<accel::Aabb> boxes;
};

inline std::vector<NamedInput> builderInputs() {
  Random random(7);
  std::vector<NamedInput> inputs;
  const auto add = [&](const std::string& name, std::size_t count, auto&& boxOf) {
    inputs.push_back({name, {}});
    for (std::size_t i = 0; i < count; ++i) inputs.back().boxes.push_back(boxOf(static_cast<double>(i)));
  };
  inputs.push_back({"random", randomBoxes(5000)});
  inputs.push_back({"one", randomBoxes(1)});
  inputs.push_back({"two", randomBoxes(2)});
  inputs.push_back({"large enough for tasks", randomBoxes(50000)});
  add("clustered", 5000, [&](double i) {
    const double cluster = std::floor(i / 500);
    return boxAround(glm::dvec3(cluster * 1000) + random.inCube(0, 0.01), glm::dvec3(1e-4));
  });
  add("coincident", 1000, [](double) { return boxAround(glm::dvec3(1, 2, 3), glm::dvec3(1)); });
  add("concentric", 1000, [](double i) { return boxAround(glm::dvec3(0), glm::dvec3(i + 1)); });
  add("one point", 1000, [](double) { return boxAround(glm::dvec3(5), glm::dvec3(0)); });
  add("points on a line", 3000, [&](double) { return boxAround(random.real() * glm::dvec3(1, 2, 3), glm::dvec3(0)); });
  add("points on an axis", 3000, [&](double) { return boxAround({random.real(), 0, 0}, glm::dvec3(0)); });
  add("flat", 3000, [&](double) { return boxAround({random.real(), 4, random.real()}, {0.01, 0, 0.01}); });
  add("huge and tiny", 2000, [&](double i) {
    if (i < 6) return boxAround(1e5 * random.direction(), glm::dvec3(1e5));
    const glm::dvec3 halfExtent(random.real(0, 0.1));
    return boxAround(random.inCube(0, 100), halfExtent);
  });
  add("geometric progression", 240, [](double i) {
    const double size = std::exp2(i / 2 - 20);
    return boxAround({size, 0, 0}, glm::dvec3(size / 8));
  });
  add("neighbouring denormals", 100, [](double i) { return boxAround(glm::dvec3(i * 1e-45), glm::dvec3(0)); });
  add("as far as allowed", 100, [&](double) { return boxAround(random.inCube(-0x1p99, 0x1p99), glm::dvec3(0x1p98)); });
  return inputs;
}

}  // namespace candela::test
