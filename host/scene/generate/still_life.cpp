// Objects that show materials of glTF, on a floor of tiles.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/scene/generate/gltf_material.h"
#include "host/scene/generate/gltf_scenes.h"
#include "host/scene/generate/lathe.h"

namespace candela::generate {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr std::uint32_t kTextureSide = 128;
constexpr std::uint64_t kFloorTriangles = 2;

// Points on a Catmull-Rom spline through the controls, `steps` for each of them.
std::vector<dvec2> spline(const std::vector<dvec2>& controls, std::uint32_t steps) {
  std::vector<dvec2> points;
  const std::size_t last = controls.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const dvec2 a = controls[i == 0 ? 0 : i - 1], b = controls[i], c = controls[i + 1],
                d = controls[std::min(i + 2, last)];
    for (std::uint32_t k = 0; k < steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      points.push_back(b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a))));
    }
  }
  points.push_back(controls[last]);
  return points;
}

std::uint32_t splineSteps(std::uint32_t size) { return size / 8 + 1; }

std::vector<dvec2> joined(std::vector<dvec2> first, const std::vector<dvec2>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

// Outside from the middle of the foot to the lip, then inside back to the bottom.
std::vector<dvec2> vase(std::uint32_t size) {
  const std::vector<dvec2> outside = spline(
      {{0.34, 0}, {0.52, 0.35}, {0.62, 0.8}, {0.5, 1.25}, {0.24, 1.6}, {0.2, 1.85}, {0.32, 2.1}}, splineSteps(size));
  const std::vector<dvec2> inside = spline({{0.29, 2.1}, {0.17, 1.85}, {0.21, 1.6}, {0.46, 1.25}, {0.57, 0.8}},
                                           splineSteps(size));
  return joined({{0, 0}}, joined(outside, joined(inside, {{0, 0.75}})));
}

std::vector<dvec2> tumbler(std::uint32_t size) {
  const std::vector<dvec2> outside = spline({{0.3, 0}, {0.33, 0.4}, {0.4, 1}}, splineSteps(size));
  const std::vector<dvec2> inside = spline({{0.365, 1}, {0.295, 0.4}, {0.27, 0.12}}, splineSteps(size));
  return joined({{0, 0}}, joined(outside, joined(inside, {{0, 0.12}})));
}

std::vector<dvec2> bowl(std::uint32_t size) {
  const std::vector<dvec2> outside = spline({{0.25, 0}, {0.5, 0.16}, {0.68, 0.42}}, splineSteps(size));
  const std::vector<dvec2> inside = spline({{0.63, 0.42}, {0.46, 0.2}, {0.2, 0.06}}, splineSteps(size));
  return joined({{0, 0}}, joined(outside, joined(inside, {{0, 0.06}})));
}

using Pixels = std::vector<std::byte>;

void append(Pixels& pixels, const dvec3& signal) {
  for (int channel = 0; channel < 3; ++channel) {
    pixels.push_back(static_cast<std::byte>(std::lround(255 * std::clamp(signal[channel], 0.0, 1.0))));
  }
}

// Two tiles each way, with joints and a grain.
Pixels tiles() {
  constexpr std::uint32_t kTile = kTextureSide / 2;
  Pixels pixels;
  for (std::uint32_t y = 0; y < kTextureSide; ++y) {
    for (std::uint32_t x = 0; x < kTextureSide; ++x) {
      const bool isJoint = x % kTile < 2 || y % kTile < 2;
      const bool isDark = (x / kTile + y / kTile) % 2 == 1;
      const double grain = 0.06 * std::sin(0.7 * x + 3 * std::sin(0.2 * y)) * std::sin(0.31 * y);
      const dvec3 tile = isDark ? dvec3(0.36, 0.33, 0.32) : dvec3(0.82, 0.78, 0.72);
      append(pixels, isJoint ? dvec3(0.5) : tile + grain);
    }
  }
  return pixels;
}

// Rings of glaze.
Pixels rings() {
  Pixels pixels;
  for (std::uint32_t y = 0; y < kTextureSide; ++y) {
    for (std::uint32_t x = 0; x < kTextureSide; ++x) {
      const double wave = 0.5 + 0.5 * std::sin(0.55 * y + 0.5 * std::sin(2 * std::numbers::pi * 6 * x / kTextureSide));
      append(pixels, mix(dvec3(0.2, 0.32, 0.5), dvec3(0.93, 0.9, 0.82), wave * wave));
    }
  }
  return pixels;
}

GltfDocument::Json textured(const MaterialFactors& factors, std::size_t texture) {
  GltfDocument::Json material = gltfMaterial(factors);
  material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", texture}};
  return material;
}

struct Ball {
  dvec2 place;
  double radius;
  MaterialFactors material;
};

const std::vector<Ball>& balls() {
  static const std::vector<Ball> all{
      {{1.25, 0.9},
       0.45,
       {.roughness = 0,
        .transmission = 1,
        .thickness = 0.9,
        .attenuation = {0.55, 0.9, 0.75},
        .attenuationDistance = 0.8}},
      {{0.35, -0.75}, 0.6, {.colour = {1, 0.78, 0.34}, .metalness = 1, .roughness = 0.12}},
      {{-0.15, 1.35}, 0.22, {.colour = {0.72, 0.04, 0.03}, .roughness = 0.25}},
      {{2.1, -0.35}, 0.4, {.colour = {0.95, 0.64, 0.54}, .metalness = 1, .roughness = 0.45}},
      {{0.62, 1.55}, 0.16, {.colour = {0.05, 0.12, 0.5}, .roughness = 0.6, .clearcoat = 1}}};
  return all;
}

void addBalls(GltfDocument& document, std::uint32_t size) {
  for (const Ball& ball : balls()) {
    const std::size_t shape = document.addShape(lathe(sphereProfile(ball.radius, size), 2 * size));
    document.addNode(shape, document.addMaterial(gltfMaterial(ball.material)),
                     {ball.place.x, ball.radius, ball.place.y});
  }
}

}  // namespace

