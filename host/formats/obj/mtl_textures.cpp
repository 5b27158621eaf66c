// Reads images, and rearranges their channels.
#include "host/formats/obj/mtl_textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "host/base/hash.h"
#include "host/base/memory_budget.h"
#include "host/base/quote.h"
#include "host/base/setting_words.h"
#include "host/formats/loading/read_file.h"
#include "host/image/film.h"
#include "host/image/texels.h"

namespace candela::obj {
namespace {

using scene::TextureImage;

constexpr std::uint32_t kMax = 65535;
using Channels = std::array<std::uint32_t, 4>;  ///< of 16 bits

Channels texelOf(const TextureImage& image, std::size_t i) {
  Channels channels{};
  for (std::size_t c = 0; c < channels.size(); ++c) {
    channels[c] = image.isDeep() ? static_cast<std::uint32_t>(image.deepTexels[i] >> (16 * c) & kMax)
                                 : (image.texels[i] >> (8 * c) & 255) * 257;
  }
  return channels;
}

/// The texel at the same place of an image of another size.
Channels texelAt(const TextureImage& image, const TextureImage& other, std::uint32_t x, std::uint32_t y) {
  const std::size_t column = std::size_t{x} * image.width / other.width;
  const std::size_t row = std::size_t{y} * image.height / other.height;
  return texelOf(image, row * image.width + column);
}

void append(TextureImage& image, bool isDeep, const Channels& c) {
  if (isDeep) {
    image.deepTexels.push_back(std::uint64_t{c[0]} | std::uint64_t{c[1]} << 16 | std::uint64_t{c[2]} << 32 |
                               std::uint64_t{c[3]} << 48);
  } else {
    image.texels.push_back(c[0] / 257 | c[1] / 257 << 8 | c[2] / 257 << 16 | c[3] / 257 << 24);
  }
}

std::size_t sizeOf(const TextureImage& image) { return std::size_t{image.width} * image.height; }

std::uint32_t luminanceOf(const Channels& c) {
  if (c[0] == c[1] && c[1] == c[2]) return c[0];
  return static_cast<std::uint32_t>(std::lround(image::luminance(glm::dvec3(c[0], c[1], c[2]))));
}

/// The channel that -imfchan names.
std::uint32_t channelOf(const Channels& c, char name) {
  switch (name) {
    case 'r':
      return c[0];
    case 'g':
      return c[1];
    case 'b':
      return c[2];
    case 'm':
      return c[3];
    default:
      return luminanceOf(c);
  }
}

bool hasAlpha(const TextureImage& image) {
  for (std::size_t i = 0; i < sizeOf(image); ++i) {
    if (texelOf(image, i)[3] != kMax) return true;
  }
  return false;
}

bool isGrey(const TextureImage& image) {
  for (std::size_t i = 0; i < sizeOf(image); ++i) {
    const Channels c = texelOf(image, i);
    if (c[0] != c[1] || c[1] != c[2]) return false;
  }
  return true;
}

/// v counts from the bottom of the image, and t from its top.
scene::TextureReference referenceTo(std::uint32_t image, const MtlMap& map) {
  scene::TextureReference reference{.image = image};
  if (map.isClamped) reference.wrapS = reference.wrapT = scene::TextureWrap::clampToEdge;
  reference.rowS = {map.scale.x, 0, map.offset.x};
  reference.rowT = {0, -map.scale.y, 1 - map.offset.y};
  return reference;
}

const MtlMap* find(const MtlMaterial& material, MapKind kind) {
  const auto found = material.maps.find(kind);
  return found == material.maps.end() ? nullptr : &found->second;
}

bool haveEqualOptions(const MtlMap& a, const MtlMap& b) {
  return a.offset == b.offset && a.scale == b.scale && a.isClamped == b.isClamped;
}

}  // namespace

std::uint32_t MtlTextures::store(TextureImage image) {
  byteCount_ += sizeOf(image) * (image.isDeep() ? sizeof(std::uint64_t) : sizeof(std::uint32_t));
  if (byteCount_ > memoryBudget()) {
    throw OutOfMemoryError(fmt::format("{}: the images need more than the {} MiB of memory that they may have",
                                       image.name, memoryBudget() >> 20));
  }
  images_.push_back(std::move(image));
  return static_cast<std::uint32_t>(images_.size() - 1);
}

MtlTextures::Image MtlTextures::load(const MtlMap& map, const Place& place) {
  const std::filesystem::path path = place.folder / map.file;
  const auto known = files_.find(path.string());
  if (known != files_.end()) return known->second;
  return files_[path.string()] = readImage(path, map, place);
}

MtlTextures::Image MtlTextures::readImage(const std::filesystem::path& path, const MtlMap& map, const Place& place) {
  try {
    guard_.require(path);
    const std::string bytes = scene::readFile(path);
    image::Texels texels = image::decodeModelTexels(std::as_bytes(std::span(bytes)));
    hashes_.push_back(fnv1aOfText(bytes));
    return store({map.file, texels.width, texels.height, std::move(texels.rgba), std::move(texels.deepRgba)});
  } catch (const FileError& error) {
    const std::string message = fmt::format("image {}: {}", scene::quote(map.file), error.what());
    if (isLenient_) {
      place.log.warn("image", map.position, message + "; its textures are left out");
    } else {
      place.log.error(map.position, fmt::format("{}; {} leaves out textures whose image cannot be read", message,
                                                settingWords("lenient")));
    }
    return std::nullopt;
  }
}

template <class Make>
std::uint32_t MtlTextures::derived(const std::string& key, const Make& make) {
  const auto known = derived_.find(key);
  if (known != derived_.end()) return known->second;
  return derived_[key] = store(make());
}

/// Without -imfchan, alpha is the opacity of an image that has it, and luminance that of others.
MtlTextures::Image MtlTextures::withAlpha(const MtlMap& map, const Place& place) {
  const Image source = load(map, place);
  if (!source || map.channel == 'm' || (map.channel == 0 && hasAlpha(images_[*source]))) return source;
  return derived(fmt::format("alpha {} {}", *source, map.channel), [&] {
    const TextureImage& image = images_[*source];
    TextureImage result{image.name, image.width, image.height, {}};
    for (std::size_t i = 0; i < sizeOf(image); ++i) {
      Channels channels = texelOf(image, i);
      channels[3] = channelOf(channels, map.channel == 0 ? 'l' : map.channel);
      append(result, image.isDeep(), channels);
    }
    return result;
  });
}

/// A missing map is white. Of a file that both maps name, roughness is green and metalness blue, as in glTF.
MtlTextures::Image MtlTextures::withRoughness(const MtlMap* roughness, const MtlMap* metalness, const Place& place) {
  constexpr std::uint32_t kMissing = ~0u;
  const std::uint32_t rough = (roughness ? load(*roughness, place) : Image()).value_or(kMissing);
  const std::uint32_t metal = (metalness ? load(*metalness, place) : Image()).value_or(kMissing);
  if (rough == kMissing && metal == kMissing) return std::nullopt;
  const char roughChannel = roughness && roughness->channel != 0 ? roughness->channel : 'g';
  const char metalChannel = metalness && metalness->channel != 0 ? metalness->channel : 'b';
  const std::string key = fmt::format("roughness {} {} metalness {} {}", rough, roughChannel, metal, metalChannel);
  return derived(key, [&] {
    const TextureImage& first = images_[rough != kMissing ? rough : metal];
    const TextureImage& second = images_[metal != kMissing ? metal : rough];
    TextureImage result{first.name, std::max(first.width, second.width), std::max(first.height, second.height), {}};
    for (std::uint32_t y = 0; y < result.height; ++y) {
      for (std::uint32_t x = 0; x < result.width; ++x) {
        const std::uint32_t green = rough != kMissing ? channelOf(texelAt(first, result, x, y), roughChannel) : kMax;
        const std::uint32_t blue = metal != kMissing ? channelOf(texelAt(second, result, x, y), metalChannel) : kMax;
        append(result, first.isDeep() || second.isDeep(), {kMax, green, blue, kMax});
      }
    }
    return result;
  });
}

MtlReferences MtlTextures::read(const MtlMaterial& material, const std::filesystem::path& folder,
                                scene::DiagnosticLog& log, std::set<std::string>& omissions) {
  const Place place{folder, log};
  const auto reference = [&](const MtlMap* map) -> std::optional<scene::TextureReference> {
    const Image image = map ? load(*map, place) : std::nullopt;
    return image ? std::optional(referenceTo(*image, *map)) : std::nullopt;
  };
  MtlReferences result;
  result.diffuse = reference(find(material, MapKind::diffuse));
  result.specular = reference(find(material, MapKind::specular));
  result.emission = reference(find(material, MapKind::emission));
  if (const MtlMap* const map = find(material, MapKind::opacity)) {
    if (const Image image = withAlpha(*map, place)) result.opacity = referenceTo(*image, *map);
  }
  const MtlMap* const normal = find(material, MapKind::normal);
  result.normal = reference(normal ? normal : find(material, MapKind::bump));
  if (!normal && result.normal && isGrey(images_[result.normal->image])) {
    omissions.insert("bump maps of heights");
    result.normal.reset();
  }
  const MtlMap* const roughness = find(material, MapKind::roughness);
  const MtlMap* const metalness = find(material, MapKind::metalness);
  if (roughness && metalness && !haveEqualOptions(*roughness, *metalness)) {
    omissions.insert("options of map_Pm other than those of map_Pr");
  }
  if (const MtlMap* const options = roughness ? roughness : metalness) {
    if (const Image image = withRoughness(roughness, metalness, place)) {
      result.metallicRoughness = referenceTo(*image, *options);
    }
  }
  return result;
}

std::uint64_t MtlTextures::hashFiles(std::uint64_t hash) const {
  for (const std::uint64_t file : hashes_) hash = fnv1aOfText(fmt::format("image {:x}", file), hash);
  return hash;
}

}  // namespace candela::obj
