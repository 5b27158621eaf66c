// Writes OpenEXR files: linear values with variance, counts and metadata.
#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "host/base/errors.h"
#include "host/image/codecs.h"
#include "host/image/exr_pixels.h"

namespace candela::image {
namespace {

class MemoryOutput : public Imf::OStream {
 public:
  MemoryOutput() : Imf::OStream("memory") {}

  void write(const char* source, int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (bytes_.size() < position_ + size) bytes_.resize(position_ + size);
    std::memcpy(bytes_.data() + position_, source, size);
    position_ += size;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }
  Bytes takeBytes() { return std::move(bytes_); }

 private:
  Bytes bytes_;
  std::uint64_t position_ = 0;
};

/// Throws FileError if a coordinate is beyond those that OpenEXR accepts.
Imath::Box2i boxOf(const PixelBox& box) {
  constexpr std::int64_t kMaxCoordinate = std::int64_t{1} << 29;
  if (std::min(box.x, box.y) < -kMaxCoordinate || std::max(box.x + box.width, box.y + box.height) > kMaxCoordinate) {
    throw FileError(fmt::format("the window {} is too far from the origin for an EXR file", boxText(box)));
  }
  const auto at = [](std::int64_t x, std::int64_t y) { return Imath::V2i(static_cast<int>(x), static_cast<int>(y)); };
  return {at(box.x, box.y), at(box.x + box.width - 1, box.y + box.height - 1)};
}

Imf::Header makeHeader(const Image& image) {
  Imf::Header header(boxOf(frameOf(image)), boxOf(windowOf(image)));
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities());  // the default is Rec. 709
  for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  if (!image.alpha.empty()) header.channels().insert(kAlphaChannel, Imf::Channel(Imf::FLOAT));
  if (!image.luminanceVariance.empty()) header.channels().insert(kVarianceChannel, Imf::Channel(Imf::FLOAT));
  if (!image.sampleCounts.empty()) header.channels().insert(kSamplesChannel, Imf::Channel(Imf::UINT));
  if (!image.badSampleCounts.empty()) header.channels().insert(kBadSamplesChannel, Imf::Channel(Imf::UINT));
  for (const Channel& channel : image.channels) header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
  for (const auto& [name, value] : image.metadata) {
    if (isExrFormatAttribute(name) || header.find(name.c_str()) != header.end()) {
      throw FileError(fmt::format("EXR files reserve the metadata name \"{}\"", name));
    }
    header.insert(name.c_str(), Imf::StringAttribute(value));
  }
  return header;
}

Bytes encode(const Image& image) {
  const Imf::Header header = makeHeader(image);
  ExrPixels pixels(image, header.dataWindow());
  pixels.addRgb("R", 0);
  pixels.addRgb("G", 1);
  pixels.addRgb("B", 2);
  if (!image.alpha.empty()) pixels.addAlpha();
  if (!image.luminanceVariance.empty()) pixels.addVariance();
  if (!image.sampleCounts.empty()) pixels.addSamples();
  if (!image.badSampleCounts.empty()) pixels.addBadSamples();
  for (const Channel& channel : image.channels) pixels.addChannel(channel);
  MemoryOutput output;
  {
    Imf::OutputFile file(output, header, kNoExrThreads);  // its destructor writes the table of offsets
    file.setFrameBuffer(pixels.frameBuffer());
    file.writePixels(static_cast<int>(image.height));
  }
  return output.takeBytes();
}

}  // namespace

Bytes encodeExr(const Image& image) try { return encode(image); } catch (const Iex::BaseExc& error) {
  throw FileError(fmt::format("cannot encode the EXR file: {}", error.what()));
}

}  // namespace candela::image
