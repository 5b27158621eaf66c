// Builds the scenes for searches.
#include "tests/trace/accel/test_scenes.h"

#include <algorithm>
#include <filesystem>

#include "host/formats/load_scene.h"
#include "host/formats/loading/scene_builder.h"
#include "tests/trace/accel/inputs.h"

namespace candela::test {

using namespace accel;
namespace {

class Maker {
 public:
  explicit Maker(std::uint64_t seed) : random(seed) {}

  void sphere(const glm::dvec3& centre, double radius) {
    add(scene::PrimitiveKind::sphere, scene.spheres, scene::Sphere{glm::vec3(centre), static_cast<float>(radius)});
  }
  void triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    addTriangle(scene, {{glm::vec3(a), glm::vec3(b), glm::vec3(c)}}, 0);
  }
  void box(const glm::dvec3& min, const glm::dvec3& max) {
    add(scene::PrimitiveKind::box, scene.boxes, scene::Box{glm::vec3(min), glm::vec3(max)});
  }
  void cone(const glm::dvec3& base, double baseRadius, const glm::dvec3& apex, double apexRadius) {
    add(scene::PrimitiveKind::cone, scene.cones,
        scene::Cone{glm::vec3(base), static_cast<float>(baseRadius), glm::vec3(apex), static_cast<float>(apexRadius)});
  }

  scene::Scene scene;
  Random random;

 private:
  template <class Shape>
  void add(scene::PrimitiveKind kind, std::vector<Shape>& shapes, const Shape& shape) {
    scene.primitives.push_back({kind, static_cast<std::uint32_t>(shapes.size()), 0});
    shapes.push_back(shape);
  }
};

// Spheres around one another and through one another: each fills many cells, each cell holds many.
scene::Scene shells() {
  Maker m(31);
  for (int i = 1; i <= 150; ++i) {
    m.sphere(glm::dvec3(0), 0.1 * i);
    m.sphere(m.random.inCube(-5, 5), m.random.real(1, 8));
  }
  return m.scene;
}

// Everything in the plane z = 0, and one in x = 3: boxes there are only as thick as their padding.
scene::Scene flat(int axis, double place) {
  Maker m(32);
  const auto inPlane = [&] {
    glm::dvec3 point = m.random.inCube(0, 10);
    point[axis] = place;
    return point;
  };
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 p = inPlane(), q = inPlane();
    m.triangle(p, glm::mix(p, q, 0.1), glm::mix(p, inPlane(), 0.1));
    m.box(glm::min(p, glm::mix(p, q, 0.05)), glm::max(p, glm::mix(p, q, 0.05)));
  }
  return m.scene;
}

// Boxes without thickness on one to three axes.
scene::Scene thinBoxes() {
  Maker m(33);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 corner = m.random.inCube(0, 10);
    glm::dvec3 size = m.random.inCube(0, 2);
    for (int axis = 0; axis <= i % 3; ++axis) size[(axis + i) % 3] = 0;
    m.box(corner, corner + size);
  }
  return m.scene;
}

scene::Scene nearAndFar() {
  Maker m(34);
  for (int i = 0; i < 100; ++i) m.sphere(m.random.inCube(-1, 1), 0.05);
  for (int i = 0; i < 10; ++i) m.sphere(m.random.inCube(-1e4, 1e4), m.random.real(0, 1e3));
  m.sphere({1e5 + 1, 0, 0}, 1e5);
  m.sphere({0, -1e5 - 1, 0}, 1e5);
  m.cone({0, 0, -2e4}, 10, {0, 0, 2e4}, 1);
  return m.scene;
}

// Faces of boxes in the planes between the cells of a grid.
scene::Scene bricks() {
  Maker m(35);
  for (int z = 0; z < 8; ++z) {
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        const glm::dvec3 corner(x, y, z);
        if ((x + y + z) % 2 == 0) m.box(corner, corner + 1.0);
        if (x == y) m.triangle(corner, corner + glm::dvec3(1, 0, 0), corner + glm::dvec3(0, 1, 0));
      }
    }
  }
  return m.scene;
}

// Triangles, spheres and cones of all sizes, and half of everything twice: those pairs tie.
scene::Scene mixed() {
  Maker m(36);
  for (int i = 0; i < 150; ++i) {
    const glm::dvec3 p = m.random.inCube(0, 100), q = p + m.random.inCube(-20, 20), r = p + m.random.inCube(-20, 20);
    const glm::dvec3 centre = m.random.inCube(0, 100);
    const double radius = std::exp2(m.random.real(-4, 4));
    for (int twice = 0; twice <= i % 2; ++twice) {
      m.triangle(p, q, r);
      m.sphere(centre, radius);
      m.cone(r, 0.1 * radius, centre, i % 3 == 0 ? 0 : radius);
      m.box(glm::min(p, centre), glm::min(p, centre) + radius);
    }
  }
  return m.scene;
}

scene::Scene needle() {
  Maker m(37);
  for (int i = 0; i < 100; ++i) m.sphere({1e3 * i, 0.001 * (i % 7), 0}, 0.5);
  return m.scene;
}

scene::Scene single(scene::PrimitiveKind kind) {
  Maker m(38);
  if (kind == scene::PrimitiveKind::sphere) m.sphere({1, 2, 3}, 0.5);
  if (kind == scene::PrimitiveKind::triangle) m.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  if (kind == scene::PrimitiveKind::box) m.box({0, 0, 0}, {0, 0, 0});
  if (kind == scene::PrimitiveKind::cone) m.cone({0, 0, 0}, 1, {0, 0, 50}, 0);
  return m.scene;
}

}  // namespace

std::vector<NamedScene> sceneFiles() {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"scenes", "tests/formats/nff/spd"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(CANDELA_SOURCE_DIR) / folder)) {
      const auto extension = entry.path().extension();
      if (extension == ".p3f" || extension == ".nff") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<NamedScene> scenes;
  for (const auto& file : files) scenes.push_back({file.filename(), formats::loadScene(file).scene});
  return scenes;
}

std::vector<NamedScene> edgeScenes() {
  return {{"nothing", {}},
          {"one sphere", single(scene::PrimitiveKind::sphere)},
          {"one triangle", single(scene::PrimitiveKind::triangle)},
          {"one point", single(scene::PrimitiveKind::box)},
          {"one cone", single(scene::PrimitiveKind::cone)},
          {"shells", shells()},
          {"flat at z = 0", flat(2, 0)},
          {"flat at x = 3", flat(0, 3)},
          {"flat and far away", flat(1, 1e5)},
          {"thin boxes", thinBoxes()},
          {"near and far", nearAndFar()},
          {"bricks", bricks()},
          {"mixed", mixed()},
          {"needle", needle()}};
}

scene::Scene largeScene(std::size_t count) {
  Maker m(39);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 p = m.random.inCube(0, 100);
    if (i % 2 == 0) {
      m.triangle(p, p + m.random.inCube(-1, 1), p + m.random.inCube(-1, 1));
    } else {
      m.sphere(p, m.random.real(0, 0.5));
    }
  }
  return m.scene;
}

}  // namespace candela::test
