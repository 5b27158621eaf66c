// Lists the layers of EXR files.
#include "host/image/exr_layers.h"

#include <OpenEXR/ImfChannelList.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "host/base/lower_case.h"

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

}  // namespace

bool isPictureOrStatistic(std::string_view name) {
  return std::ranges::find(kNames, name) != kNames.end() ||
         std::ranges::any_of(kPrefixes, [&](std::string_view prefix) { return name.starts_with(prefix); });
}

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

}  // namespace candela::image
