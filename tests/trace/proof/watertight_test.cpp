// Rays from inside closed meshes must hit them, also far from the origin, where single precision is coarse; after the
// watertightness test of Embree (Wald et al., SIGGRAPH 2014): at most 2e-5 of the rays may miss.
#include <catch2/catch.hpp>
#include <random>

#include "tests/trace/proof/closed_meshes.h"
#include "tests/trace/proof/leaves.h"

using namespace candela;
using namespace candela::proof;
using glm::vec3;

namespace {

constexpr double kAllowedMisses = 2e-5;
constexpr std::size_t kBatch = 500000;  // rays at a time
const vec3 kFarAway(148376, 1234, -223423);

// A third of the rays goes through vertices, a third through edges, the rest anywhere.
class RaySource {
 public:
  RaySource(const ClosedMesh& mesh, float spread) : mesh_(mesh), spread_(spread) {}

  std::vector<ProofRay> next(std::size_t count) {
    std::vector<ProofRay> rays(count);
    for (std::size_t i = 0; i < count; ++i) {
      const vec3 origin = mesh_.middle + spread_ * inCube();
      rays[i] = {origin, glm::normalize(target(i % 3) - origin)};
    }
    return rays;
  }

 private:
  float uniform() { return static_cast<float>(random_() >> 8) * 0x1p-24f; }
  vec3 inCube() {
    const float x = uniform(), y = uniform(), z = uniform();
    return 2.0f * vec3(x, y, z) - 1.0f;
  }
  vec3 target(std::size_t kind) {
    const glm::uvec3 face = mesh_.faces[random_() % mesh_.faces.size()];
    const vec3 a = mesh_.vertices[face.x], b = mesh_.vertices[face.y], c = mesh_.vertices[face.z];
    if (kind == 0) return a;
    if (kind == 1) return glm::mix(a, random_() % 2 == 0 ? b : c, uniform());
    return mesh_.middle + inCube();
  }

  const ClosedMesh& mesh_;
  float spread_;
  std::mt19937 random_{401};
};

struct NamedMesh {
  const char* name;
  ClosedMesh mesh;
};

std::vector<NamedMesh> closedMeshes() {
  const ClosedMesh sphere = sphereMesh(20, 128, 64), box = boxMesh(20, 24), needles = sphereMesh(20, 2000, 3);
  return {{"sphere", sphere},
          {"box", box},
          {"needles", needles},
          {"sphere far away", sphere.movedTo(kFarAway)},
          {"box far away", box.movedTo(kFarAway)},
          {"needles far away", needles.movedTo(kFarAway)}};
}

std::size_t misses(const ClosedMesh& mesh, std::size_t rayCount) {
  const RayLeaves leaves(mesh.scene());
  RaySource source(mesh, 4);
  std::size_t missed = 0;
  for (std::size_t done = 0; done < rayCount; done += kBatch) {
    for (const TracedHit& hit : leaves.closest(source.next(std::min(kBatch, rayCount - done)))) {
      missed += hit.primitive == TracedHit::kMiss;
    }
  }
  return missed;
}

void checkWatertight(std::size_t raysPerMesh) {
  for (const NamedMesh& closed : closedMeshes()) {
    const std::size_t missed = misses(closed.mesh, raysPerMesh);
    CAPTURE(closed.name, missed, raysPerMesh);
    CHECK(static_cast<double>(missed) <= kAllowedMisses * static_cast<double>(raysPerMesh));
  }
}

}  // namespace

TEST_CASE("at most two of a hundred thousand rays into each closed mesh miss it", "[swiftshader-slow]") {
  checkWatertight(100000);
}

TEST_CASE("at most two hundred of ten million rays into each closed mesh miss it", "[slow]") {
  checkWatertight(10000000);
}

TEST_CASE("rays through the gap of an open mesh are counted as misses") {
  ClosedMesh open = sphereMesh(20, 128, 64);
  open.faces.resize(open.faces.size() - 100);
  CHECK(misses(open, 100000) > 100);
}
