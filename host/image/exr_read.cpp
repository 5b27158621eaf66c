// Reads OpenEXR files of any compression: colours and, if present, alpha, variance, counts and metadata.
#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

#include "host/base/errors.h"
#include "host/base/lower_case.h"
#include "host/image/byte_cursor.h"
#include "host/image/chromaticities.h"
#include "host/image/exr_attribute.h"
#include "host/image/exr_colours.h"
#include "host/image/exr_pixels.h"
#include "host/image/image.h"

namespace candela::image {
namespace {

constexpr std::array<std::string_view, 10> kNames{
    "R", "G", "B", "A", "samples", "hits", "layerHits", "badSamples", "badLayerSamples", "firstBadSample"};
constexpr std::array<std::string_view, 5> kPrefixes{"variance.", "sqrt.", "sum.", "id.object.", "id.material."};

/// Returns whether a channel has ids of the Cryptomatte layer `matte`: the first and the third channel of the files
/// `matte00`, `matte01` and so on, named as in R G B A or red green blue alpha.
bool isIdOf(std::string_view channel, std::string_view matte) {
  if (!channel.starts_with(matte)) return false;
  channel.remove_prefix(matte.size());
  if (channel.size() < 4 || !std::isdigit(static_cast<unsigned char>(channel[0])) ||
      !std::isdigit(static_cast<unsigned char>(channel[1])) || channel[2] != '.') {
    return false;
  }
  const std::string component = lowerCase(std::string(channel.substr(3)));
  return component == "r" || component == "red" || component == "b" || component == "blue";
}

bool isCryptomatteId(const Image& image, std::string_view channel) {
  return std::ranges::any_of(image.metadata, [&](const auto& entry) {
    const auto& [key, value] = entry;
    return key.starts_with("cryptomatte/") && key.ends_with("/name") && isIdOf(channel, value);
  });
}

/// Returns whether a channel belongs to the picture or to the statistics of a film, which are not layers: sums, counts
/// and variances of samples (docs/layers.md, docs/film-file.md).
bool isPictureOrStatistic(std::string_view name) {
  return std::ranges::find(kNames, name) != kNames.end() ||
         std::ranges::any_of(kPrefixes, [&](std::string_view prefix) { return name.starts_with(prefix); });
}

/// Adds the channels of the file's layers to the image, with room for `pixelCount` values each, except those that are
/// its picture. Integers and the ids of Cryptomatte are ids. Names of channels that do not have one value for each
/// pixel are added to `image.warnings`.
void addLayerChannels(const Imf::Header& header, const ExrColours& picture, std::size_t pixelCount, Image& image) {
  for (auto entry = header.channels().begin(); entry != header.channels().end(); ++entry) {
    const Imf::Channel& channel = entry.channel();
    const std::string name = entry.name();
    const bool isShown = name == picture.alpha || std::ranges::find(picture.names, name) != picture.names.end();
    if (isShown || isPictureOrStatistic(name)) continue;
    if (channel.xSampling != 1 || channel.ySampling != 1) {
      image.warnings.push_back(
          fmt::format("the channel \"{}\" is not read, since it does not have a value for each pixel", name));
      continue;
    }
    const bool isId = channel.type == Imf::UINT || isCryptomatteId(image, name);
    image.channels.push_back({name, std::vector<float>(pixelCount), isId});
  }
}

class MemoryInput : public Imf::IStream {
 public:
  explicit MemoryInput(ByteView bytes) : Imf::IStream("memory"), bytes_(bytes) {}

