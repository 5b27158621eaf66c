// Surfaces that exist twice or share a plane: both tracers show what one copy shows, which is known exactly.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>

#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;
using test::diffuseMaterial;
using test::glassMaterial;
using test::SceneBuilder;

namespace {

// A point at `offset` times the size from the centre of a body.
struct Placed {
  vec3 centre;
  float size;

  vec3 at(float x, float y, float z) const { return centre + size * vec3(x, y, z); }
};

using AddBody = std::function<void(SceneBuilder&, const Placed&)>;

struct DoubledBody {
  std::string name;
  AddBody first;
  AddBody second;
};

void addSlope(SceneBuilder& b, const Placed& p) {
  b.quad(p.at(-1, -1, -0.25f), p.at(1, -1, -0.125f), p.at(1, 1, 0.25f), p.at(-1, 1, 0.125f));
}

// A floor whose diagonal is the other one, half as large and off the centre.
void addRug(SceneBuilder& b, const Placed& p) {
  b.triangle(p.at(0.75f, -0.5f, 0), p.at(0.75f, 0.5f, 0), p.at(-0.25f, -0.5f, 0));
  b.triangle(p.at(-0.25f, 0.5f, 0), p.at(-0.25f, -0.5f, 0), p.at(0.75f, 0.5f, 0));
}

void addFloor(SceneBuilder& b, const Placed& p) {
  b.quad(p.at(-1, -1, 0), p.at(1, -1, 0), p.at(1, 1, 0), p.at(-1, 1, 0));
}

// A point of an inclined floor that is 1000 times as large as the rugs on it. The vertices of both are rounded
// differently.
vec3 onIncline(const Placed& p, double x, double y) {
  const glm::dvec3 offset(x, y, 0.123456789 * x - 0.0456789123 * y);
  return vec3(glm::dvec3(p.centre) + double{p.size} * offset);
}

void addInclinedFloor(SceneBuilder& b, const Placed& p) {
  b.quad(onIncline(p, -1000, -900), onIncline(p, 1000, -1100), onIncline(p, 1100, 1000), onIncline(p, -1000, 1000));
}

void addInclinedRug(SceneBuilder& b, const Placed& p) {
  b.triangle(onIncline(p, -2, -1.3), onIncline(p, 1.7, -1.1), onIncline(p, 0.3, 2.1));
}

void addPlane(SceneBuilder& b, const Placed& p) { b.plane(p.at(0, 0, 0), p.at(1, 0, 0), p.at(0, 1, 0)); }
void addBox(SceneBuilder& b, const Placed& p) { b.box(p.at(-1, -1, -1), p.at(1, 1, 0)); }
void addThinBox(SceneBuilder& b, const Placed& p) { b.box(p.at(-1, -1, 0), p.at(1, 1, 1e-7f)); }
void addSphere(SceneBuilder& b, const Placed& p) { b.sphere(p.centre, p.size); }

// All bodies are convex as seen from above, where the camera is.
std::vector<DoubledBody> doubledBodies() {
  return {{"triangles", addSlope, addSlope},
          {"triangles in another order", addSlope,
           [](SceneBuilder& b, const Placed& p) {
             const vec3 low = p.at(-1, -1, -0.25f), high = p.at(1, 1, 0.25f);
             b.triangle(high, p.at(1, -1, -0.125f), low).triangle(low, p.at(-1, 1, 0.125f), high);
           }},
          {"a rug on its floor", addFloor, addRug},
          {"a rug in the plane below it", addPlane, addRug},
          {"a rug on a floor of 1000 times its size", addInclinedFloor, addInclinedRug},
          {"planes", addPlane, addPlane},
          {"boxes", addBox, addBox},
          {"a rug in the face of a box", addBox, addRug},
          {"a floor and a box as thin as rounding errors", addFloor, addThinBox},
          {"spheres", addSphere, addSphere},
          {"cylinders with their ends exchanged",
           [](SceneBuilder& b, const Placed& p) { b.cone(p.at(-1, 0, 0), p.size, p.at(1, 0, 0), p.size); },
           [](SceneBuilder& b, const Placed& p) { b.cone(p.at(1, 0, 0), p.size, p.at(-1, 0, 0), p.size); }}};
}

render::RenderSettings settingsOf(std::uint32_t side, std::uint32_t samples) {
  render::RenderSettings settings = squareSettings(side, samples);
  settings.image.rouletteStart = 100;
  return settings;
}

SceneBuilder below(const Placed& p, float angle) {
  SceneBuilder b;
  b.scene.background = vec3(1);
  b.view(p.at(0.25f, 0.125f, 4), p.at(0.25f, 0.125f, 0), {0, 1, 0}, angle);
  b.material(diffuseMaterial(vec3(0.5f)));
  return b;
}

}  // namespace

