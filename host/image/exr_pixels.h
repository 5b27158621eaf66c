// Channel names and the frame buffer, used for reading and writing EXR files.
#pragma once
#include <ImathBox.h>
#include <OpenEXR/ImfFrameBuffer.h>

#include <string_view>

#include "host/image/image.h"

namespace candela::image {

inline constexpr int kNoExrThreads = 0;
inline constexpr const char* kAlphaChannel = "A";
inline constexpr const char* kVarianceChannel = "variance.Y";
inline constexpr const char* kSamplesChannel = "samples";
inline constexpr const char* kBadSamplesChannel = "badSamples";

/// Returns whether a string attribute belongs to the file format rather than to the image.
inline bool isExrFormatAttribute(std::string_view name) { return name == "type" || name == "name" || name == "view"; }

/// Returns a frame buffer for an image. OpenEXR takes pointers to non-const even where it only reads.
class ExrPixels {
 public:
  ExrPixels(const Image& image, const Imath::Box2i& window) : image_(image), window_(window) {}

  void addRgb(const char* name, std::size_t component) {
    add(name, Imf::FLOAT, &image_.rgb.data()->x + component, sizeof(glm::vec3));
  }
  void addAlpha(const char* name = kAlphaChannel) { add(name, Imf::FLOAT, image_.alpha.data(), sizeof(float)); }
  void addVariance() { add(kVarianceChannel, Imf::FLOAT, image_.luminanceVariance.data(), sizeof(float)); }
  void addSamples() { add(kSamplesChannel, Imf::UINT, image_.sampleCounts.data(), sizeof(std::uint32_t)); }
  void addBadSamples() { add(kBadSamplesChannel, Imf::UINT, image_.badSampleCounts.data(), sizeof(std::uint32_t)); }
  /// `type` is FLOAT or UINT, which have equal sizes.
  void addChannel(const Channel& channel, Imf::PixelType type = Imf::FLOAT) {
    add(channel.name.c_str(), type, channel.values.data(), sizeof(float));
  }
  const Imf::FrameBuffer& frameBuffer() const { return frameBuffer_; }

 private:
  void add(const char* name, Imf::PixelType type, const void* first, std::size_t stride) {
    frameBuffer_.insert(name, Imf::Slice::Make(type, first, window_, stride, stride * image_.width));
  }

  const Image& image_;
  Imath::Box2i window_;
  Imf::FrameBuffer frameBuffer_;
};

}  // namespace candela::image
