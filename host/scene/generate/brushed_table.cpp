// A table of balls whose highlights are longer in one direction.
#include <cmath>
#include <numbers>

#include "host/scene/generate/gltf_material.h"
#include "host/scene/generate/gltf_scenes.h"
#include "host/scene/generate/lathe.h"

namespace candela::generate {
namespace {

constexpr double kBrushedRoughnesses[] = {0.05, 0.2, 0.35, 0.5, 0.65, 0.8};
constexpr int kBrushedColumns = 6;
constexpr double kBrushedRadius = 0.45, kBrushedDistance = 14;
constexpr std::uint32_t kTurnSide = 64;
constexpr glm::dvec3 kSteel{0.77, 0.78, 0.78}, kCopper{0.95, 0.64, 0.54};

// The parameters of the balls of a row. In the last row, a texture rotates the direction.
const MaterialFactors kBrushedRows[] = {
    {.colour = kSteel, .metalness = 1, .anisotropy = 0.5},
    {.colour = kSteel, .metalness = 1, .anisotropy = 1},
    {.colour = kCopper, .metalness = 1, .anisotropy = 0.8, .anisotropyRotation = std::numbers::pi / 2},
    {.colour = {0.1, 0.2, 0.5}, .clearcoat = 0.5, .anisotropy = 0.8},
    {.transmission = 1, .thickness = 2 * kBrushedRadius, .anisotropy = 0.6},
    {.colour = kCopper, .metalness = 1, .anisotropy = 0.9}};
constexpr std::size_t kTurningRow = std::size(kBrushedRows) - 1;

// Returns directions that turn once around every quarter of the balls' equator, of full strength.
std::vector<std::byte> turningDirections() {
  std::vector<std::byte> rgb;
  for (std::uint32_t i = 0; i < kTurnSide * kTurnSide; ++i) {
    const double angle = 8 * std::numbers::pi * (i % kTurnSide + 0.5) / kTurnSide;
    for (const double channel : {std::cos(angle), std::sin(angle), 1.0}) {
      rgb.push_back(static_cast<std::byte>(std::lround(127.5 * (1 + channel))));
    }
  }
  return rgb;
}

std::vector<glm::dvec2> brushedBall(std::uint32_t size) { return sphereProfile(kBrushedRadius, size); }

}  // namespace

std::uint64_t brushedTablePrimitives(std::uint32_t size) {
  return std::size(kBrushedRows) * kBrushedColumns * latheTriangles(brushedBall(size), 2 * size);
}

void writeBrushedTable(NffWriter& out, std::uint32_t size) {
  GltfDocument document;
  const std::size_t ball = document.addShape(lathe(brushedBall(size), 2 * size));
  const std::size_t directions = document.addTexture(kTurnSide, kTurnSide, turningDirections());
  const double middle = (kBrushedColumns - 1) / 2.0, top = (std::size(kBrushedRows) - 1) / 2.0;
  for (std::size_t row = 0; row < std::size(kBrushedRows); ++row) {
    for (int column = 0; column < kBrushedColumns; ++column) {
      MaterialFactors factors = kBrushedRows[row];
      factors.roughness = kBrushedRoughnesses[column];
      GltfDocument::Json material = gltfMaterial(factors);
      if (row == kTurningRow) {
        material["extensions"]["KHR_materials_anisotropy"]["anisotropyTexture"] = {{"index", directions}};
      }
      document.addNode(ball, document.addMaterial(material), {column - middle, top - static_cast<double>(row), 0});
    }
  }
  const double height = std::size(kBrushedRows) + 0.4;
  document.addCamera({0, 0, kBrushedDistance}, {0, 0, 0},
                     360 / std::numbers::pi * std::atan(height / 2 / kBrushedDistance),
                     (kBrushedColumns + 0.4) / height);
  out.text(document.text());
}

}  // namespace candela::generate
