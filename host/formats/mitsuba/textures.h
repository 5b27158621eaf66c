// Textures, and the images that they refer to.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/formats/loading/path_guard.h"
#include "host/formats/mitsuba/description.h"
#include "host/formats/mitsuba/numbers.h"
#include "host/formats/mitsuba/spectrum.h"
#include "host/scene/texture.h"

namespace candela::mitsuba {

/// Colours that a mesh states for its vertices or its faces.
struct MeshAttribute {
  bool isOfFaces = false;
  std::string name{};    ///< without "vertex_" or "face_"
  bool isAlpha = false;  ///< their luminance is a weight or an opacity, which Mesh::colours get as alpha

  bool operator==(const MeshAttribute&) const = default;
};

/// A colour or a number that may vary over a surface: the product of all members.
struct Texture {
  glm::dvec3 factor{1};
  std::optional<scene::TextureReference> reference{};  ///< its encoding is that of the slot for which it was made
  std::optional<MeshAttribute> attribute{};
};

/// The encoding of the texels that a slot of a material reads.
enum class Encoding {
  srgb,       ///< colours, as of a base colour
  linear,     ///< normal maps
  height,     ///< bump maps, from grey
  alpha,      ///< the alpha channel of an opacity, from grey
  weight,     ///< the red channel of a transmission
  roughness,  ///< the green channel, of which alpha of microfacets is the square; blue is 1
};

/// Reads textures of objects. Images are read once, and converted where a slot needs another encoding.
class Textures {
 public:
  Textures(const scene::SceneFile& file, const Description& description, scene::PathGuard& guard, Report& report)
      : file_(file), description_(description), guard_(guard), report_(report) {}

  /// Returns the property `name` of an object: a number, a colour, a spectrum or a texture; `absent` without one. An
  /// image that cannot be read, and a texture that is not rendered, is an error, or with `--lenient` left out. Throws
  /// PlacedError, and OutOfMemoryError if the images exceed the memory budget.
  Texture read(const Object& owner, std::string_view name, double absent, ColourUse use, Encoding encoding);
  /// Returns the same of a texture that is nested in another object.
  Texture readObject(const Object& texture, ColourUse use, Encoding encoding);

  /// Returns the same of a property that is one number, as the luminance of a colour is; texels are not encoded.
  Numbers readNumbers(const Object& owner, std::string_view name, double absent);
  /// Stores an image that texels of others determine. Those with equal names, which state all of these, are equal.
  std::uint32_t storeMade(const std::string& name, scene::TextureImage image);

  /// The images to which the references refer.
  std::vector<scene::TextureImage> takeImages() { return std::move(images_); }
  /// Continues `hash` over the bytes of all files that were read.
  std::uint64_t hashFiles(std::uint64_t hash) const;

 private:
  /// A file as it was read: integers, or linear values.
  struct Source {
    scene::TextureImage image{};
    std::vector<glm::vec3> values{};  ///< of files of floats
    bool isFloat() const { return !values.empty(); }
    glm::dvec3 valueAt(std::size_t i, bool isRaw) const;  ///< linear; not raw ones of integers are decoded
  };

  /// A bitmap as its object states it. Without a source, the image cannot be read.
  struct Bitmap {
    const Source* source = nullptr;
    scene::TextureReference reference{};  ///< without the index of an image
    bool isRaw = false;
    std::string path{};
  };

  /// The colours of a checkerboard, with those of the first texel first.
  struct Checkerboard {
    scene::TextureReference reference{};  ///< without the index of an image
    glm::dvec3 even{}, odd{};
    std::string name{};
  };

  Bitmap loadBitmap(const Object& texture);
  Checkerboard checkerboardOf(const Object& texture, ColourUse use, bool isNumber);
  Texture readBitmap(const Object& texture, Encoding encoding);
  Texture readCheckerboard(const Object& texture, ColourUse use, Encoding encoding);
  Texture readAttribute(const Object& texture, Encoding encoding);
  const Source* load(const std::filesystem::path& path, const Object& texture);
  std::uint32_t store(scene::TextureImage image);

  const scene::SceneFile& file_;
  const Description& description_;
  scene::PathGuard& guard_;
  Report& report_;
  std::map<std::string, std::optional<Source>> sources_{};            ///< by path; empty: cannot be read
  std::map<std::string, std::pair<std::uint32_t, double>> stored_{};  ///< index and factor, by what they are made of
  std::vector<scene::TextureImage> images_{};
  std::vector<std::uint64_t> hashes_{};
  std::uint64_t byteCount_ = 0;
};

}  // namespace candela::mitsuba
