// Reads values of attributes.
#include "host/formats/mitsuba/attributes.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/quote.h"
#include "host/formats/loading/number.h"
#include "host/formats/mitsuba/names.h"

namespace candela::mitsuba {

using scene::quote;

const std::string* findAttribute(const Element& element, std::string_view name) {
  const auto found = std::ranges::find(element.attributes, name, &Attribute::name);
  return found == element.attributes.end() ? nullptr : &found->value;
}

const std::string& requireAttribute(const Element& element, std::string_view name) {
  const std::string* const value = findAttribute(element, name);
  if (!value) throw PlacedError{element.place, fmt::format("<{}> has no attribute {}", element.name, quote(name))};
  return *value;
}

void checkAttributes(const Element& element, std::initializer_list<std::string_view> names) {
  for (const Attribute& attribute : element.attributes) {
    if (std::ranges::find(names, attribute.name) != names.end()) continue;
    throw PlacedError{element.place,
                      fmt::format("<{}> does not have an attribute {}{}", element.name, quote(attribute.name),
                                  suggestionFor(attribute.name, {names.begin(), names.size()}))};
  }
}

std::vector<std::string_view> wordsOf(std::string_view text) {
  constexpr std::string_view kSeparators = " ,\t\r\n";
  std::vector<std::string_view> words;
  std::size_t begin = text.find_first_not_of(kSeparators);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(kSeparators, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(kSeparators, end);
  }
  return words;
}

double numberOf(std::string_view text, const Place& place) {
  const std::vector<std::string_view> words = wordsOf(text);
  const auto number = words.size() == 1 ? scene::parseDouble(words[0])
                                        : scene::ParsedNumber<double>{0, scene::NumberStatus::notANumber};
  if (number.status != scene::NumberStatus::ok) {
    throw PlacedError{place, fmt::format("expected a finite number instead of {}", quote(text))};
  }
  return number.value;
}

std::vector<double> numbersOf(std::string_view text, const Place& place) {
  std::vector<double> numbers;
  for (const std::string_view word : wordsOf(text)) numbers.push_back(numberOf(word, place));
  return numbers;
}

glm::dvec3 tripleOf(std::string_view text, const Place& place) {
  const std::vector<double> n = numbersOf(text, place);
  if (n.size() == 1) return glm::dvec3(n[0]);
  if (n.size() != 3) throw PlacedError{place, fmt::format("expected one or three numbers instead of {}", n.size())};
  return {n[0], n[1], n[2]};
}

glm::dvec3 vectorOf(const Element& element, double absent) {
  glm::dvec3 v(absent);
  const std::string* const value = findAttribute(element, "value");
  if (value) v = tripleOf(*value, element.place);
  constexpr std::string_view kNames[]{"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const std::string* const component = findAttribute(element, kNames[axis]);
    if (!component) continue;
    if (value)
      throw PlacedError{element.place,
                        fmt::format("<{}> has both \"value\" and {}", element.name, quote(kNames[axis]))};
    v[axis] = numberOf(*component, element.place);
  }
  return v;
}

}  // namespace candela::mitsuba
