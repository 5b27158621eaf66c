// Lookups of textures: docs/light-transport.md section 11.
#pragma once
#include <cstdint>

#include "host/scene/scene.h"
#include "host/trace/reference/mesh_attributes.h"
#include "host/trace/reference/ray.h"

namespace candela::reference {

using glm::dvec2;

/// The index, along one axis of `count` texels, of the texel at texture coordinate `s`. `displacement`, in texels, is 0
/// for the filter `nearest`, else the jitter minus 1/2.
std::uint32_t texelIndex(double s, std::uint32_t count, scene::TextureWrap wrap, double displacement);

/// Four channels of 16 bits: red | green << 16 | blue << 32 | alpha << 48. Those of an image of 8 bits are multiplied
/// by 257, so that their quotients with the largest value are the same.
using Texel = std::uint64_t;

/// The texel that the jitter, two random numbers, selects at texture coordinates (s, t).
Texel texelAt(const scene::TextureImage& image, const scene::TextureReference& reference, const dvec2& st,
              const dvec2& jitter);

/// The coordinates (s, t) of a reference at a point with these attributes.
dvec2 textureCoordinates(const scene::TextureReference& reference, const MeshAttributes& attributes);

/// The channels of a texel, 0 to 1.
glm::dvec4 channelsOf(Texel texel);
double redOf(Texel texel);
double greenOf(Texel texel);
double blueOf(Texel texel);
double alphaOf(Texel texel);
/// The channels at texture coordinates (s, t), interpolated among four texels unless the filter is `nearest`.
glm::dvec4 filteredTexel(const scene::TextureImage& image, const scene::TextureReference& reference, const dvec2& st);

/// The derivatives by s and t of the red at texture coordinates (s, t), interpolated among four texels whatever the
/// filter.
dvec2 gradientOfRed(const scene::TextureImage& image, const scene::TextureReference& reference, const dvec2& st);

/// The linear colour of a texel whose colour is encoded in sRGB.
dvec3 linearColour(Texel texel);

}  // namespace candela::reference
