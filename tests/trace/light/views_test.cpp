// The auxiliary integrators: both tracers show the known values.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <vector>

#include "host/judge/verify/agreement.h"
#include "tests/trace/render/both_tracers.h"

using namespace candela;
using namespace candela::device;
using glm::dvec3;
using glm::vec3;

namespace {

constexpr std::array kViews{render::Integrator::ao,    render::Integrator::normal, render::Integrator::albedo,
                            render::Integrator::depth, render::Integrator::id,     render::Integrator::cost};

// A floor z = 0 and a wall y = 0 whose normal points away from the cameras, and far from both, 20 apart: a ball of each
// material and a triangle whose vertex normals lean.
const scene::Scene& exhibition() {
  static const scene::Scene scene = sceneFromText(
      "v\nfrom 40 -160 30\nat 40 -60 3\nup 0 0 1\nangle 50\nhither 0\nresolution 64 64\n"
      "f .8 .5 .25 1 0 0 0 0 1 0 1 0 0 0\npl 0 0 0 1 0 0 0 1 0\npl 0 0 0 0 0 1 1 0 0\n"
      "f .8 .5 .25 .6 1 .5 .2 .5 20 .3 1.5 0 0 0\ns 0 -100 5 1\n"
      "f .9 .8 .7 0 1 1 1 1 1 0 1 0 0 0\ns 20 -100 5 1\n"
      "f .9 .8 .7 0 0 0 0 0 1 1 0 0 0 0\ns 40 -100 5 1\n"
      "f .1 .2 .3 1 0 0 0 0 1 0 1 9 9 9\ns 60 -100 5 1\n"
      "f .98 .9 .95 0 0 0 0 0 1 1 1.5 0 0 0\ns 80 -100 5 1\n"
      "f .4 .3 .2 1 0 0 0 0 1 0 1 0 0 0\n"
      "pp 3\n99 -101 5 1 0 1\n101 -101 5 1 0 1\n100 -99 5 1 0 1\n");
  return scene;
}

const vec3 kMixedBall(0, -100, 5), kMirrorBall(20, -100, 5), kBlackBall(40, -100, 5), kLamp(60, -100, 5),
    kGlassBall(80, -100, 5), kLeaningTriangle(100, -100, 5);

const vec3 kAway(0, -600, 200), kOutside(0, -500, 100);  // a target with nothing behind it, as seen from outside

// Through a field of view of a hundredth of a degree.
scene::Scene lookingAt(const vec3& at, const vec3& from) {
  scene::Scene scene = exhibition();
  scene.camera->from = from;
  scene.camera->at = at;
  scene.camera->up = vec3(0.1f, 1, 0.2f);
  scene.camera->angle = 0.01f;
  return scene;
}

render::RenderSettings viewSettings(render::Integrator integrator, std::uint32_t side, std::uint32_t samples) {
  render::RenderSettings settings = squareSettings(side, samples);
  settings.image.integrator = integrator;
  settings.execution.recordPaths = true;  // always, so that each view of a scene has one kernel
  return settings;
}

dvec3 seen(const RenderFunction& renderScene, render::Integrator integrator, const vec3& at, const vec3& from) {
  return renderScene(lookingAt(at, from), viewSettings(integrator, 4, 1)).film.mean(2, 2);
}

dvec3 seenFromAbove(const RenderFunction& renderScene, render::Integrator integrator, const vec3& at) {
  return seen(renderScene, integrator, at, at + vec3(0, 0, 3));
}

void checkClose(const dvec3& value, const dvec3& expected) {
  CAPTURE(value.x, value.y, value.z, expected.x, expected.y, expected.z);
  CHECK(glm::distance(value, expected) < 2e-4);
}

double samePrimitiveFraction(const render::RenderResult& a, const render::RenderResult& b) {
  std::size_t same = 0;
  for (std::size_t i = 0; i < a.paths.size(); ++i) same += a.paths[i].vertices[0] == b.paths[i].vertices[0];
  return static_cast<double>(same) / static_cast<double>(a.paths.size());
}

void requireReferencesPixels(const scene::Scene& scene, render::Integrator integrator) {
  const render::RenderSettings settings = viewSettings(integrator, 64, 1);
  const render::RenderResult device = renderOnDevice(scene, settings);
  const render::RenderResult reference = renderOnReference(scene, settings);
  const verify::PixelAgreement pixels = verify::comparePixels(device, reference);
  CAPTURE(scene.name, static_cast<int>(integrator), pixels.causes, pixels.worst, pixels.worstX, pixels.worstY);
  CHECK(pixels.equalFraction() >= 0.999);
  CHECK(pixels.lit > pixels.pixels / 2);
  CHECK(samePrimitiveFraction(device, reference) >= 0.999);
  CHECK(device.statistics.vertices == Approx(reference.statistics.vertices).epsilon(1e-3));
  CHECK(device.statistics.shadowRays == Approx(reference.statistics.shadowRays).epsilon(1e-3));
  CHECK(device.statistics.bounceRays == 0);
}

double mean(const image::Film& film) {
  dvec3 sum(0);
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) sum += film.mean(x, y);
  }
  return sum.x / (static_cast<double>(film.width()) * film.height());
}

}  // namespace