  bool read(char* target, int count) override {
    const auto wanted = static_cast<std::size_t>(count);
    if (count < 0 || position_ > bytes_.size() || wanted > bytes_.size() - position_) {
      throw Iex::InputExc("the file is truncated");
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

[[noreturn]] void refuseDeepFile() {
  throw FileError("deep EXR files are not read; flatten the file, for example by oiiotool --flatten");
}

/// Checks the header before OpenEXR reads it: deep files and files of several parts are refused, since their decoders
/// are the largest part of OpenEXR, and OpenEXR trusts the size of an attribute, up to 2 GiB, before it looks for the
/// bytes.
void checkHeader(ByteView bytes) {
  constexpr std::uint32_t kDeep = 0x800, kMultiPart = 0x1000;
  const auto isNul = [](char c) { return c == 0; };
  ByteCursor cursor(bytes);
  cursor.take(4);  // magic number
  const std::uint32_t flags = cursor.takeWord();
  if ((flags & kDeep) != 0) refuseDeepFile();
  if ((flags & kMultiPart) != 0)
    throw FileError("EXR files of several parts are not read; extract one, for example by oiiotool --subimage");
  while (!cursor.takeUntil(isNul).empty()) {  // an empty name ends the header
    const std::string_view type = cursor.takeUntil(isNul);
    requireExrAttribute(type, cursor.take(cursor.takeWord()));
  }
}

/// Limits the memory that OpenEXR allocates while it opens a file, before checkImageSize can check the size.
void limitSizes() {
  static const bool limited = [] {
    constexpr auto kSide = static_cast<int>(kMaxImageSide);
    Imf::Header::setMaxImageSize(kSide, kSide);
    Imf::Header::setMaxTileSize(kSide, kSide);
    return true;
  }();
  static_cast<void>(limited);
}

PixelBox boxOf(const Imath::Box2i& window) {
  return {window.min.x, window.min.y, std::int64_t{window.max.x} - window.min.x + 1,
          std::int64_t{window.max.y} - window.min.y + 1};
}

Imath::Box2i checkedWindow(const Imf::Header& header) {
  const Imath::Box2i window = header.dataWindow();
  const PixelBox box = boxOf(window);
  if (box.isEmpty()) throw FileError("the data window is empty");
  checkImageSize(static_cast<std::uint64_t>(box.width), static_cast<std::uint64_t>(box.height));
  return window;
}

/// Refuses files that claim more pixels than they can contain. Deflate expands one byte to at most 1032, the other
/// methods to fewer, and a pixel has at least two bytes for each channel. DWA stores at least a value of two bytes,
/// which it deflates, for each square of 8 x 8 pixels.
void checkPlausible(const Imf::Header& header, std::size_t pixelCount, std::size_t fileSize) {
  std::size_t channelCount = 0;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    if (channel.channel().xSampling == 1 && channel.channel().ySampling == 1) ++channelCount;
  }
  constexpr std::size_t kMaxPixelsPerByte = 1032 / 2;
  const Imf::Compression compression = header.compression();
  const bool isDwa = compression == Imf::DWAA_COMPRESSION || compression == Imf::DWAB_COMPRESSION;
  const std::size_t maximum = isDwa ? 64 * kMaxPixelsPerByte : kMaxPixelsPerByte;
  if (pixelCount * channelCount / maximum > fileSize) throw FileError("not a valid EXR file: it is truncated");
}

/// Maps the colour channels of the file to those of the image.
void addColours(const ExrColours& colours, ExrPixels& pixels) {
  for (std::size_t i = 0; i < colours.names.size(); ++i) pixels.addRgb(colours.names[i].c_str(), i);
}

/// Applies what the header says about the colours.
void finishColours(const Imf::Header& header, const ExrColours& colours, Image& image) {
  if (!colours.warning.empty()) image.warnings.push_back(colours.warning);
  if (colours.names.size() == 1) {
    for (glm::vec3& pixel : image.rgb) pixel = glm::vec3(pixel.x);
  } else if (Imf::hasChromaticities(header)) {
    const auto point = [](const Imath::V2f& xy) { return glm::dvec2(xy.x, xy.y); };
    const Imf::Chromaticities& space = Imf::chromaticities(header);
    convertToRec709({point(space.red), point(space.green), point(space.blue), point(space.white)}, image);
  }
}

std::map<std::string, std::string> metadataOf(const Imf::Header& header) {
  std::map<std::string, std::string> metadata;
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
    if (isExrFormatAttribute(attribute.name())) continue;
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
    if (text) metadata[attribute.name()] = text->value();
  }
  return metadata;
}

Image decode(ByteView bytes, ImageParts parts) {
  limitSizes();
  checkHeader(bytes);
  MemoryInput input(bytes);
  Imf::InputFile file(input, kNoExrThreads);
  const Imf::Header& header = file.header();
  if (header.hasType() && Imf::isDeepData(header.type())) refuseDeepFile();
  const Imath::Box2i window = checkedWindow(header);

  Image image;
  const PixelBox box = boxOf(window);
  image.width = static_cast<std::uint32_t>(box.width);
  image.height = static_cast<std::uint32_t>(box.height);
  image.origin = {box.x, box.y};
  image.frame = boxOf(header.displayWindow());
  const std::size_t pixelCount = std::size_t{image.width} * image.height;
  checkPlausible(header, pixelCount, bytes.size());
  image.rgb.resize(pixelCount);
  const ExrColours colours = chooseColours(header);
  const auto isHalf = [&](const std::string& name) { return header.channels().findChannel(name)->type == Imf::HALF; };
  if (std::ranges::any_of(colours.names, isHalf)) image.significandBits = 11;
  if (!colours.alpha.empty()) image.alpha.resize(pixelCount);
  if (hasFullChannel(header, kVarianceChannel)) image.luminanceVariance.resize(pixelCount);
  if (hasFullChannel(header, kSamplesChannel)) image.sampleCounts.resize(pixelCount);
  if (hasFullChannel(header, kBadSamplesChannel)) image.badSampleCounts.resize(pixelCount);
  image.metadata = metadataOf(header);
  if (parts == ImageParts::withLayers) addLayerChannels(header, colours, pixelCount, image);
  image.isCubeMap = Imf::hasEnvmap(header) && Imf::envmap(header) == Imf::ENVMAP_CUBE;

  ExrPixels pixels(image, window);
  addColours(colours, pixels);
  if (!image.alpha.empty()) pixels.addAlpha(colours.alpha.c_str());
  if (!image.luminanceVariance.empty()) pixels.addVariance();
  if (!image.sampleCounts.empty()) pixels.addSamples();
  if (!image.badSampleCounts.empty()) pixels.addBadSamples();
  for (const Channel& channel : image.channels) {
    const bool isInteger = header.channels().findChannel(channel.name)->type == Imf::UINT;
    pixels.addChannel(channel, isInteger ? Imf::UINT : Imf::FLOAT);
  }
  file.setFrameBuffer(pixels.frameBuffer());
  file.readPixels(window.min.y, window.max.y);
  finishColours(header, colours, image);
  return image;
}

}  // namespace

Image decodeExr(ByteView file, ImageParts parts) try { return decode(file, parts); } catch (const Iex::BaseExc& error) {
  throw FileError(fmt::format("not a valid EXR file: {}", error.what()));
}

}  // namespace candela::image
