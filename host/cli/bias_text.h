// Describes the bias of --clamp-indirect in the metadata of an image.
#pragma once
#include <fmt/format.h>

#include <string>

namespace candela::cli {

/// Returns a sentence about a limit, a number or its notation.
template <class Limit>
std::string biasText(const Limit& limit) {
  return fmt::format(
      "--clamp-indirect {}: too dark where a contribution of light that was scattered twice or more exceeds "
      "this limit",
      limit);
}

}  // namespace candela::cli
