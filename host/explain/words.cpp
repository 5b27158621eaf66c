// Names for primitives, materials, lights, lobes and shadow rays.
#include "host/explain/words.h"

#include <fmt/format.h>

#include "host/flatten/lobes.h"

namespace candela::explain {
namespace {

const char* kindWord(scene::PrimitiveKind kind) {
  switch (kind) {
    case scene::PrimitiveKind::sphere:
      return "sphere";
    case scene::PrimitiveKind::triangle:
      return "triangle";
    case scene::PrimitiveKind::box:
      return "box";
    case scene::PrimitiveKind::cone:
      return "cone";
    case scene::PrimitiveKind::plane:
      break;
  }
  return "plane";
}

const char* materialWord(const scene::Material& material) {
  const flatten::Lobes lobes = flatten::lobesOf(material);
  if (lobes.mirror) return "mirror";
  const int count = (lobes.diffuse > 0) + (lobes.glossy > 0) + (lobes.dielectric > 0);
  if (count == 0) return "black";
  if (count > 1) return "mixture";
  return lobes.diffuse > 0 ? "diffuse" : lobes.glossy > 0 ? "glossy" : "dielectric";
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
  return primitive == render::LightTrace::kPointLight ? "a point light"
                                                      : "primitive " + primitiveWords(primitive, scene);
}

std::string lobeWords(render::Lobe lobe) {
  switch (lobe) {
    case render::Lobe::none:
      break;
    case render::Lobe::diffuse:
      return "diffuse";
    case render::Lobe::glossy:
      return "glossy";
    case render::Lobe::mirror:
      return "mirror";
    case render::Lobe::reflect:
      return "reflect";
    case render::Lobe::refract:
      return "refract";
  }
  return "none";
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
