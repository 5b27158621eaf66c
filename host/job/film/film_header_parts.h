// The functions that reading, checking and writing the headers of films as JSON share.
#pragma once
#include <algorithm>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/json_value.h"
#include "host/job/film/film_header.h"

namespace candela::film {

/// Returns a whole number of the range. Throws JsonError.
inline std::uint32_t number(const JsonValue& value, std::uint32_t min, std::uint32_t max) {
  return static_cast<std::uint32_t>(value.whole(min, max));
}

inline std::vector<std::string> textsIn(const JsonValue& list) {
  std::vector<std::string> texts;
  for (const JsonValue& entry : list.items()) texts.push_back(entry.text());
  return texts;
}

/// Returns the names of the layers, in the order of image::Layer.
std::vector<std::string_view> layerNamesOf(image::LayerSet layers);
/// Reads the member `layers`, which has the names of layers with sums in this order, and is absent if there are none.
image::LayerSet layersIn(const JsonValue& root);

/// Returns the member `mattes` of a header with mattes.
nlohmann::ordered_json mattesJson(const FilmHeader& header);
/// Reads the member `mattes` of a header whose layers are known.
void readMattes(const JsonValue& mattes, FilmHeader& header);

inline constexpr const char* kExpectsSortedSet = "expected different elements in ascending order";

template <class T>
bool isSortedSet(const std::vector<T>& items) {
  return std::ranges::adjacent_find(items, [](const T& a, const T& b) { return !(a < b); }) == items.end();
}

/// Throws JsonError, at the members of `root`, if the header is invalid although each of its values is valid.
void checkHeader(const FilmHeader& header, const JsonValue& root);

}  // namespace candela::film
