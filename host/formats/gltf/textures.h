// Textures, samplers and images (glTF 2.0 specification, section 3.8), and KHR_texture_transform.
#pragma once
#include <map>
#include <vector>

#include "host/formats/gltf/buffers.h"
#include "host/formats/loading/diagnostic_log.h"
#include "host/scene/texture.h"

namespace candela::gltf {

/// An image of the file, and the hash of its bytes if they are not in a buffer.
struct DecodedImage {
  scene::TextureImage image;
  std::optional<std::uint64_t> fileHash{};
};

/// The images that were decoded for one scene of a file and are needed by the next, by index in the file.
using DecodedImages = std::map<std::size_t, DecodedImage>;

/// Reads the images that materials use, each once.
class Textures {
 public:
  /// All must outlive this object. With `lenient`, images that cannot be read cause warnings instead of errors.
  /// `decoded`, which may be null, has the images of earlier scenes of the file, and receives those of this one.
  Textures(const Value& root, Buffers& buffers, bool lenient, DecodedImages* decoded, scene::DiagnosticLog& log)
      : root_(root), buffers_(buffers), isLenient_(lenient), decoded_(decoded), log_(log) {}

  /// Returns the texture to which a `textureInfo` such as `baseColorTexture` refers. Reads the image unless it was
  /// read before. Returns nothing, with a warning, if the texture has no image, or coordinates that are not read.
  /// Throws JsonError, at the place of the error.
  std::optional<scene::TextureReference> read(const Value& info);

  /// The images that were read, in the order of their first use, to which the references refer.
  std::vector<scene::TextureImage> takeImages() { return std::move(images_); }
  /// Continues `hash` over the bytes of the images from other files and from data URIs.
  std::uint64_t hashFiles(std::uint64_t hash) const;

 private:
  std::optional<std::uint32_t> imageOf(const Value& texture);
  /// Returns the index in images_ of an image of the file; nothing, with a warning, if it cannot be read.
  std::optional<std::uint32_t> loadImage(std::size_t index);
  scene::TextureImage decode(const Value& image, Bytes bytes) const;
  DecodedImage readImage(const Value& image);
  /// Returns an image of the file, decoded now or for an earlier scene.
  DecodedImage imageAt(std::size_t index);

  Value root_;
  Buffers& buffers_;
  bool isLenient_;
  DecodedImages* decoded_;
  scene::DiagnosticLog& log_;
  std::vector<scene::TextureImage> images_{};
  /// Into images_, by index in the file; nothing for images that cannot be read.
  std::map<std::size_t, std::optional<std::uint32_t>> indices_{};
  std::vector<std::uint64_t> fileHashes_{};
  std::uint64_t byteCount_ = 0;  ///< of images_
};

}  // namespace candela::gltf
