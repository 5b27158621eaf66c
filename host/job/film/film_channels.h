// The channels of a film file: a picture, and the exact sums of the film as words of 32 bits.
#pragma once
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/image/film.h"
#include "host/job/film/film_header.h"

namespace candela::film {

/// Rows of an OpenEXR block of the compression that film files have (ZIP). Each block has a checksum.
inline constexpr std::uint32_t kBlockRows = 16;

/// The first row of a block and its size in bytes precede its content.
inline constexpr std::size_t kBlockHeadBytes = 8;

inline constexpr const char* kFilmAttribute = "candela.film";      ///< string: FilmHeader as JSON
inline constexpr const char* kBlocksAttribute = "candela.blocks";  ///< string: CRC-32 of each block, 8 digits each
inline constexpr const char* kCheckAttribute = "candela.check";    ///< string: CRC-32 of all before the first block
inline constexpr std::size_t kCheckDigits = 8;

/// A word of FilmPixel.
struct WordChannel {
  const char* name;
  std::size_t offset;
};

constexpr std::size_t wordOf(std::size_t offset, std::size_t word) { return offset + word * sizeof(std::uint32_t); }

inline constexpr std::array kWordChannels{
    WordChannel{"samples", offsetof(image::FilmPixel, sampleCount)},
    WordChannel{"badSamples", offsetof(image::FilmPixel, badCount)},
    WordChannel{"firstBadSample", offsetof(image::FilmPixel, firstBadSample)},
    WordChannel{"sum.R.0", wordOf(offsetof(image::FilmPixel, red), 0)},
    WordChannel{"sum.R.1", wordOf(offsetof(image::FilmPixel, red), 1)},
    WordChannel{"sum.R.2", wordOf(offsetof(image::FilmPixel, red), 2)},
    WordChannel{"sum.G.0", wordOf(offsetof(image::FilmPixel, green), 0)},
    WordChannel{"sum.G.1", wordOf(offsetof(image::FilmPixel, green), 1)},
    WordChannel{"sum.G.2", wordOf(offsetof(image::FilmPixel, green), 2)},
    WordChannel{"sum.B.0", wordOf(offsetof(image::FilmPixel, blue), 0)},
    WordChannel{"sum.B.1", wordOf(offsetof(image::FilmPixel, blue), 1)},
    WordChannel{"sum.B.2", wordOf(offsetof(image::FilmPixel, blue), 2)},
    WordChannel{"sum.YY.0", wordOf(offsetof(image::FilmPixel, luminanceSquared), 0)},
    WordChannel{"sum.YY.1", wordOf(offsetof(image::FilmPixel, luminanceSquared), 1)},
    WordChannel{"sum.YY.2", wordOf(offsetof(image::FilmPixel, luminanceSquared), 2)}};

/// Another channel of films with alpha.
inline constexpr WordChannel kHitChannel{"hits", offsetof(image::FilmPixel, hitCount)};

/// The picture: means and the variance of the luminance of one sample, as image::toImage() computes them.
struct PicturePixel {
  float red = 0, green = 0, blue = 0, variance = 0, alpha = 0;
};

struct PictureChannel {
  const char* name;
  std::size_t offset;
};

inline constexpr std::array kPictureChannels{
    PictureChannel{"R", offsetof(PicturePixel, red)}, PictureChannel{"G", offsetof(PicturePixel, green)},
    PictureChannel{"B", offsetof(PicturePixel, blue)}, PictureChannel{"variance.Y", offsetof(PicturePixel, variance)}};

/// Another channel of films with alpha.
inline constexpr PictureChannel kAlphaChannel{"A", offsetof(PicturePixel, alpha)};

/// The channels that depend on the film.
struct ChannelChoice {
  bool hasAlpha = false;
  std::uint32_t sums = 0;  ///< of layers, as image::layerSumsOf() returns them
  std::array<std::uint32_t, image::kMatteKinds.size()> matteSlots{};  ///< of FilmHeader

  std::size_t slotCount() const { return std::size_t{matteSlots[0]} + matteSlots[1]; }
  std::size_t layerRows() const { return image::layerRowCount(sums); }
};

ChannelChoice channelsOf(const FilmHeader& header);

/// A word of the records of layers of a pixel.
struct LayerWordChannel {
  std::string name;
  std::size_t offset;  ///< from the pixel's first record
};

std::vector<LayerWordChannel> layerWordChannels(std::uint32_t sums);

/// The names of the channels of mattes: the id and the count of each slot, first those of objects.
std::vector<std::string> matteChannelNames(const ChannelChoice& choice);

std::vector<WordChannel> wordChannels(bool hasAlpha);

std::vector<PictureChannel> pictureChannels(bool hasAlpha);

/// Bytes of a pixel in a block that is not compressed.
std::size_t pixelBytes(const ChannelChoice& choice);

Imf::ChannelList filmChannels(const ChannelChoice& choice);

/// Adds the words of `pixels`, which are the rows of `window` from its top on. OpenEXR takes pointers to non-const even
/// where it only reads.
void addWords(Imf::FrameBuffer& buffer, const image::FilmPixel* pixels, const Imath::Box2i& window, bool hasAlpha);

/// Adds the words of the records of layers, which are those of the rows of `window`.
void addLayerWords(Imf::FrameBuffer& buffer, const image::LayerRow* rows, const Imath::Box2i& window,
                   const ChannelChoice& choice);

/// Adds the words of mattes: for each pixel of `window`, two for each slot.
void addMatteWords(Imf::FrameBuffer& buffer, const std::uint32_t* words, const Imath::Box2i& window,
                   const ChannelChoice& choice);

}  // namespace candela::film
