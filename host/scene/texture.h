// Images, and how materials refer to them: docs/light-transport.md section 11.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "lists/textures.h"

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

  bool operator==(const TextureImage&) const = default;
};

/// The treatment of texture coordinates outside of 0 to 1: the entries of CANDELA_TEXTURE_WRAPS, with their values.
enum class TextureWrap : std::uint8_t {
#define CANDELA_ENUMERATE_WRAP(wrap, name, value) wrap = value,
  CANDELA_TEXTURE_WRAPS(CANDELA_ENUMERATE_WRAP)
#undef CANDELA_ENUMERATE_WRAP
};

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

/// The quantities of a material that textures may give: the entries of CANDELA_TEXTURE_SLOTS, with their values.
enum class TextureSlot : std::uint8_t {
#define CANDELA_ENUMERATE_SLOT(slot, name, value) slot = value,
  CANDELA_TEXTURE_SLOTS(CANDELA_ENUMERATE_SLOT)
#undef CANDELA_ENUMERATE_SLOT
};
#define CANDELA_COUNT_SLOT(slot, name, value) +1
inline constexpr std::size_t kTextureSlotCount = CANDELA_TEXTURE_SLOTS(CANDELA_COUNT_SLOT);
#undef CANDELA_COUNT_SLOT

}  // namespace candela::scene
