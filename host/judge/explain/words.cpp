// Names for primitives, materials, lights, lobes and shadow rays.
#include "host/judge/explain/words.h"

#include <fmt/format.h>

namespace candela::explain {
namespace {

const char* kindWord(scene::PrimitiveKind kind) {
  switch (kind) {
#define CANDELA_NAME_KIND(kind, feature, name, value, flag) \
  case scene::PrimitiveKind::kind:                          \
    return #kind;
    CANDELA_PRIMITIVE_KINDS(CANDELA_NAME_KIND)
#undef CANDELA_NAME_KIND
  }
  return "";
}

const char* materialWord(const scene::Material& material) {
  switch (scene::kindOf(material)) {
    case scene::MaterialKind::black:
      return "black";
    case scene::MaterialKind::diffuse:
      return "diffuse";
    case scene::MaterialKind::glossy:
      return "glossy";
    case scene::MaterialKind::dielectric:
      return "dielectric";
    case scene::MaterialKind::mirror:
      return "mirror";
    case scene::MaterialKind::surface:
      return "surface";
    case scene::MaterialKind::mixture:
      break;
  }
  return "mixture";
}

}  // namespace

std::string primitiveWords(std::uint32_t primitive, const scene::Scene& scene) {
  if (primitive >= scene.primitives.size()) return fmt::to_string(primitive);
  return fmt::format("{} {}", primitive, kindWord(scene.primitives[primitive].kind));
}

std::string materialWords(std::uint32_t material, const scene::Scene& scene) {
  if (material >= scene.materials.size()) return fmt::to_string(material);
  return fmt::format("{} {}", material, materialWord(scene.materials[material]));
}

std::string lightWords(std::uint32_t primitive, const scene::Scene& scene) {
  return primitive == render::LightTrace::kPointLight ? "a light that is not a primitive"
                                                      : "primitive " + primitiveWords(primitive, scene);
}

std::string lobeWords(render::Lobe lobe) {
  switch (lobe) {
#define CANDELA_NAME_LOBE(lobe, name, value) \
  case render::Lobe::lobe:                   \
    return #lobe;
    CANDELA_LOBES(CANDELA_NAME_LOBE)
#undef CANDELA_NAME_LOBE
  }
  return "";
}

std::string shadowWords(render::ShadowOutcome outcome) {
  switch (outcome) {
    case render::ShadowOutcome::notTraced:
      break;
    case render::ShadowOutcome::visible:
      return "visible";
    case render::ShadowOutcome::occluded:
      return "occluded";
  }
  return "not traced";
}

}  // namespace candela::explain
