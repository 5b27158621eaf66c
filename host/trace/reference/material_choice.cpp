// Chooses materials by side and by weight.
#include "host/trace/reference/material_choice.h"

#include "host/trace/reference/texture.h"

namespace candela::reference {
namespace {

double weightAt(const TextureReader& textures, const Surface& surface, double factor) {
  const scene::Primitive& primitive = textures.scene.primitives[surface.primitive];
  if (primitive.kind == scene::PrimitiveKind::triangle && !meshOf(textures.scene, primitive).colours.empty()) {
    factor *= surface.attributes.colour.w;
  }
  const auto texel = textures.at(surface, scene::TextureSlot::baseColour);
  return texel ? factor * alphaOf(*texel) : factor;
}

}  // namespace

void chooseMaterial(const TextureReader& textures, VertexNumbers u, Surface& surface) {
  const auto& [scene, arithmetic] = textures;
  while (const std::optional<scene::MaterialChoice>& choice = scene.materials[surface.material].choice) {
    bool takesSecond = !surface.fromOutside;
    if (choice->weight) {
      takesSecond = arithmetic.choice(u.material()) < weightAt(textures, surface, double{*choice->weight});
      arithmetic.decide(takesSecond);
    }
    surface.material = takesSecond ? choice->second : choice->first;
  }
}

}  // namespace candela::reference
