// Computes the specialisation constants of a kernel.
#include "host/trace/device/specialise.h"

#include <bit>

#include "lists/features.h"
#include "shaders/shared/specialization.h"

namespace candela::device {
namespace {

std::uint32_t lensOf(const flatten::SceneShape& shape, const render::RenderSettings& settings) {
  if (!shape.hasLens) return gpu::kLensNone;
  return settings.image.lens == render::LensKind::disc ? gpu::kLensDisc : gpu::kLensSquare;
}

std::uint32_t filterOf(const render::RenderSettings& settings) {
  if (!settings.image.jittersPixels()) return gpu::kFilterNone;
  switch (settings.image.filter.kind) {
    case render::FilterKind::box:
      break;
    case render::FilterKind::tent:
      return gpu::kFilterTent;
    case render::FilterKind::gaussian:
      return gpu::kFilterGaussian;
  }
  return gpu::kFilterBox;
}

std::uint32_t samplerOf(render::SamplerKind kind) {
  switch (kind) {
    case render::SamplerKind::independent:
      return gpu::kSamplerIndependent;
    case render::SamplerKind::stratified:
      return gpu::kSamplerStratified;
    case render::SamplerKind::sobol:
      break;
  }
  return gpu::kSamplerSobol;
}

std::uint32_t backdropOf(render::Backdrop backdrop) {
  switch (backdrop) {
    case render::Backdrop::environment:
      break;
    case render::Backdrop::colour:
      return gpu::kBackdropColour;
    case render::Backdrop::none:
      return gpu::kBackdropNone;
  }
  return gpu::kBackdropEnvironment;
}

std::uint32_t viewOf(render::Integrator integrator) {
  switch (integrator) {
    case render::Integrator::path:
    case render::Integrator::whitted:
      break;
    case render::Integrator::ao:
      return gpu::kViewAo;
    case render::Integrator::normal:
      return gpu::kViewNormal;
    case render::Integrator::albedo:
      return gpu::kViewAlbedo;
    case render::Integrator::depth:
      return gpu::kViewDepth;
    case render::Integrator::id:
      return gpu::kViewId;
    case render::Integrator::cost:
      return gpu::kViewCost;
  }
  return gpu::kViewNone;
}

}  // namespace

std::vector<vulkan::Specialisation> specialise(const CodeForm& form, const flatten::SceneShape& shape,
                                               const render::RenderSettings& settings, bool texels) {
  std::vector<vulkan::Specialisation> constants{
      {gpu::kSpecWorkgroupX, settings.execution.workgroupInUse().width},
      {gpu::kSpecWorkgroupY, settings.execution.workgroupInUse().height},
      {gpu::kSpecOneSided, settings.image.oneSided},
      {gpu::kSpecLimitsIndirect, settings.image.indirectLimit.has_value()},
      {gpu::kSpecLayerSums, image::layerSumsOf(settings.image.layers)},
      {gpu::kSpecFilmScale, settings.image.filmScale},
      {gpu::kSpecListsHits, hasMattes(settings.image.layers)},
      {gpu::kSpecThroughSpecular, settings.image.layersThroughSpecular},
      {gpu::kSpecTextureSlots, shape.textureSlots},
      {gpu::kSpecCoincident, shape.coincident},
      {gpu::kSpecOrderReach, std::bit_cast<std::uint32_t>(shape.orderReach)},
      {gpu::kSpecBackdrop, backdropOf(settings.image.backdrop)},
      {gpu::kSpecLens, lensOf(shape, settings)},
      {gpu::kSpecFilter, filterOf(settings)},
      {gpu::kSpecFilterDeviation, std::bit_cast<std::uint32_t>(settings.image.filter.deviation)},
      {gpu::kSpecSampler, samplerOf(settings.image.sampler)},
      {gpu::kSpecStructure, shape.structure},
      {gpu::kSpecTexels, texels},
      {gpu::kSpecRecord, settings.execution.recordPaths},
      {gpu::kSpecStackSize, shape.stackSize},
      {gpu::kSpecUniformSlots, shape.uniformSlots},
      {gpu::kSpecFirstMarkedSlot, shape.firstMarkedSlot},
      {gpu::kSpecRowsAhead, shape.rowsAhead},
      {gpu::kSpecAreaLights, settings.image.lightSize > 0},
      {gpu::kSpecView, viewOf(settings.image.integrator)},
      {gpu::kSpecMasksLanes, form.masksLanes},
      {gpu::kSpecLimitsLoops, form.limitsLoops}};
  const flatten::SceneFeatures& has = shape.features;
#define CANDELA_SPECIALISE(member, name, id) constants.push_back({id, has.member});
  CANDELA_FEATURES(CANDELA_SPECIALISE)
#undef CANDELA_SPECIALISE
  for (std::uint32_t word = 0; word < gpu::kUniformKindWords; ++word) {
    constants.push_back({gpu::kSpecUniformKinds + word, shape.uniformKinds[word]});
  }
  return constants;
}

vulkan::PipelineOptions kernelOptions(const CodeForm& form, const flatten::SceneShape& shape,
                                      const render::RenderSettings& settings, bool texels,
                                      std::uint32_t pushConstantBytes) {
  using enum vulkan::BindingKind;
  return {.bindings = {storageBuffer, storageBuffer, storageBuffer, storageBuffer, uniformTexelBuffer, uniformBuffer},
          .pushConstantBytes = pushConstantBytes,
          .specialisations = specialise(form, shape, settings, texels)};
}

}  // namespace candela::device
