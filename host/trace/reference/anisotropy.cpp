// Turns the tangent by the rotation of a material and by its texture.
#include "host/trace/reference/anisotropy.h"

#include <complex>

namespace candela::reference {

void alignAnisotropy(const TextureReader& textures, Surface& surface, SurfaceMaterial& material) {
  if (!material.surface || material.surface->anisotropy == 0) return;
  const MeshAttributes& attributes = surface.attributes;
  if (attributes.tangent == dvec3(0)) {
    material.surface->anisotropy = 0;
    return;
  }
  std::complex<double> direction = std::polar(1.0, double{material.surface->anisotropyRotation});
  if (const auto texel = textures.at(surface, scene::TextureSlot::anisotropy)) {
    direction *= std::complex<double>(2 * redOf(*texel) - 1, 2 * greenOf(*texel) - 1);
    material.surface->anisotropy *= static_cast<float>(blueOf(*texel));
  }
  const dvec3 rough = direction.real() * attributes.tangent + direction.imag() * attributes.bitangent;
  surface.anisotropyDirection = textures.arithmetic.direction(normalize(rough));
}

}  // namespace candela::reference
