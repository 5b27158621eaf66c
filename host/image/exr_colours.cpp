// Finds colours by the names of channels.
#include "host/image/exr_colours.h"

#include <OpenEXR/ImfChannelList.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/base/errors.h"

namespace candela::image {
namespace {

constexpr std::size_t kMaxNamed = 12;  ///< names in a message

std::vector<std::string> namesOf(const Imf::Header& header) {
  std::vector<std::string> names;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    names.emplace_back(channel.name());
  }
  return names;
}

std::string listed(std::vector<std::string> names) {
  const bool isLong = names.size() > kMaxNamed;
  names.resize(std::min(names.size(), kMaxNamed));
  return fmt::format("{}{}", fmt::join(names, ", "), isLong ? " and others" : "");
}

std::vector<std::string> coloursOf(const std::string& prefix) { return {prefix + "R", prefix + "G", prefix + "B"}; }

bool hasAll(const Imf::Header& header, const std::vector<std::string>& names) {
  return std::ranges::all_of(names, [&](const std::string& name) { return hasFullChannel(header, name); });
}

/// Returns what stands before the colours of each layer, with its full stop.
std::vector<std::string> layersWithColours(const Imf::Header& header) {
  std::vector<std::string> prefixes;
  for (const std::string& name : namesOf(header)) {
    if (!name.ends_with(".R")) continue;
    const std::string prefix = name.substr(0, name.size() - 1);
    if (hasAll(header, coloursOf(prefix))) prefixes.push_back(prefix);
  }
  return prefixes;
}

ExrColours withAlpha(const Imf::Header& header, std::vector<std::string> names, const std::string& alpha,
                     std::string warning) {
  return {std::move(names), hasFullChannel(header, alpha) ? alpha : "", std::move(warning)};
}

}  // namespace

bool hasFullChannel(const Imf::Header& header, const std::string& name) {
  const Imf::Channel* channel = header.channels().findChannel(name);
  return channel && channel->xSampling == 1 && channel->ySampling == 1;
}

ExrColours chooseColours(const Imf::Header& header) {
  if (hasAll(header, coloursOf(""))) return withAlpha(header, coloursOf(""), "A", "");
  if (header.channels().findChannel("RY") || header.channels().findChannel("BY")) {
    throw FileError(
        "the EXR file has luminance and chroma (Y, RY and BY) instead of R, G and B, which is not read; convert it to "
        "R, G "
        "and B");
  }
  if (hasFullChannel(header, "Y")) return withAlpha(header, {"Y"}, "A", "");

  const std::vector<std::string> layers = layersWithColours(header);
  if (layers.size() == 1) {
    const std::string& layer = layers.front();
    return withAlpha(header, coloursOf(layer), layer + "A",
                     fmt::format("the file has no channels R, G and B; those of its layer \"{}\" are read",
                                 layer.substr(0, layer.size() - 1)));
  }
  if (layers.size() > 1) {
    throw FileError(
        fmt::format("the EXR file has no channels R, G and B, but several layers: {}; extract one of them, for "
                    "example by oiiotool FILE --ch {} --chnames R,G,B -o NEW",
                    listed(namesOf(header)), fmt::join(coloursOf(layers.front()), ",")));
  }
  std::vector<std::string> names = namesOf(header);
  std::erase(names, "A");
  if (names.size() == 1 && hasFullChannel(header, names.front())) {
    return withAlpha(
        header, names, "A",
        fmt::format("the file has no channels R, G and B; its channel \"{}\" is read as grey", names.front()));
  }
  throw FileError(
      fmt::format("the EXR file has neither the channels R, G and B nor Y alone, each at full resolution; it has {}",
                  listed(namesOf(header))));
}

}  // namespace candela::image
