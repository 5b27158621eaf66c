// Reads textures.
#include "host/formats/gltf/textures.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>

#include "host/base/errors.h"
#include "host/base/hash.h"
#include "host/base/memory_budget.h"
#include "host/base/setting_words.h"
#include "host/formats/gltf/uri.h"
#include "host/formats/gltf/value.h"
#include "host/image/texels.h"
#include "host/scene/texture.h"

namespace candela::gltf {
namespace {

constexpr std::uint64_t kRepeat = 10497;
constexpr std::uint64_t kMirroredRepeat = 33648;
constexpr std::uint64_t kClampToEdge = 33071;
constexpr std::uint64_t kNearest = 9728;
constexpr std::uint64_t kLinear = 9729;

scene::TextureWrap wrapOf(const Value& sampler, const char* key) {
  const std::uint64_t mode = sampler.wholeOr(key, kRepeat);
  if (mode == kRepeat) return scene::TextureWrap::repeat;
  if (mode == kMirroredRepeat) return scene::TextureWrap::mirroredRepeat;
  if (mode != kClampToEdge) sampler.require(key).fail(fmt::format("{} is not a wrapping mode", mode));
  return scene::TextureWrap::clampToEdge;
}

/// Reads wrapping and `magFilter`. There are no smaller copies of images (mipmaps), so that `minFilter` has no effect.
void readSampler(const Value& sampler, scene::TextureReference& reference) {
  reference.wrapS = wrapOf(sampler, "wrapS");
  reference.wrapT = wrapOf(sampler, "wrapT");
  const std::uint64_t filter = sampler.wholeOr("magFilter", kLinear);
  if (filter != kNearest && filter != kLinear)
    sampler.require("magFilter").fail(fmt::format("{} is not a filter", filter));
  reference.filter = filter == kNearest ? scene::TextureFilter::nearest : scene::TextureFilter::linear;
}

/// Reads KHR_texture_transform: translation times rotation times scale.
void readTransform(const Value& transform, scene::TextureReference& reference) {
  const auto offset = transform.vectorOr("offset", glm::dvec2(0));
  const auto scale = transform.vectorOr("scale", glm::dvec2(1));
  const double rotation = transform.numberOr("rotation", 0);
  const double c = std::cos(rotation);
  const double s = std::sin(rotation);
  reference.rowS = glm::vec3(glm::dvec3(c * scale.x, s * scale.y, offset.x));
  reference.rowT = glm::vec3(glm::dvec3(-s * scale.x, c * scale.y, offset.y));
}

/// Returns the set of texture coordinates, which KHR_texture_transform may override.
std::uint64_t texCoordSetOf(const Value& info, const std::optional<Value>& transform) {
  const std::uint64_t set = info.wholeOr("texCoord", 0);
  return transform ? transform->wholeOr("texCoord", set) : set;
}

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
    DecodedImage read = imageAt(index);
    images_.push_back(std::move(read.image));
    if (read.fileHash) fileHashes_.push_back(*read.fileHash);
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

DecodedImage Textures::imageAt(std::size_t index) {
  const Value image = root_.require("images")[index];
  if (decoded_ == nullptr) return readImage(image);
  if (const std::optional<Value> view = image.find("bufferView")) buffers_.view(*view);  // it counts as read
  if (!decoded_->contains(index)) decoded_->emplace(index, readImage(image));
  return decoded_->at(index);
}

DecodedImage Textures::readImage(const Value& image) {
  if (const std::optional<Value> view = image.find("bufferView")) return {decode(image, buffers_.view(*view).bytes)};
  const std::string bytes = buffers_.readUri(image.require("uri"));
  return {decode(image, std::as_bytes(std::span(bytes))), fnv1aOfText(bytes)};
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
