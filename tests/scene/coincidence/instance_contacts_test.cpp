// The search among instances finds what a comparison of all placed triangles finds.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "host/scene/coincidence/coincidence.h"
#include "host/scene/coincidence/flat_surface.h"
#include "host/scene/shape.h"
#include "tests/scene/coincidence/flat_parts.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using glm::dmat4;
using glm::dvec3;
using glm::vec3;
using scene::Coincidences;
using scene::findCoincidences;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

using Numbers = std::set<std::uint32_t>;

// The marks that findCoincidences() must set at least.
struct Marks {
  Numbers coincident, ordered;
};

// Compares all pairs of primitives in the space of the scene.
Marks marksByBruteForce(const scene::Scene& scene) {
  const scene::StoredPrimitives stored(scene.primitives);
  const std::vector<scene::FlatSurface> parts = test::flatPartsOf(scene, [](std::uint32_t) { return true; });
  const auto shapeAt = [&](std::uint32_t i) { return shapeOf(scene, scene.primitives[i]); };
  // 0: emits; 1: bounds a body that transmits light; 2: transmits light, thin-walled; 3: others
  const auto classOf = [&](std::uint32_t i) {
    const scene::Material& material = scene.materials[scene.primitives[i].material];
    if (material.emission != vec3(0)) return 0;
    if (material.dielectric) return 1;
    return material.surface && material.surface->transmissionWeight > 0 ? 2 : 3;
  };
  Marks marks;
  for (const scene::FlatSurface& a : parts) {
    for (const scene::FlatSurface& b : parts) {
      if (a.primitive == b.primitive) continue;
      if (!areCopies(shapeAt(a.primitive), shapeAt(b.primitive)) && !overlapInPlane(a, b)) continue;
      marks.coincident.insert(stored.indexOf(a.primitive));
      const int first = classOf(a.primitive), second = classOf(b.primitive);
      if (first != 0 && (first != second || first == 1)) marks.ordered.insert(stored.indexOf(a.primitive));
    }
  }
  return marks;
}

Numbers numbersOf(const std::vector<bool>& marks) {
  Numbers numbers;
  for (std::uint32_t i = 0; i < marks.size(); ++i) {
    if (marks[i]) numbers.insert(i);
  }
  return numbers;
}

Numbers missing(const Numbers& wanted, const std::vector<bool>& marks) {
  const Numbers found = numbersOf(marks);
  Numbers result;
  std::ranges::set_difference(wanted, found, std::inserter(result, result.end()));
  return result;
}

dmat4 shifted(const dvec3& by, const dmat4& map = dmat4(1)) {
  dmat4 result = map;
  result[3] = glm::dvec4(by, 1);
  return result;
}

void show(SceneBuilder& b, std::uint32_t mesh, const dmat4& map) {
  const auto material = static_cast<std::uint32_t>(b.scene.materials.size() - 1);
  addInstance(b.scene, mesh, scene::placementOf(map).value(), material);
}

// A cube of side 2 around the origin, each face of side * side quads.
scene::Mesh cube(int side) {
  scene::Mesh mesh;
  for (int face = 0; face < 6; ++face) {
    const auto at = [&](int x, int y) {
      const int axis = face / 2;
      vec3 p;
      p[axis] = face % 2 == 0 ? -1.0f : 1.0f;
      p[(axis + 1) % 3] = -1 + 2 * static_cast<float>(face % 2 == 0 ? y : x) / static_cast<float>(side);
      p[(axis + 2) % 3] = -1 + 2 * static_cast<float>(face % 2 == 0 ? x : y) / static_cast<float>(side);
      return p;
    };
    for (int x = 0; x < side; ++x) {
      for (int y = 0; y < side; ++y) {
        for (const vec3& p : {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y), at(x + 1, y + 1), at(x, y + 1)}) {
          mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
          mesh.positions.push_back(p);
        }
      }
    }
  }
  return mesh;
}

