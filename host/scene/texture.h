// Images, and how materials refer to them: docs/light-transport.md section 11.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace candela::scene {

/// Four channels of 8 or 16 bits for each texel, row by row from the top, as the image file has them: nothing is
/// decoded. One of the two arrays is empty.
struct TextureImage {
  std::string name;  ///< for messages
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint32_t> texels;        ///< red | green << 8 | blue << 16 | alpha << 24
  std::vector<std::uint64_t> deepTexels{};  ///< red | green << 16 | blue << 32 | alpha << 48

  bool isDeep() const { return !deepTexels.empty(); }
};

/// The treatment of texture coordinates outside of 0 to 1.
enum class TextureWrap : std::uint8_t { repeat, mirroredRepeat, clampToEdge };

enum class TextureFilter : std::uint8_t { nearest, linear };

/// A use of an image. The texture coordinates (u, v) of a surface point become s = dot(rowS, (u, v, 1)) and
/// t = dot(rowT, (u, v, 1)), from 0 to 1 across the image, t from the top.
struct TextureReference {
  std::uint32_t image = 0;       ///< into Scene::images
  std::uint8_t texCoordSet = 0;  ///< 0 or 1: into Mesh::texCoords
  TextureWrap wrapS = TextureWrap::repeat;
  TextureWrap wrapT = TextureWrap::repeat;
  TextureFilter filter = TextureFilter::linear;
  glm::vec3 rowS{1, 0, 0};
  glm::vec3 rowT{0, 1, 0};

  bool operator==(const TextureReference&) const = default;
};

/// The quantities of a material that textures may give. Unless stated otherwise, a texel is a factor of the quantity.
enum class TextureSlot : std::uint8_t {
  baseColour,         ///< sRGB
  emission,           ///< sRGB
  metallicRoughness,  ///< metalness: blue, roughness: green
  specular,           ///< weight: alpha
  specularColour,     ///< sRGB
  normal,             ///< no factor: a direction in the tangent frame, in red, green and blue
  transmission,       ///< weight: red
  coat,               ///< weight: red
  coatRoughness,      ///< green
  coatNormal,         ///< as `normal`
  sheenColour,        ///< sRGB
  sheenRoughness,     ///< alpha
  anisotropy,         ///< strength: blue; its direction in the tangent frame: red and green
  film,               ///< weight: red
  filmThickness,      ///< green
  glossiness          ///< alpha, a factor of 1 - roughness
};
inline constexpr std::size_t kTextureSlotCount = 16;

}  // namespace candela::scene