TEST_CASE("a white sky lights a convex body that exists twice as one copy, near and far, small and large") {
  onBothTracers([](const RenderFunction& renderScene) {
    for (const DoubledBody& body : doubledBodies()) {
      for (const float coordinate : {1e-3f, 1.0f, 1e3f, 1e6f}) {
        for (const float size : {1.0f, 100.0f, 1e4f}) {
          if (coordinate > 1e5f * size) continue;  // single precision has less than 100 steps in the body
          const Placed placed{vec3(coordinate, -coordinate, coordinate), size};
          SceneBuilder b = below(placed, 8);
          body.first(b, placed);
          body.second(b, placed);
          CAPTURE(body.name, coordinate, size);
          CHECK(meanLuminance(renderScene(b.scene, settingsOf(8, 4)).film) == Approx(0.5).epsilon(1e-3));
        }
      }
    }
  });
}

TEST_CASE("every structure, kernel and load type shows surfaces that exist twice in the same way",
          "[swiftshader-slow]") {
  const Placed placed{{0.3f, -0.7f, 0.1f}, 1};
  SceneBuilder b = below(placed, 40);
  for (const DoubledBody& body : doubledBodies()) body.first(b, placed), body.second(b, placed);
  for (int i = 0; i < 20; ++i) b.sphere(placed.at(0.1f * static_cast<float>(i), 1, 1), 0.05f);
  render::RenderSettings settings = settingsOf(24, 4);
  const std::uint64_t expected = renderOnDevice(b.scene, settings).film.hash();
  for (const render::KernelKind kernel : {render::KernelKind::megakernel, render::KernelKind::wavefront}) {
    for (const render::AccelKind accel : {render::AccelKind::none, render::AccelKind::grid, render::AccelKind::bvh}) {
      for (const render::BvhLayout layout : {render::BvhLayout::bvh2, render::BvhLayout::cwbvh}) {
        if (accel != render::AccelKind::bvh && layout == render::BvhLayout::cwbvh) continue;
        settings.execution.kernel = kernel;
        settings.structure.accel = accel;
        settings.structure.bvhLayout = layout;
        CAPTURE(static_cast<int>(kernel), static_cast<int>(accel), static_cast<int>(layout));
        CHECK(renderOnDevice(b.scene, settings).film.hash() == expected);
      }
    }
  }
}

TEST_CASE("equal triangles in any order of vertices show the lower index everywhere") {
  const vec3 p[3] = {{-1.1f, -0.9f, 0.3f}, {1.3f, -0.7f, -0.2f}, {0.1f, 1.2f, 0.4f}};
  constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  onBothTracers([&](const RenderFunction& renderScene) {
    for (const auto& first : kOrders) {
      for (const auto& second : kOrders) {
        SceneBuilder b = below({{0, 0, 0}, 1}, 20);
        b.triangle(p[first[0]], p[first[1]], p[first[2]]);
        b.material(diffuseMaterial(vec3(0.25f))).triangle(p[second[0]], p[second[1]], p[second[2]]);
        render::RenderSettings settings = settingsOf(32, 1);
        settings.image.integrator = render::Integrator::albedo;
        const image::Film film = renderScene(b.scene, settings).film;
        int lower = 0, higher = 0;
        for (std::uint32_t y = 0; y < 32; ++y) {
          for (std::uint32_t x = 0; x < 32; ++x) {
            lower += film.mean(x, y).x == 0.5;
            higher += film.mean(x, y).x == 0.25;
          }
        }
        CHECK(lower > 300);
        CHECK(higher == 0);
      }
    }
  });
}

