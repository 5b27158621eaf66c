// Textures, samplers and images (glTF 2.0 specification, section 3.8), and KHR_texture_transform.
#pragma once
#include <map>
#include <vector>

#include "host/gltf/buffers.h"
#include "host/scene/texture.h"

namespace candela::gltf {

/// Reads the images that materials use, each once.
class Textures {
 public:
  /// Both must outlive this object.
  Textures(const Value& root, Buffers& buffers) : root_(root), buffers_(buffers) {}

  /// Returns the texture to which a `textureInfo` such as `baseColorTexture` refers. Reads the image unless it has
  /// been read before. Throws PlaceError, at the place of the error.
  scene::TextureReference read(const Value& info);

  /// The images that were read, in the order of their first use, to which the references refer.
  std::vector<scene::TextureImage> takeImages() { return std::move(images_); }
  /// Continues `hash` over the bytes of the images from other files and from data URIs.
  std::uint64_t hashFiles(std::uint64_t hash) const;

 private:
  std::uint32_t imageOf(const Value& texture);
  scene::TextureImage decode(const Value& image, Bytes bytes) const;
  scene::TextureImage readImage(const Value& image);

  Value root_;
  Buffers& buffers_;
  std::vector<scene::TextureImage> images_{};
  std::map<std::size_t, std::uint32_t> indices_{};  ///< into images_, by index in the file
  std::vector<std::uint64_t> fileHashes_{};
  std::uint64_t byteCount_ = 0;  ///< of images_
};

}  // namespace candela::gltf
