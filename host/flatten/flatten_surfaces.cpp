// Stores the parameters of surfaces, and the energy tables.
#include "host/energy/energy_tables.h"
#include "host/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

constexpr std::size_t kCells = energy::kNodes - 1;
static_assert(gpu::kEnergyCells == kCells);

gpu::uvec4 cellRow(const energy::Table& table, std::size_t i, std::size_t j) {
  const auto at = [&](std::size_t x, std::size_t y) { return floatBits(double{table[y * energy::kNodes + x]}); };
  return {at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)};
}

}  // namespace

Rows surfaceRows(const scene::SurfaceParameters& s) {
  return {
      row(glm::dvec3(s.baseColour), double{s.metalness}), row(glm::dvec3(s.specularColour), double{s.specularWeight}),
      row(glm::dvec3(s.roughness, s.ior, s.transmissionWeight), s.isThinWalled ? 1.0 : 0.0),
      row(glm::dvec3(s.absorption), double{s.coatWeight}), row(glm::dvec3(s.sheenColour), double{s.sheenRoughness})};
}

Rows energyRows() {
  Rows rows;
  for (std::size_t j = 0; j < kCells; ++j) {
    for (std::size_t i = 0; i < kCells; ++i) {
      rows.push_back(cellRow(energy::kWhite, i, j));
      rows.push_back(cellRow(energy::kTilt, i, j));
    }
  }
  return rows;
}

}  // namespace candela::flatten
