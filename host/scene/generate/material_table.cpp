// Tables of balls: one of all mixtures, and one that absorbs nothing.
#include <cmath>
#include <numbers>
#include <span>

#include "host/scene/generate/gltf_material.h"
#include "host/scene/generate/gltf_scenes.h"
#include "host/scene/generate/lathe.h"

namespace candela::generate {
namespace {

constexpr double kRoughnesses[] = {0, 0.2, 0.4, 0.6, 0.8, 1};
constexpr int kColumns = 6;
constexpr double kRadius = 0.45;
constexpr double kDistance = 14;  // of the camera
constexpr double kMargin = 0.4;   // around all balls

// The parameters of the balls of a row, except for the roughness.
const MaterialFactors kTable[] = {{.colour = {1, 0.77, 0.34}, .metalness = 1},
                                  {.colour = {0.9, 0.45, 0.3}, .metalness = 0.5},
                                  {.colour = {0.75, 0.1, 0.1}},
                                  {.colour = {0.3, 0.6, 0.9}, .transmission = 0.5},
                                  {.colour = {0.85, 0.95, 0.9}, .transmission = 1},
                                  {.colour = {0.05, 0.08, 0.2}, .sheen = {0.8, 0.7, 0.9}},
                                  // gold
                                  {.metalness = 1, .eta = {0.143, 0.375, 1.442}, .kappa = {3.983, 2.386, 1.603}},
                                  {.colour = {0.03, 0.03, 0.03}, .film = 1, .filmThickness = 550}};
const MaterialFactors kFurnace[] = {{.metalness = 1},
                                    {},
                                    {.transmission = 1},
                                    {.metalness = 0.5, .transmission = 0.5},
                                    {.metalness = 1, .clearcoat = 1},
                                    {.sheen = glm::dvec3(1)},
                                    {.metalness = 1, .film = 1, .filmThickness = 400}};

void writeRows(std::span<const MaterialFactors> rows, NffWriter& out, std::uint32_t size) {
  GltfDocument document;
  const std::size_t ball = document.addShape(lathe(sphereProfile(kRadius, size), 2 * size));
  const double middle = (kColumns - 1) / 2.0, top = (static_cast<double>(rows.size()) - 1) / 2;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (int column = 0; column < kColumns; ++column) {
      MaterialFactors factors = rows[row];
      factors.roughness = factors.clearcoatRoughness = factors.sheenRoughness = kRoughnesses[column];
      if (factors.transmission > 0) factors.thickness = 2 * kRadius;
      document.addNode(ball, document.addMaterial(gltfMaterial(factors)),
                       {column - middle, top - static_cast<double>(row), 0});
    }
  }
  const double width = kColumns + kMargin, height = static_cast<double>(rows.size()) + kMargin;
  document.addCamera({0, 0, kDistance}, {0, 0, 0}, 360 / std::numbers::pi * std::atan(height / 2 / kDistance),
                     width / height);
  out.text(document.text());
}

std::uint64_t ballTriangles(std::size_t rows, std::uint32_t size) {
  return rows * kColumns * latheTriangles(sphereProfile(kRadius, size), 2 * size);
}

}  // namespace

std::uint64_t materialTablePrimitives(std::uint32_t size) { return ballTriangles(std::size(kTable), size); }
void writeMaterialTable(NffWriter& out, std::uint32_t size) { writeRows(kTable, out, size); }

std::uint64_t materialFurnacePrimitives(std::uint32_t size) { return ballTriangles(std::size(kFurnace), size); }
void writeMaterialFurnace(NffWriter& out, std::uint32_t size) { writeRows(kFurnace, out, size); }

}  // namespace candela::generate