TEST_CASE("vertex normals in the plane of their triangle are those of the triangle, whatever rounding does") {
  // Rounding of the turned vertices and normals leaves sines of either sign and a size of 1e-8.
  onBothTracers([&](const RenderFunction& renderScene) {
    for (int i = 0; i < 16; ++i) {
      const double angle = 0.2 + 0.1 * i;
      const auto turned = [&](double x, double y, double z) {
        return vec3(
            glm::dvec3(std::cos(angle) * x + std::sin(angle) * z, y, std::cos(angle) * z - std::sin(angle) * x));
      };
      SceneBuilder b;
      b.scene.background = vec3(1);
      const vec3 up = turned(0, 0, 1);
      b.view(4.0f * up, {0, 0, 0}, {0, 1, 0}, 8);
      b.material(diffuseMaterial(vec3(0.5f)));
      const vec3 inPlane = turned(1, 0, 0);
      b.patch(turned(-1, -1, 0), turned(1, -1, 0), turned(0, 1, 0), {{inPlane, inPlane, inPlane}});
      CAPTURE(angle);
      CHECK(meanLuminance(renderScene(b.scene, settingsOf(8, 4)).film) == Approx(0.5).epsilon(1e-4));
    }
  });
}

namespace {

void addGlassMesh(SceneBuilder& b, const vec3& low, const vec3& high) {
  const auto corner = [&](int x, int y, int z) {
    return vec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
  };
  b.quad(corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0));
  b.quad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  b.quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
  b.quad(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
  b.quad(corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1));
  b.quad(corner(0, 1, 0), corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1));
}

struct Table {
  bool glassFirst;
  bool isMesh;
  bool isPlane;  // else two triangles
  float scale;
};

// A block of glass that stands on a table in a white sky.
SceneBuilder glassOnTable(const Table& table, const scene::Material& glass, float albedo) {
  const Placed p{{0, 0, 0}, table.scale};
  SceneBuilder b;
  b.scene.background = vec3(1);
  b.view(p.at(0.3f, -2, 3), p.at(0, 0, 0.5f), {0, 0, 1}, 4);
  const auto addGlass = [&] {
    b.material(glass);
    if (table.isMesh)
      addGlassMesh(b, p.at(-1, -1, 0), p.at(1, 1, 1));
    else
      b.box(p.at(-1, -1, 0), p.at(1, 1, 1));
  };
  if (table.glassFirst) addGlass();
  b.material(diffuseMaterial(vec3(albedo)));
  if (table.isPlane)
    b.plane(p.at(0, 0, 0), p.at(1, 0, 0), p.at(0, 1, 0));
  else
    b.quad(p.at(-10, -10, 0), p.at(10, -10, 0), p.at(10, 10, 0), p.at(-10, 10, 0));
  if (!table.glassFirst) addGlass();
  return b;
}

std::vector<Table> tables() {
  std::vector<Table> all;
  for (const bool glassFirst : {false, true}) {
    for (const bool isMesh : {false, true}) {
      for (const bool isPlane : {false, true}) {
        for (const float scale : {1e-3f, 1.0f, 1e3f}) all.push_back({glassFirst, isMesh, isPlane, scale});
      }
    }
  }
  return all;
}

scene::Material clearGlass(float ior, bool isThinWalled = false) {
  scene::Material material;
  material.surface = scene::SurfaceParameters{
      .roughness = 0, .ior = ior, .transmissionWeight = 1, .isThinWalled = isThinWalled, .absorption = vec3(0.5f)};
  return material;
}

}  // namespace

