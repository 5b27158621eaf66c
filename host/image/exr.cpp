// OpenEXR files: linear values with variance, sample counts and metadata.
#include <ImathBox.h>
#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <cstring>

#include "host/core/errors.h"
#include "host/image/codecs.h"

namespace candela {
namespace {

constexpr int kNoThreads = 0;
constexpr const char* kVarianceChannel = "variance.Y";
constexpr const char* kSamplesChannel = "samples";

class MemoryInput : public Imf::IStream {
 public:
  explicit MemoryInput(ByteView bytes) : Imf::IStream("memory"), bytes_(bytes) {}

  bool read(char* target, int count) override {
    const auto wanted = static_cast<std::size_t>(count);
    if (count < 0 || position_ > bytes_.size() || wanted > bytes_.size() - position_) {
      throw Iex::InputExc("the file is cut short");
    }
    std::memcpy(target, bytes_.data() + position_, wanted);
    position_ += wanted;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  ByteView bytes_;
  std::uint64_t position_ = 0;
};

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

/// Names of string attributes that belong to the format, not to the picture.
bool isFormatAttribute(const std::string& name) { return name == "type" || name == "name" || name == "view"; }

/// A frame buffer for one image. OpenEXR takes pointers to non-const also where it only reads.
class PixelAccess {
 public:
  PixelAccess(const Image& image, const Imath::Box2i& window) : image_(image), window_(window) {}

  void addRgb(const char* name, std::size_t component) {
    add(name, Imf::FLOAT, &image_.rgb.data()->x + component, sizeof(glm::vec3));
  }
  void addVariance() { add(kVarianceChannel, Imf::FLOAT, image_.luminanceVariance.data(), sizeof(float)); }
  void addSamples() { add(kSamplesChannel, Imf::UINT, image_.sampleCounts.data(), sizeof(std::uint32_t)); }
  const Imf::FrameBuffer& frameBuffer() const { return frameBuffer_; }

 private:
  void add(const char* name, Imf::PixelType type, const void* first, std::size_t stride) {
    frameBuffer_.insert(name, Imf::Slice::Make(type, first, window_, stride, stride * image_.width));
  }

  const Image& image_;
  Imath::Box2i window_;
  Imf::FrameBuffer frameBuffer_;
};

Imf::Header makeHeader(const Image& image) {
  Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities());  // the default is Rec. 709
  for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  if (!image.luminanceVariance.empty()) header.channels().insert(kVarianceChannel, Imf::Channel(Imf::FLOAT));
  if (!image.sampleCounts.empty()) header.channels().insert(kSamplesChannel, Imf::Channel(Imf::UINT));
  for (const auto& [name, value] : image.metadata) {
    if (isFormatAttribute(name) || header.find(name.c_str()) != header.end()) {
      throw FileError(fmt::format("EXR files reserve the metadata name \"{}\"", name));
    }
    header.insert(name.c_str(), Imf::StringAttribute(value));
  }
  return header;
}

/// Limits what OpenEXR allocates while it opens a file, before checkImageSize can see the size.
void limitSizes() {
  static const bool limited = [] {
    constexpr auto kSide = static_cast<int>(kMaximumImageSide);
    Imf::Header::setMaxImageSize(kSide, kSide);
    Imf::Header::setMaxTileSize(kSide, kSide);
    return true;
  }();
  static_cast<void>(limited);
}

Imath::Box2i checkedWindow(const Imf::Header& header) {
  const Imath::Box2i window = header.dataWindow();
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
  const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
  if (width < 1 || height < 1) throw FileError("the data window is empty");
  checkImageSize(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
  return window;
}

bool hasChannel(const Imf::Header& header, const char* name) {
  const Imf::Channel* channel = header.channels().findChannel(name);
  return channel && channel->xSampling == 1 && channel->ySampling == 1;
}

/// Maps the file's colour channels to the image's.
void addColour(const Imf::Header& header, PixelAccess& access) {
  if (hasChannel(header, "R") && hasChannel(header, "G") && hasChannel(header, "B")) {
    access.addRgb("R", 0);
    access.addRgb("G", 1);
    access.addRgb("B", 2);
    return;
  }
  const bool hasChroma = header.channels().findChannel("RY") || header.channels().findChannel("BY");
  if (!hasChannel(header, "Y") || hasChroma) {
    throw FileError("the EXR file has neither the channels R, G and B nor Y alone, each at full resolution");
  }
  access.addRgb("Y", 0);
}

std::map<std::string, std::string> metadataOf(const Imf::Header& header) {
  std::map<std::string, std::string> metadata;
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
    if (isFormatAttribute(attribute.name())) continue;
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
    if (text) metadata[attribute.name()] = text->value();
  }
  return metadata;
}

Image decode(ByteView bytes) {
  limitSizes();
  MemoryInput input(bytes);
  Imf::InputFile file(input, kNoThreads);
  const Imf::Header& header = file.header();
  if (header.hasType() && Imf::isDeepData(header.type())) throw FileError("deep EXR files are not read");
  const Imath::Box2i window = checkedWindow(header);

  Image image;
  image.width = static_cast<std::uint32_t>(window.max.x - window.min.x + 1);
  image.height = static_cast<std::uint32_t>(window.max.y - window.min.y + 1);
  const std::size_t pixelCount = std::size_t{image.width} * image.height;
  image.rgb.resize(pixelCount);
  if (hasChannel(header, kVarianceChannel)) image.luminanceVariance.resize(pixelCount);
  if (hasChannel(header, kSamplesChannel)) image.sampleCounts.resize(pixelCount);
  image.metadata = metadataOf(header);

  PixelAccess access(image, window);
  addColour(header, access);
  if (!image.luminanceVariance.empty()) access.addVariance();
  if (!image.sampleCounts.empty()) access.addSamples();
  file.setFrameBuffer(access.frameBuffer());
  file.readPixels(window.min.y, window.max.y);
  if (!hasChannel(header, "R")) {
    for (glm::vec3& pixel : image.rgb) pixel = glm::vec3(pixel.x);
  }
  return image;
}

Bytes encode(const Image& image) {
  const Imf::Header header = makeHeader(image);
  PixelAccess access(image, header.dataWindow());
  access.addRgb("R", 0);
  access.addRgb("G", 1);
  access.addRgb("B", 2);
  if (!image.luminanceVariance.empty()) access.addVariance();
  if (!image.sampleCounts.empty()) access.addSamples();
  MemoryOutput output;
  {
    Imf::OutputFile file(output, header, kNoThreads);  // its destructor writes the table of offsets
    file.setFrameBuffer(access.frameBuffer());
    file.writePixels(static_cast<int>(image.height));
  }
  return output.takeBytes();
}

}  // namespace

Image decodeExr(ByteView file) try { return decode(file); } catch (const Iex::BaseExc& error) {
  throw FileError(fmt::format("not a valid EXR file: {}", error.what()));
}

Bytes encodeExr(const Image& image) try { return encode(image); } catch (const Iex::BaseExc& error) {
  throw FileError(fmt::format("the EXR file cannot be made: {}", error.what()));
}

}  // namespace candela