std::uint64_t stillLifePrimitives(std::uint32_t size) {
  std::uint64_t count = kFloorTriangles + balls().size() * latheTriangles(sphereProfile(1, size), 2 * size);
  for (const auto& profile : {vase(size), tumbler(size), bowl(size)}) count += latheTriangles(profile, 2 * size);
  return count;
}

void writeStillLife(NffWriter& out, std::uint32_t size) {
  GltfDocument document;
  const std::size_t tileTexture = document.addTexture(kTextureSide, kTextureSide, tiles());
  const std::size_t ringTexture = document.addTexture(kTextureSide, kTextureSide, rings());
  const auto add = [&](const TriangleMesh& mesh, const GltfDocument::Json& material, const dvec3& place) {
    const std::size_t index = document.addMaterial(material);
    document.addNode(document.addShape(mesh), index, place);
  };
  add(square(12, 12), textured({.roughness = 0.35}, tileTexture), {0, 0, 0});
  add(lathe(vase(size), 2 * size),
      gltfMaterial({.colour = {0.02, 0.22, 0.24}, .roughness = 0.4, .clearcoat = 1, .clearcoatRoughness = 0.03}),
      {-1.1, 0, -0.55});
  add(lathe(tumbler(size), 2 * size), gltfMaterial({.roughness = 0, .transmission = 1, .thickness = 0.04}),
      {1.6, 0, -1.3});
  add(lathe(bowl(size), 2 * size), textured({.roughness = 0.55}, ringTexture), {-1.35, 0, 0.95});
  addBalls(document, size);
  document.addCamera({0.6, 2.3, 7}, {0.25, 0.85, 0}, 31, 1.5);
  out.text(document.text());
}

}  // namespace candela::generate