// Instances of two meshes, of which triangles coincide in some placements, among surfaces that belong to no instance.
class Crowd {
 public:
  explicit Crowd(std::uint32_t seed) : numbers_(seed), scale_(std::pow(10.0, random(2))) {
    b.material(diffuseMaterial(vec3(0.5f)));
    const std::uint32_t plain = storeMesh(b.scene, cube(3));
    const std::uint32_t mixed = storeMesh(b.scene, soup());
    for (int i = 0; i < 12; ++i) {
      scene::Material foil;
      foil.surface = scene::SurfaceParameters{.transmissionWeight = 1, .isThinWalled = true};
      b.material(i % 7 == 1   ? test::glassMaterial(vec3(1), 1.5f)
                 : i % 7 == 2 ? foil
                              : diffuseMaterial(vec3(0.5f), vec3(i % 4 == 0 ? 1.0f : 0.0f)));
      const dmat4 map = map_ = anyMap();
      show(b, i % 2 == 0 ? plain : mixed, map);
      if (seed % 5 == 1) show(b, i % 2 == 0 ? plain : mixed, map);                           // a copy
      if (seed % 5 == 2) show(b, plain, shifted(dvec3(map[3]) + 2.0 * dvec3(map[0]), map));  // a neighbour
      if (seed % 5 == 3) show(b, plain, shifted(dvec3(map[3]) * (1 + 0x1p-23), map));        // almost a copy
      if (seed % 5 == 4) show(b, plain, shifted(dvec3(map[3]) + 0.3 * dvec3(map[0]), map));  // displaced
      if (i % 5 == 0) addDecal(map);
    }
    const auto p = [&] { return vec3(scale_ * dvec3(random(9), random(9), random(9))); };
    for (int i = 0; i < 20; ++i) b.triangle(p(), p(), p());
    b.plane(onFace(map_, 0, 0), onFace(map_, 1, 0), onFace(map_, 0, 1));
  }

  SceneBuilder b;

 private:
  double random(double limit) { return std::uniform_real_distribution(-limit, limit)(numbers_); }

  // Triangles in few planes, some of them twice, slivers, and triangles without area.
  scene::Mesh soup() {
    scene::Mesh mesh;
    const auto add = [&](const vec3& p) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(p);
    };
    for (int i = 0; i < 40; ++i) {
      const dvec3 corner(random(1), random(1), 0.25 * (i % 4));
      const dvec3 u = std::pow(10, random(1.5) - 1) * dvec3(random(1), random(1), i % 3 == 0 ? random(1) : 0);
      const dvec3 v = std::pow(10, random(1.5) - 1) * dvec3(random(1), random(1), 0);
      for (const dvec3& p : {corner, corner + u, corner + (i % 10 == 9 ? 0.5 * u : v)}) add(vec3(p));
      if (i % 8 == 0) add(vec3(corner + v)), add(vec3(corner)), add(vec3(corner + u));
    }
    return mesh;
  }

  // Moves, and turns, mirrors, scales or shears.
  dmat4 anyMap() {
    glm::dmat4 map(1);
    const int kind = std::uniform_int_distribution(0, 3)(numbers_);
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) {
        if (kind == 0 || (kind == 1 && row == column)) map[column][row] = random(1);
        if (kind == 2) map[column][row] = row == (column + 1) % 3 ? 1 : 0;
      }
    }
    for (int column = 0; column < 3; ++column) map[column] *= scale_;
    const dvec3 shift(random(5), random(5), random(5));
    return scene::placementOf(map) ? shifted(scale_ * (kind == 3 ? 100.0 : 1.0) * shift, map) : anyMap();
  }

  // Returns a point of a face of the cube that this map places.
  static vec3 onFace(const dmat4& map, double x, double y) { return vec3(dvec3(map * glm::dvec4(x, y, 1, 1))); }

  void addDecal(const dmat4& map) {
    const auto corner = [&] { return onFace(map, random(1), random(1)); };
    b.triangle(corner(), corner(), corner());
  }

  std::mt19937 numbers_;
  double scale_;
  dmat4 map_{1};  // of the last instance
};

}  // namespace

TEST_CASE("what coincides in the space of the scene is marked in instances of any placement") {
  const auto seed = GENERATE(range(0u, 40u));
  const scene::Scene& scene = Crowd(seed).b.scene;
  const Marks wanted = marksByBruteForce(scene);
  const Coincidences found = findCoincidences(scene, 1);
  CAPTURE(seed, wanted.coincident.size(), numbersOf(found.coincident).size());
  CHECK(wanted.coincident.size() > 10);
  CHECK(missing(wanted.coincident, found.coincident).empty());
  CHECK(missing(wanted.ordered, found.ordered).empty());
  CHECK_FALSE(found.truncated);
  const Coincidences again = findCoincidences(scene, 3);
  CHECK(again.coincident == found.coincident);
  CHECK(again.ordered == found.ordered);
  CHECK(again.copies == found.copies);
  CHECK(again.overlaps == found.overlaps);
  CHECK(again.orderReach == found.orderReach);
}

TEST_CASE(
    "a mesh that coincides with nothing has no marks, wherever it is shown, and a decal on one instance marks it") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.5f)));
  const std::uint32_t mesh = storeMesh(b.scene, cube(8));
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.1 * i;
    const dmat4 turned(glm::dvec4(std::cos(angle), std::sin(angle), 0, 0),
                       glm::dvec4(-std::sin(angle), std::cos(angle), 0, 0), glm::dvec4(0, 0, 1, 0),
                       glm::dvec4(0, 0, 0, 1));
    show(b, mesh, shifted(dvec3(8 + 3.7 * i, 1.1, 0.3), turned));
  }
  CHECK(numbersOf(findCoincidences(b.scene).coincident).empty());
  b.triangle({8, 1.1f, 1.3f}, {8.3f, 1.1f, 1.3f}, {8, 1.3f, 1.3f});  // on the first instance
  const Coincidences found = findCoincidences(b.scene);
  CHECK(numbersOf(found.coincident).size() > 2);
  CHECK(numbersOf(found.coincident).size() < 20);
  CHECK(found.overlaps.size() == numbersOf(found.coincident).size() - 1);
}