TEST_CASE("glass that stands on a table shows the table, whichever is first in the file") {
  onBothTracers([](const RenderFunction& renderScene) {
    for (const Table& table : tables()) {
      CAPTURE(table.glassFirst, table.isMesh, table.isPlane, table.scale);
      // Glass of ior 1 is invisible but for Schlick's approximation, which reflects (1 - cos)^5 = 7e-4 here: a black
      // table is black, and one of albedo 1/2 shows half of the sky.
      const auto mean = [&](float albedo) {
        return meanLuminance(
            renderScene(glassOnTable(table, glassMaterial(vec3(1), 1), albedo).scene, settingsOf(8, 16)).film);
      };
      CHECK(mean(0) < 2e-3);
      CHECK(mean(0.5f) == Approx(0.5).epsilon(0.025));
    }
  });
}

TEST_CASE("glass of ior 1.5 on a table loses no light and has no volume faults, whichever is first in the file") {
  onBothTracers([](const RenderFunction& renderScene) {
    for (const Table& table : tables()) {
      CAPTURE(table.glassFirst, table.isMesh, table.isPlane, table.scale);
      scene::Material glass = clearGlass(1.5f);
      render::RenderSettings settings = settingsOf(8, 64);
      settings.image.maxDepth = 64;
      CHECK(renderScene(glassOnTable(table, glass, 0.5f).scene, settings).statistics.volumeFaults == 0);
      // A white table in a white sky is white, through glass without absorption, too.
      glass.surface->absorption = vec3(0);
      settings.image.maxDepth = 400;
      CHECK(meanLuminance(renderScene(glassOnTable(table, glass, 1).scene, settings).film) == Approx(1).epsilon(0.01));
    }
  });
}

TEST_CASE("planes that exist twice hide the sky from others, at any angle and at any distance") {
  onBothTracers([](const RenderFunction& renderScene) {
    const auto mean = [&](const vec3& from, const vec3& p0, const vec3& p1, const vec3& p2) {
      SceneBuilder b;
      b.scene.background = vec3(1);
      b.view(from, {from.x, from.y, 0}, {0, 1, 0}, 20);
      b.material(diffuseMaterial(vec3(0.5f)))
          .plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0})
          .plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
      b.material(diffuseMaterial(vec3(0))).plane(p0, p1, p2).plane(p0, p1, p2);
      return meanLuminance(renderScene(b.scene, settingsOf(16, 64)).film);
    };
    CHECK(mean({2, 0, 1}, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}) == Approx(0.25).epsilon(0.02));
    CHECK(mean({0, 0, 0.5f}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}) == 0);
  });
}

