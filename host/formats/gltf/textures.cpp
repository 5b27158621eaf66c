// Reads textures.
#include "host/formats/gltf/textures.h"

#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/base/hash.h"
#include "host/base/memory_budget.h"
#include "host/base/setting_words.h"
#include "host/formats/gltf/texture_reference.h"
#include "host/formats/gltf/uri.h"
#include "host/image/texels.h"

namespace candela::gltf {
namespace {

constexpr std::uint64_t kMaxSet = 1;

std::string nameOf(const Value& image) {
  const std::optional<Value> uri = image.find("uri");
  if (uri && !isDataUri(uri->text())) return uri->text();
  return image.textOr("name", image.pointer());
}

}  // namespace

std::optional<scene::TextureReference> Textures::read(const Value& info) {
  const std::size_t textureIndex = info.require("index").indexInto("textures", root_.sizeOf("textures"));
  const Value texture = root_.require("textures")[textureIndex];
  scene::TextureReference reference;
  const std::optional<Value> transform = extensionOf(info, "KHR_texture_transform");
  if (transform) readTransform(*transform, reference);
  const std::uint64_t set = texCoordSetOf(info, transform);
  if (set > kMaxSet) {
    log_.warn(
        "set", {},
        fmt::format("{}: the texture is left out, since it has texture coordinates of set {}; sets 0 and 1 are read",
                    info.pointer(), set));
    return std::nullopt;
  }
  reference.texCoordSet = static_cast<std::uint8_t>(set);
  if (const std::optional<Value> index = texture.find("sampler")) {
    readSampler(root_.require("samplers")[index->indexInto("samplers", root_.sizeOf("samplers"))], reference);
  }
  const std::optional<std::uint32_t> image = imageOf(texture);
  if (!image) return std::nullopt;
  reference.image = *image;
  return reference;
}

std::optional<std::uint32_t> Textures::imageOf(const Value& texture) {
  const std::optional<Value> webp = extensionOf(texture, "EXT_texture_webp");
  const std::optional<Value> source = (webp ? *webp : texture).find("source");
  if (!source) {
    log_.warn("source", {}, texture.pointer() + ": the texture is left out, since it names no PNG, JPEG or WebP image");
    return std::nullopt;
  }
  const std::size_t index = source->indexInto("images", root_.sizeOf("images"));
  if (const auto known = indices_.find(index); known != indices_.end()) return known->second;
  return indices_[index] = loadImage(index);
}

std::optional<std::uint32_t> Textures::loadImage(std::size_t index) {
  const Value image = root_.require("images")[index];
  try {
    images_.push_back(readImage(image));
  } catch (const JsonError& error) {
    if (!isLenient_)
      throw JsonError(error,
                      fmt::format("; {} leaves out textures whose image cannot be read", settingWords("lenient")));
    log_.warn("image", {}, std::string(error.what()) + "; its textures are left out");
    return std::nullopt;
  }
  byteCount_ += images_.back().texels.size() * sizeof(std::uint32_t) +
                images_.back().deepTexels.size() * sizeof(std::uint64_t);
  if (byteCount_ > memoryBudget()) {
    throw OutOfMemoryError(fmt::format("{}: the images need more than the {} MiB of memory that they may have",
                                       image.pointer(), memoryBudget() >> 20));
  }
  return static_cast<std::uint32_t>(images_.size() - 1);
}

scene::TextureImage Textures::readImage(const Value& image) {
  if (const std::optional<Value> view = image.find("bufferView")) return decode(image, buffers_.view(*view).bytes);
  const std::string bytes = buffers_.readUri(image.require("uri"));
  fileHashes_.push_back(fnv1aOfText(bytes));
  return decode(image, std::as_bytes(std::span(bytes)));
}

scene::TextureImage Textures::decode(const Value& image, Bytes bytes) const {
  try {
    image::Texels texels = image::decodeTexels(bytes);
    return {nameOf(image), texels.width, texels.height, std::move(texels.rgba), std::move(texels.deepRgba)};
  } catch (const FileError& error) {
    image.fail(error.what());
  }
}

std::uint64_t Textures::hashFiles(std::uint64_t hash) const {
  for (const std::uint64_t file : fileHashes_) hash = fnv1aOfText(fmt::format("image {:x}", file), hash);
  return hash;
}

}  // namespace candela::gltf
