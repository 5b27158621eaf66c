// The part of a film file before its blocks, checked byte by byte before OpenEXR reads it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace candela::film {

/// Columns and rows of the full image, both ends included, as OpenEXR stores a rectangle.
struct ExrBox {
  std::int32_t minX = 0, minY = 0, maxX = -1, maxY = -1;

  bool operator==(const ExrBox&) const = default;
};

struct FilmHead {
  std::size_t headerBytes = 0;  ///< of the OpenEXR header; the table of blocks follows
  ExrBox dataWindow, displayWindow;
  std::string description;      ///< kFilmAttribute
  std::string blockChecks;      ///< kBlocksAttribute
  std::string check;            ///< kCheckAttribute
  std::size_t checkOffset = 0;  ///< of its digits
};

/// Longest head that is read: enough for the description of kMaxBoxes boxes, of at most 48 bytes each.
inline constexpr std::size_t kMaxHeadBytes = std::size_t{8} << 20;

/// Reads the OpenEXR header at the start of `bytes`, which may end anywhere after it. Throws FileError, without the
/// name of the file, if it is not that of a film file.
FilmHead parseHead(std::span<const std::byte> bytes);

}  // namespace candela::film
