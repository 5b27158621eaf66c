// Compares the channels of two images by their names.
#include "host/image/channel_comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "host/base/errors.h"

namespace candela::image {
namespace {

constexpr double kLayerEpsilon = 0.01;
constexpr std::array<std::string_view, 3> kColours{"R", "G", "B"};
constexpr std::string_view kAlpha = "A";

/// The value of a channel at each pixel.
struct ChannelValues {
  std::function<float(std::size_t)> value;
  bool isId = false;
};

std::optional<ChannelValues> findValues(const Image& image, std::string_view name) {
  for (std::size_t c = 0; c < kColours.size(); ++c) {
    if (name != kColours[c]) continue;
    return ChannelValues{[&image, c](std::size_t i) { return image.rgb[i][static_cast<glm::length_t>(c)]; }};
  }
  if (name == kAlpha)
    return ChannelValues{[&image](std::size_t i) { return image.alpha.empty() ? 1.0f : image.alpha[i]; }};
  const auto channel = std::ranges::find(image.channels, name, &Channel::name);
  if (channel == image.channels.end()) return std::nullopt;
  return ChannelValues{[&values = channel->values](std::size_t i) { return values[i]; }, channel->isId};
}

ChannelDifference compare(const std::string& name, const ChannelValues& a, const ChannelValues& b, const Image& image) {
  ChannelDifference result{.name = name, .isId = a.isId || b.isId};
  double sum = 0;
  std::uint64_t finiteCount = 0;
  const auto noteLargest = [&](double difference, std::size_t i) {
    result.maximumDifference = difference;
    result.maximumX = image.origin.x + static_cast<std::int64_t>(i % image.width);
    result.maximumY = image.origin.y + static_cast<std::int64_t>(i / image.width);
  };
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const float value = a.value(i), expected = b.value(i);
    const bool isEqual = std::bit_cast<std::uint32_t>(value) == std::bit_cast<std::uint32_t>(expected);
    if (result.isId) {
      if (!isEqual && result.differingCount++ == 0) noteLargest(0, i);
      continue;
    }
    const bool isFinite = std::isfinite(value) && std::isfinite(expected);
    if (isFinite) ++finiteCount;
    if (isEqual || value == expected) continue;
    ++result.differingCount;
    if (!isFinite) {
      ++result.notFiniteCount;
      continue;
    }
    const double x = value, y = expected, difference = std::abs(x - y);
    sum += difference * difference / (std::max(x * x, y * y) + kLayerEpsilon);
    if (difference > result.maximumDifference) noteLargest(difference, i);
  }
  if (finiteCount > 0) result.relativeMeanSquaredError = sum / static_cast<double>(finiteCount);
  return result;
}

std::vector<std::string> layerNamesOf(const Image& image) {
  std::vector<std::string> names;
  for (const Channel& channel : image.channels) names.push_back(channel.name);
  return names;
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

std::vector<std::string> without(const std::vector<std::string>& names, const std::vector<std::string>& others) {
  std::vector<std::string> rest;
  std::ranges::copy_if(names, std::back_inserter(rest), [&](const auto& name) { return !contains(others, name); });
  return rest;
}

/// Returns the channels of `image` that a word of --channels means, or nothing.
std::vector<std::string> channelsNamed(const std::string& word, const Image& image) {
  if (findValues(image, word)) return {word};
  std::vector<std::string> found;
  for (const std::string& name : layerNamesOf(image)) {
    if (name.starts_with(word + ".")) found.push_back(name);
  }
  const auto layer = std::ranges::find(layerNames(), word);
  if (!found.empty() || layer == layerNames().end()) return found;
  const auto names = layerChannelNames(static_cast<Layer>(layer - layerNames().begin()));
  std::ranges::copy_if(names, std::back_inserter(found),
                       [&](const auto& name) { return findValues(image, name).has_value(); });
  return found;
}

std::vector<std::string> namesOf(const Image& image) {
  std::vector<std::string> names(kColours.begin(), kColours.end());
  if (!image.alpha.empty()) names.emplace_back(kAlpha);
  std::ranges::copy(layerNamesOf(image), std::back_inserter(names));
  return names;
}

std::vector<std::string> resolve(const std::vector<std::string>& words, const Image& a, const Image& reference) {
  std::vector<std::string> names;
  for (const std::string& word : words) {
    for (const auto& [side, image] : {std::pair("A", &a), std::pair("B", &reference)}) {
      if (!channelsNamed(word, *image).empty()) continue;
      throw UsageError(fmt::format("{} has no channel \"{}\" that can be compared; it has {}", side, word,
                                   fmt::join(namesOf(*image), ", ")));
    }
    for (const std::string& name : channelsNamed(word, a)) {
      if (!findValues(reference, name)) {
        throw UsageError(fmt::format("A has the channel \"{}\", and B has not", name));
      }
      if (!contains(names, name)) names.push_back(name);
    }
  }
  return names;
}

}  // namespace

bool ChannelDifference::isWithin(double tolerance) const {
  return isId ? isEqual() : notFiniteCount == 0 && relativeMeanSquaredError <= tolerance;
}

ChannelComparison compareChannels(const Image& a, const Image& reference, const std::vector<std::string>& selected) {
  ChannelComparison comparison;
  std::vector<std::string> names;
  if (selected.empty()) {
    if (!a.alpha.empty() || !reference.alpha.empty()) names.emplace_back(kAlpha);
    const std::vector<std::string> inA = layerNamesOf(a), inB = layerNamesOf(reference);
    std::ranges::copy_if(inA, std::back_inserter(names), [&](const auto& name) { return contains(inB, name); });
    comparison.onlyInA = without(inA, inB);
    comparison.onlyInB = without(inB, inA);
  } else {
    names = resolve(selected, a, reference);
    comparison.comparesColours = std::ranges::all_of(kColours, [&](auto name) { return contains(names, name); });
    if (comparison.comparesColours) {
      std::erase_if(names, [](const auto& name) { return std::ranges::find(kColours, name) != kColours.end(); });
    }
  }
  for (const std::string& name : names) {
    comparison.channels.push_back(compare(name, *findValues(a, name), *findValues(reference, name), a));
  }
  return comparison;
}

std::string toText(const ChannelComparison& comparison) {
  std::string text;
  for (const ChannelDifference& c : comparison.channels) {
    text += fmt::format("channel {:<13} ", c.name);
    if (c.isEqual()) {
      text += "equal\n";
    } else if (c.isId) {
      text += fmt::format("{} pixels have other ids, the first at {} {}\n", c.differingCount, c.maximumX, c.maximumY);
    } else {
      text += fmt::format("relative error {:.6g}, maximum difference {:.6g} at {} {}", c.relativeMeanSquaredError,
                          c.maximumDifference, c.maximumX, c.maximumY);
      if (c.notFiniteCount > 0) text += fmt::format(", {} pixels are not finite", c.notFiniteCount);
      text += "\n";
    }
  }
  if (!comparison.onlyInA.empty())
    text += fmt::format("only in A             {}\n", fmt::join(comparison.onlyInA, ", "));
  if (!comparison.onlyInB.empty())
    text += fmt::format("only in B             {}\n", fmt::join(comparison.onlyInB, ", "));
  return text;
}

void addToJson(const ChannelComparison& comparison, nlohmann::ordered_json& json) {
  json["comparesColours"] = comparison.comparesColours;
  json["channels"] = nlohmann::ordered_json::array();
  for (const ChannelDifference& c : comparison.channels) {
    nlohmann::ordered_json channel{{"name", c.name}, {"isId", c.isId}, {"differingCount", c.differingCount}};
    if (!c.isId) {
      channel["notFiniteCount"] = c.notFiniteCount;
      channel["relativeMeanSquaredError"] = c.relativeMeanSquaredError;
    }
    channel["worst"] = {{"difference", c.maximumDifference}, {"x", c.maximumX}, {"y", c.maximumY}};
    json["channels"].push_back(std::move(channel));
  }
  json["onlyInA"] = comparison.onlyInA;
  json["onlyInB"] = comparison.onlyInB;
}

}  // namespace candela::image
