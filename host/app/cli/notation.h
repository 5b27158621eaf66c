// The notation of values on the command line: one Notation per kind of value, for reading, printing and help.
#pragma once
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/app/cli/arguments.h"
#include "host/base/tcp_client.h"
#include "host/trace/render/setting_names.h"

namespace candela::cli {

template <class T>
struct Notation {
  std::string metavar;   ///< placeholder for the value in help
  std::string expected;  ///< completes "expected ..." in messages
  std::function<std::optional<T>(const std::string&)> parse;
  std::function<std::string(const T&)> print;
  std::vector<std::string> words{};  ///< all words that a value, or each part of a list, may be; empty: any text
};

/// A decimal number from `lowest` to `highest`.
Notation<std::uint32_t> wholeNumber(std::uint32_t lowest, std::uint32_t highest);
/// A number from `lowest` to `highest`; infinities and NaN are refused.
template <class Real>
Notation<Real> realNumber(std::string metavar, Real lowest, Real highest);
/// A fraction from `lowest` to `highest`, as a number ("0.005") or as a percentage ("0.5%").
Notation<double> fraction(std::string metavar, double lowest, double highest);
/// "WxH", both from 1 to `highest`.
Notation<render::Extent> extent(std::string metavar, std::uint32_t highest);
/// "X,Y", both from 0 to `highest`.
Notation<PixelPosition> pixelPosition(std::uint32_t highest);
/// A duration in seconds, at least `lowest`: "90", "90s", "1.5min" or "2h".
Notation<double> duration(double lowest);
/// A number of bytes, at least 1 MiB: "4GiB", "1.5G", "512MiB".
Notation<std::uint64_t> byteCount();
/// "A:B", 0 <= A < B <= `highest`: the members `first` and `end` of a range.
template <class Range>
Notation<Range> range(std::uint32_t highest);
/// "X,Y,W,H", X and Y below `highest`, W and H from 1 to `highest`.
Notation<render::Window> window(std::uint32_t highest);
/// Short names of the mattes.
inline constexpr std::array<std::pair<std::string_view, image::Layer>, 2> kLayerAliases{
    {{"id", image::Layer::cryptoObject}, {"material", image::Layer::cryptoMaterial}}};
/// Names of layers, separated by commas, in any order; `none` for no layers.
Notation<image::LayerSet> layerList();
/// Any names, separated by commas, none of them empty; an empty list, which can only be the default, prints as nothing.
Notation<std::vector<std::string>> nameList(std::string metavar, std::string expected);
/// "HOST:PORT"; a host with colons is in brackets.
Notation<ServerAddress> serverAddress();
/// Any text; an empty value, which can only be the default, prints as `empty`.
Notation<std::string> text(std::string metavar, std::string expected, std::string empty = "");
/// A device: "cpu" in any case for the reference tracer, else a selector for selectDevice().
Notation<std::string> deviceSelector();
/// One of a list of names.
template <class T>
Notation<T> choice(std::vector<std::pair<std::string, T>> names);
/// One of the values of an enumeration of settings: see render::kNamesOf.
template <class T>
Notation<T> named();
/// The name of a filter, for a Gaussian also with its standard deviation in pixels from `lowest` to `highest`:
/// "gaussian:0.7".
Notation<render::PixelFilter> pixelFilter(float lowest, float highest);
/// Reads and prints like `inner`, and `absent` for no value. A word that `inner` accepts as well is a value.
template <class T>
Notation<std::optional<T>> orAbsent(Notation<T> inner, std::string absent);

// ---------------------------------------------------------------------------------------------------------------------

/// The numbers of "A:B"; nothing unless 0 <= A < B <= `highest`.
std::optional<std::pair<std::uint32_t, std::uint32_t>> parseRange(const std::string& word, std::uint32_t highest);

template <class Range>
Notation<Range> range(std::uint32_t highest) {
  const auto parse = [=](const std::string& word) -> std::optional<Range> {
    const auto numbers = parseRange(word, highest);
    return numbers ? std::optional(Range{numbers->first, numbers->second}) : std::nullopt;
  };
  const auto print = [](const Range& value) { return fmt::format("{}:{}", value.first, value.end); };
  return {"A:B", fmt::format("A:B with A below B, and both from 0 to {}", highest), parse, print};
}

/// Returns "a, b or c".
std::string joinAlternatives(const std::vector<std::string>& words);

template <class Real>
Notation<Real> realNumber(std::string metavar, Real lowest, Real highest) {
  const auto parse = [=](const std::string& word) -> std::optional<Real> {
    Real value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    if (!(value >= lowest && value <= highest)) return std::nullopt;
    return value;
  };
  const std::string expected = "a number from " + fmt::to_string(lowest) + " to " + fmt::to_string(highest);
  return {std::move(metavar), expected, parse, [](const Real& value) { return fmt::to_string(value); }};
}

template <class T>
Notation<T> choice(std::vector<std::pair<std::string, T>> names) {
  std::string metavar;
  std::vector<std::string> words;
  for (const auto& [name, value] : names) {
    if (!metavar.empty()) metavar += '|';
    metavar += name;
    words.push_back(name);
  }
  const auto parse = [names](const std::string& word) -> std::optional<T> {
    for (const auto& [name, value] : names) {
      if (name == word) return value;
    }
    return std::nullopt;
  };
  const auto print = [names](const T& wanted) -> std::string {
    for (const auto& [name, value] : names) {
      if (value == wanted) return name;
    }
    return {};
  };
  return {metavar, joinAlternatives(words), parse, print, words};
}

template <class T>
Notation<T> named() {
  std::vector<std::pair<std::string, T>> names;
  for (const auto& [name, value] : render::kNamesOf<T>) names.emplace_back(name, value);
  return choice(std::move(names));
}

template <class T>
Notation<std::optional<T>> orAbsent(Notation<T> inner, std::string absent) {
  const auto parse = [inner, absent](const std::string& word) -> std::optional<std::optional<T>> {
    if (const std::optional<T> value = inner.parse(word)) return std::optional<T>(value);
    if (word == absent) return std::optional<T>(std::nullopt);
    return std::nullopt;
  };
  const auto print = [inner, absent](const std::optional<T>& value) { return value ? inner.print(*value) : absent; };
  // Defaults such as "the scene's" are words of the help alone, and others are values.
  const bool isWord = !absent.empty() && absent.find(' ') == std::string::npos && !inner.parse(absent);
  const std::string expected = isWord ? inner.expected + ", or " + absent : inner.expected;
  return {inner.metavar, expected, parse, print, inner.words};
}

}  // namespace candela::cli
