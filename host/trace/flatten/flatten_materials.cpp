// Stores the lobes of materials as 16-byte records, followed by the surfaces and the energy tables.
#include "host/trace/flatten/flatten_sections.h"
#include "host/trace/flatten/lobes.h"

namespace candela::flatten {
namespace {

gpu::uvec4 rowOf(const scene::MaterialChoice& choice) {
  return {choice.first, choice.second, floatBits(double{choice.weight.value_or(-1.0f)}), 0};
}

}  // namespace

void appendMaterials(const scene::Scene& scene, render::Integrator integrator, const SurfaceOrder& order,
                     FlatScene& flat) {
  flat.constants.firstMaterialRow = rowCount(flat.rows);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const scene::Material& material = scene.materials[i];
    const Lobes lobes = lobesFor(integrator, material);
    flat.rows.push_back(material.choice ? rowOf(*material.choice) : row(lobes.diffuseColour, lobes.diffuse));
    flat.rows.push_back(row(lobes.glossyColour, lobes.glossy));
    flat.rows.push_back(row(ownRadiance(integrator, material), lobes.dielectric));
    flat.rows.push_back({floatBits(lobes.exponent), floatBits(lobes.ior), floatBits(lobes.mirror ? 1 : 0),
                         material.choice ? gpu::kMaterialIsChoice : order.numbers[i]});
    flat.rows.push_back(row(lobes.specularColour, 0.0));
  }
}

void appendSurfaces(const scene::Scene& scene, const SurfaceOrder& order, FlatScene& flat) {
  const Rows surfaces = surfaceRows(scene, order);
  flat.constants.firstSurfaceRow = rowCount(flat.rows);
  flat.rows.insert(flat.rows.end(), surfaces.begin(), surfaces.end());
  flat.constants.firstEnergyRow = rowCount(flat.rows);
  if (surfaces.empty()) return;
  const Rows energy = energyRows(flat.shape.features);
  flat.rows.insert(flat.rows.end(), energy.begin(), energy.end());
}

}  // namespace candela::flatten
