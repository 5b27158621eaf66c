// Suggestions for misspelt names of elements, attributes, properties, objects and materials.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace candela::mitsuba {

/// Returns the end of a message: "; did you mean "diffuse"?" with the name that is nearest to `word`, or nothing if
/// none is near. Words and names of more than 256 bytes have none.
std::string suggestionFor(std::string_view word, std::span<const std::string_view> names);

}  // namespace candela::mitsuba
