// Stores images, and the references of materials to them, as 16-byte records.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/errors.h"
#include "host/image/colour_transfer.h"
#include "host/trace/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

std::uint64_t texelRows(const scene::TextureImage& image) {
  return (image.texels.size() + 3) / 4 + (image.deepTexels.size() + 1) / 2;
}

std::size_t countReferences(const scene::Scene& scene) {
  std::size_t count = 0;
  for (const scene::Material& material : scene.materials) {
    for (const auto& texture : material.textures) count += texture.has_value();
    count += material.opacity && material.opacity->texture;
  }
  return count;
}

// Returns the first record of each image, if the first one begins at `row`.
std::vector<std::uint32_t> firstRowsOfImages(const scene::Scene& scene, std::uint64_t row) {
  std::vector<std::uint32_t> rows;
  for (const scene::TextureImage& image : scene.images) {
    rows.push_back(static_cast<std::uint32_t>(row));
    row += texelRows(image);
    if (row > gpu::kMaxTextureRows) {
      throw FileError(fmt::format("{}: the images of textures need more than the {} MiB that are supported", scene.name,
                                  std::uint64_t{gpu::kMaxTextureRows} * sizeof(gpu::uvec4) >> 20));
    }
  }
  return rows;
}

std::uint32_t flagsOf(const scene::TextureReference& reference) {
  return (reference.texCoordSet == 1 ? gpu::kTextureSecondSet : 0) |
         (reference.filter == scene::TextureFilter::nearest ? gpu::kTextureNearest : 0) |
         static_cast<std::uint32_t>(reference.wrapS) << gpu::kTextureWrapShiftS |
         static_cast<std::uint32_t>(reference.wrapT) << gpu::kTextureWrapShiftT;
}

void appendReference(const scene::Scene& scene, const scene::TextureReference& reference,
                     const std::vector<std::uint32_t>& imageRows, Rows& rows) {
  const scene::TextureImage& image = scene.images[reference.image];
  const std::uint32_t firstRow = imageRows[reference.image] << gpu::kTextureRowShift;
  const glm::vec3& s = reference.rowS;
  rows.push_back({floatBits(double{s.x}), floatBits(double{s.y}), image.width | image.height << 16,
                  flagsOf(reference) | firstRow});
  rows.push_back(row(glm::dvec3(reference.rowT), double{s.z}));
}

void appendTexels(const scene::TextureImage& image, Rows& rows) {
  for (std::size_t i = 0; i < image.texels.size(); i += 4) {
    gpu::uvec4 four(0);
    for (std::size_t k = 0; k < 4 && i + k < image.texels.size(); ++k) four[static_cast<int>(k)] = image.texels[i + k];
    rows.push_back(four);
  }
  for (std::size_t i = 0; i < image.deepTexels.size(); i += 2) {
    const std::uint64_t first = image.deepTexels[i];
    const std::uint64_t second = i + 1 < image.deepTexels.size() ? image.deepTexels[i + 1] : 0;
    rows.push_back(gpu::uvec4(first, first >> 32, second, second >> 32));
  }
}

// Returns the linear values of the sRGB signals 0 to `largest`, divided by `largest`.
Rows srgbRows(double largest) {
  const auto linear = [&](std::uint32_t value) { return floatBits(image::srgbDecode(value / largest)); };
  Rows rows;
  for (std::uint32_t i = 0; i < largest; i += 4) {
    rows.push_back({linear(i), linear(i + 1), linear(i + 2), linear(i + 3)});
  }
  return rows;
}

}  // namespace

Rows srgbTableRows() { return srgbRows(255); }

bool hasDeepTexels(const scene::Scene& scene) {
  return std::ranges::any_of(scene.images, &scene::TextureImage::isDeep);
}

std::uint32_t textureSlotsOf(const scene::Scene& scene) {
  std::uint32_t slots = 0;
  for (const scene::Material& material : scene.materials) {
    for (std::size_t slot = 0; slot < scene::kTextureSlotCount; ++slot) {
      if (material.textures[slot]) slots |= 1u << slot;
    }
  }
  return slots;
}

Rows textureRows(const scene::Scene& scene) {
  Rows rows = hasDeepTexels(scene) ? srgbRows(65535) : srgbTableRows();
  const std::size_t firstReference = rows.size() + scene.materials.size() * gpu::kMaterialTextureRows;
  const std::size_t end = firstReference + countReferences(scene) * gpu::kReferenceRows;
  const std::vector<std::uint32_t> imageRows = firstRowsOfImages(scene, end);
  Rows references;
  // Appends a reference, and returns the word that refers to it; 0 if there is none.
  const auto add = [&](const std::optional<scene::TextureReference>& reference) {
    if (!reference) return std::uint32_t{0};
    const auto first = static_cast<std::uint32_t>(firstReference + references.size());
    appendReference(scene, *reference, imageRows, references);
    return scene.images[reference->image].isDeep() ? first | gpu::kDeepReference : first;
  };
  for (const scene::Material& material : scene.materials) {
    std::array<gpu::uvec4, gpu::kOpacityRow> slots{};
    for (std::size_t slot = 0; slot < scene::kTextureSlotCount; ++slot) {
      slots[slot / 4][static_cast<int>(slot % 4)] = add(material.textures[slot]);
    }
    const scene::Opacity opacity = material.opacity.value_or(scene::Opacity{});
    rows.insert(rows.end(), slots.begin(), slots.end());
    rows.push_back({floatBits(double{opacity.factor}), floatBits(double{opacity.cutoff.value_or(-1.0f)}),
                    add(opacity.texture), 0});
    rows.push_back(
        {floatBits(double{material.normalScale}), floatBits(double{material.coatNormalScale}),
         (material.hasHeights ? gpu::kNormalMapHeights : 0) | (material.hasFacets ? 0 : gpu::kNormalMapWithoutFacets),
         0});
  }
  rows.insert(rows.end(), references.begin(), references.end());
  for (const scene::TextureImage& image : scene.images) appendTexels(image, rows);
  return rows;
}

}  // namespace candela::flatten
