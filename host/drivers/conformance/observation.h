// Observes the results of variants of a kernel, so that two of them can be compared.
#pragma once
#include <string>
#include <string_view>

#include "host/image/film.h"

namespace candela::conformance {

struct Observation {
  std::string key;     ///< variants agree if their keys are equal
  std::string text{};  ///< of a case that does not pass: the difference
  image::Film film{};  ///< of a picture
};

/// The key of a case that the device cannot run; Observation::text names the missing feature.
inline constexpr std::string_view kSkipped = "Skip";

/// Returns the difference in a sentence; empty: the keys are equal. For films, it names the first pixel that differs.
std::string differenceBetween(const Observation& plain, const Observation& other, const std::string& otherName);

}  // namespace candela::conformance