TEST_CASE("layers of a mesh that are apart coincide where an instance of it is small and far from the origin") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.5f)));
  scene::Mesh layers;
  for (const float height : {0.0f, 0.25f}) {
    for (const vec3& p : {vec3(-9, -9, height), vec3(9, -9, height), vec3(0, 9, height)}) {
      layers.indices.push_back(static_cast<std::uint32_t>(layers.positions.size()));
      layers.positions.push_back(p);
    }
  }
  const std::uint32_t mesh = storeMesh(b.scene, layers);
  const dmat4 small(glm::dvec4(1e-4, 0, 0, 0), glm::dvec4(0, 1e-4, 0, 0), glm::dvec4(0, 0, 1e-4, 0),
                    glm::dvec4(0, 0, 0, 1));
  show(b, mesh, dmat4(1));
  show(b, mesh, shifted(dvec3(0, 0, 20), small));
  CHECK(numbersOf(findCoincidences(b.scene).coincident).empty());
  show(b, mesh, shifted(dvec3(100, 0, 0), small));
  show(b, mesh, shifted(dvec3(30, 0, 0)));
  CHECK(findCoincidences(b.scene).coincident == std::vector<bool>{true, true});
}

TEST_CASE("many instances at one place are copies of the first one") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.5f)));
  const std::uint32_t mesh = storeMesh(b.scene, cube(2));
  show(b, mesh, shifted(dvec3(9, 0, 0)));
  for (int i = 0; i < 500; ++i) show(b, mesh, dmat4(1));
  const Coincidences found = findCoincidences(b.scene);
  CHECK(found.copies.empty());
  CHECK(found.copiedRuns.size() == 499);
  CHECK(found.copiedRuns.front() == Coincidences::Pair(1, 2));
  CHECK(numbersOf(found.coincident).size() == 48);
}

TEST_CASE(
    "what coincides with an emitting instance is ordered, and an instance that emits by its own material is not") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.5f))).material(diffuseMaterial(vec3(0), vec3(1)));
  scene::Mesh square;
  square.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  square.indices = {0, 1, 2, 0, 2, 3};
  const std::uint32_t lamp = storeMesh(b.scene, square);
  addInstance(b.scene, lamp, scene::placementOf(shifted(dvec3(0, 0, 7))).value(), 1);
  addInstance(b.scene, lamp, scene::placementOf(shifted(dvec3(0, 0, -7))).value(), 1);
  addMesh(b.scene, {.positions = {{-9, -9, 7}, {9, -9, 7}, {0, 9, 7}}, .indices = {0, 1, 2}}, 0);
  const Coincidences found = findCoincidences(b.scene);
  CHECK(found.coincident == std::vector<bool>{true, true, true});
  CHECK(found.ordered == std::vector<bool>{false, false, true});
  CHECK(found.orderReach >= 9);
  CHECK(found.orderReach < 9.001f);
  addInstance(b.scene, lamp, scene::placementOf(shifted(dvec3(0, 0, 7))).value(),
              0);  // in the place of its copy that emits
  CHECK(findCoincidences(b.scene).ordered == std::vector<bool>{true, true, true});
}

TEST_CASE("instances that would take too many comparisons are marked whole, on any number of threads") {
  // Two fans of triangles through one axis, slightly turned, so that all boxes of one overlap all of the other.
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.5f)));
  scene::Mesh fan;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const float angle = 0.003f * static_cast<float>(i);
    for (const vec3& p : {vec3(-1, 0, 0), vec3(1, 0, 0), vec3(0.1f, std::cos(angle), std::sin(angle))}) {
      fan.indices.push_back(static_cast<std::uint32_t>(fan.positions.size()));
      fan.positions.push_back(p);
    }
  }
  const std::uint32_t mesh = storeMesh(b.scene, fan);
  show(b, mesh, dmat4(1));
  show(b, mesh, shifted(dvec3(0.01, 0.02, 0.03)));
  b.triangle({50, 0, 0}, {51, 0, 0}, {50, 1, 0});
  const Coincidences found = findCoincidences(b.scene, 1);
  CHECK(numbersOf(found.coincident).size() == 2000);
  CHECK_FALSE(found.coincident[2000]);
  CHECK_FALSE(found.truncated);
  CHECK(findCoincidences(b.scene, 4).coincident == found.coincident);
}
