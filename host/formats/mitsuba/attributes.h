// The attributes of elements, and the numbers in them.
#pragma once
#include <glm/glm.hpp>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/mitsuba/xml_tree.h"

namespace candela::mitsuba {

/// Returns the value of an attribute; null if there is none.
const std::string* findAttribute(const Element& element, std::string_view name);
/// Throws PlacedError if there is none.
const std::string& requireAttribute(const Element& element, std::string_view name);
/// Throws PlacedError for an attribute with another name.
void checkAttributes(const Element& element, std::initializer_list<std::string_view> names);

/// Splits a text at blanks and commas.
std::vector<std::string_view> wordsOf(std::string_view text);
/// Throws PlacedError unless the text, without blanks around it, is a finite number.
double numberOf(std::string_view text, const Place& place);
/// Returns the numbers of a list.
std::vector<double> numbersOf(std::string_view text, const Place& place);
/// Returns three numbers, or one three times.
glm::dvec3 tripleOf(std::string_view text, const Place& place);
/// Returns the vector of the attribute "value", or of "x", "y" and "z", of which missing ones are `absent`.
glm::dvec3 vectorOf(const Element& element, double absent);

}  // namespace candela::mitsuba
