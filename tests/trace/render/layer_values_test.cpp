// Layers: the reference's values, and closed forms on both tracers.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "host/base/errors.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/film_channels.h"

using namespace candela;
using namespace candela::device;
using glm::dvec3;

namespace {

// Returns the number of pixels in which a channel of the two differs by more than `tolerance`, relative to values
// above 1.
std::size_t differingPixels(const Channels& a, const Channels& b, double tolerance) {
  std::size_t count = 0;
  const std::size_t pixelCount = a.all().front().values.size();
  for (std::size_t pixel = 0; pixel < pixelCount; ++pixel) {
    const auto differs = [&](std::size_t channel) {
      const double left = double{a.all()[channel].values[pixel]}, right = double{b.all()[channel].values[pixel]};
      return std::abs(left - right) > tolerance * std::max(1.0, std::abs(left));
    };
    bool found = false;
    for (std::size_t channel = 0; channel < a.all().size(); ++channel) found = found || differs(channel);
    count += found ? 1 : 0;
  }
  return count;
}

// A diffuse ball of radius 2 around (0, 6, 0), seen from the origin along y, with nothing behind.
scene::Scene ballScene() {
  return sceneFromText(
      "b .25 .5 1\nv\nfrom 0 0 0\nat 0 1 0\nup 0 0 1\nangle 60\nhither 0\nresolution 24 24\n"
      "f .8 .5 .25 1 0 0 0 0 1 0 1 0 0 0\ns 0 6 0 2\n");
}

// The unit direction of the ray through the centre of a pixel of ballScene().
dvec3 directionThrough(std::uint32_t x, std::uint32_t y, std::uint32_t side) {
  const double half = std::tan(M_PI / 6);
  const auto across = [&](double pixel) { return half * ((pixel + 0.5) / side * 2 - 1); };
  return glm::normalize(dvec3(across(x), 1, -across(y)));
}

}  // namespace

TEST_CASE("both tracers have the same layers at one sample") {
  // Rounding may change hits at edges, and a path after curved surfaces.
  for (const char* name : {"primitives.p3f", "cornell.p3f", "balls.p3f", "sky.p3f"}) {
    CAPTURE(name);
    const scene::Scene scene = loadTestScene(name);
    const Channels device(renderOnDevice(scene, layerSettings(64, 1)).film);
    const Channels reference(renderOnReference(scene, layerSettings(64, 1)).film);
    CHECK(static_cast<double>(differingPixels(device, reference, 1e-4)) <= (1 - kRequiredEqualFraction) * 64 * 64);
  }
}

TEST_CASE("the mean square root of one sample is that of its radiance") {
  const scene::Scene scene = loadTestScene("sky.p3f");
  onBothTracers([&](const RenderFunction& render) {
    const image::Film film = render(scene, layerSettings(16, 1)).film;
    const Channels channels(film);
    for (std::uint32_t y = 0; y < 16; ++y) {
      for (std::uint32_t x = 0; x < 16; ++x) {
        const dvec3 difference = channels.vectorAt("sqrt", "RGB", x, y) - sqrt(film.mean(x, y));
        REQUIRE(length(difference) < 1e-5 * (1 + length(film.mean(x, y))));
      }
    }
  });
}