TEST_CASE("an acceleration structure finds a table at once, although rounding puts it before the ray") {
  // Many small quads, so that nodes of the structure contain nothing else.
  const auto addTiles = [](SceneBuilder& b, const Placed& p, float z) {
    const auto at = [&](int i, int j) {
      return p.at(0.125f * static_cast<float>(i), 0.125f * static_cast<float>(j), z);
    };
    for (int i = -8; i < 8; ++i) {
      for (int j = -8; j < 8; ++j) b.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  };
  onBothTracers([&](const RenderFunction& renderScene) {
    render::RenderSettings settings = settingsOf(8, 16);
    for (const render::AccelKind accel : {render::AccelKind::bvh, render::AccelKind::grid}) {
      settings.structure.accel = accel;
      CAPTURE(static_cast<int>(accel));
      // Products of distances below 2 and directions are rounded coarsely above the table.
      SceneBuilder block;
      const Placed here{{0.3f, -0.7f, 0.1f}, 1};
      block.scene.background = vec3(1);
      block.view(here.at(0.3f, -2.6f, 11), here.at(0, 0, 1), {0, 0, 1}, 4);
      block.material(glassMaterial(vec3(1), 1)).box(here.at(-1, -1, 0), here.at(1, 1, 1.95f));
      block.material(diffuseMaterial(vec3(0)));
      addTiles(block, {here.centre, 10}, 0);
      CHECK(meanLuminance(renderScene(block.scene, settings).film) < 2e-3);

      // Below a pane, a ray hits the lower index of two surfaces, another pane, and then the table above that.
      SceneBuilder panes;
      panes.scene.background = vec3(1);
      panes.view({0.3f, 0.2f, 3}, {0.3f, 0.2f, 0}, {0, 1, 0}, 10);
      panes.material(glassMaterial(vec3(1), 1)).triangle({-1000, -1000, 0}, {1000, -1000, 0}, {0, 1000, 0});
      panes.material(glassMaterial(vec3(0.9f), 1));
      panes.triangle({-1000, -1000, -2e-4f}, {1000, -1000, -2e-4f}, {0, 1000, -2e-4f});
      panes.material(diffuseMaterial(vec3(0)));
      addTiles(panes, {vec3(0), 1}, -1e-4f);
      CHECK(meanLuminance(renderScene(panes.scene, settings).film) < 2e-3);

      // From far away, rays hit a pane of 2 km or the black rug that is above it by less than the tolerance.
      for (int i = 0; i < 8; ++i) {
        SceneBuilder b;
        b.scene.background = vec3(1);
        b.view({1000, 4500.0f - 50.0f * static_cast<float>(i), 16300}, {0, 0, 0}, {0, 1, 0}, 1e-4f);
        b.material(glassMaterial(vec3(1), 1)).triangle({-1000, -1000, 0}, {1000, -1000, 0}, {0, 1000, 0});
        b.material(diffuseMaterial(vec3(0)));
        addTiles(b, {vec3(0), 1}, 3e-5f);
        CAPTURE(i);
        CHECK(meanLuminance(renderScene(b.scene, settings).film) < 2e-3);
      }
    }
  });
}

TEST_CASE("a table in the plane of a pane is behind what is nearer, where it is not below the pane") {
  onBothTracers([&](const RenderFunction& renderScene) {
    render::RenderSettings settings = settingsOf(4, 64);
    for (const render::AccelKind accel : {render::AccelKind::none, render::AccelKind::bvh, render::AccelKind::grid}) {
      settings.structure.accel = accel;
      CAPTURE(static_cast<int>(accel));
      // Rays cross a pane of 2 km at x = 0. The table is 0.4 mm below, which is its plane up to rounding, and begins at
      // x = 1.1 mm; they would meet it at x = 1.6 mm. A lamp stands at x = 0.5 mm, above the pane and below it.
      SceneBuilder b;
      b.view({-4, 0, 1}, {0, 0, 0}, {0, 0, 1}, 1e-4f);
      b.material(glassMaterial(vec3(1), 1)).triangle({-1000, -1000, 0}, {1000, -1000, 0}, {0, 1000, 0});
      b.material(diffuseMaterial(vec3(0)));
      b.quad({1.1e-3f, -100, -4e-4f}, {900, -100, -4e-4f}, {900, 100, -4e-4f}, {1.1e-3f, 100, -4e-4f});
      b.material(diffuseMaterial(vec3(0), vec3(0.5f)));
      b.quad({5e-4f, -50, -1}, {5e-4f, 50, -1}, {5e-4f, 50, 1}, {5e-4f, -50, 1});
      CHECK(meanLuminance(renderScene(b.scene, settings).film) == Approx(0.5));
    }
  });
}

TEST_CASE("glass of one material that exists twice counts once") {
  const std::vector<std::pair<std::string, std::function<void(SceneBuilder&, int)>>> bodies{
      {"sphere",
       [](SceneBuilder& b, int) {
         b.sphere({0, 0, 0}, 1);
       }},
      {"cylinder",
       [](SceneBuilder& b, int) {
         b.cone({0, -2, 0}, 1, {0, 2, 0}, 1);
       }},
      {"box",
       [](SceneBuilder& b, int) {
         b.box({-1, -0.8f, -1}, {1, 0.9f, 1});
       }},
      {"mesh", [](SceneBuilder& b, int) {
         addGlassMesh(b, {-1, -0.8f, -1}, {1, 0.9f, 1});
       }}};
  onBothTracers([&](const RenderFunction& renderScene) {
    for (const auto& [name, add] : bodies) {
      const auto render = [&, add = add](int copies) {
        SceneBuilder b;
        b.scene.background = vec3(1);
        b.view({1, -5, 2}, {0, 0, 0}, {0, 0, 1}, 20);
        b.material(clearGlass(1.5f));
        for (int i = 0; i < copies; ++i) add(b, i);
        return renderScene(b.scene, settingsOf(16, 16));
      };
      CAPTURE(name);
      const render::RenderResult once = render(1);
      const render::RenderResult twice = render(2);
      CHECK(meanLuminance(twice.film) == Approx(meanLuminance(once.film)).epsilon(1e-3));
      CHECK(twice.statistics.volumeFaults == once.statistics.volumeFaults);
    }
  });
}

TEST_CASE("a thin pane that exists twice, in either winding order, absorbs once") {
  onBothTracers([](const RenderFunction& renderScene) {
    const auto mean = [&](int copies) {
      SceneBuilder b;
      b.scene.background = vec3(1);
      b.view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 10);
      scene::Material pane = clearGlass(1.5f, true);
      pane.surface->baseColour = vec3(0.5f);
      b.material(pane).quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0});
      if (copies > 1) b.quad({-2, -2, 0}, {-2, 2, 0}, {2, 2, 0}, {2, -2, 0});
      return meanLuminance(renderScene(b.scene, settingsOf(16, 64)).film);
    };
    CHECK(mean(2) == Approx(mean(1)).epsilon(1e-4));
  });
}

