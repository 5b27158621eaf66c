// Stores the parameters of surfaces, and the energy tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "host/core/errors.h"
#include "host/energy/anisotropic_tables.h"
#include "host/energy/energy_tables.h"
#include "host/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

static_assert(gpu::kEnergyCells == energy::kNodes - 1);
static_assert(gpu::kGlassCosineCells == energy::kGlassCosines - 1);
static_assert(gpu::kGlassRoughnessCells == energy::kGlassRoughnesses - 1);
static_assert(gpu::kGlassIorCells == energy::kGlassIors - 1);
static_assert(gpu::kSheenCosineCells == energy::kSheenCosines - 1);
static_assert(gpu::kSheenRoughnessCells == energy::kSheenRoughnesses - 1);
static_assert(gpu::kAnisotropicCosineCells == energy::kAnisotropicCosines - 1);
static_assert(gpu::kAnisotropicAzimuthCells == energy::kAnisotropicAzimuths - 1);
static_assert(gpu::kAnisotropicRoughnessCells == energy::kAnisotropicRoughnesses - 1);
static_assert(gpu::kAnisotropicStrengthCells == energy::kAnisotropicStrengths - 1);
static_assert(gpu::kAnisotropicGlassCosineCells == energy::kAnisotropicGlassCosines - 1);
static_assert(gpu::kAnisotropicGlassAzimuthCells == energy::kAnisotropicGlassAzimuths - 1);
static_assert(gpu::kAnisotropicGlassRoughnessCells == energy::kAnisotropicGlassRoughnesses - 1);
static_assert(gpu::kAnisotropicGlassStrengthCells == energy::kAnisotropicGlassStrengths - 1);
static_assert(gpu::kAnisotropicGlassIorCells == energy::kAnisotropicGlassIors - 1);

// Appends a record for every cell of a plane of `width` by `height` nodes.
void appendCells(const float* nodes, std::size_t width, std::size_t height, Rows& rows) {
  for (std::size_t j = 0; j + 1 < height; ++j) {
    for (const float* at = nodes + j * width; at + 1 < nodes + (j + 1) * width; ++at) {
      rows.push_back({floatBits(at[0]), floatBits(at[1]), floatBits(at[width]), floatBits(at[width + 1])});
    }
  }
}

void appendGlass(const energy::GlassTable& table, Rows& rows) {
  constexpr std::size_t kLayer = energy::kGlassCosines * energy::kGlassRoughnesses;
  for (std::size_t k = 0; k < energy::kGlassIors; ++k) {
    appendCells(table.data() + k * kLayer, energy::kGlassCosines, energy::kGlassRoughnesses, rows);
  }
}

// Appends the planes of a table of anisotropic microfacets, each of `cosines` by `azimuths` nodes.
void appendAnisotropic(std::span<const float> table, std::size_t cosines, std::size_t azimuths, Rows& rows) {
  for (std::size_t first = 0; first < table.size(); first += cosines * azimuths) {
    appendCells(table.data() + first, cosines, azimuths, rows);
  }
}

void appendAnisotropic(bool withGlass, Rows& rows) {
  appendAnisotropic(energy::kAnisotropicWhite, energy::kAnisotropicCosines, energy::kAnisotropicAzimuths, rows);
  appendAnisotropic(energy::kAnisotropicTilt, energy::kAnisotropicCosines, energy::kAnisotropicAzimuths, rows);
  if (!withGlass) return;
  appendAnisotropic(energy::kAnisotropicGlassOutside, energy::kAnisotropicGlassCosines,
                    energy::kAnisotropicGlassAzimuths, rows);
  appendAnisotropic(energy::kAnisotropicGlassInside, energy::kAnisotropicGlassCosines,
                    energy::kAnisotropicGlassAzimuths, rows);
}

void appendSurface(const scene::SurfaceParameters& s, std::uint32_t volume, Rows& rows) {
  rows.push_back(row(glm::dvec3(s.baseColour), double{s.metalness}));
  rows.push_back(row(glm::dvec3(s.specularColour), double{s.specularWeight}));
  rows.push_back(row(glm::dvec3(s.roughness, s.ior, s.transmissionWeight), double{s.coatRoughness}));
  rows.push_back(row(glm::dvec3(s.absorption), double{s.coatWeight}));
  const double rotation = s.anisotropyRotation;
  rows.push_back(
      {volume, floatBits(double{s.anisotropy}), floatBits(std::cos(rotation)), floatBits(std::sin(rotation))});
  rows.push_back(row(glm::dvec3(s.sheenColour), double{s.sheenRoughness}));
  rows.push_back(row(glm::dvec3(s.filmWeight, s.filmIor, s.filmThickness), double{s.filmThicknessMinimum}));
  const scene::Conductor conductor = s.conductor.value_or(scene::Conductor{});
  rows.push_back(row(glm::dvec3(conductor.ior), s.conductor ? 1.0 : 0.0));
  rows.push_back(row(glm::dvec3(conductor.extinction), s.disperses() ? double{s.transmissionDispersionScale} : 0.0));
}

}  // namespace

SurfaceOrder orderSurfaces(const scene::Scene& scene) {
  SurfaceOrder order;
  order.numbers.assign(scene.materials.size(), 0);
  const auto append = [&](bool hasVolume) {
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
      const auto& surface = scene.materials[i].surface;
      if (!surface || surface->hasVolume() != hasVolume) continue;
      order.materials.push_back(i);
      order.numbers[i] = static_cast<std::uint32_t>(order.materials.size());
    }
  };
  append(true);
  order.volumeCount = static_cast<std::uint32_t>(order.materials.size());
  append(false);
  if (order.volumeCount > gpu::kMaxVolumeCount) {
    throw FileError(fmt::format("{}: {} materials bound volumes; at most {} are supported", scene.name,
                                order.volumeCount, gpu::kMaxVolumeCount));
  }
  return order;
}

Rows surfaceRows(const scene::Scene& scene, const SurfaceOrder& order) {
  Rows rows;
  for (std::uint32_t i = 0; i < order.materials.size(); ++i) {
    appendSurface(*scene.materials[order.materials[i]].surface, i < order.volumeCount ? i + 1 : 0, rows);
  }
  return rows;
}

Rows energyRows(const SceneFeatures& features) {
  Rows white, tilt, rows;
  appendCells(energy::kWhite.data(), energy::kNodes, energy::kNodes, white);
  appendCells(energy::kTilt.data(), energy::kNodes, energy::kNodes, tilt);
  for (std::size_t cell = 0; cell < white.size(); ++cell) rows.insert(rows.end(), {white[cell], tilt[cell]});
  if (features.volumes) {
    appendGlass(energy::kGlassOutside, rows);
    appendGlass(energy::kGlassInside, rows);
  }
  if (features.sheens) appendCells(energy::kSheen.data(), energy::kSheenCosines, energy::kSheenRoughnesses, rows);
  if (features.anisotropy) appendAnisotropic(features.volumes, rows);
  return rows;
}

}  // namespace candela::flatten
