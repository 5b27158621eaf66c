// The images of MTL files, as the scene's textures need them.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/path_guard.h"
#include "host/formats/obj/mtl_file.h"
#include "host/scene/texture.h"

namespace candela::obj {

/// The textures of a material; empty: none. Opacity has its value in alpha, metallicRoughness in green and blue.
struct MtlReferences {
  std::optional<scene::TextureReference> diffuse{};
  std::optional<scene::TextureReference> specular{};
  std::optional<scene::TextureReference> emission{};
  std::optional<scene::TextureReference> opacity{};
  std::optional<scene::TextureReference> normal{};
  std::optional<scene::TextureReference> metallicRoughness{};
};

/// Reads images, each once, and makes others of their channels.
class MtlTextures {
 public:
  /// `guard` must outlive this object. With `lenient`, images that cannot be read cause warnings instead of errors.
  MtlTextures(scene::PathGuard& guard, bool lenient) : guard_(guard), isLenient_(lenient) {}

  /// Reads the images of a material. Their paths are relative to `folder`. Errors are added to `log`, and what a map
  /// has that is not rendered to `omissions`. Throws OutOfMemoryError if the images exceed the memory budget.
  MtlReferences read(const MtlMaterial& material, const std::filesystem::path& folder, scene::DiagnosticLog& log,
                     std::set<std::string>& omissions);

  /// The images to which the references refer.
  std::vector<scene::TextureImage> takeImages() { return std::move(images_); }
  /// Continues `hash` over the bytes of all files that were read.
  std::uint64_t hashFiles(std::uint64_t hash) const;

 private:
  struct Place {
    const std::filesystem::path& folder;
    scene::DiagnosticLog& log;
  };
  using Image = std::optional<std::uint32_t>;  ///< into images_; empty: cannot be read

  Image load(const MtlMap& map, const Place& place);
  Image readImage(const std::filesystem::path& path, const MtlMap& map, const Place& place);
  std::uint32_t store(scene::TextureImage image);
  /// Returns the image made by `make`, which is called unless the key is known.
  template <class Make>
  std::uint32_t derived(const std::string& key, const Make& make);
  Image withAlpha(const MtlMap& map, const Place& place);
  Image withRoughness(const MtlMap* roughness, const MtlMap* metalness, const Place& place);

  scene::PathGuard& guard_;
  bool isLenient_;
  std::vector<scene::TextureImage> images_{};
  std::map<std::string, Image> files_{};            ///< by path
  std::map<std::string, std::uint32_t> derived_{};  ///< by what they are made of
  std::vector<std::uint64_t> hashes_{};
  std::uint64_t byteCount_ = 0;
};

}  // namespace candela::obj