TEST_CASE("normals have the primitive's own orientation, whichever side is seen") {
  constexpr render::Integrator kNormal = render::Integrator::normal;
  onBothTracers([&](const RenderFunction& renderScene) {
    const vec3 towards(2 / 3.f, -1 / 3.f, 2 / 3.f);
    checkClose(seen(renderScene, kNormal, kMixedBall, kMixedBall + 5.f * towards), {5 / 6., 1 / 3., 5 / 6.});
    checkClose(seen(renderScene, kNormal, kMixedBall + 5.f * towards, kMixedBall), {5 / 6., 1 / 3., 5 / 6.});
    checkClose(seen(renderScene, kNormal, {0, 0, 50}, {0, -9, 50}), {0.5, 1, 0.5});
    const double lean = 0.5 + std::sqrt(0.125);
    checkClose(seenFromAbove(renderScene, kNormal, kLeaningTriangle), {lean, 0.5, lean});
    checkClose(seen(renderScene, kNormal, kLeaningTriangle, kLeaningTriangle - vec3(0, 0, 3)), {lean, 0.5, lean});
    CHECK(seen(renderScene, kNormal, kAway, kOutside) == dvec3(0));
  });
  SECTION("pixel by pixel") { requireReferencesPixels(exhibition(), kNormal); }
}

TEST_CASE("the view albedo shows the file's colours, weighted as the lobes are") {
  constexpr render::Integrator kAlbedo = render::Integrator::albedo;
  onBothTracers([&](const RenderFunction& renderScene) {
    checkClose(seenFromAbove(renderScene, kAlbedo, {0, -50, 0}), {0.8, 0.5, 0.25});
    // Kd 0.6, Ks 0.5 and T 0.3 are scaled to the sum 1.
    const dvec3 mixed = (0.9 * dvec3(0.8, 0.5, 0.25) + 0.5 * dvec3(1, 0.5, 0.2)) / 1.4;
    checkClose(seenFromAbove(renderScene, kAlbedo, kMixedBall), mixed);
    checkClose(seenFromAbove(renderScene, kAlbedo, kMirrorBall), {0.9, 0.8, 0.7});
    checkClose(seenFromAbove(renderScene, kAlbedo, kGlassBall), {0.98, 0.9, 0.95});
    checkClose(seenFromAbove(renderScene, kAlbedo, kLamp), {0.1, 0.2, 0.3});
    CHECK(seenFromAbove(renderScene, kAlbedo, kBlackBall) == dvec3(0));
    CHECK(seen(renderScene, kAlbedo, kAway, kOutside) == dvec3(0));
  });
  SECTION("pixel by pixel") { requireReferencesPixels(exhibition(), kAlbedo); }
}

TEST_CASE("the view depth shows the distance along the ray") {
  constexpr render::Integrator kDepth = render::Integrator::depth;
  onBothTracers([&](const RenderFunction& renderScene) {
    CHECK(seenFromAbove(renderScene, kDepth, {0, -50, 0}).x == Approx(3).epsilon(1e-5));
    CHECK(seen(renderScene, kDepth, {0, -50, 0}, {0, -54, 3}).y == Approx(5).epsilon(1e-3));
    CHECK(seen(renderScene, kDepth, kMixedBall, kMixedBall + vec3(0, 3, 4)).z == Approx(4).epsilon(1e-4));
    CHECK(seen(renderScene, kDepth, kAway, kOutside) == dvec3(0));
  });
  SECTION("pixel by pixel") { requireReferencesPixels(exhibition(), kDepth); }
}

TEST_CASE("the view id shows a different colour for each primitive, the same on both tracers") {
  constexpr render::Integrator kId = render::Integrator::id;
  const vec3 kFloor(0, -50, 0);
  const std::vector<vec3> objects{kFloor, kMixedBall, kMirrorBall, kBlackBall, kLamp, kGlassBall, kLeaningTriangle};
  std::set<std::array<double, 3>> colours;
  const auto note = [&](const vec3& at, const vec3& from) {
    const dvec3 colour = seen(renderOnDevice, kId, at, from);
    CHECK(colour == seen(renderOnReference, kId, at, from));
    CHECK(glm::all(glm::greaterThan(colour, dvec3(0))));
    CHECK(glm::all(glm::lessThanEqual(colour, dvec3(1))));
    CHECK(colour * 256.0 == glm::floor(colour * 256.0));
    colours.insert({colour.x, colour.y, colour.z});
  };
  for (const vec3& object : objects) note(object, object + vec3(0, 0, 3));
  note({0, 0, 50}, {0, -9, 50});
  CHECK(colours.size() == exhibition().primitives.size());
  CHECK(seen(renderOnDevice, kId, kAway, kOutside) == dvec3(0));
  requireReferencesPixels(exhibition(), kId);
}

