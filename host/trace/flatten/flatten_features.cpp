// Determines the features that a scene uses.
#include <algorithm>
#include <span>
#include <vector>

#include "host/trace/flatten/flat_scene.h"
#include "host/trace/flatten/flatten_sections.h"
#include "host/trace/flatten/geometries.h"
#include "host/trace/flatten/lobes.h"

namespace candela::flatten {
namespace {

void noteKind(scene::PrimitiveKind kind, SceneFeatures& features) {
  switch (kind) {
#define CANDELA_NOTE_KIND(kind, feature, name, value, flag) \
  case scene::PrimitiveKind::kind:                          \
    features.feature = true;                                \
    break;
    CANDELA_PRIMITIVE_KINDS(CANDELA_NOTE_KIND)
#undef CANDELA_NOTE_KIND
  }
}

void noteRun(const scene::Scene& scene, const scene::PrimitiveRun& run, SceneFeatures& features) {
  const scene::Primitive& primitive = run.start;
  noteKind(primitive.kind, features);
  if (primitive.kind == scene::PrimitiveKind::sphere) {
    const std::span spheres = std::span(scene.spheres).subspan(primitive.index, scene.primitives.countOf(run));
    features.insideOnly |= std::ranges::any_of(spheres, [](const scene::Sphere& s) { return s.radius < 0; });
  }
  if (primitive.kind == scene::PrimitiveKind::triangle) {
    features.smooth |= isSmooth(scene, primitive);
    features.secondTexCoords |= hasSecondTexCoords(scene, primitive);
    features.longCorners |= needsLongCorners(meshOf(scene, primitive));
    features.colours |= !meshOf(scene, primitive).colours.empty();
    features.tangents |= hasTangents(scene, primitive);
    const auto isInterpolated = [](const scene::Material& material) {
      return hasNormalMap(material) && (material.hasHeights || !material.hasFacets);
    };
    features.normalMaps |= hasTangents(scene, primitive) && anyMaterial(scene, primitive.material, scene::hasNormalMap);
    features.filteredNormals |= hasTangents(scene, primitive) && anyMaterial(scene, primitive.material, isInterpolated);
  }
}

void noteSurface(const scene::SurfaceParameters& surface, SceneFeatures& features) {
  features.surfaces = true;
  features.transmission |= surface.transmissionWeight > 0;
  features.volumes |= surface.hasVolume();
  features.coats |= surface.coatWeight > 0;
  features.films |= surface.filmWeight > 0 && std::max(surface.filmThickness, surface.filmThicknessMinimum) > 0;
  features.dispersion |= surface.disperses();
  features.conductors |= surface.conductor && surface.metalness > 0;
  features.anisotropy |= surface.anisotropy > 0;
  features.plastics |= surface.plastic.has_value();
  features.interfaces |= surface.bareInterface.has_value();
  features.sheens |= surface.sheenColour != glm::vec3(0);
}

void noteTexture(const std::optional<scene::TextureReference>& texture, SceneFeatures& features) {
  const scene::TextureReference identity;
  if (texture) features.textureTransforms |= texture->rowS != identity.rowS || texture->rowT != identity.rowT;
}

void noteMaterial(const scene::Material& material, render::Integrator integrator, SceneFeatures& features) {
  const Lobes lobes = lobesFor(integrator, material);
  features.diffuse |= lobes.diffuse > 0;
  features.glossy |= lobes.glossy > 0;
  features.dielectric |= lobes.dielectric > 0;
  features.mirror |= lobes.mirror;
  if (material.surface) noteSurface(*material.surface, features);
  features.mixtures |= material.surface.has_value() ||
                       (lobes.diffuse > 0) + (lobes.glossy > 0) + (lobes.dielectric > 0) > 1;
  features.emission |= ownRadiance(integrator, material) != glm::dvec3(0);
  features.choices |= material.choice.has_value();
  features.transparency |= material.opacity.has_value();
  for (const auto& texture : material.textures) noteTexture(texture, features);
  if (material.opacity) noteTexture(material.opacity->texture, features);
  features.textures |= isTextured(material) || material.opacity.has_value();
}

// Notes a material, and those between which it is a choice.
void noteMaterials(const scene::Scene& scene, std::uint32_t index, render::Integrator integrator,
                   SceneFeatures& features) {
  const scene::Material& material = scene.materials[index];
  noteMaterial(material, integrator, features);
  if (!material.choice) return;
  noteMaterials(scene, material.choice->first, integrator, features);
  noteMaterials(scene, material.choice->second, integrator, features);
}

}  // namespace

SceneFeatures featuresOf(const scene::Scene& scene, render::Integrator integrator) {
  SceneFeatures features;
  std::vector<bool> used(scene.materials.size());
  for (const scene::PrimitiveRun& run : scene.primitives.runs()) {
    noteRun(scene, run, features);
    if (used[run.start.material]) continue;
    used[run.start.material] = true;
    noteMaterials(scene, run.start.material, integrator, features);
  }
  features.deepTexels = features.textures && hasDeepTexels(scene);
  features.sky = scene.sky.has_value();
  features.environment = scene.environment.has_value();
  features.pointLights = integrator == render::Integrator::whitted && !scene.pointLights.empty();
  return features;
}

void noteLights(std::span<const LightEntry> table, const std::vector<bool>& touched, SceneFeatures& features) {
  for (const LightEntry& entry : table) {
    switch (entry.kind) {
#define CANDELA_NOTE_KIND(kind, feature, name, value) \
  case LightKind::kind:                               \
    features.feature = true;                          \
    break;
      CANDELA_LIGHT_KINDS(CANDELA_NOTE_KIND)
#undef CANDELA_NOTE_KIND
    }
  }
  features.touched = std::ranges::find(touched, true) != touched.end();
}

}  // namespace candela::flatten
