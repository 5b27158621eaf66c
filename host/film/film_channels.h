// The channels of a film file: a picture, and the exact sums of the film as words of 32 bits.
#pragma once
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/film/film_header.h"
#include "host/image/film.h"

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

inline ChannelChoice channelsOf(const FilmHeader& header) {
  return {header.hasAlpha(), image::layerSumsOf(header.layers), header.matteSlots};
}

/// A word of the records of layers of a pixel.
struct LayerWordChannel {
  std::string name;
  std::size_t offset;  ///< from the pixel's first record
};

inline std::vector<LayerWordChannel> layerWordChannels(std::uint32_t sums) {
  if (sums == 0) return {};
  std::vector<LayerWordChannel> channels{{"layerHits", 0}, {"badLayerSamples", sizeof(std::uint32_t)}};
  const std::vector<std::string> names = image::layerSumNames(sums);
  for (std::size_t row = 0; row < names.size(); ++row) {
    for (std::size_t word = 0; word < 3; ++word) {
      const std::string name = "sum." + names[row] + '.' + static_cast<char>('0' + word);
      channels.push_back({name, wordOf((1 + row) * sizeof(image::LayerRow), word)});
    }
  }
  return channels;
}

/// The names of the channels of mattes: the id and the count of each slot, first those of objects.
inline std::vector<std::string> matteChannelNames(const ChannelChoice& choice) {
  std::vector<std::string> names;
  for (const image::MatteKind kind : image::kMatteKinds) {
    const std::string prefix = kind == image::MatteKind::object ? "id.object." : "id.material.";
    for (std::uint32_t slot = 0; slot < choice.matteSlots[static_cast<std::size_t>(kind)]; ++slot) {
      for (const char* const suffix : {".id", ".count"}) names.push_back(prefix + std::to_string(slot) + suffix);
    }
  }
  return names;
}

inline std::vector<WordChannel> wordChannels(bool hasAlpha) {
  std::vector<WordChannel> channels(kWordChannels.begin(), kWordChannels.end());
  if (hasAlpha) channels.push_back(kHitChannel);
  return channels;
}

inline std::vector<PictureChannel> pictureChannels(bool hasAlpha) {
  std::vector<PictureChannel> channels(kPictureChannels.begin(), kPictureChannels.end());
  if (hasAlpha) channels.push_back(kAlphaChannel);
  return channels;
}

/// Bytes of a pixel in a block that is not compressed.
inline std::size_t pixelBytes(const ChannelChoice& choice) {
  const std::size_t layerWords = choice.sums == 0 ? 0 : 2 + 3 * (choice.layerRows() - 1);
  return 4 * (kWordChannels.size() + kPictureChannels.size() + (choice.hasAlpha ? 2 : 0) + layerWords +
              2 * choice.slotCount());
}

inline Imf::ChannelList filmChannels(const ChannelChoice& choice) {
  const Imf::Channel real(Imf::FLOAT), word(Imf::UINT);
  Imf::ChannelList list;
  for (const PictureChannel& channel : pictureChannels(choice.hasAlpha)) list.insert(channel.name, real);
  for (const WordChannel& channel : wordChannels(choice.hasAlpha)) list.insert(channel.name, word);
  for (const LayerWordChannel& channel : layerWordChannels(choice.sums)) list.insert(channel.name, word);
  for (const std::string& name : matteChannelNames(choice)) list.insert(name, word);
  return list;
}

/// Adds the words of `pixels`, which are the rows of `window` from its top on. OpenEXR takes pointers to non-const even
/// where it only reads.
inline void addWords(Imf::FrameBuffer& buffer, const image::FilmPixel* pixels, const Imath::Box2i& window,
                     bool hasAlpha) {
  const auto width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
  for (const WordChannel& channel : wordChannels(hasAlpha)) {
    const std::byte* const first = reinterpret_cast<const std::byte*>(pixels) + channel.offset;
    buffer.insert(channel.name, Imf::Slice::Make(Imf::UINT, first, window, sizeof *pixels, width * sizeof *pixels));
  }
}

/// Adds the words of the records of layers, which are those of the rows of `window`.
inline void addLayerWords(Imf::FrameBuffer& buffer, const image::LayerRow* rows, const Imath::Box2i& window,
                          const ChannelChoice& choice) {
  const std::size_t pixelStride = choice.layerRows() * sizeof *rows;
  const std::size_t rowStride = static_cast<std::size_t>(window.max.x - window.min.x + 1) * pixelStride;
  for (const LayerWordChannel& channel : layerWordChannels(choice.sums)) {
    const std::byte* const first = reinterpret_cast<const std::byte*>(rows) + channel.offset;
    buffer.insert(channel.name, Imf::Slice::Make(Imf::UINT, first, window, pixelStride, rowStride));
  }
}

/// Adds the words of mattes: for each pixel of `window`, two for each slot.
inline void addMatteWords(Imf::FrameBuffer& buffer, const std::uint32_t* words, const Imath::Box2i& window,
                          const ChannelChoice& choice) {
  const std::size_t pixelStride = 2 * choice.slotCount() * sizeof *words;
  const std::size_t rowStride = static_cast<std::size_t>(window.max.x - window.min.x + 1) * pixelStride;
  for (const std::string& name : matteChannelNames(choice)) {
    buffer.insert(name, Imf::Slice::Make(Imf::UINT, words++, window, pixelStride, rowStride));
  }
}

}  // namespace candela::film
