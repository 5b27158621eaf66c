// Reads the attributes of an OpenEXR header (its format: "OpenEXR File Layout", openexr.com).
#include "host/job/film/film_head.h"

#include <cstring>
#include <map>
#include <string_view>

#include "host/base/errors.h"
#include "host/base/setting_words.h"
#include "host/image/byte_cursor.h"
#include "host/image/exr_attribute.h"
#include "host/job/film/film_channels.h"

namespace candela::film {
namespace {

constexpr std::uint32_t kMagic = 20000630;
constexpr std::uint32_t kVersion = 2;  // a single part of scan lines, and no name is longer than 31 characters

struct Attribute {
  std::string_view type;
  std::span<const std::byte> value;
};
using Attributes = std::map<std::string_view, Attribute>;

Attributes takeAttributes(image::ByteCursor& cursor) {
  const auto isNul = [](char c) { return c == 0; };
  Attributes attributes;
  while (true) {
    const std::string_view name = cursor.takeUntil(isNul);
    if (name.empty()) return attributes;
    const std::string_view type = cursor.takeUntil(isNul);
    const std::uint32_t size = cursor.takeWord();
    const std::span<const std::byte> value = cursor.take(size);
    image::requireExrAttribute(type, value);
    if (!attributes.emplace(name, Attribute{type, value}).second) {
      throw FileError("an attribute occurs twice");
    }
  }
}

const Attribute& attributeAt(const Attributes& attributes, const char* name, std::string_view type) {
  const auto found = attributes.find(name);
  if (found == attributes.end() || found->second.type != type) {
    throw FileError(std::string("there is no attribute \"") + name + "\"");
  }
  return found->second;
}

std::string stringAt(const Attributes& attributes, const char* name) {
  const std::span<const std::byte> value = attributeAt(attributes, name, "string").value;
  return {reinterpret_cast<const char*>(value.data()), value.size()};
}

ExrBox boxAt(const Attributes& attributes, const char* name) {
  image::ByteCursor cursor(attributeAt(attributes, name, "box2i").value);
  ExrBox box;
  for (std::int32_t* const edge : {&box.minX, &box.minY, &box.maxX, &box.maxY}) {
    *edge = static_cast<std::int32_t>(cursor.takeWord());
  }
  return box;
}

}  // namespace

FilmHead parseHead(std::span<const std::byte> bytes) {
  image::ByteCursor cursor(bytes);
  if (bytes.size() < 8 || cursor.takeWord() != kMagic) throw FileError("this is not an OpenEXR file");
  if (cursor.takeWord() != kVersion) throw FileError("this OpenEXR file has tiles, several parts or deep data");
  const Attributes attributes = takeAttributes(cursor);
  if (!attributes.contains(kFilmAttribute)) {
    throw FileError(fmt::format("this OpenEXR file is a picture without the sums of a film; {} writes films",
                                settingWords("checkpoint")));
  }
  FilmHead head;
  head.headerBytes = bytes.size() - cursor.remaining();
  head.dataWindow = boxAt(attributes, "dataWindow");
  head.displayWindow = boxAt(attributes, "displayWindow");
  head.description = stringAt(attributes, kFilmAttribute);
  head.blockChecks = stringAt(attributes, kBlocksAttribute);
  head.check = stringAt(attributes, kCheckAttribute);
  if (head.check.size() != kCheckDigits) throw FileError("the checksum of the header has no 8 digits");
  head.checkOffset = static_cast<std::size_t>(attributes.at(kCheckAttribute).value.data() - bytes.data());
  return head;
}

}  // namespace candela::film
