// Reads and prints numbers and sizes.
#include "host/app/cli/notation.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "host/base/lower_case.h"

namespace candela::cli {
namespace {

std::optional<std::uint32_t> parseWhole(std::string_view word, std::uint32_t lowest, std::uint32_t highest) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  if (value < lowest || value > highest) return std::nullopt;
  return value;
}

constexpr std::string_view kAllLayers = "all";

// Returns the layer of a name, or all layers; none if there is no such name.
image::LayerSet layersNamed(std::string_view name) {
  const std::span<const std::string_view> names = image::layerNames();
  image::LayerSet layers;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == kAllLayers || name == names[i]) layers.add(static_cast<image::Layer>(i));
  }
  for (const auto& [alias, layer] : kLayerAliases) {
    if (name == alias) layers.add(layer);
  }
  return layers;
}

}  // namespace

Notation<std::uint32_t> wholeNumber(std::uint32_t lowest, std::uint32_t highest) {
  return {"N", fmt::format("a whole number from {} to {}", lowest, highest),
          [=](const std::string& word) { return parseWhole(word, lowest, highest); },
          [](const std::uint32_t& value) { return fmt::to_string(value); }};
}

Notation<double> fraction(std::string metavar, double lowest, double highest) {
  const auto parse = [=](const std::string& word) -> std::optional<double> {
    const bool percent = word.ends_with('%');
    const std::string_view digits = std::string_view(word).substr(0, word.size() - (percent ? 1 : 0));
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
    if (percent) value /= 100;
    return value >= lowest && value <= highest ? std::optional(value) : std::nullopt;
  };
  return {std::move(metavar), fmt::format("a fraction from {} to {}, or a percentage (0.5%)", lowest, highest), parse,
          [](const double& value) { return fmt::to_string(value); }};
}

Notation<render::Extent> extent(std::string metavar, std::uint32_t highest) {
  const auto parse = [=](const std::string& word) -> std::optional<render::Extent> {
    const std::size_t cross = word.find_first_of("xX");
    if (cross == std::string::npos) return std::nullopt;
    const auto width = parseWhole(std::string_view(word).substr(0, cross), 1, highest);
    const auto height = parseWhole(std::string_view(word).substr(cross + 1), 1, highest);
    if (!width || !height) return std::nullopt;
    return render::Extent{*width, *height};
  };
  return {metavar, fmt::format("{} with both from 1 to {}", metavar, highest), parse, render::extentText};
}

Notation<PixelPosition> pixelPosition(std::uint32_t highest) {
  const auto parse = [=](const std::string& word) -> std::optional<PixelPosition> {
    const std::size_t comma = word.find(',');
    if (comma == std::string::npos) return std::nullopt;
    const auto x = parseWhole(std::string_view(word).substr(0, comma), 0, highest);
    const auto y = parseWhole(std::string_view(word).substr(comma + 1), 0, highest);
    if (!x || !y) return std::nullopt;
    return PixelPosition{*x, *y};
  };
  const auto print = [](const PixelPosition& position) { return fmt::format("{},{}", position.x, position.y); };
  return {"X,Y", fmt::format("X,Y with both from 0 to {}", highest), parse, print};
}

Notation<double> duration(double lowest) {
  const auto parse = [=](const std::string& word) -> std::optional<double> {
    constexpr std::pair<std::string_view, double> kUnits[]{{"min", 60}, {"s", 1}, {"h", 3600}, {"", 1}};
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{}) return std::nullopt;
    const std::string_view unit(end, static_cast<std::size_t>(word.data() + word.size() - end));
    for (const auto& [name, seconds] : kUnits) {
      if (unit == name && value * seconds >= lowest && value * seconds <= 1e9) return value * seconds;
    }
    return std::nullopt;
  };
  return {"TIME", "a time such as 90s, 1.5min or 2h", parse,
          [](const double& value) { return fmt::format("{}s", value); }};
}

Notation<std::uint64_t> byteCount() {
  constexpr double kMiB = 1 << 20, kMaxMiB = 1 << 30;
  const auto parse = [=](const std::string& word) -> std::optional<std::uint64_t> {
    constexpr std::pair<std::string_view, double> kUnits[]{{"MiB", 1},  {"M", 1},         {"GiB", 1024},
                                                           {"G", 1024}, {"TiB", 1 << 20}, {"T", 1 << 20}};
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{}) return std::nullopt;
    const std::string_view unit(end, static_cast<std::size_t>(word.data() + word.size() - end));
    for (const auto& [name, factor] : kUnits) {
      const double size = value * factor;
      if (unit == name && size >= 1 && size <= kMaxMiB) return static_cast<std::uint64_t>(size * kMiB);
    }
    return std::nullopt;
  };
  return {"SIZE", "a size such as 512MiB, 4GiB or 1.5TiB, at least 1MiB", parse,
          [=](const std::uint64_t& value) { return fmt::format("{}MiB", static_cast<double>(value) / kMiB); }};
}

std::optional<std::pair<std::uint32_t, std::uint32_t>> parseRange(const std::string& word, std::uint32_t highest) {
  const std::size_t colon = word.find(':');
  if (colon == std::string::npos) return std::nullopt;
  const auto first = parseWhole(std::string_view(word).substr(0, colon), 0, highest);
  const auto end = parseWhole(std::string_view(word).substr(colon + 1), 0, highest);
  if (!first || !end || *first >= *end) return std::nullopt;
  return std::pair(*first, *end);
}