TEST_CASE("a blended surface that exists twice is blended twice") {
  onBothTracers([](const RenderFunction& renderScene) {
    SceneBuilder b;
    b.scene.background = vec3(1);
    b.view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 10);
    scene::Material veil = diffuseMaterial(vec3(0));
    veil.opacity = scene::Opacity{.factor = 0.5f};
    b.material(veil);
    for (int i = 0; i < 2; ++i) b.quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0});
    CHECK(meanLuminance(renderScene(b.scene, settingsOf(16, 256)).film) == Approx(0.25).epsilon(0.02));
  });
}

TEST_CASE(
    "a lamp in the plane of a surface that does not emit is in front of it, with and without next-event estimation") {
  const auto tilted = [](const vec3& middle, float size, bool downward) {
    const vec3 right(size, 0, 0.3f * size), up(0.1f * size, size, -0.2f * size);
    std::array<vec3, 4> corners{middle - right - up, middle - right + up, middle + right + up, middle + right - up};
    if (!downward) std::swap(corners[1], corners[3]);
    return corners;
  };
  struct Case {
    std::string name;
    std::function<void(SceneBuilder&, const vec3&)> ceiling;
    std::function<void(SceneBuilder&, const vec3&)> lamp;
    float distance;  // from the origin
  };
  const auto addLamp = [&](SceneBuilder& b, const vec3& o) {
    const auto c = tilted(o + vec3(0, 0, 2), 0.5f, true);
    b.quad(c[0], c[1], c[2], c[3]);
  };
  const auto addFlatLamp = [](SceneBuilder& b, const vec3& o) {
    b.quad(o + vec3(-0.5f, -0.4f, 2), o + vec3(-0.6f, 0.5f, 2), o + vec3(0.5f, 0.6f, 2), o + vec3(0.4f, -0.5f, 2));
  };
  const std::vector<Case> cases{
      {"quad",
       [&](SceneBuilder& b, const vec3& o) {
         const auto c = tilted(o + vec3(0, 0, 2), 3, false);
         b.quad(c[0], c[1], c[2], c[3]);
       },
       addLamp, 0},
      {"plane",
       [&](SceneBuilder& b, const vec3& o) {
         const auto c = tilted(o + vec3(0, 0, 2), 3, false);
         b.plane(c[0], c[1], c[2]);
       },
       addLamp, 1000},
      {"box", [](SceneBuilder& b, const vec3& o) { b.box(o + vec3(-3, -3, 2), o + vec3(3, 3, 3)); }, addFlatLamp, 0},
      {"sphere", [](SceneBuilder& b, const vec3& o) { b.sphere(o + vec3(0, 0, 2), 0.5f); },
       [](SceneBuilder& b, const vec3& o) { b.sphere(o + vec3(0, 0, 2), 0.5f); }, 0}};
  onBothTracers([&](const RenderFunction& renderScene) {
    for (const Case& c : cases) {
      const vec3 o(c.distance, -c.distance, 0.5f * c.distance);
      enum Order { lampOnly, lampFirst, ceilingFirst };
      const auto mean = [&](Order order, bool nextEventEstimation, const vec3& at) {
        SceneBuilder b;
        b.view(o + vec3(0, -0.5f, 1), o + at, {0, 1, 0}, 60);
        b.material(diffuseMaterial(vec3(0.5f)));
        b.quad(o + vec3(-5, -5, 0), o + vec3(5, -5, 0), o + vec3(5, 5, 0), o + vec3(-5, 5, 0));
        if (order == ceilingFirst) c.ceiling(b, o);
        b.material(diffuseMaterial(vec3(0), vec3(3)));
        c.lamp(b, o);
        b.material(diffuseMaterial(vec3(0.5f)));
        if (order == lampFirst) c.ceiling(b, o);
        render::RenderSettings settings = settingsOf(16, 512);
        settings.image.maxDepth = 2;
        settings.image.nextEventEstimation = nextEventEstimation;
        return meanLuminance(renderScene(b.scene, settings).film);
      };
      CAPTURE(c.name);
      const vec3 up(0.1f, 0, 2), down(0.1f, 0, 0);
      const double seen = mean(lampOnly, true, up);
      const double lit = mean(lampOnly, true, down);
      CHECK(mean(lampFirst, true, up) == Approx(seen).epsilon(0.01));
      CHECK(mean(ceilingFirst, true, up) == Approx(seen).epsilon(0.01));
      CHECK(mean(ceilingFirst, true, down) == Approx(lit).epsilon(0.01));
      CHECK(mean(ceilingFirst, false, down) == Approx(lit).epsilon(0.03));
    }
  });
}

