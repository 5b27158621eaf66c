// One quantity of a path as each tracer has it, and whether the two differ by more than rounding.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/verify/agreement.h"

namespace candela::explain {

/// Numbers are equal up to this share of the larger one, as pixels are: single precision leaves 1e-7, and a few bounces
/// off flat surfaces make 1e-5 of it.
inline constexpr double kTolerance = verify::kRelativeTolerance;

/// What one side has: words (of a decision) or one to three numbers; neither: it did not come so far.
struct Value {
  std::string words;
  std::vector<double> numbers;
  bool isAbsent() const { return words.empty() && numbers.empty(); }
};

struct Quantity {
  enum class Kind { randomNumber, decision, number };
  std::string name;  ///< as people read it, e.g. "light pdf"
  Kind kind = Kind::number;
  Value device;
  Value reference;
  double apart = 0;  ///< of numbers: their difference as a share; infinite where one is not finite
  bool differs = false;
};

/// Equal or not: the words say which way each side took.
Quantity decision(std::string name, std::string device, std::string reference);
/// Words as the samplers make them; equal bits or not.
Quantity randomNumber(std::string name, std::uint32_t device, std::uint32_t reference);

// Numbers. One that is absent on one side alone has a decision before it that differs, and is not compared.
Quantity scalar(std::string name, std::optional<double> device, std::optional<double> reference);
/// Channel by channel; what is not further apart than kAbsoluteTolerance is equal.
Quantity colour(std::string name, std::optional<glm::dvec3> device, std::optional<glm::dvec3> reference);
/// By the length of the difference, as a share of `scale` (of 1: for unit vectors).
Quantity vector(std::string name, std::optional<glm::dvec3> device, std::optional<glm::dvec3> reference,
                double scale = 1);

}  // namespace candela::explain