TEST_CASE("normals, distances and positions of a ball have their closed form") {
  constexpr std::uint32_t kBallSide = 24;
  onBothTracers([&](const RenderFunction& render) {
    const image::Film film = render(ballScene(), centreSettings(kBallSide)).film;
    const Channels channels(film);
    std::uint32_t hits = 0;
    for (std::uint32_t y = 0; y < kBallSide; ++y) {
      for (std::uint32_t x = 0; x < kBallSide; ++x) {
        const dvec3 d = directionThrough(x, y, kBallSide);
        const double b = 6 * d.y, discriminant = b * b - 32;
        if (std::abs(discriminant) < 1e-3) continue;
        const bool isHit = discriminant > 0;
        hits += isHit ? 1 : 0;
        REQUIRE(film.layerRowsAt(x, y)[0].words[0] == (isHit ? 1u : 0u));
        const double distance = isHit ? b - std::sqrt(discriminant) : 1e10;
        const dvec3 position = isHit ? distance * d : dvec3(0);
        const dvec3 normal = isHit ? (position - dvec3(0, 6, 0)) / 2.0 : dvec3(0);
        CHECK(channels.at("Z", x, y) == Approx(distance).epsilon(1e-5));
        CHECK(length(channels.vectorAt("P", "XYZ", x, y) - position) < 1e-5);
        CHECK(length(channels.vectorAt("N", "XYZ", x, y) - normal) < 1e-5);
        CHECK(length(channels.vectorAt("albedo", "RGB", x, y) - (isHit ? dvec3(0.8, 0.5, 0.25) : dvec3(0))) < 1e-6);
      }
    }
    CHECK(hits > 100);
  });
}

TEST_CASE("at a silhouette, normals and albedo are means over all samples, distances and positions over the hits") {
  // The left half of each pixel shows a wall at y = 4, whose normal faces the eye, and the right half shows nothing.
  const scene::Scene scene = sceneFromText(
      "v\nfrom 0 0 0\nat 0 1 0\nup 0 0 1\nangle 1\nhither 0\nresolution 1 1\n"
      "f .8 .5 .25 1 0 0 0 0 1 0 1 0 0 0\np 4\n-9 4 -9\n0 4 -9\n0 4 9\n-9 4 9\n");
  onBothTracers([&](const RenderFunction& render) {
    render::RenderSettings settings = layerSettings(1, 16);
    settings.image.sampler = render::SamplerKind::stratified;
    const image::Film film = render(scene, settings).film;
    CHECK(film.layerRowsAt(0, 0)[0].words[0] == 8);
    const Channels channels(film);
    CHECK(channels.at("N.Y", 0, 0) == Approx(-0.5));
    CHECK(channels.at("albedo.G", 0, 0) == Approx(0.25));
    CHECK(channels.at("Z", 0, 0) == Approx(4).epsilon(1e-4));
    CHECK(channels.at("P.Y", 0, 0) == Approx(4).epsilon(1e-6));
  });
}

TEST_CASE("normals are those of the side that is seen, and vertex normals are interpolated") {
  const float side = GENERATE(1.0f, -1.0f);
  scene::Scene scene = sceneFromText(
      "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 0.01\nhither 0\nresolution 1 1\nf 1 1 1 1 0 0 0 0 1 0 1 0 0 0\n"
      "pp 3\n-3 -3 0 -.6 0 -.8\n3 -3 0 -.6 0 -.8\n0 6 0 -.6 0 -.8\n");
  scene.camera->from.z *= side;
  onBothTracers([&](const RenderFunction& render) {
    const Channels channels(render(scene, centreSettings(1)).film);
    CHECK(length(channels.vectorAt("N", "XYZ", 0, 0) - double{side} * dvec3(0.6, 0, 0.8)) < 1e-6);
  });
}