TEST_CASE("an emitter that exists twice gives the light of one, with and without next-event estimation") {
  const std::vector<std::pair<std::string, std::function<void(SceneBuilder&, int)>>> lamps{
      {"quad",
       [](SceneBuilder& b, int) {
         b.quad({-1, -1, 2.1f}, {-1, 1, 2.1f}, {1, 1, 2.3f}, {1, -1, 2.3f});
       }},
      {"quad in another order",
       [](SceneBuilder& b, int i) {
         if (i == 0)
           b.quad({-1, -1, 2.1f}, {-1, 1, 2.1f}, {1, 1, 2.3f}, {1, -1, 2.3f});
         else
           b.quad({-1, 1, 2.1f}, {-1, -1, 2.1f}, {1, -1, 2.3f}, {1, 1, 2.3f});
       }},
      {"sphere", [](SceneBuilder& b, int) {
         b.sphere({0, 0, 2}, 0.5f);
       }}};
  onBothTracers([&](const RenderFunction& renderScene) {
    for (const auto& [name, add] : lamps) {
      const auto mean = [&, add = add](int copies, bool nextEventEstimation) {
        SceneBuilder b;
        b.view({0, -1, 1}, {0, 0, 0}, {0, 0, 1}, 20);
        b.material(diffuseMaterial(vec3(0.5f))).quad({-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0});
        b.material(diffuseMaterial(vec3(0.5f), vec3(3)));
        for (int i = 0; i < copies; ++i) add(b, i);
        render::RenderSettings settings = settingsOf(16, 1024);
        settings.image.maxDepth = 3;
        settings.image.nextEventEstimation = nextEventEstimation;
        return meanLuminance(renderScene(b.scene, settings).film);
      };
      const double once = mean(1, true);
      CAPTURE(name);
      CHECK(mean(2, true) == Approx(once).epsilon(0.01));
      CHECK(mean(2, false) == Approx(once).epsilon(0.02));
    }
  });
}

namespace {

// A frame of orthogonal axes along which all coordinates are rounded.
struct Tilted {
  double scale;

