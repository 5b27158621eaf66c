// One quantity of a path on both tracers, and whether the two differ by more than rounding.
#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/judge/verify/agreement.h"

namespace candela::explain {

/// If there are no replicas of the path, numbers, like pixels, count as equal up to this fraction of the larger one:
/// single precision gives 1e-7, which a few reflections at flat surfaces increase to 1e-5.
inline constexpr double kTolerance = verify::kRelativeTolerance;

/// Relative error of one operation in single precision.
inline constexpr double kOneRounding = 0x1p-24;

/// The value on one side: words (for a decision) or one to three numbers. Both are empty if the path did not reach it.
struct Value {
  std::string words;
  std::vector<double> numbers;
  bool isAbsent() const { return words.empty() && numbers.empty(); }
};

struct Quantity {
  enum class Kind { randomNumber, decision, number };
  std::string name;  ///< name for people, e.g. "light pdf"
  Kind kind = Kind::number;
  Value device;
  Value reference;
  double apart = 0;  ///< relative difference of numbers; infinite if one is not finite
  bool differs = false;
  /// Maximum, over the replicas, of the relative difference from the exact path; 0 for decisions.
  double spread = 0;
  bool undecidable = false;  ///< a decision that a replica takes differently

  /// The spread, in units of one rounding.
  double amplification() const { return spread / kOneRounding; }
  /// The difference that the spread explains.
  double allowed() const { return std::max(verify::kSpread * spread, verify::kSpreadFloor); }
};

/// A decision, equal or not. The words describe the choice of each side.
Quantity decision(std::string name, std::string device, std::string reference);
/// A random number, which must be bit-identical.
Quantity randomNumber(std::string name, std::uint32_t device, std::uint32_t reference);

// Numbers. A number that is missing on one side only follows a decision that differs, and is not compared.
Quantity scalar(std::string name, std::optional<double> device, std::optional<double> reference);
/// Compared channel by channel; differences up to kAbsoluteTolerance count as equal.
Quantity colour(std::string name, std::optional<glm::dvec3> device, std::optional<glm::dvec3> reference);
/// Compared by the length of the difference, as a fraction of `scale` (1 for unit vectors).
Quantity vector(std::string name, std::optional<glm::dvec3> device, std::optional<glm::dvec3> reference,
                double scale = 1);

}  // namespace candela::explain
