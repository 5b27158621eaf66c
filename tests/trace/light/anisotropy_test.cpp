// Anisotropic surfaces on both tracers: the same pixels at equal seeds, and highlights of the closed form.
#include <catch2/catch.hpp>
#include <numbers>
#include <random>

#include "host/formats/loading/mikk_tangents.h"
#include "host/image/image.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;

namespace {

constexpr float kPiHalf = std::numbers::pi_v<float> / 2;

scene::TextureImage randomTexels(std::uint32_t side, std::uint32_t seed) {
  std::mt19937 random(seed);
  scene::TextureImage image{"grain", side, side, {}};
  for (std::uint32_t i = 0; i < side * side; ++i) image.texels.push_back(static_cast<std::uint32_t>(random()));
  return image;
}

// A square from `corner` along two edges; its tangents, unless their handedness is 0, run along `u`.
scene::Mesh tangentSquare(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v, float handedness = 1) {
  scene::Mesh mesh;
  mesh.positions = {corner, corner + u, corner + u + v, corner + v};
  mesh.texCoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  if (handedness != 0) mesh.tangents.assign(4, glm::vec4(glm::normalize(u), handedness));
  return mesh;
}

scene::Material brushed(float strength, float rotation = 0, float roughness = 0.3f) {
  scene::Material material;
  material.surface = scene::SurfaceParameters{.baseColour = {0.9f, 0.6f, 0.3f}, .metalness = 1, .roughness = roughness};
  material.surface->anisotropy = strength;
  material.surface->anisotropyRotation = rotation;
  return material;
}

scene::Material withImage(scene::Material material, scene::TextureSlot slot, std::uint32_t image) {
  material.textures[static_cast<std::size_t>(slot)] = scene::TextureReference{.image = image};
  return material;
}

void addSquare(test::SceneBuilder& b, const scene::Material& material, const scene::Mesh& mesh) {
  b.material(material);
  addMesh(b.scene, mesh, static_cast<std::uint32_t>(b.scene.materials.size() - 1));
}

// Squares in front of a wall: plain, with a texture, with a normal map below a coat, a thin wall, and glass around a
// volume.
scene::Scene brushedSquares() {
  test::SceneBuilder b;
  b.scene.images = {randomTexels(8, 11), randomTexels(4, 12)};
  b.material(test::diffuseMaterial(glm::vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(test::diffuseMaterial({0.9f, 0.2f, 0.1f})).box({-4, 1, 0}, {4, 1.2f, 1});
  const auto square = [](float x) { return tangentSquare({x, 0, 0.1f}, {1.5f, 0.3f, 0}, {0.2f, 0, 1.8f}); };
  addSquare(b, brushed(0.8f, 0.5f), square(-3.5f));
  addSquare(b, withImage(brushed(0.9f), scene::TextureSlot::anisotropy, 0), square(-1.7f));
  scene::Material mapped = withImage(brushed(0.7f, 1), scene::TextureSlot::normal, 1);
  mapped.surface->coatWeight = 0.5f;
  mapped.surface->metalness = 0.3f;
  addSquare(b, mapped, square(0.1f));
  scene::Material glass = brushed(0.6f, 2, 0.2f);
  glass.surface->metalness = 0;
  glass.surface->transmissionWeight = 1;
  addSquare(b, glass, square(1.9f));
  glass.surface->isThinWalled = false;
  addSquare(b, glass, tangentSquare({-0.8f, 0, 2}, {1.5f, 0.3f, 0}, {0.2f, 0, 0.9f}));
  b.pointLight({-1, -4, 4}, glm::vec3(1));
  b.scene.background = glm::vec3(0.3f);
  b.view({0, -7, 1.5f}, {0, 0, 0.9f}, {0, 0, 1}, 40);
  b.scene.name = "brushed squares";
  return b.scene;
}

// The red that a square in the plane z = 0 reflects upwards from a light whose half vector has the slope `slope`.
double highlight(const RenderFunction& render, const scene::Material& material, const glm::dvec2& slope,
                 float handedness = 1) {
  test::SceneBuilder b;
  b.scene.images = {{"up", 1, 1, {0xffffff80u}}};  // (0, 1), strength 1
  addSquare(b, material, tangentSquare({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, handedness));
  const glm::dvec3 h = glm::normalize(glm::dvec3(slope, 1));
  b.pointLight(glm::vec3(1e4 * (2 * h.z * h - glm::dvec3(0, 0, 1))), glm::vec3(1));
  b.view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.001f);
  render::RenderSettings settings = squareSettings(1, 1);
  settings.image.maxDepth = 2;
  return image::toImage(render(b.scene, settings).film).at(0, 0).x;
}

// D V cosI of the extension's text, for wo along the normal and a half vector of this slope.
double closedForm(double at, double ab, const glm::dvec2& slope) {
  const glm::dvec3 h = glm::normalize(glm::dvec3(slope, 1)), wi = 2 * h.z * h - glm::dvec3(0, 0, 1);
  const glm::dvec3 f(ab * h.x, at * h.y, at * ab * h.z);
  const double w = at * ab / dot(f, f), d = at * ab * w * w / std::numbers::pi;
  return d * 0.5 / (wi.z + length(glm::dvec3(at * wi.x, ab * wi.y, wi.z))) * wi.z;
}

}  // namespace

TEST_CASE("anisotropic surfaces have the reference's pixels at equal seeds") {
  const scene::Scene scene = brushedSquares();
  for (const std::uint32_t seed : {0u, 1u}) {
    render::RenderSettings settings = squareSettings(96, 1);
    settings.image.seed = seed;
    checkPixelsAgree(scene, settings);
  }
}

TEST_CASE("highlights are elongated along the direction that the rotation and the texture state") {
  const double ab = 0.09, at = ab + (1 - ab) * 0.49;
  const auto strength = [](float rotation) { return brushed(0.7f, rotation); };
  const glm::dvec2 along(0.25, 0), across(0, 0.25), up(0.2, 0.2), down(0.2, -0.2);
  const double ratio = closedForm(at, ab, along) / closedForm(at, ab, across);
  const double diagonal = closedForm(at, ab, {std::hypot(0.2, 0.2), 0}) / closedForm(at, ab, {0, std::hypot(0.2, 0.2)});
  onBothTracers([&](const RenderFunction& render) {
    const auto quotient = [&](const scene::Material& material, const glm::dvec2& a, const glm::dvec2& b) {
      return highlight(render, material, a) / highlight(render, material, b);
    };
    const double mirrored = highlight(render, strength(kPiHalf / 2), down, -1) /
                            highlight(render, strength(kPiHalf / 2), up, -1);
    CHECK(mirrored == Approx(diagonal).epsilon(5e-3));
    const auto upward = [](const scene::Material& m) { return withImage(m, scene::TextureSlot::anisotropy, 0); };
    CHECK(quotient(strength(0), along, across) == Approx(ratio).epsilon(2e-3));
    CHECK(quotient(strength(kPiHalf), across, along) == Approx(ratio).epsilon(2e-3));
    CHECK(quotient(strength(kPiHalf / 2), up, down) == Approx(diagonal).epsilon(5e-3));
    // Red is 128, so that the texture's direction is half a step of the bytes off the bitangent.
    CHECK(quotient(upward(strength(0)), across, along) == Approx(ratio).epsilon(0.02));
    CHECK(quotient(upward(strength(-kPiHalf / 2)), up, down) == Approx(diagonal).epsilon(0.02));
  });
}

TEST_CASE("without a tangent, and with the strength 0, a surface is isotropic") {
  onBothTracers([](const RenderFunction& render) {
    const glm::dvec2 along(0.25, 0);
    const double isotropic = highlight(render, brushed(0), along);
    CHECK(highlight(render, brushed(0, 1), along) == isotropic);
    CHECK(highlight(render, brushed(0.7f), along, 0) == Approx(isotropic).epsilon(1e-5));
    CHECK(highlight(render, brushed(0.7f), along) > 1.5 * isotropic);
  });
}
