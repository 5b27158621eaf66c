// Chooses the layer and the facet of normal maps, and samples directions.
#include "host/trace/reference/shading.h"

#include <cmath>

#include "host/trace/reference/facet_scattering.h"

namespace candela::reference {

void mapLayer(const TextureReader& textures, const dvec3& rayDirection, VertexNumbers u, Surface& surface,
              SurfaceMaterial& material) {
  const auto& [scene, arithmetic] = textures;
  if (!hasNormalMap(scene.materials[surface.material])) return;
  if (!hasTangents(scene, scene.primitives[surface.primitive])) return;
  if (material.surface && material.surface->coatWeight > 0) {
    Surface coat = surface;
    applyNormalMap(textures, scene::TextureSlot::coatNormal, rayDirection, coat);
    coat.facetNumber = u.coatFacet();
    const double cosine = ShadingFrame(coat, rayDirection, arithmetic).wo.z;
    material.isCoatAlone = arithmetic.choice(u.layer()) < coatReflectance(material.surface->coatWeight, cosine);
    arithmetic.decide(material.isCoatAlone);
    if (material.isCoatAlone) {
      surface = coat;
      return;
    }
    material.surface->coatWeight = 0;
  }
  applyNormalMap(textures, scene::TextureSlot::normal, rayDirection, surface);
  surface.facetNumber = u.facet();
  if (scene.materials[surface.material].hasFacets) return;
  const bool isAway = dot(surface.shadingNormal, rayDirection) >= 0;
  arithmetic.decide(isAway);
  if (isAway) material.makeBlack();
}

ShadingFrame::ShadingFrame(const Surface& surface, const dvec3& rayDirection, Arithmetic& arithmetic)
    : frame(surface.shadingNormal, surface.anisotropyDirection),
      wo(arithmetic.direction(frame.toLocal(-rayDirection))) {
  if (!surface.isMapped) return;
  facets.emplace(arithmetic.direction(frame.toLocal(surface.facingNormal)));
  const bool isDirect = arithmetic.choice(surface.facetNumber) < facets->directProbability(wo);
  arithmetic.decide(isDirect);
  if (!isDirect) wo = facets->seenByReflection(wo);
}

Side ShadingFrame::sideOf(const dvec3& wi) const {
  if (!facets) return reference::sideOf(wi);
  return facets->isOn(Side::reflection, wi) ? Side::reflection : Side::transmission;
}

Shading::Shading(const Surface& at, SurfaceMaterial& material, const dvec3& rayDirection,
                 const std::optional<ChannelChoice>& choice, Arithmetic& arithmetic)
    : ShadingFrame(at, rayDirection, arithmetic), surface_(at), bsdf_(material.bsdf), arithmetic_(arithmetic) {
  if (!material.surface) return;
  material.bsdf.setSurface(*material.surface, wo, at.fromOutside, material.isCoatAlone, choice);
}

LightReceiver Shading::receiver() const {
  return {surface_.position, StoredDirection(facets ? surface_.facingNormal : surface_.shadingNormal),
          bsdf_.scattersTo(Side::transmission)};
}

double Shading::bumpShadowing(const dvec3& wi) const {
  if (surface_.unmappedNormal == dvec3(0)) return 1;
  return reference::bumpShadowing({0, 0, 1}, frame.toLocal(surface_.unmappedNormal), wi);
}

BsdfValue Shading::valueOf(const dvec3& wi, Side side) const {
  BsdfValue value = scatteredValue(bsdf_, facets, wo, wi, side);
  value.f *= bumpShadowing(wi);
  return arithmetic_.bsdfValue(value, bsdf_);
}

bool Shading::isOn(Side side, const dvec3& wi) const {
  const double cosine = dot(wi, surface_.facingNormal);
  return side == Side::reflection ? cosine > 0 : cosine < 0;
}

Ray Shading::rayTowards(const dvec3& wi, Side side) const {
  return {surface_.position, wi, surface_.primitive, surface_.outwardNormal, 0, side == Side::transmission,
          surface_.contact};
}

Scattering Shading::sample(VertexNumbers u) const {
  if (bsdf_.isBlack()) return {};
  if (bsdf_.interface() != nullptr && bsdf_.interface()->isSmooth()) return sampleInterface(u);
  if (bsdf_.surface() != nullptr || bsdf_.interface() != nullptr) return sampleSurface(u);
  const render::Lobe lobe = bsdf_.isMirror() ? render::Lobe::mirror : bsdf_.chooseLobe(arithmetic_.choice(u.lobe()));
  const bool isSmooth = lobe == render::Lobe::diffuse || lobe == render::Lobe::glossy;
  return isSmooth ? sampleSmooth(lobe, u) : sampleDelta(lobe, u);
}

Scattering Shading::sampleDelta(render::Lobe lobe, VertexNumbers u) const {
  const DeltaSample sample = lobe == render::Lobe::mirror
                                 ? bsdf_.sampleMirror(wo)
                                 : bsdf_.sampleDielectric(wo, surface_.fromOutside, arithmetic_.choice(u.bsdf().x));
  Scattering next{sample.lobe, toWorld(sample.wi), bumpShadowing(sample.wi) * sample.weight, std::nullopt};
  if (!isOn(next.side(), next.wi)) next.weight = dvec3(0);
  return next;
}

Scattering Shading::sampleInterface(VertexNumbers u) const {
  const DeltaSample sample = bsdf_.interface()->sampleSmooth(arithmetic_.choice(u.lobe()));
  const dvec3 local = leavingDirection(facets, {sample.lobe, sample.wi, 0});
  Scattering next{sample.lobe, toWorld(local), bumpShadowing(local) * sample.weight, std::nullopt};
  if (!isOn(next.side(), next.wi)) next.weight = dvec3(0);
  return next;
}

Scattering Shading::sampleSmooth(render::Lobe lobe, VertexNumbers u) const {
  const dvec3 local = arithmetic_.sampledDirection(bsdf_.sampleSmooth(lobe, wo, u.bsdf()));
  const dvec3 wi = toWorld(local);
  const BsdfValue value = valueOf(local, reference::sideOf(local));
  if (value.pdf == 0 || !isOn(reference::sideOf(local), wi)) return {.lobe = lobe, .pdf = 0.0};
  return {lobe, wi, value.f / value.pdf, value.pdf};
}

Scattering Shading::sampleSurface(VertexNumbers u) const {
  const double choice = arithmetic_.lobeChoice(u.lobe());
  SurfaceSample sample = bsdf_.interface() != nullptr ? bsdf_.interface()->sample(choice, u.bsdf())
                                                      : bsdf_.surface()->sample(choice, u.bsdf());
  sample.wi = sample.alpha > 0 ? arithmetic_.microfacetDirection(sample.wi, sample.alpha)
                               : arithmetic_.sampledDirection(sample.wi);
  if (!sample.isOnItsSide()) return {};
  const Side side = reference::sideOf(sample.wi);
  sample.wi = leavingDirection(facets, sample);
  const dvec3 wi = toWorld(sample.wi);
  const BsdfValue value = valueOf(sample.wi, side);
  if (value.pdf == 0) return {};
  if (!isOn(side, wi)) return {.lobe = sample.lobe, .pdf = 0.0};
  return {sample.lobe, wi, value.f / value.pdf, value.pdf};
}

}  // namespace candela::reference
