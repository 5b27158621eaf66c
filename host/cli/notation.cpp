// Reads and prints numbers and sizes.
#include "host/cli/notation.h"

namespace candela::cli {
namespace {

std::optional<std::uint32_t> parseWhole(std::string_view word, std::uint32_t lowest, std::uint32_t highest) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  if (value < lowest || value > highest) return std::nullopt;
  return value;
}

}  // namespace

Notation<std::uint32_t> wholeNumber(std::uint32_t lowest, std::uint32_t highest) {
  return {"N", fmt::format("a whole number from {} to {}", lowest, highest),
          [=](const std::string& word) { return parseWhole(word, lowest, highest); },
          [](const std::uint32_t& value) { return fmt::to_string(value); }};
}

Notation<double> share(std::string metavar, double lowest, double highest) {
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
    const std::size_t cross = word.find('x');
    if (cross == std::string::npos) return std::nullopt;
    const auto width = parseWhole(std::string_view(word).substr(0, cross), 1, highest);
    const auto height = parseWhole(std::string_view(word).substr(cross + 1), 1, highest);
    if (!width || !height) return std::nullopt;
    return render::Extent{*width, *height};
  };
  return {metavar, fmt::format("{} with both from 1 to {}", metavar, highest), parse, render::extentText};
}

Notation<PixelPlace> pixelPlace(std::uint32_t highest) {
  const auto parse = [=](const std::string& word) -> std::optional<PixelPlace> {
    const std::size_t comma = word.find(',');
    if (comma == std::string::npos) return std::nullopt;
    const auto x = parseWhole(std::string_view(word).substr(0, comma), 0, highest);
    const auto y = parseWhole(std::string_view(word).substr(comma + 1), 0, highest);
    if (!x || !y) return std::nullopt;
    return PixelPlace{*x, *y};
  };
  const auto print = [](const PixelPlace& place) { return fmt::format("{},{}", place.x, place.y); };
  return {"X,Y", fmt::format("X,Y with both from 0 to {}", highest), parse, print};
}

Notation<std::string> text(std::string metavar, std::string expected, std::string empty) {
  const auto parse = [](const std::string& word) { return word.empty() ? std::nullopt : std::optional(word); };
  const auto print = [empty](const std::string& value) { return value.empty() ? empty : value; };
  return {std::move(metavar), std::move(expected), parse, print};
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
