// States in the metadata of an image how it is biased on purpose.
#pragma once
#include <fmt/format.h>

#include <map>
#include <string>

#include "host/judge/verify/film_test.h"

namespace candela::cli {

/// Returns a sentence about the limit of --clamp-indirect, a number or its notation.
template <class Limit>
std::string biasText(const Limit& limit) {
  return fmt::format(
      "--clamp-indirect {}: too dark where a contribution of light that was scattered twice or more exceeds "
      "this limit",
      limit);
}

/// Marks an image as biased on purpose, so that verdicts refuse it. `sentence` follows those that it has already.
inline void addBias(std::map<std::string, std::string>& metadata, const std::string& sentence) {
  std::string& bias = metadata[verify::kBiasMetadata];
  bias += (bias.empty() ? "" : "; ") + sentence;
}

}  // namespace candela::cli
