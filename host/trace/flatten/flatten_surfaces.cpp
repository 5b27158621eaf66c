// Stores the parameters of surfaces, and the energy tables.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "host/base/errors.h"
#include "host/scene/energy/anisotropic_tables.h"
#include "host/scene/energy/energy_tables.h"
#include "host/trace/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

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

void store(const glm::vec3& colour, gpu::vec4& record) { record = {colour, record.w}; }

// Returns the lanes of the records that have parameters as they are, by CANDELA_SURFACE_PARAMETERS.
gpu::SurfaceRecords recordsOf(const scene::SurfaceParameters& s) {
  gpu::SurfaceRecords records{};
#define CANDELA_STORE_COLOUR(name, value, record) store(s.name, records.record);
#define CANDELA_STORE_NUMBER(name, value, record, lane) records.record.lane = s.name;
#define CANDELA_IGNORE_FLAG(name, value)
  CANDELA_SURFACE_PARAMETERS(CANDELA_STORE_COLOUR, CANDELA_STORE_NUMBER, CANDELA_IGNORE_FLAG)
#undef CANDELA_STORE_COLOUR
#undef CANDELA_STORE_NUMBER
#undef CANDELA_IGNORE_FLAG
  return records;
}

// Returns the constant of a shape; `smooth` is that of the smooth one.
float kindOf(scene::Interface shape, std::uint32_t smooth) {
  static_assert(gpu::kPlasticGgx - gpu::kPlasticSmooth == 1 && gpu::kInterfaceGgx - gpu::kInterfaceSmooth == 1);
  static_assert(gpu::kPlasticBeckmann - gpu::kPlasticSmooth == 2 &&
                gpu::kInterfaceBeckmann - gpu::kInterfaceSmooth == 2);
  switch (shape) {
    case scene::Interface::smooth:
      break;
    case scene::Interface::ggx:
      return static_cast<float>(smooth + 1);
    case scene::Interface::beckmann:
      return static_cast<float>(smooth + 2);
  }
  return static_cast<float>(smooth);
}

/// The transmittances of plastic, which follow the surfaces.
struct Transmittances {
  std::uint32_t first;  ///< index of their first record, counted from the first surface's
  Rows rows;
};

// Returns the record of plastic, and appends its transmittances.
gpu::vec4 storePlastic(const scene::Plastic& plastic, Transmittances& transmittances) {
  static_assert(scene::Plastic::kNodes == gpu::kPlasticCells + 1);
  const auto first = static_cast<float>(transmittances.first + rowCount(transmittances.rows));
  if (plastic.boundary != scene::Interface::smooth) {
    const auto& values = plastic.transmittances;
    for (std::size_t i = 0; i + 1 < values.size(); i += gpu::kPlasticCellsPerRow) {
      transmittances.rows.push_back(
          {floatBits(values[i]), floatBits(values[i + 1]), floatBits(values[i + 2]), floatBits(values[i + 3])});
    }
  }
  return {kindOf(plastic.boundary, gpu::kPlasticSmooth), plastic.internalReflectance, plastic.isNonlinear ? 1 : 0,
          first};
}

void appendSurface(const scene::SurfaceParameters& s, std::uint32_t volume, Rows& rows,
                   Transmittances& transmittances) {
  gpu::SurfaceRecords records = recordsOf(s);
  if (!s.disperses()) records.kappa.w = 0;
  const double rotation = s.anisotropyRotation;
  records.direction.x = std::bit_cast<float>(volume);
  records.direction.z = static_cast<float>(std::cos(rotation));
  records.direction.w = static_cast<float>(std::sin(rotation));
  const scene::Conductor conductor = s.conductor.value_or(scene::Conductor{});
  store(conductor.ior, records.eta);
  store(conductor.extinction, records.kappa);
  records.eta.w = s.conductor ? 1 : 0;
  if (s.plastic) records.plastic = storePlastic(*s.plastic, transmittances);
  if (s.bareInterface) {
    const scene::Interface shape = s.isPerfect() ? scene::Interface::smooth : *s.bareInterface;
    records.plastic = {kindOf(shape, gpu::kInterfaceSmooth), 0, 0, 0};
  }
  const std::size_t first = rows.size();
  rows.resize(first + gpu::kSurfaceRows);
#define CANDELA_STORE_RECORD(record, name, index, isLoaded) \
  rows[first + gpu::name] = std::bit_cast<gpu::uvec4>(records.record);
  CANDELA_SURFACE_RECORDS(CANDELA_STORE_RECORD)
#undef CANDELA_STORE_RECORD
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
  Transmittances transmittances{static_cast<std::uint32_t>(order.materials.size()) * gpu::kSurfaceRows, {}};
  for (std::uint32_t i = 0; i < order.materials.size(); ++i) {
    const std::uint32_t volume = i < order.volumeCount ? i + 1 : 0;
    appendSurface(*scene.materials[order.materials[i]].surface, volume, rows, transmittances);
  }
  rows.insert(rows.end(), transmittances.rows.begin(), transmittances.rows.end());
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