  vec3 at(double x, double y, double z) const {
    const glm::dvec3 right = glm::normalize(glm::dvec3(0.9, 0.3, -0.2));
    const glm::dvec3 up = glm::normalize(glm::cross(glm::dvec3(-0.1, 0.2, 0.95), right));
    return vec3(scale * (glm::dvec3(0.3, -0.7, 0.2) + x * right + y * up + z * glm::cross(right, up)));
  }
};

// A block, of which the faces towards -z and +z have their own diagonals and sizes.
void addTiltedBlock(SceneBuilder& b, const Tilted& t, double half, double low, double high) {
  const auto corner = [&](int x, int y, int z) {
    return t.at(x ? half : -half, y ? 0.9 * half : -0.9 * half, z ? high : low);
  };
  b.quad(corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0));
  b.quad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  b.quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
  b.quad(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
  b.quad(corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1));
  b.quad(corner(0, 1, 0), corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1));
}

void addTiltedSheet(SceneBuilder& b, const Tilted& t, double half, double z) {
  b.quad(t.at(-half, -half, z), t.at(half, -0.8 * half, z), t.at(half, half, z), t.at(-0.9 * half, half, z));
}

}  // namespace

TEST_CASE("surfaces in one plane show what they show with a gap between them, from both sides, in either order") {
  const scene::Material paper = diffuseMaterial(vec3(0.7f));
  scene::Material foil = clearGlass(1.5f, true);
  foil.surface->baseColour = vec3(0.5f);
  const scene::Material glass = clearGlass(1.5f), water = clearGlass(1.33f);
  using Add = std::function<void(SceneBuilder&, const Tilted&, double)>;  // with the height of what is in the plane
  const auto sheet = [](const scene::Material& material, double half) -> Add {
    return [=](SceneBuilder& b, const Tilted& t, double z) { b.material(material), addTiltedSheet(b, t, half, z); };
  };
  const auto blockAbove = [](const scene::Material& material) -> Add {
    return [=](SceneBuilder& b, const Tilted& t, double z) { b.material(material), addTiltedBlock(b, t, 0.8, z, 0.5); };
  };
  const auto blockBelow = [](const scene::Material& material) -> Add {
    return
        [=](SceneBuilder& b, const Tilted& t, double z) { b.material(material), addTiltedBlock(b, t, 0.9, -0.5, z); };
  };
  struct Case {
    std::string name;
    Add fixed, moved;
    double gap;
    double view;   // height of the eye
    double scale;  // unit of length
  };
  constexpr double kGap = 1e-3;
  const std::vector<Case> cases{
      {"foil on paper, from above", sheet(paper, 7), sheet(foil, 0.8), kGap, 2, 1},
      {"foil on paper, from below", sheet(paper, 7), sheet(foil, 0.8), -kGap, -2, 30},
      {"glass on paper, from above", sheet(paper, 7), blockAbove(glass), kGap, 2, 30},
      {"label on glass, from the label's side", blockAbove(glass), sheet(paper, 0.5), -kGap, -2, 1},
      {"glass on water, from above", blockBelow(water), blockAbove(glass), kGap, 2, 1},
      {"glass on water, from below", blockBelow(water), blockAbove(glass), kGap, -2, 30},
      {"glass on glass, from above", blockBelow(glass), blockAbove(glass), kGap, 2, 30}};
  onBothTracers([&](const RenderFunction& renderScene) {
    for (const Case& c : cases) {
      const auto mean = [&](bool movedFirst, double z) {
        const Tilted t{c.scale};
        SceneBuilder b;
        b.scene.background = vec3(1);
        b.view(t.at(1.5, 0.3, c.view), t.at(0, 0, 0.1 * c.view), {0, 0, 1}, 20);
        if (movedFirst) c.moved(b, t, z);
        c.fixed(b, t, 0);
        if (!movedFirst) c.moved(b, t, z);
        render::RenderSettings settings = settingsOf(16, 256);
        settings.image.maxDepth = 64;
        return meanLuminance(renderScene(b.scene, settings).film);
      };
      CAPTURE(c.name);
      const double apart = mean(false, c.gap);
      CHECK(mean(false, 0) == Approx(apart).epsilon(0.005));
      CHECK(mean(true, 0) == Approx(apart).epsilon(0.005));
    }
  });
}
