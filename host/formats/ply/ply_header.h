// The header of a PLY file (Turk, "The PLY Polygon File Format", 1994): its encoding, elements and properties.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/loading/loader.h"

namespace candela::ply {

enum class Encoding : std::uint8_t { ascii, littleEndian, bigEndian };

enum class NumberType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

inline bool isInteger(NumberType type) { return type < NumberType::float32; }
/// Returns the size of a binary number in bytes.
inline std::size_t sizeOf(NumberType type) {
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}
/// Returns the largest and the smallest value of an integer type.
inline std::int64_t maxOf(NumberType type) {
  constexpr std::array<std::int64_t, 6> kMax{127, 255, 32767, 65535, 2147483647, 4294967295};
  return kMax[static_cast<std::size_t>(type)];
}
inline std::int64_t minOf(NumberType type) {
  const bool isSigned = type == NumberType::int8 || type == NumberType::int16 || type == NumberType::int32;
  return isSigned ? -maxOf(type) - 1 : 0;
}
/// Returns the name that is used most: "uchar", "int", "float".
std::string_view nameOf(NumberType type);

struct Property {
  std::string name;
  NumberType type;                        ///< of the number, or of the numbers of a list
  std::optional<NumberType> countType{};  ///< of the length of a list; empty: one number
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties{};

  /// Returns the least number of bytes, or of values in a text, that one element takes.
  std::uint64_t minSize(Encoding encoding) const;
};

/// An image that a comment names: "comment TextureFile skin.png", as MeshLab and programs for photogrammetry write it.
struct TextureFile {
  std::string name;
  scene::Position position{};  ///< of the name
};

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements{};
  std::vector<TextureFile> textures{};
  std::size_t size = 0;  ///< offset of the data in the file
};

/// Returns whether the bytes begin with the word "ply" and a line end.
bool looksLikePly(std::string_view bytes);

/// Throws SceneError, with line and column, if the header is wrong, or states more elements than the file can contain.
Header readHeader(const scene::SceneFile& file);

}  // namespace candela::ply