Notation<render::Window> window(std::uint32_t highest) {
  const auto parse = [=](const std::string& word) -> std::optional<render::Window> {
    std::uint32_t numbers[4]{};
    std::string_view rest = word;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t end = i < 3 ? rest.find(',') : rest.size();
      if (end == std::string_view::npos) return std::nullopt;
      const auto number = parseWhole(rest.substr(0, end), i < 2 ? 0 : 1, highest);
      if (!number) return std::nullopt;
      numbers[i] = *number;
      rest.remove_prefix(std::min(rest.size(), end + 1));
    }
    return render::Window{numbers[0], numbers[1], numbers[2], numbers[3]};
  };
  return {"X,Y,W,H", fmt::format("X,Y,W,H with whole numbers up to {}, W and H at least 1", highest), parse,
          render::windowText};
}

Notation<render::PixelFilter> pixelFilter(float lowest, float highest) {
  const Notation<render::FilterKind> kind = named<render::FilterKind>();
  const Notation<float> deviation = realNumber<float>("S", lowest, highest);
  const std::string prefix = fmt::format("{}:", render::nameOf(render::FilterKind::gaussian));
  const auto parse = [=](const std::string& word) -> std::optional<render::PixelFilter> {
    if (const auto plain = kind.parse(word)) return render::PixelFilter{.kind = *plain};
    if (!word.starts_with(prefix)) return std::nullopt;
    const auto number = deviation.parse(word.substr(prefix.size()));
    if (!number) return std::nullopt;
    return render::PixelFilter{render::FilterKind::gaussian, *number};
  };
  return {fmt::format("{}|{}{}", kind.metavar, prefix, deviation.metavar),
          fmt::format("{}, or {}{} with S {}", kind.expected, prefix, deviation.metavar, deviation.expected), parse,
          render::filterText};
}

Notation<image::LayerSet> layerList() {
  std::vector<std::string> words{image::layerNames().begin(), image::layerNames().end()};
  for (const auto& [alias, layer] : kLayerAliases) words.emplace_back(alias);
  words.emplace_back(kAllLayers);
  const auto parse = [](const std::string& word) -> std::optional<image::LayerSet> {
    image::LayerSet layers;
    if (word == "none") return layers;
    for (std::size_t first = 0; first <= word.size();) {
      const std::size_t end = std::min(word.find(',', first), word.size());
      const image::LayerSet named = layersNamed(std::string_view(word).substr(first, end - first));
      if (named.isEmpty()) return std::nullopt;
      layers.bits |= named.bits;
      first = end + 1;
    }
    return layers;
  };
  return {"LAYERS", fmt::format("layers separated by commas, among {}", fmt::join(words, ", ")), parse,
          image::layerText, words};
}

Notation<std::vector<std::string>> nameList(std::string metavar, std::string expected) {
  const auto parse = [](const std::string& word) -> std::optional<std::vector<std::string>> {
    std::vector<std::string> names;
    for (std::size_t first = 0; first <= word.size();) {
      const std::size_t end = std::min(word.find(',', first), word.size());
      if (end == first) return std::nullopt;
      names.push_back(word.substr(first, end - first));
      first = end + 1;
    }
    return names;
  };
  return {std::move(metavar), std::move(expected), parse,
          [](const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ",")); }};
}

Notation<ServerAddress> serverAddress() {
  const auto parse = [](const std::string& word) -> std::optional<ServerAddress> {
    const std::size_t colon = std::min(word.rfind(':'), word.size());
    std::string host = word.substr(0, colon);
    const auto port = parseWhole(std::string_view(word).substr(std::min(colon + 1, word.size())), 1, 65535);
    const bool isBracketed = host.size() > 2 && host.front() == '[' && host.back() == ']';
    if (isBracketed) host = host.substr(1, host.size() - 2);
    if (!port || host.empty() || (!isBracketed && host.find(':') != std::string::npos)) return std::nullopt;
    return ServerAddress{host, static_cast<std::uint16_t>(*port)};
  };
  return {"HOST:PORT", "HOST:PORT with a port from 1 to 65535", parse, addressText};
}

Notation<std::string> text(std::string metavar, std::string expected, std::string empty) {
  const auto parse = [](const std::string& word) { return word.empty() ? std::nullopt : std::optional(word); };
  const auto print = [empty](const std::string& value) { return value.empty() ? empty : value; };
  return {std::move(metavar), std::move(expected), parse, print};
}

Notation<std::string> deviceSelector() {
  Notation<std::string> notation = text("cpu|N|SUBSTRING", "a device", "the best GPU");
  notation.parse = [](const std::string& word) -> std::optional<std::string> {
    if (word.empty()) return std::nullopt;
    const bool isReference = std::ranges::equal(word, std::string_view(render::kReferenceDevice), {}, lowerLetter);
    return isReference ? render::kReferenceDevice : word;
  };
  return notation;
}

std::string joinAlternatives(const std::vector<std::string>& words) {
  std::string joined;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) joined += i + 1 == words.size() ? " or " : ", ";
    joined += words[i];
  }
  return joined;
}

}  // namespace candela::cli
