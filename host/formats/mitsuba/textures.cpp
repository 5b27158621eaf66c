// Reads images, and converts their texels.
#include "host/formats/mitsuba/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "host/base/errors.h"
#include "host/base/file_extension.h"
#include "host/base/hash.h"
#include "host/base/memory_budget.h"
#include "host/base/quote.h"
#include "host/formats/loading/read_file.h"
#include "host/image/colour_transfer.h"
#include "host/image/film.h"
#include "host/image/image.h"
#include "host/image/texels.h"

namespace candela::mitsuba {
namespace {

using scene::quote;

constexpr const char* kLeftOut = "leaves the texture out";

std::size_t sizeOf(const scene::TextureImage& image) { return std::size_t{image.width} * image.height; }

/// The stored integers of a texel, without alpha, as fractions of the largest one.
glm::dvec3 signalAt(const scene::TextureImage& image, std::size_t i) {
  glm::dvec3 signal;
  for (int c = 0; c < 3; ++c) {
    signal[c] = image.isDeep() ? static_cast<double>(image.deepTexels[i] >> (16 * c) & 65535) / 65535
                               : static_cast<double>(image.texels[i] >> (8 * c) & 255) / 255;
  }
  return signal;
}

glm::dvec3 decoded(const glm::dvec3& signal) {
  return {image::srgbDecode(signal.x), image::srgbDecode(signal.y), image::srgbDecode(signal.z)};
}

double greyOf(const glm::dvec3& value) {
  return value.x == value.y && value.y == value.z ? value.x : image::luminance(value);
}

/// Encodes a linear value from 0 to 1 in 16 bits per channel.
std::uint64_t encoded(const glm::dvec3& value, Encoding encoding) {
  const double grey = greyOf(value);
  switch (encoding) {
    case Encoding::srgb:
      return deepTexelOf({image::srgbEncode(value.x), image::srgbEncode(value.y), image::srgbEncode(value.z)});
    case Encoding::linear:
      return deepTexelOf(value);
    case Encoding::height:
      return deepTexelOf(glm::dvec3(grey));
    case Encoding::alpha:
      return deepTexelOf(glm::dvec3(1), grey);
    case Encoding::weight:
      return deepTexelOf(glm::dvec3(grey));
    case Encoding::roughness:
      return deepTexelOf({1, std::sqrt(std::max(grey, 0.0)), 1});
  }
  throw InternalError("an encoding without texels");
}

std::optional<scene::TextureWrap> wrapOf(const std::string& mode) {
  if (mode == "repeat") return scene::TextureWrap::repeat;
  if (mode == "mirror") return scene::TextureWrap::mirroredRepeat;
  if (mode == "clamp") return scene::TextureWrap::clampToEdge;
  return std::nullopt;
}

/// Texture coordinates have v = 0 in the first row of an image.
void setMap(const Object& texture, scene::TextureReference& reference) {
  const glm::dmat4 map = texture.transform("to_uv");
  reference.rowS = glm::vec3(map[0][0], map[1][0], map[3][0]);
  reference.rowT = glm::vec3(map[0][1], map[1][1], map[3][1]);
}

/// The texture that a property is; null if it is a number, a colour or a spectrum.
const Object* textureIn(const Property& property) {
  const auto* const object = std::get_if<const Object*>(&property.value);
  if (!object || isSpectrum(**object)) return nullptr;
  if ((*object)->tag == "texture") return *object;
  throw PlacedError{property.place,
                    fmt::format("{} is {} instead of a texture", quote(property.name), (*object)->description())};
}

}  // namespace

Texture Textures::read(const Object& owner, std::string_view name, double absent, ColourUse use, Encoding encoding) {
  const Property* const property = owner.find(name);
  if (!property) return {glm::dvec3(absent)};
  const Object* const texture = textureIn(*property);
  return texture ? readObject(*texture, use, encoding) : Texture{colourOf(*property, use, report_)};
}

Texture Textures::readObject(const Object& texture, ColourUse use, Encoding encoding) {
  Texture result;
  if (texture.type == "bitmap") {
    result = readBitmap(texture, encoding);
  } else if (texture.type == "checkerboard") {
    result = readCheckerboard(texture, use, encoding);
  } else if (texture.type == "mesh_attribute") {
    result = readAttribute(texture, encoding);
  } else {
    report_.deviate(texture.place, fmt::format("{} is not rendered", texture.description()), "renders white instead");
    return {};
  }
  texture.reportUnused(report_);
  return result;
}

Numbers Textures::readNumbers(const Object& owner, std::string_view name, double absent) {
  const Property* const property = owner.find(name);
  const Object* const texture = property ? textureIn(*property) : nullptr;
  if (!texture) {
    const double value = property ? greyOf(colourOf(*property, ColourUse::unbounded, report_)) : absent;
    return {.values = {value}, .name = fmt::format("{}", value)};
  }
  Numbers result{.values = {1}, .name = "1"};
  if (texture->type == "bitmap") {
    const auto [source, reference, isRaw, path] = loadBitmap(*texture);
    if (source) {
      const scene::TextureImage& image = source->image;
      requireMemory(path + ": the texture", byteCount_ + sizeof(double) * sizeOf(image),
                    "use a machine with more memory");
      result = {reference, image.width, image.height, {}, fmt::format("{} {}", isRaw, path)};
      result.values.reserve(sizeOf(image));
      for (std::size_t i = 0; i < sizeOf(image); ++i) result.values.push_back(greyOf(source->valueAt(i, isRaw)));
    }
  } else if (texture->type == "checkerboard") {
    const Checkerboard board = checkerboardOf(*texture, ColourUse::unbounded, true);
    const double a = greyOf(board.even), b = greyOf(board.odd);
    result = {board.reference, 2, 2, {a, b, b, a}, board.name};
  } else {
    report_.deviate(texture->place, fmt::format("{} of a number is not rendered", texture->description()),
                    "takes 1 instead");
    return result;
  }
  texture->reportUnused(report_);
  return result;
}

Textures::Bitmap Textures::loadBitmap(const Object& texture) {
  Bitmap result;
  scene::TextureReference& reference = result.reference;
  setMap(texture, reference);
  const std::string filter = texture.text("filter_type", "bilinear");
  reference.filter = filter == "nearest" ? scene::TextureFilter::nearest : scene::TextureFilter::linear;
  const bool isKnown = filter == "nearest" || filter == "bilinear" || filter == "trilinear" || filter == "ewa";
  if (!isKnown) throw PlacedError{texture.place, fmt::format("{} is no filter: nearest or bilinear", quote(filter))};
  const std::string mode = texture.text("wrap_mode", "repeat");
  const auto wrapS = wrapOf(texture.text("wrap_mode_u", mode));
  const auto wrapT = wrapOf(texture.text("wrap_mode_v", mode));
  if (!wrapS || !wrapT) throw PlacedError{texture.place, "the wrap mode is none of repeat, mirror and clamp"};
  reference.wrapS = *wrapS;
  reference.wrapT = *wrapT;
  texture.ignore({"format", "accel", "max_anisotropy", "cache"}, report_);
  texture.omit({"gamma", "channel"}, report_);
  result.isRaw = texture.flag("raw", false);
  const Property* const name = texture.find("filename");
  if (!name) throw PlacedError{texture.place, "the bitmap has no \"filename\""};
  const std::filesystem::path path = findFile(texture.text("filename", ""), *texture.place.document, description_,
                                              file_.folder);
  result.source = load(path, texture);
  result.path = path.string();
  return result;
}

Texture Textures::readBitmap(const Object& texture, Encoding encoding) {
  auto [source, reference, isRaw, path] = loadBitmap(texture);
  if (!source) return {};
  const std::string key = fmt::format("{} {} {}", static_cast<int>(encoding), isRaw, path);
  const auto known = stored_.find(key);
  if (known != stored_.end()) {
    reference.image = known->second.first;
    return {glm::dvec3(known->second.second), reference};
  }
  const scene::TextureImage& image = source->image;
  const bool isAsStored = !source->isFloat() && (isRaw ? encoding == Encoding::linear : encoding == Encoding::srgb);
  double factor = 1;
  if (isAsStored) {
    reference.image = store(image);
  } else {
    scene::TextureImage converted{image.name, image.width, image.height, {}};
    for (const glm::vec3& value : source->values)
      factor = std::max({factor, double{value.x}, double{value.y}, double{value.z}});
    if (factor > 1 && encoding != Encoding::srgb && encoding != Encoding::height) factor = 1;
    converted.deepTexels.reserve(sizeOf(image));
    for (std::size_t i = 0; i < sizeOf(image); ++i)
      converted.deepTexels.push_back(encoded(source->valueAt(i, isRaw) / factor, encoding));
    reference.image = store(std::move(converted));
  }
  stored_[key] = {reference.image, factor};
  return {glm::dvec3(factor), reference};
}

glm::dvec3 Textures::Source::valueAt(std::size_t i, bool isRaw) const {
  if (isFloat()) return glm::dvec3(values[i]);
  return isRaw ? signalAt(image, i) : decoded(signalAt(image, i));
}

// Two by two texels. Where a number is needed instead of a colour, Mitsuba exchanges the colours.
Textures::Checkerboard Textures::checkerboardOf(const Object& texture, ColourUse use, bool isNumber) {
  Checkerboard result;
  setMap(texture, result.reference);
  result.reference.filter = scene::TextureFilter::nearest;
  const auto colour = [&](const char* name, double absent) {
    const Property* const property = texture.find(name);
    return property ? colourOf(*property, use, report_) : glm::dvec3(absent);
  };
  result.even = colour("color0", 0.4);
  result.odd = colour("color1", 0.2);
  if (isNumber) std::swap(result.even, result.odd);
  const glm::dvec3 even = result.even, odd = result.odd;
  result.name = fmt::format("checkerboard {} {} {} {} {} {}", even.x, even.y, even.z, odd.x, odd.y, odd.z);
  return result;
}

Texture Textures::readCheckerboard(const Object& texture, ColourUse use, Encoding encoding) {
  const bool isNumber = encoding != Encoding::srgb && encoding != Encoding::linear;
  auto [reference, even, odd, name] = checkerboardOf(texture, use, isNumber);
  const double largest = std::max({even.x, even.y, even.z, odd.x, odd.y, odd.z});
  const double factor = encoding == Encoding::srgb && largest > 1 ? largest : 1;
  const std::uint64_t a = encoded(even / factor, encoding), b = encoded(odd / factor, encoding);
  reference.image = storeMade(fmt::format("{} {}", static_cast<int>(encoding), name),
                              {"checkerboard", 2, 2, {}, {a, b, b, a}});
  return {glm::dvec3(factor), reference};
}

Texture Textures::readAttribute(const Object& texture, Encoding encoding) {
  const std::string name = texture.text("name", "");
  const double scale = texture.number("scale", 1);
  const bool isOfFaces = name.starts_with("face_");
  if (!isOfFaces && !name.starts_with("vertex_")) {
    throw PlacedError{texture.place,
                      fmt::format("the attribute {} begins neither with \"vertex_\" nor with \"face_\"", quote(name))};
  }
  if (encoding != Encoding::srgb && encoding != Encoding::alpha) {
    report_.deviate(texture.place,
                    fmt::format("the attribute {} is rendered as a colour, a weight or an opacity alone", quote(name)),
                    "renders white instead");
    return {};
  }
  const MeshAttribute attribute{isOfFaces, name.substr(name.find('_') + 1), encoding == Encoding::alpha};
  return {glm::dvec3(scale), {}, attribute};
}

const Textures::Source* Textures::load(const std::filesystem::path& path, const Object& texture) {
  const auto known = sources_.find(path.string());
  if (known != sources_.end()) return known->second ? &*known->second : nullptr;
  std::optional<Source>& source = sources_[path.string()];
  try {
    guard_.require(path);
    const std::string extension = extensionOf(path);
    const std::string bytes = scene::readFile(path);
    hashes_.push_back(fnv1aOfText(bytes));
    Source read;
    if (extension == ".exr" || extension == ".hdr" || extension == ".rgbe" || extension == ".pfm") {
      image::Image image = image::readImage(path);
      read.image = {path.filename().string(), image.width, image.height, {}};
      requireMemory(path.string() + ": the texture", byteCount_ + 24 * sizeOf(read.image),
                    "use a machine with more memory");
      read.values = std::move(image.rgb);
      for (glm::vec3& value : read.values) {
        value = glm::clamp(value, 0.0f, 1e30f);
        for (int c = 0; c < 3; ++c) value[c] = std::isfinite(value[c]) ? value[c] : 0;
      }
    } else {
      image::Texels texels = image::decodeModelTexels(std::as_bytes(std::span(bytes)));
      read.image = {path.filename().string(), texels.width, texels.height, std::move(texels.rgba),
                    std::move(texels.deepRgba)};
    }
    source = std::move(read);
  } catch (const FileError& error) {
    report_.deviate(texture.place, fmt::format("image {}: {}", quote(path.filename().string()), error.what()),
                    kLeftOut);
    return nullptr;
  }
  return &*source;
}

std::uint32_t Textures::store(scene::TextureImage image) {
  byteCount_ += sizeOf(image) * (image.isDeep() ? sizeof(std::uint64_t) : sizeof(std::uint32_t));
  requireMemory(image.name + ": with this image, the scene", byteCount_, "use a machine with more memory");
  images_.push_back(std::move(image));
  return static_cast<std::uint32_t>(images_.size() - 1);
}

std::uint32_t Textures::storeMade(const std::string& name, scene::TextureImage image) {
  const auto known = stored_.find(name);
  if (known != stored_.end()) return known->second.first;
  const std::uint32_t index = store(std::move(image));
  stored_[name] = {index, 1};
  return index;
}

std::uint64_t Textures::hashFiles(std::uint64_t hash) const {
  for (const std::uint64_t file : hashes_) hash = fnv1aOfText(fmt::format("image {:x}", file), hash);
  return hash;
}

}  // namespace candela::mitsuba
