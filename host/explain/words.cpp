#include "host/explain/words.h"

#include <fmt/format.h>

#include "host/render/lobes.h"

namespace candela::explain {
namespace {

const char* kindWord(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::sphere:
      return "sphere";
    case PrimitiveKind::triangle:
      return "triangle";
    case PrimitiveKind::box:
      return "box";
    case PrimitiveKind::cone:
      return "cone";
    case PrimitiveKind::plane:
      break;
  }
  return "plane";
}

const char* materialWord(const Material& material) {
  const Lobes lobes = lobesOf(material);
  if (lobes.mirror) return "mirror";
  const int count = (lobes.diffuse > 0) + (lobes.glossy > 0) + (lobes.dielectric > 0);
  if (count == 0) return "black";
  if (count > 1) return "mixture";
  return lobes.diffuse > 0 ? "diffuse" : lobes.glossy > 0 ? "glossy" : "dielectric";
}

}  // namespace

std::string primitiveWords(std::uint32_t primitive, const Scene& scene) {
  if (primitive >= scene.primitives.size()) return fmt::to_string(primitive);
  return fmt::format("{} {}", primitive, kindWord(scene.primitives[primitive].kind));
}

std::string materialWords(std::uint32_t material, const Scene& scene) {
  if (material >= scene.materials.size()) return fmt::to_string(material);
  return fmt::format("{} {}", material, materialWord(scene.materials[material]));
}

std::string lightWords(std::uint32_t primitive, const Scene& scene) {
  return primitive == LightTrace::kPointLight ? "a point light" : "primitive " + primitiveWords(primitive, scene);
}

std::string lobeWords(Lobe lobe) {
  switch (lobe) {
    case Lobe::none:
      break;
    case Lobe::diffuse:
      return "diffuse";
    case Lobe::glossy:
      return "glossy";
    case Lobe::mirror:
      return "mirror";
    case Lobe::reflect:
      return "reflect";
    case Lobe::refract:
      return "refract";
  }
  return "none";
}

std::string shadowWords(ShadowOutcome outcome) {
  switch (outcome) {
    case ShadowOutcome::notTraced:
      break;
    case ShadowOutcome::visible:
      return "visible";
    case ShadowOutcome::occluded:
      return "occluded";
  }
  return "not traced";
}

}  // namespace candela::explain
