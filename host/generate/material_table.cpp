// Tables of balls: one of all mixtures, and one that absorbs nothing.
#include "host/generate/gltf_material.h"
#include "host/generate/gltf_scenes.h"
#include "host/generate/lathe.h"

namespace candela::generate {
namespace {

constexpr double kRoughnesses[] = {0, 0.2, 0.4, 0.6, 0.8, 1};
constexpr int kColumns = 6;
constexpr double kRadius = 0.45;

// The parameters that the balls of a row share.
struct BallRow {
  double metalness;
  double transmission;
  double clearcoat;
  glm::dvec3 colour;
};
constexpr BallRow kTable[] = {{1, 0, 0, {1, 0.77, 0.34}},
                              {0.5, 0, 0, {0.9, 0.45, 0.3}},
                              {0, 0, 0, {0.75, 0.1, 0.1}},
                              {0, 0.5, 0, {0.3, 0.6, 0.9}},
                              {0, 1, 0, {0.85, 0.95, 0.9}}};
constexpr BallRow kFurnace[] = {{1, 0, 0, glm::dvec3(1)},
                                {0, 0, 0, glm::dvec3(1)},
                                {0, 1, 0, glm::dvec3(1)},
                                {0.5, 0.5, 0, glm::dvec3(1)},
                                {1, 0, 1, glm::dvec3(1)}};

void writeRows(std::span<const BallRow> rows, NffWriter& out, std::uint32_t size) {
  GltfDocument document;
  const std::size_t ball = document.addShape(lathe(sphereProfile(kRadius, size), 2 * size));
  const double middle = (kColumns - 1) / 2.0, top = (static_cast<double>(rows.size()) - 1) / 2;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const MaterialFactors factors{.colour = rows[row].colour,
                                    .metalness = rows[row].metalness,
                                    .roughness = kRoughnesses[column],
                                    .transmission = rows[row].transmission,
                                    .thickness = rows[row].transmission > 0 ? 2 * kRadius : 0,
                                    .clearcoat = rows[row].clearcoat,
                                    .clearcoatRoughness = kRoughnesses[column]};
      document.addNode(ball, document.addMaterial(gltfMaterial(factors)),
                       {column - middle, top - static_cast<double>(row), 0});
    }
  }
  document.addCamera({0, 0, 14}, {0, 0, 0}, 22, 6.4 / 5.4);
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