TEST_CASE("the view ao shows the cosine-weighted fraction of directions without an occluder") {
  constexpr render::Integrator kAo = render::Integrator::ao;
  onBothTracers([&](const RenderFunction& renderScene) {
    render::RenderSettings settings = viewSettings(kAo, 8, 256);
    settings.image.aoDistance = 8.f;
    const auto above = [](double distance, float height) {
      const vec3 foot(0, -static_cast<float>(distance), 0);
      return lookingAt(foot, foot + vec3(0, 0, height));
    };
    CHECK(mean(renderScene(above(50, 4), settings).film) == 1);
    // In the corner, half of the directions hit the wall. 16384 samples: a standard deviation of 0.004.
    CHECK(mean(renderScene(above(1e-3, 4), settings).film) == Approx(0.5).margin(0.016));
    // At distance d < D those do whose component towards the wall exceeds a = d/D, cosine-weighted a coordinate of the
    // unit disc: 1 - (acos a - a sqrt(1 - a^2)) / pi.
    const double a = 0.25;
    const double expected = 1 - (std::acos(a) - a * std::sqrt(1 - a * a)) / 3.14159265358979;
    CHECK(mean(renderScene(above(2, 4), settings).film) == Approx(expected).margin(0.016));
    settings.image.aoDistance.reset();  // a quarter of the way from eye to target
    CHECK(mean(renderScene(above(2, 32), settings).film) == Approx(expected).margin(0.016));
    CHECK(mean(renderScene(above(2, 4), settings).film) == 1);
    const render::RenderResult missed = renderScene(lookingAt(kAway, kOutside), settings);
    CHECK(mean(missed.film) == 1);
    CHECK(missed.statistics.shadowRays == 0);
  });
  SECTION("pixel by pixel") { requireReferencesPixels(exhibition(), kAo); }
}

TEST_CASE("the view cost shows the traversal steps of the statistics, pixel by pixel") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  const auto primitives = static_cast<double>(scene.primitives.size());
  // Mean cost with a BVH.
  const auto meanCost = [&](const RenderFunction& renderScene) {
    render::RenderSettings settings = viewSettings(render::Integrator::cost, 64, 4);
    settings.structure.accel = render::AccelKind::none;
    const image::Film all = renderScene(scene, settings).film;
    for (std::uint32_t i = 0; i < 64; ++i) CHECK(all.mean(i, 63 - i) == dvec3(primitives));
    settings.structure.accel = render::AccelKind::bvh;
    settings.structure
        .bvhLayout = render::BvhLayout::cwbvh;  // the device would test so few primitives as a linear list
    const render::RenderResult tree = renderScene(scene, settings);
    CHECK(mean(tree.film) * 4 * 64 * 64 == static_cast<double>(tree.statistics.traversalSteps));
    return mean(tree.film);
  };
  SECTION("device, where a tree spares tests") { CHECK(meanCost(renderOnDevice) < 0.5 * primitives); }
  SECTION("reference, where so few primitives have no tree") { CHECK(meanCost(renderOnReference) == primitives); }
}

TEST_CASE("every view of all kinds of primitives has the reference's pixels") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  for (const render::Integrator view : kViews) {
    if (view != render::Integrator::cost) requireReferencesPixels(scene, view);
  }
}

TEST_CASE("the division of work, the structure, and options of paths do not change a view", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  render::RenderSettings settings = viewSettings(render::Integrator::ao, 64, 4);
  settings.image.size.height = 50;  // not a multiple of any workgroup
  const std::uint64_t expected = renderOnDevice(scene, settings).film.hash();
  const auto check = [&](auto change) {
    render::RenderSettings changed = settings;
    change(changed);
    CHECK(renderOnDevice(scene, changed).film.hash() == expected);
  };
  check([](render::RenderSettings& s) { s.execution.segmentsPerDispatch = 1; });
  check([](render::RenderSettings& s) { s.execution.tile = render::Extent{17, 5}; });
  check([](render::RenderSettings& s) { s.image.maxDepth = 1; });
  check([](render::RenderSettings& s) { s.image.rouletteStart = 0; });
  check([](render::RenderSettings& s) { s.image.nextEventEstimation = false; });
  check([](render::RenderSettings& s) { s.structure.accel = render::AccelKind::grid; });
  check([](render::RenderSettings& s) { s.structure.accel = render::AccelKind::none; });
  check([](render::RenderSettings& s) { s.execution.workgroup = {16, 4}; });
  render::RenderSettings reseeded = settings;
  reseeded.image.seed = 1;
  CHECK(renderOnDevice(scene, reseeded).film.hash() != expected);
}