TEST_CASE("texture coordinates are those of set 0, also where no texture needs them, and 0 where there are none") {
  test::SceneBuilder b;
  b.material(test::diffuseMaterial(glm::vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  scene::Mesh mesh;
  mesh.positions = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  mesh.texCoords[0] = {{-2, 0}, {2, 0}, {2, 8}, {-2, 8}};
  mesh.texCoords[1] = {{7, 7}, {7, 7}, {7, 7}, {7, 7}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  addMesh(b.scene, mesh, 0);
  b.scene.background = glm::vec3(1);
  b.view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 60);
  b.scene.name = "square";
  onBothTracers([&](const RenderFunction& render) {
    const Channels channels(render(b.scene, centreSettings(20)).film);
    for (std::uint32_t x = 0; x < 20; ++x) {
      const dvec3 position = channels.vectorAt("P", "XYZ", x, 7);
      const bool onSquare = position.z > 0.5;
      CHECK(channels.at("uv.U", x, 7) == Approx(onSquare ? 2 * position.x : 0).margin(1e-5));
      CHECK(channels.at("uv.V", x, 7) == Approx(onSquare ? 4 * (position.y + 1) : 0).margin(1e-5));
    }
    CHECK(channels.vectorAt("P", "XYZ", 10, 10).z == Approx(1));
  });
}

TEST_CASE("a furnace of albedo 1/2 and radiance 1 shows 1 directly, 1/2 once scattered and 1/2 of all other light") {
  const scene::Scene scene = loadTestScene("furnace.p3f");
  onBothTracers([&](const RenderFunction& render) {
    render::RenderSettings settings = layerSettings(8, 4);
    settings.image.maxDepth = settings.image.rouletteStart = 40;
    settings.image.nextEventEstimation = false;
    const Channels channels(render(scene, settings).film);
    for (std::uint32_t x = 0; x < 8; ++x) {
      CHECK(channels.at("emission.R", x, 3) == 1);
      CHECK(channels.at("direct.G", x, 3) == Approx(0.5).epsilon(1e-5));
      CHECK(channels.at("indirect.B", x, 3) == Approx(0.5).epsilon(1e-5));
    }
  });
}

TEST_CASE("paths of one and two rays have no indirect light, and their parts are the film, unit by unit",
          "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  onBothTracers([&](const RenderFunction& render) {
    render::RenderSettings settings = layerSettings(24, 4);
    settings.image.maxDepth = 2;
    const image::Film two = render(scene, settings).film;
    settings.image.maxDepth = 1;
    const image::Film one = render(scene, settings).film;
    const std::uint32_t sums = layerSumsOf(settings.image.layers);
    const std::uint32_t unscattered = firstLayerRow(sums, image::LayerSum::unscattered);
    const std::uint32_t scatteredOnce = firstLayerRow(sums, image::LayerSum::scatteredOnce);
    std::uint64_t lit = 0;
    for (std::uint32_t y = 0; y < 24; ++y) {
      for (std::uint32_t x = 0; x < 24; ++x) {
        REQUIRE(two.layerRowsAt(x, y)[scatteredOnce + 1].words == two.at(x, y).green);
        REQUIRE(two.layerRowsAt(x, y)[unscattered + 1].words == one.at(x, y).green);
        REQUIRE(one.layerRowsAt(x, y)[scatteredOnce + 2].words == one.at(x, y).blue);
        lit += two.at(x, y).green != one.at(x, y).green ? 1 : 0;
      }
    }
    CHECK(lit > 100);
  });
}

TEST_CASE("direct light, indirect light and emission add up to the image") {
  const scene::Scene scene = loadTestScene(GENERATE("cornell.p3f", "smallpt.p3f", "sky.p3f"));
  onBothTracers([&](const RenderFunction& render) {
    const image::Film film = render(scene, layerSettings(16, 4)).film;
    const Channels channels(film);
    for (std::uint32_t y = 0; y < 16; ++y) {
      for (std::uint32_t x = 0; x < 16; ++x) {
        const dvec3 direct = channels.vectorAt("direct", "RGB", x, y);
        const dvec3 indirect = channels.vectorAt("indirect", "RGB", x, y);
        const dvec3 sum = direct + indirect + channels.vectorAt("emission", "RGB", x, y);
        CHECK(std::min({direct.x, direct.y, direct.z, indirect.x, indirect.y, indirect.z}) >= 0);
        CHECK(length(sum - film.mean(x, y)) <= 3e-7 * length(sum));  // each is rounded to single precision
      }
    }
  });
}

TEST_CASE("only the path tracer has layers") {
  render::RenderSettings settings = layerSettings(4, 1);
  settings.image.integrator = GENERATE(render::Integrator::whitted, render::Integrator::normal);
  const scene::Scene scene = primitivesUnderLights();
  CHECK_THROWS_AS(testRenderer().prepare(scene, settings), UsageError);
  CHECK_THROWS_AS(reference::makeReferenceRenderer()->prepare(scene, settings), UsageError);
}
