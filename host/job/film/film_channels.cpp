// Lists the channels of a film file, and describes where OpenEXR finds their words in memory.
#include "host/job/film/film_channels.h"

namespace candela::film {

ChannelChoice channelsOf(const FilmHeader& header) {
  return {header.hasAlpha(), image::layerSumsOf(header.layers), header.matteSlots};
}

std::vector<LayerWordChannel> layerWordChannels(std::uint32_t sums) {
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

std::vector<std::string> matteChannelNames(const ChannelChoice& choice) {
  std::vector<std::string> names;
  for (const image::MatteKind kind : image::kMatteKinds) {
    const std::string prefix = kind == image::MatteKind::object ? "id.object." : "id.material.";
    for (std::uint32_t slot = 0; slot < choice.matteSlots[static_cast<std::size_t>(kind)]; ++slot) {
      for (const char* const suffix : {".id", ".count"}) names.push_back(prefix + std::to_string(slot) + suffix);
    }
  }
  return names;
}

std::vector<WordChannel> wordChannels(bool hasAlpha) {
  std::vector<WordChannel> channels(kWordChannels.begin(), kWordChannels.end());
  if (hasAlpha) channels.push_back(kHitChannel);
  return channels;
}

std::vector<PictureChannel> pictureChannels(bool hasAlpha) {
  std::vector<PictureChannel> channels(kPictureChannels.begin(), kPictureChannels.end());
  if (hasAlpha) channels.push_back(kAlphaChannel);
  return channels;
}

std::size_t pixelBytes(const ChannelChoice& choice) {
  const std::size_t layerWords = choice.sums == 0 ? 0 : 2 + 3 * (choice.layerRows() - 1);
  return 4 * (kWordChannels.size() + kPictureChannels.size() + (choice.hasAlpha ? 2 : 0) + layerWords +
              2 * choice.slotCount());
}

Imf::ChannelList filmChannels(const ChannelChoice& choice) {
  const Imf::Channel real(Imf::FLOAT), word(Imf::UINT);
  Imf::ChannelList list;
  for (const PictureChannel& channel : pictureChannels(choice.hasAlpha)) list.insert(channel.name, real);
  for (const WordChannel& channel : wordChannels(choice.hasAlpha)) list.insert(channel.name, word);
  for (const LayerWordChannel& channel : layerWordChannels(choice.sums)) list.insert(channel.name, word);
  for (const std::string& name : matteChannelNames(choice)) list.insert(name, word);
  return list;
}

void addWords(Imf::FrameBuffer& buffer, const image::FilmPixel* pixels, const Imath::Box2i& window, bool hasAlpha) {
  const auto width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
  for (const WordChannel& channel : wordChannels(hasAlpha)) {
    const std::byte* const first = reinterpret_cast<const std::byte*>(pixels) + channel.offset;
    buffer.insert(channel.name, Imf::Slice::Make(Imf::UINT, first, window, sizeof *pixels, width * sizeof *pixels));
  }
}

void addLayerWords(Imf::FrameBuffer& buffer, const image::LayerRow* rows, const Imath::Box2i& window,
                   const ChannelChoice& choice) {
  const std::size_t pixelStride = choice.layerRows() * sizeof *rows;
  const std::size_t rowStride = static_cast<std::size_t>(window.max.x - window.min.x + 1) * pixelStride;
  for (const LayerWordChannel& channel : layerWordChannels(choice.sums)) {
    const std::byte* const first = reinterpret_cast<const std::byte*>(rows) + channel.offset;
    buffer.insert(channel.name, Imf::Slice::Make(Imf::UINT, first, window, pixelStride, rowStride));
  }
}

void addMatteWords(Imf::FrameBuffer& buffer, const std::uint32_t* words, const Imath::Box2i& window,
                   const ChannelChoice& choice) {
  const std::size_t pixelStride = 2 * choice.slotCount() * sizeof *words;
  const std::size_t rowStride = static_cast<std::size_t>(window.max.x - window.min.x + 1) * pixelStride;
  for (const std::string& name : matteChannelNames(choice)) {
    buffer.insert(name, Imf::Slice::Make(Imf::UINT, words++, window, pixelStride, rowStride));
  }
}

}  // namespace candela::film
